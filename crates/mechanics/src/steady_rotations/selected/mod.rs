//! Uniform rotations selected by one more equation: those with a given angular momentum about the vertical, and the
//! folds, where the number of rotations with one angular velocity changes.
//!
//! With s = 1/w and lambda = w^2 x the direction is v = -(s N_h + s^2 N_G) / q, where (M - x) N = q h and q G
//! (`spectrum`), and
//!
//!   |v| = 1 :             s^2 N_h.N_h + 2 s^3 N_h.N_G + s^4 N_G.N_G = q^2 ,
//!   p = w v.M v + h.v :   x q - p s q + s^3 G.N_h + s^4 G.N_G = 0 .
//!
//! Two rotations merge where the derivative of |v|^2 with respect to x at fixed s vanishes. For the folds the second
//! equation is therefore replaced by (d/dx - 2 q'/q) (N_h.N_h + 2 s N_h.N_G + s^2 N_G.N_G) q = 0.
//!
//! # Overview
//! * `equations`: both equations, as polynomials in s with polynomials in x as coefficients;
//! * `regular`: solutions away from the eigenvalues of M: the resultant of both equations in s, a polynomial in x, and
//!   their common divisor;
//! * `unseen`: solutions at eigenvalues whose eigenvectors are orthogonal to h and G;
//! * `seen`: solutions at the other eigenvalues, for the one s with the eigenvector orthogonal to s h + s^2 G;
//! * `rests`: solutions with w = 0;
//! * [`Turning`]: one rotation, enclosed.

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

/// All solutions (v, w).
pub struct Selected {
    /// Isolated motions in ascending order of x, then families, then those with w = 0.
    pub motions: Vec<Turning>,
    /// The degree of the resultant without factors that belong to no motion, and the number of its distinct real roots.
    pub degree: usize,
    pub roots: usize,
    /// The reason why further motions may exist; `None` where completeness is proved.
    pub undecided: Option<Undecided>,
}

/// The reason why completeness is not proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// The resultant vanishes identically: there is a curve of motions.
    Curve,
    /// The precision needed exceeds the largest one tried.
    TooFine,
}

/// The algebraic data of a motion.
#[derive(Clone)]
enum RotationPlace {
    /// x is a root of the resultant, and s = -ratio[0]/ratio[1] at x.
    Regular(Root),
    /// A pair (s, x) where several s belong to the root x of the resultant.
    Shared(Nested, Root),
    /// x is the eigenvalue with this index, whose eigenvector is orthogonal to h and G; s is a root of the remaining equation.
    Unseen { eigenvalue: usize, s: Nested },
    /// A solution at an eigenvalue whose eigenvector is orthogonal to s h + s^2 G for one s.
    Seen(Arc<seen::Special>),
    /// w = 0, with v parallel or antiparallel to a vector.
    Rest { along: bool, vector: Vector<Number> },
    /// w = 0 without weight: all v with h.v = p. The numbers are |h|^2 p and |h|^2.
    Circle { axis: Vector<Number>, momentum: Number, denominator: Number },
    /// w = 0 without weight and wheels: every v.
    Everywhere,
}

struct Case {
    spectrum: Spectrum,
    body: Body,
    /// The polynomials of s = -ratio[0] / ratio[1].
    ratio: Vec<Polynomial>,
}

/// The momentum p = numerator / denominator, in units of the body's integers.
struct Momentum {
    numerator: Number,
    denominator: Number,
}

impl Body {
    /// All uniform rotations with the angular momentum p about the vertical, N m s. `None` where p is undefined.
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

    /// The folds: between adjacent angular velocities of folds, and zero, the number of rotations is constant.
    pub fn folds(&self) -> Selected {
        let spectrum = Spectrum::of(&self.tensor, &[self.spin.clone(), self.weight.clone()]);
        let length = length(&spectrum);
        let slope = spectrum.seen.derivative();
        let two = Number::from(2);
        let fold = |p: &Polynomial| &(&p.derivative() * &spectrum.seen) - &scaled(&(p * &slope), &two);
        let folds = trimmed(length.iter().skip(2).map(fold).collect());
        let (mut all, case) = Selected::of(self, spectrum, &length, &folds);
        // a symmetric pair about an eigenvector orthogonal to b for all s begins where |v| = 1 without it
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
