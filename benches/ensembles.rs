//! Ensembles of gyrostats with data and starts of their own, with 8 states (synchronous motor) and 15 (six damper bars),
//! on one thread: trajectories of two seconds in each second, and steps of the classical Runge-Kutta method times systems
//! in each second, by the law that runs, evaluated in lanes. Time is the thread's own, since computers are shared.
//!
//! `cargo bench --bench ensembles`; beside others by `benches/ensembles_against.py`.

use derivations::ensemble::kind::{Kind, form_parameters};
use derivations::machines::Machine;
use derivations::machines::multi_current::{MultiCurrent, Windings};
use derivations::machines::synchronous::Synchronous;
use derivations::scene::{Axes, Family as _, Scene};
use derivations::systems::gyrostat::driven::Driven;
use derivations::systems::gyrostat::forms::SecondForm;
use field::Lanes;
use integrators::{Ensemble, Failure, Members, runge_kutta_4_step, taylor_order};
use nalgebra::Vector3;
use std::time::Instant;

const LANES: usize = 8;
const MEMBERS: u64 = 2048;
const SPAN: f64 = 2.0;
const REPEATS: usize = 5;
const STEPS: usize = 20_000;

/// A gyrostat that swings while its rotor runs beside the field.
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
    println!("states   what                     per second   steps each   failed");
    for machine in [SINGLE, BARS] {
        let scene = Scene::parse("bench", &format!("{SCENE}{machine}")).unwrap_or_else(|error| panic!("{error}"));
        for axes in [Axes::First, Axes::Second] {
            for tolerance in [1e-6, 1e-9, 1e-12] {
                trajectories(&scene, axes, tolerance);
            }
        }
        runge_kutta(&scene);
    }
}

/// Members that differ in all their data and in their starts.
struct Spread<'a> {
    next: u64,
    parameters: &'a [f64],
    state: &'a [f64],
    steps: u64,
    failed: u64,
}

/// Around one, by a percent.
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

    fn ended(&mut self, _: u64, _: &[f64], steps: u64, _: f64, failure: Option<Failure>) {
        self.steps += steps;
        self.failed += u64::from(failure.is_some());
    }
}

fn trajectories(scene: &Scene, axes: Axes, tolerance: f64) {
    let kind = Kind::record(&scene.system, &scene.machine, &scene.machine_data, axes);
    let kind = kind.unwrap_or_else(|error| panic!("{error}"));
    let (_, mut parameters) = form_parameters(&scene.system, axes);
    parameters.extend(scene.machine_data.numbers.iter().map(|(_, value)| *value));
    let state = scene.state(axes);
    let Some(series) = kind.series::<LANES>(taylor_order(tolerance)) else { return };
    let mut ensemble = Ensemble::new(series, tolerance, SPAN, kind.states(), kind.parameters());
    let mut spread = Spread { next: 0, parameters: &parameters, state: &state, steps: 0, failed: 0 };
    let time = median(|| {
        spread = Spread { next: 0, steps: 0, failed: 0, ..spread };
        ensemble.run(&mut spread);
    });
    let (rate, steps) = (MEMBERS as f64 / time, spread.steps as f64 / MEMBERS as f64);
    println!("{:>6}   {axes:<7} to {tolerance:<6.0e} {rate:>18.0} {steps:>12.1} {:>8}", kind.states(), spread.failed);
}

fn runge_kutta(scene: &Scene) {
    let (_, parameters) = form_parameters(&scene.system, Axes::Second);
    let mut next = 0;
    let mut lanes = |value: f64| {
        next += 1;
        Lanes::<LANES>(std::array::from_fn(|lane| value * near_one(lane as u64, next)))
    };
    let p: Vec<Lanes<LANES>> = parameters.iter().map(|p| lanes(*p)).collect();
    let three = |i: usize| Vector3::new(p[i], p[i + 1], p[i + 2]);
    let form = SecondForm::new(three(0), three(3), p[6], three(7));
    let start: Vec<Lanes<LANES>> = scene.state(Axes::Second).iter().map(|y| lanes(*y)).collect();
    let number = |name: &str| -> f64 {
        scene.machine_data.numbers.iter().find(|(q, _)| q.name == name).map_or(0.0, |(_, value)| *value)
    };
    match start.len() {
        8 => {
            let Ok(machine) = Synchronous::read(|q| Ok::<_, std::convert::Infallible>(lanes(number(q.name))));
            in_lanes(&Driven::new(form, machine), &start);
        }
        _ => {
            let Ok(windings) = Windings::read(|q| Ok::<_, std::convert::Infallible>(lanes(number(q.name))));
            in_lanes(&Driven::new(form, MultiCurrent::evenly(windings, 6)), &start);
        }
    }
}

fn in_lanes<M: Machine<Lanes<LANES>>>(law: &Driven<Lanes<LANES>, SecondForm<Lanes<LANES>>, M>, start: &[Lanes<LANES>]) {
    let mut state = start.to_vec();
    let time = median(|| {
        state.copy_from_slice(start);
        pulp::Arch::new().dispatch(Steps { law, state: &mut state });
    });
    let finite = state.iter().all(|y| y.0.iter().all(|y| y.is_finite()));
    let rate = (STEPS * LANES) as f64 / time;
    println!("{:>6}   RK4 steps x systems {rate:>15.2e} {:>12} {:>8}", state.len(), STEPS, u8::from(!finite));
}

struct Steps<'a, M> {
    law: &'a Driven<Lanes<LANES>, SecondForm<Lanes<LANES>>, M>,
    state: &'a mut [Lanes<LANES>],
}

impl<M: Machine<Lanes<LANES>>> pulp::WithSimd for Steps<'_, M> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let room = || vec![Lanes::all(0.0); self.state.len()];
        let (mut slopes, mut stage, mut after) = ([room(), room(), room(), room()], room(), room());
        let (time, step) = (Lanes::all(0.0), Lanes::all(SPAN / STEPS as f64));
        for _ in 0..STEPS {
            let rates = |_, y: &[Lanes<LANES>], dy: &mut [Lanes<LANES>]| self.law.rates(y, dy);
            runge_kutta_4_step(rates, time, self.state, step, &mut slopes, &mut stage, &mut after);
            self.state.copy_from_slice(&after);
        }
    }
}

/// The median time of a few repetitions, s.
fn median(mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let (own, start) = (own_time(), Instant::now());
            work();
            own_time().zip(own).map_or_else(|| start.elapsed().as_secs_f64(), |(after, before)| after - before)
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}

/// For how long this thread has been running, s; where the system says so.
fn own_time() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split(' ').next()?.parse::<f64>().ok()? * 1e-9)
}
