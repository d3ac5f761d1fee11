//! All solutions of fewer equations than unknowns, in pieces: boxes in which there is one solution, and no other, for every value of some
//! unknowns, its parameters.
//!
//! Krawczyk's operator for the other unknowns x, with the parameters t anywhere in their ranges T about t0,
//!
//!   K(X) = m - C f(m, t0) - C f_t (T - t0) + (1 - C f_x(X, T)) (X - m) inside X .

use super::local::Local;
use algebra::boxes::halves;
use field::Interval;
use std::collections::VecDeque;

/// Equations over intervals, fewer than unknowns.
pub(in crate::steady_motions) trait Underdetermined {
    /// The number of unknowns that are divided, which come first, and the number of unknowns that are bounded by the others.
    fn unknowns(&self) -> [usize; 2];

    fn rows(&self) -> usize;

    /// Narrows a box of all unknowns; false where no solution is in it.
    fn narrow(&mut self, at: &mut [Interval]) -> bool;

    /// Bounds for the unknowns that are not divided; false where there are none.
    fn bound(&mut self, at: &mut [Interval]) -> bool;

    /// Whether the further conditions on solutions hold in the whole box, or nowhere in it; none if this is not decided.
    fn holds(&mut self, _at: &[Interval]) -> Option<bool> {
        Some(true)
    }

    /// Whether each further condition that is open in a box is zero at all solutions in it, to rounding, one for each value of some unknowns.
    fn is_at_conditions(&mut self, _at: &[Interval], _parameters: &[usize]) -> bool {
        false
    }

    fn values(&mut self, at: &[Interval], values: &mut [Interval]);

    /// Derivatives, row after row.
    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]);
}

/// One solution for every value of the parameters.
#[derive(Clone, Debug)]
pub(in crate::steady_motions) struct Piece {
    /// Places of the parameters.
    pub parameters: Vec<usize>,
    /// The box of the solutions, with all values of the parameters.
    pub enclosure: Vec<Interval>,
    /// The box in which there is no other solution.
    alone: Vec<Interval>,
    /// Whether everything else holds for all of its solutions; else that is open.
    pub holds: bool,
    /// A part, narrower than the box by rounding alone, for all of whose solutions it holds, or is at its end.
    pub inner: Option<Vec<Interval>>,
}

impl Piece {
    /// Whether everything else holds for some of its solutions at most.
    pub fn is_border(&self) -> bool {
        !self.holds && self.inner.is_none()
    }
}

/// Every solution lies in a piece or in an undecided box.
#[derive(Debug, Default)]
pub(in crate::steady_motions) struct Pieces {
    pub pieces: Vec<Piece>,
    pub undecided: Vec<Vec<Interval>>,
    pub examined: usize,
}

/// Where a search ends.
#[derive(Clone, Copy)]
pub(in crate::steady_motions) struct Limits {
    pub boxes: usize,
    /// Fraction of the domain, along each unknown, below which a box is not divided.
    pub smallest: f64,
}

/// Steps of Newton's method towards the middle of a piece.
const STEPS: usize = 8;

/// The width of a piece about its middle, relative to the change of the solutions along it.
const WIDTHS: [f64; 3] = [1.25, 2.0, 4.0];

/// The same relative to the change by the largest derivatives in a box.
const OVER_BOX: [f64; 2] = [1.25, 2.0];

/// If a narrowed box is smaller than this fraction of the box, it is narrowed again.
const WORTH: f64 = 0.75;

/// The width, as a fraction of the domain, to which the border of a curve is located, where a condition ends it.
const END: f64 = 1e-9;

/// The same of a surface, which has many boxes along its border, and of families of more dimensions.
const BORDERS: [f64; 2] = [4e-3, 3e-2];

/// The part of the domain, along each parameter, by which the inner part of a piece is narrower on each side.
const ASIDE: f64 = 1e-10;

/// Boxes between two checks of the deadline.
const BETWEEN: usize = 8;

