//! Fixed points of maps with a parameter, enclosed for all values of the parameter in a range at once (Krawczyk).
//!
//! Let c be an approximation of the fixed points of R and Y one of (1 - DR)^-1, both polynomials in the parameter. On
//! the boxes X = c + [-r, r] Krawczyk's operator is
//!
//!   K(X) = c + Y (R(c) - c) + (1 - Y (1 - DR(X))) [-r, r] .
//!
//! If K(X) lies in the interior of X for every value of the parameter, R has exactly one fixed point in X for each, and
//! it lies in K(X). R(c), DR(X) and K are Taylor models in the parameter.

use super::{Model, Ordered, Rounded};

/// A fixed point as a function of the parameter.
#[derive(Clone, Debug)]
pub struct FixedPoint<M> {
    /// The enclosures of its components, as Taylor models.
    pub place: Vec<M>,
    /// The derivative of the map at the fixed point, row by row.
    pub slopes: Vec<Vec<M>>,
}

/// The values of a map, and its derivative row by row.
pub type Mapped<S> = (Vec<S>, Vec<Vec<S>>);

/// The number of box sizes tried: increasing until one is proved, then decreasing.
const TRIALS: usize = 2;
/// The centre is corrected as long as the correction shrinks by this factor.
const NEARER: f64 = 0.1;

impl<C: Rounded, const N: usize> FixedPoint<Model<C, N>> {
    /// The fixed point near `centre`, where `inverse` approximates (1 - DR)^-1 row by row, in boxes of at least the
    /// radius `least`, which contain no other fixed point. `value` gives R, `derivative` both R and DR. `None` where
    /// the proof fails.
    pub fn near(
        centre: &[Model<C, N>],
        inverse: &[Vec<Model<C, N>>],
        least: f64,
        value: impl Fn(&[Model<C, N>]) -> Option<Vec<Model<C, N>>>,
        derivative: impl Fn(&[Model<C, N>]) -> Option<Mapped<Model<C, N>>>,
    ) -> Option<Self> {
        let number = Model::<C, N>::constant;
        let zero = number(0.0);
        let correction = |at: &[Model<C, N>]| -> Option<Vec<Model<C, N>>> {
            let missing: Vec<_> = value(at)?.iter().zip(at).map(|(end, c)| end.minus(c)).collect();
            Some(inverse.iter().map(|row| dot(row, &missing, zero)).collect())
        };
        let sizes = |all: &[Model<C, N>]| all.iter().map(Model::size).collect::<Vec<f64>>();
        let largest = |all: &[Model<C, N>]| sizes(all).into_iter().fold(0.0, f64::max);
        let (mut centre, mut newton) = (centre.to_vec(), correction(centre)?);
        // the given centre may have fewer digits than these numbers
        loop {
            let next: Vec<_> = centre.iter().zip(&newton).map(|(c, by)| c.plus(by).polynomial()).collect();
            let Some(left) = correction(&next).filter(|left| largest(left) < NEARER * largest(&newton)) else { break };
            (centre, newton) = (next, left);
        }
        let newton_size = sizes(&newton);
        let mut radius: Vec<f64> = newton_size.iter().map(|size| 2.0 * size + least.max(f64::MIN_POSITIVE)).collect();
        let mut found = None;
        for _ in 0..TRIALS {
            let boxes: Vec<_> = centre.iter().zip(&radius).map(|(c, r)| c.wider(*r)).collect();
            let (_, slopes) = derivative(&boxes)?;
            let shares = inverse.iter().enumerate().map(|(i, row)| {
                // row i of |1 - Y (1 - DR)| times r
                let share = |j: usize| {
                    let unit = |k: usize| number(if k == j { 1.0 } else { 0.0 });
                    let left: Vec<_> = (0..row.len()).map(|k| unit(k).minus(&slopes[k][j])).collect();
                    unit(i).minus(&dot(row, &left, zero)).size() * radius[j]
                };
                (0..row.len()).map(share).sum::<f64>().next_up() * (1.0 + 1e-12)
            });
            let shares: Vec<f64> = shares.collect();
            let reach: Vec<f64> = newton_size.iter().zip(&shares).map(|(n, share)| (n + share).next_up()).collect();
            // not by negation: a comparison with NaN is false
            if found.is_some() || reach.iter().zip(&radius).all(|(reach, radius)| reach < radius) {
                let step = |k: usize| centre[k].plus(&newton[k]).wider(shares[k]);
                found = Some(FixedPoint { place: (0..centre.len()).map(step).collect(), slopes });
                if shares.iter().zip(&newton_size).all(|(share, size)| share <= size) {
                    break;
                }
                // the fixed point lies in K(X), hence in K of any box around that
                radius = reach;
            } else {
                radius = reach.iter().map(|reach| 2.0 * reach).collect();
            }
        }
        found
    }
}

