//! Test for expressions that are undefined everywhere for the given data, such as the root of a negative parameter.

use crate::spread_values::spread;
use symbolic::Sym;

/// Number of points that are tried besides the start.
const POINTS: u32 = 24;

/// Whether an expression has a value at a state (names and values of letters), or at one of many points of different magnitudes.
pub(super) fn has_value(expression: Sym, state: &[(String, f64)]) -> bool {
    let at_state = |name: &str| state.iter().find(|(known, _)| known == name).map_or(ANYWHERE, |(_, value)| *value);
    let is_finite = |at: &dyn Fn(&str) -> f64| {
        expression.evaluate_analytic(&|name: &str| Some(at(name))).is_ok_and(|value: f64| value.is_finite())
    };
    is_finite(&at_state) || (1..=POINTS).any(|point| is_finite(&|name| spread(name, point)))
}

/// The value of letters that are not in the state.
const ANYWHERE: f64 = 0.377;

#[cfg(test)]
mod tests {
    use super::has_value;
    use field::{Analytic, Scalar};
    use symbolic::Sym;

    #[test]
    fn a_root_of_a_negative_number_has_no_value_and_one_of_a_letter_has() {
        let x = Sym::symbol("x");
        assert!(!has_value(x + (-Sym::ONE).sqrt() * x, &[]));
        assert!(!has_value(x / (Sym::ONE - Sym::ONE), &[]));
        assert!(has_value((x - Sym::int(5)).sqrt(), &[]) && has_value((-x).sqrt(), &[("x".to_owned(), 1.0)]));
    }
}
