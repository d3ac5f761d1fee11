//! Steady motions as functions of a parameter or of the speed of a cyclic coordinate, with bifurcations.
//!
//! All motions are found at each value. If the number of motions or their stability differs between two values with complete searches, there is a
//! bifurcation in between; its bracket is narrowed until motions can no longer be distinguished.

mod change;
mod hysteresis;
mod tracks;
mod transcritical;

pub use change::Change;

use super::{NoSteadyMotions, Orientation, Range, SteadyMotion, SteadyMotions, SteadySearch, Unknown};
use crate::admissible::impossible;
pub(super) use change::kinds;
use change::{change, largest_eigenvalue};
use hysteresis::hysteresis;
use model::Model;
use std::cell::RefCell;
use transcritical::{Meeting, meetings};

/// All steady motions at one value of the parameter, in SI units.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The value of the parameter or cyclic speed, in SI units.
    pub value: f64,
    /// The steady motions at this value.
    pub found: SteadyMotions,
}

/// A bifurcation: two values of the parameter between which the motions change.
#[derive(Clone, Debug)]
pub struct Bifurcation {
    /// The last sample before the change, with a complete search.
    pub before: Sample,
    /// A sample in between whose motions differ from those on both sides.
    pub at: Option<Sample>,
    /// The first sample behind the change, with a complete search.
    pub after: Sample,
    /// The kind of the change.
    pub change: Change,
}

/// Steady motions as functions of a parameter.
#[derive(Clone, Debug)]
pub struct Along {
    /// The steady motions at the requested values at which a search is possible.
    pub samples: Vec<Sample>,
    /// Values of the parameter at which the search is not possible, with the reasons.
    pub left_out: Vec<(f64, NoSteadyMotions)>,
    /// All examined samples in ascending order, including those that narrow brackets.
    pub visited: Vec<Sample>,
    /// The bifurcations in ascending order of the parameter.
    pub bifurcations: Vec<Bifurcation>,
    /// Whether the time was over before all changes were found.
    pub is_cut: bool,
}

/// Width of a final bracket as a fraction of the range of the parameter.
const ENCLOSED: f64 = 1e-9;

/// Fraction by which ranges are widened on each side to find motions that have left them.
const WIDER: f64 = 1e-3;

/// Changes closer together than this fraction of the range count as one, since stability is undecided close to a change.
const ONE: f64 = 1e-6;

/// Fractions of a bracket at which samples are tried, in this order, until a search is complete.
const PARTS: [f64; 5] = [0.5, 0.381_966, 0.618_034, 0.236, 0.764];

