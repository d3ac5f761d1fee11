//! Steady motions along a parameter, or along the speed of a cyclic coordinate, with the bifurcations between values.
//!
//! At each value all motions are found. If the number of motions or their stability differs between two values with complete searches, there is a
//! bifurcation in between, and its bracket is narrowed as far as motions can be distinguished.

use super::spectrum::{EnclosedSpectrum, EnclosedVerdict};
use super::stability::SteadyStability;
use super::{Asked, NoSteadyMotions, Orientation, Range, SteadyMotion, SteadyMotions};
use crate::admissible::impossible;
use crate::linearisation::{Stability, Standing};
use model::Model;
use std::cell::RefCell;

/// All motions at a value.
#[derive(Clone, Debug)]
pub struct Sample {
    pub value: f64,
    pub found: SteadyMotions,
}

/// A change between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Two motions appear or vanish together: a fold, or saddle-node.
    Fold,
    /// Two motions appear or vanish at a third: a pitchfork.
    Pitchfork,
    /// The motions persist; a pair of eigenvalues crosses the imaginary axis: a Hopf bifurcation, or the loss of gyroscopic stability.
    Pair,
    /// The motions persist; their stability changes in another way.
    Exchange,
    /// The number of directions changes in which a motion is unstable; motions neither appear nor vanish, and none becomes stable or unstable.
    Directions,
    /// A motion leaves the ranges, or enters them.
    Leaves,
    /// A motion appears or vanishes within the ranges, since a condition changes or friction reaches its bound.
    Ends,
    /// Two or more motions leave the ranges, or enter them, at their ends.
    LeaveTogether,
    /// Families appear or vanish, such as positions at which friction holds, and no isolated motion does.
    Families,
    /// Several of these at once.
    Several,
}

/// Two values between which the motions change.
#[derive(Clone, Debug)]
pub struct Bifurcation {
    /// The last value before the change and the first one after it, each with a complete search.
    pub before: Sample,
    pub after: Sample,
    pub change: Change,
}

/// Motions along a parameter.
#[derive(Clone, Debug)]
pub struct Along {
    pub samples: Vec<Sample>,
    /// All examined values in ascending order, including those of brackets.
    pub visited: Vec<Sample>,
    pub bifurcations: Vec<Bifurcation>,
}

/// The part of the range to which a change is enclosed.
const ENCLOSED: f64 = 1e-9;

/// Changes closer to each other than this fraction of the range count as one, since stability is not decided close to a change.
const ONE: f64 = 1e-6;

/// If the search at a value between two others is not complete, values at these fractions of the distance are tried.
const PARTS: [f64; 5] = [0.5, 0.381_966, 0.618_034, 0.236, 0.764];

/// If two motions merge and a third is closer than this fraction of the ranges, all three merge.
const TOGETHER: f64 = 1e-2;

/// A motion closer to an end of a range than this fraction of it counts as leaving the range there.
const AT_END: f64 = 1e-5;

