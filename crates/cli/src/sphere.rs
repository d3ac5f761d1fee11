//! The pictures of all stationary motions: the cone on the unit sphere, the directrix in space, the angular velocity along
//! both.

use crate::stability_map;
use charts::{Curve, CurvePoint, Mark, Panel, Sphere, Study, Table, Track, significant};
use derivations::scene::{Scene, System};
use derivations::stationary::branches::{Branch, Form};
use derivations::stationary::energies::Kept;
use derivations::stationary::motions::Stationary as All;
use derivations::stationary::stability::reduced::{Fate, Reduced};
use derivations::systems::gyrostat::stationary::Stationary;
use mechanics::uniform::Census;
use nalgebra::{Matrix3, Vector3};

/// Moments below this share of the larger one are rounding.
const ROUNDING: f64 = 1e-9;
/// Points closer together than this, as a share of the picture, are not drawn.
const NEAR: f64 = 0.012;
/// The first point of view.
const VIEW: (f64, f64) = (35.0, 25.0);

/// Gyrostats with a speed of their rotor: scenes that share these share the pictures.
pub fn all<'a>(scenes: impl Iterator<Item = &'a Scene>) -> (Vec<Sphere>, Option<Study>) {
    let scenes: Vec<&Scene> = scenes.collect();
    let mut found: Vec<(Case, Vec<&str>)> = Vec::new();
    for &scene in &scenes {
        for case in cases(scene) {
            match found.iter_mut().find(|(known, _)| known.conditions == case.conditions) {
                Some((_, titles)) => titles.push(&scene.title),
                None => found.push((case, vec![&scene.title])),
            }
        }
    }
    let spheres = found.iter().flat_map(|(case, titles)| [cone(case, titles), directrix(case)]).collect();
    let study = (!found.is_empty()).then(|| Study { pictures: stability_map::all(&scenes), ..study(&found) });
    (spheres, study)
}

/// Where a gyrostat may turn for ever, and what it is.
struct Case {
    conditions: Stationary<f64>,
    /// What the rotor keeps: its relative speed, rad/s.
    speed: f64,
    /// D = det A / det A*
    singularity: f64,
    pieces: Vec<Piece>,
    census: Option<Census>,
}

/// A connected run of directions with one fate.
struct Piece {
    /// `None` where no real angular velocity goes with the directions.
    fate: Option<Fate>,
    /// (v, w) in the order of w.
    points: Vec<(Vector3<f64>, f64)>,
}

/// A branch of the cone, cut where its stability changes; neighbouring pieces share a point.
fn pieces(form: &Form, branch: Branch) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (v, w) in branch.points {
        let fate = branch.kind.map(|_| fate(form, v, w));
        match pieces.last_mut() {
            Some(piece) if piece.fate == fate => piece.points.push((v, w)),
            last => {
                let shared = last.and_then(|piece| piece.points.last().copied());
                pieces.push(Piece { fate, points: shared.into_iter().chain([(v, w)]).collect() });
            }
        }
    }
    pieces
}

/// What becomes of a tilt there: in doubles, as the picture is.
fn fate(form: &Form, v: Vector3<f64>, w: f64) -> Fate {
    let tensor = Matrix3::from_diagonal(&form.moments);
    let multiplier = ((tensor * v * w + form.spin) * w + form.weight).dot(&v);
    let motion = Reduced { tensor, spin: form.spin, speed: w, vertical: v, multiplier };
    Fate::of(&motion, |x: f64| if x > 0.0 { 1 } else { -1 })
}

