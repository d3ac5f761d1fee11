//! Findings on the equations of another program, as text.

use super::differences::TermDifference;
use crate::display::factors;
use crate::equation::{Outcome, vanishes};
use crate::motion::Motion;
use crate::refutation::Refutation;
use claims::Verdict;
use model::Trace;
use model::equations::Characteristics;
use symbolic::{Hypotheses, Sym, normal};

/// The finding on an equation of the other program.
#[derive(Clone, Debug)]
pub struct PeerEquation {
    pub name: String,
    pub verdict: Verdict,
    /// The verdict as a sentence.
    pub sentence: String,
    /// The terms in which it differs from the model's equation along the same direction.
    pub terms: Vec<TermDifference>,
    /// The value of its left side with the model's accelerations inserted, as text and LaTeX; `None` if it is too long.
    pub left: Option<(String, String)>,
    /// An exact point at which the equation fails, as pairs of name and value.
    pub point: Vec<(String, String)>,
}

/// The finding on all equations of the other program.
#[derive(Clone, Debug)]
pub struct PeerFinding {
    pub verdict: Verdict,
    pub sentence: String,
    pub equations: Vec<PeerEquation>,
    /// The conditions that divisors do not vanish, as text and LaTeX.
    pub requires: Vec<(String, String)>,
}

/// The largest length of a printed expression in characters.
const READABLE: usize = 600;

/// The finding on an expression that should vanish along the motion `motion`; `along` also determines the accelerations.
pub(super) fn judged(
    name: String,
    zero: Sym,
    [motion, along]: [&Motion<'_, '_>; 2],
    zero_is: &str,
    terms: impl FnOnce() -> Vec<TermDifference>,
    requires: &mut Vec<Sym>,
) -> PeerEquation {
    let mut found = PeerEquation {
        name,
        verdict: Verdict::Proved,
        sentence: String::new(),
        terms: Vec::new(),
        left: None,
        point: Vec::new(),
    };
    match vanishes(motion, zero, &[]) {
        Outcome::Zero(divisors) => {
            requires.extend(divisors);
            found.sentence = format!("the normal form of {zero_is} is zero");
        }
        Outcome::Identified(why) => (found.verdict, found.sentence) = (Verdict::Identified, why),
        Outcome::Undecided(why) => (found.verdict, found.sentence) = (Verdict::Undecided, why),
        Outcome::Undefined(divisor) => {
            found.verdict = Verdict::Undefined;
            found.sentence = format!("it divides by {divisor}, which vanishes everywhere");
        }
        Outcome::NonZero(refutation) => {
            found.verdict = Verdict::Refuted;
            let left = motion.reduced(zero);
            let value = refutation.value(left).map_or_else(|| "not zero".to_owned(), |value| value.to_string());
            let formal = if refutation.is_formal {
                "; sines and cosines are taken there as independent of their angles"
            } else {
                ""
            };
            found.sentence = format!("at the exact point {zero_is} is {value}{formal}");
            found.point = point(&refutation, along);
            found.left = readable(left, motion);
            found.terms = terms();
        }
    }
    found
}

/// The degrees of freedom of both programs.
pub(super) struct Freedom {
    /// The degrees of freedom of the other program; `ours` are those of the model.
    pub theirs: usize,
    /// The number of undecided equations of the other program, each of which may be a constraint and remove a degree of freedom.
    pub open: usize,
    pub ours: usize,
}

