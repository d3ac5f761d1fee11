//! Expressions that are zero for all values of their letters.

use field::{DoubleDouble, Over};
use symbolic::{Hypotheses, Identity, Sym, decide, identified};

/// The number of parts beyond which expressions are not brought into normal form: they are taken as they are written.
const MOST_EXPANDED: usize = 2_000;

/// Points at which an expression is evaluated before it is brought into normal form.
const POINTS: usize = 4;

/// The size beyond which a value in double-double is not the rounding of zero: terms of a sum would have to be beyond
/// 1e20.
const ROUNDING: f64 = 1e-10;

/// Whether a component is zero for all values: by random points of prime fields, or where it has functions by its normal form. One that is
/// not zero at some point has no normal form written down, which may be very long.
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

/// Whether a component has a value other than zero at a point.
fn differs_from_zero(component: Sym, point: usize) -> bool {
    let value = |name: &str| Some(DoubleDouble::lift(letter(name, point)));
    component.evaluate_analytic(&value).is_ok_and(|value| {
        let value = value.hi();
        value.is_finite() && value.abs() > ROUNDING
    })
}

/// A value between 1/2 and 3/2 that a name has at a point, the same on every machine.
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
