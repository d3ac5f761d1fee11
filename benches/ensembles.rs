//! Ensembles of gyrostats with data and starts of their own, with 8 states (synchronous motor) and 15 (six damper bars),
//! on one core: trajectories of two seconds each second to a tolerance, and steps of the classical Runge-Kutta method times
//! systems each second. `cargo bench --bench ensembles`; beside others by `benches/ensembles_against.py`.

use derivations::ensemble::kind::{Kind, form_parameters};
use derivations::scene::{Axes, Family as _, Scene, System};
use integrators::{Ensemble, Failure, Members};
use std::time::Instant;

const LANES: usize = 8;
const MEMBERS: u64 = 4096;
const SPAN: f64 = 2.0;
const REPEATS: usize = 7;

fn main() {
    let text = std::fs::read_to_string("scenes/spin_up.toml").expect("it is there");
    let fifteen = text.replace("bars = 8", "bars = 6");
    let eight = text
        .replace("multi_current", "synchronous")
        .lines()
        .filter(|line| {
            !["a1", "l1", "r1", "a2", "l2", "r2", "mu", "bars", "outputs"]
                .iter()
                .any(|key| line.starts_with(&format!("{key} =")))
        })
        .collect::<Vec<_>>()
        .join("\n");
    println!("states form   tolerance order  trajectories/s   steps each  failures");
    for text in [eight, fifteen] {
        let scene = Scene::parse("bench", &text).unwrap_or_else(|error| panic!("{error}"));
        for axes in [Axes::First, Axes::Second] {
            for tolerance in [1e-6, 1e-9, 1e-12] {
                row(&scene, axes, tolerance);
            }
        }
    }
}

struct Feed<'a> {
    next: u64,
    end: u64,
    parameters: &'a [f64],
    state: &'a [f64],
    steps: u64,
    failed: u64,
    sum: f64,
}

impl Members for Feed<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        let number = self.next;
        self.next += 1;
        parameters.copy_from_slice(self.parameters);
        state.copy_from_slice(self.state);
        for (i, x) in parameters.iter_mut().enumerate() {
            *x *= 1.0 + 1e-2 * ((number * 37 + i as u64 * 11) % 101) as f64 / 101.0;
        }
        for (i, x) in state.iter_mut().enumerate() {
            *x += 1e-1 * ((number * 53 + i as u64 * 17) % 103) as f64 / 103.0;
        }
        (number < self.end).then_some(number)
    }
    fn ended(&mut self, _: u64, state: &[f64], steps: u64, failure: Option<Failure>) {
        self.steps += steps;
        self.failed += u64::from(failure.is_some());
        self.sum += state[0];
    }
}

fn row(scene: &Scene, axes: Axes, tolerance: f64) {
    let kind = Kind::record(&scene.system, &scene.machine, &scene.machine_data, axes).expect("it can be written down");
    let mut parameters = form_parameters(&scene.system, axes);
    parameters.extend(scene.machine_data.numbers.iter().map(|(_, x)| *x));
    let state = scene.state(axes);
    let _ = matches!(scene.system, System::Gyrostat(_));
    let order = Ensemble::<Box<dyn integrators::LaneSeries<LANES>>, LANES>::order(tolerance);
    let series = kind.series::<LANES>(order).expect("it fits");
    let mut ensemble = Ensemble::new(series, tolerance, SPAN, kind.states(), kind.parameters());
    let mut times = Vec::new();
    let mut feed = Feed { next: 0, end: 0, parameters: &parameters, state: &state, steps: 0, failed: 0, sum: 0.0 };
    for _ in 0..REPEATS {
        feed = Feed { next: 0, end: MEMBERS, steps: 0, failed: 0, ..feed };
        let start = Instant::now();
        ensemble.run(&mut feed);
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    println!(
        "{:>6} {axes:<7} {tolerance:>8.0e} {order:>5} {:>14.0} {:>12.1} {:>9} step {:.0} ns/system",
        kind.states(),
        MEMBERS as f64 / times[REPEATS / 2],
        feed.steps as f64 / MEMBERS as f64,
        feed.failed,
        times[REPEATS / 2] * 1e9 / feed.steps as f64
    );
}
