//! `dalembert stationary --along NAME=FROM..TO --out FILE.svg`: the bifurcation diagram of steady motions.

use super::steady_box::AlongFound;
use super::verdict::verdict;
use ::scenes::steady_motions::{Bifurcation, Change, Range, Sample, SteadyMotion, SteadyMotions};
use charts::{BranchPanel, BranchPiece, Branches, Standing};
use std::f64::consts::{PI, TAU};

/// The largest distance, as a fraction of the ranges, between motions at adjacent values that are joined although their numbers differ.
const JOINED: f64 = 0.02;

/// The fraction of the range of the parameter that the width of a line covers.
const HIDDEN: f64 = 2e-3;

/// The kinds of marks; the first four have shapes of their own.
const KINDS: [&str; 5] = [
    "two motions appear or vanish (fold)",
    "an eigenvalue pair crosses the imaginary axis (Hopf)",
    "stability is exchanged",
    "two motions leave a third (pitchfork)",
    "several changes at once",
];

/// The bifurcation diagram, with one panel for each unknown.
pub(super) fn picture(found: &AlongFound, range: Range) -> Branches {
    let AlongFound { title, name, unit, units, along, .. } = found;
    let samples: Vec<&Sample> = along.visited.iter().filter(|sample| sample.found.is_complete()).collect();
    let unknowns = samples.first().map_or(&[][..], |sample| &sample.found.unknowns);
    let panels = unknowns.iter().zip(units).enumerate().map(|(place, (unknown, unit))| {
        let values = || samples.iter().flat_map(|sample| &sample.found.motions).map(|motion| unknown_at(motion, place));
        let range = match unknown.is_circle {
            true => [-PI, PI],
            false => [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)],
        };
        BranchPanel {
            y: labelled(&unknown.name, unit),
            range,
            pieces: pieces(&samples, place),
            marks: marks(found, place),
        }
    });
    let left_out = along.visited.len() - samples.len();
    let left_out = match left_out {
        0 => String::new(),
        count => format!(" Values at which the search leaves boxes undecided are left out: {count}."),
    };
    Branches {
        title: title.clone(),
        x: (labelled(name, unit), [range.from.min(range.to), range.to.max(range.from)]),
        panels: panels.collect(),
        kinds: KINDS.map(String::from).into(),
        note: format!(
            "At each value all steady motions of the ranges are found by a complete search; lines join neighbours. Between two values at which \
             everything is alike nothing is seen.{left_out}"
        ),
    }
}

fn labelled(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name},{unit}") }
}

fn standing(motion: &SteadyMotion, found: &SteadyMotions) -> Standing {
    match verdict(motion, &found.cyclic).0 {
        "stable" | "asymptotically stable" => Standing::Stable,
        "unstable" => Standing::Unstable,
        _ => Standing::Undecided,
    }
}

/// The value of an unknown at a motion, from its enclosure. Some unknowns, such as speeds that the search introduces, are not in the state.
fn unknown_at(motion: &SteadyMotion, unknown: usize) -> f64 {
    let [low, high] = motion.enclosure[unknown];
    0.5 * (low + high)
}

/// The distance of two motions as a fraction of the ranges; differences of angles are taken modulo a full turn.
fn distance(found: &SteadyMotions, a: &SteadyMotion, b: &SteadyMotion) -> f64 {
    let part = |(place, unknown): (usize, &::scenes::steady_motions::Unknown)| {
        let gap = (unknown_at(a, place) - unknown_at(b, place)).abs();
        let gap = if unknown.is_circle { gap.min((TAU - gap).abs()) } else { gap };
        gap / (unknown.range.to - unknown.range.from)
    };
    found.unknowns.iter().enumerate().map(part).fold(0.0, |sum, part| sum + part * part).sqrt()
}

