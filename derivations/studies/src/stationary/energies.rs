//! The quadratic form and the vectors of the function W, from the bodies' energies by differentiation.

use field::{Base, Rational, Tangent};
use mechanics::differentiate::{along, gradient, unit};
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;
use systems::gyrostat::Gyrostat;

/// The second derivatives of T with respect to (w, phi'), and the gradient of -V with respect to the vertical.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energies<P: field::Scalar> {
    /// d2T/dw2, kg m^2.
    pub tensor: Matrix3<P>,
    /// d2T/dw dphi', kg m^2.
    pub mixed: Vector3<P>,
    /// d2T/dphi'2, kg m^2.
    pub axial: P,
    /// -dV/dv, N m.
    pub weight: Vector3<P>,
}

/// The rotor's constant quantity, which determines the quadratic form M and the vector h of W.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// The speed relative to the carrier: M is the second derivative of T with respect to w.
    RelativeSpeed,
    /// The own momentum p = dT/dphi' (Routh): M is that derivative reduced by the rotor's part, and h its coefficient
    /// times p.
    Momentum,
}

impl<P: Base> Energies<P> {
    /// The derivatives from kinetic and potential energy of bodies.
    pub fn of(bodies: &Gyrostat<P>) -> Self {
        let kinetic = |[x, y, z, rotor]: [Tangent<Tangent<P>>; 4]| bodies.kinetic_energy(Vector3::new(x, y, z), rotor);
        let rows: [[P; 4]; 4] = std::array::from_fn(|i| {
            let moving: [Tangent<P>; 4] = along([P::zero(); 4], unit(i));
            gradient(kinetic, moving).map(|component| component.slope)
        });
        let potential = |[x, y, z]: [Tangent<P>; 3]| bodies.potential_energy(Vector3::new(x, y, z));
        Energies {
            tensor: Matrix3::from_fn(|i, j| rows[i][j]),
            mixed: Vector3::from_fn(|i, _| rows[i][3]),
            axial: rows[3][3],
            weight: -Vector3::from(gradient(potential, [P::zero(); 3])),
        }
    }

    /// M, and h per unit of the constant quantity.
    pub fn quadratic(&self, kept: Kept) -> (Matrix3<P>, Vector3<P>) {
        match kept {
            Kept::RelativeSpeed => (self.tensor, self.mixed),
            Kept::Momentum => {
                let share = self.mixed / self.axial;
                (self.tensor - share * self.mixed.transpose(), share)
            }
        }
    }
}

impl Energies<Rational> {
    /// The energies as constant expressions.
    pub fn written(&self) -> Energies<Sym> {
        Energies {
            tensor: self.tensor.map(Sym::constant),
            mixed: self.mixed.map(Sym::constant),
            axial: Sym::constant(self.axial),
            weight: self.weight.map(Sym::constant),
        }
    }
}
