//! Two crossed windings compared with equivalent models.

use crate::number;
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::crossed_windings::CrossedWindings;
use dalembert_derivations::machines::kloss::Kloss;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::studies::model_reduction::currents::Current;
use field::{Circle, Rational, Tangent};
use motor::{Machine, torque_and_current_rates};
use num_traits::Zero;

/// Bars at -90 and at 180 degrees: -a sin(g + t) becomes a cos g and a sin g.
#[test]
fn two_bars_at_right_angles_without_excitation_are_the_machine() {
    let o = Rational::zero();
    let (field_speed, flux, inductance, resistance, f) =
        (number(150, 1), number(1, 40), number(1, 625), number(8, 125), number(1, 2500));
    let crossed = CrossedWindings { field_speed, flux, inductance, resistance, f };
    let (l2, r2, idle) = (inductance, resistance, number(1, 1));
    let windings = Windings { field_speed, b0: o, a1: o, l1: idle, r1: idle, a2: flux, l2, r2, mu: o, f };
    let bars = vec![Circle { cos: o, sin: number(-1, 1) }, Circle { cos: number(-1, 1), sin: o }];
    let all = MultiCurrent { windings, bars };
    for (half, slip, first, second) in [(2, -140, 3, -7), (-5, 6, 11, 2), (1, 0, -4, 9)] {
        let (angle, slip) = (Circle::from_half_tangent(number(half, 7)), number(slip, 1));
        let currents = [number(first, 3), number(second, 5)];
        let (mut ours, mut theirs) = ([o; 2], [o; 3]);
        let moment = torque_and_current_rates(&crossed, angle, slip, &currents, &mut ours);
        assert_eq!(moment, torque_and_current_rates(&all, angle, slip, &[o, currents[0], currents[1]], &mut theirs));
        assert_eq!(ours, theirs[1..]);
    }
}

/// With the steady currents of the present slip the torque is that of Kloss, with the pull-out torque a^2/(2 L) at the
/// slip R/L; its derivative at synchronism equals that of the asynchronous motor with k = a^2/R.
#[test]
fn at_constant_slip_the_moment_is_that_of_kloss_and_near_synchronism_the_linear_one() {
    let (field_speed, flux, inductance, resistance, f) = (150.0, 0.025, 1.6e-3, 0.064, 4e-4);
    let crossed = CrossedWindings { field_speed, flux, inductance, resistance, f };
    let moment = |angle: f64, slip: f64| {
        let angle = field::Analytic::circle(angle).map(Tangent::fixed);
        let slip = Tangent::variable(slip);
        let currents = [0, 1].map(|k| Current::AtPresentSlip.of(&crossed, k, angle, slip));
        torque_and_current_rates(&crossed, angle, slip, &currents, &mut [slip; 2])
    };
    let (pull_out, pull_out_slip) = (flux * flux / (2.0 * inductance), resistance / (inductance * field_speed));
    let kloss = Kloss { field_speed, pull_out, pull_out_slip, f };
    for angle in [0.0, 0.4, 2.0, -1.1] {
        for slip in [-150.0, -40.0, -6.0, 0.3, 80.0] {
            let (ours, theirs) = (moment(angle, slip).value, kloss.torque_law(slip, slip + field_speed));
            assert!((ours - theirs).abs() < 1e-14 * pull_out, "{ours} and {theirs} at {angle}, {slip}");
        }
        let linear = Asynchronous { field_speed, k: flux * flux / resistance, f };
        let theirs = linear.torque_law(Tangent::variable(0.0), Tangent::variable(field_speed));
        let ours = moment(angle, 0.0);
        assert!((ours.slope - theirs.slope).abs() < 1e-12 * linear.k, "{} and {}", ours.slope, theirs.slope);
        assert!((ours.value - theirs.value).abs() < 1e-16, "{} and {}", ours.value, theirs.value);
    }
}