/// Pairs of motions at two adjacent values that belong to one branch, the closest first.
fn joined(before: &SteadyMotions, after: &SteadyMotions) -> Vec<(usize, usize)> {
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (i, a) in before.motions.iter().enumerate() {
        pairs.extend(after.motions.iter().enumerate().map(|(j, b)| (distance(before, a, b), i, j)));
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let as_many = before.motions.len() == after.motions.len();
    let mut found: Vec<(usize, usize)> = Vec::new();
    for (gap, i, j) in pairs {
        let is_free = found.iter().all(|(a, b)| *a != i && *b != j);
        if is_free && (as_many || gap < JOINED) {
            found.push((i, j));
        }
    }
    found
}

/// The pieces of branches in one unknown.
fn pieces(samples: &[&Sample], place: usize) -> Vec<BranchPiece> {
    // each unfinished piece, with the index of its last motion among the motions at the last value
    let mut open: Vec<(usize, BranchPiece)> = Vec::new();
    let mut all: Vec<BranchPiece> = Vec::new();
    for (k, sample) in samples.iter().enumerate() {
        let found = &sample.found;
        let unknown = &found.unknowns[place];
        let pairs = match k.checked_sub(1) {
            Some(last) => joined(&samples[last].found, found),
            None => Vec::new(),
        };
        let mut next: Vec<(usize, BranchPiece)> = Vec::new();
        for (j, motion) in found.motions.iter().enumerate() {
            let own = standing(motion, found);
            let point = (sample.value, unknown_at(motion, place));
            let before = pairs.iter().find(|(_, to)| *to == j).and_then(|(from, _)| {
                let at = open.iter().position(|(last, _)| last == from)?;
                Some(open.swap_remove(at).1)
            });
            let wraps = |last: f64| unknown.is_circle && (last - point.1).abs() > PI;
            let piece = match before {
                Some(mut piece) if piece.standing == own && !piece.points.last().is_some_and(|last| wraps(last.1)) => {
                    piece.points.push(point);
                    piece
                }
                // at a single undecided value the piece continues with its stability
                Some(mut piece)
                    if own == Standing::Undecided && !piece.points.last().is_some_and(|last| wraps(last.1)) =>
                {
                    piece.points.push(point);
                    all.push(piece);
                    BranchPiece { standing: own, points: vec![point] }
                }
                Some(piece) => {
                    let last = piece.points.last().copied().filter(|last| !wraps(last.1));
                    all.push(piece);
                    BranchPiece { standing: own, points: last.into_iter().chain([point]).collect() }
                }
                None => BranchPiece { standing: own, points: vec![point] },
            };
            next.push((j, piece));
        }
        all.extend(open.drain(..).map(|(_, piece)| piece));
        open = next;
    }
    all.extend(open.into_iter().map(|(_, piece)| piece));
    // undecided pieces close to a change of stability are left out if they are narrower than the line
    let ends = |piece: &BranchPiece| piece.points.first().zip(piece.points.last()).map_or(0.0, |(a, b)| b.0 - a.0);
    let whole = samples.first().zip(samples.last()).map_or(0.0, |(a, b)| b.value - a.value);
    all.retain(|piece| piece.standing != Standing::Undecided || ends(piece) > HIDDEN * whole);
    all
}

/// The marks at the bifurcations, in one unknown.
fn marks(found: &AlongFound, place: usize) -> Vec<(usize, (f64, f64))> {
    found.along.bifurcations.iter().flat_map(|one| of_change(one, place)).collect()
}

fn of_change(Bifurcation { before, after, change, .. }: &Bifurcation, place: usize) -> Vec<(usize, (f64, f64))> {
    let kind = match change {
        Change::Fold => 0,
        Change::Pair => 1,
        Change::Exchange | Change::Transcritical => 2,
        Change::Pitchfork => 3,
        Change::Several => 4,
        // no marks: branches that leave the range, families, which are not drawn, and changes between unstable motions
        Change::Leaves
        | Change::LeaveTogether
        | Change::Ends
        | Change::AtSingularPlace
        | Change::Families
        | Change::Directions
        | Change::Infinite
        | Change::AtValue => return Vec::new(),
    };
    let value = 0.5 * (before.value + after.value);
    let (fewer, more) = match before.found.motions.len() <= after.found.motions.len() {
        true => (&before.found, &after.found),
        false => (&after.found, &before.found),
    };
    let at = |motion: &SteadyMotion| unknown_at(motion, place);
    let pairs = joined(fewer, more);
    if fewer.motions.len() == more.motions.len() {
        let changed =
            pairs.iter().filter(|(i, j)| standing(&fewer.motions[*i], fewer) != standing(&more.motions[*j], more));
        return changed.map(|(_, j)| (kind, (value, at(&more.motions[*j])))).collect();
    }
    let alone = |j: &usize| pairs.iter().all(|(_, to)| to != j);
    let mut left: Vec<&SteadyMotion> = (0..more.motions.len()).filter(alone).map(|j| &more.motions[j]).collect();
    let mut marks = Vec::new();
    // the two motions of a pair that merges are the closest to each other
    while let Some(motion) = left.pop() {
        let nearest = (0..left.len())
            .map(|k| (distance(more, motion, left[k]), k))
            .filter(|(gap, _)| *gap < JOINED)
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let other = nearest.map(|(_, k)| left.swap_remove(k));
        marks.push((kind, (value, other.map_or(at(motion), |other| 0.5 * (at(motion) + at(other))))));
    }
    marks
}
