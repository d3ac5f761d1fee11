//! The reason why a member stopped: its kind, by which members are counted, and the reason with its own numbers.

use integrators::Failure;
use std::fmt;

/// Why there is no such member, or why it stopped.
#[derive(Clone, Debug, PartialEq)]
pub enum Stopped {
    /// A drawn value is not finite.
    NotFinite { datum: String },
    /// Parts of a model that cannot exist, in words.
    Impossible(String),
    /// A start that cannot be completed so that the constraints hold, in words.
    Start(String),
    /// Data of the machine that are beyond their bounds, in words.
    Machine(String),
    /// The law does not hold any more.
    Left(&'static str),
    /// The run failed.
    Run(Failure),
}

/// The text between the kind and the reason; no kind contains it.
const BETWEEN: &str = ": ";

impl Stopped {
    /// The name of the kind, the same for all members of it.
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

    /// The kind in a text that [`Stopped`] was written as.
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
