//! Sufficient condition for the conservation of the energy T + V of a model.

use crate::changing_laws::changes;
use model::equations::{Equation, Level, constraints_of, vanishes};
use model::{Model, Trace};
use symbolic::Sym;

/// Returns true if the form of loads and constraints shows that T + V is constant along every motion.
pub fn keeps_energy(model: &Model) -> bool {
    symbolic::apart(|| conserves(model))
}

/// True if the only loads are uniform gravity and a given potential, constraints do no work, the kinetic energy is quadratic in the
/// speeds, and nothing depends on time or changes at events.
pub(crate) fn conserves(model: &Model) -> bool {
    let acts = !(model.forces.is_empty() && model.torques.is_empty() && model.generalised.is_empty())
        || model.energies.dissipation.is_some()
        || model.energies.coenergy.is_some();
    if changes(model) {
        return false;
    }
    if acts || model.gravity.is_some() && Trace::of(model).uniform_gravity().is_none() {
        return false;
    }
    let trace = Trace::of(model);
    let constraints = constraints_of(&trace);
    // letters of varying masses are known only after the kinetic energy has been formed
    let kinetic = trace.kinetic_energy();
    if !trace.solid().is_empty() {
        return false;
    }
    let held = constraints.iter();
    let knows_time = |scalar: &Sym| scalar.symbols_of().contains(&trace.time);
    // reactions do no work if every constraint is linear and homogeneous in the speeds
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let is_linear = |one: &Equation| {
        let moves = one.row.iter().any(|slope| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol)));
        one.level == Level::Position || !moves && one.zero.substitute(&at_rest) == Sym::ZERO
    };
    let do_no_work = held.clone().all(|one| one.gains.is_none() && !knows_time(&one.zero) && is_linear(one));
    // kinetic energy at zero speeds: a prescribed motion drives the system
    let driven = kinetic.substitute(&at_rest);
    let is_driven = driven != Sym::ZERO && !vanishes(driven);
    // a given kinetic energy may contain terms linear in the speeds: T + V is then not the conserved quantity
    let is_quadratic = model.energies.kinetic.is_none() || trace.has_quadratic_kinetic_energy();
    do_no_work && !is_driven && is_quadratic && ![kinetic, trace.potential_energy()].iter().any(knows_time)
}
