//! Bisection for the threshold at which a test ceases to hold.

/// Bisections after which a threshold is found to the last bit.
const MOST: usize = 60;

/// The threshold between a value at which `test` holds and one at which it fails, to a relative accuracy; `None` where the test does
/// not hold at the first or holds at the second.
pub fn edge(holds: f64, fails: f64, share: f64, test: impl Fn(f64) -> bool) -> Option<f64> {
    if !test(holds) || test(fails) {
        return None;
    }
    let (mut holds, mut fails) = (holds, fails);
    for _ in 0..MOST {
        let middle = 0.5 * (holds + fails);
        if (fails - holds).abs() <= share * middle.abs() {
            break;
        }
        if test(middle) { holds = middle } else { fails = middle }
    }
    Some(0.5 * (holds + fails))
}