/// All pieces in some boxes of the divided unknowns, which are parts of a domain.
pub(in crate::steady_motions) fn pieces(
    equations: &mut dyn Underdetermined,
    domain: &[Interval],
    boxes: Vec<Vec<Interval>>,
    limits: Limits,
    mut goes_on: impl FnMut() -> bool,
) -> Pieces {
    // sides could be narrowed without end where equations have no values
    let least: Vec<f64> = domain.iter().map(|side| limits.smallest * side.width()).collect();
    let mut found = Pieces::default();
    let mut open = VecDeque::from(boxes);
    while let Some(next) = open.pop_front() {
        if found.examined >= limits.boxes || found.examined.is_multiple_of(BETWEEN) && !goes_on() {
            found.undecided.push(next);
            found.undecided.extend(open);
            break;
        }
        found.examined += 1;
        let Some(Open { left, blamed, end }) = examined(equations, next, (&mut found.pieces, &least), domain) else {
            continue;
        };
        let smallest = match end.as_ref().map(|end| end.parameters.len()) {
            None => limits.smallest,
            Some(0 | 1) => END,
            Some(dimension) => BORDERS[(dimension - 2).min(1)],
        };
        match (halves(&left, domain, blamed, smallest), end) {
            (Some(halves), _) => open.extend(halves),
            (None, Some(end)) => found.pieces.push(end),
            (None, None) => found.undecided.push(left),
        }
    }
    found
}

/// The part of a box that is still open.
struct Open {
    left: Vec<Interval>,
    /// The unknown to divide, if a single one spreads the equations.
    blamed: Option<usize>,
    /// Its solutions, if only the further conditions are undecided for some of them.
    end: Option<Piece>,
}

/// None if the whole box is decided.
fn examined(
    equations: &mut dyn Underdetermined,
    mut at: Vec<Interval>,
    (pieces, least): (&mut Vec<Piece>, &[f64]),
    domain: &[Interval],
) -> Option<Open> {
    let [n, bounded] = equations.unknowns();
    let rows = equations.rows();
    loop {
        let before = at.clone();
        at.resize(n + bounded, Interval::EVERYTHING);
        if !equations.narrow(&mut at) {
            return None;
        }
        if !equations.bound(&mut at) {
            at.truncate(n);
            return Some(Open { left: at, blamed: None, end: None });
        }
        if equations.holds(&at) == Some(false) {
            return None;
        }
        if pieces.iter().any(|piece| at.iter().zip(&piece.alone).all(|(at, alone)| at.is_part_of(*alone))) {
            return None;
        }
        let mut values = vec![Interval::EVERYTHING; rows];
        equations.values(&at, &mut values);
        if values.iter().any(|value| !value.contains(0.0)) {
            return None;
        }
        let Some(local) = Local::of(equations, &at) else {
            at.truncate(n);
            return Some(Open { left: at, blamed: None, end: None });
        };
        at = local.narrowed(&at)?;
        let mut end = None;
        if let Some(piece) = shown(equations, &local, &at) {
            let meets = at.iter().zip(&piece.enclosure).all(|(at, own)| at.and(*own).is_some());
            let holds = if meets { equations.holds(&piece.enclosure) } else { Some(false) };
            match holds {
                Some(holds) => {
                    pieces.extend(holds.then_some(Piece { holds, ..piece }));
                    return None;
                }
                None => match inner(equations, &piece, domain) {
                    Some(inner) => {
                        pieces.push(Piece { inner: Some(inner), ..piece });
                        return None;
                    }
                    None => end = Some(piece),
                },
            }
        }
        let is_narrower = |((left, before), least): ((&Interval, &Interval), &f64)| {
            before.width() > *least && left.width() < WORTH * before.width()
        };
        if !at[..n].iter().zip(&before).zip(least).any(is_narrower) {
            let blamed = blamed(equations, &local.parameters, &at);
            at.truncate(n);
            return Some(Open { left: at, blamed, end });
        }
        at.truncate(n);
    }
}

