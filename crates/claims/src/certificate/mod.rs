//! Certificates: everything that a checker needs to repeat the proof of a verdict, as text and without trust in this program.
//!
//! A [`Certificate`] holds expressions as they were recorded, before anything was simplified, in one straight-line
//! program. Its [`Part`]s list what was shown: the relations of `then` follow from those of `given`, or fail at an
//! exact point. `verify/` is a checker in another language; it shares no code with this one.

mod of_claim;
mod part;
mod program;

pub use part::{Combined, Minimum, PartProof, Product, Relation, Relations, Stability, Step};
pub use program::{Operation, Recorder};

use crate::{Judged, Verdict};
use serde::Serialize;

/// The number of the format, which changes with it.
pub const FORMAT: u32 = 1;

/// The certificates of a paper: one file.
#[derive(Clone, Debug, Serialize)]
pub struct CertificateFile {
    /// The name and version of the program.
    pub made_by: String,
    /// [`FORMAT`].
    pub format: u32,
    /// The key of the paper, with which the ids of its claims begin.
    pub paper: String,
    pub title: String,
    pub citation: String,
    pub claims: Vec<Certificate>,
}

/// The certificate of a claim, or the reason why there is none.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Certificate {
    pub id: String,
    pub says: String,
    /// The formulas as text, for reading only.
    pub formulas: Vec<String>,
    pub verdict: String,
    /// The proof of the verdict, in a sentence.
    pub evidence: String,
    /// Divisors and hypotheses as the ledger lists them, for reading only.
    pub requires: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub program: Vec<Operation>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Part>,
    /// Why this verdict has no certificate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub none: Option<String>,
}

/// A statement with its proof; numbers are places in the program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// Relations that are presupposed.
    pub given: Vec<Relation>,
    /// Consequences of equalities of `given`, one after the other: values of letters, and powers that are rewritten.
    pub steps: Vec<Step>,
    /// The rates of letters that move, where a conclusion is about a rate.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rates: Vec<(usize, usize)>,
    pub then: Vec<Relation>,
    pub proof: PartProof,
}

impl Certificate {
    /// The claim with its verdict, still without a proof.
    pub fn for_claim(judged: &Judged) -> Self {
        Certificate {
            id: judged.id.clone(),
            says: judged.says.clone(),
            formulas: judged.text.clone(),
            verdict: judged.verdict.name().to_owned(),
            evidence: judged.evidence.clone(),
            requires: judged.requires.iter().chain(&judged.signs).map(|(text, _)| text.clone()).collect(),
            ..Certificate::default()
        }
    }

    /// Whether the claim is one of the paper with this key.
    pub fn is_of(&self, paper: &str) -> bool {
        self.id.split('/').next() == Some(paper)
    }

    /// The certificate with these parts, or with the reason `otherwise` where there are none.
    pub fn proved_by(self, program: Vec<Operation>, parts: Vec<Part>, otherwise: &str) -> Self {
        match parts.is_empty() {
            true => Certificate { none: Some(otherwise.to_owned()), ..self },
            false => Certificate { program, parts, ..self },
        }
    }

    /// The reason why claims with this verdict have no certificate; `None` for other verdicts.
    pub fn reason_without(verdict: Verdict) -> Option<&'static str> {
        match verdict {
            Verdict::Definition => Some("a definition makes no claim"),
            Verdict::Open => Some("the claim was not attempted"),
            Verdict::Undecided => Some("the claim was not decided"),
            Verdict::Refuted
            | Verdict::Undefined
            | Verdict::Proved
            | Verdict::Enclosed
            | Verdict::Identified
            | Verdict::Tested => None,
        }
    }
}
