//! Loads that brake a motion one way and drive it the other way: the resistance of a fan as -c w^2.
//!
//! Where speeds change their signs, the part of a load's power with their even powers stays: viscous friction takes energy either way. The part with
//! their third power, and with higher odd ones, changes its sign. The first power belongs to a load that does not depend on speeds.

use crate::equations::vanishes;
use crate::{Along, Fault, Force, Model, Torque, Trace};
use std::ops::Range;
use symbolic::{Dimension, Sym, apart};

/// A load as a file has it, by its place in the model.
#[derive(Clone, Copy, Debug)]
pub(super) enum Load {
    Force(usize),
    Torque(usize),
    Generalised(usize),
}

/// The highest power of speeds that is looked for.
const HIGHEST: usize = 8;

/// A warning for each such load.
pub(super) fn one_sided(model: &Model, loads: &[(Load, Range<usize>)]) -> Vec<Fault> {
    let warning = |at: &Range<usize>| {
        Fault::at(
            at.clone(),
            "this load brakes a motion one way, and drives it the other way",
            "its power has an odd power of the speeds",
            "`-c*abs(w)*w`, which brakes both ways; of a motion that goes one way alone it may stay",
        )
    };
    // in energies without bodies speeds have no ways that loads could brake
    if model.bodies.is_empty() {
        return Vec::new();
    }
    apart(|| {
        let trace = Trace::of(model);
        let is_one_sided = |load: Load| power(&trace, load).is_some_and(|power| changes_sign(&trace, power));
        loads.iter().filter(|(load, _)| is_one_sided(*load)).map(|(_, at)| warning(at)).collect()
    })
}

/// The power of a load; none of one along a quasi-velocity.
fn power(trace: &Trace<'_>, load: Load) -> Option<Sym> {
    let model = trace.model;
    Some(match load {
        Load::Force(place) => match &model.forces[place] {
            Force::On { at, is } => trace.dot(trace.vector(*is), trace.material_velocity(*at)),
            Force::Between { points, is } => {
                let [first, second] = points.map(|point| trace.material_velocity(point));
                let line = trace.between(points[0].point, points[1].point);
                // its length has no speed
                trace.scalar(*is) * (trace.dot(line, second) - trace.dot(line, first))
            }
        },
        Load::Torque(place) => match &model.torques[place] {
            Torque::On { frame, is } => trace.dot(trace.vector(*is), trace.turning(*frame)),
            Torque::Between { frames, is } => {
                let [first, second] = frames.map(|frame| trace.dot(trace.vector(*is), trace.turning(frame)));
                second - first
            }
        },
        Load::Generalised(place) => match model.generalised[place].along {
            Along::Speed(speed) => trace.scalar(model.generalised[place].is) * trace.speeds[speed],
            Along::Expression(speed) => trace.scalar(model.generalised[place].is) * trace.scalar(speed),
            Along::QuasiVelocity(_) => return None,
        },
    })
}

/// Whether a power is a sum of powers of the speeds, with an odd one beyond the first. Currents and reactions are no speeds here, and an `abs` or a `sign`
/// depends on the direction.
fn changes_sign(trace: &Trace<'_>, power: Sym) -> bool {
    if power.symbols_of().iter().any(|symbol| trace.switches.contains(symbol)) {
        return false;
    }
    let charge = Dimension::current() * Dimension::time();
    let model = trace.model;
    let is_charge = |place: usize| model.coordinates.get(place).is_some_and(|one| one.dimension == charge);
    let is_letter = |place: usize| is_charge(place) || model.impulses.contains(&place);
    let factor = Sym::symbol("[factor of speeds]");
    let speeds = trace.speeds.iter().enumerate().filter(|(place, _)| !is_letter(*place));
    let scaled: Vec<(Sym, Sym)> = speeds.map(|(_, &speed)| (speed, factor * speed)).collect();
    let mut derivative = power.substitute(&scaled);
    let mut is_odd = false;
    for order in 1..=HIGHEST {
        derivative = derivative.diff(factor);
        if derivative == Sym::ZERO {
            return is_odd;
        }
        let term = derivative.substitute(&[(factor, Sym::ZERO)]);
        if term == Sym::UNDEFINED || order == 2 && !is_odd && vanishes(derivative.diff(factor)) {
            return false;
        }
        is_odd |= order > 2 && order % 2 == 1 && term != Sym::ZERO && !vanishes(term);
    }
    is_odd && vanishes(derivative)
}
