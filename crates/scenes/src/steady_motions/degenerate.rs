//! Isolated motions of systems with one unknown at which the force f has a zero of higher order.
//!
//! If f and its derivatives below the order m vanish exactly at q0, and the derivative of order m has no zero in a region about q0, then
//!
//!   f(q) = f^(m)(p) (q - q0)^m / m!   with p in the region ,
//!
//! and q0 is the only zero in the region. The sign of f^(m) decides whether the energy rises or falls on each side, since f is minus its slope.

use super::Region;
use super::equations::SteadyEquations;
use super::search::Boxes;
use field::{Interval, Rational};
use model::equations::vanishes;
use symbolic::Sym;

/// Largest number of digits of the decimals that are tried as q0.
const DIGITS: usize = 9;

/// The only zero in a region: its position, and the order and sign of the first derivative that does not vanish.
#[derive(Clone, Copy, Debug)]
pub(super) struct Degenerate {
    pub at: f64,
    order: usize,
    /// The sign of the derivative of this order.
    sign: i32,
}

impl Degenerate {
    /// The zero in a region; `None` if it is not proved.
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

    /// The number of directions, 0 or 1, in which the energy falls; if a condition is zero at the motion, only its open side counts. `None` if undecided.
    pub fn falls(&self, equations: &SteadyEquations, boxes: &mut Boxes<'_>) -> Option<usize> {
        let at = [Interval::point(self.at)];
        let ways: Vec<i32> = match boxes.open_sides(&at)[..] {
            [] => vec![1, -1],
            [side, ..] => {
                let rises = boxes.side_slope(&at, side).first()?.sign().filter(|sign| *sign != 0)?;
                vec![if equations.holds[side] { rises } else { -rises }]
            }
        };
        // the force points away from the motion
        let falls = |way: &&i32| self.sign * way.pow(1 + self.order as u32) > 0;
        Some(usize::from(ways.iter().any(|way| falls(&way))))
    }
}

/// Decimals of few digits in an interval, as candidates for the exact zero.
fn candidates(low: f64, high: f64) -> Vec<f64> {
    let middle = 0.5 * (low + high);
    let decimals = (0..DIGITS).filter_map(|digits| format!("{middle:.digits$e}").parse().ok());
    let mut all: Vec<f64> = [0.0].into_iter().chain(decimals).filter(|at| (low..=high).contains(at)).collect();
    all.dedup();
    all
}
