//! The first run of a scene's own model: it determines the sizes of the outputs, and the budget of other runs.

use super::outputs::{Watched, largest};
use super::plan::{COARSE, LAST, first_of, is_stiff_at};
use super::run_rows::Run;
use super::sampled_run::looks;
use integrators::{Failure, Method, Observer, Span, Tolerance};
use simulation::Problem;

/// The number of output times of a pilot run by Taylor's method: a multiple of those of references.
const DENSE: usize = 128;

/// A coarse run.
pub struct FirstRun {
    pub method: Method,
    pub run: Run,
    /// Times (s) and states, including the start.
    pub along: Vec<(f64, Vec<f64>)>,
}

impl FirstRun {
    /// A coarse run that reaches the end, and the number of evaluations of all attempts.
    ///
    /// # Errors
    /// The reason why no run reaches the end.
    pub fn of(own: &Problem) -> Result<(Self, u64), String> {
        let stiff = is_stiff_at(&*own.law, &own.state, own.span);
        let (mut spent, mut why) = (own.state.len() as u64, None);
        let found = first_of(stiff, |method, most| {
            if why.is_some() {
                return (None, 0);
            }
            // evaluations of a Taylor polynomial between steps cost little
            let times: Vec<f64> = match method {
                Method::Taylor => (1..=DENSE).map(|k| own.span * (k as f64 / DENSE as f64)).collect(),
                _ => looks(own.span).collect(),
            };
            let span = Span::new(0.0, own.span, &own.state).with_outputs(&times).with_evaluations(most);
            let mut seen = Seen { samples: Vec::new(), steps: Vec::new() };
            let (outcome, left) = own.integrate(method, &Tolerance::both(COARSE), &span, &mut seen);
            let evaluations = outcome.work.rates + outcome.work.jacobians * own.state.len() as u64;
            spent += evaluations;
            if outcome.reached() && left.is_none() && outcome.time == own.span {
                return (Some((seen, evaluations)), evaluations);
            }
            // a state that overflows with one method overflows with any
            let overflows = matches!(outcome.failure(), Some(Failure::LeftTheNumbers { .. }));
            if overflows {
                why = outcome.failure().map(|failure| failure.to_string());
            } else if outcome.reached() || left.is_some() {
                why = Some(left.unwrap_or("an event ends the run before its span").to_owned());
            } else if most >= LAST {
                let told = |failure: Failure| {
                    format!(
                        "the scene's own model does not reach its end, so that errors of smaller ones are not known: {failure}"
                    )
                };
                why = outcome.failure().map(told);
            }
            (None, evaluations)
        });
        let Some((method, (seen, evaluations))) = found else {
            return Err(why.unwrap_or_else(|| "no method reaches its end".to_owned()));
        };
        let row = |(time, state): &(f64, Vec<f64>)| (*time, (own.row)(*time, state));
        let states = own.state.len() - own.metered;
        let run = Run {
            asked: seen.samples.iter().map(row).collect(),
            steps: seen.steps.iter().map(row).collect(),
            evaluations,
        };
        let mut along: Vec<(f64, Vec<f64>)> =
            std::iter::once((0.0, own.state.clone())).chain(seen.samples).chain(seen.steps).collect();
        along.sort_by(|a, b| a.0.total_cmp(&b.0));
        along.dedup_by(|a, b| a.0 == b.0);
        along.iter_mut().for_each(|(_, state)| state.truncate(states));
        Ok((FirstRun { method, run, along }, spent))
    }

    /// The outputs with these names, and their sizes along the run.
    pub fn watched(&self, own: &Problem, names: &[String]) -> Watched {
        let start = (0.0, (own.row)(0.0, &own.state));
        let rows: Vec<&(f64, Vec<f64>)> =
            std::iter::once(&start).chain(&self.run.steps).chain(&self.run.asked).collect();
        let values: Vec<Vec<f64>> = rows.iter().map(|(_, row)| row.clone()).collect();
        let sizes =
            (0..own.state.len() - own.metered).map(|i| largest(self.along.iter().map(|(_, state)| state[i]))).collect();
        let watched = Watched::of(&own.columns, names, &values, sizes);
        let without_value = rows.into_iter().find_map(|(time, row)| {
            let place = watched.columns.iter().position(|&column| !row[column].is_finite())?;
            Some((watched.names[place].clone(), *time))
        });
        Watched { stiff: self.method.traits().implicit, without_value, ..watched }
    }
}

/// The states of a run at the requested times, and at its steps.
struct Seen {
    samples: Vec<(f64, Vec<f64>)>,
    steps: Vec<(f64, Vec<f64>)>,
}

impl Observer<f64> for Seen {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.samples.push((time, state.to_vec()));
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        self.steps.push((time, state.to_vec()));
    }
}
