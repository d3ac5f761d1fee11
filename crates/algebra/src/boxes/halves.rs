//! Bisection of a box.

use field::Interval;

/// A side shorter than this fraction of the longest one is not bisected before it.
const SHORT: f64 = 1.0 / 64.0;

/// The halves of a box across the side `blamed` for slow progress, or else across its longest side, relative to the
/// domain. `None` where all sides are at most `smallest`.
pub fn halves(
    at: &[Interval],
    domain: &[Interval],
    blamed: Option<usize>,
    smallest: f64,
) -> Option<[Vec<Interval>; 2]> {
    let part = |k: usize| match domain[k].width() {
        0.0 => 0.0,
        whole => at[k].width() / whole,
    };
    let longest = (0..at.len()).max_by(|&a, &b| part(a).total_cmp(&part(b)))?;
    // bisecting a side that is already short does not help
    let side = blamed.filter(|&k| part(k) > smallest && part(k) > SHORT * part(longest)).unwrap_or(longest);
    let (whole, middle) = (at[side], at[side].middle());
    if part(longest) < smallest || !(whole.low() < middle && middle < whole.high()) {
        return None;
    }
    let with = |half: Interval| {
        let mut all = at.to_vec();
        all[side] = half;
        all
    };
    Some([with(Interval::new(whole.low(), middle)), with(Interval::new(middle, whole.high()))])
}
