//! Inequalities: proved by the signs of their terms, refuted at an exact point.

use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions, scalar};
use crate::display::Told;
use crate::equation::{Outcome, Refutation};
use crate::finding::{Finding, Sides};
use crate::letters::Letters;
use crate::motion::Motion;
use crate::verdict::{allowed, neither};
use claims::{Condition, Page, Point, Verdict};
use field::Rational;
use latex::{Relation, Statement};
use reader::Issue;
use symbolic::{Node, Sym};

/// `a > b` and `a \geq b` where the hypotheses hold.
pub(crate) fn inequality(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
) -> Result<(), Issue> {
    let refused = |title: &str| {
        Issue::at(claim.formula.span.clone(), title.to_owned(), "here")
            .accepted(r"two sides with <, >, \leq or \geq between them")
    };
    let (sides, relation) = match &statement.chains[..] {
        [chain] => match (&chain.sides[..], &chain.relations[..]) {
            ([left, right], [relation]) => ([left, right], *relation),
            _ => return Err(refused("an inequality has two sides")),
        },
        _ => return Err(refused("an equivalence is no inequality")),
    };
    let (left, left_own) = scalar(&claim.formula, sides[0], letters)?;
    let (right, right_own) = scalar(&claim.formula, sides[1], letters)?;
    finding.judged.text = vec![format!("{left_own} {} {right_own}", relation.sign())];
    finding.judged.latex = vec![format!("{} {} {}", left_own.latex(), relation.latex(), right_own.latex())];
    let (greater, is_strict) = match relation {
        Relation::Greater => (left - right, true),
        Relation::GreaterOrEqual => (left - right, false),
        Relation::Less => (right - left, true),
        Relation::LessOrEqual => (right - left, false),
        Relation::Equal | Relation::NotEqual => return Err(refused("this formula is no inequality")),
    };
    let trace = letters.trace;
    let symbols = greater.symbols_of();
    let is_dynamic = trace.accelerations.iter().any(|acceleration| symbols.contains(acceleration))
        || symbols.iter().any(|symbol| symbol.to_string().starts_with("multiplier "));
    let motion = if is_dynamic { Motion::by_equations(trace) } else { Ok(Motion::by_constraints(trace)) };
    let mut motion = match motion {
        Ok(motion) => motion,
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    assume(&mut motion, assumed)?;
    finding.allowed = allowed(trace, is_dynamic);
    let conditions = conditions(&motion, assumed);
    let reduced = motion.reduced(greater);
    let told = Told(letters);
    let mut page = Page::of("paper", |_| None);
    page.claim("", "", "")
        .given(conditions.iter().copied())
        .under(&motion.hypotheses)
        .by_signs([Condition::Positive(reduced)]);
    let by_signs = page.judge().into_iter().next();
    if let Some(judged) = by_signs.filter(|judged| judged.verdict == Verdict::Proved) {
        (finding.judged.verdict, finding.judged.evidence) = (Verdict::Proved, judged.evidence);
        return Ok(());
    }
    // as printed too: a normal form may mix signs that the print keeps apart
    let shows = |expression: Sym| match sign(expression, &conditions) {
        Some(Sign::Positive) => true,
        Some(Sign::NotNegative) => !is_strict,
        _ => false,
    };
    if shows(reduced) || shows(greater) {
        let evidence = "every term as written has this sign: squares, and letters that are positive".to_owned();
        (finding.judged.verdict, finding.judged.evidence) = (Verdict::Proved, evidence);
        return Ok(());
    }
    match search(reduced, is_strict, &conditions, &motion) {
        Some(refutation) => {
            finding.judged.verdict = Verdict::Refuted;
            let value = |side: Sym| refutation.value(motion.reduced(side)).map(|value| value.to_string());
            finding.sides = value(left).zip(value(right)).map(|(left, right)| Sides { left, right });
            finding.judged.evidence = match &finding.sides {
                Some(Sides { left, right }) => {
                    format!("at the exact point the left side is {left} and the right side is {right}")
                }
                None => "it fails at the exact point".to_owned(),
            };
            finding.judged.counterexample = crate::display::point([left_own, right_own], &refutation, &motion, told);
        }
        None => {
            let why = "the signs of its terms do not show it, and no exact point was found at which it fails";
            neither(Outcome::Undecided(why.to_owned()), letters, finding);
        }
    }
    Ok(())
}

/// What is known of the sign of an expression.
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

/// The sign of an expression as it is written, by those of its letters.
fn sign(expression: Sym, conditions: &[Condition]) -> Option<Sign> {
    let of = |part: Sym| sign(part, conditions);
    if conditions.contains(&Condition::Positive(expression)) {
        return Some(Sign::Positive);
    }
    let is_apart =
        |part: Sym| conditions.contains(&Condition::NonZero(part)) || of(part).is_some_and(|sign| sign.parts().1);
    let square = |part: Sym| Some(if is_apart(part) { Sign::Positive } else { Sign::NotNegative });
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
        Node::Product(a, b) if a == b => square(a),
        Node::Product(a, b) => Some(of(a)?.product(of(b)?)),
        Node::Quotient(a, b) => {
            let below = of(b).filter(|sign| sign.parts().1)?;
            Some(of(a)?.product(below))
        }
        Node::Power(a, n) if n % 2 == 0 => square(a),
        Node::Power(a, _) => of(a),
        Node::Root(a) => Some(if of(a) == Some(Sign::Positive) { Sign::Positive } else { Sign::NotNegative }),
        _ => None,
    }
}

