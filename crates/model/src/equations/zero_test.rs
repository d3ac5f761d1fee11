//! Test whether an expression is identically zero.

use field::{DoubleDouble, Over};
use symbolic::{Hypotheses, Identity, Sym, decide, identified};

/// Longer expressions, in operations, are not brought to normal form and count as nonzero.
const MOST_EXPANDED: usize = 2_000;

/// The number of points at which an expression is evaluated before its normal form is computed.
const POINTS: usize = 4;

/// A larger value in double-double arithmetic cannot be a rounding error of zero, unless terms of a sum exceed
/// 1e20.
const ROUNDING: f64 = 1e-10;

/// Returns whether an expression is identically zero: by random points of prime fields, or for expressions with functions by the normal form. The normal form is
/// not computed if the expression is nonzero at a numerical point, since it may be very long.
pub fn vanishes(component: Sym) -> bool {
    match identified(&[component]) {
        Identity::Identified { .. } => true,
        Identity::NotZero => false,
        Identity::Untested(_) if Sym::operations_of(&[component]) > MOST_EXPANDED => false,
        Identity::Untested(_) => {
            !(0..POINTS).any(|point| differs_from_zero(component, point))
                && decide(component, &Hypotheses::none()).is_zero()
        }
    }
}

/// Returns whether an expression differs from zero at a numerical point.
fn differs_from_zero(component: Sym, point: usize) -> bool {
    let value = |name: &str| Some(DoubleDouble::lift(letter(name, point)));
    component.evaluate_analytic(&value).is_ok_and(|value| {
        let value = value.hi();
        value.is_finite() && value.abs() > ROUNDING
    })
}

/// Returns a value between 1/2 and 3/2 that depends only on the name and the point.
fn letter(name: &str, point: usize) -> f64 {
    // Fowler, Noll and Vo's hash
    let mixed = name
        .bytes()
        .chain([point as u8])
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    0.5 + (mixed >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::vanishes;
    use field::Analytic;
    use symbolic::{Sym, symbols};

    #[test]
    fn a_sum_with_roots_vanishes_where_it_is_zero_for_all_values() {
        let [x, y] = symbols(["x", "y"]);
        let speed = (x * x + y * y).sqrt();
        assert!(vanishes(x / speed * (x / speed) + y / speed * (y / speed) - Sym::ONE));
        assert!(!vanishes(x / speed * (x / speed) + y / speed * (y / speed)));
    }

    /// An expression whose normal form has millions of terms.
    #[test]
    fn a_long_sum_that_is_not_zero_is_told_at_once() {
        let letters: Vec<Sym> = (0..12).map(|place| Sym::symbol(&format!("x{place}"))).collect();
        let all = letters.iter().fold(Sym::ZERO, |sum, &letter| sum + letter);
        let product =
            letters.iter().fold(Sym::ONE, |product, &letter| product * (all + letter).sqrt() * (all - letter));
        assert!(!vanishes(product - all));
    }
}
