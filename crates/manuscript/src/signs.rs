//! Signs of expressions, and exact points with required signs.

use crate::half_turn::{holds_half_turn, is_half_turn};
use crate::motion::Motion;
use crate::refutation::{self, Refutation, exact};
use claims::{Condition, Page, Verdict};
use field::{Elementary, Rational};
use std::collections::HashMap;
use symbolic::{Hypotheses, Node, Sym, normal, univariate};

/// The sign that an expression is shown to have.
pub(crate) struct Shown {
    /// Whether zero is excluded.
    pub is_strict: bool,
    /// Whether all terms of its normal form have this sign.
    pub is_of_normal_form: bool,
    pub evidence: String,
}

/// Whether an expression is positive, or nonnegative, where the conditions hold: by its normal form, or as written.
pub(crate) fn shows(expression: Sym, motion: &Motion<'_, '_>, conditions: &[Condition]) -> Option<Shown> {
    let mut page = Page::of("paper", |_| None);
    let draft = page.claim("", "", "").given(conditions.iter().copied()).under(&motion.hypotheses);
    draft.by_signs([Condition::Positive(expression)]);
    if let Some(judged) = page.judge().into_iter().find(|judged| judged.verdict == Verdict::Proved) {
        return Some(Shown { is_strict: true, is_of_normal_form: true, evidence: judged.evidence });
    }
    // a normal form may mix signs that are separate in the printed form
    let evidence =
        "every term as written has this sign: squares, exponentials, and letters that are positive".to_owned();
    let is_strict = is_written_as_positive(expression, conditions)?;
    Some(Shown { is_strict, is_of_normal_form: false, evidence })
}

/// Whether the terms of an expression as written show that it is nonnegative: none if not, otherwise whether zero is excluded.
pub(crate) fn is_written_as_positive(expression: Sym, conditions: &[Condition]) -> Option<bool> {
    let known = &mut HashMap::new();
    sign(expression, conditions, known).and_then(|sign| match sign {
        Sign::Positive => Some(true),
        Sign::NotNegative => Some(false),
        Sign::NotPositive | Sign::Negative => None,
    })
}

/// Knowledge of the sign of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Positive,
    NotNegative,
    NotPositive,
    Negative,
}

impl Sign {
    fn opposite(self) -> Self {
        match self {
            Sign::Positive => Sign::Negative,
            Sign::NotNegative => Sign::NotPositive,
            Sign::NotPositive => Sign::NotNegative,
            Sign::Negative => Sign::Positive,
        }
    }

    /// Whether it is at least zero, and whether it excludes zero.
    fn parts(self) -> (bool, bool) {
        match self {
            Sign::Positive => (true, true),
            Sign::NotNegative => (true, false),
            Sign::NotPositive => (false, false),
            Sign::Negative => (false, true),
        }
    }

    fn of_parts((is_up, is_strict): (bool, bool)) -> Self {
        match (is_up, is_strict) {
            (true, true) => Sign::Positive,
            (true, false) => Sign::NotNegative,
            (false, false) => Sign::NotPositive,
            (false, true) => Sign::Negative,
        }
    }

    fn product(self, other: Self) -> Self {
        let ((up, strict), (other_up, other_strict)) = (self.parts(), other.parts());
        Sign::of_parts((up == other_up, strict && other_strict))
    }
}

/// The signs of parts that were looked at, since parts that stand in several places are looked at once.
type KnownSigns = HashMap<Sym, Option<Sign>>;

/// The sign of an expression as written, by the signs of its letters.
fn sign(expression: Sym, conditions: &[Condition], known: &mut KnownSigns) -> Option<Sign> {
    if let Some(found) = known.get(&expression) {
        return *found;
    }
    let found = sign_as_written(expression, conditions, known);
    known.insert(expression, found);
    found
}

