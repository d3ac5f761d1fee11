//! Exact points at which conditions hold and expressions have required signs.

use crate::constraint_circles::Circles;
use crate::drawn_numbers::Draw;
use crate::half_turn::{holds_half_turn, is_half_turn};
use crate::motion::Motion;
use crate::refutation::{self, LONG, Refutation, exact};
use crate::turned_points;
use claims::Condition;
use std::cell::Cell;
use symbolic::{Hypotheses, Node, Sym, normal};

/// The number of trial points for expressions without square roots; [`POINTS_OF_ROOTS`] applies to expressions with roots, which are slower.
const POINTS: u32 = 4_000;
const POINTS_OF_ROOTS: u32 = 600;

/// The number of points at which a long expression, whose numbers may outgrow the exact fractions of fixed size, is tried with longer ones.
const POINTS_OF_LONG: u32 = 100;

/// The effort of a search: all trial points, or a part of them if a less suitable point is known already.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effort {
    Whole,
    Part,
}

impl Effort {
    fn of(self, points: u32) -> u32 {
        if self == Effort::Whole { points } else { points / 10 }
    }
}

/// An exact point at which the conditions hold and `asked` accepts the signs of the expressions.
pub(crate) fn search(
    expressions: &[Sym],
    conditions: &[Condition],
    motion: &Motion<'_, '_>,
    effort: Effort,
    asked: impl Fn(&[i8]) -> bool,
) -> Option<Refutation> {
    let is_open = |expression: &Sym| motion.undetermined(*expression).is_some();
    // rules other than those for squares of coordinates belong to free frames
    let has_rules = motion.hypotheses.statements().len() != motion.squares.len();
    if !motion.open.is_empty() || expressions.iter().any(is_open) || has_rules {
        return None;
    }
    let circles = Circles::of(motion);
    let has_root = |e: &Sym| e.leaves_of().iter().any(|leaf| matches!(leaf.node(), Node::Root(_)));
    let is_slow = |e: &Sym| has_root(e) || holds_half_turn(*e);
    let has_slow =
        expressions.iter().any(is_slow) || conditions.iter().any(|condition| is_slow(&condition.expression()));
    let points = if has_slow { POINTS_OF_ROOTS } else { POINTS };
    let all = expressions.iter().copied().chain(conditions.iter().map(|condition| condition.expression()));
    let Some(mut draw) = Draw::of(all.chain(circles.zeros()), conditions) else {
        return match circles.is_empty() {
            true => turned_points::find(expressions, conditions, effort.of(POINTS_OF_ROOTS), asked),
            false => None,
        };
    };
    draw.leaves.retain(|leaf| !circles.gives(*leaf));
    let is_long = expressions.iter().any(|each| Sym::operations_of(&[*each]) > LONG);
    let long = Cell::new(if is_long { POINTS_OF_LONG } else { 0 });
    draw.find(
        effort.of(points),
        |point| circles.completed(point),
        |point| {
            let values = exact(point);
            let rational = |each: Sym| values.value(each).filter(|value| value.is_defined())?.sign();
            let there = |each: Sym| Refutation { point: point.to_vec(), is_formal: false }.value(each);
            let by_long = |each: Sym| match long.replace(long.get().saturating_sub(1)) {
                0 => None,
                _ => there(each).and_then(refutation::sign),
            };
            let by_half_turn =
                |each: Sym| if holds_half_turn(each) { there(each).and_then(refutation::sign) } else { None };
            let by_roots = |each: Sym| if has_root(&each) { there(each).and_then(refutation::sign) } else { None };
            let holds = || {
                let holds = |condition: &Condition| {
                    let of = condition.expression();
                    let sign = rational(of).or_else(|| by_roots(of)).or_else(|| by_half_turn(of));
                    sign.is_some_and(|sign| condition.allows(sign))
                };
                conditions.iter().all(holds)
            };
            let signs = || -> Option<Vec<i8>> {
                let sign = |each: &Sym| {
                    let exactly = rational(*each).or_else(|| by_long(*each));
                    let found = exactly.or_else(|| by_roots(*each)).or_else(|| by_half_turn(*each));
                    found.map(|sign| sign as i8)
                };
                expressions.iter().map(sign).collect()
            };
            holds() && signs().is_some_and(|signs| asked(&signs))
        },
    )
}

