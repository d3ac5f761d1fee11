//! The hierarchy of motor models: their equivalences and limits, and their behaviour on a bench.

use crate::physical::machines::{Sample, every_machine, numbers};
use crate::physical::rate::rate;
use crate::physical::{fixed, gyrostat, rounded};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::equivalent_windings::EquivalentWindings;
use dalembert_derivations::machines::kloss::Kloss;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::Form;
use field::{Circle, Rational, Scalar};
use integrators::{Method, Span, Tolerance, integrate};
use motor::{Bench, Machine, Motor, electrical_power, joule_heat, motional_torque, torque_and_current_rates};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use proptest::prelude::*;
use simulation::{CompiledLaw, SymbolicLaw};

fn windings() -> Windings<f64> {
    Windings { field_speed: 9.0, b0: 0.8, a1: 0.5, l1: 0.3, r1: 0.7, a2: 0.4, l2: 0.2, r2: 0.9, mu: 0.02, f: 0.05 }
}

/// The state after a time, by a number of steps of the classical Runge-Kutta method.
fn after(law: impl SymbolicLaw + 'static, state: &[f64], time: f64, steps: u32) -> Vec<f64> {
    let system = CompiledLaw::new(law);
    let (method, span) = (Method::RungeKutta4 { steps }, Span::new(0.0, time, state));
    let outcome = integrate(&system, method, &Tolerance::both(1e-9), &span, &mut ());
    assert!(outcome.reached(), "{:?}", outcome.end);
    outcome.state
}

fn largest_gap<'a>(a: impl IntoIterator<Item = &'a f64>, b: impl IntoIterator<Item = &'a f64>) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn rational() -> impl Strategy<Value = Rational> {
    (-40..40i64, 1..9i64).prop_map(|(n, d)| Rational::new(n, d))
}

fn positive() -> impl Strategy<Value = Rational> {
    (1..40i64, 1..9i64).prop_map(|(n, d)| Rational::new(n, d))
}

proptest! {
    #![proptest_config(fixed(6))]

    /// The equivalent currents are linear in those of the bars, and a Runge-Kutta method commutes with linear maps: the
    /// runs differ by rounding only.
    #[test]
    fn any_number_of_bars_moves_like_its_equivalent_windings(g in gyrostat(), sample in numbers()) {
        let form = rounded(&g).second_form().0;
        for bars in 1..=12 {
            let last = -Circle::turn(1, 8);
            let all = Driven::new(form, MultiCurrent::evenly(windings(), bars));
            let two = Driven::new(form, EquivalentWindings::new(windings(), bars, last));
            let lines = two.machine.windings() - 1;
            let lump = |state: &[f64]| -> Vec<f64> {
                let axes = [last, last + Circle::turn(1, 4)];
                let lumped = axes.iter().take(lines).map(|&axis| {
                    let along = all.machine.bars.iter().zip(&state[9..]).map(|(&bar, i)| i * (bar - axis).cos);
                    along.sum::<f64>() / (bars as f64 / lines as f64).sqrt()
                });
                state[..9].iter().copied().chain(lumped).collect()
            };
            let state = sample.state(all.dimension());
            let end = lump(&after(all.clone(), &state, 0.5, 400));
            let gap = largest_gap(&end, &after(two, &lump(&state), 0.5, 400));
            prop_assert!(gap < 1e-10, "{bars} bars: {gap:e}");
        }
    }

    #[test]
    fn a_machine_in_a_carrier_too_heavy_to_turn_runs_as_on_the_bench(sample in numbers()) {
        for machine in every_machine(&sample) {
            let name = machine.name();
            let gap = off_the_bench(machine, &sample);
            prop_assert!(gap < 1e-8, "{name}: {gap:e}");
        }
    }
}

