//! Families of steady motions, where independent equations are fewer than unknowns: a speed may have any value, or an equation follows from
//! the others by an identity.
//!
//! A family is enclosed in pieces. In each piece there is exactly one motion for every value of its parameters.

mod columns;
mod ends;
mod identities;
mod local;
mod pieces;
mod sweep;

pub(super) use identities::Identity;

use super::equations::{NO_CASE, SteadyEquations};
use super::friction::Friction;
use super::search::{Boxes, Tangents};
use super::turns_to_zero;
use algebra::boxes::Equations;
use ends::{Ends, Extent};
use field::Interval;
use local::Local;
use pieces::{Limits, Piece, Pieces, Underdetermined};
use std::f64::consts::PI;
use sweep::Sweep;

/// A connected family of steady motions.
#[derive(Clone, Debug)]
pub struct Family {
    /// The dimension of the family.
    pub dimension: usize,
    /// For each piece, the indices of the unknowns that are its parameters, and the box of its motions, in SI units.
    pub pieces: Vec<(Vec<usize>, Vec<[f64; 2]>)>,
    /// For each unknown, a range that contains its values in all motions of the family.
    pub hull: Vec<[f64; 2]>,
    /// For each unknown, two values that are proved to be reached; `None` if no motion is proved.
    pub reached: Vec<Option<[f64; 2]>>,
    /// The displacements along which the forces do no work, one for each identity that causes the family.
    pub along: Vec<String>,
    /// The number of pieces at the border of the family; only some of their motions satisfy the conditions.
    pub border: usize,
    /// The indices, in the combination of cases, of conditions that are zero in all motions of the family.
    pub at_conditions: Vec<usize>,
    /// The effect of dry friction on small motions about those members that are strictly inside the friction limits; `None` without friction.
    pub friction: Option<Friction>,
    /// Some of the motions: values of unknowns and reactions.
    pub(super) members: Vec<Vec<f64>>,
}

impl Family {
    /// Whether pieces of two families have a point in common, up to rounding.
    pub(super) fn touches(&self, other: &Self) -> bool {
        let near = |[low, high]: &[f64; 2]| JOINT * (1.0 + low.abs().max(high.abs()));
        let meet = |one: &[[f64; 2]], other: &[[f64; 2]]| {
            let at = |(own, other): (&[f64; 2], &[f64; 2])| {
                own[0] <= other[1] + near(other) && other[0] <= own[1] + near(own)
            };
            one.iter().zip(other).all(at)
        };
        if self.dimension != other.dimension || !meet(&self.hull, &other.hull) {
            return false;
        }
        let wider = |at: &[f64; 2]| [at[0] - near(at), at[1] + near(at)];
        let all = self.pieces.iter().chain(&other.pieces).map(|(_, at)| at);
        let sweep = Sweep::of(&all.clone().map(|at| at.iter().map(wider).collect()).collect::<Vec<_>>(), |_| false);
        let (all, own): (Vec<&Vec<[f64; 2]>>, usize) = (all.collect(), self.pieces.len());
        sweep.any_pair(|a, b| (a < own) != (b < own) && meet(all[a], all[b]))
    }

    /// The union of two families that touch.
    pub(super) fn joined(mut self, other: Self) -> Self {
        let both = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a.min(c), b.max(d)];
        self.hull.iter_mut().zip(other.hull).for_each(|(own, other)| *own = both(*own, other));
        for (own, other) in self.reached.iter_mut().zip(other.reached) {
            *own = own.zip(other).map(|(own, other)| both(own, other)).or(*own).or(other);
        }
        self.pieces.extend(other.pieces);
        self.members.extend(other.members);
        self.along.extend(other.along);
        self.along.sort();
        self.along.dedup();
        self.border += other.border;
        self.at_conditions.retain(|place| other.at_conditions.contains(place));
        self.friction = common([self.friction, other.friction].into_iter());
        self
    }
}

/// Number of motions of a family whose stability is tested.
const MEMBERS: usize = 7;

/// A box is not divided along an unknown if its width is below this fraction of the range.
const SMALLEST: f64 = 1e-6;

/// The equations with the indices `rows`, without those that follow by identities.
struct Fewer<'a, 'b> {
    boxes: &'b mut Boxes<'a>,
    rows: Vec<usize>,
    all: usize,
    values: Vec<Interval>,
    slopes: Vec<Interval>,
}

