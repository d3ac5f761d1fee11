//! A scene run: its trajectory in the axes of the data.

use super::state::ROTOR_SPEED;
use super::{Axes, Scene};
use crate::machines::{Catalogued, ForMachine};
use integrators::{Method, Observer, Outcome, Span, Tolerance, integrate};
use std::time::{Duration, Instant};

/// How a scene is to be run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    pub method: Method,
    pub tolerance: f64,
    pub axes: Axes,
    /// Instants kept beside the start.
    pub samples: usize,
    /// After so long the run is stopped, and what there is is kept.
    pub allowed: Duration,
}

/// A run, whether it reached its end or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// Of the states, then `rotor_speed`.
    pub names: Vec<String>,
    pub times: Vec<f64>,
    /// One row for each time: the states in the axes of the data, then the rotor's relative speed.
    pub rows: Vec<Vec<f64>>,
    /// The last good state, written like a row.
    pub last: Vec<f64>,
    /// As the integrator gave it, in the axes of the form.
    pub outcome: Outcome<f64>,
}

impl Scene {
    /// What the scene itself asks for.
    pub fn choice(&self) -> Choice {
        let run = &self.run;
        Choice {
            method: run.method,
            tolerance: run.tolerance,
            axes: Axes::First,
            samples: run.samples,
            allowed: Duration::from_secs(300),
        }
    }

    /// Runs. `progress` is told the fraction done after every step.
    pub fn simulate(&self, choice: &Choice, progress: impl FnMut(f64)) -> Trajectory {
        let problem = self.problem(choice.axes);
        let samples = divisor(choice.method, choice.samples);
        let mut span = Span::new(0.0, self.run.span, &problem.state)
            .with_even_outputs(samples)
            .with_deadline(Instant::now() + choice.allowed);
        span.outputs.insert(0, 0.0);
        for invariant in &problem.invariants {
            span = span.with_monitor(invariant.name, |_, y| (invariant.value)(y));
        }
        let row = self.row(choice.axes);
        let mut kept = Kept { row: &row, times: Vec::new(), rows: Vec::new(), progress };
        let tolerance = Tolerance::both(choice.tolerance);
        let outcome = integrate(&*problem.law, choice.method, &tolerance, &span, &mut kept);
        let (times, rows) = (kept.times, kept.rows);
        let mut names = self.names();
        names.push(ROTOR_SPEED.to_owned());
        Trajectory { names, times, rows, last: row(&outcome.state), outcome }
    }

    /// From a state in the axes of a form to a row in the axes of the data.
    fn row(&self, axes: Axes) -> impl Fn(&[f64]) -> Vec<f64> {
        let back = self.back(axes);
        let frame_speed = self.machine.clone().apply(FrameSpeed);
        let slip = self.names().iter().position(|name| name == "slip");
        move |state| {
            let mut row = state.to_vec();
            back(&mut row);
            row.push(frame_speed + slip.map_or(0.0, |slip| state[slip]));
            row
        }
    }
}

/// Methods land their steps on the samples. One of constant step keeps its steps only where their number is a multiple.
fn divisor(method: Method, samples: usize) -> usize {
    let (Method::Euler { steps }
    | Method::RungeKutta4 { steps }
    | Method::BackwardEuler { steps }
    | Method::ImplicitMidpoint { steps }) = method
    else {
        return samples;
    };
    let steps = steps as usize;
    (1..=samples.min(steps)).rev().find(|samples| steps.is_multiple_of(*samples)).unwrap_or(1)
}

impl Trajectory {
    /// The column of a name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }
}

/// Keeps the rows, and passes the progress on.
struct Kept<R, F> {
    row: R,
    times: Vec<f64>,
    rows: Vec<Vec<f64>>,
    progress: F,
}

impl<R: Fn(&[f64]) -> Vec<f64>, F: FnMut(f64)> Observer<f64> for Kept<R, F> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.times.push(time);
        self.rows.push((self.row)(state));
    }

    fn progress(&mut self, fraction: f64) {
        (self.progress)(fraction);
    }
}

struct FrameSpeed;

impl ForMachine for FrameSpeed {
    type Output = f64;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> f64 {
        machine.frame_speed()
    }
}
