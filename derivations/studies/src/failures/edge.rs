//! Where something ceases to hold, by halving.

/// Halvings after which an edge between floats is found as well as it can be.
const MOST: usize = 60;

/// The edge between a value at which `test` holds and one at which it does not, to a share of itself; `None` where it is
/// not so at these two.
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
