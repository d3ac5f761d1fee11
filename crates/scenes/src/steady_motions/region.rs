//! Undecided regions of a search, each with a numerical diagnosis: merging motions, a family, or singular equations.

use super::dependence::may_be_dependent;
use super::equations::{SteadyEquations, Unknown};
use algebra::boxes::Zero;
use field::Interval;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// A region of undecided boxes that touch one another.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The smallest box that contains the undecided boxes, in SI units.
    pub hull: Vec<[f64; 2]>,
    /// The number of boxes.
    pub boxes: usize,
    /// The numerical diagnosis.
    pub near: Near,
    /// Whether the region is proved to contain a steady motion: the equations change their signs between opposite faces (theorem of Poincare
    /// and Miranda). This test also works for singular equations.
    pub holds_one: bool,
}

/// The result of Newton's method from some boxes of a region: a numerical indication, not a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Near {
    /// No steady motion other than the known ones is found.
    Nothing,
    /// The equations are undefined somewhere in the region, since a distance or a divisor is zero there.
    Undefined,
    /// The constraints are dependent, or nearly so, somewhere in the region: reactions are unbounded there.
    Dependent,
    /// A motion with regular equations: a search with more boxes would prove it.
    Regular,
    /// A motion at which the equations are singular in this number of directions, without further motions along these: motions merge.
    Merging(usize),
    /// Motions that form a family of this dimension: a curve, a surface.
    Family(usize),
}

/// Largest number of unknowns for the test of signs on faces. `FACE` is the distance of these faces from the region, relative to its width.
const MOST_FACES: usize = 6;
const FACE: f64 = 0.25;

/// Number of cells along each unknown into which boxes are sorted; cells are at least as large as the largest box.
const CELLS: f64 = 48.0;

/// With more cells, all boxes are one region.
const MOST_CELLS: usize = 2_000;

/// With more boxes, all are one region: separating them would take longer than the search.
const MOST_BOXES: usize = 20_000;

/// With more regions, the size of the cells is doubled.
const MOST_REGIONS: usize = 16;

/// Number of boxes, over all regions, from which Newton's method starts; for more than six unknowns fewer, since the cost grows with the
/// cube of the number.
const BEGINNINGS: usize = 96;

/// Largest number of iterations of a singular value decomposition.
const MOST_ITERATIONS: usize = 1_000;

/// Largest number of Newton's iterations.
const STEPS: usize = 60;

/// Zeros whose values differ by less, relative to the values, are equal.
const ROUNDING: f64 = 1e-9;

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-6;

/// Singular value of the equations, divided by their largest derivatives over the ranges, below which a position may be singular.
const LEAST_REGULAR: f64 = 1e-4;

/// Newton's method starts at this fraction of a box along each unknown.
const ASIDE_OF_MIDDLE: f64 = 0.43;

/// A region is small if its widths are below this fraction of the ranges.
const SMALL: f64 = 1e-5;

/// Length of a displacement along a singular direction, as a fraction of a range.
const ASIDE: f64 = 1e-3;

/// The regions of undecided boxes; those with most boxes come first.
pub(super) fn regions(equations: &SteadyEquations, known: &[Zero], undecided: &[Vec<Interval>]) -> Vec<Region> {
    let ranges: Vec<Interval> = equations.unknowns.iter().map(|unknown| unknown.range.interval()).collect();
    let mut cells = if undecided.len() > MOST_BOXES { 1.0 } else { CELLS };
    let mut groups = grouped(&ranges, undecided, cells);
    while groups.len() > MOST_REGIONS {
        cells *= 0.5;
        groups = grouped(&ranges, undecided, cells);
    }
    let dear = (equations.unknowns.len() + equations.reactions).max(6).pow(3) / 6_usize.pow(3);
    let beginnings = (BEGINNINGS / dear / groups.len().max(1)).max(1);
    let mut all: Vec<Region> = groups.into_iter().map(|boxes| region(equations, known, (&boxes, beginnings))).collect();
    all.sort_by(|a, b| b.boxes.cmp(&a.boxes).then_with(|| a.hull[0][0].total_cmp(&b.hull[0][0])));
    all
}

/// Groups of boxes whose cells touch, with `cells` cells along each unknown.
fn grouped<'a>(ranges: &[Interval], undecided: &'a [Vec<Interval>], cells: f64) -> Vec<Vec<&'a Vec<Interval>>> {
    let largest = |k: usize| undecided.iter().fold(0.0, |most: f64, at| most.max(at[k].width()));
    let sizes: Vec<f64> = (0..ranges.len()).map(|k| largest(k).max(ranges[k].width() / cells)).collect();
    let cell = |at: &Vec<Interval>| -> Vec<i64> {
        (0..sizes.len()).map(|k| ((at[k].middle() - ranges[k].low()) / sizes[k]).floor() as i64).collect()
    };
    let mut filled: BTreeMap<Vec<i64>, Vec<&Vec<Interval>>> = BTreeMap::new();
    undecided.iter().for_each(|at| filled.entry(cell(at)).or_default().push(at));
    let mut groups: BTreeMap<usize, Vec<&Vec<Interval>>> = BTreeMap::new();
    for (group, boxes) in joined(&filled.keys().collect::<Vec<_>>()).into_iter().zip(filled.into_values()) {
        groups.entry(group).or_default().extend(boxes);
    }
    groups.into_values().collect()
}

