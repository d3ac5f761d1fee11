//! The first approximation of a gyrostat whose rotor keeps its relative speed or its own momentum, reduced to three unknowns.
//!
//! With deviations d nu of the vertical and eta = d omega - w0 d nu: d nu' = nu x eta, and with a tensor T, the rotor's
//! momentum sigma, H = lambda - w0^2 T, kappa = 2 w0 T nu + sigma and n = kappa - w0 tr(T) nu
//!
//!   T eta' = nu x H d nu + n x eta ,    K(z) eta = 0 ,    K(z) = z^2 T - z \[n\] - \[nu\] H \[nu\] ,
//!
//!   det K = z^2 det T (z^4 + a z^2 + b) .
//!
//! That this is what the laws come to is proved in `claims`.

use crate::stationary::energies::Energies;
use field::Scalar;
use mechanics::rotation::{adjugate, determinant};
use nalgebra::{Matrix3, Vector3};

/// A stationary motion, and what the rotor lends to the carrier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<S: Scalar> {
    /// T: A* where the rotor keeps its relative speed, A where it keeps its own momentum, kg m^2
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
    /// A rotor that keeps its relative speed W, rad/s.
    pub fn kept(energies: &Energies<S>, speed: S, vertical: Vector3<S>, rotor_speed: S) -> Self {
        let Energies { tensor, mixed, weight, .. } = *energies;
        let spin = mixed * rotor_speed;
        let multiplier = ((tensor * vertical * speed + spin) * speed + weight).dot(&vertical);
        Reduced { tensor, spin, speed, vertical, multiplier }
    }

    /// A rotor that has this relative speed now, and keeps its own momentum.
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

    /// H, N m
    pub fn stiffness(&self) -> Matrix3<S> {
        Matrix3::identity() * self.multiplier - self.tensor * self.speed.squared()
    }

    /// kappa, N m s: what a tilt changes of the vertical momentum
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

    /// Q: twice the energy of a tilt with the vertical momentum kept, N m; it counts on the plane across nu.
    pub fn energy(&self) -> Matrix3<S> {
        let coupling = self.coupling();
        self.stiffness() + coupling * coupling.transpose() / self.weight()
    }

    /// det T a, det T b, the discriminant of both, and the trace of Q across nu: their signs decide.
    pub fn deciding(&self) -> [S; 4] {
        let [det, a, b] = self.polynomial();
        let form = self.energy();
        let trace = form.trace() - (form * self.vertical).dot(&self.vertical);
        [a, b, a.squared() - det * b * S::int(4), trace]
    }
}

/// The matrix of a x .
pub fn cross<S: Scalar>(a: Vector3<S>) -> Matrix3<S> {
    let zero = S::zero();
    Matrix3::new(zero, -a.z, a.y, a.z, zero, -a.x, -a.y, a.x, zero)
}

/// What becomes of a tilt, at constant speed and with a motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// The energy is definite: stable at constant speed, and with every motor whose own state is stable.
    ByEnergy,
    /// The roots are on the axis and the energy is not definite: only gyroscopic forces hold it; a motor that feels it makes it
    /// unstable.
    ByGyroscopes,
    Unstable,
    /// On the edge between them.
    Edge,
}

impl Fate {
    pub const ALL: [Fate; 4] = [Fate::ByEnergy, Fate::ByGyroscopes, Fate::Unstable, Fate::Edge];

    /// For readers.
    pub fn name(self) -> &'static str {
        match self {
            Fate::ByEnergy => "stable by energy, with every motor",
            Fate::ByGyroscopes => "held by gyroscopic forces alone",
            Fate::Unstable => "unstable",
            Fate::Edge => "on the edge",
        }
    }

    /// From the signs of numbers; those of fractions are exact.
    pub fn of<S: Scalar>(motion: &Reduced<S>, sign: impl Fn(S) -> i32) -> Fate {
        Fate::by_signs(motion.deciding().map(sign))
    }

    /// From the signs of [`Reduced::deciding`].
    pub fn by_signs([a, b, apart, trace]: [i32; 4]) -> Fate {
        match (b, a, apart) {
            (1, _, _) if trace > 0 => Fate::ByEnergy,
            (1, 1, 1) => Fate::ByGyroscopes,
            (0, 0 | 1, _) | (1, 1, 0) => Fate::Edge,
            _ => Fate::Unstable,
        }
    }
}
