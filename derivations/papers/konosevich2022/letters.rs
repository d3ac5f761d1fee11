//! The paper's letters, with their dimensions, and the gyrostat written in them.

use crate::machines::multi_current::{MultiCurrent, Windings};
use crate::systems::gyrostat::{Carrier, Gyrostat, Motion, Rotor};
use field::{Analytic, Circle, Rational, Scalar};
use nalgebra::{Matrix3, Vector3};
use num_traits::{One, Zero};
use symbolic::{Dimension, Hypotheses, Sym};

/// (name, LaTeX, exponents of kg, m, s, A). A `#` at the end of a name stands for 1, 2, 3, two for a pair of them.
const LETTERS: &[(&str, &str, [i64; 4])] = &[
    ("ω#", r"\omega_#", [0, 0, -1, 0]),
    ("ω̇#", r"\dot\omega_#", [0, 0, -2, 0]),
    ("ν#", r"\nu_#", [0, 0, 0, 0]),
    ("ν̇#", r"\dot\nu_#", [0, 0, -1, 0]),
    ("l#", "l_#", [0, 0, 0, 0]),
    ("e#", "e_#", [0, 0, 0, 0]),
    ("h#", "h_#", [0, 1, 0, 0]),
    ("c⁰#", "c^0_#", [0, 1, 0, 0]),
    ("A#", "A_#", [1, 2, 0, 0]),
    ("A⋆#", "A^*_#", [1, 2, 0, 0]),
    ("x#", "x_#", [1, 2, -1, 0]),
    ("A⁰##", "A^0_{##}", [1, 2, 0, 0]),
    ("A⋆##", "A^*_{##}", [1, 2, 0, 0]),
    ("A##", "A_{##}", [1, 2, 0, 0]),
    ("m⁰", "m^0", [1, 0, 0, 0]),
    ("m′", "m'", [1, 0, 0, 0]),
    ("A′", "A'", [1, 2, 0, 0]),
    ("B′", "B'", [1, 2, 0, 0]),
    ("g", "g", [0, 1, -2, 0]),
    ("Γ", r"\Gamma", [1, 2, -2, 0]),
    ("φ̇′", r"\dot\varphi'", [0, 0, -1, 0]),
    ("φ̈′", r"\ddot\varphi'", [0, 0, -2, 0]),
    ("p′", "p'", [0, 0, -1, 0]),
    ("ṗ′", r"\dot p'", [0, 0, -2, 0]),
    ("M", "M", [1, 2, -2, 0]),
    ("M2", "M_2", [1, 2, -2, 0]),
    ("γ", r"\gamma", [0, 0, 0, 0]),
    ("γ̇", r"\dot\gamma", [0, 0, -1, 0]),
    ("γ̈", r"\ddot\gamma", [0, 0, -2, 0]),
    ("Ω", r"\Omega", [0, 0, -1, 0]),
    ("Ω′", r"\Omega'", [0, 0, -1, 0]),
    ("Ω⁰", r"\Omega^0", [0, 0, -1, 0]),
    ("ω⁰", r"\omega^0", [0, 0, -1, 0]),
    ("b0", "b_0", [1, 2, -2, 0]),
    ("c0", "c_0", [1, 2, -2, 0]),
    ("μ", r"\mu", [1, 2, -1, 0]),
    ("k", "k", [1, 2, -1, 0]),
    ("f", "f", [1, 2, -1, 0]),
    ("κ", r"\kappa", [1, 2, -1, 0]),
    ("Mk", "M_k", [1, 2, -2, 0]),
    ("sk", "s_k", [0, 0, 0, 0]),
    ("a1", "a_1", [1, 2, -2, -1]),
    ("a2", "a_2", [1, 2, -2, -1]),
    ("L1", "L_1", [1, 2, -2, -2]),
    ("L2", "L_2", [1, 2, -2, -2]),
    ("R1", "R_1", [1, 2, -3, -2]),
    ("R2", "R_2", [1, 2, -3, -2]),
    ("x", "x", [0, 0, 0, 1]),
    ("ẋ", r"\dot x", [0, 0, -1, 1]),
    ("D", "D", [0, 0, 0, 0]),
    ("det Ã", r"\det\tilde A", [3, 6, 0, 0]),
    ("V⋆", "V^*", [1, 2, 0, 0]),
    ("S⋆", "S^*", [1, 2, 0, 0]),
    ("Δ⋆", r"\Delta^*", [2, 4, 0, 0]),
    ("Π⋆", r"\Pi^*", [0, 0, 0, 0]),
    ("l⁰", "l^0", [0, 0, 0, 0]),
    // ours: Euler's angles, a quaternion, a direction, a scale, sines and cosines by name
    ("ψ", r"\psi", [0, 0, 0, 0]),
    ("θ", r"\theta", [0, 0, 0, 0]),
    ("φ", r"\varphi", [0, 0, 0, 0]),
    ("ψ̇", r"\dot\psi", [0, 0, -1, 0]),
    ("θ̇", r"\dot\theta", [0, 0, -1, 0]),
    ("φ̇", r"\dot\varphi", [0, 0, -1, 0]),
    ("φ′", r"\varphi'", [0, 0, 0, 0]),
    ("ψ̈", r"\ddot\psi", [0, 0, -2, 0]),
    ("θ̈", r"\ddot\theta", [0, 0, -2, 0]),
    ("φ̈", r"\ddot\varphi", [0, 0, -2, 0]),
    ("q0", "q_0", [0, 0, 0, 0]),
    ("q#", "q_#", [0, 0, 0, 0]),
    ("u#", "u_#", [0, 0, 0, 0]),
    ("t", "t", [0, 0, 0, 0]),
    ("r", "r", [0, 0, 0, 0]),
    ("C", "C", [0, 0, 0, 0]),
    ("c", "c", [0, 0, 0, 0]),
    ("s", "s", [0, 0, 0, 0]),
    ("ch", r"\cos h", [0, 0, 0, 0]),
    ("sh", r"\sin h", [0, 0, 0, 0]),
    ("cn", r"\cos 2nh", [0, 0, 0, 0]),
    ("sn", r"\sin 2nh", [0, 0, 0, 0]),
    ("ct", r"\cos t", [0, 0, 0, 0]),
    ("st", r"\sin t", [0, 0, 0, 0]),
    // ours: a multiplier with what it multiplies, moments of inertia
    ("λ", r"\lambda", [1, 2, -2, 0]),
    ("α#", r"\alpha_#", [1, 2, -2, 0]),
    ("δ#", r"\delta_#", [1, 2, -2, 0]),
    ("a", "a", [1, 2, 0, 0]),
    ("d#", "d_#", [1, 2, 0, 0]),
];

