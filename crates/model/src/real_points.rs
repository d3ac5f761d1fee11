//! Numerical tests at real points: decides whether two expressions have equal values up to the precision of double-double numbers. They are used where roots or
//! functions prevent an exact decision.

use crate::Trace;
use field::DoubleDouble;
use symbolic::Sym;

/// The number of points, and how many of them must have a value.
const POINTS: u64 = 24;
const NEEDED: usize = 12;

/// The number of digits of a double-double number that remain after rounding in sums of some thousand terms.
const DIGITS: f64 = 22.0;

/// Returns the number of points and the digits to which all pairs agree; `None` if too few points have values, or if a pair differs.
pub(crate) fn equal_digits(pairs: &[(Sym, Sym)]) -> Option<(usize, f64)> {
    let (mut points, mut digits) = (0, f64::INFINITY);
    for point in 0..POINTS {
        let here: Vec<f64> = pairs.iter().map(|&(one, other)| agreed(one, other, point)).collect();
        if here.iter().any(|digits| digits.is_nan()) {
            continue;
        }
        let least = here.into_iter().fold(f64::INFINITY, f64::min);
        points += 1;
        digits = digits.min(least);
    }
    (points >= NEEDED && digits >= DIGITS).then_some((points, digits))
}

/// Returns the value of an expression at the start of a model; `None` if the expression contains other symbols than coordinates, speeds, the time, and parameters with
/// values, or if the start does not give all coordinates.
pub(crate) fn value_at_start(trace: &Trace<'_>, expression: Sym) -> Option<f64> {
    let model = trace.model;
    let is_given = |place: usize| {
        model.start.iter().any(|start| (start.coordinate, start.order, start.is_guess) == (place, 0, false))
    };
    if !(0..model.positions()).all(is_given) {
        return None;
    }
    let state = model.start_state();
    let names: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).collect();
    let value = |name: &str| {
        let of_state = names.iter().position(|own| own == name).map(|place| state[place]);
        let parameter = || model.parameters.iter().find(|own| own.name == name)?.value;
        let pi = || (Sym::symbol(name) == trace.pi).then_some(std::f64::consts::PI);
        let time = || (Sym::symbol(name) == trace.time).then_some(0.0);
        of_state.or_else(parameter).or_else(time).or_else(pi).map(DoubleDouble::from)
    };
    expression.evaluate_analytic(&value).ok().map(|value: DoubleDouble| value.hi()).filter(|value| value.is_finite())
}

/// Returns the value of an expression at a real point; `None` if it is undefined.
pub(crate) fn value_at_point(expression: Sym, point: u64) -> Option<f64> {
    let found = expression.evaluate_analytic(&|name: &str| Some(drawn(name, point))).ok();
    found.map(|value: DoubleDouble| value.hi()).filter(|value| value.is_finite())
}

/// Returns the number of digits to which two expressions agree at a point; NaN if one is undefined.
fn agreed(one: Sym, other: Sym, point: u64) -> f64 {
    let value = |expression: Sym| value_at_point(expression, point).unwrap_or(f64::NAN);
    let (size, difference) = (value(one).abs().max(value(other).abs()), value(one - other).abs());
    if !(size.is_finite() && difference.is_finite()) {
        return f64::NAN;
    }
    if difference == 0.0 { 31.0 } else { (size / difference).log10() }
}

/// Returns a reproducible pseudorandom number between 1/5 and 6/5, determined by the name and the point.
pub(crate) fn drawn(name: &str, point: u64) -> DoubleDouble {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ point.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in name.bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    hash ^= hash >> 29;
    let fraction = (hash.wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 11) as f64 / (1_u64 << 53) as f64;
    DoubleDouble::from(0.2) + DoubleDouble::from(fraction)
}