/// For each cell the number of its group; touching cells belong to one group.
fn joined(cells: &[&Vec<i64>]) -> Vec<usize> {
    let mut of: Vec<usize> = (0..cells.len()).collect();
    if cells.len() > MOST_CELLS {
        return vec![0; cells.len()];
    }
    let touch = |a: &Vec<i64>, b: &Vec<i64>| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1);
    for i in 0..cells.len() {
        for j in 0..i {
            let (one, other) = (of[i], of[j]);
            if one != other && touch(cells[i], cells[j]) {
                of.iter_mut().filter(|group| **group == one).for_each(|group| *group = other);
            }
        }
    }
    of
}

fn region(equations: &SteadyEquations, known: &[Zero], (boxes, beginnings): (&[&Vec<Interval>], usize)) -> Region {
    let mut hull = boxes[0].clone();
    for at in boxes {
        hull.iter_mut().zip(*at).for_each(|(hull, at)| *hull = hull.hull(*at));
    }
    let between = boxes.len().div_ceil(beginnings);
    let begun = boxes.iter().skip(boxes.len() / 2 % between).step_by(between);
    let near = match (has_values(equations, &hull), may_be_dependent(equations, &hull)) {
        (false, _) => Near::Undefined,
        (true, true) => Near::Dependent,
        (true, false) => begun.map(|from| near(equations, known, from, &hull)).max().unwrap_or(Near::Nothing),
    };
    let holds_one = holds_one(equations, &hull);
    Region { hull: hull.into_iter().map(|at| [at.low(), at.high()]).collect(), boxes: boxes.len(), near, holds_one }
}

/// Whether the loads are bounded in a small region; true for large regions, in which enclosures are too wide for a decision.
fn has_values(equations: &SteadyEquations, hull: &[Interval]) -> bool {
    let is_large = |(at, unknown): (&Interval, &Unknown)| at.width() > SMALL * unknown.range.interval().width();
    if hull.iter().zip(&equations.unknowns).any(is_large) {
        return true;
    }
    let mut loads = vec![Interval::EVERYTHING; equations.tapes.loads.outputs()];
    equations.tapes.loads.over::<Interval>().evaluate(hull, &mut loads);
    loads.iter().all(|load| load.size().is_finite())
}

/// Whether every unknown can be assigned an equation of its own that has opposite signs on the two faces of this unknown, for a box slightly
/// larger than the region.
fn holds_one(equations: &SteadyEquations, hull: &[Interval]) -> bool {
    let unknowns = hull.len();
    let others = equations.tapes.surplus.outputs() + equations.tapes.implied.outputs() + equations.holds.len();
    if equations.reactions > 0 || equations.rows != unknowns || unknowns > MOST_FACES || others > 0 {
        return false;
    }
    let wider: Vec<Interval> =
        hull.iter().map(|at| Interval::new(at.low() - FACE * at.width(), at.high() + FACE * at.width())).collect();
    let mut program = equations.tapes.values.over::<Interval>();
    let mut signs_on = |k: usize, face: f64| {
        let (mut at, mut values) = (wider.clone(), vec![Interval::EVERYTHING; unknowns]);
        at[k] = Interval::point(face);
        program.evaluate(&at, &mut values);
        values.into_iter().map(|value| value.sign().unwrap_or(0)).collect::<Vec<_>>()
    };
    let faces: Vec<[Vec<i32>; 2]> =
        (0..unknowns).map(|k| [wider[k].low(), wider[k].high()].map(|face| signs_on(k, face))).collect();
    let changes = |k: usize, row: usize| faces[k][0][row] * faces[k][1][row] < 0;
    matched(unknowns, &changes, 0, &mut vec![false; unknowns])
}

/// Whether each unknown from `from` on can be assigned an equation that is not yet taken.
fn matched(count: usize, changes: &impl Fn(usize, usize) -> bool, from: usize, taken: &mut Vec<bool>) -> bool {
    if from == count {
        return true;
    }
    (0..count).any(|row| {
        if taken[row] || !changes(from, row) {
            return false;
        }
        taken[row] = true;
        let all = matched(count, changes, from + 1, taken);
        taken[row] = false;
        all
    })
}