/// The distance between the rotor's motion on a bench and in a gyrostat with a carrier of 1e12 kg m^2, after a run.
fn off_the_bench(machine: Motor, sample: &Sample) -> f64 {
    let mut g = rounded(&dalembert_derivations::papers::konosevich2022::gyrostats::spherical().gyrostat);
    g.carrier.inertia = Matrix3::identity() * 1e12;
    let bench = Bench { machine: machine.clone(), axial: g.rotor.axial };
    let heavy = Driven::new(g.first_form().0, machine);
    let mut state = sample.state(heavy.dimension());
    state[..3].fill(0.0);
    let end = after(heavy, &state, 1.0, 200);
    let at_rest = largest_gap(&end[..6], &state[..6]);
    if bench.dimension() == 0 {
        return at_rest;
    }
    at_rest.max(largest_gap(&end[6..], &after(bench, &state[6..], 1.0, 200)))
}

/// Whether the power loss of a bench, W, agrees with its laws.
fn goes_where_it_is_sent(machine: Motor, sample: &Sample) -> bool {
    let bench = Bench { machine, axial: 0.7 };
    let y: Vec<f64> = sample.state(6 + bench.dimension()).split_off(6);
    let mut dy = vec![0.0; y.len()];
    bench.rates(&y, &mut dy);
    let known = bench.machine.rotor();
    let (rotor, currents) = y.split_at(known.dimension());
    let (angle, slip) = known.angle_and_slip(rotor);
    let frame_speed = bench.machine.frame_speed();
    let moment = torque_and_current_rates(&bench.machine, angle, slip, currents, &mut vec![0.0; currents.len()]);
    let (law, lost) = (bench.machine.torque_law(slip, slip + frame_speed), joule_heat(&bench.machine, currents));
    let (given, slides) =
        (electrical_power(&bench.machine, angle, currents), motional_torque(&bench.machine, currents));
    let (field, friction) = (frame_speed * (moment - law - slides), (slip + frame_speed) * law);
    rate(|y| bench.rotor_momentum(y), &y, &dy).is(&[moment])
        && rate(|y| bench.energy(y), &y, &dy).is(&[field, friction, given, -lost])
        && rate(|y| bench.jacobi(y), &y, &dy).is(&[law * slip, -lost, given, -frame_speed * slides])
}