fn sign_as_written(expression: Sym, conditions: &[Condition], known: &mut KnownSigns) -> Option<Sign> {
    let mut of = |part: Sym| sign(part, conditions, known);
    if conditions.contains(&Condition::Positive(expression)) {
        return Some(Sign::Positive);
    }
    if conditions.contains(&Condition::Positive(-expression))
        || conditions.contains(&Condition::Positive(Sym::ZERO - expression))
    {
        return Some(Sign::Negative);
    }
    if conditions.contains(&Condition::NotNegative(expression)) {
        return Some(Sign::NotNegative);
    }
    if conditions.contains(&Condition::NotNegative(-expression))
        || conditions.contains(&Condition::NotNegative(Sym::ZERO - expression))
    {
        return Some(Sign::NotPositive);
    }
    let is_stated = |part: Sym| {
        [part, -part, Sym::ZERO - part].into_iter().any(|part| conditions.contains(&Condition::NonZero(part)))
    };
    let square = |part: Sym, own: Option<Sign>| {
        let is_apart = is_stated(part) || own.is_some_and(|sign| sign.parts().1);
        Some(if is_apart { Sign::Positive } else { Sign::NotNegative })
    };
    let sum = |a: Sign, b: Sign| {
        let ((up, strict), (other_up, other_strict)) = (a.parts(), b.parts());
        (up == other_up).then(|| Sign::of_parts((up, strict || other_strict)))
    };
    match expression.node() {
        Node::Constant(_) => match expression.as_constant()?.sign()? {
            1 => Some(Sign::Positive),
            0 => Some(Sign::NotNegative),
            _ => Some(Sign::Negative),
        },
        Node::Sum(a, b) => sum(of(a)?, of(b)?),
        Node::Difference(a, b) if a == Sym::ZERO => of(b).map(Sign::opposite),
        Node::Difference(a, b) => sum(of(a)?, of(b)?.opposite()),
        Node::Negation(a) => of(a).map(Sign::opposite),
        Node::Product(a, b) if a == b => square(a, of(a)),
        Node::Product(a, b) => Some(of(a)?.product(of(b)?)),
        Node::Quotient(a, b) => {
            let below = of(b).filter(|sign| sign.parts().1)?;
            Some(of(a)?.product(below))
        }
        Node::Power(a, n) if n % 2 == 0 => square(a, of(a)),
        Node::Power(a, _) => of(a),
        Node::Elementary(Elementary::Exp, ..) => Some(Sign::Positive),
        Node::Root(a) => Some(if of(a) == Some(Sign::Positive) { Sign::Positive } else { Sign::NotNegative }),
        _ => None,
    }
}

/// A part of an expression that is the square root of a quantity that is always negative.
pub(crate) fn without_real_value(expression: Sym, motion: &Motion<'_, '_>, conditions: &[Condition]) -> Option<Sym> {
    // each part once: multiples of an angle share most of theirs
    Sym::ascending(&[expression]).into_iter().find(|part| {
        let Node::Root(below) = part.node() else { return false };
        let below = motion.reduced(below);
        below.as_constant().and_then(|value| value.sign()) == Some(-1)
            || shows(-below, motion, conditions).is_some_and(|shown| shown.is_strict)
    })
}

/// The numbers of trial points, without and with roots, whose evaluation takes longer.
const POINTS: u32 = 4_000;
const POINTS_OF_ROOTS: u32 = 600;

/// The number of points that a search tries: all, or a part if a less plain point is known already.
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

/// An exact point at which the conditions hold and expressions have the required signs.
pub(crate) fn search(
    expressions: &[Sym],
    conditions: &[Condition],
    motion: &Motion<'_, '_>,
    effort: Effort,
    asked: impl Fn(&[i8]) -> bool,
) -> Option<Refutation> {
    let is_open = |expression: &Sym| motion.undetermined(*expression).is_some();
    // further rules besides squares of coordinates belong to free frames
    let has_rules = motion.hypotheses.statements().len() != motion.squares.len();
    if !motion.open.is_empty() || expressions.iter().any(is_open) || has_rules {
        return None;
    }
    let squares: Vec<(Sym, Sym)> = motion.squares.iter().map(|&(of, zero)| (of, motion.reduced(zero))).collect();
    let has_root = |e: &Sym| e.leaves_of().iter().any(|leaf| matches!(leaf.node(), Node::Root(_)));
    let is_slow = |e: &Sym| has_root(e) || holds_half_turn(*e);
    let has_slow =
        expressions.iter().any(is_slow) || conditions.iter().any(|condition| is_slow(&condition.expression()));
    let points = if has_slow { POINTS_OF_ROOTS } else { POINTS };
    let all = expressions.iter().copied().chain(conditions.iter().map(|condition| condition.expression()));
    let mut draw = Draw::of(all.chain(squares.iter().map(|(_, zero)| *zero)), conditions)?;
    draw.leaves.retain(|leaf| squares.iter().all(|(of, _)| of != leaf));
    draw.find(
        effort.of(points),
        |point| with_squares(point, &squares),
        |point| {
            let values = exact(point);
            let rational = |each: Sym| values.value(each).filter(|value| value.is_defined())?.sign();
            let there = |each: Sym| Refutation { point: point.to_vec(), is_formal: false }.value(each);
            let by_half_turn =
                |each: Sym| if holds_half_turn(each) { there(each).and_then(refutation::sign) } else { None };
            let by_roots = |each: Sym| if has_root(&each) { there(each)?.as_constant()?.sign() } else { None };
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
                    let found = rational(*each).or_else(|| by_roots(*each)).or_else(|| by_half_turn(*each));
                    found.map(|sign| sign as i8)
                };
                expressions.iter().map(sign).collect()
            };
            holds() && signs().is_some_and(|signs| asked(&signs))
        },
    )
}

/// A point with the coordinates whose squares are given by constraints; none if they are not fractions.
fn with_squares(point: Vec<(Sym, Sym)>, squares: &[(Sym, Sym)]) -> Option<Vec<(Sym, Sym)>> {
    squares.iter().try_fold(point, |mut point, &(of, zero)| {
        let left = normal(zero.substitute(&point), &Hypotheses::none()).ok()?.numerator();
        let dense = univariate(left, of).ok()?;
        let &[constant, _, leading] = &dense[..] else { return None };
        let root = field::Analytic::sqrt(Sym::constant(-constant / leading));
        let value = normal(root, &Hypotheses::none()).ok()?.to_sym();
        value.as_constant().filter(|value| value.is_defined())?;
        point.push((of, value));
        Some(point)
    })
}

