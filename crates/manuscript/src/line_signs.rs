//! Exact signs of an expression in one unknown, a letter or an angle, wherever the conditions on the unknown hold, by real roots of polynomials.

use crate::refutation::Refutation;
use algebra::real::{Polynomial, Root};
use claims::Condition;
use field::Rational;
use symbolic::{Hypotheses, Node, Sym, normal, univariate};

/// The least sign of an expression where the conditions on its unknown hold, with points at which it has this sign.
pub(crate) struct Least {
    /// -1, 0 or 1.
    pub sign: i32,
    /// The points, those with few digits before roots of polynomials.
    pub points: Vec<Refutation>,
}

/// The unknown of an expression, and its substitution in polynomials.
enum Unknown {
    Letter(Sym),
    /// An angle, replaced by the tangent of its half, which has no value at the angle π.
    Angle {
        angle: Sym,
        tangent: Sym,
    },
}

/// The numerator and the denominator of a fraction.
type Fraction = [Polynomial; 2];

/// The least sign; `None` if there are more unknowns, or if no point satisfies the conditions.
pub(crate) fn least(expression: Sym, conditions: &[Condition]) -> Option<Least> {
    let found = signs(expression, conditions)?;
    let sign = found.iter().map(|(sign, _)| *sign).min()?;
    let points = found.into_iter().filter(|(each, _)| *each == sign).filter_map(|(_, point)| point);
    Some(Least { sign, points: points.collect() })
}

/// Whether no value of the only unknown satisfies the conditions.
pub(crate) fn exclude_each_other(conditions: &[Condition]) -> bool {
    let leaves_none = |of: &Condition| signs(of.expression(), conditions).is_some_and(|found| found.is_empty());
    conditions.iter().any(leaves_none)
}

/// The signs of an expression where the conditions on its unknown hold, each with a point (a number with few digits, or a root); `None` if there are
/// more unknowns.
fn signs(expression: Sym, conditions: &[Condition]) -> Option<Vec<(i32, Option<Refutation>)>> {
    let unknown = Unknown::of(expression)?;
    let own = unknown.fraction(expression)?;
    let stated: Vec<Condition> =
        conditions.iter().copied().filter(|condition| unknown.holds_all(condition.expression())).collect();
    let mut sides: Vec<(Condition, Fraction)> = Vec::new();
    for condition in stated {
        sides.push((condition, unknown.fraction(condition.expression())?));
    }
    let mut roots: Vec<(Root, Polynomial)> = Vec::new();
    for polynomial in sides.iter().flat_map(|(_, fraction)| fraction).chain(&own) {
        let free = polynomial.square_free();
        roots.extend(free.real_roots().into_iter().map(|root| (root, free.clone())));
    }
    roots.sort_by(|(a, _), (b, _)| a.compare(b));
    roots.dedup_by(|(a, _), (b, _)| a.compare(b).is_eq());
    let between = samples(&roots)?;
    let mut found: Vec<(i32, Option<Sym>)> = Vec::new();
    for (root, value) in between.iter().map(|(root, value)| (root, Some(Sym::constant(*value)))) {
        found.extend(sign_at(root, &own, &sides).map(|sign| (sign, value)));
    }
    for (root, polynomial) in &roots {
        found.extend(sign_at(root, &own, &sides).map(|sign| (sign, exact(root, polynomial))));
    }
    let mut found: Vec<(i32, Option<Refutation>)> =
        found.into_iter().map(|(sign, value)| (sign, value.and_then(|value| unknown.point(value)))).collect();
    if let Unknown::Angle { angle, .. } = unknown {
        found.extend(at_half_turn(expression, angle, &sides));
    }
    Some(found)
}

impl Unknown {
    fn of(expression: Sym) -> Option<Self> {
        let leaves = expression.leaves_of();
        let letters: Vec<Sym> = leaves.into_iter().filter(|leaf| leaf.as_constant().is_none()).collect();
        let angle_of = |leaf: Sym| match leaf.node() {
            Node::Cos(angle) | Node::Sin(angle) => Some(angle).filter(|angle| angle.symbol_name().is_some()),
            _ => None,
        };
        let first = *letters.first()?;
        match angle_of(first) {
            Some(angle) => letters
                .iter()
                .all(|leaf| angle_of(*leaf) == Some(angle))
                .then(|| Unknown::Angle { angle, tangent: Sym::symbol(&format!("tangent of half of {angle}")) }),
            None => (letters.len() == 1 && first.symbol_name().is_some()).then_some(Unknown::Letter(first)),
        }
    }

    /// Whether an expression contains no other unknown.
    fn holds_all(&self, expression: Sym) -> bool {
        let is_own = |leaf: &Sym| match *self {
            Unknown::Letter(letter) => *leaf == letter,
            Unknown::Angle { angle, .. } => {
                matches!(leaf.node(), Node::Cos(of) | Node::Sin(of) if of == angle)
            }
        };
        expression.leaves_of().iter().filter(|leaf| leaf.as_constant().is_none()).all(is_own)
    }

