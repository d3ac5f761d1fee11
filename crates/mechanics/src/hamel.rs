//! The equations of Boltzmann and Hamel: Lagrange's equations in quasi-velocities.
//!
//! Quasi-velocities w = W(q) q' are linear forms of the velocities that need not be rates of coordinates. With the
//! fields X_j (q' = X_j for w = unit vector j) and their brackets [X_j, X_m] = sum_l c^l_jm X_l the equations are
//!
//!   d/dt (dT/dw_j) + sum_lm c^l_jm w_m dT/dw_l - X_j(T) = Q_j ,
//!
//! where X_j(T) is the derivative of T(q, w) along X_j with w constant, and Q_j the power of the forces along X_j.

use crate::differentiate::{along, fixed, gradient, unit};
use field::{Scalar, Tangent};
use nalgebra::{SMatrix, SVector};

/// The left-hand side of these equations for a kinetic energy T(w) independent of the position, as for a body about a
/// fixed point.
///
/// `fields(q)` has the X_j as columns, over dual numbers for their brackets; `forms` is W(q), the inverse of their
/// matrix. `rates` are w'.
pub fn boltzmann_hamel<S: Scalar, const N: usize>(
    kinetic_energy: impl Fn([Tangent<Tangent<S>>; N]) -> Tangent<Tangent<S>>,
    forms: SMatrix<S, N, N>,
    fields: impl Fn([Tangent<S>; N]) -> SMatrix<Tangent<S>, N, N>,
    position: [S; N],
    quasi: [S; N],
    rates: [S; N],
) -> [S; N] {
    let momentum: [S; N] = gradient(|w| kinetic_energy(fixed(w)).value, quasi);
    let structure = brackets(forms, fields, position);
    std::array::from_fn(|j| {
        let varied = std::array::from_fn(|k| {
            Tangent::moving(Tangent::moving(quasi[k], rates[k]), Tangent::fixed(unit::<S, N>(j)[k]))
        });
        let mut residual = kinetic_energy(varied).slope.slope;
        for (l, moment) in momentum.iter().enumerate() {
            for (m, speed) in quasi.iter().enumerate() {
                residual += structure[l][(j, m)] * *speed * *moment;
            }
        }
        residual
    })
}

/// The structure functions c^l_jm of the brackets [X_j, X_m] = D X_m X_j - D X_j X_m, as a matrix (j, m) for each l.
fn brackets<S: Scalar, const N: usize>(
    forms: SMatrix<S, N, N>,
    fields: impl Fn([Tangent<S>; N]) -> SMatrix<Tangent<S>, N, N>,
    position: [S; N],
) -> [SMatrix<S, N, N>; N] {
    let at_rest = fields(fixed(position)).map(|x| x.value);
    // the derivatives of all fields along X_j
    let derived: [SMatrix<S, N, N>; N] = std::array::from_fn(|j| {
        let direction: [S; N] = std::array::from_fn(|i| at_rest[(i, j)]);
        fields(along(position, direction)).map(|x| x.slope)
    });
    let mut structure = [SMatrix::<S, N, N>::zeros(); N];
    for j in 0..N {
        for m in 0..N {
            let bracket: SVector<S, N> = SVector::from_fn(|i, _| derived[j][(i, m)] - derived[m][(i, j)]);
            let components = forms * bracket;
            for l in 0..N {
                structure[l][(j, m)] = components[l];
            }
        }
    }
    structure
}
