//! Signs of sines and cosines from bounds of their angles: sin(θ/2) is positive where 0 < θ < π.

use crate::condition_products::show;
use crate::half_turn::{bounds, half_turn, is_half_turn};
use claims::Condition;
use field::Scalar;
use symbolic::{Node, Sym};

/// The lower ends, in multiples of π, of the intervals of length π to which an angle is compared.
const HALF_TURNS: [i64; 5] = [0, -1, 1, -2, 2];

/// The signs of sines and cosines in some expressions that follow from conditions on the letters of their angles.
pub(crate) fn circle_signs(expressions: &[Sym], conditions: &[Condition]) -> Vec<Condition> {
    let is_letter = |leaf: &Sym| leaf.symbol_name().is_some() || leaf.as_constant().is_some();
    let on_letters =
        conditions.iter().copied().filter(|condition| condition.expression().leaves_of().iter().all(is_letter));
    let on_letters: Vec<Condition> = on_letters.collect();
    let sign = |leaf: Sym| match leaf.node() {
        Node::Sin(angle) => sign_of_sine(leaf, angle, angle, &on_letters),
        Node::Cos(angle) => sign_of_sine(leaf, angle, angle + half_turn() / (Sym::ONE + Sym::ONE), &on_letters),
        _ => None,
    };
    Sym::ascending(expressions).into_iter().filter_map(sign).collect()
}

/// The sign of `leaf`, which is the sine of `shifted` and a sine or cosine of `angle`; `None` where the conditions do not determine it.
fn sign_of_sine(leaf: Sym, angle: Sym, shifted: Sym, on_letters: &[Condition]) -> Option<Condition> {
    let letters = angle.symbols_of();
    let letters: Vec<Sym> = letters.into_iter().filter(|letter| !is_half_turn(*letter)).collect();
    let is_own = |symbol: Sym| is_half_turn(symbol) || letters.contains(&symbol);
    let own = on_letters.iter().filter(|condition| condition.expression().symbols_of().into_iter().all(is_own));
    let own: Vec<Condition> = own.copied().collect();
    let is_bounded = |letter: &Sym| own.iter().any(|condition| condition.expression().symbols_of().contains(letter));
    if letters.is_empty() || !letters.iter().all(is_bounded) {
        return None;
    }
    let known = [&own[..], &bounds()].concat();
    let at_least_zero = |of: Sym| [true, false].into_iter().find(|is_strict| show(of, *is_strict, &known));
    HALF_TURNS.into_iter().find_map(|from| {
        let turned = |count: i64| Sym::int(count) * half_turn();
        let (below, above) = (at_least_zero(shifted - turned(from))?, at_least_zero(turned(from + 1) - shifted)?);
        let value = if from % 2 == 0 { leaf } else { Sym::ZERO - leaf };
        Some(if below && above { Condition::Positive(value) } else { Condition::NotNegative(value) })
    })
}
