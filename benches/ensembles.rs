//! Timing of ensembles of gyrostats in which every member has its own data and initial state, with 8 states
//! (synchronous motor) and with 15 (six damper bars), on one thread. Reported are the trajectories of two seconds
//! computed per second, with the largest error of any member relative to a reference run with tolerance 1e-15; and the
//! steps of the classical Runge-Kutta method times systems per second, for the compiled law evaluated in SIMD lanes.
//!
//! Run it by `cargo bench --bench ensembles`; `benches/peers/ensembles.py` compares it with other tools.

use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::studies::ensemble::kind::{Kind, form_parameters};
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::SecondForm;
use field::Batch;
use integrators::{BatchRungeKutta4, Ensemble, Failure, Members, Ode, batch_order, fuses};
use nalgebra::Vector3;
use reader::Family as _;
use simulation::Axes;
use std::time::Instant;

/// The width of the batches of steps: two registers per number, to hide the latency of operations.
const WIDE: usize = 16;
const MEMBERS: u64 = 2048;
const SPAN: f64 = 2.0;
const REPEATS: usize = 9;
const STEPS: usize = 20_000;

/// A gyrostat that oscillates while its rotor slips against the field.
const SCENE: &str = r#"
title = "bench"
system = "gyrostat"
gravity = "9.81 m/s^2"
[carrier]
mass = "1.5 kg"
centre = "0.01 -0.02 0.05 m"
inertia = "0.02 0.001 -0.002; 0.001 0.03 0.0005; -0.002 0.0005 0.025 kg m^2"
[rotor]
mass = "0.4 kg"
centre = "0 0.03 0.04 m"
axis = "0 0.6 0.8"
axial = "3e-4 kg m^2"
transverse = "2e-4 kg m^2"
[start]
angular_velocity = "1 -2 3 rad/s"
vertical = "0.6 0 0.8"
rotor_angle = "0.3 rad"
rotor_speed = "29 rad/s"
[run]
span = "2 s"
[machine]
field_speed = "30 rad/s"
b0 = "0.05 N m"
f = "1e-4 N m s"
"#;
const SINGLE: &str = "model = \"synchronous\"\n";
const BARS: &str = "model = \"multi_current\"\na1 = \"0.01 Wb\"\nl1 = \"0.01 H\"\nr1 = \"1 ohm\"\na2 = \"0.01 Wb\"\n\
                    l2 = \"0.01 H\"\nr2 = \"1 ohm\"\nmu = \"1e-4 N m s\"\nbars = 6\n";

fn main() {
    println!("states   what                     per second   steps each   failed   error");
    for machine in [SINGLE, BARS] {
        let scene = Scene::parse("bench", &format!("{SCENE}{machine}")).unwrap_or_else(|error| panic!("{error}"));
        for axes in [Axes::First, Axes::Second] {
            trajectories(&scene, axes);
        }
        if fuses() { runge_kutta::<true>(&scene) } else { runge_kutta::<false>(&scene) }
    }
}

/// Ensemble members that differ in all their data and in their initial states.
struct Spread<'a> {
    next: u64,
    parameters: &'a [f64],
    state: &'a [f64],
    steps: u64,
    failed: u64,
    /// The final states, concatenated.
    ends: Vec<f64>,
}

/// A factor within one percent of one, different for each member.
fn near_one(member: u64, i: usize) -> f64 {
    1.0 + 1e-4 * ((member * 37 + 11 * i as u64) % 101) as f64
}

impl Members for Spread<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        self.next += 1;
        let spread = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).enumerate().for_each(|(i, (to, from))| *to = from * near_one(self.next, i));
        };
        spread(parameters, self.parameters);
        spread(state, self.state);
        (self.next <= MEMBERS).then_some(self.next)
    }

    fn ended(&mut self, number: u64, state: &[f64], steps: u64, _: f64, failure: Option<Failure>) {
        self.ends[(number as usize - 1) * state.len()..][..state.len()].copy_from_slice(state);
        self.steps += steps;
        self.failed += u64::from(failure.is_some());
    }
}

