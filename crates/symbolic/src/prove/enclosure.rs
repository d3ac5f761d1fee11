//! Points at which an enclosure shows that an expression does not vanish: for exponentials and other functions, which have no exact values.

use crate::{Sym, Tape};
use field::Interval;

/// The number of points that are tried.
const POINTS: usize = 4;

/// Whether an expression is shown not to vanish everywhere: its enclosure at one of a few points, whose letters are between 1/2 and 3/2,
/// does not contain zero. `false` decides nothing.
///
/// ```
/// use dalembert_symbolic::{Sym, differs_from_zero};
/// use field::{Analytic, Elementary, Scalar};
///
/// let x = Sym::symbol("x");
/// let exp = |x: Sym| x.elementary(Elementary::Exp, x);
/// assert!(differs_from_zero(exp(x) - Sym::ONE));
/// assert!(!differs_from_zero(exp(x) * exp(-x) - Sym::ONE));
/// ```
pub fn differs_from_zero(expression: Sym) -> bool {
    let letters = expression.symbols_of();
    let Ok(tape) = Tape::record(&letters, &[expression]) else { return false };
    let mut program = tape.over::<Interval>();
    // multiples of the golden ratio are spread evenly
    let letter = |number: usize| Interval::point(0.5 + (number as f64 * 0.618_033_988_749_894_9).fract());
    (0..POINTS).any(|point| {
        let inputs: Vec<Interval> = (1..=letters.len()).map(|place| letter(place + point * letters.len())).collect();
        let mut value = [Interval::point(0.0)];
        program.evaluate(&inputs, &mut value);
        value[0].low() > 0.0 || value[0].high() < 0.0
    })
}
