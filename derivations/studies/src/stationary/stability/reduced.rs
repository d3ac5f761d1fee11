//! The linearisation of a gyrostat whose rotor has a constant relative speed or own momentum, reduced to three unknowns.
//!
//! With deviations d nu of the vertical and eta = d omega - w0 d nu: d nu' = nu x eta, and with a tensor T, the rotor's
//! momentum sigma, H = lambda - w0^2 T, kappa = 2 w0 T nu + sigma and n = kappa - w0 tr(T) nu
//!
//!   T eta' = nu x H d nu + n x eta ,    K(z) eta = 0 ,    K(z) = z^2 T - z \[n\] - \[nu\] H \[nu\] ,
//!
//!   det K = z^2 det T (z^4 + a z^2 + b) .
//!
//! `derivations/theorems/src/stability/` proves this reduction.

use crate::stationary::energies::Energies;
use field::Scalar;
use mechanics::rotation::{adjugate, determinant};
use nalgebra::{Matrix3, Vector3};

/// A steady motion of a gyrostat with constant relative speed or own momentum of the rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<S: Scalar> {
    /// T, kg m^2: A* where the rotor's relative speed is constant, A where its own momentum is
    pub tensor: Matrix3<S>,
    /// sigma: A' W l or A' (W + w0 l.nu) l, N m s
    pub spin: Vector3<S>,
    /// w0, rad/s
    pub speed: S,
    /// nu
    pub vertical: Vector3<S>,
    /// lambda = nu.(w0 x + Ge), N m
    pub multiplier: S,
}

impl<S: Scalar> Reduced<S> {
    /// A gyrostat with the constant relative speed W of the rotor, rad/s.
    pub fn kept(energies: &Energies<S>, speed: S, vertical: Vector3<S>, rotor_speed: S) -> Self {
        let Energies { tensor, mixed, weight, .. } = *energies;
        let spin = mixed * rotor_speed;
        let multiplier = ((tensor * vertical * speed + spin) * speed + weight).dot(&vertical);
        Reduced { tensor, spin, speed, vertical, multiplier }
    }

    /// A gyrostat with a free rotor of this relative speed, rad/s, whose own momentum is conserved.
    pub fn free(energies: &Energies<S>, speed: S, vertical: Vector3<S>, rotor_speed: S) -> Self {
        let Energies { tensor, mixed, axial, .. } = *energies;
        let share = mixed / axial;
        let spin = share * (mixed.dot(&vertical) * speed + axial * rotor_speed);
        Reduced {
            tensor: tensor - share * mixed.transpose(),
            spin,
            ..Self::kept(energies, speed, vertical, rotor_speed)
        }
    }

    /// the stiffness H, N m
    pub fn stiffness(&self) -> Matrix3<S> {
        Matrix3::identity() * self.multiplier - self.tensor * self.speed.squared()
    }

    /// kappa, N m s: the derivative of the vertical momentum by a tilt
    pub fn coupling(&self) -> Vector3<S> {
        self.tensor * self.vertical * (self.speed + self.speed) + self.spin
    }

    /// n, N m s
    pub fn gyroscopic(&self) -> Vector3<S> {
        self.coupling() - self.vertical * (self.speed * self.tensor.trace())
    }

    /// -\[nu\] H \[nu\]
    pub fn pulled_back(&self) -> Matrix3<S> {
        let turn = cross(self.vertical);
        -(turn * self.stiffness() * turn)
    }

    /// K(z)
    pub fn pencil(&self, z: S) -> Matrix3<S> {
        self.tensor * z.squared() - cross(self.gyroscopic()) * z + self.pulled_back()
    }

    /// (det T, det T a, det T b)
    pub fn polynomial(&self) -> [S; 3] {
        let n = self.gyroscopic();
        let a = (adjugate(&self.tensor) * self.pulled_back()).trace() + (self.tensor * n).dot(&n);
        let (h, across) = (self.stiffness(), self.vertical.cross(&self.coupling()));
        let b = self.weight() * (adjugate(&h) * self.vertical).dot(&self.vertical) + (h * across).dot(&across);
        [determinant(&self.tensor), a, b]
    }

    /// nu.T nu
    pub fn weight(&self) -> S {
        (self.tensor * self.vertical).dot(&self.vertical)
    }

    /// Q, N m: twice the energy of a tilt at constant vertical momentum, on the plane orthogonal to nu.
    pub fn energy(&self) -> Matrix3<S> {
        let coupling = self.coupling();
        self.stiffness() + coupling * coupling.transpose() / self.weight()
    }

    /// det T a, det T b, their discriminant, and the trace of Q orthogonal to nu: the signs decide stability.
    pub fn deciding(&self) -> [S; 4] {
        let [det, a, b] = self.polynomial();
        let form = self.energy();
        let trace = form.trace() - (form * self.vertical).dot(&self.vertical);
        [a, b, a.squared() - det * b * S::int(4), trace]
    }
}

/// The matrix of the cross product with a.
pub fn cross<S: Scalar>(a: Vector3<S>) -> Matrix3<S> {
    let zero = S::zero();
    Matrix3::new(zero, -a.z, a.y, a.z, zero, -a.x, -a.y, a.x, zero)
}

/// The stability of a tilt, at constant rotor speed and with a motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// Definite energy: stable at constant speed, and with every motor whose own steady state is stable.
    ByEnergy,
    /// Imaginary eigenvalues with indefinite energy: stabilised only by gyroscopic forces; unstable with a motor whose torque responds to
    /// the motion.
    ByGyroscopes,
    Unstable,
    /// On the boundary between two of the other cases.
    Edge,
}

impl Fate {
    pub const ALL: [Fate; 4] = [Fate::ByEnergy, Fate::ByGyroscopes, Fate::Unstable, Fate::Edge];

    /// The name in pictures and tables.
    pub fn name(self) -> &'static str {
        match self {
            Fate::ByEnergy => "stable by energy, with every motor",
            Fate::ByGyroscopes => "held by gyroscopic forces alone",
            Fate::Unstable => "unstable",
            Fate::Edge => "on the edge",
        }
    }

    /// The fate of a motion, given the sign of numbers; that of fractions is exact.
    pub fn of<S: Scalar>(motion: &Reduced<S>, sign: impl Fn(S) -> i32) -> Fate {
        Fate::by_signs(motion.deciding().map(sign))
    }

    /// The fate by the signs of [`Reduced::deciding`].
    pub fn by_signs([a, b, apart, trace]: [i32; 4]) -> Fate {
        match (b, a, apart) {
            (1, _, _) if trace > 0 => Fate::ByEnergy,
            (1, 1, 1) => Fate::ByGyroscopes,
            (0, 0 | 1, _) | (1, 1, 0) => Fate::Edge,
            _ => Fate::Unstable,
        }
    }
}
