//! Section 1.1's rod in the paper's symbols: the system of `systems/rod.rs` with symbolic data.

use super::alphabet::{letter, letters, tidy};
use super::general::or_undefined;
use field::{Analytic, Circle, Over};
use mechanics::constrained::combining::{Combined, extended, painleve};
use mechanics::constrained::contacts::{Closed, Sides};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::rates::{jacobian, rates};
use mechanics::constrained::{Charted, PointSystem, State};
use symbolic::Sym;
use systems::rod::{GuidedRod, Rod};

/// The symbols of section 1.1 and the rod in these symbols, in the coordinates (x, y, x1, y1); y points downwards.
pub struct RodLetters {
    pub rod: GuidedRod<Sym>,
    pub m: Sym,
    pub m1: Sym,
    pub l: Sym,
    pub g: Sym,
    pub f: Sym,
    pub x: Sym,
    pub theta: Sym,
    pub point: Circle<Sym>,
    pub dx: Sym,
    pub ddx: Sym,
    pub dtheta: Sym,
    pub ddtheta: Sym,
    pub lambda: Sym,
    pub lambda1: Sym,
    pub mu: Sym,
}

/// The rod without its guide: q = (x, y, theta), p = q'.
#[derive(Clone, Copy, Debug)]
pub struct Released(pub Rod<Sym>);

impl PointSystem<4> for Released {
    type Given = Sym;

    fn masses<S: Over<Sym>>(&self) -> [S; 4] {
        self.0.masses()
    }

    fn force<S: Over<Sym>>(&self, at: &State<S, 4>) -> [S; 4] {
        self.0.force(at)
    }
}

impl Charted<4, 3, 3> for Released {
    fn place<S: Over<Sym> + Analytic>(&self, time: S, [x, y, theta]: [S; 3]) -> [S; 4] {
        let [x, on_guide, x1, y1] = self.0.place(time, [x, theta]);
        [x, on_guide + y, x1, y1 + y]
    }

    fn rates<S: Over<Sym> + Analytic>(&self, _time: S, _q: [S; 3], p: [S; 3]) -> [S; 3] {
        p
    }
}

/// The symbols, created in the calling thread.
impl Default for RodLetters {
    fn default() -> Self {
        let [m, m1, l, g, f] = letters(["m", "m1", "l", "g", "f"]);
        let rod = Rod { guided: m, free: m1, length: l, gravity: g, friction: f, sides: Sides::One };
        let theta = letter("θ");
        RodLetters {
            rod: Closed(rod),
            m,
            m1,
            l,
            g,
            f,
            x: letter("x"),
            theta,
            point: theta.circle(),
            dx: letter("ẋ"),
            ddx: letter("ẍ"),
            dtheta: letter("θ̇"),
            ddtheta: letter("θ̈"),
            lambda: letter("λ"),
            lambda1: letter("λ1"),
            mu: letter("μ"),
        }
    }
}

impl RodLetters {
    /// The motion by the chart q = (x, theta), p = q'.
    pub fn motion(&self) -> Motion<Sym, 4, 2> {
        Motion::at(&self.rod, Sym::ZERO, [self.x, self.theta], [self.dx, self.dtheta])
    }

    /// The accelerations of both points for x'', theta''.
    pub fn acceleration(&self) -> [Sym; 4] {
        self.motion().acceleration([self.ddx, self.ddtheta])
    }

    fn state(&self) -> State<Sym, 4> {
        self.motion().state
    }

    /// The weights.
    pub fn given_force(&self) -> [Sym; 4] {
        self.rod.force(&self.state())
    }

    /// The unit forces of rod and guide, with the signs of the paper's lambda_1 and lambda.
    fn directions(&self) -> [[Sym; 4]; 2] {
        let [length, guide] = jacobian(&self.rod, &self.state());
        [length.map(|row| row / self.l), guide.map(|row| -row)]
    }

    /// The constraint forces.
    pub fn of_constraints(&self, lambda1: Sym, lambda: Sym) -> [Sym; 4] {
        let [along, across] = self.directions();
        std::array::from_fn(|i| lambda1 * along[i] + lambda * across[i])
    }

