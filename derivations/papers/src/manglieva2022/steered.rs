//! Task 1's steered rod in the paper's symbols: the system of `systems/steered_rod.rs` with symbolic data.

use super::alphabet::{letter, letters, tidy};
use super::general::or_undefined;
use field::{Analytic, Circle};
use mechanics::constrained::combining::{Combined, extended, painleve};
use mechanics::constrained::contacts::{Closed, Sides};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::rates::{jacobian, rates};
use mechanics::constrained::{Constrained, PointSystem, State};
use symbolic::Sym;
use systems::steered_rod::{GuidedSteeredRod, SteeredRod};

/// The symbols of task 1 and the steered rod in these symbols, in the coordinates (x1, y1, x2, y2); y points downwards.
pub struct SteeredLetters {
    pub rod: GuidedSteeredRod<Sym>,
    pub m1: Sym,
    pub m2: Sym,
    pub l: Sym,
    pub g: Sym,
    pub f: Sym,
    pub drive: Sym,
    pub x1: Sym,
    pub theta: Sym,
    pub point: Circle<Sym>,
    pub dx1: Sym,
    pub ddx1: Sym,
    pub dtheta: Sym,
    pub ddtheta: Sym,
    pub lambda: Sym,
    pub lambda1: Sym,
    pub lambda2: Sym,
    pub mu: Sym,
}

/// The symbols, created in the calling thread.
impl Default for SteeredLetters {
    fn default() -> Self {
        let [m1, m2, l, g, f, drive] = letters(["m1", "m2", "l", "g", "f", "X"]);
        let rod = SteeredRod { guided: m1, free: m2, length: l, gravity: g, drive, friction: f, sides: Sides::One };
        let theta = letter("θ");
        SteeredLetters {
            rod: Closed(rod),
            m1,
            m2,
            l,
            g,
            f,
            drive,
            x1: letter("x1"),
            theta,
            point: theta.circle(),
            dx1: letter("ẋ1"),
            ddx1: letter("ẍ1"),
            dtheta: letter("θ̇"),
            ddtheta: letter("θ̈"),
            lambda: letter("λ"),
            lambda1: letter("λ1"),
            lambda2: letter("λ2"),
            mu: letter("μ"),
        }
    }
}

/// The unit reactions with the paper's signs: along the rod, perpendicular to it (equal at both ends), at the guide.
type Directions = [[Sym; 4]; 3];

impl SteeredLetters {
    /// The motion by the chart q = (x1, theta), p = x1'.
    pub fn motion(&self) -> Motion<Sym, 4, 1> {
        Motion::at(&self.rod, Sym::ZERO, [self.x1, self.theta], [self.dx1])
    }

    /// theta' expressed by x1', from the constraint of the middle.
    pub fn turning(&self) -> Sym {
        self.root_of_middle(self.dtheta)
    }

    /// x1' expressed by theta', from the constraint of the middle.
    pub fn speed(&self) -> Sym {
        self.root_of_middle(self.dx1)
    }

    /// Solves the constraint of the middle, which is linear, for one velocity.
    fn root_of_middle(&self, velocity: Sym) -> Sym {
        let middle = self.middle();
        -(tidy(middle.substitute(&[(velocity, Sym::ZERO)])) / tidy(middle.diff(velocity)))
    }

    /// The weights and the force X.
    pub fn given_force(&self) -> [Sym; 4] {
        self.rod.force(&self.motion().state)
    }

    fn directions(&self) -> Directions {
        let [length, middle, guide] = jacobian(&self.rod, &self.motion().state);
        [length.map(|row| row / self.l), middle.map(|row| row / self.l), guide.map(|row| -row)]
    }

    /// The constraint forces.
    pub fn of_constraints(&self, multipliers: [Sym; 3]) -> [Sym; 4] {
        let directions = self.directions();
        std::array::from_fn(|i| (0..3).fold(Sym::ZERO, |sum, k| sum + multipliers[k] * directions[k][i]))
    }

    /// The constraint forces for the symbols lambda_1, lambda_2, lambda.
    pub fn named_constraints(&self) -> [Sym; 4] {
        self.of_constraints([self.lambda1, self.lambda2, self.lambda])
    }

    /// The reactions (R_x, R_y, R_21, R_22): of the guide on M1, along the rod and perpendicular to it on both points.
    fn reactions(&self, [rx, ry, along, across]: [Sym; 4]) -> [Sym; 4] {
        let rod = self.of_constraints([along, across, Sym::ZERO]);
        [rod[0] + rx, rod[1] + ry, rod[2], rod[3]]
    }

    /// The extended decomposition of the reactions.
    pub fn extended(&self, reactions: [Sym; 4]) -> Combined<Sym, 4, 3> {
        or_undefined(extended(self.rod.masses(), self.directions(), self.reactions(reactions)))
    }

    /// Painleve's decomposition of the reactions.
    pub fn painleve(&self, reactions: [Sym; 4]) -> Combined<Sym, 4, 3> {
        or_undefined(painleve(self.directions(), self.reactions(reactions)))
    }

    /// The extended friction force, with the paper's mu: R_x = (m1 + m2) mu.
    pub fn friction(&self) -> [Sym; 4] {
        let rx = (self.m1 + self.m2) * self.mu;
        self.extended([rx, Sym::ZERO, Sym::ZERO, Sym::ZERO]).of_friction.map(tidy)
    }

    /// The multipliers (lambda_1, lambda_2, lambda) under the given forces and friction, in the symbols theta' and x1'.
    pub fn multipliers(&self, friction: [Sym; 4]) -> [Sym; 3] {
        let given = self.given_force();
        let force = std::array::from_fn(|i| given[i] + friction[i]);
        match multipliers(&self.rod, &self.state(), force) {
            Ok(reaction) => {
                let [length, middle, gap] = reaction.multipliers;
                [length * self.l, middle * self.l, -gap].map(tidy)
            }
            Err(_) => [Sym::UNDEFINED; 3],
        }
    }

    /// The state with x1' and theta' as independent symbols, as in the paper before (1.88).
    pub fn state(&self) -> State<Sym, 4> {
        let Circle { cos, sin } = self.point;
        let (place, across) = (self.motion().state.place, self.l * self.dtheta);
        let velocity = [self.dx1, Sym::ZERO, self.dx1 - across * sin, across * cos];
        State { time: Sym::ZERO, place, velocity }
    }

    /// The second derivatives of the constraints of length and middle, for the accelerations of Newton's equations.
    pub fn differentiated(&self, friction: [Sym; 4]) -> [Sym; 3] {
        let (masses, given): ([Sym; 4], _) = (self.rod.masses(), self.given_force());
        let normal = self.named_constraints();
        let acceleration = std::array::from_fn(|i| (given[i] + normal[i] + friction[i]) / masses[i]);
        rates(&self.rod, &self.state(), acceleration)
    }

    /// The constraint of the middle for the symbols x1' and theta', divided by -l.
    pub fn middle(&self) -> Sym {
        let [_, middle, _] = self.rod.constraints(&self.state()).map(|constraint| constraint.value());
        -middle / self.l
    }

    /// The residuals m x'' - X - R^n - R^tau in each coordinate.
    pub fn newton(&self, acceleration: [Sym; 4], friction: [Sym; 4]) -> [Sym; 4] {
        let (masses, given): ([Sym; 4], _) = (self.rod.masses(), self.given_force());
        let normal = self.named_constraints();
        std::array::from_fn(|i| masses[i] * acceleration[i] - given[i] - normal[i] - friction[i])
    }
}
