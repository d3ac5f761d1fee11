//! Classification of the changes of steady motions between two values of a parameter.

use super::Sample;
use crate::linearisation::{Stability, Standing};
use crate::steady_motions::spectrum::{EnclosedSpectrum, EnclosedVerdict};
use crate::steady_motions::stability::SteadyStability;
use crate::steady_motions::{Range, SteadyMotion, SteadyMotions, Unknown};

/// If two motions merge and a third is closer than this fraction of the ranges, all three merge.
const TOGETHER: f64 = 1e-2;

/// A motion closer to an end of a range than this fraction of it counts as leaving the range there.
const AT_END: f64 = 1e-5;

/// Next to a change, eigenvalues cross the imaginary axis if their real parts are below this multiple of a typical eigenvalue.
const NEAR_AXIS: f64 = 1e-2;

/// Eigenvalues above this multiple of a typical one, on both sides of a change, become infinite in between.
const HUGE: f64 = 30.0;

/// The kind of change of the steady motions between two values of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Two motions appear or vanish together: a fold, or saddle-node.
    Fold,
    /// Two motions appear or vanish at a third: a pitchfork.
    Pitchfork,
    /// Two motions pass through each other and exchange their stability: transcritical.
    Transcritical,
    /// The motions persist; a pair of eigenvalues crosses the imaginary axis: a Hopf bifurcation, or the loss of gyroscopic stability.
    Pair,
    /// The motions persist; their stability changes in another way, such as an exchange of stability.
    Exchange,
    /// The motions and their stability persist; the number of unstable directions of an unstable motion changes.
    Directions,
    /// A motion leaves or enters the searched ranges at their end.
    Leaves,
    /// Motions appear or vanish where the coordinates are singular, such as the axis about which a bead circles.
    AtSingularPlace,
    /// A motion appears or vanishes within the ranges, since a condition changes or friction reaches its limit.
    Ends,
    /// Two or more motions leave or enter the searched ranges at their ends.
    LeaveTogether,
    /// Families of motions appear or vanish, such as positions at which friction holds; the isolated motions persist.
    Families,
    /// The motions persist; eigenvalues become infinite and none crosses the imaginary axis: inertia, or the rank of the constraints, vanishes in
    /// between.
    Infinite,
    /// The motions are equal in kind on both sides and differ at a single value in between, such as the one belt speed at which dry friction
    /// sticks.
    AtValue,
    /// Several of these changes together.
    Several,
}

/// For each motion the number of unstable directions (zero if unknown), sorted; and the number of families.
pub(in crate::steady_motions) fn kinds(found: &SteadyMotions) -> (Vec<usize>, usize) {
    let mut kinds: Vec<usize> = found.motions.iter().map(unstable).collect();
    kinds.sort_unstable();
    (kinds, found.families.len())
}

