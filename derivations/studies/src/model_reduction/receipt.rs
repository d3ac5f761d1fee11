//! What was asked for, what was chosen, and why.

use super::Loss;
use super::estimate::Estimate;
use super::outputs::Watched;
use super::plan::Plan;
use super::run_rows::Row;
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

/// A reduced model as the receipt has it.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    pub dropped: String,
    pub loss: Loss,
    pub states: usize,
    /// Why there is none, in words, where it was not carried.
    pub model: Result<Estimate, String>,
    /// The name by which a run is asked for it; none of a model that no run takes by name.
    pub asked_as: Option<String>,
    /// Why it is not taken, where it cannot be.
    pub verdict: Sufficiency,
    /// The best run of it.
    pub choice: Option<Choice>,
}

impl Line {
    /// The scene's own model, by its name.
    pub fn own(name: &str, states: usize, outputs: usize) -> Self {
        let model = Ok(Estimate::nothing(outputs));
        let (name, asked_as, dropped) = (name.to_owned(), Some(name.to_owned()), String::new());
        Line { name, dropped, loss: Loss::Own, states, model, asked_as, verdict: Sufficiency::Suffices, choice: None }
    }
}

impl Sufficiency {
    /// Of a model by its estimate.
    pub fn of(model: &Result<Estimate, String>, tolerance: f64) -> Self {
        match model {
            Err(_) => Sufficiency::NotCarried,
            Ok(model) if model.second > BELIEVED * model.first.max(MINUTE * tolerance) => Sufficiency::NotBelieved,
            Ok(model) if model.promised() > OF_MODEL * tolerance => Sufficiency::TooFar,
            Ok(_) => Sufficiency::Suffices,
        }
    }
}

/// Whether a reduced model serves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sufficiency {
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
    /// It costs as much as the scene's own model.
    NotCheaper,
    /// Trying it would have cost more than it may.
    NotTried,
}

/// A run.
#[derive(Clone, Debug)]
pub struct Choice {
    pub plan: Plan,
    pub work: Work,
    /// The median, s; taken side by side with all others.
    pub seconds: Option<f64>,
    /// Model and method: an estimate.
    pub promised: f64,
    /// By the reference that is kept, where there is one.
    pub measured: Option<f64>,
    /// Rows at the instants of the references.
    pub rows: Vec<Row>,
}

/// The work of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    pub evaluations: u64,
    /// Bytes of the code of the law, where it is known: what an evaluation costs.
    pub code: Option<usize>,
}

impl Work {
    /// So many times as much as another: by evaluations and code where both codes are known, else by evaluations.
    pub fn over(self, other: Work) -> f64 {
        let evaluations = self.evaluations as f64 / other.evaluations as f64;
        match (self.code, other.code) {
            (Some(own), Some(code)) if code > 0 => evaluations * (own as f64 / code as f64),
            _ => evaluations,
        }
    }
}

/// What was chosen and why.
#[derive(Clone, Debug)]
pub struct Receipt {
    pub watched: Watched,
    pub tolerance: f64,
    /// From the scene's own model down.
    pub lines: Vec<Line>,
    /// The line that was taken, of those that a run takes by name; none where none serves.
    pub taken: Option<usize>,
    /// Evaluations of all pilots, estimates and runs; the transition matrices of a schedule come on top.
    pub deciding: u64,
    /// Names of a row.
    pub columns: Vec<String>,
}

impl Receipt {
    /// The cheapest line of all: what no run takes by name too.
    pub fn cheapest(&self) -> Option<usize> {
        cheapest(&self.lines, |_| true)
    }

    /// The work of the scene's own model by its best method over that of a line.
    pub fn saved(&self, line: usize) -> Option<f64> {
        let work = |line: &Line| line.choice.as_ref().map(|choice| choice.work);
        Some(work(self.lines.first()?)?.over(work(self.lines.get(line)?)?))
    }

    /// What deciding took in runs of the scene's own model.
    pub fn worth(&self) -> Option<f64> {
        Some(self.deciding as f64 / self.lines.first()?.choice.as_ref()?.work.evaluations as f64)
    }

    /// The run from which on it has paid to decide; none where nothing is saved.
    pub fn pays_from(&self) -> Option<u64> {
        let saved = 1.0 - 1.0 / self.saved(self.taken?)?;
        (saved > 0.0).then_some((self.worth()? / saved).ceil() as u64)
    }
}

/// The line with the least work; of equals the one with fewer states, then the one further down.
pub(super) fn cheapest(lines: &[Line], is: impl Fn(&Line) -> bool) -> Option<usize> {
    let serving = lines.iter().enumerate().rev().filter(|(_, line)| is(line));
    let mut serving = serving.filter_map(|(at, line)| Some((at, line.choice.as_ref()?.work, line.states)));
    let first = serving.next()?;
    let best = serving.fold(first, |best, one| {
        let over = one.1.over(best.1);
        if over < 1.0 || (over == 1.0 && one.2 < best.2) { one } else { best }
    });
    Some(best.0)
}
