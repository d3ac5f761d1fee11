//! The contents of a report page, as plain data.
//!
//! *Text* means prose that may hold LaTeX between dollar signs; *LaTeX* means one displayed formula without them.

use crate::{Areas, Sphere, Timings, Trajectory, Verdict, WorkPrecision};

/// The whole page, in the order in which it is read.
#[derive(Clone, Debug, Default)]
pub struct Report {
    pub title: String,
    /// One paragraph of text: the examined statements and the results.
    pub summary: String,
    /// The program and version that made the page, for the last line and the generator in the head.
    pub generated_by: String,
    pub papers: Vec<PaperSection>,
    pub scenes: Vec<SceneSection>,
    pub spheres: Vec<Sphere>,
    /// Maps of the stability of stationary motions.
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
    /// The text in the place of timings that are missing; empty where none are missing.
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
    /// Short and without spaces, such as `doe2024`: names the section in links.
    pub id: String,
    pub title: String,
    /// Authors, journal, year: text.
    pub citation: String,
    pub summary: String,
    /// The claims in the paper's order, so that those of one section follow each other.
    pub claims: Vec<ClaimRow>,
}

impl PaperSection {
    /// The number of the paper's claims with this verdict; corrections are not counted.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.claims.iter().filter(|claim| claim.verdict == verdict).count()
    }

    /// The claims by the paper's own sections, in their order.
    pub fn groups(&self) -> impl Iterator<Item = &[ClaimRow]> {
        self.claims.chunk_by(|a, b| a.section == b.section)
    }
}

/// One line of a ledger, or the correction of one.
#[derive(Clone, Debug, Default)]
pub struct ClaimRow {
    /// The permanent identifier: `paper/eqN/slug`.
    pub id: String,
    /// The paper's own number, as printed: `(5.3)`; empty where it has none.
    pub equation_label: String,
    /// The heading of the paper's section with the claim: text, empty where there is none.
    pub section: String,
    /// The title: text.
    pub title: String,
    pub verdict: Verdict,
    /// The statement: displayed formulas.
    pub latex: Vec<String>,
    /// All assumptions, as texts: hypotheses, divisors that must not vanish, signs.
    pub requires: Vec<String>,
    /// The evidence for the verdict: text.
    pub evidence: String,
    /// The point at which the claim fails: name (text) and exact value (text) of each letter.
    pub counterexample: Vec<(String, String)>,
    /// Left side minus right side: LaTeX.
    pub difference: Option<String>,
    /// The corrected statement, with its own verdict.
    pub correction: Option<Box<ClaimRow>>,
    /// The reason for which the printed statement fails: text, empty where it holds.
    pub why: String,
    /// The reading of a damaged or ambiguous text; empty where the print is unambiguous.
    pub reading: String,
    /// Anything else a reader should know: text, empty where there is nothing.
    pub note: String,
}

/// A scene: one system, one set of parameters, every method.
#[derive(Clone, Debug, Default)]
pub struct SceneSection {
    /// Short and without spaces: names the section in links.
    pub id: String,
    pub title: String,
    pub description: String,
    pub parameters: Vec<Parameter>,
    /// The run in a few lines, name and value (texts): invariants, work, model.
    pub facts: Vec<(String, String)>,
    /// Any further tables.
    pub tables: Vec<Table>,
    pub trajectory: Option<Trajectory>,
    /// Usually two: by evaluations and by time.
    pub work: Vec<WorkPrecision>,
    pub note: String,
}

/// A parameter of a scene.
#[derive(Clone, Debug, Default)]
pub struct Parameter {
    /// The symbol: text, such as `$A_1$`.
    pub symbol: String,
    pub value: String,
    /// The unit: text, empty for a pure number.
    pub unit: String,
    pub meaning: String,
}

/// Pictures over planes, and tables, about one question.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// The identifier in links, different for each study.
    pub id: String,
    pub title: String,
    /// The introduction: text.
    pub lead: String,
    /// The motion in time, where the study follows one.
    pub run: Option<Trajectory>,
    pub pictures: Vec<Areas>,
    pub tables: Vec<Table>,
    /// Text below.
    pub note: String,
}

/// A table of texts. Columns whose entries are all numbers are set flush right.
#[derive(Clone, Debug, Default)]
pub struct Table {
    pub caption: String,
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}
