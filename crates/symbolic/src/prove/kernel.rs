//! The choice of the width of monomials and the size of coefficients for a computation.

use super::failure::Failure;
use algebra::multivariate::{Coefficient, Limit};
use dashu_int::IBig;

/// A computation with polynomials of any width and coefficients of any size.
pub(super) trait Computation {
    type Output;
    fn run<C: Coefficient, const W: usize>(&self) -> Result<Self::Output, Failure>;
}

/// Runs with monomials that suffice for the generators, and with machine integers if they do. Every pair of a width
/// and a coefficient is compiled by itself, so there are few: big integers cost more than wide monomials.
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
