//! What was asked for, what was chosen, and why.

use super::Loss;
use super::estimate::Estimate;
use super::plan::Plan;
use super::watched::Watched;
use std::time::Duration;

/// What is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Wish {
    /// Relative to the size of each output.
    pub tolerance: f64,
    pub outputs: Vec<String>,
    /// For the times, and before that for where to switch; nothing of either where it is zero.
    pub allowed: Duration,
}

/// The share of the tolerance that the model may take; the method has the rest.
pub const OF_MODEL: f64 = 0.5;
/// Where the second order is more than this share of the first, the estimate is no estimate.
const BELIEVED: f64 = 0.5;
/// Errors below this share of what is allowed need no belief.
const MINUTE: f64 = 1e-3;

/// A rung as the receipt has it.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    pub dropped: String,
    pub loss: Loss,
    pub states: usize,
    /// Why there is none, in words, where it was not carried.
    pub model: Result<Estimate, String>,
    /// Why it is not taken, where it cannot be.
    pub verdict: Verdict,
    /// The best run of it.
    pub choice: Option<Choice>,
}

impl Line {
    /// The scene's own model.
    pub fn own(name: &str, states: usize, outputs: usize) -> Self {
        let model = Ok(Estimate::nothing(outputs));
        let (dropped, loss, verdict) = (String::new(), Loss::Own, Verdict::Suffices);
        Line { name: name.to_owned(), dropped, loss, states, model, verdict, choice: None }
    }
}

impl Verdict {
    /// Of a model by its estimate.
    pub fn of(model: &Result<Estimate, String>, tolerance: f64) -> Self {
        match model {
            Err(_) => Verdict::NotCarried,
            Ok(model) if model.second > BELIEVED * model.first.max(MINUTE * tolerance) => Verdict::NotBelieved,
            Ok(model) if model.promised() > OF_MODEL * tolerance => Verdict::TooFar,
            Ok(_) => Verdict::Suffices,
        }
    }
}

/// Whether a rung serves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It does.
    Suffices,
    /// Its error is estimated above what is allowed.
    TooFar,
    /// The second order is not small: nothing is promised.
    NotBelieved,
    /// The carried error did not reach the end.
    NotCarried,
    /// No method reached the end.
    NotRun,
    /// The run leaves the regime that it would hold.
    NotHeld,
}

/// A run.
#[derive(Clone, Debug)]
pub struct Choice {
    pub plan: Plan,
    pub evaluations: u64,
    /// The median, s; taken side by side with all others.
    pub seconds: Option<f64>,
    /// Model and method: an estimate.
    pub promised: f64,
    /// By the reference that is kept, where there is one.
    pub measured: Option<f64>,
    /// Rows at the instants.
    pub rows: Vec<(f64, Vec<f64>)>,
}

/// What was chosen and why.
#[derive(Clone, Debug)]
pub struct Receipt {
    pub watched: Watched,
    pub tolerance: f64,
    /// From the scene's own model down.
    pub lines: Vec<Line>,
    /// The line that was taken; none where none serves.
    pub taken: Option<usize>,
    /// Evaluations of all pilots, estimates and runs; the transition matrices of a schedule come on top.
    pub deciding: u64,
    /// What all of that took, s, deriving the models and the schedule too; taking times on top is for the receipt.
    pub took: f64,
    /// Names of a row.
    pub columns: Vec<String>,
}

impl Receipt {
    /// Time of the scene's own model by its best method over that of the one taken.
    pub fn saved(&self) -> Option<f64> {
        let seconds = |line: &Line| line.choice.as_ref().and_then(|choice| choice.seconds);
        Some(seconds(self.lines.first()?)? / seconds(&self.lines[self.taken?])?)
    }

    /// What deciding took in runs of the scene's own model.
    pub fn worth(&self) -> Option<f64> {
        Some(self.took / self.lines.first()?.choice.as_ref()?.seconds?)
    }

    /// The run from which on it has paid to decide; none where nothing is saved.
    pub fn pays_from(&self) -> Option<u64> {
        let saved = 1.0 - 1.0 / self.saved()?;
        (saved > 0.0).then_some((self.worth()? / saved).ceil() as u64)
    }
}
