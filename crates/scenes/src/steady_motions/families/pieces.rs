//! All solutions of fewer equations than unknowns, enclosed in pieces: boxes in which there is exactly one solution for every value of some
//! unknowns, the parameters of the piece.
//!
//! A piece is proved by Krawczyk's operator for the other unknowns x, with the parameters t in their ranges T about t0:
//!
//!   K(X) = m - C f(m, t0) - C f_t (T - t0) + (1 - C f_x(X, T)) (X - m) inside X .

use super::local::Local;
use algebra::boxes::halves;
use field::Interval;
use std::collections::VecDeque;

/// Equations with interval arguments, fewer than the unknowns.
pub(in crate::steady_motions) trait Underdetermined {
    /// The number of unknowns that are divided, which come first; and of unknowns that follow from these by bounds, such as reactions.
    fn unknowns(&self) -> [usize; 2];

    fn rows(&self) -> usize;

    /// Narrows a box; false if it contains no solution.
    fn narrow(&mut self, at: &mut [Interval]) -> bool;

    /// Computes bounds of the unknowns that are not divided; false if there are none.
    fn bound(&mut self, at: &mut [Interval]) -> bool;

    /// Whether the further conditions (inequalities) hold everywhere in a box, or nowhere; `None` if undecided.
    fn holds(&mut self, _at: &[Interval]) -> Option<bool> {
        Some(true)
    }

    /// Whether each condition that is undecided in a box is zero, up to rounding, at all solutions there (one for each value of the parameters).
    fn is_at_conditions(&mut self, _at: &[Interval], _parameters: &[usize]) -> bool {
        false
    }

    fn values(&mut self, at: &[Interval], values: &mut [Interval]);

    /// The derivatives of the values by all unknowns, row by row.
    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]);
}

/// A box with exactly one solution for every value of its parameters.
#[derive(Clone, Debug)]
pub(in crate::steady_motions) struct Piece {
    /// The indices of the parameters.
    pub parameters: Vec<usize>,
    /// A box that contains the solutions for all values of the parameters.
    pub enclosure: Vec<Interval>,
    /// A larger box without further solutions.
    alone: Vec<Interval>,
    /// Whether the further conditions are proved for all solutions of the piece.
    pub holds: bool,
    /// The enclosure with the intervals of its parameters made narrower by rounding; `None` unless every solution in it satisfies the further
    /// conditions or lies at a zero of one of them.
    pub inner: Option<Vec<Interval>>,
}

impl Piece {
    /// Whether only some of the solutions may satisfy the conditions.
    pub fn is_border(&self) -> bool {
        !self.holds && self.inner.is_none()
    }
}

/// The result of a search: every solution lies in a piece or in an undecided box.
#[derive(Debug, Default)]
pub(in crate::steady_motions) struct Pieces {
    pub pieces: Vec<Piece>,
    /// Boxes that may contain solutions, each with an interval for every unknown.
    pub undecided: Vec<Vec<Interval>>,
    /// The number of boxes that were examined.
    pub examined: usize,
}

/// Limits of a search: the number of boxes, and the smallest width.
#[derive(Clone, Copy)]
pub(in crate::steady_motions) struct Limits {
    pub boxes: usize,
    /// A box is not divided along an unknown if its width is below this fraction of the domain.
    pub smallest: f64,
}

/// Number of Newton's iterations towards the middle of a piece.
const STEPS: usize = 8;

/// Trial widths of a piece, relative to the change of the solutions by the derivatives at the middle.
const WIDTHS: [f64; 3] = [1.25, 2.0, 4.0];

/// Further trial widths, relative to the change by the largest derivatives in the box.
const OVER_BOX: [f64; 2] = [1.25, 2.0];

/// A box is narrowed again if this step reduced a width below this fraction.
const WORTH: f64 = 0.75;

/// Width, as a fraction of the domain, to which the end of a curve at a condition is located.
const END: f64 = 1e-9;

/// The corresponding widths for surfaces, whose borders need many boxes, and for families of higher dimension.
const BORDERS: [f64; 2] = [4e-3, 3e-2];

/// Fraction of the domain by which the inner part of a piece is narrower on each side, along each parameter.
const ASIDE: f64 = 1e-10;

/// Number of boxes between two checks of the deadline.
const BETWEEN: usize = 8;

/// Encloses all solutions in some boxes of a domain.
pub(in crate::steady_motions) fn pieces(
    equations: &mut dyn Underdetermined,
    domain: &[Interval],
    boxes: Vec<Vec<Interval>>,
    limits: Limits,
    mut goes_on: impl FnMut() -> bool,
) -> Pieces {
    // equations without values in a box could be narrowed indefinitely
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

/// A box that is still undecided.
struct Open {
    left: Vec<Interval>,
    /// The unknown to be divided, if one is mainly responsible for the nonlinearity.
    blamed: Option<usize>,
    /// The piece of its solutions, if only the further conditions are undecided.
    end: Option<Piece>,
}

/// Examines a box and adds its pieces; `None` if the box is decided.
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

/// The unknown whose range contributes most to the nonlinearity: with this unknown at its middle, 1 - C f_x is smallest.
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

/// A piece that is proved to contain all solutions in a box; `None` if the proof fails.
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
    // change of the solutions over the parameters, from derivatives in the middle, or at turning points from those in the whole box; at least
    // a rounding error
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

/// The piece with parameters narrower by rounding, if all its solutions satisfy the conditions or lie at the zero of one; otherwise `None`.
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

/// An approximate solution of a piece, with each parameter at the fraction `part` of its range.
pub(super) fn solution(equations: &mut dyn Underdetermined, piece: &Piece, part: f64) -> Vec<f64> {
    let mut at = piece.enclosure.clone();
    for &place in &piece.parameters {
        let own = at[place];
        at[place] = Interval::point((own.low() + part * own.width()).min(own.high()));
    }
    narrow(equations, &piece.parameters, &mut at);
    at.iter().map(|own| own.middle()).collect()
}

/// Whether the conditions are satisfied, or zero, at all solutions of a box, or satisfied nowhere; `None` if undecided.
pub(super) fn fulfils(equations: &mut dyn Underdetermined, at: &[Interval], parameters: &[usize]) -> Option<bool> {
    equations.holds(at).or_else(|| equations.is_at_conditions(at, parameters).then_some(true))
}

/// Number of iterations of Krawczyk's operator in [`narrow`].
const NARROWED: usize = 6;

/// Narrows the dependent unknowns in a box by Krawczyk's operator, if the box contains a solution for every value of the parameters.
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

    /// A curve in the plane, given by an equation and its two derivatives.
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