fn dot<R: Ordered>(a: &[R], b: &[R], zero: R) -> R {
    a.iter().zip(b).fold(zero, |sum, (x, y)| sum.plus(&x.times(y)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::TaylorModel;

    /// R(x, y) = (x - (x^2 - h)/4, (x + y)/2 - h/5), with the fixed point x = sqrt(h), y = x - 2 h/5.
    fn enclosed(low: f64, high: f64, slope: f64) -> Option<FixedPoint<TaylorModel>> {
        let h = TaylorModel::over_range(low, high);
        let number = TaylorModel::constant;
        let value = |at: &[TaylorModel]| {
            let x = at[0].minus(&at[0].times(&at[0]).minus(&h).times(&number(0.25)));
            let y = at[0].plus(&at[1]).times(&number(0.5)).minus(&h.times(&number(0.2)));
            Some(vec![x, y])
        };
        let derivative = |at: &[TaylorModel]| {
            let own = number(1.0).minus(&at[0].times(&number(slope)));
            Some((value(at)?, vec![vec![own, number(0.0)], vec![number(0.5), number(0.5)]]))
        };
        let at_nodes = |f: &dyn Fn(f64) -> f64| TaylorModel::through(TaylorModel::nodes().map(|tau| f(h.at(tau))));
        let root = |h: f64| h.abs().sqrt();
        // off by an error that Newton's step must correct
        let centre = [at_nodes(&|h| root(h) + 1e-5), at_nodes(&|h| root(h) - 0.4 * h)];
        // (1 - DR)^-1 with DR = [[1 - x/2, 0], [1/2, 1/2]]
        let inverse =
            [vec![at_nodes(&|h| 2.0 / root(h)), number(0.0)], vec![at_nodes(&|h| 2.0 / root(h)), number(2.0)]];
        FixedPoint::near(&centre, &inverse, 0.0, value, derivative)
    }

    #[test]
    fn a_fixed_point_is_held_for_every_value_of_the_parameter() {
        let found = enclosed(1.0, 1.5, 0.5).expect("it is simple");
        for k in -10..=10 {
            let tau = f64::from(k) / 10.0;
            let h = 1.25 + 0.25 * tau;
            for (place, exact) in found.place.iter().zip([h.sqrt(), h.sqrt() - 0.4 * h]) {
                let (off, most) = ((place.at(tau) - exact).abs(), place.left());
                assert!(off <= most && most < 1e-5, "{off:e} against {most:e}");
            }
            assert!((found.slopes[0][0].at(tau) - (1.0 - 0.5 * h.sqrt())).abs() < 1e-3);
        }
    }

    /// At h = 0 two fixed points meet; with a wrong derivative the proof fails.
    #[test]
    fn where_it_is_not_simple_or_the_derivative_is_wrong_nothing_is_said() {
        assert!(enclosed(-0.1, 0.1, 0.5).is_none());
        assert!(enclosed(1.0, 1.5, -0.5).is_none());
    }
}
