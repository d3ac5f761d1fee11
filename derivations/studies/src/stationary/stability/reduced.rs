//! The linearisation of a gyrostat with constant relative speed, or constant own momentum, of the rotor, reduced to
//! three unknowns.
//!
//! Let d nu be the deviation of the vertical nu, and eta = d omega - w0 d nu. Then d nu' = nu x eta. With the inertia
//! tensor T, the rotor's momentum sigma, H = lambda - w0^2 T, kappa = 2 w0 T nu + sigma and n = kappa - w0 tr(T) nu,
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

/// A steady motion of a gyrostat with constant relative speed or constant own momentum of the rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<S: Scalar> {
    /// The tensor T, kg m^2: A* if the rotor's relative speed is constant, A if its own momentum is.
    pub tensor: Matrix3<S>,
    /// The rotor's momentum sigma, N m s: A' W l, or A' (W + w0 l.nu) l.
    pub spin: Vector3<S>,
    /// The angular velocity w0, rad/s.
    pub speed: S,
    /// The unit vector nu of the vertical.
    pub vertical: Vector3<S>,
    /// The multiplier lambda = nu.(w0 x + Ge), N m.
    pub multiplier: S,
}

impl<S: Scalar> Reduced<S> {
    /// A gyrostat whose rotor has the constant relative speed W, rad/s.
    pub fn kept(energies: &Energies<S>, speed: S, vertical: Vector3<S>, rotor_speed: S) -> Self {
        let Energies { tensor, mixed, weight, .. } = *energies;
        let spin = mixed * rotor_speed;
        let multiplier = ((tensor * vertical * speed + spin) * speed + weight).dot(&vertical);
        Reduced { tensor, spin, speed, vertical, multiplier }
    }

    /// A gyrostat with a free rotor, whose own momentum is conserved; `rotor_speed`: its relative speed, rad/s.
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

    /// The stiffness H, N m.
    pub fn stiffness(&self) -> Matrix3<S> {
        Matrix3::identity() * self.multiplier - self.tensor * self.speed.squared()
    }

    /// The vector kappa, N m s: the derivative of the vertical component of angular momentum with respect to a tilt.
    pub fn coupling(&self) -> Vector3<S> {
        self.tensor * self.vertical * (self.speed + self.speed) + self.spin
    }

    /// The vector n of the gyroscopic term, N m s.
    pub fn gyroscopic(&self) -> Vector3<S> {
        self.coupling() - self.vertical * (self.speed * self.tensor.trace())
    }

    /// The matrix -\[nu\] H \[nu\].
    pub fn pulled_back(&self) -> Matrix3<S> {
        let turn = cross(self.vertical);
        -(turn * self.stiffness() * turn)
    }

    /// The matrix polynomial K(z).
    pub fn pencil(&self, z: S) -> Matrix3<S> {
        self.tensor * z.squared() - cross(self.gyroscopic()) * z + self.pulled_back()
    }

    /// The coefficients (det T, det T a, det T b).
    pub fn polynomial(&self) -> [S; 3] {
        let n = self.gyroscopic();
        let a = (adjugate(&self.tensor) * self.pulled_back()).trace() + (self.tensor * n).dot(&n);
        let (h, across) = (self.stiffness(), self.vertical.cross(&self.coupling()));
        let b = self.weight() * (adjugate(&h) * self.vertical).dot(&self.vertical) + (h * across).dot(&across);
        [determinant(&self.tensor), a, b]
    }

    /// The moment of inertia nu.T nu about the vertical.
    pub fn weight(&self) -> S {
        (self.tensor * self.vertical).dot(&self.vertical)
    }

    /// The quadratic form Q, N m, on the plane orthogonal to nu: twice the energy of a tilt at constant vertical
    /// component of angular momentum.
    pub fn energy(&self) -> Matrix3<S> {
        let coupling = self.coupling();
        self.stiffness() + coupling * coupling.transpose() / self.weight()
    }

    /// The four numbers whose signs decide stability: det T a, det T b, the discriminant, and the trace of Q on the
    /// plane orthogonal to nu.
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

/// The stability with respect to tilting, at constant rotor speed and with a motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// The energy is definite: stable at constant speed, and with every motor whose own steady state is stable.
    ByEnergy,
    /// The eigenvalues are imaginary and the energy is indefinite: stabilised by gyroscopic forces only, and unstable
    /// with a motor whose torque responds to the motion.
    ByGyroscopes,
    Unstable,
    /// On the boundary between two of the other cases.
    Edge,
}

impl Fate {
    pub const ALL: [Fate; 4] = [Fate::ByEnergy, Fate::ByGyroscopes, Fate::Unstable, Fate::Edge];

    /// The name in figures and tables.
    pub fn name(self) -> &'static str {
        match self {
            Fate::ByEnergy => "stable by energy, with every motor",
            Fate::ByGyroscopes => "held by gyroscopic forces alone",
            Fate::Unstable => "unstable",
            Fate::Edge => "on the edge",
        }
    }

    /// The stability of a motion; `sign` gives the sign of a number, which is exact for rational numbers.
    pub fn of<S: Scalar>(motion: &Reduced<S>, sign: impl Fn(S) -> i32) -> Fate {
        Fate::by_signs(motion.deciding().map(sign))
    }

    /// The stability by the signs of [`Reduced::deciding`].
    pub fn by_signs([a, b, apart, trace]: [i32; 4]) -> Fate {
        match (b, a, apart) {
            (1, _, _) if trace > 0 => Fate::ByEnergy,
            (1, 1, 1) => Fate::ByGyroscopes,
            (0, 0 | 1, _) | (1, 1, 0) => Fate::Edge,
            _ => Fate::Unstable,
        }
    }
}
