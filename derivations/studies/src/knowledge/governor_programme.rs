//! The friction governor with a programmed motion of the wheel that keeps the second shaft's speed: closed forms,
//! margins and series.
//!
//! A governor with a drum and a disc has the parameter R, one with two discs has a.

use super::friction_governor::{LATERAL, frictionless};
use crate::model_reduction::models::Reductions;
use crate::model_reduction::{Loss, Lower, ReducedModel};
use field::Over;
use simulation::Axes;
use simulation::events::{Margin, Margins};
use simulation::knowledge::{ClosedForm, Diagnosis, Ended, Knowledge, submit};
use simulation::models::Modelled;
use std::sync::Arc;
use symbolic::Sym;
use systems::governor::constant::{ConstantTorques, ProgrammeEnd};
use systems::governor::{Gearing, Governor, Torque};

const NAME: &str = "governor_programme";

submit! { Knowledge {
    name: NAME,
    summary: "a friction governor, its wheel led so that the second shaft keeps its speed",
    parameters: &["J1", "J2", "J", "m", "r", "M1", "M2", LATERAL, "speed"],
    columns: &["phi1", "phi2", "phi", "rho"],
    equations: &[include_str!("../../../../scenes/governors/drum_programme.toml"), include_str!("../../../../scenes/governors/between_discs.toml")],
    theory: |scene, _| theory(scene),
    diagnosis,
    closed_form,
    margins,
} }

submit! { Reductions { name: NAME, models } }

/// The governor of a scene, without a force along the axle.
///
/// # Errors
/// The name of a missing parameter.
pub fn governor(scene: &dyn Modelled) -> Result<Governor<f64>, &'static str> {
    let datum = |name: &'static str| scene.value(name).ok_or(name);
    let gearing = match scene.value("R") {
        Some(radius) => Gearing::Drum { radius },
        None => Gearing::Discs { distance: datum("a")? },
    };
    Ok(Governor {
        inertia: [datum("J1")?, datum("J2")?, datum("J")?],
        mass: datum("m")?,
        radius: datum("r")?,
        gearing,
        moments: [Torque::constant(datum("M1")?), Torque::constant(datum("M2")?)],
        push: 0.0,
        lateral: datum(LATERAL)?,
    })
}

/// The closed form of the motion of the wheel.
struct Closed {
    course: ProgrammeEnd,
    what: &'static str,
    distance: Box<dyn Fn(f64) -> Option<f64>>,
}

impl Closed {
    fn of(scene: &dyn Modelled) -> Option<Self> {
        let (governor, speed, start) = (governor(scene).ok()?, scene.value("speed")?, scene.value("rho")?);
        if let Some(between) = governor.between(speed) {
            let distance = Box::new(move |time| between.distance_at(start, time));
            return Some(Closed { course: between.course(start), what: "the quadrature in closed form", distance });
        }
        let law = governor.small_parameter(speed)?;
        let (of_second, of_first) = (law.of_second[0], law.of_first[0]);
        let law = ConstantTorques { epsilon: law.epsilon, of_second, of_first, start };
        let distance = Box::new(move |time| law.distance(time));
        Some(Closed { course: law.course(), what: "the closed form by Lambert's W", distance })
    }
}

fn closed_form(scene: &dyn Modelled, time: f64) -> Option<ClosedForm> {
    let closed = Closed::of(scene)?;
    let rho = (closed.distance)(time)?;
    Some(ClosedForm { what: closed.what, values: vec![("rho", rho)] })
}

fn theory(scene: &dyn Modelled) -> Vec<String> {
    let said = Closed::of(scene).map(|closed| match closed.course {
        ProgrammeEnd::Rest => "the moments balance: the wheel rests".to_owned(),
        ProgrammeEnd::ReachesAxis { time } if !time.is_finite() => {
            "the wheel comes to the axis of the second disc, at a time that doubles do not hold".to_owned()
        }
        ProgrammeEnd::ReachesAxis { time } => {
            format!("the wheel comes to the axis of the second disc at t = {time:.9} s, and no motion follows")
        }
        ProgrammeEnd::TendsTo { distance: 0.0 } => {
            "the wheel tends to the axis of the first disc, whose speed grows without bound".to_owned()
        }
        ProgrammeEnd::TendsTo { distance } if !distance.is_finite() => {
            "the wheel tends to a distance that doubles do not hold".to_owned()
        }
        ProgrammeEnd::TendsTo { distance } => format!("the wheel tends to rho = {distance:.9} m"),
        ProgrammeEnd::Grows => "rho grows without bound: the wheel leaves every disc".to_owned(),
    });
    said.into_iter().collect()
}