/// The verdict on all equations, with a sentence.
pub(super) fn whole(found: &[PeerEquation], determined: bool, freedom: Freedom) -> (Verdict, String) {
    let with = |verdict: Verdict| {
        found.iter().filter(|one| one.verdict == verdict).map(|one| one.name.as_str()).collect::<Vec<_>>()
    };
    let refuted = with(Verdict::Refuted);
    let open: Vec<&str> = [with(Verdict::Undecided), with(Verdict::Undefined)].concat();
    let plural = |count: usize| if count == 1 { format!("{count} degree") } else { format!("{count} degrees") };
    if !refuted.is_empty() {
        return (
            Verdict::Refuted,
            format!(
                "they are other equations of motion: {} of {} do not hold along the motions of the model ({})",
                refuted.len(),
                found.len(),
                refuted.join(", ")
            ),
        );
    }
    if !open.is_empty() {
        return (Verdict::Undecided, format!("not decided: {}", open.join(", ")));
    }
    let Freedom { theirs, open, ours } = freedom;
    if theirs > ours && theirs - open.min(theirs) <= ours {
        let why = format!(
            "each of the equations holds along every motion of the model, but it was not decided which of them are constraints: they have up to {} of freedom, and the model {}",
            plural(theirs),
            plural(ours)
        );
        return (Verdict::Undecided, why);
    }
    if theirs != ours {
        return (
            Verdict::Refuted,
            format!(
                "they are other equations of motion: they have {} of freedom, and the model {}",
                plural(theirs),
                plural(ours)
            ),
        );
    }
    if !determined {
        let why = "each of the equations holds along every motion of the model, but they do not determine all accelerations: their matrix is singular at a random point of a prime field";
        return (Verdict::Undecided, why.to_owned());
    }
    match with(Verdict::Identified).is_empty() {
        true => (Verdict::Proved, "they are the same equations of motion: with the model's accelerations each of them vanishes, and they determine all accelerations".to_owned()),
        false => (Verdict::Identified, "they are the same equations of motion but for a small probability of error: each of them vanishes with the model's accelerations, and they determine all accelerations".to_owned()),
    }
}

/// A sentence on the speeds of the model that the other program's speeds do not determine.
pub(super) fn untold(trace: &Trace<'_>, free: &Characteristics, slopes: &[Vec<Sym>]) -> String {
    let is_told = |column: usize| slopes.iter().any(|row| row[column] != Sym::ZERO);
    let open: Vec<String> = free
        .independent
        .iter()
        .enumerate()
        .filter(|(column, _)| !is_told(*column))
        .map(|(_, &k)| format!("`{}`", trace.speeds[k]))
        .collect();
    let what = if open.is_empty() { "all speeds of the model".to_owned() } else { open.join(", ") };
    format!("the coordinates of the other program do not determine {what}")
}

/// An expression as text and LaTeX; `None` if it is too long.
pub(super) fn readable(expression: Sym, motion: &Motion<'_, '_>) -> Option<(String, String)> {
    let form = normal(expression, &motion.hypotheses).ok()?.to_sym();
    let text = form.to_string();
    (text.chars().count() <= READABLE).then(|| (text, form.latex()))
}

/// Names and exact values at a counterexample.
fn point(refutation: &Refutation, motion: &Motion<'_, '_>) -> Vec<(String, String)> {
    let mut listed: Vec<(String, String)> = Vec::new();
    let trace = motion.trace;
    let found = refutation.point.iter().copied();
    let determined = motion.replaced().into_iter().chain(trace.accelerations.iter().copied());
    let determined = determined.filter_map(|symbol| Some((symbol, refutation.value(motion.reduced(symbol))?)));
    for (symbol, value) in found.chain(determined) {
        let name = symbol.to_string();
        if value != symbol && listed.iter().all(|(known, _)| *known != name) {
            listed.push((name, value.to_string()));
        }
    }
    listed
}

/// The conditions that divisors do not vanish, each once.
pub(super) fn divisors(found: &[Sym]) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    for &divisor in found {
        let parts = normal(divisor, &Hypotheses::none()).map_or(vec![divisor], |form| factors(form.numerator()));
        for part in parts.into_iter().filter(|part| part.as_constant().is_none()) {
            let line = (format!("{part} != 0"), format!(r"{} \neq 0", part.latex()));
            if !all.contains(&line) {
                all.push(line);
            }
        }
    }
    all.sort_by_key(|(text, _)| (text.chars().count(), text.clone()));
    all
}
