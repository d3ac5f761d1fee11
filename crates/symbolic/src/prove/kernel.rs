//! Choosing the width of monomials and the size of coefficients for a computation.

use crate::poly::{Coefficient, Failure};
use dashu_int::IBig;

/// A computation with polynomials of any width and coefficients of any size.
pub(super) trait Computation {
    type Output;
    fn run<C: Coefficient, const W: usize>(&self) -> Result<Self::Output, Failure>;
}

/// Runs with the narrowest monomials for the number of generators, and with machine integers if they suffice.
pub(super) fn compute<T: Computation>(computation: &T, generators: usize) -> Result<T::Output, Failure> {
    match with_coefficients::<i128, T>(computation, generators) {
        Err(Failure::Overflow) => with_coefficients::<IBig, T>(computation, generators),
        result => result,
    }
}

fn with_coefficients<C: Coefficient, T: Computation>(computation: &T, generators: usize) -> Result<T::Output, Failure> {
    match generators {
        0..=8 => computation.run::<C, 1>(),
        9..=16 => computation.run::<C, 2>(),
        17..=32 => computation.run::<C, 4>(),
        33..=64 => computation.run::<C, 8>(),
        65..=160 => computation.run::<C, 20>(),
        _ => Err(Failure::Generators(generators)),
    }
}