/// The unknown whose range spreads the equations the most: with this unknown at its middle they are closest to linear.
fn blamed(equations: &mut dyn Underdetermined, parameters: &[usize], at: &[Interval]) -> Option<usize> {
    let [n, _] = equations.unknowns();
    let mut least: Option<(f64, usize)> = None;
    for k in (0..n).filter(|&k| at[k].width() > 0.0) {
        let mut narrow = at.to_vec();
        narrow[k] = Interval::point(at[k].middle());
        let Some(spread) = Local::with(equations, &narrow, parameters).map(|local| local.spread()) else { continue };
        if spread.is_finite() && least.is_none_or(|(known, _)| spread < known) {
            least = Some((spread, k));
        }
    }
    least.map(|(_, k)| k)
}

/// A piece over the parameters of a box, with all solutions in this.
fn shown(equations: &mut dyn Underdetermined, local: &Local, at: &[Interval]) -> Option<Piece> {
    let mut middle: Vec<f64> = at.iter().map(|part| part.middle()).collect();
    let mut last = None;
    for _ in 0..STEPS {
        let points: Vec<Interval> = middle.iter().map(|&at| Interval::point(at)).collect();
        let near = Local::with(equations, &points, &local.parameters)?;
        near.dependent.iter().zip(&near.step).for_each(|(&place, step)| middle[place] -= step.middle());
        if !middle.iter().all(|value| value.is_finite()) {
            return None;
        }
        last = Some(near);
    }
    let near = last?;
    // the change of the solutions along the parameters, which is at least rounding: by their derivatives in the middle, and where an unknown
    // turns there, by those in the whole box
    let way = |by: &Local, row: usize| -> f64 {
        let along = local.parameters.iter().map(|&k| by.entry(row, k).size() * 0.5 * at[k].width());
        along.sum::<f64>() + near.step[row].width()
    };
    let widths = WIDTHS.map(|width| (width, &near)).into_iter().chain(OVER_BOX.map(|width| (width, local)));
    widths.into_iter().find_map(|(width, by)| {
        let mut alone = at.to_vec();
        for (row, &place) in local.dependent.iter().enumerate() {
            let rounding = 1e-14 * (1.0 + middle[place].abs());
            let radius = width * (way(by, row) + 0.05 * at[place].width()) + rounding;
            alone[place] = Interval::new(middle[place] - radius, middle[place] + radius);
        }
        let over = Local::with(equations, &alone, &local.parameters)?;
        let inside = over.krawczyk(&alone);
        let covers = at.iter().zip(&alone).all(|(at, alone)| at.is_part_of(*alone));
        let is_within = |(&place, inside): (&usize, &Interval)| inside.is_inside(alone[place]);
        let is_inside = covers && local.dependent.iter().zip(&inside).all(is_within);
        is_inside.then(|| {
            let mut enclosure = alone.clone();
            local.dependent.iter().zip(&inside).for_each(|(&place, inside)| enclosure[place] = *inside);
            Piece { parameters: local.parameters.clone(), enclosure, alone, holds: false, inner: None }
        })
    })
}

/// The part of a piece whose parameters are narrower by rounding, if everything else holds all over it, or is at its end.
fn inner(equations: &mut dyn Underdetermined, piece: &Piece, domain: &[Interval]) -> Option<Vec<Interval>> {
    let mut at = piece.enclosure.clone();
    for &place in &piece.parameters {
        let aside = ASIDE * domain.get(place).map_or(0.0, |range| range.width());
        let own = at[place];
        if own.width() <= 4.0 * aside {
            return None;
        }
        at[place] = Interval::new(own.low() + aside, own.high() - aside);
    }
    narrow(equations, &piece.parameters, &mut at);
    fulfils(equations, &at, &piece.parameters).filter(|fulfils| *fulfils).map(|_| at)
}

