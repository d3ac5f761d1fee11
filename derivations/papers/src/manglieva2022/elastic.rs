//! Chapter 3's governor with an elastic rim in the paper's symbols: `systems/elastic_governor.rs` with symbolic data.

use super::alphabet::{int, letter, letters, tidy};
use field::Scalar;
use mechanics::constrained::appell::residual;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::{Charted, PointSystem, kinetic_energy};
use symbolic::{Hypotheses, Sym};
use systems::elastic_governor::ElasticGovernor;

/// The interpretation of the signs of the rim's force and torque up to (3.22).
pub const AS_PRINTED: &str = r"The claim is judged with the printed force $+a\lambda$ and moment $+b\psi$. A rim that resists then has $a<0$, $b<0$. The printed $Z$ belongs to $-a\lambda$.";

/// The interpretation of these signs from Z on.
pub const AS_STIFFNESS: &str = r"The claim is judged for a rim that resists, with the force $-a\lambda$ and the moment $-b\psi$, $a>0$, $b>0$. The printed $Z$ belongs to it, the printed $+a\lambda$ of (3.17) does not.";

/// The symbols of the elastic governor; the paper's r1 is R, the radius of the drum.
pub struct ElasticLetters {
    pub governor: ElasticGovernor<Sym>,
    pub inertia: [Sym; 3],
    pub drum: Sym,
    pub wheel: Sym,
    pub offset: Sym,
    pub sleeve: Sym,
    pub ball: Sym,
    pub link: Sym,
    pub moments: [Sym; 2],
    pub springs: [Sym; 2],
    pub tensions: [Sym; 2],
    pub rest: Sym,
    pub a: Sym,
    pub b: Sym,
    pub drill: Sym,
    pub alpha: Sym,
    pub beta: Sym,
    /// The state omega1, x, x', lambda, psi.
    pub state: [Sym; 5],
    /// The accelerations omega1', x''.
    pub rates: [Sym; 2],
    /// Appell's equations of omega1 and x: left-hand side minus right-hand side.
    pub balance: [Sym; 2],
}

impl Default for ElasticLetters {
    fn default() -> Self {
        let inertia = letters(["J1", "J2", "J"]);
        let [drum, wheel, offset, sleeve, ball, link] = letters(["R", "r", "c", "m", "mₛ", "l"]);
        let (moments, springs, tensions) = (letters(["M1", "M2"]), letters(["c1", "c2"]), letters(["δ1", "δ2"]));
        let [rest, a, b, drill, alpha, beta] = letters(["x₀", "aᵉ", "bᵉ", "dᵉ", "αᵉ", "β"]);
        let governor = ElasticGovernor {
            drum_inertia: inertia[0],
            disc_inertia: inertia[1],
            wheel_inertia: inertia[2],
            drum,
            wheel,
            offset,
            sleeve,
            ball,
            link,
            m1: moments[0],
            m2: moments[1],
            c1: springs[0],
            c2: springs[1],
            delta1: tensions[0],
            delta2: tensions[1],
            rest,
            across: a,
            twist: b,
            drill,
            alpha,
            beta,
            rim_mass: Sym::ZERO,
            rim_inertia: Sym::ZERO,
        };
        let (state, rates) = (letters(["ω1", "x", "ẋ", "λᵉ", "ψ"]), letters(["ω̇1", "ẍ"]));
        let motion = motion(&governor, state);
        let balance = residual(&governor, &motion, governor.force(&motion.state), rates).map(tidy);
        ElasticLetters {
            governor,
            inertia,
            drum,
            wheel,
            offset,
            sleeve,
            ball,
            link,
            moments,
            springs,
            tensions,
            rest,
            a,
            b,
            drill,
            alpha,
            beta,
            state,
            rates,
            balance,
        }
    }
}

/// The motion at a position where the drum's direction is along the axis.
fn motion(governor: &ElasticGovernor<Sym>, [speed, x, drift, lambda, psi]: [Sym; 5]) -> Motion<Sym, 12, 2> {
    let zero = Sym::ZERO;
    Motion::at(governor, zero, [zero, zero, zero, x, lambda, psi], [speed, drift])
}

impl ElasticLetters {
    pub fn motion(&self) -> Motion<Sym, 12, 2> {
        motion(&self.governor, self.state)
    }

    /// The acceleration energy S = 1/2 sum m a^2 of discs, sleeve and balls.
    pub fn acceleration_energy(&self) -> Sym {
        kinetic_energy(self.governor.masses(), self.motion().acceleration(self.rates))
    }

    /// The rates phi2', lambda', psi' by the constraints.
    pub fn rolling(&self) -> [Sym; 3] {
        let ([speed, x, drift, lambda, psi], zero) = (self.state, Sym::ZERO);
        let [_, second, _, _, across, turn] =
            self.governor.rates(zero, [zero, zero, zero, x, lambda, psi], [speed, drift]);
        [second, across, turn]
    }