impl Along {
    /// The motions at a number of values between two, in SI units.
    ///
    /// # Errors
    /// The reason for which steady motions are not searched for at some value, or for which the name is not a parameter.
    pub fn of(
        model: &Model,
        asked: &Asked,
        (name, range): (&str, Range),
        values: usize,
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Self, NoSteadyMotions> {
        let visited = RefCell::new(Vec::new());
        let mut at = |value: f64| {
            let found = found_at(model, asked, &[(name, value)], &mut goes_on)?;
            let sample = Sample { value, found };
            visited.borrow_mut().push(sample.clone());
            Ok(sample)
        };
        let last = values.saturating_sub(1).max(1);
        let value = |k: usize| range.from + (range.to - range.from) * k as f64 / last as f64;
        let samples = (0..=last).map(|k| at(value(k))).collect::<Result<Vec<Sample>, _>>()?;
        let complete: Vec<&Sample> = samples.iter().filter(|sample| sample.found.is_complete()).collect();
        let mut bifurcations: Vec<Bifurcation> = Vec::new();
        let size = range.to - range.from;
        for pair in complete.windows(2).filter(|pair| kinds(&pair[0].found) != kinds(&pair[1].found)) {
            let found = enclosed([pair[0].clone(), pair[1].clone()], size, &mut at)?;
            bifurcations.extend(found);
        }
        let bifurcations = merged(bifurcations, ONE * size.abs());
        let mut visited = visited.into_inner();
        visited.sort_by(|a, b| a.value.total_cmp(&b.value));
        Ok(Along { samples, visited, bifurcations })
    }
}

/// All motions at values of parameters, or of speeds of cyclic coordinates, in SI units.
pub(super) fn found_at(
    model: &Model,
    asked: &Asked,
    values: &[(&str, f64)],
    goes_on: impl FnMut() -> bool,
) -> Result<SteadyMotions, NoSteadyMotions> {
    searched(model, asked, values, goes_on).map_err(|why| {
        let is_parameter = |(name, _): &&(&str, f64)| model.parameters.iter().any(|own| own.name == *name);
        let values: Vec<(String, f64)> =
            values.iter().filter(is_parameter).map(|(name, value)| ((*name).to_owned(), *value)).collect();
        if values.is_empty() { why } else { NoSteadyMotions::At { values, why: Box::new(why) } }
    })
}

fn searched(
    model: &Model,
    asked: &Asked,
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

/// The changes between two values, each enclosed.
fn enclosed(
    ends: [Sample; 2],
    size: f64,
    at: &mut impl FnMut(f64) -> Result<Sample, NoSteadyMotions>,
) -> Result<Vec<Bifurcation>, NoSteadyMotions> {
    let mut open = vec![ends];
    let mut all = Vec::new();
    // from the first to the last
    while let Some([before, after]) = open.pop() {
        if kinds(&before.found) == kinds(&after.found) {
            continue;
        }
        let way = after.value - before.value;
        let mut between = None;
        if way.abs() > ENCLOSED * size.abs() {
            for part in PARTS {
                let sample = at(before.value + part * way)?;
                if sample.found.is_complete() {
                    between = Some(sample);
                    break;
                }
            }
        }
        match between {
            Some(sample) => open.extend([[sample.clone(), after], [before, sample]]),
            None => all.push(Bifurcation { change: change(&before, &after), before, after }),
        }
    }
    Ok(all)
}

/// The changes, with those closer together than `near` as one.
fn merged(all: Vec<Bifurcation>, near: f64) -> Vec<Bifurcation> {
    let mut merged: Vec<Bifurcation> = Vec::new();
    for next in all {
        match merged.last_mut() {
            Some(last) if (next.before.value - last.after.value).abs() <= near => {
                last.after = next.after;
                last.change = change(&last.before, &last.after);
            }
            _ => merged.push(next),
        }
    }
    merged.retain(|one| kinds(&one.before.found) != kinds(&one.after.found));
    merged
}

/// The number of directions in which each motion is unstable, if known, in ascending order; and the number of families.
pub(super) fn kinds(found: &SteadyMotions) -> (Vec<usize>, usize) {
    let mut kinds: Vec<usize> = found.motions.iter().map(unstable).collect();
    kinds.sort_unstable();
    (kinds, found.families.len())
}

fn unstable(motion: &SteadyMotion) -> usize {
    match &motion.stability {
        SteadyStability::Falls(count) | SteadyStability::FallsOdd(count) | SteadyStability::FallsOnSide(count) => {
            *count
        }
        SteadyStability::FedByFriction => 1,
        // the linear equations without cyclic coordinates do not depend on the instant; those with cyclic coordinates may
        SteadyStability::Linear(found) => {
            match (found.enclosed.as_ref().map(EnclosedSpectrum::verdict), found.linear.stability) {
                (Ok(EnclosedVerdict::Unstable(count)), _) => count,
                (Ok(EnclosedVerdict::Undecided { touching: 1.., .. }) | Err(_), Stability::Unstable(count))
                    if found.linear.standing != Standing::Moving =>
                {
                    count
                }
                _ => 0,
            }
        }
        SteadyStability::Minimum
        | SteadyStability::AtCondition(_)
        | SteadyStability::MinimumOnSides
        | SteadyStability::HeldByFriction
        | SteadyStability::Singular(_)
        | SteadyStability::Unknown(_) => 0,
    }
}

fn change(before: &Sample, after: &Sample) -> Change {
    let (fewer, more) = match before.found.motions.len() <= after.found.motions.len() {
        true => (before, after),
        false => (after, before),
    };
    let leaving = at_ends(more).saturating_sub(at_ends(fewer));
    let [(alone, families), (others, other_families)] = [kinds(&before.found), kinds(&after.found)];
    if families != other_families {
        return if alone == others { Change::Families } else { Change::Several };
    }
    match more.found.motions.len() - fewer.found.motions.len() {
        0 => exchanged(before, after),
        1 if leaving > 0 => Change::Leaves,
        1 => Change::Ends,
        gap if leaving >= gap => Change::LeaveTogether,
        2 if leaving == 0 && has_three_together(more) => Change::Pitchfork,
        2 if leaving == 0 => Change::Fold,
        _ => Change::Several,
    }
}

/// The change if the number of motions stays equal, by the directions that become unstable.
fn exchanged(before: &Sample, after: &Sample) -> Change {
    let unstable = |sample: &Sample| -> usize { sample.found.motions.iter().map(unstable).sum() };
    let stable = |sample: &Sample| kinds(&sample.found).0.iter().filter(|directions| **directions == 0).count();
    match unstable(before).abs_diff(unstable(after)) {
        2 => Change::Pair,
        1.. if stable(before) == stable(after) => Change::Directions,
        _ => Change::Exchange,
    }
}

/// The number of motions that touch an end of a range.
fn at_ends(sample: &Sample) -> usize {
    let SteadyMotions { unknowns, motions, .. } = &sample.found;
    let touches = |motion: &&SteadyMotion| {
        unknowns.iter().zip(&motion.enclosure).any(|(unknown, [low, high])| {
            let Range { from, to } = unknown.range;
            let near = AT_END * (to - from);
            !unknown.is_circle && (*low <= from + near || *high >= to - near)
        })
    };
    motions.iter().filter(touches).count()
}

/// Whether three motions lie close together.
fn has_three_together(sample: &Sample) -> bool {
    let SteadyMotions { unknowns, motions, .. } = &sample.found;
    let is_near = |a: &SteadyMotion, b: &SteadyMotion| {
        let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
        unknowns.iter().zip(a.enclosure.iter().zip(&b.enclosure)).all(|(unknown, (a, b))| {
            let gap = (middle(*a) - middle(*b)).abs();
            let whole = unknown.range.to - unknown.range.from;
            let around = if unknown.is_circle { (2.0 * std::f64::consts::PI - gap).abs() } else { gap };
            gap.min(around) < TOGETHER * whole
        })
    };
    motions.iter().any(|own| motions.iter().filter(|other| is_near(own, other)).count() >= 3)
}
