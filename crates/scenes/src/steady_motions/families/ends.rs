//! Bounds of a family along each unknown: values beyond which it contains no motion, and values that its motions are proved to reach.
//!
//! The piece of the family that extends furthest is bisected along its parameters. In each half Krawczyk's operator narrows the dependent
//! unknowns. The bisection ends when a proved motion is within rounding of the outer bound, or when the parameters are too narrow.

use super::Fewer;
use super::pieces::{Piece, fulfils, narrow};
use crate::steady_motions::Unknown;
use field::Interval;
use std::f64::consts::PI;

/// The range of an unknown over a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    /// A range that contains the values of all motions.
    pub within: [f64; 2],
    /// Two values that the unknown is proved to reach; `None` if no motion is proved to satisfy all conditions.
    pub reached: Option<[f64; 2]>,
}

/// Largest distance between the outer bound and a proved motion at which an end is known, in SI units and relative to the value.
const KNOWN: f64 = 1e-10;

/// Largest number of bisections for each end.
const HALVINGS: usize = 160;

/// Parameters narrower than this, relative to their values, are not bisected.
const NARROW: f64 = 1e-15;

/// A part of a piece: a box of motions; `holds` says whether all of them are proved to satisfy the conditions.
#[derive(Clone)]
struct Part<'a> {
    piece: &'a Piece,
    rows: &'a [usize],
    at: Vec<Interval>,
    holds: bool,
}

/// The pieces of a family, each with the indices of the equations that determine it; and the unknowns with their ranges.
pub(super) struct Ends<'a> {
    pub pieces: Vec<(&'a Piece, &'a [usize])>,
    pub unknowns: &'a [Unknown],
}

impl<'a> Ends<'a> {
    /// The range of the unknown with index `place`, which lies in the interval `within`.
    pub fn along(
        &self,
        (place, within): (usize, [f64; 2]),
        equations: &mut Fewer<'_, '_>,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Extent {
        let begun = self.pieces.iter().flat_map(|&(piece, rows)| {
            let part = |at: &Vec<Interval>, holds: bool| Part {
                piece,
                rows,
                holds: holds && self.is_in_ranges(at),
                at: at.clone(),
            };
            let inner = piece.inner.as_ref().map(|inner| part(inner, true));
            [part(&piece.enclosure, piece.holds)].into_iter().chain(inner)
        });
        let mut parts: Vec<Part<'_>> = begun.filter(|part| self.meets_ranges(&part.at)).collect();
        let mut ends = [Bound::default(); 2];
        for (side, end) in [-1.0, 1.0].into_iter().zip(&mut ends) {
            let far = |at: &Interval| if side < 0.0 { -at.low() } else { at.high() };
            let near = |at: &Interval| if side < 0.0 { -at.high() } else { at.low() };
            // the furthest of the proved motions at midpoints
            let mut single: Option<f64> = None;
            for halvings in 0..=HALVINGS {
                let bounds = |part: &Part<'_>| self.within(&part.at, place, within);
                let Some((first, outer)) = parts
                    .iter()
                    .enumerate()
                    .map(|(own, part)| (own, far(&bounds(part))))
                    .max_by(|a, b| a.1.total_cmp(&b.1))
                else {
                    break;
                };
                let shown = |part: &Part<'_>| match part.piece.parameters.contains(&place) {
                    true => far(&bounds(part)),
                    false => near(&bounds(part)),
                };
                let reached = parts.iter().filter(|part| part.holds).map(shown).chain(single).max_by(f64::total_cmp);
                *end = Bound { outer: side * outer, reached: reached.map(|reached| side * reached) };
                let is_known = reached.is_some_and(|reached| outer - reached <= KNOWN * (1.0 + outer.abs()));
                if is_known || halvings == HALVINGS || !goes_on() {
                    break;
                }
                let Some(halves) = self.halves(&parts[first], equations) else { break };
                let middles = halves.iter().filter_map(|half| self.middle(half, equations));
                let furthest = middles.map(|at| near(&self.within(&at, place, within)));
                single = furthest.chain(single).max_by(f64::total_cmp);
                parts.swap_remove(first);
                parts.extend(halves);
            }
        }
        let [low, high] = ends;
        let reached = low.reached.zip(high.reached).map(|(low, high)| [low, high]);
        Extent { within: [low.outer.max(within[0]), high.outer.min(within[1])], reached }
    }

    /// The range of an unknown in a box: an angle is shifted by whole turns next to `within`, another unknown is cut to its searched range.
    fn within(&self, at: &[Interval], place: usize, within: [f64; 2]) -> Interval {
        let (unknown, at) = (&self.unknowns[place], at[place]);
        if !unknown.is_circle {
            return at.and(unknown.range.interval()).unwrap_or(at);
        }
        let middle = 0.5 * (within[0] + within[1]);
        let turns = ((middle - at.middle()) / (2.0 * PI)).round() * 2.0 * PI;
        at + Interval::new(turns.next_down(), turns.next_up())
    }

    fn meets_ranges(&self, at: &[Interval]) -> bool {
        self.unknowns.iter().zip(at).all(|(own, at)| own.is_circle || at.and(own.range.interval()).is_some())
    }

    fn is_in_ranges(&self, at: &[Interval]) -> bool {
        self.unknowns.iter().zip(at).all(|(own, at)| own.is_circle || at.is_part_of(own.range.interval()))
    }

    /// The halves of a part along its relatively widest parameter, without those that contain no motion; `None` if all parameters are narrow.
    fn halves<'p>(&self, part: &Part<'p>, equations: &mut Fewer<'_, '_>) -> Option<Vec<Part<'p>>> {
        let share = |&k: &usize| part.at[k].width() / part.piece.enclosure[k].width();
        let is_wide = |k: &usize| part.at[*k].width() > NARROW * (1.0 + part.at[*k].size());
        let widest = part.piece.parameters.iter().copied().filter(is_wide);
        let widest = widest.max_by(|a, b| share(a).total_cmp(&share(b)))?;
        let own = part.at[widest];
        let mut halves = Vec::new();
        equations.rows = part.rows.to_vec();
        for half in [Interval::new(own.low(), own.middle()), Interval::new(own.middle(), own.high())] {
            let mut at = part.at.clone();
            at[widest] = half;
            narrow(equations, &part.piece.parameters, &mut at);
            let fulfilled = if part.piece.holds { Some(true) } else { fulfils(equations, &at, &part.piece.parameters) };
            if fulfilled != Some(false) && self.meets_ranges(&at) {
                let holds = fulfilled == Some(true) && self.is_in_ranges(&at);
                halves.push(Part { at, holds, ..part.clone() });
            }
        }
        Some(halves)
    }

    /// The box of the motion at the midpoint of the parameters; `None` if it is not proved to satisfy all conditions.
    fn middle(&self, part: &Part<'_>, equations: &mut Fewer<'_, '_>) -> Option<Vec<Interval>> {
        let mut at = part.at.clone();
        part.piece.parameters.iter().for_each(|&place| at[place] = Interval::point(at[place].middle()));
        equations.rows = part.rows.to_vec();
        narrow(equations, &part.piece.parameters, &mut at);
        let fulfilled = part.piece.holds || fulfils(equations, &at, &part.piece.parameters) == Some(true);
        (fulfilled && self.is_in_ranges(&at)).then_some(at)
    }
}

/// One end of a range: no motion lies beyond `outer`, and a motion is proved at `reached`.
#[derive(Clone, Copy, Default)]
struct Bound {
    outer: f64,
    reached: Option<f64>,
}
