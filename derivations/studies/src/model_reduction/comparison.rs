//! Comparison of reduced models with a run of the scene's own model, the most promising first, within a budget of
//! evaluations.

use super::Loss;
use super::choose::{FINER, Models, OF_METHOD};
use super::outputs::Watched;
use super::plan::{FINEST, Plan, Runnable, SLOWER, between, by_kind, fastest_at, is_stiff_at};
use super::receipt::{Line, Sufficiency};
use super::run_rows::Run;
use super::trial::Trial;
use integrators::Method;
use std::cell::Cell;

/// The budget of the decision, in runs of the scene's own model; reduced models get what its first runs have left. Runs
/// with too large differences end early.
const PRICE: f64 = 3.0;
/// The smallest budget for reduced models, in runs of the scene's own model.
const LEAST: f64 = 1.0;
/// A model is too expensive if it costs more than this fraction of the scene's own.
const WORTH: f64 = 0.8;
/// The tolerance that usually suffices for an error, as a fraction of it.
const USUAL: f64 = 0.1;

/// The scene's own run and the data of the comparison.
pub struct Comparison<'a> {
    pub models: &'a dyn Models,
    pub forms: &'a [Vec<Runnable<'a>>],
    pub watched: &'a Watched,
    /// The largest relative error allowed.
    pub tolerance: f64,
    pub own: &'a Trial,
    /// The number of evaluations spent before the comparison.
    pub before: u64,
    /// The cost of the comparison so far, in evaluations of the scene's own law.
    pub spent: u64,
}

impl Comparison<'_> {
    /// The trials of the models that suffice, each with its distance from the scene's own run plus the error of that
    /// run. Sets all verdicts.
    pub fn trials(&mut self, lines: &mut [Line]) -> Vec<Trial> {
        let mut order: Vec<usize> =
            (1..lines.len()).filter(|&line| lines[line].verdict == Sufficiency::Suffices).collect();
        // exact models first, then those with the fewest states
        order.sort_by_key(|&line| (matches!(lines[line].loss, Loss::Small { .. }), lines[line].states));
        let mut found: Vec<Trial> = Vec::new();
        for line in order {
            // a model with as many states as a sufficient one saves less
            let served = found.iter().any(|known| lines[known.line].states <= lines[line].states);
            lines[line].verdict = match self.left() > 0.0 && !served {
                false => Sufficiency::NotTried,
                true if self.is_as_dear(line, lines) => Sufficiency::NotCheaper,
                true => match self.trial(line, matches!(lines[line].loss, Loss::Small { .. })) {
                    Ok(trial) => {
                        found.push(trial);
                        Sufficiency::Suffices
                    }
                    Err(verdict) => verdict,
                },
            };
        }
        found
    }

    /// The number of evaluations of the scene's own law that may still be spent.
    fn left(&self) -> f64 {
        let own = self.own.run.evaluations as f64;
        (PRICE * own - self.before as f64).max(LEAST * own) - self.spent as f64
    }

    /// The cost of an evaluation of a line's law divided by that of the scene's own law.
    fn share(&self, line: usize) -> f64 {
        match (self.models.code_size(line), self.models.code_size(0)) {
            (Some(code), Some(own)) if own > 0 => code as f64 / own as f64,
            _ => 1.0,
        }
    }

    /// Whether the law of a line is stiff.
    fn is_stiff(&self, line: usize) -> bool {
        let span = self.forms[line].first().map_or(0.0, |form| form.span);
        self.models.start(line).is_some_and(|(law, start)| is_stiff_at(law, start, span))
    }

    /// Whether a model saves nothing, estimated before its run: with equal time scales only shorter code is cheaper,
    /// and with an implicit method also fewer states.
    fn is_as_dear(&self, line: usize, lines: &[Line]) -> bool {
        let fewer = lines[line].states as f64 / lines[0].states as f64;
        let fastest = |line: usize| self.models.start(line).map(|(law, start)| fastest_at(law, start));
        let is_slower = matches!((fastest(line), fastest(0)), (Some(line), Some(own)) if line < SLOWER * own);
        let cost = match (self.is_stiff(line), self.own.plan.method.traits().implicit) {
            _ if is_slower || self.models.changes(0) && !self.models.changes(line) => 0.0,
            (true, true) => self.share(line) * fewer,
            (false, false) if fewer == 1.0 => self.share(line),
            _ => 0.0,
        };
        cost > WORTH
    }

    /// The trial of a line's model, compared with the scene's own run.
    fn trial(&mut self, line: usize, is_approximate: bool) -> Result<Trial, Sufficiency> {
        let usual = (USUAL * OF_METHOD * self.tolerance).max(FINEST);
        let mut tolerance = self.own.plan.tolerance.min(usual);
        // the error of an exact model is that of its method only
        for is_last in if is_approximate { &[true][..] } else { &[false, true][..] } {
            match self.run_at(line, tolerance) {
                Err(Sufficiency::TooFar) if !is_last => tolerance = (tolerance * FINER).max(FINEST),
                Err(verdict) => return Err(verdict),
                Ok((method, run)) => {
                    let off = self.own.run.apart(&run, self.watched).ok_or(Sufficiency::NotRun)?;
                    let error = between(method) * off + self.own.error;
                    let plan = Plan { method, tolerance, ..self.own.plan.clone() };
                    // false for NaN too
                    return match error <= self.tolerance {
                        true => Ok(Trial { line, plan, run, error }),
                        false => Err(Sufficiency::TooFar),
                    };
                }
            }
        }
        Err(Sufficiency::TooFar)
    }

    /// A run that costs less than the scene's own, by an explicit or, for a stiff law, an implicit method.
    fn run_at(&mut self, line: usize, tolerance: f64) -> Result<(Method, Run), Sufficiency> {
        let form = self.forms[line].first().ok_or(Sufficiency::NotRun)?;
        let Trial { plan, run: own, error, .. } = self.own;
        let (share, times) = (self.share(line), own.times());
        let near = own.near(self.watched, (self.tolerance - error) / between(plan.method));
        let is_stiff = self.is_stiff(line);
        let is_too_far = Cell::new(false);
        let serves = |time: f64, row: &[f64]| {
            is_too_far.set(is_too_far.get() || !near(time, row));
            !is_too_far.get()
        };
        let mut by = |implicit: bool| {
            by_kind(implicit, |method| {
                let most = (WORTH * own.evaluations as f64).min(self.left().max(0.0)) / share;
                let (run, spent) = form.run_while((method, tolerance, most as u64), &times, &serves);
                self.spent += (spent as f64 * share).ceil() as u64;
                (run, spent)
            })
        };
        let found = by(is_stiff);
        // a law may become stiff after the start
        let again = found.is_none() && plan.method.traits().implicit && !is_stiff && !is_too_far.get();
        let found = if again { by(true) } else { found };
        found.ok_or(if is_too_far.get() { Sufficiency::TooFar } else { Sufficiency::NotCheaper })
    }
}