/// One for each stationary relative speed of the rotor; none for a free rotor, which has one for each of its momenta, and
/// none where every direction is one.
fn cases(scene: &Scene) -> Vec<Case> {
    let System::Gyrostat(bodies) = &scene.system else { return Vec::new() };
    let Ok(all) = All::of(scene) else { return Vec::new() };
    if all.kept == Kept::Momentum {
        return Vec::new();
    }
    let derived = bodies.derived();
    let own = bodies.in_axes(&derived.full.axes);
    let census = all.census();
    let of_case = |(case, census): (&derivations::stationary::motions::Case, Option<Census>)| {
        let speed = case.value.to_f64();
        let (spin, weight) = (own.rotor.axial * speed, own.weight());
        let conditions = Stationary { moments: derived.full.moments, axis: own.rotor.axis, spin, weight };
        let form = Form { moments: conditions.moments, spin: conditions.axis * spin, weight };
        let folds: Vec<f64> = census.iter().flat_map(|census| &census.stretches).map(|stretch| stretch.to).collect();
        let folds: Vec<f64> = folds.into_iter().filter(|w| w.is_finite()).collect();
        let pieces = form.branches(&folds).into_iter().flat_map(|branch| pieces(&form, branch)).collect();
        Case { conditions, speed, singularity: derived.singularity, pieces, census }
    };
    let censuses = census.into_iter().map(Result::ok);
    let cases = all.cases.iter().zip(censuses).map(of_case);
    cases.filter(|case| case.conditions.weight.norm() > 0.0).collect()
}

/// How pieces are told apart: by their stability.
fn class(piece: &Piece) -> (usize, &'static str) {
    match piece.fate {
        Some(fate) => (Fate::ALL.iter().position(|known| *known == fate).unwrap_or(0), fate.name()),
        None => (Fate::ALL.len(), "no rotation: its square would be negative"),
    }
}

/// A piece as a curve of points in space with the angular velocity as value, thinned.
fn curve(piece: &Piece, size: f64, place: impl Fn(&Vector3<f64>, f64) -> Vector3<f64>) -> Curve {
    let (class, name) = class(piece);
    let mut points: Vec<CurvePoint> = Vec::new();
    let last = piece.points.len().saturating_sub(1);
    for (k, (v, w)) in piece.points.iter().enumerate() {
        let at = place(v, *w);
        let near = |known: &CurvePoint| (Vector3::from(known.at) - at).norm() < NEAR * size;
        if k == last || !points.last().is_some_and(near) {
            points.push(CurvePoint { at: at.into(), value: Some(*w) });
        }
    }
    Curve { name: name.to_owned(), class: Some(class), points }
}

fn cone(case: &Case, titles: &[&str]) -> Sphere {
    let (conditions, speed) = (&case.conditions, case.speed);
    let marks = idle(conditions).into_iter().chain(named(conditions)).collect();
    Sphere {
        title: format!("The cone of all axes of rotation, the rotor at {} rad/s", significant(speed, 4)),
        description: "Each point of the lines is a direction in the carrier, in the principal axes of $A^*$, that can \
                      point straight down while the carrier turns about it for ever and the rotor keeps its relative \
                      speed: (7.11), branch by branch over the angular velocity, so that none is missed. Point at a line \
                      to read $\\omega^0$. The colour is stability. Where the energy is definite at fixed integrals, deviations \
                      stay small at constant speed, and with a motor they fade, if it feels them; what gyroscopic forces alone \
                      hold at constant speed, a motor that feels it makes unstable. At $e$ and $-e$ the carrier rests; to the principal directions \
                      the lines tend as $\\omega^0\\to\\pm\\infty$."
            .to_owned(),
        facts: facts(case),
        value: "angular velocity of the carrier, rad/s".to_owned(),
        axes: ["\u{3be}₁".into(), "\u{3be}₂".into(), "\u{3be}₃".into()],
        curves: case.pieces.iter().map(|piece| curve(piece, 1.0, |v, _| *v)).collect(),
        marks,
        view: VIEW,
        note: format!("The gyrostat of: {}.", titles.join("; ")),
        ..Sphere::default()
    }
}

fn directrix(case: &Case) -> Sphere {
    let length = reach(case);
    let real = case.pieces.iter().filter(|piece| piece.fate.is_some());
    Sphere {
        title: format!("The directrix, the rotor at {} rad/s", significant(case.speed, 4)),
        description: format!(
            "The ends of the angular velocities $\\omega^0\\nu$ in the carrier, in the principal axes of $A^*$. The sphere \
             has the radius {} rad/s. The curve passes through the centre, where the carrier rests, and goes to infinity \
             along the principal axes.",
            significant(length, 3)
        ),
        value: "angular velocity of the carrier, rad/s".to_owned(),
        axes: ["\u{3be}₁".into(), "\u{3be}₂".into(), "\u{3be}₃".into()],
        length: Some(length),
        curves: real.map(|piece| curve(piece, length, |v, w| v * w)).collect(),
        view: VIEW,
        ..Sphere::default()
    }
}

