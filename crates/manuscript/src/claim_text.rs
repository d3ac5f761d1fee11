//! The claims of a paper's file, as text.

use crate::passage::{Passage, placed};
use claims::Verdict;
use latex::{Displayed, formulas};
use reader::{Issue, Table};
use std::collections::BTreeSet;
use std::ops::Range;
use units::nearest;

/// The kind of statement that a claim makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    EquationOfMotion,
    LinearisedEquation,
    Formula,
    Identity,
    Inequality,
    Equivalence,
    IntegralOfMotion,
    SteadyMotion,
    Stability,
    Number,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 10] = [
        Kind::EquationOfMotion,
        Kind::LinearisedEquation,
        Kind::Formula,
        Kind::Identity,
        Kind::Inequality,
        Kind::Equivalence,
        Kind::IntegralOfMotion,
        Kind::SteadyMotion,
        Kind::Stability,
        Kind::Number,
    ];

    /// The name of the kind in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EquationOfMotion => "equation of motion",
            Self::LinearisedEquation => "linearised equation",
            Self::Formula => "formula",
            Self::Identity => "identity",
            Self::Inequality => "inequality",
            Self::Equivalence => "equivalence",
            Self::IntegralOfMotion => "integral of motion",
            Self::SteadyMotion => "steady motion",
            Self::Stability => "stability",
            Self::Number => "number",
        }
    }

    /// The reason for which a verdict on a claim of this kind may have no certificate.
    pub(crate) fn without_certificate(self) -> &'static str {
        match self {
            Self::Number => "the verdict rests on a tie of the last printed digit, or on a number that is not real",
            Self::LinearisedEquation => {
                "the verdict rests on a free frame, for which the second checker has no steps yet"
            }
            Self::Inequality => {
                "the verdict rests on several rules at once, or on a point, for which the second checker has no steps yet"
            }
            Self::Stability => {
                "the verdict rests on several conditions of the roots, or on kept momenta, for which the second checker has no steps yet"
            }
            _ => {
                "the verdict rests on a root without a real value, or on a point where a value by the equations of motion divides by zero"
            }
        }
    }
}

/// A claim of a paper.
#[derive(Clone, Debug)]
pub struct ClaimText {
    /// The range of its table in the file, in bytes.
    pub at: Range<usize>,
    /// The number of the formula in the paper: `5`, `2.3a`.
    pub equation: String,
    /// A name that distinguishes several claims about one formula; may be empty.
    pub name: String,
    /// The claim as a sentence; may be empty.
    pub says: String,
    pub section: String,
    pub note: String,
    pub kind: Kind,
    /// The formula in LaTeX, as printed.
    pub formula: Passage,
    /// The faults of its table and of its formula. A claim with faults is not judged; the others are.
    pub faults: Vec<Issue>,
    /// The hypotheses in LaTeX.
    pub given: Vec<Passage>,
    /// The letters that are constant on a steady motion, in LaTeX.
    pub resting: Vec<Passage>,
    pub expected: Option<Verdict>,
}

impl ClaimText {
    /// Whether another claim is about the same steady motion.
    pub(crate) fn has_motion_of(&self, other: &Self) -> bool {
        let is_one = |own: &[Passage], others: &[Passage]| {
            let texts = |list: &[Passage]| list.iter().map(|one| one.text.replace(' ', "")).collect::<BTreeSet<_>>();
            texts(own) == texts(others)
        };
        let are_steady = [self, other].iter().all(|one| one.kind == Kind::SteadyMotion);
        are_steady
            && self.key() != other.key()
            && is_one(&self.resting, &other.resting)
            && is_one(&self.given, &other.given)
    }

    /// The last part of the claim's id: `eq5`, `eq5/sign`, or `power` for a claim without a number.
    pub fn key(&self) -> String {
        let plain: String =
            self.equation.chars().filter(|letter| !matches!(letter, '(' | ')') && !letter.is_whitespace()).collect();
        let prefix = if plain.starts_with(|letter: char| letter.is_ascii_digit()) { "eq" } else { "" };
        if self.name.is_empty() { format!("{prefix}{plain}") } else { format!("{prefix}{plain}/{}", self.name) }
    }
}

const NEEDED: &str = "[[claim]] in double brackets is accepted, since a paper has several";

