//! Edits of one term that is lost: the missing terms exactly, where they are short.

use super::edit::Edit;
use super::letter_rates::{rates, ways_to_tell};
use super::places::Places;
use super::probe::Probe;
use crate::change::EditKind;
use crate::claim_text::Kind;
use crate::letters::Letters;
use latex::{Chain, Meaning, Statement, Value, read, value};
use model::equations::Equations;
use symbolic::{Hypotheses, Sym, normal};

/// Lost terms with more characters are no slip of a print.
const SHORT: usize = 90;

/// The letter that stands for the term that is looked for.
const SOUGHT: &str = r"\aleph";

/// The terms that each sum lacks, where that is so many short terms of the paper's letters at most; in an integral also a letter.
pub(super) fn lost(
    kind: Kind,
    places: &Places,
    text: &str,
    letters: &Letters<'_, '_>,
    probe: &Probe<'_, '_>,
    most: usize,
) -> Vec<Edit> {
    let mut all: Vec<Edit> = Vec::new();
    let mut known = letters.spelt();
    if known.iter().any(|name| name == SOUGHT) {
        return all;
    }
    known.push(SOUGHT.to_owned());
    for sum in &places.sums {
        let behind = text[sum.end..].trim_start();
        let may_follow =
            behind.is_empty() || behind.starts_with([')', ']', '}', '=', '&']) || behind.starts_with(r"\right");
        if !may_follow || &text[sum.clone()] == "0" {
            continue;
        }
        let terms: Vec<(&str, String)> = match kind {
            Kind::IntegralOfMotion if most == 1 => {
                let plain = rates(letters).into_iter().filter(|rate| rate.order == 0);
                plain.flat_map(|rate| [("+", rate.latex.clone()), ("-", rate.latex)]).collect()
            }
            _ => {
                let with = format!("{}+{SOUGHT}{}", &text[..sum.end], &text[sum.end..]);
                let read = read(&with, &known).ok().and_then(|statement| one_difference(&statement, letters));
                read.map_or_else(Vec::new, |zero| missing(kind, zero, letters, probe, most))
                    .into_iter()
                    .map(signed)
                    .collect()
            }
        };
        for (sign, latex) in terms {
            let words = format!("the lost term `{sign} {latex}`");
            let edit =
                Edit { kind: EditKind::LostTerm, span: sum.end..sum.end, after: format!(" {sign} {latex}"), words };
            if !all.contains(&edit) {
                all.push(edit);
            }
        }
    }
    all.sort_by_key(|edit| edit.after.len());
    all
}

/// A term with its sign in LaTeX; several of them in parentheses.
fn signed(term: Sym) -> (&'static str, String) {
    match (term.to_string().starts_with('-'), count(&term.to_string())) {
        (true, 1) => ("-", (-term).latex()),
        (false, 1) => ("+", term.latex()),
        _ => ("+", format!(r"\left({}\right)", term.latex())),
    }
}

/// The difference of the two sides over the model.
fn one_difference(statement: &Statement, letters: &Letters<'_, '_>) -> Option<Sym> {
    let [Chain { sides, .. }] = &statement.chains[..] else { return None };
    let [left, right] = &sides[..] else { return None };
    let meaning = Sought(letters);
    match (value(left, &meaning).ok()?, value(right, &meaning).ok()?) {
        (Value::Scalar(left), Value::Scalar(right)) => Some(left - right),
        _ => None,
    }
}

/// The value that the sought term must have, in the paper's letters: by the motion, and by each equation of motion.
fn missing(kind: Kind, difference: Sym, letters: &Letters<'_, '_>, probe: &Probe<'_, '_>, most: usize) -> Vec<Sym> {
    let sought = sought();
    let plain = difference.substitute(&[(sought, Sym::ZERO)]);
    let slope = difference.diff(sought);
    if slope == Sym::ZERO || slope.symbols_of().contains(&sought) {
        return Vec::new();
    }
    let motion = probe.motion();
    let mut residuals = vec![motion.reduced(plain)];
    if kind == Kind::EquationOfMotion {
        let trace = letters.trace;
        let Equations { mass, bias, constraints } = Equations::of(trace);
        for (k, row) in mass.iter().enumerate() {
            let inertia = row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
            let equation = constraints.iter().fold(inertia, |sum, one| sum - one.multiplier * one.row[k]);
            for (j, &entry) in row.iter().enumerate().filter(|(_, entry)| **entry != Sym::ZERO) {
                let factor = trace.by_acceleration(plain, j) / entry;
                if factor != Sym::ZERO {
                    residuals.push(plain - factor * equation);
                }
            }
        }
    }
    let mut found: Vec<Sym> = Vec::new();
    for residual in residuals {
        let Ok(form) = normal(-residual / slope, &motion.hypotheses) else { continue };
        // as it is, or by a letter that stands for more than one symbol
        let told = ways_to_tell(letters, form.to_sym());
        for own in told {
            let Ok(own) = normal(own, &Hypotheses::none()).map(|form| form.to_sym()) else { continue };
            let text = own.to_string();
            if own != Sym::ZERO && text.chars().count() <= SHORT && count(&text) <= most && !found.contains(&own) {
                found.push(own);
            }
        }
    }
    found
}

/// The number of terms of a sum, as it is written.
fn count(text: &str) -> usize {
    1 + text.matches(" + ").count() + text.matches(" - ").count()
}

fn sought() -> Sym {
    Sym::symbol("sought term")
}

/// The letters of the paper, and the one that is sought.
struct Sought<'a, 't, 'm>(&'a Letters<'t, 'm>);

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