/// An angular velocity beyond which nothing happens any more: past the last fold.
fn reach(case: &Case) -> f64 {
    let stretches = case.census.iter().flat_map(|census| &census.stretches);
    let last = stretches.map(|stretch| stretch.to.abs()).filter(|w| w.is_finite()).fold(0.0, f64::max);
    let size = case.conditions.moments.max();
    let usual = (case.conditions.weight.norm() / size).sqrt() + case.conditions.spin.abs() / size;
    if last > 0.0 { 1.4 * last } else { 3.0 * usual }
}

/// The angular velocity along the cone, and the number of motions for each.
fn study(found: &[(Case, Vec<&str>)]) -> Study {
    let tables = found.iter().filter_map(|(case, _)| table(case)).collect();
    let run = found.first().map(|(case, _)| along(case));
    Study {
        id: "stationary-cone".into(),
        title: "All stationary motions".into(),
        lead: "For a given angular velocity the stationary directions are the real roots of one polynomial; for every \
               angular velocity their number is known, because the angular velocities at which two of them merge are roots \
               of a polynomial too. All are isolated exactly; `dalembert stationary` lists them for any scene, with its \
               certificate."
            .replace('`', ""),
        run,
        tables,
        ..Study::default()
    }
}

/// For each branch: how far the vertical is from the centre of mass, and the vertical momentum, over the angular velocity.
fn along(case: &Case) -> charts::Trajectory {
    let (conditions, reach) = (&case.conditions, reach(case));
    let down = conditions.weight.normalize();
    let angle = |v: &Vector3<f64>, _: f64| v.dot(&down).clamp(-1.0, 1.0).acos().to_degrees();
    let momentum = |v: &Vector3<f64>, w: f64| {
        v.component_mul(&conditions.moments).dot(v) * w + conditions.spin * conditions.axis.dot(v)
    };
    let panel = |y: &str, value: &dyn Fn(&Vector3<f64>, f64) -> f64| {
        // in the order of the classes, so that they look as on the sphere
        let mut pieces: Vec<&Piece> = case.pieces.iter().filter(|piece| piece.fate.is_some()).collect();
        pieces.sort_by_key(|piece| class(piece).0);
        let track = |piece: &&Piece| Track {
            name: class(piece).1.to_owned(),
            points: piece.points.iter().filter(|(_, w)| w.abs() <= reach).map(|(v, w)| (*w, value(v, *w))).collect(),
            stopped: None,
        };
        let series = pieces.iter().map(track).filter(|track| !track.points.is_empty()).collect();
        Panel { y: y.to_owned(), series }
    };
    charts::Trajectory {
        title: format!("The angular velocity along the cone, the rotor at {} rad/s", significant(case.speed, 4)),
        x: "angular velocity of the carrier, rad/s".into(),
        panels: vec![panel("angle from e, degrees", &angle), panel("vertical momentum, N m s", &momentum)],
        note: "A vertical line meets the upper curves in all stationary motions with that angular velocity; a horizontal one \
               meets the lower curves in all with that momentum, which every motor conserves."
            .into(),
    }
}

fn table(case: &Case) -> Option<Table> {
    let census = case.census.as_ref()?;
    let bound =
        |w: f64| if w.is_finite() { significant(w, 6) } else { (if w < 0.0 { "−∞" } else { "∞" }).to_owned() };
    let rows = census.stretches.iter().map(|stretch| {
        let families = if stretch.families > 0 { format!(" and {} families", stretch.families) } else { String::new() };
        vec![bound(stretch.from), bound(stretch.to), format!("{}{families}", stretch.isolated)]
    });
    Some(Table {
        caption: format!("How many stationary motions, the rotor at {} rad/s", significant(case.speed, 4)),
        head: ["from, rad/s", "to, rad/s", "motions"].map(String::from).into(),
        rows: rows.collect(),
    })
}

