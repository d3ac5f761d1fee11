//! Two masses on guides with friction.

use super::verdicts::{decide, q};
use dalembert_derivations::systems::painleve_klein::PainleveKlein;
use field::Rational;
use mechanics::constrained::State;
use mechanics::regimes::Consistency;

/// The sliders with tan theta = 4/3 and m1 = m2 = P2 = 1, moving forwards.
fn sliders(tangent_times_friction: Rational, load: i64) -> Consistency<Rational, 2> {
    let system = PainleveKlein {
        masses: [q(1, 1), q(1, 1)],
        loads: [q(load, 1), q(1, 1)],
        distance: q(4, 1),
        length: q(5, 1),
        friction: tangent_times_friction * q(3, 4),
    };
    let place = [q(0, 1), q(0, 1), q(3, 1), q(4, 1)];
    decide(&system, &State { time: q(0, 1), place, velocity: [q(1, 1), q(0, 1), q(1, 1), q(0, 1)] })
}

#[test]
fn the_sliders_have_two_accelerations_or_none() {
    let Consistency::Several(a, b) = sliders(q(3, 1), 2) else { panic!("two accelerations") };
    let mut found = [a.motion[0][1], b.motion[0][1]];
    found.sort_by(|a, b| (*a - *b).sign().unwrap_or(0).cmp(&0));
    assert_eq!(found, [q(0, 1), q(6, 5)]);
    assert_eq!(sliders(q(3, 1), 0), Consistency::None);
}

#[test]
fn the_sliders_are_unique_below_the_critical_friction() {
    for load in -20..=20 {
        assert!(matches!(sliders(q(19, 10), load), Consistency::Unique(_)), "load {load}");
    }
}

#[test]
fn at_the_critical_friction_one_load_gives_a_continuum() {
    // here (m1 + m2 - f m2 tan theta) x'' = P1 + P2 - f P2 tan theta reads 0 = 0
    assert!(matches!(sliders(q(2, 1), 1), Consistency::Continuum(_)));
    assert_eq!(sliders(q(2, 1), 0), Consistency::None);
}
