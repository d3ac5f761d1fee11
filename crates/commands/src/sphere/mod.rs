//! Pictures of all steady motions of a gyrostat: the cone of permanent rotations on the unit sphere, its directrix in space, and the angular
//! velocity along both.

mod along;
mod marks;
mod pieces;

use crate::job_pool::JobPool;
use crate::stability_map;
use along::{along, table};
use charts::{Areas, Curve, CurvePoint, Sphere, Study, significant};
use marks::{idle, named};
use mechanics::steady_rotations::Census;
use nalgebra::{Matrix3, Vector3};
use pieces::{Known, Piece, class, pieces};
use std::collections::HashMap;
use studies::scene::{Scene, Setup};
use studies::stationary::branches::Form;
use studies::stationary::energies::Kept;
use studies::stationary::motions::{Case as Drawn, Stationary as All};
use studies::stationary::stability::cone::Fates;
use systems::gyrostat::stationary::Stationary as Conditions;

/// The least distance between drawn points, as a fraction of the size of the picture.
const NEAR: f64 = 0.012;
/// The initial view: azimuth and elevation in degrees.
const VIEW: (f64, f64) = (35.0, 25.0);

/// The cones of all gyrostats at the constant speeds of their rotors. Scenes with equal data share a cone.
#[derive(Default)]
pub struct Stationary {
    cones: Vec<Cone>,
    /// The cones as they are drawn; `None` before the jobs have run.
    cases: Vec<Option<Case>>,
    maps: Option<Vec<Areas>>,
}

/// The equations of the permanent rotations of a gyrostat at one rotor speed, and the stability of each rotation.
struct Cone {
    conditions: Conditions<f64>,
    /// The constant speed of the rotor relative to the carrier, rad/s.
    speed: f64,
    /// The ratio D = det A / det A*.
    singularity: f64,
    /// The principal axes of A* as columns.
    axes: Matrix3<f64>,
    body: Drawn,
    fates: Fates,
    titles: Vec<String>,
}

/// A drawn cone: the permanent rotations of a gyrostat, in pieces of one stability, and its data.
struct Case {
    conditions: Conditions<f64>,
    /// The constant speed of the rotor relative to the carrier, rad/s.
    speed: f64,
    /// The ratio D = det A / det A*.
    singularity: f64,
    pieces: Vec<Piece>,
    census: Option<Census>,
    titles: Vec<String>,
}

/// The expected time for computing a cone, s.
const COST: f64 = 4.0;

impl Stationary {
    /// The cones of the gyrostats of the scenes, not computed yet.
    pub fn of<'s>(scenes: impl Iterator<Item = &'s Scene>) -> Self {
        let mut cones = Vec::new();
        scenes.for_each(|scene| gather(scene, &mut cones));
        Stationary { cases: cones.iter().map(|_| None).collect(), cones, maps: None }
    }

    /// Adds the jobs that compute the cones and the stability maps.
    pub fn enlist<'s>(&'s mut self, scenes: Vec<&'s Scene>, crew: &mut JobPool<'s>) {
        for (place, cone) in self.cases.iter_mut().zip(&self.cones) {
            crew.add(COST, place, || cone.drawn());
        }
        crew.add(1.0, &mut self.maps, move || stability_map::all(&scenes));
    }

    /// The pictures and the study for the report.
    pub fn pictures(self) -> (Vec<Sphere>, Option<Study>) {
        let found: Vec<Case> = self.cases.into_iter().flatten().collect();
        let spheres = found.iter().flat_map(|case| [cone(case), directrix(case)]).collect();
        let pictures = self.maps.unwrap_or_default();
        (spheres, (!found.is_empty()).then(|| Study { pictures, ..study(&found) }))
    }
}

/// Adds a cone for each constant relative speed of the rotor, unless it is in the list. A scene with a free rotor has none, since each value of the
/// rotor's momentum has another cone; neither has a scene in which every direction is steady.
fn gather(scene: &Scene, found: &mut Vec<Cone>) {
    let Setup::Gyrostat(bodies) = &scene.system else { return };
    let Ok(all) = All::of(scene) else { return };
    let derived = bodies.derived();
    let axes = derived.full.axes;
    let own = bodies.in_axes(&axes);
    if all.kept == Kept::Momentum || own.weight().norm() == 0.0 {
        return;
    }
    for case in &all.cases {
        let speed = case.value.to_f64();
        let (spin, weight) = (own.rotor.axial * speed, own.weight());
        let conditions = Conditions { moments: derived.full.moments, axis: own.rotor.axis, spin, weight };
        if let Some(known) = found.iter_mut().find(|known| known.conditions == conditions) {
            known.titles.push(scene.title.clone());
            continue;
        }
        let (Some(body), Ok(fates)) = (case.drawn(&all.energies, all.kept), Fates::of(&all.energies)) else { continue };
        let (singularity, titles) = (derived.singularity, vec![scene.title.clone()]);
        found.push(Cone { conditions, speed, singularity, axes, body, fates, titles });
    }
}

impl Cone {
    fn drawn(&self) -> Case {
        let Conditions { moments, axis, spin, weight } = self.conditions;
        let census = self.body.body.census().ok();
        let form = Form { moments, spin: axis * spin, weight };
        let folds = census.iter().flat_map(|census| &census.stretches).map(|stretch| stretch.to);
        let folds: Vec<f64> = folds.filter(|w| w.is_finite()).collect();
        let mut known = Known { fates: &self.fates, case: &self.body, axes: self.axes, at: HashMap::new() };
        let pieces = form.branches(&folds).into_iter().flat_map(|branch| pieces(&mut known, branch)).collect();
        let Cone { conditions, speed, singularity, .. } = *self;
        Case { conditions, speed, singularity, pieces, census, titles: self.titles.clone() }
    }
}

/// The curve of a piece in space, thinned, with the angular velocity as the value that colours it.
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

fn cone(case: &Case) -> Sphere {
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
        note: format!("The gyrostat of: {}.", case.titles.join("; ")),
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

/// The angular velocity up to which the cone is drawn, beyond the last fold, rad/s.
fn reach(case: &Case) -> f64 {
    let stretches = case.census.iter().flat_map(|census| &census.stretches);
    let last = stretches.map(|stretch| stretch.to.abs()).filter(|w| w.is_finite()).fold(0.0, f64::max);
    let size = case.conditions.moments.max();
    let usual = (case.conditions.weight.norm() / size).sqrt() + case.conditions.spin.abs() / size;
    if last > 0.0 { 1.4 * last } else { 3.0 * usual }
}

/// The study of the angular velocity along the cone, with the number of steady motions at each angular velocity.
fn study(found: &[Case]) -> Study {
    let tables = found.iter().filter_map(table).collect();
    let run = found.first().map(along);
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

/// The data of carrier and rotor with units; vectors are in the principal axes of A*.
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
