//! Loads that resist a motion in one direction and drive it in the other, such as the resistance -c w^2 of a fan.
//!
//! If all speeds change their signs, the terms of a load's power with even powers of the speeds stay: viscous friction dissipates in both directions. The
//! terms with the third and higher odd powers change their sign. Terms with the first power belong to loads that do not depend on speeds.

use crate::equations::vanishes;
use crate::{Along, Fault, Force, Model, Torque, Trace};
use std::ops::Range;
use symbolic::{Dimension, Sym, apart};

/// A load of the file, by its index in the model.
#[derive(Clone, Copy, Debug)]
pub(super) enum Load {
    Force(usize),
    Torque(usize),
    Generalised(usize),
}

/// The highest power of the speeds that is examined.
const HIGHEST: usize = 8;

/// Returns a warning for each such load.
pub(super) fn one_sided(model: &Model, loads: &[(Load, Range<usize>)]) -> Vec<Fault> {
    let warning = |at: &Range<usize>| {
        Fault::at(
            at.clone(),
            "this load brakes a motion one way, and drives it the other way",
            "its power has an odd power of the speeds",
            "`-c*abs(w)*w`, which brakes both ways; if the speed never changes its sign, the load may stay as it is",
        )
    };
    // in a system given by energies only, speeds have no direction in space
    if model.bodies.is_empty() {
        return Vec::new();
    }
    apart(|| {
        let trace = Trace::of(model);
        let is_one_sided = |load: Load| power(&trace, load).is_some_and(|power| changes_sign(&trace, power));
        loads.iter().filter(|(load, _)| is_one_sided(*load)).map(|(_, at)| warning(at)).collect()
    })
}

/// Returns the power of a load; `None` for a load along a quasi-velocity.
fn power(trace: &Trace<'_>, load: Load) -> Option<Sym> {
    let model = trace.model;
    Some(match load {
        Load::Force(place) => match &model.forces[place] {
            Force::On { at, is } => trace.dot(trace.vector(*is), trace.material_velocity(*at)),
            Force::Between { points, is } => {
                let [first, second] = points.map(|point| trace.material_velocity(point));
                let line = trace.between(points[0].point, points[1].point);
                // the magnitude of the vector cancels with the normalisation of the direction
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

/// Returns whether a power is a polynomial in the speeds with an odd power above the first. Currents and rates of reaction impulses do not count as speeds, and
/// a power that contains a switch (`abs`, `sign`) is excluded.
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
