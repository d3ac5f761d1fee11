//! Expressions that have no value anywhere at the given data, such as the root of a negative parameter: every statement on them would be empty.

use symbolic::Sym;

/// Points that are tried beside the start.
const POINTS: u32 = 24;

/// The irrational step of a sequence that fills an interval evenly.
const STEP: f64 = 0.618_033_988_749_894_9;

/// Whether an expression has a value at a state of some letters, or at one of many points of all sizes.
pub(super) fn has_value(expression: Sym, state: &[(String, f64)]) -> bool {
    let at_state = |name: &str| state.iter().find(|(known, _)| known == name).map_or(ANYWHERE, |(_, value)| *value);
    let is_finite = |at: &dyn Fn(&str) -> f64| {
        expression.evaluate_analytic(&|name: &str| Some(at(name))).is_ok_and(|value: f64| value.is_finite())
    };
    is_finite(&at_state) || (1..=POINTS).any(|point| is_finite(&|name| spread(name, point)))
}

/// A value for letters that are no part of a state.
const ANYWHERE: f64 = 0.377;

/// A number between -100 and 100 for a letter, small ones as often as large ones.
pub(crate) fn spread(name: &str, point: u32) -> f64 {
    let letter: u32 = name.bytes().fold(7, |sum, byte| (sum * 31 + u32::from(byte)) % 9973);
    let part = |times: u32| (f64::from(letter + times * point) * STEP).fract();
    let size = 10f64.powf(4.0 * part(1) - 2.0);
    if part(3) < 0.5 { -size } else { size }
}

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
