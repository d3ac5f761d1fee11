//! Conditions at which forces are discontinuous in a speed, such as dry friction. The motion may keep such a condition at zero (sliding
//! mode).

use model::MatrixForm;
use symbolic::{Derivation, Hypotheses, Sym, differs_from_zero, normal, substitute_all};

/// An expression in both cases of a condition.
type Cases = [Sym; 2];

/// The index of the first condition that may stay at zero: it depends on a speed, and the equations are not proved equal in both cases
/// where it is zero.
pub(super) fn sticking(form: &MatrixForm) -> Option<usize> {
    let terms: Vec<Sym> = form.mass.iter().flatten().chain(&form.inertia).chain(&form.forces).copied().collect();
    let held = form.constraints.iter().flat_map(|held| held.row.iter().chain([&held.bias, &held.zero]).copied());
    let terms: Vec<Sym> = terms.into_iter().chain(held).collect();
    form.switches.iter().position(|(case, condition)| {
        if !condition.symbols_of().iter().any(|symbol| form.speeds.contains(symbol)) {
            return false;
        }
        let [on, off] = [Sym::ONE, Sym::ZERO].map(|value| substitute_all(&terms, &[(*case, value)]));
        let jumps: Vec<Cases> = on.into_iter().zip(off).map(Cases::from).filter(|cases| !are_equal(*cases)).collect();
        !jumps.is_empty() && !vanish_with(form, *condition, &jumps)
    })
}

/// Whether jumps vanish where a condition is zero, by a letter in which the condition is linear.
fn vanish_with(form: &MatrixForm, condition: Sym, jumps: &[Cases]) -> bool {
    let letters = [&form.speeds, &form.positions, &form.parameters, &form.inputs].into_iter().flatten().copied();
    letters.chain([form.time]).any(|letter| {
        let slope = Derivation::new([(letter, Sym::ONE)]).of(condition);
        if is_zero(slope) || slope.symbols_of().contains(&letter) {
            return false;
        }
        let root = -condition.substitute(&[(letter, Sym::ZERO)]) / slope;
        jumps.iter().all(|cases| are_equal(cases.map(|case| case.substitute(&[(letter, root)]))))
    })
}

/// True if the expression is proved to be identically zero.
fn is_zero(expression: Sym) -> bool {
    are_equal([expression, Sym::ZERO])
}

/// Whether two expressions are shown to be equal: by their normal form, which is long for nested functions and hence computed only where no
/// point tells them apart.
fn are_equal([a, b]: Cases) -> bool {
    a == b || (!differs_from_zero(a - b) && normal(a - b, &Hypotheses::none()).is_ok_and(|form| form.is_zero()))
}
