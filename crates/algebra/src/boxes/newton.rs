//! The preconditioned interval Newton method.

use super::Equations;
use field::Interval;
use nalgebra::DMatrix;

/// The linearisation of equations over a box X with the midpoint m: a matrix C near the inverse of f'(m), with
/// products.
pub(super) struct Local {
    pub middle: Vec<f64>,
    /// C f(m).
    pub step: Vec<Interval>,
    /// C f'(X), row by row.
    pub slopes: Vec<Interval>,
}

impl Local {
    /// The linearisation; `None` where f'(m) is singular or f' is unbounded.
    pub fn of(equations: &mut dyn Equations, at: &[Interval]) -> Option<Self> {
        let n = at.len();
        let mut slopes = vec![Interval::EVERYTHING; n * n];
        equations.slopes(at, &mut slopes);
        let mut values = vec![Interval::EVERYTHING; n];
        equations.values(&at.iter().map(|part| Interval::point(part.middle())).collect::<Vec<_>>(), &mut values);
        Local::new(at, &values, |row, column| slopes[row * n + column])
    }

    /// The linearisation from the values at the midpoint and the derivatives over the box.
    pub fn new(at: &[Interval], values: &[Interval], slope: impl Fn(usize, usize) -> Interval) -> Option<Self> {
        let n = at.len();
        if (0..n * n).any(|place| !slope(place / n, place % n).size().is_finite()) {
            return None;
        }
        let about = DMatrix::from_fn(n, n, |row, column| slope(row, column).middle());
        let inverse = about.try_inverse().filter(|inverse| inverse.iter().all(|entry| entry.is_finite()))?;
        let product = |row: usize, of: &dyn Fn(usize) -> Interval| {
            (0..n).fold(Interval::point(0.0), |sum, k| sum + Interval::point(inverse[(row, k)]) * of(k))
        };
        Some(Local {
            middle: at.iter().map(|part| part.middle()).collect(),
            step: (0..n).map(|row| product(row, &|k| values[k])).collect(),
            slopes: (0..n * n).map(|place| product(place / n, &|k| slope(k, place % n))).collect(),
        })
    }

    /// The part of a box that may contain zeros (Hansen and Sengupta); `None` where there is none.
    pub fn narrowed(&self, at: &[Interval]) -> Option<Vec<Interval>> {
        let n = at.len();
        let mut left = at.to_vec();
        for i in 0..n {
            let own = self.slopes[i * n + i];
            let rest = (0..n).filter(|&j| j != i).fold(self.step[i], |sum, j| {
                sum + self.slopes[i * n + j] * (left[j] - Interval::point(self.middle[j]))
            });
            if !own.contains(0.0) {
                left[i] = left[i].and(Interval::point(self.middle[i]) - rest / own)?;
            } else if !(rest + own * (left[i] - Interval::point(self.middle[i]))).contains(0.0) {
                return None;
            }
        }
        Some(left)
    }

    /// Krawczyk's operator K(X) on the box.
    pub fn krawczyk(&self, at: &[Interval]) -> Vec<Interval> {
        let n = at.len();
        let entry = |i: usize, j: usize| {
            let one = if i == j { Interval::point(1.0) } else { Interval::point(0.0) };
            one - self.slopes[i * n + j]
        };
        (0..n)
            .map(|i| {
                let about = Interval::point(self.middle[i]) - self.step[i];
                (0..n).fold(about, |sum, j| sum + entry(i, j) * (at[j] - Interval::point(self.middle[j])))
            })
            .collect()
    }
}