fn near(equations: &SteadyEquations, known: &[Zero], from: &[Interval], hull: &[Interval]) -> Near {
    let positions = equations.unknowns.len();
    let mut start = DVector::zeros(positions + equations.reactions);
    // not the midpoint, which may be a point of symmetry
    (0..positions).for_each(|k| start[k] = from[k].low() + ASIDE_OF_MIDDLE * from[k].width());
    let Some(found) = zero(equations, start) else { return Near::Nothing };
    let margin = |k: usize| ASIDE * equations.unknowns[k].range.interval().width();
    let is_there = |at: &DVector<f64>| {
        (0..positions).all(|k| at[k] >= hull[k].low() - margin(k) && at[k] <= hull[k].high() + margin(k))
    };
    let is_known = known.iter().any(|zero| {
        (0..positions).all(|k| (found[k] - zero.enclosure[k].middle()).abs() <= ROUNDING * (1.0 + found[k].abs()))
    });
    if is_known || !is_there(&found) {
        return Near::Nothing;
    }
    // rows are scaled by their largest derivatives, so that an equation all of whose derivatives vanish at the zero counts as singular
    let Some(mut scaled) = slopes(equations, &found) else { return Near::Nothing };
    let largest = largest_slopes(equations);
    for (row, largest) in largest.iter().enumerate().filter(|(_, largest)| **largest > 0.0 && largest.is_finite()) {
        scaled.row_mut(row).unscale_mut(*largest);
    }
    let Some(svd) = scaled.try_svd(false, true, f64::EPSILON, MOST_ITERATIONS) else { return Near::Nothing };
    let Some(rows) = svd.v_t else { return Near::Nothing };
    let regular =
        svd.singular_values[0].max(if largest.iter().all(|one| one.is_finite()) { LEAST_REGULAR } else { 0.0 });
    let is_zero = |k: usize| svd.singular_values[k] <= RANK * regular;
    let singular: Vec<usize> = (0..svd.singular_values.len()).filter(|&k| is_zero(k)).collect();
    let stands_beside = |&k: &usize| {
        let direction = rows.row(k).transpose();
        let size = (0..positions).map(|i| direction[i].abs() / margin(i)).fold(0.0, f64::max);
        let beside = zero(equations, &found + &direction / size);
        beside.is_some_and(|beside| (beside - &found).dot(&direction) > 0.5 / size)
    };
    match (singular.len(), singular.iter().filter(|k| stands_beside(k)).count()) {
        (0, _) => Near::Regular,
        (merging, 0) => Near::Merging(merging),
        (_, family) => Near::Family(family),
    }
}

/// A zero near a point by Newton's method with least-norm steps; `None` if it does not converge.
fn zero(equations: &SteadyEquations, mut at: DVector<f64>) -> Option<DVector<f64>> {
    let mut program = equations.tapes.values.over::<f64>();
    let mut values = vec![0.0; at.len()];
    // truncation removes singular values that are zero since equations are fewer than unknowns
    for _ in 0..STEPS {
        program.evaluate(at.as_slice(), &mut values[..equations.rows]);
        let svd = slopes(equations, &at)?.try_svd(true, true, f64::EPSILON, MOST_ITERATIONS)?;
        let largest = svd.singular_values.max();
        let step = svd.solve(&DVector::from_column_slice(&values), RANK * largest).ok()?;
        at -= &step;
        if !at.iter().all(|at| at.is_finite()) {
            return None;
        }
        if step.norm() <= 1e-12 * (1.0 + at.norm()) {
            break;
        }
    }
    program.evaluate(at.as_slice(), &mut values[..equations.rows]);
    let size = slopes(equations, &at)?.norm() * (1.0 + at.norm());
    values.iter().all(|value| value.abs() <= 1e-9 * size).then_some(at)
}

/// A bound of the derivatives of each equation over the ranges of the unknowns; infinite if there is none.
fn largest_slopes(equations: &SteadyEquations) -> Vec<f64> {
    let ranges = equations.unknowns.iter().map(|unknown| unknown.range.interval());
    let all: Vec<Interval> = ranges.chain((0..equations.reactions).map(|_| Interval::EVERYTHING)).collect();
    let mut slopes = vec![Interval::EVERYTHING; equations.rows * all.len()];
    equations.tapes.slopes.over::<Interval>().evaluate(&all, &mut slopes);
    slopes.chunks(all.len()).map(|row| row.iter().fold(0.0, |largest: f64, slope| largest.max(slope.size()))).collect()
}

/// The derivatives of the equations, filled up with zero rows; `None` if one is not finite, such as that of a distance at zero.
fn slopes(equations: &SteadyEquations, at: &DVector<f64>) -> Option<DMatrix<f64>> {
    let mut slopes = vec![0.0; at.len() * at.len()];
    equations.tapes.slopes.over::<f64>().evaluate(at.as_slice(), &mut slopes[..equations.rows * at.len()]);
    let are_numbers = slopes.iter().all(|slope| slope.is_finite());
    are_numbers.then(|| DMatrix::from_row_slice(at.len(), at.len(), &slopes))
}