    fn fraction(&self, expression: Sym) -> Option<Fraction> {
        let (letter, over) = match *self {
            Unknown::Letter(letter) => (letter, expression),
            Unknown::Angle { angle, tangent } => {
                let (one, square) = (Sym::ONE, tangent * tangent);
                let circle = angle.circle_as_written();
                let known =
                    [(circle.cos, (one - square) / (one + square)), (circle.sin, (tangent + tangent) / (one + square))];
                (tangent, expression.substitute(&known))
            }
        };
        let form = normal(over, &Hypotheses::none()).ok()?;
        let of = |part: Sym| Polynomial::from_rationals(&univariate(part, letter).ok()?);
        Some([of(form.numerator())?, of(form.denominator())?])
    }

    /// The point at which the unknown, or the tangent of half the angle, has this value.
    fn point(&self, value: Sym) -> Option<Refutation> {
        let form = |part: Sym| normal(part, &Hypotheses::none()).ok().map(|form| form.to_sym());
        let point = match *self {
            Unknown::Letter(letter) => vec![(letter, value)],
            Unknown::Angle { angle, .. } => {
                let (circle, below) = (angle.circle_as_written(), Sym::ONE + value * value);
                let cos = form((Sym::ONE - value * value) / below)?;
                vec![(circle.cos, cos), (circle.sin, form((value + value) / below)?)]
            }
        };
        Some(Refutation { point, is_formal: false })
    }
}

/// The sign at the angle π; `None` unless the conditions hold there.
fn at_half_turn(expression: Sym, angle: Sym, sides: &[(Condition, Fraction)]) -> Option<(i32, Option<Refutation>)> {
    let circle = angle.circle_as_written();
    let point = vec![(circle.cos, Sym::ZERO - Sym::ONE), (circle.sin, Sym::ZERO)];
    let there = Refutation { point, is_formal: false };
    let sign = |expression: Sym| there.value(expression)?.as_constant()?.sign();
    let holds = |(condition, _): &(Condition, Fraction)| {
        sign(condition.expression()).is_some_and(|sign| condition.allows(sign))
    };
    let own = sign(expression).filter(|_| sides.iter().all(holds))?;
    Some((own, Some(there)))
}

/// The sign of a fraction at a root; `None` unless all conditions hold and the fraction has a value there.
fn sign_at(root: &Root, own: &Fraction, sides: &[(Condition, Fraction)]) -> Option<i32> {
    let sign = |[above, below]: &Fraction| {
        Some(root.sign_of(below)).filter(|below| *below != 0).map(|below| below * root.sign_of(above))
    };
    let holds =
        |(condition, fraction): &(Condition, Fraction)| sign(fraction).is_some_and(|sign| condition.allows(sign));
    sides.iter().all(holds).then(|| sign(own)).flatten()
}

/// A number in each interval between adjacent roots, and one before and one after all roots.
fn samples(roots: &[(Root, Polynomial)]) -> Option<Vec<(Root, Rational)>> {
    let ends: Vec<[f64; 2]> = roots.iter().map(|(root, _)| root.enclosure(64).ends()).collect();
    let gaps: Vec<Option<Rational>> = match (ends.first(), ends.last()) {
        (Some(first), Some(last)) => {
            let inner = ends.windows(2).map(|pair| number_between(pair[0][1], pair[1][0]));
            let (before, behind) = (number_between(first[0] - 2.0, first[0]), number_between(last[1], last[1] + 2.0));
            std::iter::once(before).chain(inner).chain([behind]).collect()
        }
        _ => vec![Some(Rational::new(1, 1))],
    };
    gaps.into_iter().map(|value| Some((Root::rational(value?)?, value?))).collect()
}

/// An integer as an expression.
pub(crate) fn number(value: i64) -> Sym {
    Sym::constant(Rational::new(value, 1))
}

/// A number with few binary digits in an open interval.
pub(crate) fn number_between(low: f64, high: f64) -> Option<Rational> {
    (0..60).find_map(|bits| {
        let scale = 2_f64.powi(bits);
        let above = (low * scale).floor() + 1.0;
        let is_inside = above < high * scale && above.abs() < 9e15;
        is_inside.then(|| Rational::new(above as i64, 1_i64 << bits))
    })
}

/// A root as an exact expression: a rational number, or one with a square root; `None` for other roots.
fn exact(root: &Root, polynomial: &Polynomial) -> Option<Sym> {
    let fraction = root.enclosure(256).simplest();
    if Root::rational(fraction).is_some_and(|same| same.compare(root).is_eq()) {
        return Some(Sym::constant(fraction));
    }
    let numbers =
        polynomial.integers()?.into_iter().map(|n| Some(Sym::constant(Rational::new(i64::try_from(n).ok()?, 1))));
    let [c, b, a] = numbers.collect::<Option<Vec<Sym>>>()?[..] else { return None };
    let four = number(4);
    let discriminant = normal(b * b - four * a * c, &Hypotheses::none()).ok()?.to_sym();
    let spread = field::Analytic::sqrt(discriminant);
    let value = root.enclosure(64).to_f64();
    [spread - b, Sym::ZERO - spread - b].into_iter().map(|above| above / (a + a)).find(|candidate| {
        let near = candidate.evaluate_analytic(&|_: &str| None::<f64>).ok();
        near.is_some_and(|near| (near - value).abs() <= 1e-9 * (1.0 + value.abs()))
    })
}
