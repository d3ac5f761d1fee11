//! Exact points at which a claim fails.

use crate::half_turn::{enclosed, holds_half_turn, is_half_turn, is_number_of_half_turn, with_exact_turns};
use crate::motion::{Motion, solution};
use claims::{Condition, Point};
use field::Analytic;
use symbolic::{Hypotheses, Node, Sym, decide, normal};

/// The number of operations, common parts counted once, beyond which a normal form may be very long.
pub(crate) const LONG: usize = 200;

/// An exact point at which an expression is not zero or has a wrong sign.
pub(crate) struct Refutation {
    /// Symbols of the model, and cosines and sines of its angles, with their values.
    pub point: Vec<(Sym, Sym)>,
    /// Whether sines and cosines are treated as independent of their angles.
    pub is_formal: bool,
}

impl Refutation {
    /// The value of an expression at the point; it may contain π. `None` if the point does not determine it.
    pub fn value(&self, expression: Sym) -> Option<Sym> {
        let at = |expression: Sym| {
            let there = with_exact_turns(self.with_parts_of_angles(expression).substitute(&self.point));
            // the normal form of a long expression is computed where it is one of numbers
            if is_long(expression) && !there.symbols_of().into_iter().all(is_half_turn) {
                return None;
            }
            let form = normal(there, &Hypotheses::none()).ok()?.to_sym();
            form.symbols_of().into_iter().all(is_half_turn).then_some(form)
        };
        // multiples of angles are expressed by the angles of the point
        let expanded = || at(normal(expression, &Hypotheses::none()).ok()?.to_sym());
        at(expression).or_else(|| if is_long(expression) { None } else { expanded() })
    }

    /// An expression with an angle expressed by the part of it whose sine and cosine the point contains: sin(a) by sin(a/2) and cos(a/2).
    fn with_parts_of_angles(&self, expression: Sym) -> Sym {
        let parts: Vec<PartOfAngle> = self.point.iter().filter_map(|(leaf, _)| PartOfAngle::of(*leaf)).collect();
        if parts.is_empty() {
            return expression;
        }
        let of_letters: Vec<(Sym, Sym)> = parts.iter().map(|part| (part.letter, part.unit / part.factor)).collect();
        let of_units = parts.iter().flat_map(|part| {
            let (new, own) = (part.unit.circle_as_written(), part.angle.circle_as_written());
            [(new.cos, own.cos), (new.sin, own.sin)]
        });
        let of_units: Vec<(Sym, Sym)> = of_units.collect();
        let known = expression.leaves_of().into_iter().filter_map(|leaf| {
            let angle = angle_of(leaf)?;
            let by_units = angle.substitute(&of_letters);
            let point = (by_units != angle).then(|| by_units.circle())?;
            let value = if matches!(leaf.node(), Node::Cos(_)) { point.cos } else { point.sin };
            Some((leaf, value.substitute(&of_units)))
        });
        expression.substitute(&known.collect::<Vec<_>>())
    }

    /// Whether an expression does not vanish at the point, and all constraints and hypotheses of the motion hold there.
    pub fn is_confirmed(&self, expression: Sym, motion: &Motion<'_, '_>) -> bool {
        let is_possible = !self.point.iter().any(|(leaf, _)| is_number_of_half_turn(*leaf));
        is_possible && self.value(motion.reduced(expression)).is_some_and(is_apart) && self.is_on(motion)
    }

    /// Whether constraints and hypotheses, in their original form, hold at the point for some values of the symbols that it leaves open.
    pub fn is_on(&self, motion: &Motion<'_, '_>) -> bool {
        let mut point = self.point.clone();
        for symbol in motion.replaced() {
            let value = self.value(motion.reduced(symbol)).filter(|value| enclosed(*value).is_some());
            if let (Some(value), true) = (value, point.iter().all(|(known, _)| *known != symbol)) {
                point.push((symbol, value));
            }
        }
        motion.held.iter().all(|&zero| {
            let Ok(left) = normal(zero.substitute(&point), &Hypotheses::none()).map(|form| form.numerator()) else {
                return false;
            };
            if left == Sym::ZERO || decide(motion.reduced(zero), &motion.hypotheses).is_zero() {
                return true;
            }
            // a symbol that the point leaves open takes the value that the equation requires
            match solution(motion.trace, left, None).filter(|found| found.divisor.as_constant().is_some()) {
                Some(found) => {
                    let taken = [(found.symbol, found.value)];
                    point.iter_mut().for_each(|(_, value)| *value = value.substitute(&taken));
                    point.push(taken[0]);
                    true
                }
                None => false,
            }
        })
    }