fn trajectories(scene: &Scene, axes: Axes) {
    let kind = Kind::record(&scene.system, &scene.machine, axes);
    let kind = kind.unwrap_or_else(|error| panic!("{error}"));
    let (_, mut parameters) = form_parameters(&scene.system, axes);
    parameters.extend(scene.machine.values());
    let state = scene.state(axes);
    let n = kind.states();
    let ends = vec![0.0; n * MEMBERS as usize];
    let mut spread = Spread { next: 0, parameters: &parameters, state: &state, steps: 0, failed: 0, ends };
    let mut run = |tolerance: f64, repeats: usize| {
        let series = kind.series(batch_order(tolerance))?;
        let mut ensemble = Ensemble::new(series, tolerance, SPAN, n, kind.parameters());
        let time = median(repeats, || {
            (spread.next, spread.steps, spread.failed) = (0, 0, 0);
            ensemble.run(&mut spread);
        });
        Some((time, spread.steps, spread.failed, spread.ends.clone()))
    };
    let Some((.., exact)) = run(1e-15, 1) else { return };
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let Some((time, steps, failed, ends)) = run(tolerance, REPEATS) else { continue };
        let off = |(a, b): (&f64, &f64)| (a - b).abs() / b.abs().max(1.0);
        let error = ends.iter().zip(&exact).map(off).fold(0.0, f64::max);
        let (rate, steps) = (MEMBERS as f64 / time, steps as f64 / MEMBERS as f64);
        println!("{n:>6}   {axes:<7} to {tolerance:<6.0e} {rate:>18.0} {steps:>12.1} {failed:>8}   {error:.1e}");
    }
    println!("{n:>6}   {axes:<7} ends at {:?}", &exact[..n]);
}

fn runge_kutta<const FUSED: bool>(scene: &Scene) {
    let (_, parameters) = form_parameters(&scene.system, Axes::Second);
    let mut next = 0;
    let mut lanes = |value: f64| {
        next += 1;
        Batch::<WIDE, FUSED>(std::array::from_fn(|lane| value * near_one(lane as u64, next)))
    };
    let p: Vec<_> = parameters.iter().map(|p| lanes(*p)).collect();
    let three = |i: usize| Vector3::new(p[i], p[i + 1], p[i + 2]);
    let form = SecondForm::new(three(0), three(3), p[6], three(7));
    let start: Vec<_> = scene.state(Axes::Second).iter().map(|y| lanes(*y)).collect();
    let number = |name: &str| scene.machine.datum(name).unwrap_or_default();
    match start.len() {
        8 => {
            let Ok(machine) = Synchronous::read(|q| Ok::<_, std::convert::Infallible>(lanes(number(&q.name))));
            in_lanes(&Driven::new(form, machine), &start);
        }
        _ => {
            let Ok(windings) = Windings::read(|q| Ok::<_, std::convert::Infallible>(lanes(number(&q.name))));
            in_lanes(&Driven::new(form, MultiCurrent::evenly(windings, 6)), &start);
        }
    }
}

fn in_lanes<const FUSED: bool>(law: &impl Ode<Batch<WIDE, FUSED>>, start: &[Batch<WIDE, FUSED>]) {
    let (mut state, mut room) = (start.to_vec(), BatchRungeKutta4::new(start.len()));
    let time = median(REPEATS, || {
        state.copy_from_slice(start);
        room.steps(law, 0.0, SPAN / STEPS as f64, STEPS, &mut state);
    });
    let finite = state.iter().all(|y| y.0.iter().all(|y| y.is_finite()));
    let rate = (STEPS * WIDE) as f64 / time;
    println!("{:>6}   RK4 steps x systems {rate:>15.2e} {:>12} {:>8}", state.len(), STEPS, u8::from(!finite));
}

/// The median time of a few repetitions, s.
fn median(repeats: usize, mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..repeats)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[repeats / 2]
}
