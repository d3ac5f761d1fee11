//! Two published errors: Appell's equations obtained by writing q'' for q' in the kinetic energy; and a test whose
//! expected result was derived from the same wrong kinematics as the code.

use super::alphabet::{letter, letters};
use super::cases;
use claims::{Condition, Line, Page};
use field::{Analytic, Base, Over, Tangent};
use mechanics::appell::appell;
use mechanics::constrained::motion::{Motion, velocity};
use mechanics::constrained::rates::first_rates;
use mechanics::constrained::{Charted, PointSystem, State, appell as equations, kinetic_energy};
use mechanics::differentiate::fixed;
use symbolic::Sym;
use systems::knife_edge::KnifeEdge;

use Condition::Equal;

/// A point of mass m in the plane, without constraints and forces.
#[derive(Clone, Copy, Debug)]
struct Point<P>(P);

impl<P: Base> PointSystem<2> for Point<P> {
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

/// The knife edge with the velocities of a body whose blade is in front of its centre of mass, although it is behind.
#[derive(Clone, Copy, Debug)]
struct Reversed<P>(KnifeEdge<P>);

impl<P: Base> PointSystem<4> for Reversed<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        self.0.masses()
    }

    fn force<S: Over<P>>(&self, at: &State<S, 4>) -> [S; 4] {
        self.0.force(at)
    }
}

impl<P: Base> Charted<4, 3, 2> for Reversed<P> {
    fn place<S: Over<P> + Analytic>(&self, time: S, q: [S; 3]) -> [S; 4] {
        self.0.place(time, q)
    }

    fn rates<S: Over<P> + Analytic>(&self, time: S, q: [S; 3], p: [S; 2]) -> [S; 3] {
        KnifeEdge { offset: -self.0.offset, ..self.0 }.rates(time, q, p)
    }
}

pub fn claims(page: &mut Page) {
    page.section("Museum");
    appell_from_kinetic_energy(page);
    kinematics_of_the_code(page);
}

/// Code and expected result agree because both are derived from the same chart; neither checks the constraint.
fn kinematics_of_the_code(page: &mut Page) {
    let case = cases::knife_edge();
    let code = Reversed(case.system);
    let (time, q, p) = case.at;
    let rates = letters(["v̇", "θ̈"]);
    let motion = Motion::at(&code, time, q, p);
    let found = equations::residual(&code, &motion, code.force(&motion.state), rates);
    let [m, j, d, g, v, dtheta] = letters(["m", "J", "d", "g", "v", "θ̇"]);
    let (cos, sin) = (letter("θ").circle().cos, letter("θ").circle().sin);
    let expected = [
        m * (rates[0] + d * dtheta * dtheta) - m * g * cos,
        (j + m * d * d) * rates[1] - m * d * v * dtheta - m * g * d * sin,
    ];
    page.claim("museum", "kinematics-agree", r"The knife edge has the wrong velocities $\dot x = v\cos\theta + d\dot\theta\sin\theta$, $\dot y = v\sin\theta - d\dot\theta\cos\theta$ here. Appell's equations from code with these velocities agree with those derived from them on paper, so that a comparison of both passes")
        .in_words()
        .follows((0..2).map(|i| Equal(found[i], expected[i])));
    let slip = first_rates(&case.system, &motion.state)[1];
    page.claim("museum", "kinematics", r"$\dot x = v\cos\theta + d\dot\theta\sin\theta$, $\dot y = v\sin\theta - d\dot\theta\cos\theta$ are velocities of the knife edge: its blade does not slip sideways")
        .why("The signs of the offset are those of a blade on the other side of the centre.")
        .fails([Line::formula(slip, letter("slip"), Sym::ZERO)]);
    page.claim(
        "museum",
        "kinematics-right",
        r"The blade of the knife edge slips at the rate below with $\dot x = v\cos\theta + d\dot\theta\sin\theta$, $\dot y = v\sin\theta - d\dot\theta\cos\theta$",
    )
    .holds([Line::formula(slip, letter("slip"), -(d * dtheta + d * dtheta))]);
    page.correct();
}

/// The acceleration energy S obtained from T by writing q'' for q'.
fn appell_from_kinetic_energy(page: &mut Page) {
    let [m, r, theta, dr, dtheta, ddr, ddtheta] = letters(["m", "r", "θ", "ṙ", "θ̇", "r̈", "θ̈"]);
    let point = Point(m);
    let motion = Motion::at(&point, Sym::ZERO, [r, theta], [dr, dtheta]);
    let right = equations::residual(&point, &motion, [Sym::ZERO; 2], [ddr, ddtheta]);
    // T with q'' in place of q'
    let energy = |dq: [Tangent<Sym>; 2]| {
        let q = fixed([r, theta]);
        kinetic_energy(point.masses(), velocity(&point, Tangent::fixed(Sym::ZERO), q, dq))
    };
    let wrong = appell(energy, [ddr, ddtheta]);
    let inertia = [m * ddr, m * r * r * ddtheta];
    page.claim("museum", "appell-from", r"$S$ made of $T$ by writing $\ddot q$ for $\dot q$, which is a fault, gives $m\ddot r$ and $m r^2\ddot\theta$ for a point in polar coordinates")
        .in_words()
        .follows([Equal(wrong[0], inertia[0]), Equal(wrong[1], inertia[1])]);
    page.claim("museum", "appell", r"$m\ddot r=0$, $mr^2\ddot\theta=0$, from $S$ made of $T$ by writing $\ddot q$ for $\dot q$, are the equations of motion of a free point in polar coordinates")
        .why(r"The acceleration of a point in polar coordinates does not vanish with $\ddot q$.")
        .fails([Line::equation(right[0], inertia[0], Sym::ZERO), Line::equation(right[1], inertia[1], Sym::ZERO)]);
    page.claim(
        "museum",
        "appell-right",
        r"The equations of motion of a free point in polar coordinates have the centrifugal and the Coriolis term, which stand in the acceleration at $\ddot q=0$",
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
    page.claim("museum", "appell-lost", r"The term that is lost where $S$ is made of $T$ by writing $\ddot q$ for $\dot q$ is $\sum m\ddot x|_{\dot p=0}\,\partial\dot x/\partial p_j$, here in polar coordinates")
        .in_words()
        .follows((0..2).map(|j| Equal(right[j] - wrong[j], of_drift[j])));
}
