//! The quantities of the paper as symbols, and the gyrostat in these symbols.

use super::alphabet::{current, cyclic, letter, tensor, vector};
use field::{Analytic, Circle};
use machines::multi_current::{MultiCurrent, Windings};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use symbolic::{Hypotheses, Sym};
use systems::gyrostat::{Carrier, Gyrostat, MotionInstant, Rotor};

/// The quantities of the paper as symbols.
pub struct Letters {
    pub w: Vector3<Sym>,
    pub dw: Vector3<Sym>,
    pub nu: Vector3<Sym>,
    pub l: Vector3<Sym>,
    pub e: Vector3<Sym>,
    pub h: Vector3<Sym>,
    /// The principal moments of A.
    pub a: Vector3<Sym>,
    /// The principal moments of A*.
    pub a_star: Vector3<Sym>,
    pub m_rotor: Sym,
    pub axial: Sym,
    pub transverse: Sym,
    pub big_gamma: Sym,
    pub dphi: Sym,
    pub ddphi: Sym,
    pub torque: Sym,
    pub gamma: Sym,
    pub dgamma: Sym,
    pub ddgamma: Sym,
    pub omega_field: Sym,
    pub omega0: Sym,
    pub b0: Sym,
    pub c0: Sym,
    /// The hypothesis |l| = 1.
    pub unit_axis: Hypotheses,
    /// The hypothesis |nu| = 1.
    pub unit_vertical: Hypotheses,
}

/// The symbols, created in the calling thread.
impl Default for Letters {
    fn default() -> Self {
        let (l, nu) = (vector("l"), vector("ν"));
        Letters {
            w: vector("ω"),
            dw: vector("ω̇"),
            nu,
            l,
            e: vector("e"),
            h: vector("h"),
            a: vector("A"),
            a_star: vector("A⋆"),
            m_rotor: letter("m′"),
            axial: letter("A′"),
            transverse: letter("B′"),
            big_gamma: letter("Γ"),
            dphi: letter("φ̇′"),
            ddphi: letter("φ̈′"),
            torque: letter("M"),
            gamma: letter("γ"),
            dgamma: letter("γ̇"),
            ddgamma: letter("γ̈"),
            omega_field: letter("Ω"),
            omega0: letter("ω⁰"),
            b0: letter("b0"),
            c0: letter("c0"),
            unit_axis: Hypotheses::none().unit_vector(l.into()),
            unit_vertical: Hypotheses::none().unit_vector(nu.into()),
        }
    }
}

impl Letters {
    /// The gyrostat in arbitrary axes, with a symbol for every datum.
    pub fn general(&self) -> Gyrostat<Sym> {
        Gyrostat {
            carrier: Carrier { mass: letter("m⁰"), centre: vector("c⁰"), inertia: tensor("A⁰") },
            rotor: self.rotor(),
            gravity: letter("g"),
        }
    }

    /// The gyrostat in the principal axes of A: the carrier's tensor is diag(A1, A2, A3) minus the rotor's
    /// contribution; its centre of mass follows from the weight Gamma e.
    pub fn in_axes_of_a(&self) -> Gyrostat<Sym> {
        self.with_reduced_tensor(Matrix3::from_diagonal(&self.a))
    }

    /// The gyrostat in the principal axes of A*.
    pub fn in_axes_of_a_star(&self) -> Gyrostat<Sym> {
        let along = self.l * self.l.transpose();
        self.with_reduced_tensor(Matrix3::from_diagonal(&self.a_star) - along * self.axial)
    }

    /// The gyrostat in arbitrary axes with a given tensor A.
    pub fn with_reduced_tensor(&self, reduced: Matrix3<Sym>) -> Gyrostat<Sym> {
        let (h, along) = (self.h, self.l * self.l.transpose());
        let identity = Matrix3::<Sym>::identity();
        let of_rotor = (identity * h.dot(&h) - h * h.transpose()) * self.m_rotor + (identity - along) * self.transverse;
        let (mass, gravity) = (letter("m⁰"), letter("g"));
        Gyrostat {
            carrier: Carrier {
                mass,
                centre: (self.e * (self.big_gamma / gravity) - h * self.m_rotor) / mass,
                inertia: reduced - of_rotor,
            },
            rotor: self.rotor(),
            gravity,
        }
    }

    fn rotor(&self) -> Rotor<Sym> {
        Rotor { mass: self.m_rotor, centre: self.h, axis: self.l, axial: self.axial, transverse: self.transverse }
    }

