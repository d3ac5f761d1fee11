//! Values of letters at which expressions are evaluated, without order and the same on every machine.

/// The irrational step of a sequence that fills an interval evenly.
const STEP: f64 = 0.618_033_988_749_894_9;

/// A number between -100 and 100 for a letter at a point, small ones as often as large ones.
pub(crate) fn spread(name: &str, point: u32) -> f64 {
    let letter: u32 = name.bytes().fold(7, |sum, byte| (sum * 31 + u32::from(byte)) % 9973);
    let part = |times: u32| (f64::from(letter + times * point) * STEP).fract();
    let size = 10f64.powf(4.0 * part(1) - 2.0);
    if part(3) < 0.5 { -size } else { size }
}
