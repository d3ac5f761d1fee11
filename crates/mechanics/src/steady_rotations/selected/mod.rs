//! The uniform rotations that one more equation selects: all with a given angular momentum about the vertical; all at which
//! the number of rotations with one angular velocity changes.
//!
//! With s = 1/w and lambda = w^2 x, v = -(s N_h + s^2 N_G) / q where (M - x) N = q h and q G (`spectrum`), and
//!
//!   |v| = 1 :             s^2 N_h.N_h + 2 s^3 N_h.N_G + s^4 N_G.N_G = q^2 ,
//!   p = w v.M v + h.v :   x q - p s q + s^3 G.N_h + s^4 G.N_G = 0 .
//!
//! Two rotations merge where at fixed s the derivative of |v|^2 by x vanishes: the coefficients of s^0, s, s^2 in
//! (d/dx - 2 q'/q) (N_h.N_h + 2 s N_h.N_G + s^2 N_G.N_G) q in the place of the second.
//!
//! # Overview
//! * `equations`: both equations, as polynomials in s whose coefficients are polynomials in x;
//! * `regular`: away from the eigenvalues of M: the resultant of both in s, a polynomial in x, and their common divisor;
//! * `unseen`: at eigenvalues whose eigenvectors are orthogonal to h and to G;
//! * `seen`: at the other eigenvalues, for the one s with the eigenvector orthogonal to s h + s^2 G;
//! * `rests`: w = 0;
//! * [`Turning`]: one of the rotations, enclosed.

mod equations;
mod regular;
mod rests;
mod seen;
mod turning;
mod unseen;

pub use turning::Turning;

use super::Body;
use super::rotations::Kind;
use super::spectrum::{Spectrum, Vector, scaled};
use algebra::real::{Nested, Number, Polynomial, Root};
use equations::{balance, length, trimmed};
use field::Rational;
use std::sync::Arc;

/// All (v, w) that satisfy the equation.
pub struct Selected {
    /// Isolated motions in ascending order of x, families, rests.
    pub motions: Vec<Turning>,
    /// The degree of the resultant without the factors that stand for no motion, and the number of its different real
    /// roots.
    pub degree: usize,
    pub roots: usize,
    /// The reason why further motions may exist, if there is one: then "all" is not proved.
    pub undecided: Option<Undecided>,
}

/// Why completeness is not proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// The resultant vanishes identically: motions form a curve.
    Curve,
    /// More bits than are tried would be needed.
    TooFine,
}

/// The place of a motion.
#[derive(Clone)]
enum RotationPlace {
    /// x, and s as a fraction there.
    Regular(Root),
    /// x and s, where several s go with one x.
    Shared(Nested, Root),
    /// s, at an eigenvalue whose eigenvector is orthogonal to h and to G.
    Unseen { eigenvalue: usize, s: Nested },
    /// At an eigenvalue whose eigenvector is orthogonal to s h + s^2 G for one s.
    Seen(Arc<seen::Special>),
    /// w = 0, v along a vector or against it.
    Rest { along: bool, vector: Vector<Number> },
    /// w = 0 without weight: all v with h.v = p, as p (|h|^2 times the number, and |h|^2) and h.
    Circle { axis: Vector<Number>, momentum: Number, denominator: Number },
    /// w = 0 without weight and wheels: every v.
    Everywhere,
}

struct Case {
    spectrum: Spectrum,
    body: Body,
    /// s = -ratio[0] / ratio[1]
    ratio: Vec<Polynomial>,
}

/// p = numerator / denominator in the measure of the body's numbers.
struct Momentum {
    numerator: Number,
    denominator: Number,
}

impl Body {
    /// All uniform rotations with the angular momentum p about the vertical, N m s. `None` where that is undefined.
    pub fn at_momentum(&self, p: Rational) -> Option<Selected> {
        let (numerator, denominator) = Number::over_common(&[p])?;
        let momentum = Momentum { numerator: numerator.first()? * &self.scale, denominator };
        let spectrum = Spectrum::of(&self.tensor, &[self.spin.clone(), self.weight.clone()]);
        let length = length(&spectrum);
        let balance = balance(self, &spectrum, &momentum);
        let (mut all, case) = Selected::of(self, spectrum, &length, &balance);
        all.unseen(&case, &length, &balance);
        all.seen(&case, &momentum);
        all.rests(&case, &momentum);
        Some(all)
    }

    /// The folds: between two neighbours of these angular velocities, and zero, the number of rotations is constant.
    pub fn folds(&self) -> Selected {
        let spectrum = Spectrum::of(&self.tensor, &[self.spin.clone(), self.weight.clone()]);
        let length = length(&spectrum);
        let slope = spectrum.seen.derivative();
        let two = Number::from(2);
        let fold = |p: &Polynomial| &(&p.derivative() * &spectrum.seen) - &scaled(&(p * &slope), &two);
        let folds = trimmed(length.iter().skip(2).map(fold).collect());
        let (mut all, case) = Selected::of(self, spectrum, &length, &folds);
        // a pair on both sides of an eigenvector that is always orthogonal to b begins where |v| = 1 without it
        for &eigenvalue in &case.spectrum.unseen {
            let begins = Nested::roots(&case.spectrum.eigenvalues[eigenvalue].0, &length);
            all.motions.extend(begins.into_iter().map(|s| Turning {
                shape: super::Shape::Point,
                kind: Kind::Degenerate,
                place: RotationPlace::Unseen { eigenvalue, s },
                case: Arc::clone(&case),
            }));
        }
        all
    }
}
