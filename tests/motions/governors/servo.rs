//! The programme by multipliers and a control force, compared exactly with Appell's equations.

use super::*;
use dalembert_derivations::systems::governor::servo::Kept;
use field::Tangent;
use mechanics::constrained::motion::velocity;
use mechanics::constrained::programmed::Linear;
use mechanics::constrained::servo::{Servo, Steered, additions, gradients, steered, violation};
use mechanics::constrained::{Charted, State};
use mechanics::differentiate::along;
use symbolic::Sym;

/// A fraction as an expression: the chart requires a scalar type with cosines, which are needed here at zero angles
/// only.
fn ratio(n: i64, d: i64) -> Sym {
    Sym::ratio(n, d)
}

fn of_rationals(gearing: Gearing<Sym>) -> Governor<Sym> {
    Governor {
        inertia: [ratio(3, 5), ratio(1, 2), ratio(1, 10)],
        mass: ratio(4, 5),
        radius: ratio(1, 5),
        gearing,
        moments: [
            Torque { start: ratio(-1, 2), growth: ratio(1, 3) },
            Torque { start: ratio(2, 5), growth: ratio(1, 7) },
        ],
        push: ratio(7, 10),
        lateral: ratio(3, 10),
    }
}

/// The governor with prescribed speed, in its programmed motion at an instant.
fn on_its_programme(gearing: Gearing<Sym>, [time, rho, speed]: [Sym; 3]) -> (Kept<Sym>, State<Sym, 7>) {
    let governor = of_rationals(gearing);
    let zero = ratio(0, 1);
    let (q, drift) = ([zero, zero, zero, rho], governor.programme(time, rho, speed));
    let state = State { time, place: governor.place(time, q), velocity: velocity(&governor, time, q, [speed, drift]) };
    (Kept { governor, speed }, state)
}

const GEARINGS: [Gearing<(i64, i64)>; 2] = [Gearing::Drum { radius: (1, 2) }, Gearing::Discs { distance: (4, 5) }];

fn gearings() -> impl Iterator<Item = Gearing<Sym>> {
    GEARINGS.into_iter().map(|gearing| match gearing {
        Gearing::Drum { radius: (n, d) } => Gearing::Drum { radius: ratio(n, d) },
        Gearing::Discs { distance: (n, d) } => Gearing::Discs { distance: ratio(n, d) },
    })
}

#[test]
fn the_control_is_the_force_of_appells_equations_and_the_wheel_moves_as_the_programme_says() {
    for gearing in gearings() {
        for at in [[ratio(0, 1), ratio(3, 10), ratio(2, 1)], [ratio(5, 3), ratio(1, 7), ratio(-3, 2)]] {
            let (kept, state) = on_its_programme(gearing, at);
            let none =
                (&Linear::<Sym, 5>::baumgarte(ratio(0, 1), ratio(0, 1)), &Linear::baumgarte(ratio(0, 1), ratio(0, 1)));
            let found: Steered<_, 7, 1> = steered(&kept, none, &state).expect("the contacts are independent");
            let [time, rho, speed] = at;
            assert_eq!(found.acceleration[6], kept.governor.programme_acceleration(time, rho, speed));
            // in addition to the force of the data
            assert_eq!(found.controls[0] + kept.governor.push, kept.governor.control_force(time, rho, speed));
            let still = violation(&kept, none.0, &state).expect("they are");
            assert_eq!(
                (still.value, still.rate),
                ([ratio(0, 1)], [ratio(0, 1)]),
                "the start keeps the speed and its rate"
            );
        }
    }
}

#[test]
fn the_push_does_not_move_the_speed_at_once_and_is_not_along_its_gradient() {
    for gearing in gearings() {
        let (kept, state) = on_its_programme(gearing, [ratio(1, 2), ratio(2, 7), ratio(2, 1)]);
        let ([row], [push], [direction]) = (
            gradients(&kept, &state),
            additions(&kept, &state).expect("the contacts are independent"),
            kept.directions(&state),
        );
        let dot = |a: [Sym; 7], b: [Sym; 7]| a.into_iter().zip(b).fold(ratio(0, 1), |sum, (a, b)| sum + a * b);
        assert_eq!(dot(row, push), ratio(0, 1));
        assert_eq!(dot(row, direction), ratio(0, 1));
        assert_ne!(dot(push, push), ratio(0, 1));
    }
}

#[test]
fn a_speed_that_is_off_is_led_back_as_its_gains_say() {
    let gain = ratio(10, 1);
    let led = (&Linear::<Sym, 5>::baumgarte(gain, gain), &Linear::<Sym, 1>::baumgarte(gain, gain));
    for gearing in gearings() {
        let (kept, mut state) = on_its_programme(gearing, [ratio(1, 2), ratio(2, 7), ratio(2, 1)]);
        // now the contact conditions, the speed and its rate are violated
        (state.velocity[1], state.velocity[3], state.velocity[6]) = (ratio(5, 3), ratio(11, 5), ratio(1, 9));
        let now = violation(&kept, led.0, &state).expect("the contacts are independent");
        let found: Steered<_, 7, 1> = steered(&kept, led, &state).expect("they are");
        let moving = State {
            time: Tangent::variable(state.time),
            place: along(state.place, state.velocity),
            velocity: along(state.velocity, found.acceleration),
        };
        let second = violation(&kept, led.0, &moving).expect("they are").rate[0].slope;
        let two = ratio(2, 1);
        assert_eq!(second, -(two * gain * now.rate[0]) - gain * gain * now.value[0]);
        // and the rate is that of the motion, for any control
        assert_eq!(kept.kept(&moving)[0].slope, now.rate[0]);
        assert!(now.rate[0] != ratio(0, 1) && now.value[0] != ratio(0, 1));
    }
}
