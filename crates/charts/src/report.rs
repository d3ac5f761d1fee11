//! The contents of a report page, as plain data.
//!
//! In comments on fields, *text* means prose that may contain LaTeX between dollar signs; *LaTeX* means one displayed formula without them.

use crate::{Areas, Sphere, Timings, Trajectory, Verdict, WorkPrecision};

/// The content of the whole page, in the order of the page.
#[derive(Clone, Debug, Default)]
pub struct Report {
    pub title: String,
    /// One paragraph of text: the examined statements and the results.
    pub summary: String,
    /// The program with its version, for the last line and for the generator in the head of the page.
    pub generated_by: String,
    pub papers: Vec<PaperSection>,
    pub scenes: Vec<SceneSection>,
    pub spheres: Vec<Sphere>,
    /// Maps of the stability of steady motions.
    pub stability: Vec<Areas>,
    /// Errors of approximations.
    pub approximations: Vec<Trajectory>,
    /// Comparisons that are neither claims nor scenes.
    pub studies: Vec<Study>,
    /// Maps of the determinacy of motion with friction.
    pub friction: Vec<Areas>,
    /// Runs across stick, slip and detachment.
    pub rough: Vec<SceneSection>,
    pub timings: Vec<Timings>,
    /// The text in place of missing timings; empty where none are missing.
    pub timings_missing: String,
}

impl Report {
    /// The number of claims of all papers with this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.papers.iter().map(|paper| paper.count(verdict)).sum()
    }
}

/// The ledger of one paper.
#[derive(Clone, Debug, Default)]
pub struct PaperSection {
    /// A short identifier without spaces, such as `doe2024`, for links.
    pub id: String,
    pub title: String,
    /// Authors, journal, year, as text.
    pub citation: String,
    pub summary: String,
    /// The claims in the order of the paper; claims of one section are adjacent.
    pub claims: Vec<ClaimRow>,
}

impl PaperSection {
    /// The number of claims of this paper with this verdict; corrections are not counted.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.claims.iter().filter(|claim| claim.verdict == verdict).count()
    }

    /// The claims of each section, in the order of the paper.
    pub fn groups(&self) -> impl Iterator<Item = &[ClaimRow]> {
        self.claims.chunk_by(|a, b| a.section == b.section)
    }
}

/// One row of a ledger, or the correction of one.
#[derive(Clone, Debug, Default)]
pub struct ClaimRow {
    /// The permanent identifier of the claim: `paper/eqN/slug`.
    pub id: String,
    /// The number of the formula as printed: `(5.3)`; empty where the paper gives none.
    pub equation_label: String,
    /// The heading of the section of the paper that contains the claim, as text; empty where there is none.
    pub section: String,
    /// The title, as text.
    pub title: String,
    pub verdict: Verdict,
    /// The statement, as displayed formulas in LaTeX.
    pub latex: Vec<String>,
    /// All assumptions, as texts: hypotheses, divisors that must not vanish, signs.
    pub requires: Vec<String>,
    /// The evidence for the verdict, as text.
    pub evidence: String,
    /// The point at which the claim fails: the name and the exact value of each letter, as texts.
    pub counterexample: Vec<(String, String)>,
    /// Left side minus right side, in LaTeX.
    pub difference: Option<String>,
    /// The corrected statement, with its own verdict.
    pub correction: Option<Box<ClaimRow>>,
    /// The reason for which the printed statement fails, as text; empty where it holds.
    pub why: String,
    /// The chosen reading of a damaged or ambiguous print, as text; empty where the printed formula is unambiguous.
    pub reading: String,
    /// Further remarks, as text; empty where there are none.
    pub note: String,
}

/// A scene: one system with one set of parameters, run by every method.
#[derive(Clone, Debug, Default)]
pub struct SceneSection {
    /// A short identifier without spaces, for links.
    pub id: String,
    pub title: String,
    pub description: String,
    pub parameters: Vec<Parameter>,
    /// The results of the run as names and values (texts): invariants, work, model.
    pub facts: Vec<(String, String)>,
    /// Further tables.
    pub tables: Vec<Table>,
    pub trajectory: Option<Trajectory>,
    /// Work-precision charts, usually two: errors over evaluations and over time.
    pub work: Vec<WorkPrecision>,
    pub note: String,
}

/// A parameter of a scene.
#[derive(Clone, Debug, Default)]
pub struct Parameter {
    /// The symbol, as text such as `$A_1$`.
    pub symbol: String,
    pub value: String,
    /// The unit, as text; empty for a pure number.
    pub unit: String,
    pub meaning: String,
}

/// A study of one question: pictures over planes, and tables.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// The identifier in links, unique on the page.
    pub id: String,
    pub title: String,
    /// The introduction, as text.
    pub lead: String,
    /// The motion over time, if the study has one.
    pub run: Option<Trajectory>,
    pub pictures: Vec<Areas>,
    pub tables: Vec<Table>,
    /// The text below the pictures and tables.
    pub note: String,
}

/// A table of texts. Columns whose entries are all numbers are set flush right.
#[derive(Clone, Debug, Default)]
pub struct Table {
    pub caption: String,
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}
