//! A claim: a statement, and the way to decide it.

use crate::{Condition, Proof, Verdict};
use symbolic::{Hypotheses, Sym};

/// One claim of a paper's page.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The permanent identifier: `paper/eqN/slug`.
    pub id: String,
    /// The heading of the section of the paper.
    pub section: &'static str,
    /// The numbered equation or statement of the paper: `eq5.3`, `statement7`.
    pub equation: &'static str,
    /// The claim as a sentence; LaTeX between dollar signs.
    pub says: String,
    pub statement: Statement,
    /// The verdict that the author of the page expects; a test compares it with the verdict that the program finds.
    pub expected: Verdict,
    /// The corrected claim, for a claim that fails.
    pub correction: Option<Box<Claim>>,
    /// The reason for which the printed statement fails, such as the slip behind it; empty where it holds.
    pub why: String,
    /// The reading of a damaged or ambiguous text: the signs of the source, the restored signs, and the reading that is judged.
    pub reading: String,
    /// Further remarks.
    pub note: String,
    /// Whether the sentence `says` stands alone, without the formulas.
    pub in_words: bool,
}

/// The statement that a claim makes.
#[derive(Clone, Debug)]
pub enum Statement {
    /// A definition introduces names and claims nothing.
    Definition(Vec<Line>),
    /// Equalities for all values that the hypotheses allow.
    Equations { lines: Vec<Line>, hypotheses: Hypotheses },
    /// An implication.
    Theorem(Theorem),
}

/// An equation of the paper, with the expression derived independently of it.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// The expression derived from first principles; it equals `left - right` where the paper is correct.
    pub derived: Sym,
    /// The left side as printed.
    pub left: Sym,
    /// The right side as printed.
    pub right: Sym,
    /// Whether `left` is only a name, so that `derived` is compared with `right` alone.
    pub names: bool,
}

impl Line {
    /// An equation `left = right`, where `derived` vanishes along every motion and should equal `left - right`.
    pub fn equation(derived: Sym, left: Sym, right: Sym) -> Self {
        Line { derived, left, right, names: false }
    }

    /// A formula `name = right`, where `derived` should equal `right`.
    pub fn formula(derived: Sym, name: Sym, right: Sym) -> Self {
        Line { derived, left: name, right, names: true }
    }

    /// The printed expression that is compared with `derived`: `right` of a formula, otherwise `left - right`.
    pub fn printed(&self) -> Sym {
        if self.names { self.right } else { self.left - self.right }
    }

    /// The LaTeX of the claim as printed in the paper.
    pub fn latex(&self) -> String {
        format!("{} = {}", self.left.latex(), self.right.latex())
    }
}

/// An implication for all values: the conclusions `then` follow from the conditions `given` and the rules.
#[derive(Clone, Debug)]
pub struct Theorem {
    pub given: Vec<Condition>,
    pub then: Vec<Condition>,
    /// Equalities that always hold, such as |l| = 1.
    pub rules: Hypotheses,
    pub proof: Proof,
}
