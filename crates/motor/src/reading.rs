//! The equations of a motor for display: torque and currents by Lagrange and Maxwell.

use crate::exact_turns::with_exact_turns;
use crate::{Machine, Motor, torque_and_current_rates};
use claims::derivation::{Equation, NotDerived};
use field::Analytic;
use symbolic::{Hypotheses, Sym, normal};

/// The equations of M and L di/dt for a motor, with its data as symbols.
///
/// # Errors
/// [`NotDerived::TooLarge`] where an expression is too large.
pub fn equations_of(motor: &Motor) -> Result<Vec<Equation>, NotDerived> {
    let motor = motor.letters();
    let currents: Vec<Sym> = (0..motor.windings()).map(|k| Sym::symbol(&motor.current_name(k))).collect();
    equations(&motor, &currents)
}

/// The equations of M and L di/dt for a symbolic machine, with the angle γ from the field.
///
/// # Errors
/// [`NotDerived::TooLarge`] where an expression is too large.
pub fn equations(machine: &impl Machine<Sym>, currents: &[Sym]) -> Result<Vec<Equation>, NotDerived> {
    let [angle, slip] = [("γ", r"\gamma"), ("γ̇", r"\dot\gamma")].map(|(name, latex)| Sym::named(name, latex));
    let mut rates = vec![Sym::ZERO; currents.len()];
    let torque = torque_and_current_rates(machine, angle.circle(), slip, currents, &mut rates);
    let mut equations = vec![Equation { left: Sym::symbol("M"), right: simplified(torque)? }];
    for (k, (current, rate)) in currents.iter().zip(rates).enumerate() {
        let inductance = machine.inductance(k);
        let name = Sym::named(&format!("d{current}/dt"), &format!(r"\frac{{d{}}}{{dt}}", current.latex()));
        equations.push(Equation { left: inductance * name, right: simplified(inductance * rate)? });
    }
    Ok(equations)
}

fn simplified(expression: Sym) -> Result<Sym, NotDerived> {
    let form = normal(with_exact_turns(expression), &Hypotheses::none());
    form.map(|form| form.to_sym()).map_err(|reason| NotDerived::TooLarge(reason.to_string()))
}