/// All claims of a file, in its order.
pub fn claims(top: &mut Table<'_>, source: &str) -> Vec<ClaimText> {
    let mut all: Vec<ClaimText> = Vec::new();
    for mut table in top.tables("claim", NEEDED) {
        let at = table.span();
        let equation = table.text("equation", "number of the formula in the paper, such as \"5\" or \"2.3\"").value;
        let formula = table.text("formula", "formula in LaTeX as printed, in single quotes: '\\ddot{x} = -g'");
        let formula = Passage::of(&table, source, &formula);
        let mut text =
            |key: &str, needed: &str| table.optional_text(key, needed).map(|text| text.value).unwrap_or_default();
        let (name, says) = (
            text("name", "name that tells claims of one formula apart"),
            text("says", "sentence that the formula states"),
        );
        let (section, note) = (text("section", "section of the paper"), text("note", "remark for a reader"));
        let mut written = |key: &str, needed: &str| -> Vec<Passage> {
            let found = table.texts(key, needed);
            found.iter().map(|value| Passage::of(&table, source, value)).collect()
        };
        let given = written("given", "['\\dot{x} = 0', 'm > 0']");
        let resting = written("resting", "['\\theta', '\\dot{\\varphi}']");
        let kind = kind(&mut table);
        let expected = expected(&mut table);
        if matches!(kind, Some(Kind::SteadyMotion | Kind::Stability | Kind::LinearisedEquation)) && resting.is_empty() {
            let issue = Issue::at(at.clone(), "the letters that rest on the motion are not named", "no `resting` here");
            table.report(
                issue.accepted("resting = ['\\theta', '\\dot{\\varphi}']: letters and rates that are constant"),
            );
        }
        let faults = table.finish();
        // a claim of unknown kind has a fault and is not judged
        let kind = kind.unwrap_or(Kind::Formula);
        let claim =
            ClaimText { at, equation, name, says, section, note, kind, formula, faults, given, resting, expected };
        for mut claim in taken_apart(claim) {
            if let Some(other) = all.iter().find(|other| other.key() == claim.key()) {
                let title = format!("two claims have the name `{}`", other.key());
                let issue = Issue::at(claim.at.clone(), title, "the second one");
                claim.faults.push(issue.accepted("name = \"...\", which tells claims of one formula apart"));
            }
            all.push(claim);
        }
    }
    all
}

/// One claim for each formula of a display with several formulas.
fn taken_apart(claim: ClaimText) -> Vec<ClaimText> {
    let parts = match formulas(&claim.formula.text) {
        Ok(parts) => parts,
        Err(fault) => {
            let faults = [claim.faults, vec![placed(&claim.formula, fault)]].concat();
            return vec![ClaimText { faults, ..claim }];
        }
    };
    let of = |Displayed { name, text, start }: Displayed| {
        let names = [claim.name.as_str(), &name].into_iter().filter(|name| !name.is_empty());
        let name = names.collect::<Vec<_>>().join("/");
        ClaimText { name, formula: claim.formula.from(text, start), ..claim.clone() }
    };
    parts.into_iter().map(of).collect()
}

fn kind(table: &mut Table<'_>) -> Option<Kind> {
    let names: Vec<&str> = Kind::ALL.into_iter().map(Kind::name).collect();
    let needed = format!("kind of claim: {}", names.join(", "));
    let found = table.text("kind", &needed);
    let written = match found.value.as_str() {
        "formula for a quantity" => "formula",
        "if and only if" => "equivalence",
        other => other,
    };
    let kind = Kind::ALL.into_iter().find(|kind| kind.name() == written);
    if kind.is_none() && !found.value.is_empty() {
        let near = nearest(&found.value, names.iter().copied());
        let near = near.map_or_else(String::new, |near| format!("is `{near}` meant? "));
        let title = format!("no kind of claim is called `{}`", found.value);
        table.report(Issue::at(found.span, title, "not known").accepted(format!("{near}Known: {}", names.join(", "))));
    }
    kind
}

fn expected(table: &mut Table<'_>) -> Option<Verdict> {
    let found = table.optional_text("expect", "verdict that is expected: proved, enclosed or refuted")?;
    let accepted = [
        Verdict::Proved,
        Verdict::Enclosed,
        Verdict::Identified,
        Verdict::Refuted,
        Verdict::Undecided,
        Verdict::Undefined,
    ];
    let verdict = accepted.into_iter().find(|verdict| verdict.name() == found.value);
    if verdict.is_none() && !found.value.is_empty() {
        let title = format!("no verdict is called `{}`", found.value);
        table.report(
            Issue::at(found.span, title, "not known")
                .accepted("proved, enclosed, identified, refuted, undecided, undefined"),
        );
    }
    verdict
}
