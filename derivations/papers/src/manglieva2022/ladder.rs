//! Task 2's ladder in the paper's symbols: the system of `systems/ladder.rs` with symbolic data.

use super::alphabet::{letter, letters, tidy};
use field::{Analytic, Circle, Scalar};
use mechanics::constrained::PointSystem;
use mechanics::constrained::contacts::{Closed, Contacts};
use mechanics::constrained::motion::Motion;
use mechanics::differentiate::{along, fixed, unit};
use symbolic::Sym;
use systems::ladder::{Ladder, LeaningLadder};

/// The symbols of task 2 and the ladder in these symbols, in the coordinates (x, y, c, s) of its centre and direction.
pub struct LadderLetters {
    pub ladder: LeaningLadder<Sym>,
    pub m: Sym,
    pub inertia: Sym,
    pub l: Sym,
    pub g: Sym,
    pub at_wall: Sym,
    pub at_floor: Sym,
    pub alpha: Sym,
    pub point: Circle<Sym>,
    pub dalpha: Sym,
    pub ddalpha: Sym,
}

/// The symbols, created in the calling thread.
impl Default for LadderLetters {
    fn default() -> Self {
        let [m, inertia, l, g, at_wall, at_floor] = letters(["m", "J", "l", "g", "fA", "fB"]);
        let ladder = Ladder { mass: m, inertia, half_length: l, gravity: g, friction: [at_wall, at_floor] };
        let alpha = letter("α");
        LadderLetters {
            ladder: Closed(ladder),
            m,
            inertia,
            l,
            g,
            at_wall,
            at_floor,
            alpha,
            point: alpha.circle(),
            dalpha: letter("α̇"),
            ddalpha: letter("α̈"),
        }
    }
}

/// The forces of unit reactions in the coordinates: normal and tangential, at the wall and at the floor.
#[derive(Clone, Copy, Debug)]
pub struct Pushes {
    pub normal: [[Sym; 4]; 2],
    pub tangential: [[Sym; 4]; 2],
}

impl LadderLetters {
    /// The motion by the chart q = alpha, p = alpha'.
    pub fn motion(&self) -> Motion<Sym, 4, 1> {
        Motion::at(&self.ladder, Sym::ZERO, [self.alpha], [self.dalpha])
    }

    /// The gradients of gap and position along the curve for each contact.
    pub fn pushes(&self) -> Pushes {
        let place = self.motion().state.place;
        let mut pushes = Pushes { normal: [[Sym::ZERO; 4]; 2], tangential: [[Sym::ZERO; 4]; 2] };
        for i in 0..4 {
            let moved = self.ladder.0.contacts(fixed([Sym::ZERO])[0], along(place, unit(i)));
            for (k, contact) in moved.into_iter().enumerate() {
                pushes.normal[k][i] = contact.gap.slope;
                pushes.tangential[k][i] = contact.along.slope;
            }
        }
        pushes
    }

    /// The forces of normal reactions and friction. The paper counts friction positive upwards at A and towards O at B.
    pub fn reactions(&self, normal: [Sym; 2], friction: [Sym; 2]) -> [Sym; 4] {
        let Pushes { normal: across, tangential } = self.pushes();
        std::array::from_fn(|i| {
            normal[0] * across[0][i] + normal[1] * across[1][i] + friction[0] * tangential[0][i]
                - friction[1] * tangential[1][i]
        })
    }

    /// The residuals m x'' - X - reactions in each coordinate; rigidity balances the last two.
    pub fn newton(&self, acceleration: [Sym; 4], reactions: [Sym; 4]) -> [Sym; 4] {
        let (masses, weight): ([Sym; 4], [Sym; 4]) = (self.ladder.masses(), self.ladder.force(&self.motion().state));
        std::array::from_fn(|i| masses[i] * acceleration[i] - weight[i] - reactions[i])
    }

    /// The accelerations of the coordinates for alpha''.
    pub fn turning(&self) -> [Sym; 4] {
        self.motion().acceleration([self.ddalpha])
    }

    /// The normal reactions with sliding friction f_A N_A, f_B N_B, by the theorem of the centre of mass.
    pub fn normal_reactions(&self) -> [Sym; 2] {
        self.normal_reactions_at(self.turning())
    }

    /// The normal reactions for given accelerations of the coordinates.
    pub fn normal_reactions_at(&self, acceleration: [Sym; 4]) -> [Sym; 2] {
        let Pushes { normal, tangential } = self.pushes();
        let missing = self.newton(acceleration, [Sym::ZERO; 4]);
        let column = |k: usize, way: i64, friction: Sym| {
            [0, 1].map(|i| normal[k][i] + Sym::int(way) * friction * tangential[k][i])
        };
        let (a, b) = (column(0, 1, self.at_wall), column(1, -1, self.at_floor));
        let det = a[0] * b[1] - a[1] * b[0];
        [(missing[0] * b[1] - missing[1] * b[0]) / det, (a[0] * missing[1] - a[1] * missing[0]) / det].map(tidy)
    }

    /// The forces of normal reactions with sliding friction.
    pub fn sliding(&self, [wall, floor]: [Sym; 2]) -> [Sym; 4] {
        self.reactions([wall, floor], [self.at_wall * wall, self.at_floor * floor])
    }

    /// The residual of the equation of motion along the chart, with sliding friction at both ends.
    pub fn balance(&self) -> Sym {
        let [balance] = self.motion().generalised(self.newton(self.turning(), self.sliding(self.normal_reactions())));
        balance
    }

    /// The acceleration alpha'' by the equation of motion, which is linear in it.
    pub fn acceleration(&self) -> Sym {
        let balance = self.balance();
        let still = balance.substitute(&[(self.ddalpha, Sym::ZERO)]);
        tidy(-(still / tidy(balance.diff(self.ddalpha))))
    }

    /// An expression for the uniform ladder with a common friction coefficient f.
    pub fn uniform(&self, expression: Sym) -> Sym {
        let f = letter("f");
        let third = self.m * self.l.powi(2) / Sym::int(3);
        expression.substitute(&[(self.at_wall, f), (self.at_floor, f), (self.inertia, third)])
    }
}