/// The point extended by values for letters that occur only in conditions, such that all conditions hold; `None` if there are no such values.
pub(crate) fn completed(found: Refutation, conditions: &[Condition]) -> Option<Refutation> {
    if !may_be_real(&found.point, conditions)
        || conditions.iter().any(|condition| found.satisfies(*condition) == Some(false))
    {
        return None;
    }
    with_whole_circles(&found.point, conditions).into_iter().find_map(|point| {
        let found = Refutation { point, is_formal: found.is_formal };
        let is_excluded = conditions.iter().any(|condition| found.satisfies(*condition) == Some(false));
        if is_excluded { None } else { with_open_letters(found, conditions) }
    })
}

/// The points that extend a point by the missing sine or cosine of an angle that conditions contain, with either sign of the root; empty if a value of
/// the point is not between -1 and 1.
fn with_whole_circles(point: &[(Sym, Sym)], conditions: &[Condition]) -> Vec<Vec<(Sym, Sym)>> {
    let is_asked = |leaf: &Sym| conditions.iter().any(|condition| condition.expression().leaves_of().contains(leaf));
    let mut all = vec![point.to_vec()];
    for &(leaf, value) in point {
        let other = match leaf.node() {
            Node::Cos(angle) => Sym::from_node(Node::Sin(angle)),
            Node::Sin(angle) => Sym::from_node(Node::Cos(angle)),
            _ => continue,
        };
        if !is_asked(&other) || point.iter().any(|(known, _)| *known == other) {
            continue;
        }
        let root = field::Analytic::sqrt(Sym::ONE - value * value);
        let Ok(root) = normal(root, &Hypotheses::none()).map(|form| form.to_sym()) else { return Vec::new() };
        let signs = [root, Sym::ZERO - root];
        let with = |point: &Vec<(Sym, Sym)>, root: Sym| [&point[..], &[(other, root)]].concat();
        all = signs.iter().flat_map(|&root| all.iter().map(move |point| with(point, root))).collect();
    }
    all
}

/// The point extended by values for the letters that it leaves open and conditions contain.
fn with_open_letters(found: Refutation, conditions: &[Condition]) -> Option<Refutation> {
    let open: Vec<Condition> =
        conditions.iter().copied().filter(|condition| found.satisfies(*condition) != Some(true)).collect();
    if open.is_empty() {
        return Some(found);
    }
    let left: Vec<Condition> =
        open.iter().map(|condition| condition.mapped(|of| of.substitute(&found.point))).collect();
    let whole = |point: &[(Sym, Sym)]| [&found.point[..], point].concat();
    let Some(draw) = Draw::of(left.iter().map(|condition| condition.expression()), conditions) else {
        let more = turned_points::find(&[], &left, POINTS_OF_ROOTS, |_| true)?;
        return Some(Refutation { point: whole(&more.point), is_formal: found.is_formal });
    };
    let more = draw.find(POINTS, Some, |point| {
        let there = Refutation { point: whole(point), is_formal: false };
        open.iter().all(|condition| there.satisfies(*condition) == Some(true))
    })?;
    Some(Refutation { point: whole(&more.point), is_formal: found.is_formal })
}

/// Whether a point can be one of real numbers where the conditions hold. To refute an equation, an angle, its sine and its cosine may have
/// independent values, since an expression that does not vanish there does not vanish for all angles. A condition that contains the angle makes
/// the values dependent.
fn may_be_real(point: &[(Sym, Sym)], conditions: &[Condition]) -> bool {
    let asked = |letter: Sym| conditions.iter().any(|condition| condition.expression().leaves_of().contains(&letter));
    point.iter().all(|(letter, _)| match letter.node() {
        Node::Cos(angle) | Node::Sin(angle) => {
            // the values are dependent if conditions contain all letters of the angle, as for theta/2 or s/R
            let letters = angle.symbols_of();
            !letters.into_iter().filter(|letter| !is_half_turn(*letter)).all(asked)
        }
        _ => true,
    })
}
