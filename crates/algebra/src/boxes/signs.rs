//! Splitting of a box by the sign of a determined unknown. A product whose interval excludes zero bounds one factor
//! from below once the sign of the other is fixed, but bounds neither while both signs are possible.

use super::Equations;
use super::search::WORTH;
use field::Interval;

/// The result of splitting a box by the signs of its determined unknowns.
pub(super) enum Signs {
    /// The box contains no zeros.
    None,
    /// The box was narrowed to the hull of both parts; separate boxes do not pay.
    One,
    /// Separate boxes for both signs, which bound an unknown or are much smaller.
    Both([Vec<Interval>; 2]),
}

/// The number of boxes that are split in any case.
const FIRST: usize = 64;

/// Afterwards all boxes are split as long as at least one of this many splits reduced the work.
const GAINS: usize = 8;

/// Otherwise one of this many boxes is split.
const SELDOM: usize = 32;

/// The statistics of splits in a search.
#[derive(Default)]
pub(super) struct Worth {
    asked: usize,
    seen: usize,
    gained: usize,
}

impl Worth {
    /// Narrows a box by both signs of each unbounded determined unknown, while splits pay.
    pub fn by_signs(&mut self, equations: &mut dyn Equations, at: &mut [Interval]) -> Signs {
        self.asked += 1;
        if self.seen >= FIRST && self.gained * GAINS < self.seen && !self.asked.is_multiple_of(SELDOM) {
            return Signs::One;
        }
        let open: Vec<Interval> = at.to_vec();
        let found = by_signs(equations, at);
        self.seen += 1;
        self.gained += usize::from(!matches!(found, Signs::One) || open != at);
        found
    }
}

fn by_signs(equations: &mut dyn Equations, at: &mut [Interval]) -> Signs {
    let n = equations.divided();
    let signs = [Interval::new(f64::NEG_INFINITY, 0.0), Interval::new(0.0, f64::INFINITY)];
    for k in n..at.len() {
        if at[k].low() >= 0.0 || at[k].high() <= 0.0 || at[k].size().is_finite() {
            continue;
        }
        let cases = signs.map(|sign| {
            let mut case = at.to_vec();
            case[k] = at[k].and(sign)?;
            // the second pass uses the bounds of the first for the other factor
            (equations.narrow(&mut case) && equations.narrow(&mut case)).then_some(case)
        });
        match cases {
            [None, None] => return Signs::None,
            [Some(one), None] | [None, Some(one)] => at.copy_from_slice(&one),
            [Some(one), Some(other)] => {
                let is_narrower = |case: &[Interval]| {
                    case[k].size().is_finite()
                        || case[..n].iter().zip(&*at).any(|(left, before)| left.width() < WORTH * before.width())
                };
                if is_narrower(&one) && is_narrower(&other) {
                    return Signs::Both([one, other]);
                }
                at.iter_mut().zip(one.iter().zip(&other)).for_each(|(at, (one, other))| *at = one.hull(*other));
            }
        }
    }
    Signs::One
}