    /// An instant of a motion with arbitrary accelerations.
    pub fn motion(&self) -> MotionInstant<Sym> {
        MotionInstant {
            angular_velocity: self.w,
            vertical: self.nu,
            rotor_speed: self.dphi,
            angular_acceleration: self.dw,
            rotor_acceleration: self.ddphi,
            torque: self.torque,
        }
    }

    /// An instant of a motion with the rotor's angle measured from the field: phi' = g' + W.
    pub fn motion_from_field(&self) -> MotionInstant<Sym> {
        MotionInstant { rotor_speed: self.dgamma + self.omega_field, rotor_acceleration: self.ddgamma, ..self.motion() }
    }

    /// A steady motion: w = w0 nu, all other rates zero, the rotor at a constant relative speed.
    pub fn stationary(&self, rotor_speed: Sym, torque: Sym) -> MotionInstant<Sym> {
        MotionInstant {
            angular_velocity: self.nu * self.omega0,
            vertical: self.nu,
            rotor_speed,
            angular_acceleration: Vector3::zeros(),
            rotor_acceleration: Sym::zero(),
            torque,
        }
    }

    /// The electric constants; friction is the torque M2 instead.
    pub fn windings(&self) -> Windings<Sym> {
        Windings {
            field_speed: self.omega_field,
            b0: self.b0,
            a1: letter("a1"),
            l1: letter("L1"),
            r1: letter("R1"),
            a2: letter("a2"),
            l2: letter("L2"),
            r2: letter("R2"),
            mu: letter("μ"),
            f: Sym::zero(),
        }
    }

    /// The paper's motor, with its bars at arbitrary angles; those of the paper are t_n = -pi/4 + 2 pi n/N.
    pub fn motor(&self, bars: u32) -> MultiCurrent<Sym> {
        let angle = |n| Sym::named(&format!("t{n}"), &format!("t_{{{n}}}"));
        MultiCurrent { windings: self.windings(), bars: (1..=bars).map(|n| angle(n).circle()).collect() }
    }

    /// The motor with N bars evenly spaced from -pi/4 on. N must divide 24, so that the angles have square roots of 2
    /// and 3 only.
    pub fn evenly_spaced(&self, bars: u32) -> MultiCurrent<Sym> {
        let back = Circle::exact_turn(1, 8).unwrap_or(Circle::zero());
        let bars = (1..=bars).filter_map(|n| Circle::exact_turn(n, bars)).map(|turn| turn - back).collect();
        MultiCurrent { windings: self.windings(), bars }
    }

    /// The angle g as a circle point.
    pub fn angle(&self) -> Circle<Sym> {
        self.gamma.circle()
    }

    /// The currents x, i1, i2, ...
    pub fn currents(&self, bars: u32) -> Vec<Sym> {
        std::iter::once(letter("x")).chain((1..=bars).map(current)).collect()
    }

    /// The vector A* nu x nu.
    pub fn tilt(&self) -> Vector3<Sym> {
        self.a_star.component_mul(&self.nu).cross(&self.nu)
    }

    /// V* as printed in (7.1).
    pub fn v_star(&self) -> Sym {
        self.quadratic(self.l)
    }

    /// S* as printed in (7.5).
    pub fn s_star(&self) -> Sym {
        self.quadratic(self.e)
    }

    fn quadratic(&self, d: Vector3<Sym>) -> Sym {
        let (a, n) = (self.a_star, self.nu);
        (a.y - a.z) * d.x * n.y * n.z + (a.z - a.x) * d.y * n.z * n.x + (a.x - a.y) * d.z * n.x * n.y
    }

    /// Delta* as printed in (7.1).
    pub fn delta_star(&self) -> Sym {
        let (a, n) = (self.a_star, self.nu);
        let term = |d: Sym, p: Sym, q: Sym| d.powi(2) * p.powi(2) * q.powi(2);
        term(a.y - a.z, n.y, n.z) + term(a.z - a.x, n.z, n.x) + term(a.x - a.y, n.x, n.y)
    }

    /// Pi* as printed in (7.6).
    pub fn pi_star(&self) -> Sym {
        let (e, u) = (self.e, self.l.cross(&self.nu));
        -(e.x * u.x) - e.y * u.y - e.z * u.z
    }

    /// The left-hand sides of (6.5) as printed.
    pub fn conditions(&self) -> Vector3<Sym> {
        let (a, n, w0) = (self.a_star, self.nu, self.omega0);
        let gyroscopic = self.axial * self.omega_field * w0;
        cyclic(|_, j, k| {
            (a[j] - a[k]) * w0.powi(2) * n[j] * n[k]
                + gyroscopic * (self.l[j] * n[k] - self.l[k] * n[j])
                + self.big_gamma * (self.e[j] * n[k] - self.e[k] * n[j])
        })
    }
}
