//! Steady motions of a gyrostat as JSON.

use super::{Given, motor, why};
use crate::stability;
use mechanics::steady_rotations::{Census, Shape, Undecided};
use serde_json::{Value, json};
use studies::scene::Scene;
use studies::stationary::energies::Kept;
use studies::stationary::motions::{Answer, Certificate, Found, Stationary};
use studies::stationary::motor::MotorStates;

pub(super) fn all(scene: &Scene, all: &Stationary<'_>, given: Given, answers: &[Answer]) -> Value {
    let (name, value) = match given {
        Given::Speed(w) => ("omega0", w),
        Given::Momentum(p) => ("momentum", p),
    };
    let each = answers.iter().map(|answer| {
        let Certificate { degree, roots, again, morse, undecided } = &answer.certificate;
        json!({
            kept_name(all.kept): answer.value,
            "complete": answer.certificate.is_complete(),
            "certificate": { "degree": degree, "real_roots": roots, "by_sturm": again, "morse": morse,
                             "undecided": undecided.map(why) },
            "motions": answer.found.iter().map(|found| motion(&all.motor, found)).collect::<Vec<_>>(),
        })
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "motor": motor::object(&all.motor), name: value,
            "cases": each.collect::<Vec<_>>() })
}

pub(super) fn census(scene: &Scene, all: &Stationary<'_>, census: &[Result<Census, Undecided>]) -> Value {
    let finite = |w: f64| w.is_finite().then_some(w);
    let each = all.cases.iter().zip(census).map(|(case, census)| {
        let stretches = census.as_ref().ok().map(|census| {
            let stretch = |s: &mechanics::steady_rotations::SpeedInterval| {
                json!({ "from": finite(s.from), "to": finite(s.to), "isolated": s.isolated, "families": s.families })
            };
            census.stretches.iter().map(stretch).collect::<Vec<_>>()
        });
        json!({ kept_name(all.kept): case.value.to_f64(), "complete": census.is_ok(), "stretches": stretches })
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "motor": motor::object(&all.motor),
            "cone": each.collect::<Vec<_>>() })
}

fn motion(motor: &MotorStates, found: &Found) -> Value {
    let boxed: Vec<[f64; 2]> = found.enclosed.iter().map(|x| x.ends()).collect();
    let circle = found.family.as_ref().and_then(|members| members.circle);
    let circle = circle.map(|(radius, axis)| json!({ "radius": radius, "axis": axis.as_slice() }));
    json!({
        "shape": shape(found.shape), "kind": super::text::kind(found.kind), "multiplier": found.multiplier,
        "direction": found.enclosed.each_ref().map(|x| x.to_f64()), "box": boxed, "circle": circle,
        "omega0": found.speed, "rotor_speed": found.rotor_speed, "momentum": found.momentum, "residual": found.residual,
        "stability": match &found.family {
            Some(members) => stability::along_objects(motor, &members.along),
            None => stability::objects(motor, &found.stability),
        },
    })
}

fn kept_name(kept: Kept) -> &'static str {
    match kept {
        Kept::RelativeSpeed => "rotor_speed",
        Kept::Momentum => "rotor_momentum",
    }
}

fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::Point => "point",
        Shape::Pair { .. } => "one of a pair",
        Shape::Circle { .. } => "circle",
        Shape::Sphere => "sphere",
    }
}