impl Underdetermined for Fewer<'_, '_> {
    fn unknowns(&self) -> [usize; 2] {
        [self.boxes.divided(), self.boxes.determined()]
    }

    fn rows(&self) -> usize {
        self.rows.len()
    }

    fn narrow(&mut self, at: &mut [Interval]) -> bool {
        self.boxes.narrow(at) && self.boxes.narrow_aside(at)
    }

    fn bound(&mut self, at: &mut [Interval]) -> bool {
        self.boxes.bound(at)
    }

    fn holds(&mut self, at: &[Interval]) -> Option<bool> {
        self.boxes.lies_aside(at)
    }

    fn is_at_conditions(&mut self, at: &[Interval], parameters: &[usize]) -> bool {
        self.conditions_along(at, parameters).is_some()
    }

    fn values(&mut self, at: &[Interval], values: &mut [Interval]) {
        self.values.resize(self.all, Interval::EVERYTHING);
        self.boxes.values(at, &mut self.values);
        values.iter_mut().zip(&self.rows).for_each(|(value, &row)| *value = self.values[row]);
    }

    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]) {
        let wide = at.len();
        self.slopes.resize(self.all * wide, Interval::EVERYTHING);
        self.boxes.slopes(at, &mut self.slopes);
        for (own, &row) in slopes.chunks_mut(wide).zip(&self.rows) {
            own.copy_from_slice(&self.slopes[row * wide..(row + 1) * wide]);
        }
    }
}

impl Fewer<'_, '_> {
    /// The conditions that are zero in all motions of a box with these parameters, if all other conditions have their required signs there.
    fn conditions_along(&mut self, at: &[Interval], parameters: &[usize]) -> Option<Vec<usize>> {
        let tangents = Local::with(self, at, parameters)?.tangents()?;
        let mut middle = at.to_vec();
        parameters.iter().for_each(|&place| middle[place] = Interval::point(middle[place].middle()));
        pieces::narrow(self, parameters, &mut middle);
        self.boxes.lies_along(at, &Tangents { middle, parameters: parameters.to_vec(), tangents })
    }
}

/// Boxes with one choice of independent equations; `along` has the displacements of the identities.
struct OfRows {
    rows: Vec<usize>,
    along: Vec<String>,
    open: Vec<Vec<Interval>>,
}

/// The families that were found, and the undecided boxes.
#[derive(Default)]
pub(super) struct Enclosed {
    pub families: Vec<Family>,
    pub undecided: Vec<Vec<Interval>>,
    pub examined: usize,
}

/// The families in some boxes of a domain, for equations that are dependent or fewer than the unknowns.
pub(super) fn families(
    equations: &SteadyEquations,
    boxes: &mut Boxes<'_>,
    (domain, open): (&[Interval], Vec<Vec<Interval>>),
    most: usize,
    mut goes_on: impl FnMut() -> bool,
) -> Enclosed {
    let mut enclosed = Enclosed::default();
    let mut of_rows: Vec<OfRows> = Vec::new();
    for at in open {
        let (dropped, along) = Identity::implied(&equations.identities, &at);
        if dropped.is_empty() && equations.rows == at.len() + equations.reactions {
            enclosed.undecided.push(at);
            continue;
        }
        let rows: Vec<usize> = (0..equations.rows).filter(|row| !dropped.contains(row)).collect();
        match of_rows.iter_mut().find(|known| known.rows == rows) {
            Some(known) => known.open.push(at),
            None => of_rows.push(OfRows { rows, along, open: vec![at] }),
        }
    }
    let mut all: Vec<OwnPiece> = Vec::new();
    let mut fewer = Fewer { boxes, rows: Vec::new(), all: equations.rows, values: Vec::new(), slopes: Vec::new() };
    for OfRows { rows, along, open } in of_rows {
        let limits = Limits { boxes: most.saturating_sub(enclosed.examined), smallest: SMALLEST };
        fewer.rows.clone_from(&rows);
        let Pieces { pieces, undecided, examined } = pieces::pieces(&mut fewer, domain, open, limits, &mut goes_on);
        enclosed.examined += examined;
        enclosed.undecided.extend(undecided);
        let own = |piece: Piece| OwnPiece { piece, rows: rows.clone(), along: along.clone() };
        all.extend(pieces.into_iter().map(own));
    }
    enclosed.families = joined(equations, all, &mut fewer, &mut goes_on);
    enclosed
}

