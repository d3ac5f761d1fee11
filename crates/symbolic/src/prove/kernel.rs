//! Choice of the width of monomials and of the size of coefficients.

use super::failure::Failure;
use algebra::multivariate::{Coefficient, Limit};
use dashu_int::IBig;

/// A computation with polynomials that is generic in the width of monomials and the type of coefficients.
pub(super) trait Computation {
    type Output;
    fn run<C: Coefficient, const W: usize>(&self) -> Result<Self::Output, Failure>;
}

/// Runs a computation with monomials that are wide enough for the generators: first with 128-bit coefficients, after an overflow with big integers. Each
/// combination is compiled separately; for big integers there are only two, since the width matters less there.
pub(super) fn compute<T: Computation>(computation: &T, generators: usize) -> Result<T::Output, Failure> {
    let by_machine_integers = match generators {
        0..=16 => computation.run::<i128, 2>(),
        17..=32 => computation.run::<i128, 4>(),
        33..=64 => computation.run::<i128, 8>(),
        65..=160 => computation.run::<i128, 20>(),
        _ => Err(Failure::Generators(generators)),
    };
    match by_machine_integers {
        Err(Failure::Polynomial(Limit::Overflow)) if generators <= 32 => computation.run::<IBig, 4>(),
        Err(Failure::Polynomial(Limit::Overflow)) => computation.run::<IBig, 20>(),
        result => result,
    }
}
