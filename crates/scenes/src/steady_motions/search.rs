//! Interval evaluation of the equations of steady motion for the search over boxes; the reactions are bounded as functions of the positions.

use super::SteadyEquations;
use super::tapes::Tapes;
use algebra::boxes::Equations;
use field::Interval;
use nalgebra::DMatrix;
use symbolic::{Program, Propagation};

/// A condition is zero if its value is below this multiple of its derivatives times the unknowns.
const ROUNDING: f64 = 1e-10;

/// The equations and conditions, compiled for interval arguments, with buffers.
pub(super) struct Boxes<'a> {
    divided: usize,
    reactions: usize,
    values: Program<'a, Interval>,
    through: Propagation<'a>,
    surplus: Program<'a, Interval>,
    left: Vec<Interval>,
    implied: Program<'a, Interval>,
    implies: Vec<Interval>,
    through_surplus: Propagation<'a>,
    slopes: Program<'a, Interval>,
    loads: Program<'a, Interval>,
    /// Expressions with required signs; `holds` says for each whether it must be positive, otherwise negative.
    sides: Program<'a, Interval>,
    side_slopes: Program<'a, Interval>,
    through_sides: Propagation<'a>,
    holds: &'a [bool],
    side: Vec<Interval>,
    /// Factors of conditions and fractions of friction: index of the unknown, and the range to which it is limited.
    shares: Vec<(usize, Interval)>,
    /// The values of J^T, then of -h.
    load: Vec<Interval>,
}

/// A family of motions in a box: the motion at the midpoint of its parameters, the indices of the parameters, and the derivatives of all
/// unknowns by each.
pub(super) struct Tangents {
    pub middle: Vec<Interval>,
    pub parameters: Vec<usize>,
    pub tangents: Vec<Vec<Interval>>,
}

impl<'a> Boxes<'a> {
    /// The compiled equations; `tapes` may be those with sums of angles as unknowns.
    pub fn of(equations: &'a SteadyEquations, tapes: &'a Tapes) -> Self {
        let SteadyEquations { reactions, unknowns, holds, .. } = equations;
        let Tapes { values, slopes, loads, surplus, implied, sides, side_slopes, margins } = tapes;
        Boxes {
            divided: unknowns.len(),
            reactions: *reactions,
            values: values.over(),
            through: Propagation::of(values),
            surplus: surplus.over(),
            left: vec![Interval::EVERYTHING; surplus.outputs()],
            implied: implied.over(),
            implies: vec![Interval::EVERYTHING; implied.outputs()],
            through_surplus: Propagation::of(surplus),
            slopes: slopes.over(),
            loads: loads.over(),
            sides: sides.over(),
            side_slopes: side_slopes.over(),
            through_sides: Propagation::of(margins),
            holds,
            side: vec![Interval::EVERYTHING; holds.len()],
            shares: (unknowns.iter().enumerate())
                .filter(|(_, unknown)| unknown.place >= equations.state.len())
                .map(|(k, unknown)| (k, unknown.range.interval()))
                .collect(),
            load: vec![Interval::EVERYTHING; loads.outputs()],
        }
    }
}

impl Boxes<'_> {
    /// Whether all expressions with required signs have these signs everywhere in a box (`Some(true)`) or one has the other sign (`Some(false)`);
    /// `None` if undecided. A violated redundant constraint also gives `Some(false)`.
    pub fn lies_aside(&mut self, at: &[Interval]) -> Option<bool> {
        self.lies_aside_but_for(at, &[])
    }

    /// As [`Boxes::lies_aside`], without the expressions with the indices `open`.
    pub fn lies_aside_but_for(&mut self, at: &[Interval], open: &[usize]) -> Option<bool> {
        self.implied.evaluate(at, &mut self.implies);
        if self.implies.iter().any(|value| !value.contains(0.0)) {
            return Some(false);
        }
        if self.shares.iter().any(|(k, range)| at[*k].and(*range).is_none()) {
            return Some(false);
        }
        let are_within = self.shares.iter().all(|(k, range)| at[*k].is_part_of(*range));
        if self.holds.is_empty() {
            return are_within.then_some(true);
        }
        self.sides.evaluate(at, &mut self.side);
        // an unbounded enclosure, as of a root whose argument may be negative by rounding, does not show where the expression is defined
        if self.side.iter().any(|value| !value.size().is_finite()) && !self.narrow_aside(&mut at.to_vec()) {
            return Some(false);
        }
        let closed = |(own, _): &(usize, _)| !open.contains(own);
        let sides = || self.side.iter().zip(self.holds).enumerate().filter(closed).map(|(_, side)| side);
        if sides().any(|(value, holds)| if *holds { value.high() < 0.0 } else { value.low() > 0.0 }) {
            return Some(false);
        }
        let has_side = |(value, holds): (&Interval, &bool)| if *holds { value.low() > 0.0 } else { value.high() < 0.0 };
        (are_within && sides().all(has_side)).then_some(true)
    }
}

