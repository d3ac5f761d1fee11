//! The hypotheses of a claim: equalities, which are solved, and conditions about signs and zeros.

use crate::letters::Letters;
use crate::motion::Motion;
use crate::passage::{Passage, placed};
use claims::Condition;
use latex::{Chain, Form, Relation, Term, Value, read, value};
use reader::Issue;
use symbolic::{Sym, dimension};

/// A hypothesis after it has been read.
#[derive(Clone)]
pub(crate) struct Hypothesis {
    /// The hypothesis in the paper's letters, as text and LaTeX.
    pub told: (String, String),
    /// The difference of its sides in the paper's letters; `None` if a side is a number, which is in SI units.
    pub own: Option<Sym>,
    /// For an equality, the difference of its sides in the symbols of the model, and the side that is a single letter, if any.
    pub equality: Option<(Sym, Option<Sym>)>,
    /// Whether it sets a letter to a number other than zero, so that dimensions need not agree under it.
    pub scales: bool,
    /// Any other hypothesis, in the symbols of the model: a sign, or an expression that differs from zero.
    pub condition: Option<Condition>,
    /// The range of the hypothesis in the file, in bytes.
    pub at: std::ops::Range<usize>,
}

/// The fault of an expression without a value in the model, with its place in the file.
pub(crate) fn without_value(text: &Passage, fault: latex::NoValue) -> Issue {
    Issue::at(text.part(&fault.span), fault.why, "here").accepted("an expression that the model gives a value")
}

/// A side of a formula in the symbols of the model and in the letters of the paper.
pub(crate) struct Side {
    pub model: Value,
    pub own: Value,
}

/// A side of a formula, evaluated.
pub(crate) fn side(text: &Passage, term: &Term, letters: &Letters<'_, '_>) -> Result<Side, Issue> {
    let fault = |fault| without_value(text, fault);
    Ok(Side {
        model: value(term, &letters.in_model()).map_err(fault)?,
        own: value(term, &letters.in_paper()).map_err(fault)?,
    })
}

/// A side of a formula that must be a scalar, in the symbols of the model and in the letters of the paper.
pub(crate) fn scalar(text: &Passage, term: &Term, letters: &Letters<'_, '_>) -> Result<(Sym, Sym), Issue> {
    match side(text, term, letters)? {
        Side { model: Value::Scalar(model), own: Value::Scalar(own) } => Ok((model, own)),
        _ => {
            let issue = Issue::at(text.part(&term.span), "a vector or a matrix stands where a scalar must", "here");
            Err(issue.accepted("an equation for each component"))
        }
    }
}

/// Reads the hypotheses of a claim. Equalities come first, ordered by the number of their letters, so that their order in the file has no effect.
///
/// # Errors
/// The first text that is not a hypothesis.
pub(crate) fn hypotheses(given: &[Passage], letters: &Letters<'_, '_>) -> Result<Vec<Hypothesis>, Issue> {
    let mut all = given.iter().map(|text| hypothesis(text, letters)).collect::<Result<Vec<_>, Issue>>()?;
    all.sort_by_cached_key(|one| match one.equality {
        Some((zero, _)) => (zero.symbols_of().len(), one.told.0.clone()),
        None => (usize::MAX, String::new()),
    });
    Ok(all)
}

fn hypothesis(text: &Passage, letters: &Letters<'_, '_>) -> Result<Hypothesis, Issue> {
    let accepted =
        r"an equality, an inequality or `\neq` between two sides: '\dot{x} = 0', 'm > 0', '\sin\theta \neq 0'";
    let statement = read(&text.text, &letters.spelt()).map_err(|fault| placed(text, fault))?;
    let [Chain { sides, relations }] = &statement.chains[..] else {
        return Err(Issue::at(text.span.clone(), "an equivalence is no hypothesis", "here").accepted(accepted));
    };
    let ([left, right], [relation]) = (&sides[..], &relations[..]) else {
        return Err(
            Issue::at(text.span.clone(), "a hypothesis must have two sides", "this one has not").accepted(accepted)
        );
    };
    let ((left_is, left_own), (right_is, right_own)) = (scalar(text, left, letters)?, scalar(text, right, letters)?);
    let told = (
        format!("{left_own} {} {right_own}", relation.sign()),
        format!("{} {} {}", left_own.latex(), relation.latex(), right_own.latex()),
    );
    let is_mixed = || dimension(left_own - right_own, &|name: &str| letters.dimension(name)).is_err();
    let scales = *relation == Relation::Equal && right_is != Sym::ZERO && is_mixed();
    // a number without letters, such as 2 or its square root
    let is_number = |side: Sym| side.symbols_of().is_empty() && side != Sym::ZERO;
    let own = (!is_number(left_own) && !is_number(right_own)).then_some(left_own - right_own);
    let mut found = Hypothesis { told, own, equality: None, scales, condition: None, at: text.span.clone() };
    match relation {
        Relation::Equal => {
            let is_letter = |side: &Term| matches!(side.form, Form::Letter(_) | Form::Rate(..));
            let alone = [(left, left_is), (right, right_is)].into_iter().find(|(side, _)| is_letter(side));
            let alone = alone.map(|(_, is)| is);
            found.equality = Some((left_is - right_is, alone));
        }
        Relation::NotEqual => found.condition = Some(Condition::NonZero(left_is - right_is)),
        Relation::Greater => found.condition = Some(Condition::Positive(left_is - right_is)),
        Relation::Less => found.condition = Some(Condition::Positive(right_is - left_is)),
        Relation::GreaterOrEqual => found.condition = Some(Condition::NotNegative(left_is - right_is)),
        Relation::LessOrEqual => found.condition = Some(Condition::NotNegative(right_is - left_is)),
    }
    Ok(found)
}

/// Adds the equalities of hypotheses to the assumptions of a motion.
///
/// # Errors
/// The first equality that cannot be solved.
pub(crate) fn assume(motion: &mut Motion<'_, '_>, hypotheses: &[Hypothesis]) -> Result<(), Issue> {
    for hypothesis in hypotheses {
        if let Some((zero, first)) = hypothesis.equality {
            motion.assume(zero, first).map_err(|why| {
                let issue = Issue::at(hypothesis.at.clone(), why, "not solved");
                issue.accepted("an equality in which a letter stands alone, such as '\\dot{x} = 0'")
            })?;
        }
    }
    Ok(())
}

/// The conditions of hypotheses, reduced on the motion.
pub(crate) fn conditions(motion: &Motion<'_, '_>, hypotheses: &[Hypothesis]) -> Vec<Condition> {
    let reduced = |condition: Condition| condition.mapped(|e| motion.reduced(e));
    hypotheses.iter().filter_map(|hypothesis| hypothesis.condition.map(reduced)).collect()
}
