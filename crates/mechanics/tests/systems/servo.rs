//! Servo constraints on a speed, and massless coordinates, compared with the equations that define the motion.

use dalembert_mechanics::constrained::combining::extended;
use dalembert_mechanics::constrained::massless;
use dalembert_mechanics::constrained::multipliers::leading_to;
use dalembert_mechanics::constrained::programmed::{Linear, Programme, violation as of_contacts};
use dalembert_mechanics::constrained::rates::{jacobian, rates};
use dalembert_mechanics::constrained::servo::{Servo, Steered, additions, gradients, steered, violation};
use dalembert_mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use dalembert_mechanics::differentiate::along;
use field::{Over, Rational, Tangent};

/// A point on the curve y = x^2, and one on a line, at z, which is driven by the square of the first point's speed. A
/// force along x, to which the curve reacts, makes the speed of the second point constant. The last coordinate is
/// determined by the first point.
struct Driven {
    last: Rational,
}

impl PointSystem<4> for Driven {
    type Given = Rational;

    fn masses<S: Over<Rational>>(&self) -> [S; 4] {
        [S::int(2), S::int(2), S::ratio(3, 2), S::lift(self.last)]
    }

    fn force<S: Over<Rational>>(&self, at: &State<S, 4>) -> [S; 4] {
        let ([dx, dy, dz, _], [.., w]) = (at.velocity, at.place);
        [-dx, S::int(-3), dx.squared() + dy.squared() - dz * at.time, -w]
    }
}

impl Constrained<4, 2> for Driven {
    fn constraints<S: Over<Rational>>(&self, at: &State<S, 4>) -> [Constraint<S>; 2] {
        let ([x, y, ..], [dx, dy, _, dw]) = (at.place, at.velocity);
        [Constraint::Geometric(y - x.squared()), Constraint::Kinematic(dw - x * dx - dy)]
    }
}

impl Servo<4, 2, 1> for Driven {
    fn kept<S: Over<Rational>>(&self, at: &State<S, 4>) -> [S; 1] {
        [at.velocity[2] - at.time.half()]
    }

    fn directions<S: Over<Rational>>(&self, _at: &State<S, 4>) -> [[S; 4]; 1] {
        [[S::one(), S::zero(), S::zero(), S::zero()]]
    }
}

fn ratio(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

/// A state that violates every constraint.
fn state() -> State<Rational, 4> {
    State {
        time: ratio(2, 3),
        place: [ratio(1, 2), ratio(1, 3), ratio(0, 1), ratio(1, 7)],
        velocity: [ratio(3, 4), ratio(-1, 5), ratio(2, 1), ratio(5, 2)],
    }
}

fn dot<const N: usize>(a: [Rational; N], b: [Rational; N]) -> Rational {
    a.into_iter().zip(b).fold(ratio(0, 1), |sum, (a, b)| sum + a * b)
}

fn led<const K: usize>() -> Linear<Rational, K> {
    Linear::baumgarte(ratio(3, 1), ratio(5, 1))
}

#[test]
fn a_control_leads_what_it_keeps_and_the_contacts_answer_it() {
    let (system, at) = (Driven { last: ratio(1, 4) }, state());
    let contacts = led::<2>();
    let found: Steered<_, 4, 1> = steered(&system, (&contacts, &led()), &at).expect("the contacts are independent");
    // the contact constraints are prescribed functions of time
    let wanted = contacts.prescribed(&at, &of_contacts(&system, &at));
    assert_eq!(rates(&system, &at, found.acceleration), wanted);
    // without forces and control only ideal reactions remain
    let (masses, force) = (system.masses(), system.force(&at));
    let [direction] = system.directions(&at);
    let reaction =
        std::array::from_fn(|i| masses[i] * found.acceleration[i] - force[i] - direction[i] * found.controls[0]);
    let parts = extended(masses, jacobian(&system, &at), reaction).expect("the contacts are independent");
    assert_eq!(parts.of_friction, [ratio(0, 1); 4]);
    // along this motion r is the rate of phi, and the rate of r is the prescribed one
    let moving = State {
        time: Tangent::variable(at.time),
        place: along(at.place, at.velocity),
        velocity: along(at.velocity, found.acceleration),
    };
    let (now, next) = (violation(&system, &contacts, &at), violation(&system, &contacts, &moving));
    let (now, next) = (now.expect("they are"), next.expect("they are"));
    assert_eq!(next.value[0].slope, now.rate[0]);
    assert_eq!([next.rate[0].slope], led::<1>().prescribed(&at, &now));
    assert!(now.value[0] != ratio(0, 1) && now.rate[0] != ratio(0, 1) && found.controls[0] != ratio(0, 1));
}

#[test]
fn what_a_control_adds_is_along_the_contacts_and_across_what_it_keeps() {
    let (system, at) = (Driven { last: ratio(1, 4) }, state());
    let [added] = additions(&system, &at).expect("the contacts are independent");
    for row in jacobian(&system, &at) {
        assert_eq!(dot(row, added), ratio(0, 1));
    }
    let [gradient] = gradients(&system, &at);
    assert_eq!(gradient, [0, 0, 1, 0].map(|one| ratio(one, 1)));
    assert_eq!(dot(gradient, added), ratio(0, 1));
    assert!(added[1] != ratio(0, 1), "the curve answers");
}

#[test]
fn a_coordinate_without_mass_moves_as_its_constraint_says_and_passes_its_force_on() {
    let at = state();
    let wanted = [ratio(1, 3), ratio(-2, 1)];
    for last in [ratio(0, 1), ratio(1, 4)] {
        let system = Driven { last };
        let (masses, force) = (system.masses::<Rational>(), system.force(&at));
        let found = massless::leading_to(&system, &at, force, wanted).expect("every coordinate is held");
        assert_eq!(rates(&system, &at, found.acceleration), wanted);
        let rows = jacobian(&system, &at);
        for i in 0..4 {
            let reaction = dot(found.multipliers, rows.map(|row| row[i]));
            assert_eq!(masses[i] * found.acceleration[i], force[i] + reaction);
        }
        if last != ratio(0, 1) {
            assert_eq!(Ok(found), leading_to(&system, &at, force, wanted));
        }
    }
}
