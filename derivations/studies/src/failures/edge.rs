//! Bisection for the threshold of a condition.

/// The largest number of bisections; a threshold is then known to the last bit.
const MOST: usize = 60;

/// The threshold between a value for which `test` is true and one for which it is false, to the relative accuracy
/// `share`; `None` where `test` is false at the first or true at the second.
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
