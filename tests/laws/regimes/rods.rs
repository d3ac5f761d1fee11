//! One contact with friction: rods on a line, and a bead on a dome.

use super::verdicts::{decide, q};
use dalembert_derivations::systems::rod::Rod;
use dalembert_derivations::systems::slender_rod::SlenderRod;
use field::{Circle, Over, Rational};
use mechanics::constrained::contacts::{Contact, Contacts, Sides};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};
use mechanics::regimes::{
    Condition, Consistency, Direction, Dry, Face, Mode, Sizes, Touch, Unfit, consistent, touches, verdict,
};

use Direction::Forwards;

/// A uniform slender rod with m = l = g = 1 that leans forwards and rotates; its end slides backwards.
fn slender_rod(friction: Rational, angle: Circle<Rational>, spin: Rational) -> Consistency<Rational, 1> {
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction };
    let velocity = [-one - spin * angle.sin, spin * angle.cos, -spin * angle.sin, spin * angle.cos];
    decide(&rod, &State { time: q(0, 1), place: [angle.cos, angle.sin, angle.cos, angle.sin], velocity })
}

#[test]
fn the_slender_rod_is_unique_up_to_its_critical_friction() {
    // tan theta = 4/3: (1 + 3 cos^2) / (3 sin cos) = 13/9
    let angle = Circle { cos: q(3, 5), sin: q(4, 5) };
    let (slow, fast) = (q(0, 1), q(2, 1));
    for spin in [slow, fast] {
        assert!(matches!(slender_rod(q(129, 90), angle, spin), Consistency::Unique(_)));
    }
    // above the critical friction: no motion if the rod falls slowly, two motions if its rotation lifts it
    assert_eq!(slender_rod(q(131, 90), angle, slow), Consistency::None);
    assert!(matches!(slender_rod(q(131, 90), angle, fast), Consistency::Several(..)));
    assert_eq!(slender_rod(q(13, 9), angle, slow), Consistency::None);
}

#[test]
fn painleves_rod_slides_as_newtons_laws_for_its_two_points_say() {
    let (m, m1, l, g, f) = (q(2, 1), q(3, 1), q(1, 1), q(10, 1), q(1, 4));
    let rod = Rod { guided: m, free: m1, length: l, gravity: g, friction: f, sides: Sides::Two };
    let (c, s) = (q(3, 5), q(4, 5));
    for direction in Direction::ALL {
        let speed = direction.sign();
        let velocity = [speed, q(0, 1), speed, q(0, 1)];
        let at = State { time: q(0, 1), place: [q(0, 1), q(0, 1), c, s], velocity };
        let Consistency::Unique(found) = decide(&rod, &at) else { panic!("one motion") };
        // R_x = -(direction) f N, N = (m + m1) g - m1 l theta'' c, l theta'' = x'' s + g c
        let against = -f * speed;
        let weight = (m + m1) * g - m1 * g * c * c;
        let right = m1 * g * s * c + against * weight;
        assert_eq!(found.motion[0][1], right / (m + m1 * c * c + against * m1 * s * c));
    }
}

/// A bead of mass 1 on a dome of radius 1 with friction, g = 10, f = 1/2.
struct Dome;

impl PointSystem<2> for Dome {
    type Given = Rational;

    fn masses<S: Over<Rational>>(&self) -> [S; 2] {
        [S::one(); 2]
    }

    fn force<S: Over<Rational>>(&self, _at: &State<S, 2>) -> [S; 2] {
        [S::zero(), S::int(-10)]
    }
}

impl Constrained<2, 0> for Dome {
    fn constraints<S: Over<Rational>>(&self, _at: &State<S, 2>) -> [Constraint<S>; 0] {
        []
    }
}

impl Contacts<2, 0, 1> for Dome {
    fn contacts<S: Over<Rational>>(&self, _time: S, [x, y]: [S; 2]) -> [Contact<S>; 1] {
        let gap = (x.squared() + y.squared() - S::one()).half();
        // near the top
        [Contact { gap, along: x / y, friction: S::ratio(1, 2), sides: Sides::One }]
    }
}

#[test]
fn a_bead_leaves_the_top_of_a_dome_when_it_is_too_fast() {
    let over_the_top = |speed| {
        let at = State { time: q(0, 1), place: [q(0, 1), q(1, 1)], velocity: [q(speed, 1), q(0, 1)] };
        let Consistency::Unique(found) = decide(&Dome, &at) else { panic!("one motion") };
        found
    };
    // N = m (g - v^2/R)
    assert_eq!(over_the_top(3).reactions, [[q(1, 1), q(-1, 2)]]);
    let fast = over_the_top(4);
    assert_eq!((fast.regime, fast.motion), ([Mode::Apart], [[q(6, 1), q(0, 1)]]));
}

#[test]
fn a_contact_that_closes_with_a_velocity_is_an_impact() {
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction: one };
    let place = [q(3, 5), q(4, 5), q(3, 5), q(4, 5)];
    let falling = State { time: q(0, 1), place, velocity: [q(0, 1), q(-1, 1), q(0, 1), q(0, 1)] };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &falling, Sizes::of(&falling)), Err(Unfit::Impact { contact: 0 }));
    let rising = State { velocity: [q(0, 1), q(1, 1), q(0, 1), q(0, 1)], ..falling };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &rising, Sizes::of(&rising)), Ok([Touch::Open]));
    let below = State { place: [q(3, 5), q(3, 5), q(3, 5), q(4, 5)], ..falling };
    assert_eq!(touches::<_, _, 4, 1, 1>(&rod, &below, Sizes::of(&below)), Err(Unfit::Penetrates { contact: 0 }));
}

#[test]
fn a_tie_is_told_and_counted_as_one_motion() {
    // a rod vertically above its end, pushed exactly to the limit of friction
    let one = q(1, 1);
    let rod = SlenderRod { mass: one, inertia: q(1, 3), half_length: one, gravity: one, friction: q(1, 2) };
    let still = [q(0, 1); 4];
    let at = State { time: q(0, 1), place: [q(0, 1), one, q(0, 1), one], velocity: still };
    // W is diag(1, 4): a force of 2 at the centre requires T = -1/2 = -f N
    let dry = Dry::<_, 1>::of(&rod, &at, [q(2, 1), -one, q(0, 1), q(0, 1)]).expect("one constraint");
    let mut names = Vec::new();
    consistent(&dry, &[Touch::Rest], |found| names.push((found.regime[0], found.tie)));
    let stick = (Mode::Stick(Face::Front), Some((0, Condition::HoldsBackwards)));
    let slip = (Mode::Slip(Forwards, Face::Front), Some((0, Condition::Departs)));
    assert_eq!(names, [stick, slip]);
    let Consistency::Unique(found) = verdict(&dry, &[Touch::Rest]) else { panic!("one motion under two names") };
    assert_eq!(found.motion, [[q(0, 1); 2]]);
}

#[test]
fn infinite_forces_have_no_verdict() {
    let rod = SlenderRod { mass: 1.0, inertia: 1.0, half_length: 1.0, gravity: 1.0, friction: 1.0 };
    let at = State { time: 0.0, place: [0.0, 1.0, 0.0, 1.0], velocity: [0.0; 4] };
    let dry = Dry::<f64, 1>::of(&rod, &at, [f64::INFINITY, 0.0, 0.0, 0.0]).expect("one constraint");
    assert_eq!(verdict(&dry, &[Touch::Rest]), Consistency::Undefined);
}
