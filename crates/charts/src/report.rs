//! Everything that a page shows, as plain data.
//!
//! *Text* means prose that may hold LaTeX between dollar signs; *LaTeX* means one displayed formula without them.

use crate::{Areas, Sphere, Timings, Trajectory, Verdict, WorkPrecision};

/// The whole page, in the order in which it is read.
#[derive(Clone, Debug, Default)]
pub struct Report {
    pub title: String,
    /// One paragraph of text: what was examined and what came out.
    pub summary: String,
    /// The maker of the page, for the last line and the generator that the head names: program and version.
    pub generated_by: String,
    pub papers: Vec<PaperSection>,
    pub scenes: Vec<SceneSection>,
    pub spheres: Vec<Sphere>,
    /// Where stationary motions are stable.
    pub stability: Vec<Areas>,
    /// Errors of approximations.
    pub approximations: Vec<Trajectory>,
    /// Comparisons that are neither claims nor scenes.
    pub studies: Vec<Study>,
    /// Where motion with friction is determined.
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
    /// In the paper's own order: those of one of its sections stand together.
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
    /// Permanent: `paper/eqN/slug`.
    pub id: String,
    /// The paper's own number, as printed: `(5.3)`; empty where it has none.
    pub equation_label: String,
    /// The heading of the paper's section with the claim: text, empty where there is none.
    pub section: String,
    /// Text.
    pub title: String,
    pub verdict: Verdict,
    /// The statement, a displayed formula each.
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
    /// Why the print fails: text, empty where it does not.
    pub why: String,
    /// The reading of a damaged or ambiguous text; empty where there was nothing to choose.
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
    /// Text: `$A_1$`.
    pub symbol: String,
    pub value: String,
    /// Text, empty for a pure number.
    pub unit: String,
    pub meaning: String,
}

/// Pictures over planes, and tables, about one question.
#[derive(Clone, Debug, Default)]
pub struct Study {
    /// As it may stand in a link; no two studies have the same.
    pub id: String,
    pub title: String,
    /// LaTeX between dollar signs.
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
