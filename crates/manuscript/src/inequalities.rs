//! Claims that are inequalities: proofs by the signs of terms, refutations by exact points.

use crate::admissible::admissible;
use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::condition_products;
use crate::conditions::{Hypothesis, assume, conditions, scalar};
use crate::display::{Told, divisors, tell_point};
use crate::equation::Outcome;
use crate::exact_points::{Effort, completed, search};
use crate::finding::{Finding, Sides as Values};
use crate::half_turn::{enclosed, holds_half_turn};
use crate::letters::Letters;
use crate::line_signs::least;
use crate::lost_divisors::Lost;
use crate::monotone_functions;
use crate::motion::Motion;
use crate::natural_domain::natural_domain;
use crate::polynomial_signs;
use crate::real_signs;
use crate::refutation::Refutation;
use crate::signs::{Shown, shows};
use crate::square_sums::{self, square_sum};
use crate::verdict::{allowed, neither};
use claims::certificate::PartProof;
use claims::{Condition, Verdict};
use field::Rational;
use latex::{Relation, Statement};
use reader::Issue;
use symbolic::{Sym, normal};

/// The sides of an inequality.
pub(crate) struct Sides {
    /// The difference that is claimed to be positive or nonnegative; for `a \neq b` the square of the difference.
    pub greater: Sym,
    pub is_strict: bool,
    /// The left side in the symbols of the model.
    pub left: Sym,
    pub right: Sym,
    /// Both sides in the paper's letters.
    pub own: [Sym; 2],
    pub text: String,
    pub latex: String,
}