/// An approximate solution of a piece at a part, from 0 to 1, of the range of each parameter.
pub(super) fn solution(equations: &mut dyn Underdetermined, piece: &Piece, part: f64) -> Vec<f64> {
    let mut at = piece.enclosure.clone();
    for &place in &piece.parameters {
        let own = at[place];
        at[place] = Interval::point((own.low() + part * own.width()).min(own.high()));
    }
    narrow(equations, &piece.parameters, &mut at);
    at.iter().map(|own| own.middle()).collect()
}

/// Whether the further conditions hold in a whole box or are at their ends there, or nowhere; none if this is not decided.
pub(super) fn fulfils(equations: &mut dyn Underdetermined, at: &[Interval], parameters: &[usize]) -> Option<bool> {
    equations.holds(at).or_else(|| equations.is_at_conditions(at, parameters).then_some(true))
}

/// Steps of Krawczyk's operator in a part of a piece.
const NARROWED: usize = 6;

/// Narrows the unknowns that depend on the parameters of a piece, one motion of which is in a box for every value of these.
pub(super) fn narrow(equations: &mut dyn Underdetermined, parameters: &[usize], at: &mut [Interval]) {
    for _ in 0..NARROWED {
        let Some(local) = Local::with(equations, at, parameters) else { return };
        let inside = local.krawczyk(at);
        let mut gains = false;
        for (&place, inside) in local.dependent.iter().zip(inside) {
            let Some(both) = at[place].and(inside) else { return };
            gains |= both.width() < 0.5 * at[place].width();
            at[place] = both;
        }
        if !gains {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A curve in the plane, by its equation and the derivatives of this.
    struct Curve {
        value: fn(Interval, Interval) -> Interval,
        slopes: fn(Interval, Interval) -> [Interval; 2],
    }

    impl Underdetermined for Curve {
        fn unknowns(&self) -> [usize; 2] {
            [2, 0]
        }

        fn rows(&self) -> usize {
            1
        }

        fn narrow(&mut self, _: &mut [Interval]) -> bool {
            true
        }

        fn bound(&mut self, _: &mut [Interval]) -> bool {
            true
        }

        fn values(&mut self, at: &[Interval], values: &mut [Interval]) {
            values[0] = (self.value)(at[0], at[1]);
        }

        fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]) {
            slopes.copy_from_slice(&(self.slopes)(at[0], at[1]));
        }
    }

    const TWO: fn() -> Interval = || Interval::point(2.0);

    #[test]
    fn a_curve_with_a_vertex_in_the_middle_of_a_flat_box_is_one_piece() {
        let mut vertex = Curve { value: |x, y| y - x * x / TWO(), slopes: |x, _| [-x, Interval::point(1.0)] };
        let domain = vec![Interval::new(-1.0, 1.0), Interval::new(0.0, 1.0)];
        let flat = vec![Interval::new(-1e-4, 1e-4), Interval::new(0.0, 5e-9)];
        let found = pieces(&mut vertex, &domain, vec![flat], Limits { boxes: 20, smallest: 1e-6 }, || true);
        assert!(found.undecided.is_empty() && found.pieces.len() == 1, "{found:?}");
    }

    #[test]
    fn a_circle_lies_in_pieces_and_nothing_is_undecided() {
        let mut circle =
            Curve { value: |x, y| x * x + y * y - Interval::point(1.0), slopes: |x, y| [x * TWO(), y * TWO()] };
        let domain = vec![Interval::new(-2.0, 1.7); 2];
        let limits = Limits { boxes: 5_000, smallest: 1e-6 };
        let found = pieces(&mut circle, &domain, vec![domain.clone()], limits, || true);
        assert!(found.undecided.is_empty(), "{found:?}");
        assert!(found.pieces.len() < 200);
        for degree in 0..360 {
            let point = [f64::from(degree).to_radians().cos(), f64::from(degree).to_radians().sin()];
            let holds = |piece: &Piece| piece.enclosure.iter().zip(point).all(|(own, at)| own.contains(at));
            assert!(found.pieces.iter().any(holds), "{degree}");
        }
    }
}
