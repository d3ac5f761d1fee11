//! Edits that add a lost term. The missing terms are computed exactly, and used if they are short.

use super::comparison::letters;
use super::edit::Edit;
use super::ground::Ground;
use super::integral_terms::{integral_terms, terms_below_rates};
use super::places::Places;
use super::probe::Probe;
use super::search::edited;
use super::text_claim::TextClaim;
use crate::change::EditKind;
use crate::claim_text::Kind;
use crate::letter_forms::ways_to_tell;
use crate::letters::Letters;
use crate::linearisation::Linearisation;
use crate::motion::Motion;
use latex::{Chain, Meaning, Statement, Value, read, value};
use model::equations::Equations;
use std::ops::Range;
use symbolic::{Hypotheses, Sym, normal};

/// The largest length of a lost term in characters; a longer term is not a plausible error of the printed formula.
pub(super) const SHORT: usize = 140;

/// The letter that stands for the unknown lost term.
pub(super) const SOUGHT: &str = r"\aleph";

/// Edits that add the terms which each sum of a claim lacks; in an integral of motion also edits that add a single letter.
pub(super) fn lost(ground: &TextClaim<'_, '_, '_>, places: &Places, probe: &Probe<'_, '_>, most: usize) -> Vec<Edit> {
    let (kind, letters) = (ground.claim.kind, ground.letters);
    if kind == Kind::IntegralOfMotion && most == 1 {
        let plain = || ground.rates().iter().filter(|rate| rate.order == 0).map(|rate| rate.latex.clone());
        let terms = || plain().flat_map(|latex| [("+", latex.clone()), ("-", latex)]).collect();
        let letters_alone = added(open_sums(places, ground.text()).map(|sum| (sum, terms())));
        let of_integrals = |statement: &Statement| integral_terms(statement, letters);
        let others = lost_terms(places, ground.text(), ground.known(), most, &of_integrals);
        return [letters_alone, others].concat();
    }
    lost_terms(places, ground.text(), letters.spelt(), most, &|statement| missing_values(ground, statement, probe))
}

/// The values of the letter of the unknown term with which a claim holds.
pub(super) fn sought_values(ground: &TextClaim<'_, '_, '_>, statement: &Statement, probe: &Probe<'_, '_>) -> Vec<Sym> {
    // a single part of a linearised equation does not determine the letter
    if ground.claim.kind == Kind::LinearisedEquation {
        return Vec::new();
    }
    missing_values(ground, statement, probe)
}

fn missing_values(ground: &TextClaim<'_, '_, '_>, statement: &Statement, probe: &Probe<'_, '_>) -> Vec<Sym> {
    let letters = ground.letters;
    // the rate of an unknown term has no value
    let below_rates = || terms_below_rates(statement, letters);
    sought_difference(statement, letters)
        .map_or_else(below_rates, |zero| missing(ground.claim.kind, zero, letters, probe))
}

/// Edits that add the terms which each sum lacks, if these are at most `most` short terms. `of` returns their values from the formula in which
/// the letter of the unknown term is added to the sum.
pub(super) fn lost_terms(
    places: &Places,
    text: &str,
    mut known: Vec<String>,
    most: usize,
    of: &dyn Fn(&Statement) -> Vec<Sym>,
) -> Vec<Edit> {
    if known.iter().any(|name| name == SOUGHT) {
        return Vec::new();
    }
    known.push(SOUGHT.to_owned());
    let printed = places.atoms.len() + places.numbers.len();
    added(open_sums(places, text).map(|sum| {
        let with = format!("{}+{SOUGHT}{}", &text[..sum.end], &text[sum.end..]);
        let terms = read(&with, &known).map_or_else(|_| Vec::new(), |statement| of(&statement));
        let is_short = |term: &Sym| {
            let told = term.to_string();
            // several terms that are much longer than the printed formula would be a new formula
            let is_less = count(&told) == 1 || 2 * letters(*term) <= 3 * printed;
            *term != Sym::ZERO && told.chars().count() <= SHORT && count(&told) <= most && is_less
        };
        (sum, terms.into_iter().filter(is_short).map(signed).collect())
    }))
}

