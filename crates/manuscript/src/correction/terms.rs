//! Edits of one term: one that is lost, one that is superfluous.

use super::edit::Edit;
use super::exchanges::told;
use super::places::Places;
use super::probe::Probe;
use crate::change::EditKind;
use crate::claim_text::Kind;
use crate::letters::Letters;
use latex::{Chain, Meaning, Statement, Value, read, value};
use model::equations::Equations;
use symbolic::{Hypotheses, Sym, normal};

/// A lost term with more characters is no slip of a print.
const SHORT: usize = 90;

/// The letter that stands for the term that is looked for.
const SOUGHT: &str = r"\aleph";

/// Each term away that is not alone in its sum.
pub(super) fn superfluous(places: &Places, text: &str) -> Vec<Edit> {
    let mut all = Vec::new();
    for (place, summand) in places.summands.iter().enumerate().filter(|(_, summand)| summand.count > 1) {
        let start = summand.sign.map_or(summand.span.start, |(at, _)| at);
        let mut span = start..summand.span.end;
        // the sign behind the first term goes with it, where it is a plus
        let next = (summand.number == 1).then(|| places.summands[place + 1..].iter().find(|next| next.number == 2));
        if let Some((at, '+')) = next.flatten().and_then(|next| next.sign) {
            span.end = at + 1;
        }
        let words = format!("no `{}`, which is {}", &text[summand.span.clone()], told(summand, text));
        all.push(Edit { kind: EditKind::ExtraTerm, span, after: String::new(), words });
    }
    all
}

/// The term that each sum lacks, where it is one short term of the paper's letters.
pub(super) fn lost(
    kind: Kind,
    places: &Places,
    text: &str,
    letters: &Letters<'_, '_>,
    probe: &Probe<'_, '_>,
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
        let with = format!("{}+{SOUGHT}{}", &text[..sum.end], &text[sum.end..]);
        let Some(difference) = read(&with, &known).ok().and_then(|statement| one_difference(&statement, letters))
        else {
            continue;
        };
        for term in missing(kind, difference, letters, probe) {
            let (sign, latex) = match term.to_string().starts_with('-') {
                true => ("-", (-term).latex()),
                false => ("+", term.latex()),
            };
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

/// What the sought term must be, in the paper's letters: by the motion, and by each equation of motion.
fn missing(kind: Kind, difference: Sym, letters: &Letters<'_, '_>, probe: &Probe<'_, '_>) -> Vec<Sym> {
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
        let own = letters.told(form.to_sym());
        let Ok(own) = normal(own, &Hypotheses::none()).map(|form| form.to_sym()) else { continue };
        let text = own.to_string();
        let is_one_term = !text.contains(" + ") && !text.contains(" - ");
        if own != Sym::ZERO && text.chars().count() <= SHORT && is_one_term && !found.contains(&own) {
            found.push(own);
        }
    }
    found
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
