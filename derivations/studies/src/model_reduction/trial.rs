//! A run of a model with its error estimate.

use super::choose::{FINER, ROUNDED};
use super::outputs::Watched;
use super::plan::{FINEST, Plan, between, error_at};
use super::run_rows::Run;

/// The smallest observed order of the error in the tolerance for which an extrapolation is credible.
const LEAST_SLOPE: f64 = 0.5;
/// The work of pilots differs by this root, at least, of the ratio of their tolerances where these limit the steps: methods have lower orders.
const ROOT: f64 = 24.0;
/// The work of a run over that of a coarser one whose error it measures, at least.
const MORE: f64 = 1.3;
/// The number of tolerances at which a finer run is sought.
const MOST_FINER: usize = 3;

/// A run of a line's model by a plan, with its error (the largest over the run).
#[derive(Clone, Debug)]
pub struct Trial {
    pub line: usize,
    pub plan: Plan,
    pub run: Run,
    pub error: f64,
}

impl Trial {
    /// The run of a plan with its method's error, at most `most` if one of two runs achieves that. If both pilots are
    /// coarser, the error is extrapolated from theirs. If this is not credible or too large, a finer run measures the
    /// error, or replaces the run. `None` where no run reaches its end.
    pub fn of_plan(
        (line, mut plan): (usize, Plan),
        watched: &Watched,
        most: f64,
        mut go: impl FnMut(&Plan, &[f64]) -> Option<Run>,
    ) -> Option<Self> {
        let known = plan.known(plan.tolerance).cloned();
        let run = known.clone().or_else(|| go(&plan, &plan.pilots[1].run.times()))?;
        let factor = between(plan.method);
        let [coarse, fine] = &plan.pilots;
        let by_pilots = match (known, coarse.run.apart(&run, watched), fine.run.apart(&run, watched)) {
            _ if !is_finer(&fine.run, &coarse.run, (coarse.tolerance / fine.tolerance).powf(1.0 / ROOT)) => None,
            (Some(_), ..) => Some(plan.error_at(plan.tolerance)),
            // the finer pilot serves as the exact motion, with its own error
            (None, _, Some(off)) if plan.tolerance > fine.tolerance => {
                Some(factor * off + plan.error_at(fine.tolerance))
            }
            (None, Some(of_coarse), Some(of_fine)) => {
                let slope = (of_coarse / of_fine).ln() / (coarse.tolerance / fine.tolerance).ln();
                (slope >= LEAST_SLOPE).then(|| error_at(factor * of_fine, plan.tolerance / fine.tolerance))
            }
            _ => None,
        };
        let told = |plan: Plan, run: Run, error: f64| Trial { line, plan, run, error: error.max(ROUNDED) };
        if let Some(error) = by_pilots.filter(|error| *error <= most) {
            return Some(told(plan, run, error));
        }
        let mut finer = plan.clone();
        let mut measured: Option<Run> = None;
        for _ in 0..MOST_FINER {
            finer.tolerance = (finer.tolerance * FINER).max(FINEST);
            let Some(better) = go(&finer, &run.times()) else { break };
            let is_last = is_finer(&better, &run, MORE) || finer.tolerance <= FINEST;
            measured = Some(better);
            if is_last {
                break;
            }
        }
        let Some(better) = measured else { return by_pilots.map(|error| told(plan, run, error)) };
        let off = factor * run.apart(&better, watched)?;
        if off <= most {
            return Some(told(plan, run, off));
        }
        let error = error_at(off, finer.tolerance / plan.tolerance);
        plan = finer;
        Some(told(plan, better, error))
    }
}

/// Whether a run takes so many times the work of a coarser one that their distance is the error of the coarser one. Where events, and not the
/// tolerance, limit the steps, runs at different tolerances have the same steps and the same error.
fn is_finer(finer: &Run, coarser: &Run, times: f64) -> bool {
    finer.evaluations as f64 >= times * coarser.evaluations as f64
}
