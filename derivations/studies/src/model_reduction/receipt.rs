//! The record of a choice: the request, the models with their verdicts, and the selected model.

use super::Loss;
use super::estimate::Estimate;
use super::outputs::Watched;
use super::plan::Plan;
use super::run_rows::Row;
use std::time::Duration;

/// The request of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Wish {
    /// The largest allowed error, relative to the size of each output.
    pub tolerance: f64,
    pub outputs: Vec<String>,
    /// The time limit for timings, and before that for the search of a switching run; zero for neither.
    pub allowed: Duration,
}

/// The model's share of the tolerance; the method has the rest.
pub const OF_MODEL: f64 = 0.5;
/// An estimate is credible only if its second order is below this fraction of the first.
const BELIEVED: f64 = 0.5;
/// Errors below this fraction of the allowed one are accepted without that test.
const MINUTE: f64 = 1e-3;

/// A model in the record, with its verdict and best run.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    pub dropped: String,
    pub loss: Loss,
    pub states: usize,
    /// The error estimate of the model, or the reason why there is none.
    pub model: Result<Estimate, String>,
    /// The name by which a run selects the model; `None` where this is impossible.
    pub asked_as: Option<String>,
    /// Whether the model suffices, or the reason why not.
    pub verdict: Sufficiency,
    /// The best run of the model.
    pub choice: Option<Choice>,
}

impl Line {
    /// The line of the scene's own model.
    pub fn own(name: &str, states: usize, outputs: usize) -> Self {
        let model = Ok(Estimate::nothing(outputs));
        let (name, asked_as, dropped) = (name.to_owned(), Some(name.to_owned()), String::new());
        Line { name, dropped, loss: Loss::Own, states, model, asked_as, verdict: Sufficiency::Suffices, choice: None }
    }
}

impl Sufficiency {
    /// The verdict on a model by its estimate.
    pub fn of(model: &Result<Estimate, String>, tolerance: f64) -> Self {
        match model {
            Err(_) => Sufficiency::NotCarried,
            Ok(model) if model.second > BELIEVED * model.first.max(MINUTE * tolerance) => Sufficiency::NotBelieved,
            Ok(model) if model.promised() > OF_MODEL * tolerance => Sufficiency::TooFar,
            Ok(_) => Sufficiency::Suffices,
        }
    }
}

/// The verdict on a reduced model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sufficiency {
    /// The model suffices.
    Suffices,
    /// The error estimate exceeds the allowed error.
    TooFar,
    /// The second order is not small: the estimate is not credible.
    NotBelieved,
    /// The run of the error equation did not reach the end.
    NotCarried,
    /// No method reached the end.
    NotRun,
    /// The run costs as much as that of the scene's own model.
    NotCheaper,
    /// A trial would have exceeded the budget, or could not have saved anything.
    NotTried,
}

/// A run with its cost and errors.
#[derive(Clone, Debug)]
pub struct Choice {
    pub plan: Plan,
    pub work: Work,
    /// The median time, s, measured in turns with all others.
    pub seconds: Option<f64>,
    /// The error estimate of model and method together.
    pub promised: f64,
    /// The error measured against the stored reference, if there is one.
    pub measured: Option<f64>,
    /// Rows at the instants of the references.
    pub rows: Vec<Row>,
}

/// The work of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Work {
    pub evaluations: u64,
    /// The code size of the law in bytes, if known: a measure of the cost of an evaluation.
    pub code: Option<usize>,
}

impl Work {
    /// The ratio to another work: evaluations times code size if both are known, else evaluations.
    pub fn over(self, other: Work) -> f64 {
        let evaluations = self.evaluations as f64 / other.evaluations as f64;
        match (self.code, other.code) {
            (Some(own), Some(code)) if code > 0 => evaluations * (own as f64 / code as f64),
            _ => evaluations,
        }
    }
}

/// The record of a choice.
#[derive(Clone, Debug)]
pub struct Receipt {
    pub watched: Watched,
    pub tolerance: f64,
    /// The models, beginning with the scene's own.
    pub lines: Vec<Line>,
    /// The selected line, among those that a run can select by name; `None` where none suffices.
    pub taken: Option<usize>,
    /// The number of evaluations of all pilots, estimates and runs, without the transition matrices of a schedule.
    pub deciding: u64,
    /// Names of the outputs in a row.
    pub columns: Vec<String>,
}

impl Receipt {
    /// The cheapest line of all, including those that a run cannot select by name.
    pub fn cheapest(&self) -> Option<usize> {
        cheapest(&self.lines, |_| true)
    }

    /// The work of the scene's own model with its best method divided by that of a line.
    pub fn saved(&self, line: usize) -> Option<f64> {
        let work = |line: &Line| line.choice.as_ref().map(|choice| choice.work);
        Some(work(self.lines.first()?)?.over(work(self.lines.get(line)?)?))
    }

    /// The cost of the decision, in runs of the scene's own model.
    pub fn worth(&self) -> Option<f64> {
        Some(self.deciding as f64 / self.lines.first()?.choice.as_ref()?.work.evaluations as f64)
    }

    /// The number of runs after which the decision has paid; `None` where nothing is saved.
    pub fn pays_from(&self) -> Option<u64> {
        let saved = 1.0 - 1.0 / self.saved(self.taken?)?;
        (saved > 0.0).then_some((self.worth()? / saved).ceil() as u64)
    }
}

/// The line with the least work; of equal ones that with fewer states, then the later one.
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
