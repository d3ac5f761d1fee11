//! The pictures of all stationary motions: the cone on the unit sphere, the directrix in space, the angular velocity along
//! both.

mod along;
mod marks;
mod pieces;

use crate::stability_map;
use along::{along, table};
use charts::{Curve, CurvePoint, Sphere, Study, significant};
use marks::{idle, named};
use mechanics::uniform::Census;
use nalgebra::Vector3;
use pieces::{Known, Piece, class, pieces};
use std::collections::HashMap;
use studies::scene::{Scene, System};
use studies::stationary::branches::Form;
use studies::stationary::energies::Kept;
use studies::stationary::motions::Stationary as All;
use studies::stationary::stability::cone::Fates;
use systems::gyrostat::stationary::Stationary;

/// Points closer together than this, as a share of the picture, are not drawn.
const NEAR: f64 = 0.012;
/// The first point of view.
const VIEW: (f64, f64) = (35.0, 25.0);

/// Gyrostats with a speed of their rotor: scenes that share these share the pictures.
pub fn all<'a>(scenes: impl Iterator<Item = &'a Scene>) -> (Vec<Sphere>, Option<Study>) {
    let scenes: Vec<&Scene> = scenes.collect();
    let mut found: Vec<(Case, Vec<&str>)> = Vec::new();
    scenes.iter().for_each(|scene| gather(scene, &mut found));
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

/// One case for each stationary relative speed of the rotor, unless it is known; none for a free rotor, which has one for each of
/// its momenta, and none where every direction is one.
fn gather<'a>(scene: &'a Scene, found: &mut Vec<(Case, Vec<&'a str>)>) {
    let System::Gyrostat(bodies) = &scene.system else { return };
    let Ok(all) = All::of(scene) else { return };
    let Ok(fates) = Fates::of(&all.energies) else { return };
    let derived = bodies.derived();
    let own = bodies.in_axes(&derived.full.axes);
    if all.kept == Kept::Momentum || own.weight().norm() == 0.0 {
        return;
    }
    for case in &all.cases {
        let speed = case.value.to_f64();
        let (spin, weight) = (own.rotor.axial * speed, own.weight());
        let conditions = Stationary { moments: derived.full.moments, axis: own.rotor.axis, spin, weight };
        if let Some((_, titles)) = found.iter_mut().find(|(known, _)| known.conditions == conditions) {
            titles.push(&scene.title);
            continue;
        }
        let Some(drawn) = case.drawn(&all.energies, all.kept) else { continue };
        let census = case.body.census().ok();
        let form = Form { moments: conditions.moments, spin: conditions.axis * spin, weight };
        let folds = census.iter().flat_map(|census| &census.stretches).map(|stretch| stretch.to);
        let folds: Vec<f64> = folds.filter(|w| w.is_finite()).collect();
        let mut known = Known { fates: &fates, case: &drawn, axes: derived.full.axes, at: HashMap::new() };
        let pieces = form.branches(&folds).into_iter().flat_map(|branch| pieces(&mut known, branch)).collect();
        found.push((Case { conditions, speed, singularity: derived.singularity, pieces, census }, vec![&scene.title]));
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