/// What carrier and rotor come to, in the principal axes of A*.
fn facts(case: &Case) -> Vec<(String, String)> {
    let Case { conditions, speed, singularity, .. } = case;
    let numbers = |v: Vector3<f64>| v.iter().map(|x| significant(*x, 3)).collect::<Vec<_>>().join(", ");
    let weight = conditions.weight;
    let facts = [
        ("principal moments of $A^*$", format!("{} kg m²", numbers(conditions.moments))),
        ("rotor's axis $l$", format!("({})", numbers(conditions.axis))),
        ("direction $e$ of the centre of mass", format!("({})", numbers(weight.normalize()))),
        ("$\\Gamma$, weight times distance", format!("{} N m", significant(weight.norm(), 3))),
        ("$A'\\Omega$, the rotor's own momentum", format!("{} N m s", significant(conditions.spin, 3))),
        ("$\\Omega$, its relative speed", format!("{} rad/s", significant(*speed, 4))),
        ("$D = \\det A / \\det A^*$", significant(*singularity, 4)),
    ];
    facts.map(|(name, value)| (name.to_owned(), value)).into()
}

/// The directions that the gyrostat itself has.
fn named(conditions: &Stationary<f64>) -> [Mark; 3] {
    let mark = |name: &str, at: Vector3<f64>, note: &str| Mark {
        name: name.into(),
        at: at.into(),
        note: note.into(),
        hollow: false,
    };
    let down = conditions.weight.normalize();
    [
        mark("l, rotor", conditions.axis, "the rotor's axis"),
        mark("e, hanging", down, "the centre of mass below the fixed point, at rest"),
        mark("\u{2212}e, upright", -down, "the centre of mass above the fixed point, at rest"),
    ]
}

/// The principal directions, which lie on the line whatever the data, where no angular velocity makes a motion.
fn idle(conditions: &Stationary<f64>) -> Vec<Mark> {
    let directions = (0..3).flat_map(|i| [1.0, -1.0].map(|sign| Vector3::ith(i, sign)));
    let idle = directions.filter(|direction| !turns_about(conditions, *direction));
    idle.map(|at| Mark {
        at: at.into(),
        note: "principal direction: on the line, but no rotation about it".into(),
        hollow: true,
        ..Mark::default()
    })
    .collect()
}

/// Whether some angular velocity about a principal direction is a motion. The missing moment there is b + a w0, because
/// A* v x v vanishes: so a and b must be parallel.
fn turns_about(conditions: &Stationary<f64>, direction: Vector3<f64>) -> bool {
    let still = conditions.missing_moment(direction, 0.0);
    let slope = conditions.missing_moment(direction, 1.0) - still;
    let (a, b) = (slope.norm(), still.norm());
    if b <= ROUNDING * conditions.weight.norm() {
        return true;
    }
    a > ROUNDING * conditions.spin.abs() && slope.cross(&still).norm() <= ROUNDING * a * b
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gyrostat(axis: [f64; 3], weight: [f64; 3]) -> Stationary<f64> {
        Stationary { moments: Vector3::new(3.0, 4.0, 5.0), axis: axis.into(), spin: 2.0, weight: weight.into() }
    }

    #[test]
    fn principal_directions_are_rings_unless_some_rotation_about_them_is_a_motion() {
        assert_eq!(idle(&gyrostat([0.6, 0.0, 0.8], [0.0, 3.0, 1.0])).len(), 6);
        // rotor and weight in one principal plane: a rotation about each of its two axes, the rest along none
        assert_eq!(idle(&gyrostat([0.6, 0.8, 0.0], [1.0, 3.0, 0.0])).len(), 2);
        // hanging on a principal axis is a rest at least
        assert_eq!(idle(&gyrostat([0.6, 0.0, 0.8], [1.0, 0.0, 0.0])).len(), 2);
    }
}