/// Edits that add one term which the last side lacks after another edit.
pub(super) fn lost_beside(ground: &impl Ground, edit: &Edit, end: usize) -> Vec<Edit> {
    let mut known = ground.known();
    if known.iter().any(|name| name == SOUGHT) || edit.span.end > end {
        return Vec::new();
    }
    known.push(SOUGHT.to_owned());
    let at = Edit::new(EditKind::LostTerm, end..end, format!(" + {SOUGHT}"), String::new());
    let Some((text, _)) = edited(ground.text(), &[edit.clone(), at]) else { return Vec::new() };
    let terms = read(&text, &known).map_or_else(|_| Vec::new(), |statement| ground.sought(&statement));
    let is_short = |term: &Sym| {
        let told = term.to_string();
        *term != Sym::ZERO && told.chars().count() <= SHORT / 2 && count(&told) == 1
    };
    added(std::iter::once((end..end, terms.into_iter().filter(is_short).map(signed).collect())))
}

/// The edits that add a missing term at the end of the right side of a condition, or at the end of the left side if the right side is zero.
pub(super) fn lost_on_a_side(places: &Places, text: &str, missing: &str) -> Vec<Edit> {
    let end = |side: usize| {
        places.summands.iter().find(|summand| summand.side == Some(side)).map(|first| places.sums[first.sum].clone())
    };
    let (Some(left), Some(right)) = (end(0), end(1)) else { return Vec::new() };
    let is_empty = &text[right.clone()] == "0";
    let signed = match (missing.strip_prefix('-'), is_empty) {
        (Some(term), true) => ("+", term.to_owned()),
        (Some(term), false) => ("-", term.to_owned()),
        (None, true) => ("-", missing.to_owned()),
        (None, false) => ("+", missing.to_owned()),
    };
    added(std::iter::once((if is_empty { left } else { right }, vec![signed])))
}

/// The sums to which a term can be added at the end.
fn open_sums<'a>(places: &'a Places, text: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
    let may_hold = |sum: &&Range<usize>| {
        let behind = text[sum.end..].trim_start();
        let may_follow = behind.is_empty()
            || behind.starts_with([')', ']', '}', '=', '&'])
            || [r"\right", r"\\", r"\end"].into_iter().any(|command| behind.starts_with(command))
            || [r"\bigr", r"\Bigr", r"\biggr", r"\Biggr"].into_iter().any(|size| behind.starts_with(size));
        may_follow && &text[(*sum).clone()] != "0"
    };
    places.sums.iter().filter(may_hold).cloned()
}