impl Along {
    /// The motions at equally spaced values of the parameter or cyclic speed `name`, in SI units, and their bifurcations. Values at which no search is
    /// possible are left out; the search ends early when `goes_on` returns false.
    ///
    /// # Errors
    /// If no search is possible at any value, such as for a name that is no parameter; with the reason at the last value.
    pub fn of(
        model: &Model,
        asked: &SteadySearch,
        (name, range): (&str, Range),
        values: usize,
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, NoSteadyMotions> {
        let (visited, goes_on) = (RefCell::new(Vec::new()), RefCell::new(goes_on));
        let at = |value: f64| {
            let found = found_at(model, asked, &[(name, value)], || (goes_on.borrow_mut())())?;
            let sample = Sample { value, found };
            visited.borrow_mut().push(sample.clone());
            Ok(sample)
        };
        let last = values.saturating_sub(1).max(1);
        let value = |k: usize| range.from + (range.to - range.from) * k as f64 / last as f64;
        let (mut samples, mut left_out): (Vec<Sample>, Vec<(f64, NoSteadyMotions)>) = (Vec::new(), Vec::new());
        // even without time left, one value is examined
        for value in (0..=last).filter(|k| *k == 0 || (goes_on.borrow_mut())()).map(value) {
            match at(value) {
                Ok(sample) => samples.push(sample),
                Err(why) => left_out.push((value, why)),
            }
        }
        if samples.is_empty()
            && let Some((_, why)) = left_out.pop()
        {
            return Err(why);
        }
        let complete: Vec<&Sample> = samples.iter().filter(|sample| sample.found.is_complete()).collect();
        let size = range.to - range.from;
        let mut brackets: Vec<[Sample; 2]> = Vec::new();
        for pair in complete.windows(2).filter(|pair| kinds(&pair[0].found) != kinds(&pair[1].found)) {
            brackets.extend(enclosed([pair[0].clone(), pair[1].clone()], size, &at));
        }
        let mut passing: Vec<[Sample; 2]> = Vec::new();
        let mut hidden = hysteresis(&complete, &at);
        for meeting in meetings(&complete, size, &at) {
            match meeting {
                Meeting::Transcritical(both) => passing.push(*both),
                Meeting::Hidden(all) => hidden.push(*all),
            }
        }
        for [before, middle, after] in hidden {
            brackets.extend(enclosed([before, middle.clone()], size, &at));
            brackets.extend(enclosed([middle, after], size, &at));
        }
        let order = |own: &[Sample; 2]| own[0].value * size.signum();
        brackets.sort_by(|a, b| order(a).total_cmp(&order(b)));
        let beyond = |value: f64| {
            let found = found_at(model, &asked.wider(WIDER), &[(name, value)], || (goes_on.borrow_mut())()).ok()?;
            found.is_complete().then(|| outside(&found, asked))
        };
        let mut bifurcations =
            merged(brackets, ONE * size.abs(), &|before, after| change(before, after, (typical(&samples), &beyond)));
        let transcritical =
            |[before, after]: [Sample; 2]| Bifurcation { before, at: None, after, change: Change::Transcritical };
        bifurcations.extend(passing.into_iter().map(transcritical));
        bifurcations.sort_by(|a, b| (a.before.value * size.signum()).total_cmp(&(b.before.value * size.signum())));
        let is_cut = !(goes_on.borrow_mut())();
        let mut visited = visited.into_inner();
        visited.sort_by(|a, b| a.value.total_cmp(&b.value));
        Ok(Along { samples, left_out, visited, bifurcations, is_cut })
    }
}

/// All steady motions at given values of parameters and cyclic speeds in SI units, without positions at which the coordinates are singular.
pub(super) fn found_at(
    model: &Model,
    asked: &SteadySearch,
    values: &[(&str, f64)],
    goes_on: impl FnMut() -> bool,
) -> Result<SteadyMotions, NoSteadyMotions> {
    searched(model, asked, values, goes_on).map(SteadyMotions::without_singular_places).map_err(|why| {
        let is_parameter = |(name, _): &&(&str, f64)| model.parameters.iter().any(|own| own.name == *name);
        let values: Vec<(String, f64)> =
            values.iter().filter(is_parameter).map(|(name, value)| ((*name).to_owned(), *value)).collect();
        if values.is_empty() { why } else { NoSteadyMotions::At { values, why: Box::new(why) } }
    })
}

fn searched(
    model: &Model,
    asked: &SteadySearch,
    values: &[(&str, f64)],
    goes_on: impl FnMut() -> bool,
) -> Result<SteadyMotions, NoSteadyMotions> {
    let (mut model, mut asked) = (model.clone(), asked.clone());
    let is_parameter = |name: &str| model.parameters.iter().any(|parameter| parameter.name == name);
    let (parameters, speeds): (Vec<_>, Vec<_>) = values.iter().copied().partition(|(name, _)| is_parameter(name));
    if !parameters.is_empty() {
        model.set_values(&parameters).map_err(|why| NoSteadyMotions::Undefined { why })?;
        if let Some(issue) = impossible(&model).into_iter().next() {
            return Err(NoSteadyMotions::Undefined { why: issue.title });
        }
    }
    let point = |(name, value): (&str, f64)| (name.to_owned(), Range { from: value, to: value });
    asked.ranges.extend(speeds.into_iter().map(point));
    if let Some(source) = asked.text.as_ref().filter(|_| !model.free.is_empty()) {
        let all = Orientation::all(source, &model, &asked)?;
        return Ok(SteadyMotions::united_orientations(SteadyMotions::of_orientations(all, goes_on)?));
    }
    match model.switches.is_empty() && model.contacts.is_empty() {
        true => SteadyMotions::of(&model, &asked, goes_on),
        false => Ok(SteadyMotions::united(SteadyMotions::of_cases(&model, &asked, goes_on)?)),
    }
}

/// The brackets of all changes between two samples, in ascending order.
fn enclosed(ends: [Sample; 2], size: f64, at: &impl Fn(f64) -> Result<Sample, NoSteadyMotions>) -> Vec<[Sample; 2]> {
    let mut open = vec![ends];
    let mut all = Vec::new();
    while let Some([before, after]) = open.pop() {
        if kinds(&before.found) == kinds(&after.found) {
            continue;
        }
        let way = after.value - before.value;
        let parts = if way.abs() > ENCLOSED * size.abs() { &PARTS[..] } else { &[] };
        let tried = parts.iter().filter_map(|part| at(before.value + part * way).ok());
        match tried.into_iter().find(|sample| sample.found.is_complete()) {
            Some(sample) => open.extend([[sample.clone(), after], [before, sample]]),
            None => all.push([before, after]),
        }
    }
    all
}

/// The number of motions outside the ranges of `asked`, from a search in wider ranges.
fn outside(found: &SteadyMotions, asked: &SteadySearch) -> usize {
    let leaves = |(unknown, [low, high]): (&Unknown, &[f64; 2])| {
        let range = asked.range(&unknown.name).filter(|_| !unknown.is_circle);
        range.is_some_and(|range| *high < range.from || *low > range.to)
    };
    let is_outside = |motion: &&SteadyMotion| found.unknowns.iter().zip(&motion.enclosure).any(leaves);
    found.motions.iter().filter(is_outside).count()
}

/// The bifurcations in brackets; brackets closer together than `near` are merged into one.
fn merged(brackets: Vec<[Sample; 2]>, near: f64, change: &dyn Fn(&Sample, &Sample) -> Change) -> Vec<Bifurcation> {
    let mut merged: Vec<(Sample, Option<Sample>, Sample)> = Vec::new();
    for [before, after] in brackets {
        match merged.last_mut() {
            Some((_, at, last)) if (before.value - last.value).abs() <= near => {
                at.get_or_insert(before);
                *last = after;
            }
            _ => merged.push((before, None, after)),
        }
    }
    let told = merged.into_iter().map(|(before, at, after)| {
        let differs = |own: &Sample| [&before, &after].iter().all(|end| kinds(&own.found) != kinds(&end.found));
        let at = at.filter(differs);
        let change = match &at {
            _ if kinds(&before.found) != kinds(&after.found) => change(&before, &after),
            Some(at) if is_shared(&before.found, &at.found) => Change::Transcritical,
            _ => Change::AtValue,
        };
        Bifurcation { before, at, after, change }
    });
    told.filter(|one| one.change != Change::AtValue || one.at.is_some()).collect()
}

/// Whether two of the motions beside a value are one motion at the value.
fn is_shared(beside: &SteadyMotions, at: &SteadyMotions) -> bool {
    at.motions.len() + 1 == beside.motions.len() && at.families.len() == beside.families.len()
}

/// The median over the samples of the largest eigenvalue, 1/s; infinite if none is known.
fn typical(samples: &[Sample]) -> f64 {
    let mut all: Vec<f64> = samples.iter().filter_map(|sample| largest_eigenvalue(&sample.found)).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(f64::INFINITY)
}
