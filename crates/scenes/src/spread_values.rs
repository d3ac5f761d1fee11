//! Deterministic sample values of letters for the evaluation of expressions, equal on every machine.

/// The fractional part of the golden ratio: its multiples modulo 1 are evenly distributed in [0, 1).
const STEP: f64 = 0.618_033_988_749_894_9;

/// The value of the letter `name` at a sample point: either sign, absolute value from 0.01 to 100 with an even distribution of its logarithm.
pub(crate) fn spread(name: &str, point: u32) -> f64 {
    let letter: u32 = name.bytes().fold(7, |sum, byte| (sum * 31 + u32::from(byte)) % 9973);
    let part = |times: u32| (f64::from(letter + times * point) * STEP).fract();
    let size = 10f64.powf(4.0 * part(1) - 2.0);
    if part(3) < 0.5 { -size } else { size }
}
