//! The reason why a member stopped: its kind, by which members are counted, and a text with details.

use integrators::Failure;
use std::fmt;

/// The reason why a member does not exist, or why it stopped early.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// A drawn value is not finite.
    NotFinite { datum: String },
    /// The data describe bodies that cannot exist; the text gives the reason.
    Impossible(String),
    /// The start cannot be completed such that the constraints hold; the text gives the reason.
    Start(String),
    /// Data of the machine are outside their bounds; the text gives the reason.
    Machine(String),
    /// The law is no longer valid, for the given reason.
    Left(&'static str),
    /// The run failed.
    Run(Failure),
}

/// The separator between kind and details; no kind contains it.
const BETWEEN: &str = ": ";

impl Stopped {
    /// The name of the kind, equal for all members of that kind.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "a datum is not finite",
            Self::Impossible(_) => "no such bodies exist",
            Self::Start(_) => "no start meets the constraints",
            Self::Machine(_) => "no such machine exists",
            Self::Left(_) => "left its law",
            Self::Run(failure) => failure.name(),
        }
    }

    /// The kind in a text written by [`Stopped`].
    pub fn kind_in(text: &str) -> &str {
        text.split_once(BETWEEN).map_or(text, |(kind, _)| kind)
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{BETWEEN}", self.kind())?;
        match self {
            Self::NotFinite { datum } => write!(f, "`{datum}`"),
            Self::Impossible(reason) | Self::Start(reason) | Self::Machine(reason) => write!(f, "{reason}"),
            Self::Left(reason) => write!(f, "{reason}"),
            Self::Run(failure) => {
                // most failures begin with their name
                let told = failure.to_string();
                let reason = told.strip_prefix(failure.name()).unwrap_or(&told);
                write!(f, "{}", reason.trim_start_matches([':', ' ']))
            }
        }
    }
}
