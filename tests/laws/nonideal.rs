//! The counterexamples about rods and ladders with friction, checked independently of the paper: by Lagrange's
//! equations of the first kind with numerical data, where the contact reactions are given forces.

use dalembert_derivations::systems::ladder::{Ladder, LeaningLadder};
use dalembert_derivations::systems::rod::Rod;
use dalembert_derivations::systems::steered_rod::{GuidedSteeredRod, SteeredRod};
use field::{Rational, Scalar};
use mechanics::constrained::contacts::{Closed, Sides};
use mechanics::constrained::multipliers::{Reaction, multipliers};
use mechanics::constrained::{PointSystem, State};

fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator)
}

fn int(n: i64) -> Rational {
    Rational::int(n)
}

/// The rod of (1.22), which slides without rotation, cos theta = 3/5, sin theta = 4/5, under the reactions of the
/// guide.
fn rod_under([rx, ry]: [Rational; 2]) -> [Rational; 4] {
    let one = int(1);
    let rod = Rod { guided: one, free: one, length: one, gravity: one, friction: ratio(1, 2), sides: Sides::One };
    let (place, along) = ([int(0), int(0), ratio(3, 5), ratio(4, 5)], int(1));
    let at = State { time: int(0), place, velocity: [along, int(0), along, int(0)] };
    let weights: [Rational; 4] = rod.force(&at);
    let force = [weights[0] + rx, weights[1] + ry, weights[2], weights[3]];
    let Reaction { acceleration, .. } = multipliers(&rod, &at, force).expect("a rod has a length");
    acceleration
}

/// R_x and R_y as functions of mu and lambda, (1.42).
fn guide(mu: Rational) -> [Rational; 2] {
    [ratio(34, 25) * mu, ratio(-25, 17) + ratio(12, 25) * mu]
}

#[test]
fn the_corrected_friction_brakes_the_rod_and_keeps_it_on_the_floor() {
    let [rx, ry] = guide(ratio(-625, 952));
    assert_eq!(rx, ratio(1, 2) * ry);
    assert_eq!((rx.sign(), ry.sign()), (Some(-1), Some(-1)), "against x' > 0, and the floor pushes");
    let [_, downwards, ..] = rod_under([rx, ry]);
    assert_eq!(downwards, int(0));
}

#[test]
fn the_printed_friction_keeps_the_rod_on_the_floor_and_pushes_it_along() {
    let [rx, ry] = guide(ratio(125, 272));
    assert_eq!(rx, -ratio(1, 2) * ry);
    assert_eq!((rx.sign(), ry.sign()), (Some(1), Some(-1)), "with x' > 0");
    let [_, downwards, ..] = rod_under([rx, ry]);
    assert_eq!(downwards, int(0));
}

#[test]
fn neither_sign_of_the_law_lets_the_heavy_rod_slide_forward() {
    // m1 = 100 m, f = 1: R_y as a function of lambda for R_x = f R_y and for R_x = -f R_y
    let (lambda, mobile, coupling) = (ratio(-101, 37), int(37), int(48));
    let at = |way: i64| lambda * mobile / (mobile - int(way) * coupling);
    assert_eq!(at(1).sign(), Some(1), "the floor would have to pull");
    assert_eq!(at(-1).sign(), Some(-1), "the guide above would have to pull");
}

#[test]
fn the_smooth_ladder_leaves_the_wall_at_two_thirds_of_its_first_cosine() {
    let third = ratio(1, 3);
    let push_of_wall = |[cos, sin]: [Rational; 2], speed: Rational| {
        let ladder: LeaningLadder<Rational> = Closed(Ladder {
            mass: int(1),
            inertia: third,
            half_length: int(1),
            gravity: int(5),
            friction: [int(0); 2],
        });
        let at = State {
            time: int(0),
            place: [sin, cos, cos, sin],
            velocity: [cos * speed, -sin * speed, -sin * speed, cos * speed],
        };
        let weight: [Rational; 4] = ladder.force(&at);
        let Reaction { multipliers: [_, wall, _], .. } = multipliers(&ladder, &at, weight).expect("it leans");
        wall
    };
    // released from rest at cos = 9/10: alpha'^2 = 3g/2l (9/10 - cos) is 9/4 at cos = 3/5
    assert_eq!(push_of_wall([ratio(3, 5), ratio(4, 5)], ratio(3, 2)), int(0));
    assert_eq!(push_of_wall([ratio(4, 5), ratio(3, 5)], int(0)).sign(), Some(1), "at rest the wall pushes");
}

#[test]
fn the_guide_of_the_steered_rod_pulls_where_the_far_mass_is_the_heavier() {
    let data = SteeredRod {
        guided: int(1),
        free: int(2),
        length: int(1),
        gravity: int(1),
        drive: int(-1),
        friction: ratio(1, 2),
        sides: Sides::Two,
    };
    let rod: GuidedSteeredRod<Rational> = Closed(data);
    let at = State { time: int(0), place: [int(0), int(0), int(1), int(0)], velocity: [int(0); 4] };
    let given: [Rational; 4] = rod.force(&at);
    // at rest friction balances X: mu = -X / (m1 + m2) at both points, along the guide
    let mu = ratio(1, 3);
    let force = [given[0] + mu, given[1], given[2] + int(2) * mu, given[3]];
    let Reaction { acceleration, multipliers: [_, _, gap] } = multipliers(&rod, &at, force).expect("it is guided");
    assert_eq!(acceleration[0], int(0));
    assert_eq!(-gap, int(1), "lambda, downwards");
}