    /// The generalised forces of omega1 and x.
    pub fn work(&self) -> [Sym; 2] {
        let motion = self.motion();
        motion.generalised(self.governor.force(&motion.state))
    }

    /// The lengths x - c and 4 l^2 - x^2.
    pub fn lengths(&self, x: Sym) -> [Sym; 2] {
        [x - self.offset, int(4) * self.link.squared() - x.squared()]
    }

    /// The moment of inertia theta(x) of the paper.
    pub fn theta(&self, x: Sym) -> Sym {
        let ([first, second, third], [rho, height]) = (self.inertia, self.lengths(x));
        let drum = self.drum.powi(2);
        second * drum / rho.powi(2) + first + third * drum / self.wheel.powi(2) + self.ball.half() * height
    }

    /// The function F(x) with its sign: -(J2 R^2/(x - c)^3 + m_sp x).
    pub fn coupling(&self, x: Sym) -> Sym {
        let [rho, _] = self.lengths(x);
        -(self.inertia[1] * self.drum.powi(2) / rho.powi(3) + self.ball * x)
    }

    /// The reduced mass m(x) with the mass m of the sleeve: m + 2 m_sp l^2/(4 l^2 - x^2).
    pub fn mobile(&self, x: Sym) -> Sym {
        let [_, height] = self.lengths(x);
        self.sleeve + int(2) * self.ball * self.link.powi(2) / height
    }

    /// An expression at the steady motion: omega1 = omega_0, x = x_0, everything else zero.
    pub fn stationary(&self, expression: Sym) -> Sym {
        let ([w, x, drift, lambda, psi], [spin, push]) = (self.state, self.rates);
        let zero = Sym::ZERO;
        let rest = [(drift, zero), (lambda, zero), (psi, zero), (spin, zero), (push, zero)];
        tidy(expression.substitute(&rest).substitute(&[(w, letter("ω₀")), (x, self.rest)]))
    }

    /// The two equations of motion and the two constraints of the rim, linearised at the steady motion: the
    /// coefficients of omega1', x', lambda, psi as polynomials in mu, by differentiation.
    pub fn characteristic_matrix(&self) -> [[Sym; 4]; 4] {
        let ([w, x, drift, lambda, psi], [spin, push]) = (self.state, self.rates);
        let [_, across, turn] = self.rolling();
        let mu = letter("μᵉ");
        let equations = [self.balance[0], self.balance[1], across, turn];
        let mut matrix = equations.map(|equation| {
            let of = |variable: Sym| self.stationary(equation.diff(variable));
            [of(spin) * mu + of(w), of(push) * mu.powi(2) + of(drift) * mu + of(x), of(lambda), of(psi)]
        });
        // the rim's equations are given by rates: x' - ... - lambda' = 0 and psi' - ... = 0
        matrix[2][2] -= mu;
        matrix[3] = matrix[3].map(|entry| -entry);
        matrix[3][3] += mu;
        matrix
    }

    /// The values of the given symbols at the steady motion, with d = -b as printed in (3.17).
    pub fn names(&self, wanted: &[&str]) -> Hypotheses {
        self.named(wanted, Hypotheses::none().given(self.drill, -self.b))
    }

    /// The values of the given symbols for a resisting rim, whose torque on the disc is b psi.
    pub fn names_of_stiffness(&self, wanted: &[&str]) -> Hypotheses {
        self.named(wanted, Hypotheses::none())
    }

    /// An expression of (3.17) with the signs of a resisting rim: -a lambda, -b psi, and b psi on the disc.
    pub fn resisting(&self, expression: Sym) -> Sym {
        tidy(expression.substitute(&[(self.drill, -self.b)]).substitute(&[(self.a, -self.a), (self.b, -self.b)]))
    }

    fn named(&self, wanted: &[&str], base: Hypotheses) -> Hypotheses {
        let (x, w) = (self.rest, letter("ω₀"));
        let [distance, _] = self.lengths(x);
        let stiffness = self.ball.half() * w.powi(2) + self.springs[0] + self.springs[1];
        let meanings = [
            ("θ₀", self.theta(x)),
            ("m₀", self.mobile(x)),
            ("V", self.drum * w),
            ("α₁", self.drum * w * self.alpha),
            ("β₁", self.drum * w * self.beta),
            ("Φ₁", self.coupling(x) * w),
            ("Φ₂", self.drum / distance.powi(2) * self.moments[1]),
            ("Φ₃", self.ball * x * w),
            ("Φ₄", stiffness),
            ("ϱ₀", distance),
            ("Fˣ", self.coupling(x)),
        ];
        let asked = meanings.into_iter().filter(|(name, _)| wanted.contains(name));
        asked.fold(base, |names, (name, meaning)| names.given(letter(name), meaning))
    }
}
