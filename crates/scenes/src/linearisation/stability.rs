//! Eigenvalues of a linearisation, and stability in the first approximation.

use nalgebra::{Complex, DMatrix};
use std::fmt;

/// Matrix entries below this part of the largest are rounding errors.
const ROUNDING: f64 = 1e-14;

/// Real parts below this part of the largest absolute eigenvalue count as zero.
const ZERO: f64 = 1e-9;

/// The eigenvalues of a matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The eigenvalues by decreasing real part, 1/s; NaN if they are not found.
    pub values: Vec<Complex<f64>>,
    /// The number of exact zeros, from zero columns (variations on which no equation depends) or zero rows (variations that never
    /// change).
    pub idle: usize,
}

/// All eigenvalues of a matrix. Rows and columns of zeros are removed first, so that their zero eigenvalues are exact.
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Spectrum {
    let mut rest = matrix.clone();
    let mut all = Vec::new();
    let small = matrix.amax() * ROUNDING;
    while let Some(at) = (0..rest.nrows()).find(|&at| rest.column(at).amax() <= small || rest.row(at).amax() <= small) {
        rest = rest.remove_row(at).remove_column(at);
        all.push(Complex::new(0.0, 0.0));
    }
    let idle = all.len();
    if rest.nrows() > 0 {
        // eigenvalues that are not found are NaN
        let unknown = || vec![Complex::new(f64::NAN, f64::NAN); rest.nrows()];
        all.extend(integrators::eigenvalues(&rest).unwrap_or_else(unknown));
    }
    all.sort_by(|one, other| other.re.total_cmp(&one.re).then(other.im.total_cmp(&one.im)));
    Spectrum { values: all, idle }
}

/// Stability in the first approximation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// The point moves: eigenvalues at an instant do not decide stability.
    Moving,
    /// The number of eigenvalues with positive real parts.
    Unstable(usize),
    /// All eigenvalues have negative real parts, except `idle` exact zeros. These say nothing if nonlinear terms depend on their
    /// variations, such as a force -x^3.
    Asymptotic { idle: usize },
    /// No eigenvalue has a positive real part, and this number has the real part zero.
    Undecided(usize),
    /// The matrix has no eigenvalues: no motion is possible.
    Nothing,
}

impl Stability {
    /// Stability of an equilibrium or a steady motion. `is_steady` is false if the linear equations change along the motion.
    pub fn of(spectrum: &Spectrum, is_steady: bool) -> Self {
        let Spectrum { values: eigenvalues, idle } = spectrum;
        let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
        let sign = |value: &&Complex<f64>| value.re > ZERO * largest;
        let unstable = eigenvalues.iter().filter(sign).count();
        // an unknown eigenvalue decides nothing
        let is_neutral = |value: &&Complex<f64>| value.re.is_nan() || value.re.abs() <= ZERO * largest;
        let neutral = eigenvalues.iter().filter(is_neutral).count();
        match (is_steady, unstable, neutral) {
            (false, ..) => Stability::Moving,
            _ if eigenvalues.is_empty() => Stability::Nothing,
            (_, 0, neutral) if neutral == *idle && eigenvalues.len() > *idle => Stability::Asymptotic { idle: *idle },
            (_, 0, neutral) => Stability::Undecided(neutral),
            (_, unstable, _) => Stability::Unstable(unstable),
        }
    }
}

impl fmt::Display for Stability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stability::Moving => write!(f, "the point moves: eigenvalues of an instant do not decide stability"),
            Stability::Unstable(1) => write!(f, "one eigenvalue has a positive real part: unstable"),
            Stability::Unstable(count) => write!(f, "{count} eigenvalues have positive real parts: unstable"),
            Stability::Asymptotic { idle: 0 } => {
                write!(f, "every eigenvalue has a negative real part: asymptotically stable")
            }
            Stability::Asymptotic { idle } => write!(
                f,
                "every eigenvalue has a negative real part but for {idle} zero, of variations that appear in no linear equation: \
                 asymptotically stable in all others, unless the equations of motion depend on these"
            ),
            Stability::Undecided(count) => write!(
                f,
                "no eigenvalue has a positive real part, and {count} of them {} zero: the linear equations do not decide stability",
                if *count == 1 { "has the real part" } else { "have the real part" }
            ),
            Stability::Nothing => write!(f, "no eigenvalues: no motion near this point is possible"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Stability, eigenvalues};
    use nalgebra::DMatrix;

    #[test]
    fn zeros_of_coordinates_that_do_not_occur_are_exact() {
        // a cart with a hanging pendulum: no equation depends on the position of the cart
        let matrix = DMatrix::from_row_slice(4, 4, &[0., 0., 1., 0., 0., 0., 0., 1., 0., 3., 0., 0., 0., -9., 0., 0.]);
        let found = eigenvalues(&matrix);
        assert_eq!((found.values.iter().filter(|value| value.norm() == 0.0).count(), found.idle), (2, 2));
        assert!(found.values.iter().any(|value| (value.im - 3.0).abs() < 1e-12));
        assert_eq!(Stability::of(&found, true), Stability::Undecided(4));
        assert_eq!(Stability::of(&found, false), Stability::Moving);
        let damped = DMatrix::from_row_slice(2, 2, &[0., 1., -2., -3.]);
        assert_eq!(Stability::of(&eigenvalues(&damped), true), Stability::Asymptotic { idle: 0 });
        let rolling = DMatrix::from_row_slice(3, 3, &[0., 1., 0., 0., -1., 0., 0., 2., -3.]);
        assert_eq!(Stability::of(&eigenvalues(&rolling), true), Stability::Asymptotic { idle: 1 });
        let upright = DMatrix::from_row_slice(2, 2, &[0., 1., 2., 0.]);
        assert_eq!(
            Stability::of(&eigenvalues(&upright), true).to_string(),
            "one eigenvalue has a positive real part: unstable"
        );
    }
}
