//! Forward differentiation of functions over any scalar type.

use field::{Scalar, Tangent};

/// The gradient of f at x, by one evaluation over dual numbers for each coordinate.
pub fn gradient<S: Scalar, const N: usize>(f: impl Fn([Tangent<S>; N]) -> Tangent<S>, x: [S; N]) -> [S; N] {
    std::array::from_fn(|i| f(along(x, unit(i))).slope)
}

/// x as dual numbers with the derivative `direction`.
pub fn along<S: Scalar, const N: usize>(x: [S; N], direction: [S; N]) -> [Tangent<S>; N] {
    std::array::from_fn(|i| Tangent::moving(x[i], direction[i]))
}

/// x as dual numbers with the derivative zero.
pub fn fixed<S: Scalar, const N: usize>(x: [S; N]) -> [Tangent<S>; N] {
    x.map(Tangent::fixed)
}

/// The i-th unit vector.
pub fn unit<S: Scalar, const N: usize>(i: usize) -> [S; N] {
    std::array::from_fn(|j| if i == j { S::one() } else { S::zero() })
}
