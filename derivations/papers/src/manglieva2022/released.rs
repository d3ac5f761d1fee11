//! Section 3.2's released governor in the paper's symbols: its linearisation and its optimal regulator.

use super::alphabet::{letter, letters, tidy};
use super::governor::GovernorLetters;
use mechanics::bellman::Regulator;
use symbolic::{Hypotheses, Sym};
use systems::governor::released::LinearisedEquations;

/// The released governor near its programmed motion.
pub struct ReleasedLetters {
    pub drum: GovernorLetters,
    /// The equations x' = A x + b u1 of x = (zeta, rho', z), with M2 expressed by the programmed rho'.
    pub linear: LinearisedEquations<Sym>,
    pub rho: Sym,
    pub drho: Sym,
    pub n: Sym,
    /// The deviation (zeta, rho', z).
    pub deviation: [Sym; 3],
    pub control: Sym,
    /// The matrix of V in the paper's symbols: C22 belongs to z, C33 to rho'.
    pub value: [[Sym; 3]; 3],
    /// The weights q1 of zeta, q2 of z, q3 of rho', s of u1, which represent the units of the criterion.
    pub weights: [Sym; 4],
}

impl Default for ReleasedLetters {
    fn default() -> Self {
        let drum = GovernorLetters::with_drum();
        let [rho, drho, n, control] = letters(["ϱ₀", "ϱ̇₀", "n", "u₁"]);
        let programme = drum.reduced() * rho * drum.speed * drho - rho * drum.m1 / drum.drum;
        let at = [drum.speed, rho, drho];
        let undefined = [[Sym::ONE / Sym::ZERO; 3]; 3];
        let raw = drum.governor.linearised(Sym::ZERO, at);
        let raw = raw.unwrap_or(LinearisedEquations { matrix: undefined, control: undefined[0] });
        let on_programme = |entry: Sym| tidy(entry.substitute(&[(drum.m2, programme)]));
        let linear = LinearisedEquations {
            matrix: raw.matrix.map(|row| row.map(on_programme)),
            control: raw.control.map(on_programme),
        };
        let [c11, c22, c33, c12, c13, c23] = letters(["C₁₁", "C₂₂", "C₃₃", "C₁₂", "C₁₃", "C₂₃"]);
        ReleasedLetters {
            drum,
            linear,
            rho,
            drho,
            n,
            deviation: letters(["ζ", "ϱ′", "z"]),
            control,
            value: [[c11, c12, c13], [c12, c33, c23], [c13, c23, c22]],
            weights: letters(["q₁", "q₂", "q₃", "s"]),
        }
    }
}

impl ReleasedLetters {
    /// The value n = J1/R^2 + J/r^2.
    pub fn names(&self) -> Hypotheses {
        Hypotheses::none().given(self.n, self.drum.reduced())
    }

    /// The inertia n rho_0^2 + J2.
    pub fn inertia(&self) -> Sym {
        self.n * self.rho.powi(2) + self.drum.second
    }

    /// The coefficient S1 = M1/R - n omega2 rho_0'.
    pub fn slope(&self) -> Sym {
        self.drum.m1 / self.drum.drum - self.n * self.drum.speed * self.drho
    }

    /// The derivative d/dt along the programmed motion of an expression in rho_0, rho_0', M1.
    pub fn along_programme(&self, expression: Sym) -> Sym {
        let [second, growth] = letters(["ϱ̈₀", "Ṁ1"]);
        let moving = [(self.rho, self.drho), (self.drho, second), (self.drum.m1, growth)];
        tidy(moving.iter().fold(Sym::ZERO, |sum, (of, rate)| sum + expression.diff(*of) * *rate))
    }

    /// Krasovskii's vectors L1 = b and L_(k+1) = dL_k/dt - P L_k.
    pub fn krasovskii(&self) -> [[Sym; 3]; 3] {
        let next = |column: [Sym; 3]| -> [Sym; 3] {
            let turned = self.linear.apply(column);
            std::array::from_fn(|i| tidy(self.along_programme(column[i]) - turned[i]))
        };
        let first = self.linear.control;
        let second = next(first);
        [first, second, next(second)]
    }

    /// The regulator of the criterion with its units as weights.
    pub fn regulator(&self) -> Regulator<Sym, 3> {
        let [of_speed, of_drift, of_place, price] = self.weights;
        Regulator {
            matrix: self.linear.matrix,
            control: self.linear.control,
            weights: [of_speed, of_place, of_drift],
            price,
        }
    }

    /// The values n1 = n/(n rho_0^2 + J2), S1' = S1/(n rho_0^2 + J2), and n.
    pub fn normal_names(&self) -> Hypotheses {
        let inertia = self.drum.reduced() * self.rho.powi(2) + self.drum.second;
        let slope = self.drum.m1 / self.drum.drum - self.drum.reduced() * self.drum.speed * self.drho;
        self.names().given(letter("n₁"), self.drum.reduced() / inertia).given(letter("S₁′"), slope / inertia)
    }
}