proptest! {
    #![proptest_config(fixed(64))]

    #[test]
    fn on_the_bench_the_energy_goes_where_the_laws_send_it(sample in numbers()) {
        for machine in every_machine(&sample) {
            let name = machine.name();
            prop_assert!(goes_where_it_is_sent(machine, &sample), "{name}");
        }
    }

    #[test]
    fn without_coupling_and_damping_the_multi_current_motor_is_the_synchronous_one(
        data in [positive(), positive(), positive(), positive(), positive(), positive(), positive()],
        half in rational(), slip in rational(), currents in [rational(), rational(), rational()]
    ) {
        let o = Rational::zero();
        let [field_speed, b0, l1, r1, l2, r2, f] = data;
        let windings = Windings { field_speed, b0, a1: o, l1, r1, a2: o, l2, r2, mu: o, f };
        let idle = MultiCurrent { windings, bars: [half, slip].map(Circle::from_half_tangent).into() };
        let synchronous = Synchronous { field_speed, b0, f };
        let (angle, mut rates) = (Circle::from_half_tangent(half), [o; 3]);
        let moment = torque_and_current_rates(&idle, angle, slip, &currents, &mut rates);
        prop_assert_eq!(moment, torque_and_current_rates(&synchronous, angle, slip, &[], &mut []));
        // M = -b0 sin g - f phi', and the currents decay independently
        prop_assert_eq!(moment, -(b0 * angle.sin) - f * (slip + field_speed));
        prop_assert_eq!(rates, [-(r1 / l1 * currents[0]), -(r2 / l2 * currents[1]), -(r2 / l2 * currents[2])]);
    }

    /// Kloss' torque is the linear one with the slope 2 m_k / (s_k W), divided by 1 + (s/s_k)^2; the two agree at small
    /// slip.
    #[test]
    fn kloss_moment_is_the_linear_one_at_small_slip(data in [positive(), positive(), positive(), positive()], slip in rational()) {
        let [field_speed, pull_out, pull_out_slip, f] = data;
        let kloss = Kloss { field_speed, pull_out, pull_out_slip, f };
        let linear = Asynchronous { field_speed, k: Rational::int(2) * pull_out / (pull_out_slip * field_speed), f };
        let speed = slip + field_speed;
        let ratio = slip / (field_speed * pull_out_slip);
        let of_slip = |moment: Rational| moment + f * speed;
        prop_assert_eq!(
            of_slip(kloss.torque_law(slip, speed)) * (Rational::int(1) + ratio * ratio),
            of_slip(linear.torque_law(slip, speed))
        );
        prop_assert_eq!(of_slip(linear.torque_law(slip, speed)), -(linear.k * slip));
        let at_pull_out = -(pull_out_slip * field_speed);
        prop_assert_eq!(kloss.torque_law(at_pull_out, Rational::zero()), pull_out);
    }

    #[test]
    fn a_kept_speed_has_the_same_reaction_in_both_forms_and_no_other_moment_keeps_it(g in gyrostat(), sample in numbers()) {
        let g = rounded(&g);
        let state = sample.state(7);
        let (w, v, speed) = (Vector3::from_column_slice(&state[..3]), Vector3::from_column_slice(&state[3..6]), state[6]);
        let ((first, a), (second, b)) = (g.first_form(), g.second_form());
        let (first_rate, reaction) = first.prescribed(a.transpose() * w, a.transpose() * v, speed);
        let (second_rate, same) = second.prescribed(b.transpose() * w, b.transpose() * v, speed);
        let size = (first_rate.norm() + w.norm() * (w.norm() + speed.abs())) * g.full_tensor().norm() + g.weight().norm();
        prop_assert!((reaction - same).abs() <= 1e-12 * size);
        prop_assert!((a * first_rate - b * second_rate).norm() * g.full_tensor().norm() <= 1e-11 * size);
        let (_, still) = first.accelerations(a.transpose() * w, a.transpose() * v, speed, reaction);
        let (_, moving) = first.accelerations(a.transpose() * w, a.transpose() * v, speed, reaction + size);
        prop_assert!(still.abs() * g.rotor.axial <= 1e-12 * size);
        prop_assert!(moving.abs() * g.rotor.axial > 0.5 * size);
    }
}

/// The torque -N/2 a2^2 R2 g' / (R2^2 + L2^2 g'^2) is Kloss' torque with the critical slip R2 / (L2 W) and the pull-out
/// torque N a2^2 / (4 L2).
#[test]
fn at_constant_slip_the_damper_has_kloss_moment() {
    let damper = Windings { b0: 0.0, a1: 0.0, mu: 0.0, f: 0.0, ..windings() };
    let Windings { field_speed, a2, l2, r2, .. } = damper;
    for bars in 3..=9 {
        let pull_out = bars as f64 * a2 * a2 / (4.0 * l2);
        let kloss = Kloss { field_speed, pull_out, pull_out_slip: r2 / (l2 * field_speed), f: 0.0 };
        for slip in [-9.0, -2.0, 0.3, 5.0] {
            // a rotor with practically infinite moment of inertia
            let bench = Bench { machine: MultiCurrent::evenly(damper, bars), axial: 1e12 };
            let mut start = vec![0.0; bench.dimension()];
            start[1] = slip;
            let end = after(bench.clone(), &start, 30.0 * l2 / r2, 6000);
            let (angle, mut rates) = (field::Analytic::circle(end[0]), vec![0.0; bars + 1]);
            let moment = torque_and_current_rates(&bench.machine, angle, end[1], &end[2..], &mut rates);
            let expected = kloss.torque_law(slip, slip + field_speed);
            assert!((moment - expected).abs() < 1e-9 * pull_out, "{bars} bars at {slip}: {moment} and {expected}");
        }
    }
}
