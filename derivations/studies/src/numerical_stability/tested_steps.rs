//! What a splitting was seen to do near a motion, step by step, beside what is proved of every step.

use super::continuation::before;
use super::reasons::Unproved;
use super::splittings::Own;
use super::step_intervals::{Proved, does};
use integrators::Splitting;

/// What a splitting was seen to do near a motion.
#[derive(Clone, Debug)]
pub struct Tested {
    pub splitting: Splitting,
    /// Its own motions, each with its step, s, in ascending order.
    pub own: Vec<(f64, Own)>,
    /// Whether anything grows, at each step, s, that was asked for; `None` where no step is taken, or no motion of the
    /// splitting's own is found.
    pub grows: Vec<(f64, Option<bool>)>,
    /// Between them, where that changes, s: by the proof where there is one.
    pub edges: Vec<f64>,
    /// What it does at every step between the first and the last, or why nothing is proved of that.
    pub proved: Result<Proved, Unproved>,
    /// The longest step that the program takes, s; zero where the law has no splitting.
    pub longest: f64,
}

impl Tested {
    /// In a line.
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

    /// What was seen where the proof leaves something open.
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

    /// The motion at the last step up to one, s.
    pub fn before(&self, step: f64) -> Option<&Own> {
        before(&self.own, step)
    }

    /// Whether a step is refused, since what fades would grow on its way back.
    pub fn refuses(&self, step: f64) -> bool {
        step > self.longest
    }
}
