//! Stability of a splitting near a motion: tests at single step sizes, in addition to proofs for all step sizes.

use super::continuation::before;
use super::reasons::Unproved;
use super::splittings::Own;
use super::step_intervals::{Proved, does};
use integrators::Splitting;

/// The test results of a splitting near a motion.
#[derive(Clone, Debug)]
pub struct Tested {
    pub splitting: Splitting,
    /// The fixed points, each with its step size, s, ascending.
    pub own: Vec<(f64, Own)>,
    /// Whether the map is unstable for each requested step size, s; `None` where a step fails or no fixed point is
    /// found.
    pub grows: Vec<(f64, Option<bool>)>,
    /// The thresholds between them, s: from the proof if there is one.
    pub edges: Vec<f64>,
    /// The proved verdicts for all step sizes between the first and the last, or the reason why there is no proof.
    pub proved: Result<Proved, Unproved>,
    /// The longest accepted step, s; zero if the law has no splitting.
    pub longest: f64,
}

impl Tested {
    /// The results in one line.
    pub fn told(&self) -> String {
        if self.longest == 0.0 {
            return format!("there is none, since {}", Unproved::Fed);
        }
        let known: Vec<(f64, bool)> = self.grows.iter().filter_map(|(step, grows)| Some((*step, (*grows)?))).collect();
        let (Some((from, grows)), Some((to, _))) = (known.first(), known.last()) else {
            return "no step is taken, or no stationary motion of its own is found".to_owned();
        };
        let longest =
            if self.longest.is_finite() { format!("; no step beyond {:.4e}", self.longest) } else { String::new() };
        match &self.proved {
            Ok(proved) => {
                let alone = proved.open().into_iter().map(|ends| self.tested_alone(proved, ends)).collect::<String>();
                format!("proved from {from:.1e} to {to:.1e}: the map {}{alone}{longest}", proved.told())
            }
            Err(reason) => {
                let turns = self
                    .edges
                    .iter()
                    .enumerate()
                    .map(|(place, edge)| format!(", {} from h = {edge:.4e} on", does(*grows != (place % 2 == 0))));
                let told = turns.fold(does(*grows).to_owned(), |told, turn| told + &turn);
                format!("tested from {from:.1e} to {to:.1e}, since {reason}: the map {told}{longest}")
            }
        }
    }

    /// The test results in an interval that the proof leaves undecided, in words.
    fn tested_alone(&self, proved: &Proved, [low, high]: [f64; 2]) -> String {
        let inside = self.grows.iter().filter(|(step, _)| (low..=high).contains(step));
        let seen: Vec<(f64, bool)> = inside.filter_map(|(step, grows)| Some((*step, (*grows)?))).collect();
        let steps = seen.len();
        let growing = seen.iter().filter(|(_, grows)| *grows).count();
        let says = match seen.iter().filter(|(step, _)| proved.at(*step).is_some()).count() {
            0 => "tested".to_owned(),
            known if known == steps => "proved step by step".to_owned(),
            known => format!("tested, {known} proved,"),
        };
        let grows = match (growing, steps) {
            (_, 0) => return String::new(),
            (0, _) => "does not grow at the steps that were looked at".to_owned(),
            (some, all) if some == all => "grows at the steps that were looked at".to_owned(),
            (some, all) => format!("grows at {some} of {all} steps"),
        };
        format!("; {says} from {low:.4e} to {high:.4e}: {grows}")
    }

    /// The fixed point at the last step size up to a given one, s.
    pub fn before(&self, step: f64) -> Option<&Own> {
        before(&self.own, step)
    }

    /// Whether a step size (s) is rejected because negative sub-steps would amplify decaying components.
    pub fn refuses(&self, step: f64) -> bool {
        step > self.longest
    }
}