    /// The reactions: the guide's (R_x, R_y) on M, and R_1 along the rod.
    pub fn reactions(&self, [rx, ry, r1]: [Sym; 3]) -> [Sym; 4] {
        let Circle { cos, sin } = self.point;
        [rx - r1 * cos, ry - r1 * sin, r1 * cos, r1 * sin]
    }

    /// The extended decomposition of the reactions (R_x, R_y, R_1).
    pub fn extended(&self, reactions: [Sym; 3]) -> Combined<Sym, 4, 2> {
        or_undefined(extended(self.rod.masses(), self.directions(), self.reactions(reactions)))
    }

    /// Painleve's decomposition of the reactions.
    pub fn painleve(&self, reactions: [Sym; 3]) -> Combined<Sym, 4, 2> {
        or_undefined(painleve(self.directions(), self.reactions(reactions)))
    }

    /// The multipliers (lambda_1, lambda) under the weights and friction, by Lagrange's equations of the first kind.
    pub fn multipliers(&self, friction: [Sym; 4]) -> [Sym; 2] {
        let weights = self.given_force();
        let force = std::array::from_fn(|i| weights[i] + friction[i]);
        let [length, gap] = match multipliers(&self.rod, &self.state(), force) {
            Ok(reaction) => reaction.multipliers,
            Err(_) => [Sym::UNDEFINED; 2],
        };
        [length * self.l, -gap].map(tidy)
    }

    /// The second derivative of the length constraint, for given accelerations of the points.
    pub fn stretch(&self, acceleration: [Sym; 4]) -> Sym {
        let [length, _] = rates(&self.rod, &self.state(), acceleration);
        length
    }

    /// The residuals m x'' - X - R^n - R^tau in each coordinate.
    pub fn newton(&self, acceleration: [Sym; 4], friction: [Sym; 4]) -> [Sym; 4] {
        let (masses, weights): ([Sym; 4], _) = (self.rod.masses(), self.given_force());
        let normal = self.of_constraints(self.lambda1, self.lambda);
        std::array::from_fn(|i| masses[i] * acceleration[i] - weights[i] - normal[i] - friction[i])
    }

    /// The extended friction force, with the paper's mu: R_x = mu (m + m1 cos^2 theta).
    pub fn friction(&self) -> [Sym; 4] {
        self.extended([self.mu * self.mobile(), Sym::ZERO, Sym::ZERO]).of_friction
    }

    /// The guide's (R_x, R_y) from lambda and mu: the rod's internal forces are opposite at its ends and cancel in the
    /// sums.
    pub fn contact(&self) -> [Sym; 2] {
        let (normal, friction) = (self.of_constraints(self.lambda1, self.lambda), self.friction());
        [0, 1].map(|i| tidy(normal[i] + friction[i] + normal[i + 2] + friction[i + 2]))
    }

    /// The guide's (R_x, R_y) from the motion: the sums of m x'' - X over both points.
    pub fn contact_by(&self, acceleration: [Sym; 4]) -> [Sym; 2] {
        let (masses, weights): ([Sym; 4], _) = (self.rod.masses(), self.given_force());
        [0, 1].map(|axis| {
            [axis, axis + 2].into_iter().fold(Sym::ZERO, |sum, i| sum + masses[i] * acceleration[i] - weights[i])
        })
    }

    /// The mu of the law R_x = sign f R_y, for a multiplier: the contact reactions are linear in mu.
    pub fn mu_by_law(&self, sign: Sym, lambda: Sym) -> Sym {
        let [rx, ry] = self.contact();
        let excess = (rx - sign * self.f * ry).substitute(&[(self.lambda, lambda)]);
        -(excess.substitute(&[(self.mu, Sym::ZERO)]) / excess.diff(self.mu))
    }

    /// The factor m + m1 cos^2 theta.
    pub fn mobile(&self) -> Sym {
        self.m + self.m1 * self.point.cos.powi(2)
    }
}
