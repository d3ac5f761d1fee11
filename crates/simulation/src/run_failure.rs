//! Failures of a run by standard names, common to all commands.
//!
//! A failure is detected where a run has stopped, or afterwards from its record, never during a step. Its evidence uses
//! the names of the scene. Its remedy is an option of the program or a key of the file.

use std::fmt;

/// A kind of failure of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FailureKind {
    SingularChart,
    SingularMassMatrix,
    DependentConstraints,
    Drift,
    Stiffness,
    UnstableStep,
    Zeno,
    Chattering,
    NoContactMode,
    SeveralContactModes,
    Jam,
    BlowUp,
    UnboundedGrowth,
    Pole,
    EndOfDomain,
    Overflow,
    MissedEvent,
}

impl FailureKind {
    /// Every kind that a run can show. Invalid input is reported by messages with positions in the file instead.
    pub const ALL: [Self; 17] = [
        Self::SingularChart,
        Self::SingularMassMatrix,
        Self::DependentConstraints,
        Self::Drift,
        Self::Stiffness,
        Self::UnstableStep,
        Self::Zeno,
        Self::Chattering,
        Self::NoContactMode,
        Self::SeveralContactModes,
        Self::Jam,
        Self::BlowUp,
        Self::UnboundedGrowth,
        Self::Pole,
        Self::EndOfDomain,
        Self::Overflow,
        Self::MissedEvent,
    ];

    /// The standard name.
    pub fn name(self) -> &'static str {
        match self {
            Self::SingularChart => "singular chart",
            Self::SingularMassMatrix => "singular mass matrix",
            Self::DependentConstraints => "loss of rank of the constraints",
            Self::Drift => "drift off the constraints",
            Self::Stiffness => "stiffness",
            Self::UnstableStep => "step beyond the stability limit",
            Self::Zeno => "Zeno: events accumulate",
            Self::Chattering => "chattering",
            Self::NoContactMode => "Painleve's paradox: no contact mode is consistent",
            Self::SeveralContactModes => "several contact modes are consistent",
            Self::Jam => "jam",
            Self::BlowUp => "blow-up in finite time",
            Self::UnboundedGrowth => "growth without bound",
            Self::Pole => "pole of the law",
            Self::EndOfDomain => "end of the domain of the law",
            Self::Overflow => "overflow in the law",
            Self::MissedEvent => "missed event",
        }
    }
}

impl FailureKind {
    /// Whether a run with this failure is wrong although it has reached its end.
    pub fn spoils(self) -> bool {
        self == Self::MissedEvent
    }
}

/// A failure of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunFailure {
    pub kind: FailureKind,
    /// The time of the failure, s.
    pub at: f64,
    /// The evidence: a sentence with place and numbers, without full stop.
    pub evidence: String,
    /// The remedy: an option or a key of the file, as a sentence without full stop.
    pub remedy: String,
}

impl fmt::Display for FailureKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for RunFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at t = {:.9} s: {}", self.kind, self.at, self.evidence)
    }
}
