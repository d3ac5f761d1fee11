//! Exact points at which angles are fractions of π, for expressions that contain an angle as well as its sine, or sums and fractions of angles.

use crate::half_turn::{half_turn, is_half_turn};
use crate::refutation::{Refutation, sign};
use claims::Condition;
use field::Rational;
use symbolic::{Hypotheses, Node, Sym, normal};

/// Trial angles in multiples of π/12, those with simple sines first.
const TWELFTHS: [i64; 16] = [6, 12, -6, 4, 2, 3, 8, 9, 0, -4, -2, -3, 24, 18, 16, -12];

/// Trial values of other letters.
const NUMBERS: [(i64, i64); 10] = [(1, 1), (2, 1), (1, 2), (3, 1), (-1, 1), (-2, 1), (4, 1), (3, 2), (0, 1), (-1, 2)];

/// The first of `points` trial points at which the conditions hold and `asked` accepts the signs of the expressions. Without expressions,
/// every second trial point gives angles rational values, whose sines are enclosed.
pub(crate) fn find(
    expressions: &[Sym],
    conditions: &[Condition],
    points: u32,
    asked: impl Fn(&[i8]) -> bool,
) -> Option<Refutation> {
    let all: Vec<Sym> = expressions.iter().copied().chain(conditions.iter().map(|one| one.expression())).collect();
    let parts = Sym::ascending(&all);
    let angles = parts.iter().filter_map(|part| match part.node() {
        Node::Cos(angle) | Node::Sin(angle) => Some(angle.symbols_of()),
        _ => None,
    });
    let angles: Vec<Sym> = angles.flatten().filter(|letter| !is_half_turn(*letter)).collect();
    if angles.is_empty() || parts.iter().any(|part| matches!(part.node(), Node::Function(..))) {
        return None;
    }
    let mut letters: Vec<Sym> =
        all.iter().flat_map(|of| of.symbols_of()).filter(|letter| !is_half_turn(*letter)).collect();
    letters.sort_unstable();
    letters.dedup();
    let mut state = 1_u32;
    let mut next = |count: usize| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as usize % count
    };
    (0..points).find_map(|attempt| {
        // the range of trial values grows from point to point
        let among = |all: usize| (1 + attempt as usize / 2).min(all);
        let mut value = |letter: Sym| match angles.contains(&letter) && (attempt % 2 == 0 || !expressions.is_empty()) {
            true => half_turn() * Sym::constant(Rational::new(TWELFTHS[next(among(TWELFTHS.len()))], 12)),
            false => {
                let (above, below) = NUMBERS[next(among(NUMBERS.len()))];
                Sym::constant(Rational::new(above, below))
            }
        };
        let point = letters.iter().map(|&letter| (letter, value(letter))).collect();
        let found = Refutation { point, is_formal: false };
        let sign_there = |of: Sym| found.value(of).and_then(sign);
        let holds = |one: &Condition| sign_there(one.expression()).is_some_and(|sign| one.allows(sign));
        let signs = || expressions.iter().map(|of| sign_there(*of).map(|sign| sign as i8)).collect::<Option<Vec<i8>>>();
        let is_it = conditions.iter().all(holds) && signs().is_some_and(|signs| asked(&signs));
        is_it.then(|| with_circles(found, &parts))
    })
}

/// The point extended by the sines and cosines in the parts of expressions; those of multiples of an angle follow from the angle itself.
fn with_circles(mut found: Refutation, parts: &[Sym]) -> Refutation {
    let angle_of = |part: Sym| match part.node() {
        Node::Cos(angle) | Node::Sin(angle) => Some(angle),
        _ => None,
    };
    let angles: Vec<Sym> = parts.iter().filter_map(|part| angle_of(*part)).collect();
    let is_multiple = |angle: Sym, of: Sym| {
        let ratio = normal(angle / of, &Hypotheses::none()).ok().and_then(|ratio| ratio.to_sym().as_constant());
        ratio.is_some_and(|ratio| ratio.to_f64().abs() > 1.0)
    };
    let is_own = |angle: Sym| !angles.iter().any(|of| is_multiple(angle, *of));
    let circles = parts.iter().filter(|part| angle_of(**part).is_some_and(is_own));
    let values: Vec<(Sym, Sym)> = circles.filter_map(|&leaf| Some((leaf, found.value(leaf)?))).collect();
    found.point.extend(values);
    found
}
