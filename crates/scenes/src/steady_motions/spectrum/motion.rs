//! Enclosure of a steady motion to thirty digits, with the linear equations there.

use super::reduction::{solved, whole};
use crate::linearisation::{AllSlopes, VariedEquations};
use crate::steady_motions::equations::SteadyEquations;
use algebra::real::{Ball, Ordered};
use field::{Interval, Rational};
use nalgebra::DMatrix;
use num_traits::Zero;

/// Largest number of iterations of Krawczyk's operator.
const STEPS: usize = 6;

/// The derivatives of the equations at a motion with enclosed unknowns and reactions, and its speeds; other values are the exact decimals of
/// `state`. `None` if accelerations and reactions are not determined.
pub(super) fn slopes_at(
    equations: &SteadyEquations,
    varied: &VariedEquations,
    enclosure: &[Interval],
    state: &[f64],
) -> Option<(AllSlopes<Ball>, Vec<Ball>)> {
    let [n, m, ..] = varied.counts();
    let unknowns = refined(equations, enclosure);
    let positions = equations.unknowns.len();
    let one = Ball::constant(1.0);
    let number = |value: &f64| one.fraction(Rational::decimal(*value));
    let mut point: Vec<Ball> = state.iter().map(number).collect::<Option<_>>()?;
    equations.unknowns.iter().zip(&unknowns).for_each(|(unknown, value)| point[unknown.place] = *value);
    let (places, rates) = &equations.determined;
    let mut speeds = vec![Ball::zero(); places.len()];
    rates.over::<Ball>().evaluate(&unknowns[..positions], &mut speeds);
    places.iter().zip(speeds).for_each(|(&place, speed)| point[place] = speed);
    let first = point.len();
    point.resize(first + n + m, Ball::zero());
    point.extend(equations.switches.iter().map(|value| Ball::constant(*value)));
    let open = varied.over(&point, Ball::zero());
    let right = open.motion.values.iter().chain(&open.acceleration.values).map(|value| vec![-*value]).collect();
    let found = solved(whole(&open, &Ball::zero()), right)?;
    // accelerations, then multipliers
    point[first..first + n + m].iter_mut().zip(found).for_each(|(own, found)| *own = found[0]);
    let speeds = point[first - n..first].to_vec();
    Some((varied.over(&point, Ball::zero()), speeds))
}

/// A narrow enclosure of the zero in `enclosure`, by Krawczyk's operator K with thirty digits; K(X) contains every zero in X.
fn refined(equations: &SteadyEquations, enclosure: &[Interval]) -> Vec<Ball> {
    let size = enclosure.len();
    let mut at: Vec<Ball> = enclosure.iter().map(|part| Ball::over_range(part.low(), part.high())).collect();
    let (mut values, mut slopes) = (equations.tapes.values.over::<Ball>(), equations.tapes.slopes.over::<Ball>());
    let (mut value, mut slope) = (vec![Ball::zero(); size], vec![Ball::zero(); size * size]);
    for _ in 0..STEPS {
        let middle: Vec<Ball> = at.iter().map(|part| part.polynomial()).collect();
        values.evaluate(&middle, &mut value);
        slopes.evaluate(&at, &mut slope);
        let Some(inverse) = DMatrix::from_fn(size, size, |i, j| slope[i * size + j].at(0.0)).try_inverse() else {
            break;
        };
        let inverse = |i: usize, j: usize| Ball::constant(inverse[(i, j)]);
        let step = |i: usize| {
            let by = (0..size).fold(Ball::zero(), |sum, k| sum + inverse(i, k) * value[k]);
            (0..size).fold(middle[i].minus(&by), |sum, j| {
                let one = by_identity(i, j);
                let defect = (0..size).fold(one, |rest, k| rest - inverse(i, k) * slope[k * size + j]);
                sum + defect * (at[j] - middle[j])
            })
        };
        let next: Vec<Ball> = (0..size).map(step).collect();
        let gains = next.iter().zip(&at).any(|(next, at)| next.left() < 0.5 * at.left());
        let is_bounded = next.iter().zip(&at).all(|(next, at)| next.left() <= at.left());
        if !(gains && is_bounded) {
            break;
        }
        at = next;
    }
    at
}

fn by_identity(i: usize, j: usize) -> Ball {
    if i == j { Ball::constant(1.0) } else { Ball::zero() }
}
