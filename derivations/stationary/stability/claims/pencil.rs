//! The reduced first approximation of a gyrostat whose rotor keeps its momentum: K(z) eta = 0.
//!
//! With deviations of the vertical and eta = d omega - w0 d nu: d nu' = nu x eta, and with a tensor T, the rotor's momentum
//! sigma, x = w0 T nu + sigma, H = lambda - w0^2 T, kappa = 2 w0 T nu + sigma and n = kappa - w0 tr(T) nu
//!
//!   T eta' = nu x H d nu + n x eta ,    K(z) = z^2 T - z [n] - [nu] H [nu] .

use crate::papers::konosevich2022::{Letters, letter};
use crate::stationary::energies::Energies;
use field::Scalar;
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;

/// What the rotor lends to the carrier.
#[derive(Clone, Copy)]
pub struct Carrier {
    /// T: A* where the rotor keeps its relative speed, A where it keeps its own momentum.
    pub tensor: Matrix3<Sym>,
    /// sigma: A' W l or A' (W + w0 l.nu) l
    pub spin: Vector3<Sym>,
    pub speed: Sym,
    pub vertical: Vector3<Sym>,
    pub multiplier: Sym,
}

impl Carrier {
    /// A rotor of constant relative speed, in the axes of A*.
    pub fn kept(s: &Letters) -> Self {
        Carrier {
            tensor: Matrix3::from_diagonal(&s.a_star),
            spin: s.l * (s.axial * s.omega_field),
            speed: s.omega0,
            vertical: s.nu,
            multiplier: letter("λ"),
        }
    }

    /// A free rotor, in the same axes and with the same speed.
    pub fn free(s: &Letters) -> Self {
        Carrier {
            tensor: Matrix3::from_diagonal(&s.a_star) - s.l * s.l.transpose() * s.axial,
            spin: s.l * (s.axial * (s.omega_field + s.omega0 * s.l.dot(&s.nu))),
            ..Carrier::kept(s)
        }
    }

    /// H
    pub fn stiffness(&self) -> Matrix3<Sym> {
        Matrix3::identity() * self.multiplier - self.tensor * self.speed.powi(2)
    }

    /// kappa
    pub fn coupling(&self) -> Vector3<Sym> {
        self.tensor * self.vertical * (Sym::int(2) * self.speed) + self.spin
    }

    /// n
    pub fn gyroscopic(&self) -> Vector3<Sym> {
        self.coupling() - self.vertical * (self.speed * self.tensor.trace())
    }

    /// -[nu] H [nu]
    pub fn pulled_back(&self) -> Matrix3<Sym> {
        let turn = cross(self.vertical);
        -(turn * self.stiffness() * turn)
    }

    /// K(z)
    pub fn pencil(&self, z: Sym) -> Matrix3<Sym> {
        self.tensor * z.powi(2) - cross(self.gyroscopic()) * z + self.pulled_back()
    }
}

/// The matrix of a x .
pub fn cross(a: Vector3<Sym>) -> Matrix3<Sym> {
    Matrix3::new(Sym::ZERO, -a.z, a.y, a.z, Sym::ZERO, -a.x, -a.y, a.x, Sym::ZERO)
}

/// The gyrostat in the axes of A* with the weight for which nu is stationary with the multiplier lambda: every stationary
/// motion of every gyrostat is of this form.
pub fn stationary(s: &Letters) -> Energies<Sym> {
    let carrier = Carrier::kept(s);
    let momentum = carrier.tensor * s.nu * s.omega0 + carrier.spin;
    Energies {
        tensor: carrier.tensor,
        mixed: s.l * s.axial,
        axial: s.axial,
        weight: s.nu * carrier.multiplier - momentum * s.omega0,
    }
}