/// A point completed with values for letters that occur only in conditions, so that all conditions hold; none if there are no such values.
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

/// A point with the other coordinate of each angle of which it gives one, where conditions ask for it, by either root; none of these where a
/// coordinate is not one of a circle.
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

/// A point with values for the letters that it leaves open.
fn with_open_letters(found: Refutation, conditions: &[Condition]) -> Option<Refutation> {
    let open: Vec<Condition> =
        conditions.iter().copied().filter(|condition| found.satisfies(*condition) != Some(true)).collect();
    if open.is_empty() {
        return Some(found);
    }
    let left = open.iter().map(|condition| condition.expression().substitute(&found.point));
    let draw = Draw::of(left, conditions)?;
    let whole = |point: &[(Sym, Sym)]| [&found.point[..], point].concat();
    let more = draw.find(POINTS, Some, |point| {
        let there = Refutation { point: whole(point), is_formal: false };
        open.iter().all(|condition| there.satisfies(*condition) == Some(true))
    })?;
    Some(Refutation { point: whole(&more.point), is_formal: found.is_formal })
}

/// Whether a point can be one of real numbers where the conditions hold. To refute an equation an angle, its sine and its cosine may have
/// independent values: an expression that does not vanish there does not vanish for all angles. A condition that contains the angle ties them
/// together.
fn may_be_real(point: &[(Sym, Sym)], conditions: &[Condition]) -> bool {
    let asked = |letter: Sym| conditions.iter().any(|condition| condition.expression().leaves_of().contains(&letter));
    point.iter().all(|(letter, _)| match letter.node() {
        Node::Cos(angle) | Node::Sin(angle) => {
            // conditions on every letter of an angle such as theta/2 or s/R tie it
            let letters = angle.symbols_of();
            !letters.into_iter().filter(|letter| !is_half_turn(*letter)).all(asked)
        }
        _ => true,
    })
}

/// Small numbers for letters, in a fixed order.
struct Draw<'a> {
    leaves: Vec<Sym>,
    /// Letters that stand below roots, for which squares are drawn.
    below_roots: Vec<Sym>,
    conditions: &'a [Condition],
}

impl<'a> Draw<'a> {
    /// The letters of expressions; none where one of them depends on others.
    fn of(expressions: impl Iterator<Item = Sym>, conditions: &'a [Condition]) -> Option<Self> {
        let (mut leaves, mut below_roots): (Vec<Sym>, Vec<Sym>) = (Vec::new(), Vec::new());
        let mut open: Vec<Sym> = expressions.flat_map(Sym::leaves_of).collect();
        while let Some(leaf) = open.pop() {
            if let Node::Root(inside) = leaf.node() {
                below_roots.extend(inside.leaves_of());
                open.extend(inside.leaves_of());
            } else if !leaves.contains(&leaf) && !is_half_turn(leaf) {
                leaves.push(leaf);
            }
        }
        leaves.reverse();
        let is_plain = |leaf: &Sym| match leaf.node() {
            Node::Symbol(_) => true,
            Node::Cos(angle) | Node::Sin(angle) => angle.symbol_name().is_some() && !leaves.contains(&angle),
            _ => false,
        };
        leaves.iter().all(is_plain).then_some(Draw { leaves, below_roots, conditions })
    }

    /// The first suitable point, completed.
    fn find(
        &self,
        points: u32,
        completed: impl Fn(Vec<(Sym, Sym)>) -> Option<Vec<(Sym, Sym)>>,
        is_asked: impl Fn(&[(Sym, Sym)]) -> bool,
    ) -> Option<Refutation> {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            i64::from(state >> 8)
        };
        (0..points).find_map(|attempt| {
            let size = i64::from(2 + attempt / 64);
            let mut point: Vec<(Sym, Sym)> = Vec::new();
            for &leaf in &self.leaves {
                let (draw, below) = (next(), 1 + next() % (1 + size / 4));
                let is_positive = self.conditions.contains(&Condition::Positive(leaf));
                let above = if is_positive { 1 + draw % size } else { draw % (2 * size + 1) - size };
                let number = Rational::new(above, below);
                // the root of a square is a fraction
                let is_squared = self.below_roots.contains(&leaf) && attempt % 2 == 1;
                let number = if is_squared { number * number } else { number };
                let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else {
                    point.push((leaf, Sym::constant(number)));
                    continue;
                };
                let cos = Sym::from_node(Node::Cos(angle));
                if point.iter().all(|(known, _)| *known != cos) {
                    let (one, two) = (Rational::new(1, 1), Rational::new(2, 1));
                    let norm = one + number * number;
                    point.push((cos, Sym::constant((one - number * number) / norm)));
                    point.push((Sym::from_node(Node::Sin(angle)), Sym::constant(two * number / norm)));
                }
            }
            let point = completed(point).filter(|point| is_asked(point))?;
            Some(Refutation { point, is_formal: false })
        })
    }
}
