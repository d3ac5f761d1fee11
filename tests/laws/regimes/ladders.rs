//! Two contacts with friction: ladders on wall and floor.

use super::verdicts::{decide, name, q};
use dalembert_derivations::systems::ladder::Ladder;
use field::{Circle, Rational};
use mechanics::constrained::State;
use mechanics::regimes::{Consistency, Direction, Dry, Face, Mode, Seen, Touch, consistent};
use num_traits::Zero;

use Direction::{Backwards, Forwards};

/// The uniform ladder with m = l = 1, g = 10.
pub fn ladder(friction: Rational) -> Ladder<Rational> {
    let one = q(1, 1);
    Ladder { mass: one, inertia: q(1, 3), half_length: one, gravity: q(10, 1), friction: [friction; 2] }
}

/// The state of the ladder on wall and floor with an angle from the wall and an angular velocity.
pub fn leaning(angle: Circle<Rational>, spin: Rational) -> State<Rational, 4> {
    let (c, s) = (angle.cos, angle.sin);
    State { time: q(0, 1), place: [s, c, c, s], velocity: [spin * c, -spin * s, -spin * s, spin * c] }
}

#[test]
fn a_steep_ladder_on_rough_ground_stays_with_undetermined_reactions() {
    let steep = leaning(Circle { cos: q(12, 13), sin: q(5, 13) }, q(0, 1));
    let Consistency::Unique(found) = decide(&ladder(q(1, 2)), &steep) else { panic!("one motion") };
    assert_eq!(found.regime, [Mode::Stick(Face::Front); 2]);
    assert!(found.motion.as_flattened().iter().all(Rational::is_zero));
    assert!(!found.determined);
}

/// If both friction cones contain the line between the ends, the reactions along this line are unbounded.
#[test]
fn a_ladder_that_is_wedged_has_reactions_without_bound() {
    let wedged = leaning(Circle { cos: q(3, 5), sin: q(4, 5) }, q(0, 1));
    let Consistency::Unique(found) = decide(&ladder(q(2, 1)), &wedged) else { panic!("one motion") };
    assert_eq!(found.regime, [Mode::Stick(Face::Front); 2]);
    assert!(!found.determined);
}

#[test]
fn a_flat_ladder_on_smooth_ground_falls_as_the_closed_form_says() {
    let angle = Circle { cos: q(3, 5), sin: q(4, 5) };
    let Consistency::Unique(found) = decide(&ladder(q(0, 1)), &leaning(angle, q(0, 1))) else { panic!("one motion") };
    // (m l^2 + J) alpha'' = m g l sin alpha, and the floor's point has x = 2 l sin alpha
    let turning = q(10, 1) * angle.sin / q(4, 3);
    assert_eq!(found.motion[1][1], q(2, 1) * angle.cos * turning);
}

#[test]
fn a_ladder_at_rest_may_stay_or_slide_up_under_one_load() {
    // f = 1/2 and tan alpha = 12/5 > 1/f; the reactions are those of the claim regimes/ladder-rest/reactions, at one
    // limit of rest
    let (f, at) = (q(1, 2), leaning(Circle { cos: q(5, 13), sin: q(12, 13) }, q(0, 1)));
    let system = ladder(f);
    let (wall, floor, against) = (q(100, 1) + q(263, 39), q(100, 1) + q(191, 78), q(91, 12));
    let reactions = [[wall, -f * wall], [floor, f * (floor - against) - f * against]];
    let zero = [q(0, 1); 4];
    let seen = Seen::<_, 4, 2>::of(&system, &at, zero).expect("one constraint");
    let mut load = zero;
    for (reaction, direction) in reactions.as_flattened().iter().zip(seen.directions.as_flattened()) {
        (0..4).for_each(|i| load[i] -= *reaction * direction[i]);
    }
    let dry = Dry::of(&system, &at, load).expect("one constraint");
    let mut found = Vec::new();
    consistent(&dry, &[Touch::Rest; 2], |regime| found.push((regime.regime, regime.motion[0][1])));
    // at the floor's friction limit several regimes describe this rest
    found.dedup_by_key(|(_, motion)| *motion);
    let up = [Mode::Slip(Forwards, Face::Front), Mode::Slip(Backwards, Face::Front)];
    assert_eq!(found, [([Mode::Stick(Face::Front); 2], q(0, 1)), (up, q(24, 13))]);
}

/// The construction of the claims regimes/ladder-rest/ambiguous and ambiguous-down with epsilon = 1, also for f^2 > 2.
#[test]
fn whatever_the_friction_some_load_lets_a_ladder_at_rest_stay_or_slide() {
    let (one, third) = (q(1, 1), q(1, 3));
    for (f, turn) in [(q(1, 2), q(2, 3)), (q(1, 1), q(3, 5)), (q(3, 2), q(1, 2)), (q(3, 1), q(2, 5))] {
        let steep = Circle::from_half_tangent(turn);
        for up in [true, false] {
            // from the decisive contact: the wall for upwards, the floor for downwards
            let ordered = |[a, b]: [[Rational; 2]; 2]| if up { [a, b] } else { [b, a] };
            let Circle { cos: c, sin: s } = steep;
            let at = leaning(if up { steep } else { Circle { cos: s, sin: c } }, q(0, 1));
            let u = f * s - c;
            assert_eq!(u.sign(), Some(1));
            let p = c + third / c + s * s / u;
            let (n1, n2, fall) = (q(10, 1), q(10, 1) + p / (f + f), (third - c * p) / s);
            let reactions = ordered([[n1 + p, -f * n1 - s + fall], [n2 - fall, f * n2 + c - p]]);
            let system = ladder(f);
            let seen = Seen::<_, 4, 2>::of(&system, &at, [q(0, 1); 4]).expect("one constraint");
            let mut load = [q(0, 1); 4];
            for (reaction, direction) in reactions.as_flattened().iter().zip(seen.directions.as_flattened()) {
                (0..4).for_each(|i| load[i] -= *reaction * direction[i]);
            }
            let dry = Dry::of(&system, &at, load).expect("one constraint");
            let mut motions = Vec::new();
            consistent(&dry, &[Touch::Rest; 2], |regime| motions.push(regime.motion.map(|pair| pair[1])));
            let slide = if up { [one + one, -one - one] } else { [-one - one, one + one] };
            let slide = [slide[0] * at.place[3], slide[1] * at.place[2]];
            assert!(motions.contains(&[q(0, 1); 2]) && motions.contains(&slide), "f = {f}: {motions:?}");
        }
    }
}

#[test]
fn the_ladders_own_weight_leaves_no_motion_or_two_beyond_four_thirds() {
    let angle = Circle { cos: q(15, 17), sin: q(8, 17) };
    for (friction, slow, fast) in [(q(27, 20), "none", "several"), (q(13, 10), "unique", "unique")] {
        let verdict = |spin| name(&decide(&ladder(friction), &leaning(angle, spin))).0;
        assert_eq!([verdict(q(1, 10)), verdict(q(5, 1))], [slow, fast], "f = {friction}");
    }
}

#[test]
fn at_rest_its_own_weight_leaves_the_ladder_one_motion() {
    for angle in (1..40).map(|k| Circle::from_half_tangent(q(k, 41))) {
        for friction in (0..12).map(|k| q(k, 4)) {
            let found = decide(&ladder(friction), &leaning(angle, q(0, 1)));
            assert_eq!(name(&found).0, "unique", "f = {friction} at {angle:?}");
        }
    }
}