impl Boxes<'_> {
    /// Narrows a box to the points at which expressions may have their required signs; false if there are none.
    pub fn narrow_aside(&mut self, at: &mut [Interval]) -> bool {
        let side = |holds: &bool| if *holds { [0.0, f64::INFINITY] } else { [f64::NEG_INFINITY, 0.0] };
        let margins = self.holds.iter().map(side).map(|[from, to]| Interval::new(from, to));
        let mut all: Vec<Interval> = at.iter().copied().chain(margins).collect();
        if self.holds.is_empty() {
            return true;
        }
        let may = self.through_sides.narrow(&mut all);
        at.copy_from_slice(&all[..at.len()]);
        may
    }

    /// The indices of expressions that are zero, up to rounding, at all motions of a family in a box, if all others have their signs there. Uses the
    /// value at the midpoint and the derivative along the family, since the unknowns depend on each other.
    pub fn lies_along(&mut self, at: &[Interval], family: &Tangents) -> Option<Vec<usize>> {
        let (wide, open) = (at.len(), self.open_sides(at));
        let mut slopes = vec![Interval::EVERYTHING; self.side.len() * wide];
        self.side_slopes.evaluate(at, &mut slopes);
        self.sides.evaluate(&family.middle, &mut self.side);
        let is_zero = |&side: &usize| {
            let slopes = &slopes[side * wide..][..wide];
            let rates = family.parameters.iter().zip(&family.tangents).map(|(&place, tangent)| {
                let rate = slopes.iter().zip(tangent).fold(Interval::point(0.0), |sum, (by, along)| sum + *by * *along);
                rate * (at[place] - family.middle[place])
            });
            let value = rates.fold(self.side[side], |sum, rate| sum + rate);
            let scale: f64 = slopes.iter().zip(at).map(|(slope, at)| slope.size() * (1.0 + at.size())).sum();
            scale.is_finite() && value.size() <= ROUNDING * scale
        };
        let are_zero = !open.is_empty() && open.iter().all(is_zero);
        (are_zero && self.lies_aside_but_for(at, &open) == Some(true)).then_some(open)
    }

    /// The indices of expressions that may be zero in a box.
    pub fn open_sides(&mut self, at: &[Interval]) -> Vec<usize> {
        self.sides.evaluate(at, &mut self.side);
        (0..self.side.len()).filter(|&k| self.side[k].contains(0.0)).collect()
    }

    /// Whether each expression that may be zero in a box has a gradient that is not zero there.
    pub fn has_regular_sides(&mut self, at: &[Interval]) -> bool {
        let open = self.open_sides(at);
        open.into_iter().all(|side| self.side_slope(at, side).iter().any(|slope| !slope.contains(0.0)))
    }

    /// The derivatives of an expression with a required sign by the unknowns.
    pub fn side_slope(&mut self, at: &[Interval], side: usize) -> Vec<Interval> {
        let mut slopes = vec![Interval::EVERYTHING; self.side.len() * at.len()];
        self.side_slopes.evaluate(at, &mut slopes);
        slopes[side * at.len()..][..self.divided].to_vec()
    }

    /// Whether a zero in a box satisfies the surplus equations, which were not solved; `None` if undecided.
    pub fn fulfils_all(&mut self, at: &[Interval]) -> Option<bool> {
        self.surplus.evaluate(at, &mut self.left);
        match self.left.iter().all(|value| value.contains(0.0)) {
            true if self.left.is_empty() => Some(true),
            true => None,
            false => Some(false),
        }
    }
}