/// A piece, the indices of its equations, and the displacements of the identities.
struct OwnPiece {
    piece: Piece,
    rows: Vec<usize>,
    along: Vec<String>,
}

/// The families of all pieces: touching pieces belong to one family.
fn joined(
    equations: &SteadyEquations,
    all: Vec<OwnPiece>,
    fewer: &mut Fewer<'_, '_>,
    goes_on: &mut dyn FnMut() -> bool,
) -> Vec<Family> {
    let positions = equations.unknowns.len();
    let ends = |own: &OwnPiece| own.piece.enclosure[..positions].iter().map(|at| [at.low(), at.high()]).collect();
    let sweep = Sweep::of(&all.iter().map(ends).collect::<Vec<_>>(), |k| equations.unknowns[k].is_circle);
    let of = sweep.groups(|one, other| {
        let [one, other] = [one, other].map(|own| &all[own].piece);
        one.parameters.len() == other.parameters.len() && touch(equations, one, other)
    });
    let mut groups: Vec<usize> = of.clone();
    groups.sort_unstable();
    groups.dedup();
    let of_group = |group: usize| {
        let own: Vec<&OwnPiece> =
            all.iter().zip(&of).filter(|(_, own)| **own == group).map(|(piece, _)| piece).collect();
        family(equations, &own, fewer, goes_on)
    };
    let mut found: Vec<Family> = groups.into_iter().map(of_group).collect();
    found.sort_by(|a, b| {
        b.dimension.cmp(&a.dimension).then_with(|| {
            a.hull
                .iter()
                .flatten()
                .zip(b.hull.iter().flatten())
                .map(|(a, b)| a.total_cmp(b))
                .find(|order| order.is_ne())
                .unwrap_or(std::cmp::Ordering::Equal)
        })
    });
    found
}

/// Whether two pieces have a point in common; angles are compared up to whole turns.
fn touch(equations: &SteadyEquations, one: &Piece, other: &Piece) -> bool {
    equations.unknowns.iter().zip(one.enclosure.iter().zip(&other.enclosure)).all(|(unknown, (one, other))| {
        let turns = match unknown.is_circle {
            true => ((one.middle() - other.middle()) / (2.0 * PI)).round() * 2.0 * PI,
            false => 0.0,
        };
        // tolerance for the rounding of a whole turn
        let moved = *other + Interval::new(turns - 1e-12, turns + 1e-12);
        one.and(moved).is_some()
    })
}

fn family(
    equations: &SteadyEquations,
    pieces: &[&OwnPiece],
    fewer: &mut Fewer<'_, '_>,
    goes_on: &mut dyn FnMut() -> bool,
) -> Family {
    let positions = equations.unknowns.len();
    let ends = |piece: &Piece| -> Vec<[f64; 2]> {
        let ranges = equations.unknowns.iter().map(|unknown| unknown.range);
        let own = piece.enclosure[..positions].iter().zip(ranges);
        // a piece may extend beyond the searched ranges
        own.map(|(own, range)| [own.low().max(range.from), own.high().min(range.to)]).collect()
    };
    let all: Vec<(Vec<usize>, Vec<[f64; 2]>)> =
        pieces.iter().map(|own| (own.piece.parameters.clone(), ends(&own.piece))).collect();
    let of_piece = pieces.iter().map(|own| (&own.piece, &own.rows[..])).collect();
    let extents = Ends { pieces: of_piece, unknowns: &equations.unknowns };
    let mut extent = |k: usize| {
        let ends = all.iter().map(|(_, at)| at[k]);
        let is_circle = equations.unknowns[k].is_circle;
        let within = if is_circle { arc(ends.collect()) } else { around(ends) };
        match is_circle && within[1] - within[0] >= 2.0 * PI - JOINT {
            true => Extent { within, reached: Some(within) },
            false => extents.along((k, within), fewer, &mut *goes_on),
        }
    };
    let (hull, reached) = (0..positions).map(&mut extent).map(|own| (own.within, own.reached)).unzip();
    let mut along: Vec<String> = pieces.iter().flat_map(|own| own.along.iter().cloned()).collect();
    along.sort();
    along.dedup();
    let between = pieces.len().div_ceil(MEMBERS).max(1);
    let each = MEMBERS.div_ceil(pieces.len());
    let mut members = Vec::new();
    for own in pieces.iter().step_by(between) {
        fewer.rows.clone_from(&own.rows);
        for part in 0..each {
            let mut at = pieces::solution(fewer, &own.piece, (part as f64 + 0.5) / each as f64);
            for (value, _) in at.iter_mut().zip(&equations.unknowns).filter(|(_, unknown)| unknown.is_circle) {
                *value += turns_to_zero(*value);
            }
            members.push(at);
        }
    }
    let of_piece = |own: &&OwnPiece| equations.friction.as_ref().map(|law| law.at(&own.piece.enclosure[..positions]));
    let friction = common(pieces.iter().map(of_piece));
    let dimension = pieces[0].piece.parameters.len();
    let border = pieces.iter().filter(|own| own.piece.is_border()).count();
    let at_conditions = along_conditions(equations, pieces, fewer);
    Family { dimension, members, pieces: all, hull, reached, along, border, at_conditions, friction }
}