/// The dimension of a symbol of the paper; `None` for a name that the paper does not have.
pub fn dimension(name: &str) -> Option<Dimension> {
    let place = |[kg, m, s, a]: [i64; 4]| Dimension::of(kg, m, s, a);
    for (stem, exponents) in [("i̇", [0, 0, -1, 1]), ("i", [0, 0, 0, 1]), ("t", [0, 0, 0, 0])] {
        if name.strip_prefix(stem).is_some_and(|n| !n.is_empty() && n.chars().all(|c| c.is_ascii_digit())) {
            return Some(place(exponents));
        }
    }
    if name.starts_with("C") && name.len() == 3 {
        // the root of a moment of inertia
        return dimension("A′").map(|inertia| inertia.power(Rational::new(1, 2)));
    }
    LETTERS.iter().find(|(pattern, _, _)| matches(pattern, name)).map(|(_, _, exponents)| place(*exponents))
}

fn matches(pattern: &str, name: &str) -> bool {
    let stem = pattern.trim_end_matches('#');
    let places = pattern.len() - stem.len();
    name.strip_prefix(stem).is_some_and(|rest| rest.len() == places && rest.chars().all(|c| matches!(c, '1'..='3')))
}

/// The symbol of a letter; the LaTeX comes from the table.
pub fn letter(name: &str) -> Sym {
    let found = LETTERS.iter().find(|(pattern, _, _)| matches(pattern, name));
    found.map_or_else(
        || Sym::symbol(name),
        |(_, latex, _)| {
            let index: String = name.chars().filter(|c| matches!(c, '1'..='3')).collect();
            Sym::named(name, &latex.replace("##", &index).replace('#', &index))
        },
    )
}

/// The three components of a vector.
pub fn vector(stem: &str) -> Vector3<Sym> {
    Vector3::from_fn(|i, _| letter(&format!("{stem}{}", i + 1)))
}

/// A symmetric tensor with components 11, 22, 33, 12, 23, 31.
pub fn tensor(stem: &str) -> Matrix3<Sym> {
    let [a11, a22, a33, a12, a23, a31] = ["11", "22", "33", "12", "23", "31"].map(|ij| letter(&format!("{stem}{ij}")));
    Matrix3::new(a11, a12, a31, a12, a22, a23, a31, a23, a33)
}

/// Everything that the paper names.
pub struct Letters {
    pub w: Vector3<Sym>,
    pub dw: Vector3<Sym>,
    pub nu: Vector3<Sym>,
    pub l: Vector3<Sym>,
    pub e: Vector3<Sym>,
    pub h: Vector3<Sym>,
    /// principal moments of A
    pub a: Vector3<Sym>,
    /// principal moments of A*
    pub a_star: Vector3<Sym>,
    pub m_rotor: Sym,
    pub axial: Sym,
    pub transverse: Sym,
    pub big_gamma: Sym,
    pub dphi: Sym,
    pub ddphi: Sym,
    pub moment: Sym,
    pub gamma: Sym,
    pub dgamma: Sym,
    pub ddgamma: Sym,
    pub omega_field: Sym,
    pub omega0: Sym,
    pub b0: Sym,
    pub c0: Sym,
    /// |l| = 1
    pub unit_axis: Hypotheses,
    /// |nu| = 1
    pub unit_vertical: Hypotheses,
}

