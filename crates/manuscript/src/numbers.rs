//! Claims about printed numbers: an enclosure of a quantity for given data is compared with the printed digits.

use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, scalar};
use crate::equation::Outcome;
use crate::finding::{Finding, Sides};
use crate::half_turn::{enclosed, is_half_turn};
use crate::letters::Letters;
use crate::motion::Motion;
use crate::printed_decimal::PrintedDecimal;
use crate::verdict::{allowed, neither};
use claims::certificate::PartProof;
use claims::{Condition, Verdict};
use field::{Interval, Rational};
use latex::{Relation, Statement};
use reader::Issue;
use std::ops::Range;
use symbolic::{Hypotheses, NotNormal, Sym, normal};

/// Judges a claim such as `\ddot{\theta} = -12.98`: the value that follows from `given` must agree with every printed digit. Numbers are in SI units.
pub(crate) fn number(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let accepted =
        r"'\ddot{x} = -1.25' or '\ddot{x} = -1.25\cdot 10^{-2}', with the data in given = ['m = 2', 'x = 0.1']";
    let refused = |title: String| Issue::at(claim.formula.span.clone(), title, "here").accepted(accepted);
    let [chain] = &statement.chains[..] else { return Err(refused("a number is printed in one equality".to_owned())) };
    let ([left, right], [Relation::Equal]) = (&chain.sides[..], &chain.relations[..]) else {
        return Err(refused("a number is printed in one equality".to_owned()));
    };
    let Some(digits) = PrintedDecimal::of(right, &claim.formula.text) else {
        return Err(refused("the right side of this claim is no decimal number".to_owned()));
    };
    let exact_half = digits.half_unit();
    let ((quantity, own), (printed_is, printed_own)) =
        (scalar(&claim.formula, left, letters)?, scalar(&claim.formula, right, letters)?);
    finding.judged.text = vec![format!("{own} = {}", printed_own.decimal_text())];
    finding.judged.latex = vec![format!("{} = {}", own.latex(), printed_own.decimal_latex())];
    let mut motion = match Motion::by_equations(letters.trace) {
        Ok(motion) => motion,
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    assume(&mut motion, assumed)?;
    finding.allowed = allowed(letters.trace, true);
    let value = cancelled(&motion, motion.reduced(quantity));
    let open = value.symbols_of().into_iter().filter(|symbol| !is_half_turn(*symbol));
    let open: Vec<String> = open.map(|symbol| letters.told(symbol).to_string()).collect();
    if !open.is_empty() {
        return Err(refused(format!("the value depends on {}, which `given` does not have", open.join(", "))));
    }
    if let Err(NotNormal::Undefined(divisor)) = normal(value, &Hypotheses::none()) {
        neither(Outcome::Undefined(divisor), letters, finding);
        return Ok(());
    }
    let apart = exactly(value - printed_is);
    let is_tie = apart.is_some_and(|missing| missing == exact_half || -missing == exact_half);
    let is_zero = |side: Sym| exactly(side).is_some_and(|side| side.sign() == Some(0));
    let has_digits = !is_zero(printed_is) || is_zero(value);
    let (Some(value), Some(printed), Some(exact)) = (enclosed(value), enclosed(printed_is), exactly(printed_is)) else {
        neither(Outcome::Undecided("the value was not enclosed".to_owned()), letters, finding);
        return Ok(());
    };
    let agreement = Agreement::of(value, apart, [exact - exact_half, exact + exact_half]);
    let range = range(value);
    let (verdict, evidence) = match agreement {
        _ if is_tie => {
            let tie = "the value lies exactly half a unit of the last printed digit from the print";
            (Verdict::Enclosed, format!("{tie}: a tie, which is rounded up or down by convention"))
        }
        Agreement::Agrees if !has_digits => {
            let why = "a printed zero has no significant digit, so that it neither confirms nor refutes a value within half a unit of its last digit";
            (Verdict::Undecided, format!("{why}: {range}"))
        }
        Agreement::Agrees => {
            (Verdict::Enclosed, format!("by enclosures: {range}, which is the printed number to all its digits"))
        }
        Agreement::Differs => {
            if [value.low(), value.high()].into_iter().all(f64::is_finite) {
                finding.sides = Some(Sides { left: short(value), right: short(printed) });
                let missing = apart.map_or_else(|| short(value - printed), |apart| apart.to_f64().to_string());
                finding.judged.difference = Some((missing.clone(), missing));
            }
            finding.judged.counterexample = assumed
                .iter()
                .filter_map(|one| one.told.0.split_once(" = "))
                .map(|(a, b)| (a.to_owned(), b.to_owned()))
                .collect();
            (Verdict::Refuted, format!("by enclosures: {range}"))
        }
        Agreement::Open => (Verdict::Undecided, format!("{range}, which leaves the last printed digit open")),
    };
    (finding.judged.verdict, finding.judged.evidence) = (verdict, evidence);
    if !is_tie {
        let half = Sym::constant(exact_half);
        let within = [quantity - (printed_is - half), printed_is + half - quantity].map(Condition::Positive);
        record.part(&motion, assumed, &within, |_| match verdict {
            Verdict::Refuted => PartProof::Excluded,
            _ => PartProof::Enclosure,
        });
    }
    Ok(())
}

/// The relation of a value to the interval of numbers that round to the printed digits.
enum Agreement {
    Agrees,
    Differs,
    Open,
}

impl Agreement {
    /// The relation, by the exact difference `apart` from the printed number if the value is rational, otherwise by the ends of its enclosure.
    fn of(value: Interval, apart: Option<Rational>, [low, high]: [Rational; 2]) -> Self {
        let is_below = |one: Rational, other: Rational| (one - other).sign() == Some(-1);
        if let Some(apart) = apart {
            let half = (high - low) / Rational::new(2, 1);
            return if is_below(half, apart) || is_below(half, -apart) { Self::Differs } else { Self::Agrees };
        }
        let exact = |end: f64| end.is_finite().then(|| Rational::exactly(end));
        let is_after = |end: Option<Rational>, other: Rational| end.is_some_and(|end| is_below(other, end));
        let is_before = |end: Option<Rational>, other: Rational| end.is_some_and(|end| is_below(end, other));
        let (from, to) = (exact(value.low()), exact(value.high()));
        match (is_after(from, low) && is_before(to, high), is_after(from, high) || is_before(to, low)) {
            (true, _) => Self::Agrees,
            (_, true) => Self::Differs,
            _ => Self::Open,
        }
    }
}

/// A printed number with its correct digits.
pub(crate) struct Right {
    /// The range of the printed digits in the formula.
    pub span: Range<usize>,
    pub digits: String,
    /// The range of the exponent of ten and the exponent with which the printed digits are correct.
    pub power: Option<(Range<usize>, String)>,
}

/// The correct digits of a printed number, as many as are printed; `None` if the value is not determined.
pub(crate) fn right(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
) -> Option<Right> {
    let [left, right] = &statement.chains.first()?.sides[..] else { return None };
    let (quantity, _) = scalar(&claim.formula, left, letters).ok()?;
    let mut motion = Motion::by_equations(letters.trace).ok()?;
    assume(&mut motion, assumed).ok()?;
    let value = enclosed(cancelled(&motion, motion.reduced(quantity)))?.middle();
    let printed = PrintedDecimal::of(right, &claim.formula.text)?;
    let power = printed.power_for(value, &claim.formula.text);
    value.is_finite().then(|| Right { digits: printed.digits(value), span: printed.span, power })
}

/// A value in which letters that cancel have been removed.
fn cancelled(motion: &Motion<'_, '_>, value: Sym) -> Sym {
    match value.symbols_of().into_iter().all(is_half_turn) {
        true => value,
        false => normal(value, &motion.hypotheses).map_or(value, |form| form.to_sym()),
    }
}

/// A sentence with the ends of an enclosure.
fn range(value: Interval) -> String {
    let beyond = "beyond the numbers of double precision";
    match (value.low(), value.high()) {
        (low, high) if low.is_finite() && high.is_finite() => {
            format!("the value lies between {low:e} and {high:e}")
        }
        (low, _) if low.is_finite() => format!("the value is {low:e} or larger, {beyond}"),
        (_, high) if high.is_finite() => format!("the value is {high:e} or smaller, {beyond}"),
        _ => "the value was enclosed by no number of double precision".to_owned(),
    }
}

/// The midpoint of an enclosure with nine digits.
fn short(value: Interval) -> String {
    let digits = format!("{:.8e}", value.middle());
    digits.parse::<f64>().map_or(digits, |value| value.to_string())
}

/// The value of an expression if it is a rational number.
fn exactly(expression: Sym) -> Option<Rational> {
    normal(expression, &Hypotheses::none()).ok()?.to_sym().as_constant().filter(|value| value.is_defined())
}
