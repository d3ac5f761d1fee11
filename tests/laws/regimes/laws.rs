//! Every motion found by any method satisfies the laws of contact and friction.

use super::ladders::{ladder, leaning};
use super::verdicts::{name, q};
use dalembert_derivations::studies::regimes::maps::{Kind, maps};
use dalembert_derivations::systems::ladder::Ladder;
use field::{Circle, Rational};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Sides;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::mode::modes;
use mechanics::regimes::{
    Consistency, Direction, Dry, Found, Ordered, Sizes, Touch, conditions, consistent, posed, touches, verdict,
};
use num_traits::Zero;
use std::collections::HashSet;

use Direction::Backwards;

/// Whether reactions and accelerations satisfy the laws of contact and friction, checked without regimes.
fn lawful<const K: usize>(dry: &Dry<Rational, K>, touches: &[Touch; K], found: &Found<Rational, K>) -> bool {
    let sign = |x: Rational| x.sign().expect("every value is defined");
    (0..K).all(|k| {
        let ([normal, tangential], [gap, along]) = (found.reactions[k], found.motion[k]);
        let limit = dry.friction[k] * normal.size() - tangential.size();
        let open = normal.is_zero() && tangential.is_zero();
        let normal_law = match (touches[k], dry.sides[k]) {
            (Touch::Open, _) => open,
            (_, Sides::Two) => gap.is_zero(),
            (_, Sides::One) => sign(normal) >= 0 && sign(gap) >= 0 && (normal * gap).is_zero(),
        };
        let friction_law = match touches[k] {
            Touch::Open => true,
            Touch::Slides(direction) => limit.is_zero() && sign(tangential * direction.sign()) <= 0,
            Touch::Rest if normal.is_zero() => open,
            Touch::Rest => sign(limit) >= 0 && (along.is_zero() || limit.is_zero() && sign(tangential * along) <= 0),
        };
        normal_law && friction_law
    })
}

/// A deterministic generator of small rationals.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> Rational {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        q(((self.0 >> 33) % 41) as i64 - 20, 7)
    }
}

#[test]
fn what_is_found_obeys_the_laws_and_floats_agree() {
    let mut numbers = Numbers(1);
    let (mut none, mut several) = (0, 0);
    for case in 0..400 {
        let angle = Circle::from_half_tangent(q(1 + case % 11, 12));
        let spin = if case % 3 == 0 { q(0, 1) } else { numbers.next() };
        let (mut system, at) = (ladder(numbers.next().size()), leaning(angle, spin));
        system.friction[1] = numbers.next().size();
        let load = std::array::from_fn(|_| numbers.next());
        let dry = Dry::<_, 2>::of(&system, &at, load).expect("one constraint");
        let touch = touches(&system, &at, Sizes::of(&at)).expect("on wall and floor");
        consistent(&dry, &touch, |found| assert!(lawful(&dry, &touch, &found), "case {case}: {found:?}"));
        let exact = verdict(&dry, &touch);
        none += u32::from(exact == Consistency::None);
        several += u32::from(matches!(exact, Consistency::Several(..)));
        let f = system.friction.map(Rational::to_f64);
        let rounded = Ladder { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: 10.0, friction: f };
        let place = at.place.map(Rational::to_f64);
        let near = State { time: 0.0, place, velocity: at.velocity.map(Rational::to_f64) };
        let dry = Dry::<_, 2>::of(&rounded, &near, load.map(Rational::to_f64)).expect("one constraint");
        let rounded = verdict(&dry, &touches(&rounded, &near, Sizes::of(&near)).expect("on wall and floor"));
        assert_eq!(name(&exact), name(&rounded), "case {case}: {exact:?} but {rounded:?}");
    }
    assert!(none > 0 && several > 0, "{none} without a motion, {several} with several");
}

#[test]
fn cramers_rule_and_elimination_agree() {
    let at = leaning(Circle { cos: q(3, 5), sin: q(4, 5) }, q(1, 2));
    let (dry, touches) = posed(&ladder(q(1, 3)), &at).expect("on wall and floor");
    let mut regular = 0;
    consistent(&dry, &touches, |found| {
        let cramer = Cramer::of(&dry, &found.regime);
        assert_eq!(cramer.reactions(), found.reactions);
        for (condition, form) in conditions(&dry, &touches, &found.regime).iter().flatten().flatten() {
            assert!(cramer.value(form).sign() >= Some(0), "{condition}");
        }
        regular += 1;
    });
    assert_eq!(regular, 1);
}

#[test]
fn a_smooth_guide_has_no_stick() {
    let count = |friction| modes(Touch::Rest, Sides::Two, friction).count();
    assert_eq!((count(q(0, 1)), count(q(1, 1))), (2, 6));
    assert_eq!(modes(Touch::Slides(Backwards), Sides::One, q(0, 1)).count(), 2);
}

#[test]
fn decisions_alone_find_the_critical_curves() {
    let mut shown = HashSet::new();
    for map in maps() {
        assert!(map.distance < 1e-9, "{}: {:.1e}", map.title, map.distance);
        let (_, least, name) = map.least;
        let lowest = map.curve.iter().map(|(_, f)| *f).fold(f64::INFINITY, f64::min);
        assert!(lowest >= least && lowest < 1.001 * least, "{name}: {lowest}");
        shown.extend(map.rows.into_iter().flatten().map(Kind::name));
    }
    assert_eq!(shown.len(), Kind::ALL.len(), "{shown:?}");
}