/// Reads the sides of an inequality.
///
/// # Errors
/// The formula is not an inequality.
pub(crate) fn sides(claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Result<Sides, Issue> {
    let refused = |title: &str| {
        Issue::at(claim.formula.span.clone(), title.to_owned(), "here")
            .accepted(r"two sides with <, >, \leq, \geq or \neq between them")
    };
    let ([left, right], relation) = match &statement.chains[..] {
        [chain] => match (&chain.sides[..], &chain.relations[..]) {
            ([left, right], [relation]) => ([left, right], *relation),
            _ => return Err(refused("an inequality has two sides")),
        },
        _ => return Err(refused("an equivalence is no inequality")),
    };
    let ((left, left_own), (right, right_own)) =
        (scalar(&claim.formula, left, letters)?, scalar(&claim.formula, right, letters)?);
    let (greater, is_strict) = match relation {
        Relation::Greater => (left - right, true),
        Relation::GreaterOrEqual => (left - right, false),
        Relation::Less => (right - left, true),
        Relation::LessOrEqual => (right - left, false),
        // two sides differ where the square of their difference is positive
        Relation::NotEqual => ((left - right) * (left - right), true),
        Relation::Equal => return Err(refused("this formula is no inequality")),
    };
    let text = format!("{left_own} {} {right_own}", relation.sign());
    let latex = format!("{} {} {}", left_own.latex(), relation.latex(), right_own.latex());
    Ok(Sides { greater, is_strict, left, right, own: [left_own, right_own], text, latex })
}

/// Judges `a > b`, `a \geq b` or `a \neq b` under its hypotheses.
pub(crate) fn inequality(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let Sides { greater, is_strict, left, right, own, text, latex } = sides(claim, statement, letters)?;
    (finding.judged.text, finding.judged.latex) = (vec![text], vec![latex]);
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
    let hidden = match motion.lost_divisors(greater) {
        Lost::Divisors(hidden) => [&motion.divisors[..], &hidden].concat(),
        Lost::Zero(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    let is_enough = |found: &Shown| found.is_strict || !is_strict;
    let by_terms = [reduced, greater]
        .into_iter()
        .find_map(|side| shows(side, &motion, &conditions).filter(is_enough).map(|found| (Some(side), found)));
    // constraints of positions may turn the difference into a square
    let form = || normal(reduced, &motion.hypotheses).map_or(reduced, |form| form.to_sym());
    let by_squares = || {
        let shown = |side: Sym| real_signs::shows(side, &conditions).filter(is_enough);
        let sum = || {
            let is_strict = square_sums::shows(reduced, &conditions)?;
            let evidence = "a sum of squares and of products of what is positive".to_owned();
            Some(Shown { is_strict, evidence, is_of_normal_form: true }).filter(is_enough)
        };
        shown(reduced).or_else(|| shown(form())).or_else(sum).map(|found| (None, found))
    };
    if let Some((side, found)) = by_terms.or_else(by_squares) {
        match side {
            Some(side) if found.is_of_normal_form && side == reduced => record.positive(&motion, assumed, greater),
            Some(side) if !found.is_of_normal_form => {
                record.positive_as_written(&motion, assumed, [greater, side], is_strict);
            }
            _ if square_sum(reduced, is_strict, &conditions).is_some() => {
                record.positive_by_squares(&motion, assumed, [greater, reduced], is_strict, &conditions);
            }
            // constraints of positions may turn the difference into a square
            _ if !motion.squares.is_empty() => {
                record.positive_by_squares(&motion, assumed, [greater, form()], is_strict, &conditions);
            }
            _ => record.positive_by_products(&motion, assumed, reduced, is_strict, &conditions),
        }
        (finding.judged.verdict, finding.judged.evidence) = (Verdict::Proved, found.evidence);
        finding.judged.requires.extend(divisors(&hidden, told));
        return Ok(());
    }
    // two sides differ where one of them is greater
    let apart = motion.reduced(left) - motion.reduced(right);
    let differences = if greater == (left - right) * (left - right) { vec![apart, -apart] } else { vec![reduced] };
    let fails = |sign: i8| sign == -1 || sign == 0 && is_strict;
    let found = |conditions: &[Condition], effort: Effort| {
        search(&[reduced], conditions, &motion, effort, |signs| fails(signs[0]))
            .or_else(|| polynomial_signs::negative_point(reduced, conditions, &motion))
            .or_else(|| failing_point([greater, reduced], conditions, &motion, fails))
    };
    match found(&conditions, Effort::Whole) {
        Some(refutation) => {
            let refutation = admissible(refutation, &motion, &conditions, |within| found(within, Effort::Part));
            record.is_below(&motion, assumed, greater, is_strict, &refutation);
            finding.judged.verdict = Verdict::Refuted;
            let value = |side: Sym| refutation.value(motion.reduced(side)).map(|value| value.to_string());
            finding.sides = value(left).zip(value(right)).map(|(left, right)| Values { left, right });
            finding.judged.evidence = match &finding.sides {
                Some(Values { left, right }) => {
                    format!("at the exact point the left side is {left} and the right side is {right}")
                }
                None => "it fails at the exact point".to_owned(),
            };
            tell_point(own, &refutation, &motion, told, finding);
        }
        None if condition_products::show(reduced, is_strict, &conditions) => {
            record.positive_by_products(&motion, assumed, reduced, is_strict, &conditions);
            finding.judged.verdict = Verdict::Proved;
            finding.judged.evidence =
                "products of the hypotheses with its opposite add up to a negative number, exactly".to_owned();
            finding.judged.requires.extend(divisors(&hidden, told));
        }
        None if differences
            .iter()
            .any(|side| monotone_functions::shows(*side, &conditions).is_some_and(|is| is || !is_strict)) =>
        {
            record.leave_out();
            finding.judged.verdict = Verdict::Proved;
            finding.judged.evidence =
                "the difference of both sides is not negative at the bound of a letter, and grows from there on: so does its derivative, or it is a square"
                    .to_owned();
            finding.judged.requires.extend(divisors(&hidden, told));
        }
        None if enclosed(reduced).is_some_and(|value| value.low() > 0.0) => {
            finding.judged.verdict = Verdict::Enclosed;
            finding.judged.evidence = "by an enclosure of the difference of both sides, which are numbers".to_owned();
            let then = [Condition::Positive(greater)];
            record.part(&motion, assumed, &then, |_| PartProof::Enclosure);
        }
        None if enclosed(reduced).is_some_and(|value| value.high() < 0.0) => {
            finding.judged.verdict = Verdict::Refuted;
            finding.judged.evidence =
                "by an enclosure of the difference of both sides, which are numbers: it has the other sign".to_owned();
            let then = [Condition::Positive(greater)];
            record.part(&motion, assumed, &then, |_| PartProof::Excluded);
        }
        None => {
            let why = "neither the signs of its terms nor squares, discriminants and real roots show it, and no exact point was found at which it fails";
            neither(Outcome::Undecided(why.to_owned()), letters, finding);
        }
    }
    Ok(())
}

/// A point at which an expression in one unknown has a wrong sign: a rational number, or a number with a square root.
fn failing_point(
    [greater, reduced]: [Sym; 2],
    conditions: &[Condition],
    motion: &Motion<'_, '_>,
    fails: impl Fn(i8) -> bool,
) -> Option<Refutation> {
    if !motion.open.is_empty() || !motion.hypotheses.statements().is_empty() || motion.undetermined(reduced).is_some() {
        return None;
    }
    let all = [conditions, &natural_domain(&[greater, reduced])].concat();
    // π is replaced by a convergent within its bounds, and points that are found are tested with π itself
    let holds_pi = holds_half_turn(reduced) || all.iter().any(|condition| holds_half_turn(condition.expression()));
    if holds_pi {
        let near = [(motion.trace.pi, Sym::constant(Rational::new(103_993, 33_102)))];
        let all: Vec<Condition> = all.iter().map(|condition| condition.mapped(|e| e.substitute(&near))).collect();
        let is_it = |found: &Refutation| {
            found.value(reduced).and_then(crate::refutation::sign).is_some_and(|sign| fails(sign as i8))
        };
        let points = least(reduced.substitute(&near), &all)?.points;
        return points.into_iter().filter(is_it).find_map(|found| completed(found, conditions));
    }
    let least = least(reduced, &all).filter(|least| fails(least.sign.signum() as i8))?;
    let is_rational = |found: &Refutation| found.point.iter().all(|(_, value)| value.as_constant().is_some());
    let holds = |found: &Refutation| {
        let sign = |of: Sym| found.value(of).and_then(crate::refutation::sign);
        conditions.iter().all(|condition| sign(condition.expression()).is_some_and(|sign| condition.allows(sign)))
    };
    least.points.into_iter().find_map(|found| match is_rational(&found) {
        true => completed(found, conditions),
        false => holds(&found).then_some(found),
    })
}