impl Equations for Boxes<'_> {
    fn divided(&self) -> usize {
        self.divided
    }

    fn determined(&self) -> usize {
        self.reactions
    }

    fn narrow(&mut self, at: &mut [Interval]) -> bool {
        self.through.narrow(at) && self.through_surplus.narrow(at) && self.lies_aside(at) != Some(false)
    }

    /// Bounds the reactions by as many rows of J^T lambda = h as there are reactions, chosen independent at the middle of the box.
    fn bound(&mut self, at: &mut [Interval]) -> bool {
        let m = self.reactions;
        let (positions, multipliers) = at.split_at_mut(self.divided);
        if m == 0 {
            return true;
        }
        let is_bounded = |multipliers: &[Interval]| multipliers.iter().all(|one| one.size().is_finite());
        self.loads.evaluate(positions, &mut self.load);
        let rows = self.load.len() / (m + 1);
        let (matrix, forces) = self.load.split_at(rows * m);
        let entry = |row: usize, column: usize| matrix[row * m + column];
        let Some(chosen) = independent(rows, m, |row, column| entry(row, column).middle()) else {
            return is_bounded(multipliers);
        };
        let middle = DMatrix::from_fn(m, m, |k, column| entry(chosen[k], column).middle());
        let Some(inverse) = middle.try_inverse() else { return is_bounded(multipliers) };
        let point = |value: f64| Interval::point(value);
        let product = |row: usize, of: &dyn Fn(usize) -> Interval| {
            (0..m).fold(point(0.0), |sum, k| sum + point(inverse[(row, k)]) * of(k))
        };
        // lambda = mid + e, |e| <= |C (h - J mid)| / (1 - |1 - C J|) in the maximum norm
        let guess: Vec<f64> = (0..m).map(|row| product(row, &|k| -forces[chosen[k]]).middle()).collect();
        let left: Vec<Interval> = (0..m)
            .map(|row| {
                product(row, &|k| (0..m).fold(-forces[chosen[k]], |sum, j| sum - entry(chosen[k], j) * point(guess[j])))
            })
            .collect();
        let defect = (0..m).map(|row| {
            let entries = (0..m).map(|column| {
                let one = if row == column { point(1.0) } else { point(0.0) };
                one - product(row, &|k| entry(chosen[k], column))
            });
            entries.fold(point(0.0), |sum, each| sum + point(each.size())).high()
        });
        let defect = defect.fold(0.0, f64::max);
        let size = left.iter().fold(0.0, |most: f64, each| most.max(each.size()));
        let bound = (point(size) / (point(1.0) - point(defect))).high();
        if !(defect < 1.0 && bound.is_finite()) {
            return is_bounded(multipliers);
        }
        for (one, guess) in multipliers.iter_mut().zip(&guess) {
            let found = point(*guess) + Interval::new(-bound, bound);
            // both contain every solution; if they are disjoint there is none
            *one = one.and(found).unwrap_or(found);
        }
        true
    }

    fn values(&mut self, at: &[Interval], values: &mut [Interval]) {
        self.values.evaluate(at, values);
    }

    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]) {
        self.slopes.evaluate(at, slopes);
    }
}

/// A choice of as many rows as columns that form a regular matrix, by partial pivoting; `None` if there is none.
pub(super) fn independent(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Vec<usize>> {
    let mut left = DMatrix::from_fn(rows, columns, entry);
    let mut chosen = Vec::new();
    for column in 0..columns {
        let pivot = (0..rows)
            .filter(|row| !chosen.contains(row))
            .max_by(|&a, &b| left[(a, column)].abs().total_cmp(&left[(b, column)].abs()))?;
        let value = left[(pivot, column)];
        if value == 0.0 || !value.is_finite() {
            return None;
        }
        for row in (0..rows).filter(|row| *row != pivot && !chosen.contains(row)) {
            let factor = left[(row, column)] / value;
            for other in column..columns {
                left[(row, other)] -= factor * left[(pivot, other)];
            }
        }
        chosen.push(pivot);
    }
    Some(chosen)
}
