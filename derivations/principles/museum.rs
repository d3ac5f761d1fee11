//! Appell's equations made by writing q'' for q' in the kinetic energy.

use super::alphabet::letters;
use claims::{Condition, Line, Page};
use field::{Analytic, Base, Over, Tangent};
use mechanics::appell::appell;
use mechanics::constrained::motion::{Motion, velocity};
use mechanics::constrained::{Charted, State, System, appell as equations, kinetic_energy};
use mechanics::differentiate::fixed;
use symbolic::Sym;

use Condition::Equal;

/// A point of mass m in the plane, free of constraints and forces.
#[derive(Clone, Copy, Debug)]
struct Point<P>(P);

impl<P: Base> System<2> for Point<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 2] {
        [self.0, self.0].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 2>) -> [S; 2] {
        [S::zero(); 2]
    }
}

/// Polar coordinates.
impl<P: Base> Charted<2, 2, 2> for Point<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [r, theta]: [S; 2]) -> [S; 2] {
        let point = theta.circle();
        [r * point.cos, r * point.sin]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], p: [S; 2]) -> [S; 2] {
        p
    }
}

pub fn claims(page: &mut Page) {
    page.section("Museum");
    let [m, r, theta, dr, dtheta, ddr, ddtheta] = letters(["m", "r", "θ", "ṙ", "θ̇", "r̈", "θ̈"]);
    let point = Point(m);
    let motion = Motion::at(&point, Sym::ZERO, [r, theta], [dr, dtheta]);
    let right = equations::residual(&point, &motion, [Sym::ZERO; 2], [ddr, ddtheta]);
    // T with q'' in the place of q'
    let energy = |dq: [Tangent<Sym>; 2]| {
        let q = fixed([r, theta]);
        kinetic_energy(point.masses(), velocity(&point, Tangent::fixed(Sym::ZERO), q, dq))
    };
    let wrong = appell(energy, [ddr, ddtheta]);
    let inertia = [m * ddr, m * r * r * ddtheta];
    page.claim("museum", "appell-from", r"the fault: $S$ made of $T$ by writing $\ddot q$ for $\dot q$ gives $m\ddot r$ and $m r^2\ddot\theta$ for a point in polar coordinates")
        .follows([Equal(wrong[0], inertia[0]), Equal(wrong[1], inertia[1])]);
    page.claim("museum", "appell", r"these are the equations of motion of a free point")
        .fails([Line::equation(right[0], inertia[0], Sym::ZERO), Line::equation(right[1], inertia[1], Sym::ZERO)]);
    page.claim(
        "museum",
        "appell-right",
        r"the fault lost the centrifugal and the Coriolis term, which stand in the acceleration at $\ddot q=0$",
    )
    .holds([
        Line::equation(right[0], inertia[0], m * r * dtheta * dtheta),
        Line::equation(right[1], inertia[1], -(m * r * dr * dtheta + m * r * dr * dtheta)),
    ]);
    page.correct();
    let of_drift = {
        let forces: [Sym; 2] = std::array::from_fn(|i| m * motion.drift[i]);
        motion.generalised(forces)
    };
    page.claim("museum", "appell-lost", r"in every chart the lost term is $\sum m\ddot x|_{\dot p=0}\,\partial\dot x/\partial p_j$; it vanishes in Cartesian coordinates")
        .follows((0..2).map(|j| Equal(right[j] - wrong[j], of_drift[j])));
}