/// The number of unstable directions, as far as it is known.
pub(super) fn unstable(motion: &SteadyMotion) -> usize {
    match &motion.stability {
        SteadyStability::Falls(count) | SteadyStability::FallsOdd(count) | SteadyStability::FallsOnSide(count) => {
            *count
        }
        SteadyStability::FedByFriction => 1,
        // linear equations that contain cyclic coordinates may depend on the instant
        SteadyStability::Linear(found) => {
            match (found.enclosed.as_ref().map(EnclosedSpectrum::verdict), found.by_numbers()) {
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
        | SteadyStability::MinimumWithLoss
        | SteadyStability::InTouch(_)
        | SteadyStability::AtCondition(_)
        | SteadyStability::MinimumOnSides
        | SteadyStability::HeldByFriction
        | SteadyStability::Singular(_)
        | SteadyStability::Unknown(_) => 0,
    }
}

/// The number of motions just outside the searched ranges at a value of the parameter; `None` where it is unknown.
pub(super) type Beyond<'a> = &'a dyn Fn(f64) -> Option<usize>;

/// The change between two neighbouring samples; `typical` is the typical size of an eigenvalue in 1/s.
pub(super) fn change(before: &Sample, after: &Sample, (typical, beyond): (f64, Beyond<'_>)) -> Change {
    let (fewer, more) = match before.found.motions.len() <= after.found.motions.len() {
        true => (before, after),
        false => (after, before),
    };
    let gap = more.found.motions.len() - fewer.found.motions.len();
    let [(alone, families), (others, other_families)] = [kinds(&before.found), kinds(&after.found)];
    if families != other_families {
        return if alone == others { Change::Families } else { Change::Several };
    }
    let touching = at_ends(more).saturating_sub(at_ends(fewer));
    // a motion that moves fast may leave a range between two samples without touching its end at either
    let leaving = match gap {
        0 => 0,
        _ if touching >= gap => touching,
        _ => beyond(fewer.value).zip(beyond(more.value)).map_or(touching, |(out, known)| out.saturating_sub(known)),
    };
    match gap {
        1.. if at_singular_places(more) == at_singular_places(fewer) + gap => Change::AtSingularPlace,
        0 => exchanged(before, after, typical),
        1 if leaving > 0 => Change::Leaves,
        1 => Change::Ends,
        _ if leaving >= gap => Change::LeaveTogether,
        2 if leaving == 0 && has_three_together(more) => Change::Pitchfork,
        2 if leaving == 0 => Change::Fold,
        _ => Change::Several,
    }
}

/// The change between samples with equal numbers of motions.
fn exchanged(before: &Sample, after: &Sample, typical: f64) -> Change {
    let unstable = |sample: &Sample| -> usize { sample.found.motions.iter().map(unstable).sum() };
    let stable = |sample: &Sample| kinds(&sample.found).0.iter().filter(|directions| **directions == 0).count();
    let far = |sample: &Sample| largest_eigenvalue(&sample.found).is_none_or(|largest| largest > HUGE * typical);
    if far(before) && far(after) && [before, after].iter().any(|own| largest_eigenvalue(&own.found).is_some()) {
        return Change::Infinite;
    }
    let worse = if unstable(before) > unstable(after) { before } else { after };
    match unstable(before).abs_diff(unstable(after)) {
        2 if is_pair_at_axis(&worse.found, typical) => Change::Pair,
        1.. if stable(before) == stable(after) => Change::Directions,
        _ => Change::Exchange,
    }
}

/// The eigenvalues (real and imaginary parts, 1/s) of a motion, enclosed ones if available; empty if the energy alone decided the stability.
fn eigenvalues(motion: &SteadyMotion) -> Vec<[f64; 2]> {
    let (SteadyStability::Linear(found) | SteadyStability::InTouch(found)) = &motion.stability else {
        return Vec::new();
    };
    match &found.enclosed {
        Ok(enclosed) if enclosed.discs.iter().all(|disc| disc.radius.is_finite()) => {
            enclosed.discs.iter().flat_map(|disc| std::iter::repeat_n(disc.centre, disc.count)).collect()
        }
        _ => found.linear.eigenvalues.clone(),
    }
}

/// The largest absolute eigenvalue of all motions in 1/s; `None` if no eigenvalue is known, or all are zero.
pub(super) fn largest_eigenvalue(found: &SteadyMotions) -> Option<f64> {
    let sizes = found.motions.iter().flat_map(eigenvalues).map(|[re, im]| re.hypot(im));
    Some(sizes.fold(0.0, f64::max)).filter(|size| *size > 0.0)
}

/// Whether the two eigenvalues with the smallest positive real parts are complex and close to the imaginary axis.
fn is_pair_at_axis(found: &SteadyMotions, typical: f64) -> bool {
    let mut right: Vec<[f64; 2]> = found.motions.iter().flat_map(eigenvalues).filter(|[re, _]| *re > 0.0).collect();
    right.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let is_near = |[re, im]: &[f64; 2]| *re <= NEAR_AXIS * typical && *im != 0.0;
    right.len() >= 2 && right[..2].iter().all(is_near)
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

/// Whether three motions are close together.
fn has_three_together(sample: &Sample) -> bool {
    let SteadyMotions { unknowns, motions, .. } = &sample.found;
    let is_near = |a: &SteadyMotion, b: &SteadyMotion| are_near(unknowns, &a.enclosure, &b.enclosure);
    motions.iter().any(|own| motions.iter().filter(|other| is_near(own, other)).count() >= 3)
}

/// The number of motions close to positions at which the coordinates are singular.
fn at_singular_places(sample: &Sample) -> usize {
    let SteadyMotions { unknowns, motions, singular_places, .. } = &sample.found;
    let is_there =
        |motion: &&SteadyMotion| singular_places.iter().any(|place| are_near(unknowns, place, &motion.enclosure));
    motions.iter().filter(is_there).count()
}

/// Whether the midpoints of two enclosures are close together.
fn are_near(unknowns: &[Unknown], a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    distance(unknowns, a, b) < TOGETHER
}

/// The largest distance of enclosures of unknowns, as a part of the ranges.
pub(super) fn distance(unknowns: &[Unknown], a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
    let each = unknowns.iter().zip(a.iter().zip(b)).map(|(unknown, (a, b))| {
        let gap = (middle(*a) - middle(*b)).abs();
        let whole = unknown.range.to - unknown.range.from;
        let around = if unknown.is_circle { (2.0 * std::f64::consts::PI - gap).abs() } else { gap };
        // an unknown with a given value has no width
        if whole == 0.0 { 0.0 } else { gap.min(around) / whole }
    });
    each.fold(0.0, f64::max)
}
