//! Certificates: the data by which a second program repeats the proof of a verdict without trust in this program.
//!
//! A [`Certificate`] contains expressions as they were before simplification, in one straight-line
//! program. Each of its [`Part`]s states a result: the relations `then` follow from the relations `given`, or fail at an
//! exact point. `verify/` is such a second program, in another language; it shares no code with this one.

mod of_claim;
mod part;
mod program;

pub use part::{Combined, Minimum, PartProof, Product, Relation, Relations, Stability, Step};
pub use program::{Operation, Recorder};

use crate::{Judged, Verdict};
use serde::Serialize;

/// The version of the format; every change of the format increases it.
pub const FORMAT: u32 = 1;

/// The file with the certificates of a paper.
#[derive(Clone, Debug, Serialize)]
pub struct CertificateFile {
    /// The program with its version.
    pub made_by: String,
    /// The version of the format, [`FORMAT`].
    pub format: u32,
    /// The key of the paper, the first part of the ids of its claims.
    pub paper: String,
    pub title: String,
    pub citation: String,
    pub claims: Vec<Certificate>,
}

/// The certificate of a claim, or the reason for which there is none.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Certificate {
    pub id: String,
    pub says: String,
    /// The formulas as text, for human readers only.
    pub formulas: Vec<String>,
    pub verdict: String,
    /// The proof of the verdict as a sentence.
    pub evidence: String,
    /// Divisors and hypotheses as in the ledger, for human readers only.
    pub requires: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub program: Vec<Operation>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<Part>,
    /// The reason for which this verdict has no certificate; `None` with a certificate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub none: Option<String>,
}

/// A result with its proof. Numbers are indices of entries of the program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// The premises.
    pub given: Vec<Relation>,
    /// Successive consequences of equalities in `given`: values of letters, and powers of letters replaced by lower ones.
    pub steps: Vec<Step>,
    /// Pairs of a letter and its time derivative, where a conclusion is about a time derivative.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rates: Vec<(usize, usize)>,
    pub then: Vec<Relation>,
    pub proof: PartProof,
}

impl Certificate {
    /// The claim with its verdict, without a proof yet.
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

    /// Whether the claim belongs to the paper with this key.
    pub fn is_of(&self, paper: &str) -> bool {
        self.id.split('/').next() == Some(paper)
    }

    /// The certificate with these parts, or with the reason `otherwise` where there are no parts.
    pub fn proved_by(self, program: Vec<Operation>, parts: Vec<Part>, otherwise: &str) -> Self {
        match parts.is_empty() {
            true => Certificate { none: Some(otherwise.to_owned()), ..self },
            false => Certificate { program, parts, ..self },
        }
    }

    /// The reason for which claims with this verdict have no certificate; `None` for other verdicts.
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