/// The fraction of its initial value below which the second lever arm counts as zero.
const NEAR: f64 = 1e-2;

fn diagnosis(run: &Ended<'_>) -> Option<Diagnosis> {
    let (governor, first) = (governor(run.scene).ok()?, run.scene.value("rho")?);
    let at = Closed::of(run.scene).and_then(|closed| match closed.course {
        ProgrammeEnd::ReachesAxis { time } => Some(time).filter(|time| time.is_finite()),
        _ => None,
    });
    let [[_, now], [_, first]] = [run.last("rho"), first].map(|rho| governor.levers(rho));
    if !run.has_left_its_law() && now > NEAR * first && !at.is_some_and(|at| run.was_before(at)) {
        return None;
    }
    let what = match governor.moments[1].start {
        0.0 => "the wheel comes to the axis of the second disc: no motion follows",
        _ => {
            "blow-up in finite time: the wheel comes to the axis of the second disc with infinite speed, and no motion follows"
        }
    };
    Some(Diagnosis { what: what.to_owned(), at })
}

/// The margins: the lever arms of the wheel that change.
fn margins(scene: &dyn Modelled, states: &[String]) -> Option<Box<Margins>> {
    let gearing = governor(scene).ok()?.gearing;
    let place = states.iter().position(|name| name == "rho")?;
    Some(Box::new(move |_, y, dy| {
        let [rho, rate] = [y[place], dy[place]];
        let second = "the wheel has come to the axis of the second disc, or beyond";
        let first = "the wheel has come to the axis of the first disc, or beyond";
        match gearing {
            Gearing::Drum { .. } => vec![Margin { value: rho, rate, what: second, ..Margin::default() }],
            Gearing::Discs { distance } => vec![
                Margin { value: rho, rate, what: first, ..Margin::default() },
                Margin { value: distance - rho, rate: -rate, what: second, ..Margin::default() },
            ],
        }
    }))
}

fn models(scene: &dyn Modelled) -> Vec<ReducedModel> {
    frictionless(scene).into_iter().chain(series(scene).unwrap_or_default()).collect()
}

/// Reduced models by truncated series of the programmed motion in powers of its small parameter: the wheel has no state
/// but the time; the shafts rotate as the wheel rolls.
fn series(scene: &dyn Modelled) -> Option<Vec<ReducedModel>> {
    const ORDERS: [(usize, &str); 4] =
        [(1, "series to eps"), (2, "series to eps^2"), (4, "series to eps^4"), (8, "series to eps^8")];
    let (governor, speed) = (governor(scene).ok()?, scene.value("speed")?);
    let (law, start) = (governor.small_parameter(speed)?, scene.problem(Axes::First).state);
    let place = Arc::new(move |clock: Sym, terms: &[Vec<f64>]| {
        let value = |term: &Vec<f64>| term.iter().rev().fold(Sym::ZERO, |sum, &c| sum * clock + Sym::lift(c));
        terms.iter().rev().fold(Sym::ZERO, |sum, term| sum * Sym::lift(law.epsilon) + value(term))
    });
    let turning = move |rho: Sym| {
        let [first, second] = governor.levers(rho);
        let (rim, speed) = (second * Sym::lift(speed), Sym::lift(speed));
        [rim / first, speed, rim / Sym::lift(governor.radius)]
    };
    let reduced = |(order, name): (usize, &'static str)| {
        let terms = Arc::new(law.series(start[3], order));
        let (seen, followed) = ((Arc::clone(&place), Arc::clone(&terms)), (Arc::clone(&place), terms));
        let lift = move |_: Sym, z: &[Sym]| {
            let (place, terms) = &seen;
            let rho = place(z[0], terms);
            let [first, second, wheel] = turning(rho);
            vec![z[1], z[2], z[3], rho, first, second, wheel, rho.diff(z[0])]
        };
        let rates = move |_: Sym, z: &[Sym]| {
            let (place, terms) = &followed;
            let [first, second, wheel] = turning(place(z[0], terms));
            vec![Sym::ONE, first, second, wheel]
        };
        let lower = Lower { dimension: 4, lift: Arc::new(lift), rates: Arc::new(rates), kept: None };
        let loss = Loss::Small { parameter: "eps (k1/rho0 + k2) t/rho0" };
        let first = vec![0.0, start[0], start[1], start[2]];
        ReducedModel::new(name, "the powers of the small parameter beyond", loss, lower, first)
    };
    Some(ORDERS.into_iter().filter_map(reduced).collect())
}
