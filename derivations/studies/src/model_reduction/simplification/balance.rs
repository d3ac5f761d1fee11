//! Quasi-steady values of fast states, from zero rates, which are linear in these states.

use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, substitute_all};

/// The largest number of operations in rates that are solved: the solution is substituted into every rate.
const MOST: usize = 4_000;

/// Expressions for unknowns w with r(w) = 0; `None` where the rates r are nonlinear in w, or do not determine it.
pub(super) fn balanced(rates: &[Sym], unknowns: &[Sym]) -> Option<Vec<Sym>> {
    if Sym::operations_of(rates) > MOST {
        return None;
    }
    let matrix: Vec<Vec<Sym>> =
        rates.iter().map(|rate| unknowns.iter().map(|unknown| rate.diff(*unknown)).collect()).collect();
    let is_linear = |entry: &Sym| !entry.symbols_of().iter().any(|symbol| unknowns.contains(symbol));
    if !matrix.iter().flatten().all(is_linear) {
        return None;
    }
    let zeros: Vec<(Sym, Sym)> = unknowns.iter().map(|unknown| (*unknown, Sym::ZERO)).collect();
    let right: Vec<Sym> = substitute_all(rates, &zeros).into_iter().map(|rest| -rest).collect();
    Some(solve(&matrix, &right, &Hypotheses::none()).ok()?.values())
}

#[cfg(test)]
mod tests {
    use super::balanced;
    use symbolic::{Hypotheses, Sym, decide, symbols};

    #[test]
    fn two_coupled_circuits_balance_and_a_saturated_one_is_refused() {
        let [i, j, u, r] = symbols(["i", "j", "u", "r"]);
        let values = balanced(&[u - r * i - j, i - r * j], &[i, j]).expect("linear");
        let zero = |left: Sym, right: Sym| decide(left - right, &Hypotheses::none()).is_zero();
        assert!(zero(values[1] * (r * r + Sym::ONE), u));
        assert!(balanced(&[u - r * i * i], &[i]).is_none());
        assert!(balanced(&[u - i, u - i], &[i, j]).is_none());
    }
}