/// Edits that add a term to a sum, the shortest first.
fn added(terms: impl Iterator<Item = (Range<usize>, Vec<(&'static str, String)>)>) -> Vec<Edit> {
    let mut all: Vec<Edit> = Vec::new();
    for (sum, terms) in terms {
        for (sign, latex) in terms {
            let words = format!("the missing term `{sign} {latex}`");
            let edit = Edit::new(EditKind::LostTerm, sum.end..sum.end, format!(" {sign} {latex}"), words);
            if !all.contains(&edit) {
                all.push(edit);
            }
        }
    }
    all.sort_by_key(|edit| edit.after.len());
    // a quotient by a sum, or by a rate, would make up for a term that is lost elsewhere
    let divides_by_rate = |edit: &Edit| edit.after.rsplit_once("}{").is_some_and(|(_, below)| below.contains("dot"));
    let is_plain = |edit: &Edit| !(edit.after.contains(r"\frac") && (count(&edit.after) > 2 || divides_by_rate(edit)));
    if all.iter().any(is_plain) {
        all.retain(is_plain);
    }
    all
}

/// The sign and the LaTeX of a term; a sum is put in parentheses.
pub(super) fn signed(term: Sym) -> (&'static str, String) {
    match (term.to_string().starts_with('-'), count(&term.to_string())) {
        (true, 1) => ("-", (-term).latex()),
        (false, 1) => ("+", term.latex()),
        _ => ("+", format!(r"\left({}\right)", term.latex())),
    }
}

/// The difference of the two sides over the model; of matrices that of the first entries in which the sought letter stands.
fn sought_difference(statement: &Statement, letters: &Letters<'_, '_>) -> Option<Sym> {
    let [Chain { sides, .. }] = &statement.chains[..] else { return None };
    let [left, right] = &sides[..] else { return None };
    let meaning = Sought(letters);
    let [left, right] = [value(left, &meaning).ok()?, value(right, &meaning).ok()?];
    match (&left, &right) {
        (Value::Scalar(left), Value::Scalar(right)) => Some(*left - *right),
        (Value::Matrix(_), Value::Matrix(_)) => {
            let mut entries = left.entries().into_iter().zip(right.entries()).map(|(left, right)| left - right);
            entries.find(|entry| entry.symbols_of().contains(&sought()))
        }
        _ => None,
    }
}

/// The values of the unknown term in the paper's letters, on the motion and by each equation of motion.
fn missing(kind: Kind, difference: Sym, letters: &Letters<'_, '_>, probe: &Probe<'_, '_>) -> Vec<Sym> {
    let sought = sought();
    // if the term stands in a denominator, the numerator of the difference is linear in it
    let is_below = difference.diff(sought).symbols_of().contains(&sought);
    let over_one = || normal(difference, &Hypotheses::none()).map_or(difference, |form| form.numerator());
    let difference = if is_below { over_one() } else { difference };
    let plain = difference.substitute(&[(sought, Sym::ZERO)]);
    let slope = difference.diff(sought);
    if slope == Sym::ZERO || slope.symbols_of().contains(&sought) {
        return Vec::new();
    }
    let motion = probe.motion();
    let there = motion.reduced(slope);
    let along = || (motion.reduced(plain), there);
    let residuals: Vec<(Sym, Sym)> = match (kind, probe.linear()) {
        (Kind::LinearisedEquation, Some(linear)) => {
            linear_residuals(plain, letters, linear).into_iter().map(|residual| (residual, there)).collect()
        }
        (Kind::EquationOfMotion, _) => {
            let of_equations = residuals(plain, letters).into_iter().map(|residual| (residual, slope));
            std::iter::once(along()).chain(of_equations).collect()
        }
        _ => vec![along()],
    };
    let mut found: Vec<Sym> = Vec::new();
    for (residual, slope) in residuals {
        let Ok(form) = normal(-residual / slope, &motion.hypotheses) else { continue };
        // unchanged, or by letters that denote more than one symbol
        let ways = [vec![form.to_sym()], by_dependent_rates(form.to_sym(), motion)].concat();
        for own in ways.into_iter().flat_map(|way| ways_to_tell(letters, way, &motion.hypotheses)) {
            let Ok(own) = normal(own, &Hypotheses::none()).map(|form| form.to_sym()) else { continue };
            if !found.contains(&own) {
                found.push(own);
            }
        }
    }
    found
}

/// A term as a multiple of a speed, or of its square, that the constraints give by others: `m y'` rather than `m x' tan(psi)`.
fn by_dependent_rates(term: Sym, motion: &Motion<'_, '_>) -> Vec<Sym> {
    let dependent = motion.replaced().into_iter().filter(|symbol| motion.trace.speeds.contains(symbol));
    let powers = dependent.flat_map(|speed| [speed, speed * speed]);
    let ratios = powers.filter_map(|power| {
        let value = motion.reduced(power);
        let ratio = normal(term / value, &motion.hypotheses).ok().filter(|_| value != Sym::ZERO)?.to_sym();
        let is_plainer = ratio.symbols_of().len() < term.symbols_of().len();
        let moves = ratio.symbols_of().iter().any(|symbol| motion.trace.speeds.contains(symbol));
        (is_plainer && !moves).then(|| ratio * power)
    });
    ratios.collect()
}

/// The differences between a printed equation and multiples of the equations of motion.
fn residuals(plain: Sym, letters: &Letters<'_, '_>) -> Vec<Sym> {
    let trace = letters.trace;
    let mut all = Vec::new();
    let moves = (0..trace.accelerations.len()).any(|j| trace.by_acceleration(plain, j) != Sym::ZERO);
    for (equation, row) in equations_with_inertia(letters) {
        // without accelerations, the lost term may be the inertia term
        if !moves {
            all.extend([plain - equation, plain + equation]);
        }
        for (j, &entry) in row.iter().enumerate().filter(|(_, entry)| **entry != Sym::ZERO) {
            let factor = trace.by_acceleration(plain, j) / entry;
            if factor != Sym::ZERO {
                all.push(plain - factor * equation);
            }
        }
    }
    all
}

/// The differences between a printed linear equation and multiples of the linearised equations of motion.
fn linear_residuals(plain: Sym, letters: &Letters<'_, '_>, linear: &Linearisation<'_, '_>) -> Vec<Sym> {
    let trace = letters.trace;
    let printed = linear.form(plain);
    let mut all = Vec::new();
    for (equation, _) in equations_with_inertia(letters) {
        let equation = linear.form(equation);
        if trace.accelerations.iter().all(|&acceleration| printed.diff(acceleration) == Sym::ZERO) {
            all.extend([printed - equation, printed + equation]);
        }
        for &acceleration in &trace.accelerations {
            let entry = equation.diff(acceleration);
            let factor = if entry == Sym::ZERO { Sym::ZERO } else { printed.diff(acceleration) / entry };
            if factor != Sym::ZERO {
                all.push(printed - factor * equation);
            }
        }
    }
    all
}

/// The equations of motion as expressions that vanish, each with its row of the mass matrix.
fn equations_with_inertia(letters: &Letters<'_, '_>) -> Vec<(Sym, Vec<Sym>)> {
    let trace = letters.trace;
    let Equations { mass, bias, constraints } = Equations::of(trace);
    let of = |(k, row): (usize, Vec<Sym>)| {
        let inertia = row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
        (constraints.iter().fold(inertia, |sum, one| sum - one.multiplier * one.row[k]), row)
    };
    mass.into_iter().enumerate().map(of).collect()
}

/// The number of terms of a sum in a text.
pub(super) fn count(text: &str) -> usize {
    1 + text.matches(" + ").count() + text.matches(" - ").count()
}

pub(super) fn sought() -> Sym {
    Sym::symbol("sought term")
}

/// The value of the letter of the unknown term from an expression that is zero; `None` if the expression is not linear in the letter.
pub(super) fn solved(zero: Sym) -> Option<Sym> {
    let slope = zero.diff(sought());
    let is_linear = slope != Sym::ZERO && !slope.symbols_of().contains(&sought());
    is_linear.then(|| -zero.substitute(&[(sought(), Sym::ZERO)]) / slope)
}

/// The value of the letter of the unknown term in a claim, on the motion.
pub(super) fn lack(statement: &Statement, letters: &Letters<'_, '_>, probe: &Probe<'_, '_>) -> Option<Sym> {
    let motion = probe.motion();
    let value = motion.reduced(solved(sought_difference(statement, letters)?)?);
    normal(value, &motion.hypotheses).ok().map(|form| form.to_sym())
}

/// The meanings of the paper's letters and of the letter of the unknown term.
pub(super) struct Sought<'a, 't, 'm>(pub &'a Letters<'t, 'm>);

impl Meaning for Sought<'_, '_, '_> {
    fn letter(&self, name: &str) -> Option<Value> {
        if name == SOUGHT { Some(Value::Scalar(sought())) } else { self.0.in_model().letter(name) }
    }

    fn rate(&self, of: Sym) -> Result<Sym, String> {
        self.0.in_model().rate(of)
    }

    fn partial(&self, of: Sym, by: Sym) -> Result<Sym, String> {
        self.0.in_model().partial(of, by)
    }

    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        self.0.in_model().circle(angle)
    }
}