/// The conditions that are zero in the inner part of every piece, as indices in the combination.
fn along_conditions(equations: &SteadyEquations, pieces: &[&OwnPiece], fewer: &mut Fewer<'_, '_>) -> Vec<usize> {
    let mut common: Option<Vec<usize>> = None;
    for own in pieces {
        fewer.rows.clone_from(&own.rows);
        let inner = own.piece.inner.as_ref();
        let sides = inner.and_then(|inner| fewer.conditions_along(inner, &own.piece.parameters)).unwrap_or_default();
        let places: Vec<usize> = sides.into_iter().map(|side| equations.side_places[side]).collect();
        common = Some(match common {
            Some(known) => known.into_iter().filter(|place| places.contains(place)).collect(),
            None => places,
        });
    }
    common.unwrap_or_default().into_iter().filter(|place| *place != NO_CASE).collect()
}

/// The effect of friction if it is equal in all parts; otherwise `Friction::Open`. `None` without friction.
fn common(mut all: impl Iterator<Item = Option<Friction>>) -> Option<Friction> {
    let first = all.next()??;
    Some(if all.all(|own| own == Some(first)) { first } else { Friction::Open })
}

/// Gaps between pieces below this size are rounding errors.
const JOINT: f64 = 1e-9;

/// The smallest interval that contains all the intervals.
fn around(ends: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |all, own| [all[0].min(own[0]), all[1].max(own[1])])
}

/// The smallest arc that contains all the arcs of a circle, in radians; the end may exceed a turn.
fn arc(mut ends: Vec<[f64; 2]>) -> [f64; 2] {
    ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let first = ends[0][0];
    let mut last = f64::NEG_INFINITY;
    let (mut widest, mut begin) = (0.0, first);
    for own in &ends {
        if own[0] - last > widest && last.is_finite() {
            (widest, begin) = (own[0] - last, own[0]);
        }
        last = last.max(own[1]);
    }
    if widest <= JOINT || first + 2.0 * PI - last >= widest {
        return [first, last];
    }
    // the widest gap lies between the arcs: the result begins behind it and continues beyond a turn
    let end = ends.iter().map(|own| own[1]).filter(|end| *end < begin).fold(f64::NEG_INFINITY, f64::max) + 2.0 * PI;
    let turns = turns_to_zero(begin);
    [begin + turns, end + turns]
}

#[cfg(test)]
mod tests {
    use super::arc;
    use std::f64::consts::PI;

    #[test]
    fn an_arc_over_the_cut_of_a_circle_is_as_wide_as_its_pieces() {
        let near =
            |found: [f64; 2], from: f64, to: f64| (found[0] - from).abs() < 1e-12 && (found[1] - to).abs() < 1e-12;
        assert!(near(arc(vec![[2.0, 2.6], [-3.7, -3.5]]), 2.0, 2.0 * PI - 3.5));
        assert!(near(arc(vec![[-0.5, 0.1], [0.1, 0.4]]), -0.5, 0.4));
        // the whole circle except for one gap
        assert!(near(arc(vec![[-3.7, -1.0], [-0.5, 2.6]]), -0.5, 2.0 * PI - 1.0));
        assert!(near(arc(vec![[-3.7586, 1.0], [0.9, 2.5247]]), -3.7586, 2.5247));
    }
}