impl Letters {
    /// The symbols, made in the calling thread.
    pub fn new() -> Self {
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
            moment: letter("M"),
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

    /// The gyrostat in arbitrary axes, every datum a symbol.
    pub fn general(&self) -> Gyrostat<Sym> {
        Gyrostat {
            carrier: Carrier { mass: letter("m⁰"), centre: vector("c⁰"), inertia: tensor("A⁰") },
            rotor: self.rotor(),
            gravity: letter("g"),
        }
    }

    /// The gyrostat in the principal axes of A: the carrier's tensor is what the rotor leaves of diag(A1, A2, A3), and
    /// the carrier's centre what it leaves of the weight Gamma e.
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

    /// An instant with all accelerations free.
    pub fn motion(&self) -> Motion<Sym> {
        Motion {
            angular_velocity: self.w,
            vertical: self.nu,
            rotor_speed: self.dphi,
            angular_acceleration: self.dw,
            rotor_acceleration: self.ddphi,
            moment: self.moment,
        }
    }

    /// The same with the rotor's angle measured from the field: phi' = g' + W.
    pub fn motion_from_field(&self) -> Motion<Sym> {
        Motion { rotor_speed: self.dgamma + self.omega_field, rotor_acceleration: self.ddgamma, ..self.motion() }
    }

    /// A constant motion: w = w0 nu, everything else at rest, the rotor at a relative speed.
    pub fn stationary(&self, rotor_speed: Sym, moment: Sym) -> Motion<Sym> {
        Motion {
            angular_velocity: self.nu * self.omega0,
            vertical: self.nu,
            rotor_speed,
            angular_acceleration: Vector3::zeros(),
            rotor_acceleration: Sym::zero(),
            moment,
        }
    }

    /// The electric constants; friction is left to the moment M2.
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

    /// The paper's motor, with its bars at arbitrary angles: the paper's are t_n = -pi/4 + 2 pi n/N.
    pub fn motor(&self, bars: u32) -> MultiCurrent<Sym> {
        let angle = |n| Sym::named(&format!("t{n}"), &format!("t_{{{n}}}"));
        MultiCurrent { windings: self.windings(), bars: (1..=bars).map(|n| angle(n).circle()).collect() }
    }

    /// The same with its N bars evenly spaced from -pi/4 on; N divides 24, where the angles are roots of 2 and 3.
    pub fn evenly_spaced(&self, bars: u32) -> MultiCurrent<Sym> {
        let back = Circle::exact_turn(1, 8).unwrap_or(Circle::zero());
        let bars = (1..=bars).filter_map(|n| Circle::exact_turn(n, bars)).map(|turn| turn - back).collect();
        MultiCurrent { windings: self.windings(), bars }
    }

    /// The angle g as a circle point.
    pub fn angle(&self) -> Circle<Sym> {
        self.gamma.circle()
    }

    /// x, i1, i2, ...
    pub fn currents(&self, bars: u32) -> Vec<Sym> {
        std::iter::once(letter("x")).chain((1..=bars).map(|n| current(n))).collect()
    }

    /// A* nu x nu.
    pub fn tilt(&self) -> Vector3<Sym> {
        self.a_star.component_mul(&self.nu).cross(&self.nu)
    }

    /// V*, as printed in (7.1).
    pub fn v_star(&self) -> Sym {
        self.quadratic(self.l)
    }

    /// S*, as printed in (7.5).
    pub fn s_star(&self) -> Sym {
        self.quadratic(self.e)
    }

    fn quadratic(&self, d: Vector3<Sym>) -> Sym {
        let (a, n) = (self.a_star, self.nu);
        (a.y - a.z) * d.x * n.y * n.z + (a.z - a.x) * d.y * n.z * n.x + (a.x - a.y) * d.z * n.x * n.y
    }

    /// Delta*, as printed in (7.1).
    pub fn delta_star(&self) -> Sym {
        let (a, n) = (self.a_star, self.nu);
        let term = |d: Sym, p: Sym, q: Sym| d.powi(2) * p.powi(2) * q.powi(2);
        term(a.y - a.z, n.y, n.z) + term(a.z - a.x, n.z, n.x) + term(a.x - a.y, n.x, n.y)
    }

    /// Pi*, as printed in (7.6).
    pub fn pi_star(&self) -> Sym {
        let (e, u) = (self.e, self.l.cross(&self.nu));
        -(e.x * u.x) - e.y * u.y - e.z * u.z
    }

    /// The left sides of (6.5), as printed.
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

/// The current of a bar.
pub fn current(bar: u32) -> Sym {
    Sym::named(&format!("i{bar}"), &format!("i_{{{bar}}}"))
}

/// (1 2 3): a formula for the first component, and its cyclic permutations.
pub fn cyclic(formula: impl Fn(usize, usize, usize) -> Sym) -> Vector3<Sym> {
    Vector3::new(formula(0, 1, 2), formula(1, 2, 0), formula(2, 0, 1))
}

/// A rational constant.
pub fn number(numerator: i64, denominator: i64) -> Sym {
    Sym::ratio(numerator, denominator)
}

/// One as a symbol's value.
pub fn one() -> Sym {
    Sym::one()
}