    /// Whether a condition holds at the point; `None` if the point does not decide it.
    pub fn satisfies(&self, condition: Condition) -> Option<bool> {
        let of = condition.expression();
        let has_root = || of.leaves_of().iter().any(|leaf| matches!(leaf.node(), Node::Root(_)));
        // the root of a rational square is rational; any other root is enclosed
        let by_roots = || {
            let value = if has_root() { self.value(of)? } else { return None };
            sign(value).map(|sign| condition.allows(sign))
        };
        let has_half_turn = || holds_half_turn(of) || self.point.iter().any(|(_, value)| holds_half_turn(*value));
        let by_half_turn = || if has_half_turn() { sign(self.value(of)?) } else { None };
        let by_enclosure = || by_half_turn().map(|sign| condition.allows(sign));
        condition.holds_at(&exact(&self.point)).or_else(by_roots).or_else(by_enclosure)
    }
}

fn is_long(expression: Sym) -> bool {
    Sym::operations_of(&[expression]) > LONG
}

/// An angle that is a rational multiple of a letter, such as a/2.
struct PartOfAngle {
    letter: Sym,
    angle: Sym,
    factor: Sym,
    /// A letter that replaces the angle.
    unit: Sym,
}

impl PartOfAngle {
    /// The angle of a cosine or sine, if it is such a multiple.
    fn of(leaf: Sym) -> Option<Self> {
        let angle = angle_of(leaf)?;
        let [letter] = angle.symbols_of()[..] else { return None };
        let factor = angle.diff(letter);
        let is_fraction = letter != angle && !is_half_turn(letter) && factor.as_constant().is_some();
        let is_whole = decide(angle - factor * letter, &Hypotheses::none()).is_zero();
        (is_fraction && is_whole).then(|| PartOfAngle {
            letter,
            angle,
            factor,
            unit: Sym::symbol(&format!("part of {letter}")),
        })
    }
}

/// The angle of a cosine or a sine.
fn angle_of(leaf: Sym) -> Option<Sym> {
    match leaf.node() {
        Node::Cos(angle) | Node::Sin(angle) => Some(angle),
        _ => None,
    }
}

/// The sign of a number: exact for a rational number, otherwise by an enclosure; `None` if the enclosure contains zero.
pub(crate) fn sign(value: Sym) -> Option<i32> {
    let exactly = value.as_constant().map(|value| value.sign());
    exactly.unwrap_or_else(|| enclosed(value)?.sign().filter(|sign| *sign != 0))
}

/// Whether a number is not zero: by its enclosure, or because its normal form contains only one square root, or π, with rational coefficients.
fn is_apart(value: Sym) -> bool {
    let has_one_root = || match value.leaves_of()[..] {
        [leaf] => is_half_turn(leaf) || matches!(leaf.node(), Node::Root(below) if below.as_constant().is_some()),
        _ => false,
    };
    enclosed(value).is_some_and(|enclosed| match enclosed.sign() {
        Some(sign) => sign != 0,
        None => value != Sym::ZERO && has_one_root(),
    })
}

/// The rational values of a point, under the names that expressions use.
pub(crate) fn exact(point: &[(Sym, Sym)]) -> Point {
    let name = |symbol: Sym| match symbol.node() {
        Node::Cos(angle) if angle.symbol_name().is_some() => format!("cos {angle}"),
        Node::Sin(angle) if angle.symbol_name().is_some() => format!("sin {angle}"),
        _ => symbol.to_string(),
    };
    Point::named(point.iter().filter_map(|(symbol, value)| Some((name(*symbol), value.as_constant()?))))
}
