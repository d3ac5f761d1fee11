//! Isolated motions at which the one equation of a system with one unknown is degenerate: by the order of its zero.
//!
//! Where f and its derivatives below the order m vanish at q0 exactly, and that of the order m has no zero in a region about q0,
//!
//!   f(q) = f^(m)(p) (q - q0)^m / m!   with p in the region ,
//!
//! and q0 is the only zero there. The force f is the negative slope of the energy, whose rise or fall on each side follows from its sign.

use super::Region;
use super::equations::SteadyEquations;
use super::search::Boxes;
use field::{Interval, Rational};
use model::equations::vanishes;
use symbolic::Sym;

/// Decimals with up to so many digits are tried.
const DIGITS: usize = 9;

/// The only zero in a region.
#[derive(Clone, Copy, Debug)]
pub(super) struct Degenerate {
    pub at: f64,
    order: usize,
    /// The sign of the derivative of that order.
    sign: i32,
}

impl Degenerate {
    /// The zero of a region; none where that is not shown.
    pub fn of(equations: &SteadyEquations, region: &Region) -> Option<Self> {
        let [[low, high]] = region.hull[..] else { return None };
        let others = equations.tapes.surplus.outputs() + equations.tapes.implied.outputs() + equations.reactions;
        if equations.rows != 1 || others > 0 || equations.is_at_condition {
            return None;
        }
        symbolic::apart(|| {
            let tape = equations.derivatives.as_ref()?;
            let mut bounds = vec![Interval::EVERYTHING; tape.outputs()];
            tape.over::<Interval>().evaluate(&[Interval::new(low, high)], &mut bounds);
            let order = (1..tape.outputs()).find(|&order| bounds[order].sign().is_some_and(|sign| sign != 0))?;
            let sign = bounds[order].sign()?;
            let at = candidates(low, high).into_iter().find(|&at| {
                let mut values = vec![Sym::ZERO; tape.outputs()];
                tape.over::<Sym>().evaluate(&[Sym::constant(Rational::decimal(at))], &mut values);
                values[..order].iter().all(|value| vanishes(*value))
            })?;
            Some(Degenerate { at, order, sign })
        })
    }

    /// In how many directions the energy falls, of the two sides or of those that conditions leave.
    pub fn falls(&self, equations: &SteadyEquations, boxes: &mut Boxes<'_>) -> Option<usize> {
        let at = [Interval::point(self.at)];
        let ways: Vec<i32> = match boxes.open_sides(&at)[..] {
            [] => vec![1, -1],
            [side, ..] => {
                let rises = boxes.side_slope(&at, side).first()?.sign().filter(|sign| *sign != 0)?;
                vec![if equations.holds[side] { rises } else { -rises }]
            }
        };
        // a force along the way that leads off
        let falls = |way: &&i32| self.sign * way.pow(1 + self.order as u32) > 0;
        Some(usize::from(ways.iter().any(|way| falls(&way))))
    }
}

/// Numbers of a range that somebody may have meant.
fn candidates(low: f64, high: f64) -> Vec<f64> {
    let middle = 0.5 * (low + high);
    let decimals = (0..DIGITS).filter_map(|digits| format!("{middle:.digits$e}").parse().ok());
    let mut all: Vec<f64> = [0.0].into_iter().chain(decimals).filter(|at| (low..=high).contains(at)).collect();
    all.dedup();
    all
}
