//! Conditions at which forces are discontinuous in a speed, such as dry friction. The motion may keep such a condition at zero (sliding
//! mode).

use model::MatrixForm;
use symbolic::{Derivation, Hypotheses, Sym, normal, substitute_all};

/// The index of the first condition that may stay at zero: it depends on a speed, and the equations are not proved equal in both cases
/// where it is zero.
pub(super) fn sticking(form: &MatrixForm) -> Option<usize> {
    let terms: Vec<Sym> = form.mass.iter().flatten().chain(&form.inertia).chain(&form.forces).copied().collect();
    let held = form.constraints.iter().flat_map(|held| held.row.iter().chain([&held.bias, &held.zero]).copied());
    let terms: Vec<Sym> = terms.into_iter().chain(held).collect();
    form.switches.iter().position(|(case, condition)| {
        let holds_speeds = condition.symbols_of().iter().any(|symbol| form.speeds.contains(symbol));
        let [on, off] = [Sym::ONE, Sym::ZERO].map(|value| substitute_all(&terms, &[(*case, value)]));
        let jumps: Vec<Sym> =
            on.into_iter().zip(off).map(|(on, off)| on - off).filter(|jump| !is_zero(*jump)).collect();
        holds_speeds && !jumps.is_empty() && !vanish_with(form, *condition, &jumps)
    })
}

/// True if the jumps are proved to vanish where the condition is zero. The condition is solved for a symbol in which it is linear.
fn vanish_with(form: &MatrixForm, condition: Sym, jumps: &[Sym]) -> bool {
    let letters = [&form.speeds, &form.positions, &form.parameters, &form.inputs].into_iter().flatten().copied();
    letters.chain([form.time]).any(|letter| {
        let slope = Derivation::new([(letter, Sym::ONE)]).of(condition);
        if is_zero(slope) || slope.symbols_of().contains(&letter) {
            return false;
        }
        let root = -condition.substitute(&[(letter, Sym::ZERO)]) / slope;
        substitute_all(jumps, &[(letter, root)]).into_iter().all(is_zero)
    })
}

/// True if the expression is proved to be identically zero.
fn is_zero(expression: Sym) -> bool {
    expression == Sym::ZERO || normal(expression, &Hypotheses::none()).is_ok_and(|form| form.is_zero())
}
