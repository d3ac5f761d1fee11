//! A claim: a statement with the way to decide it.

use crate::{Condition, Proof, Verdict};
use symbolic::{Hypotheses, Sym};

/// One line of a paper's page.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Permanent: `paper/eqN/slug`.
    pub id: String,
    /// The paper's section.
    pub section: &'static str,
    /// The entry of the paper that it belongs to: `eq5.3`, `statement7`.
    pub equation: &'static str,
    /// The claim as a sentence; LaTeX between dollar signs.
    pub says: String,
    pub statement: Statement,
    /// The verdict that the author of the page expects; a test compares it with the verdict found.
    pub expected: Verdict,
    /// The corrected claim, where this one fails.
    pub correction: Option<Box<Claim>>,
    /// Why the print fails, where it does: the slip that explains it.
    pub why: String,
    /// The reading of a damaged or ambiguous text: the source's signs, the restored ones, and the reading that is judged.
    pub reading: String,
    /// Anything else a reader should know.
    pub note: String,
    /// The sentence says it all: no formula is shown.
    pub in_words: bool,
}

/// The statement that a claim makes.
#[derive(Clone, Debug)]
pub enum Statement {
    /// Introduces names and makes no claim.
    Definition(Vec<Line>),
    /// Equalities for all values within the hypotheses.
    Equations { lines: Vec<Line>, hypotheses: Hypotheses },
    /// An implication.
    Theorem(Theorem),
}

/// An equation of the paper beside the expression that was derived without it.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// From first principles: equals `left - right` where the paper is right.
    pub derived: Sym,
    /// As printed.
    pub left: Sym,
    /// As printed.
    pub right: Sym,
    /// The derived side is the value of `right` alone, and `left` only its name.
    pub names: bool,
}

impl Line {
    /// An equation `left = right`, where `derived` vanishes along the motion and should be `left - right`.
    pub fn equation(derived: Sym, left: Sym, right: Sym) -> Self {
        Line { derived, left, right, names: false }
    }

    /// A formula `name = right` whose value was derived.
    pub fn formula(derived: Sym, name: Sym, right: Sym) -> Self {
        Line { derived, left: name, right, names: true }
    }

    /// The paper's side in the comparison.
    pub fn printed(&self) -> Sym {
        if self.names { self.right } else { self.left - self.right }
    }

    /// The LaTeX of the claim as printed in the paper.
    pub fn latex(&self) -> String {
        format!("{} = {}", self.left.latex(), self.right.latex())
    }
}

/// An implication for all values: `then` follows from the conditions `given` and the rules.
#[derive(Clone, Debug)]
pub struct Theorem {
    pub given: Vec<Condition>,
    pub then: Vec<Condition>,
    /// Relations that hold throughout, such as |l| = 1.
    pub rules: Hypotheses,
    pub proof: Proof,
}