/// Points that are tried.
const POINTS: u32 = 4_000;

/// An exact point at which the conditions hold and the expression is negative, or zero where it must be positive.
fn search(expression: Sym, is_strict: bool, conditions: &[Condition], motion: &Motion<'_, '_>) -> Option<Refutation> {
    if !motion.open.is_empty()
        || motion.undetermined(expression).is_some()
        || !motion.hypotheses.statements().is_empty()
    {
        return None;
    }
    let mut leaves = expression.leaves_of();
    for condition in conditions {
        leaves.extend(
            condition.expression().leaves_of().into_iter().filter(|leaf| !leaves.contains(leaf)).collect::<Vec<_>>(),
        );
    }
    let is_plain = |leaf: &Sym| match leaf.node() {
        Node::Symbol(_) => true,
        Node::Cos(angle) | Node::Sin(angle) => angle.symbol_name().is_some() && !leaves.contains(&angle),
        _ => false,
    };
    if !leaves.iter().all(is_plain) {
        return None;
    }
    let mut state = 1u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        i64::from(state >> 8)
    };
    (0..POINTS).find_map(|attempt| {
        let size = i64::from(2 + attempt / 64);
        let mut point: Vec<(Sym, Sym)> = Vec::new();
        for &leaf in &leaves {
            let (draw, below) = (next(), 1 + next() % (1 + size / 4));
            let positive = conditions.contains(&Condition::Positive(leaf));
            let above = if positive { 1 + draw % size } else { draw % (2 * size + 1) - size };
            let number = Rational::new(above, below);
            match leaf.node() {
                Node::Cos(angle) | Node::Sin(angle) => {
                    let cos = Sym::from_node(Node::Cos(angle));
                    if point.iter().all(|(known, _)| *known != cos) {
                        let (one, two) = (Rational::new(1, 1), Rational::new(2, 1));
                        let norm = one + number * number;
                        point.push((cos, Sym::constant((one - number * number) / norm)));
                        point.push((Sym::from_node(Node::Sin(angle)), Sym::constant(two * number / norm)));
                    }
                }
                _ => point.push((leaf, Sym::constant(number))),
            }
        }
        let values = Point::of(point.iter().filter_map(|(symbol, value)| Some((*symbol, value.as_constant()?))));
        let holds = conditions.iter().all(|condition| condition.holds_at(&values) == Some(true));
        let refutation = Refutation { point, is_formal: false };
        let sign = refutation.value(expression)?.as_constant()?.sign()?;
        (holds && (sign == -1 || sign == 0 && is_strict)).then_some(refutation)
    })
}
