//! The choice of principal axes for the equations of a gyrostat.

use std::fmt;
use std::str::FromStr;

/// The body whose principal axes the equations use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Axes {
    /// Axes of body A: the paper's first form.
    #[default]
    First,
    /// Axes of body A*: the paper's second form.
    Second,
}

impl fmt::Display for Axes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::First => "first",
            Self::Second => "second",
        })
    }
}

impl FromStr for Axes {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "first" => Ok(Self::First),
            "second" => Ok(Self::Second),
            _ => Err("`first` (axes of A) or `second` (axes of A*) is accepted".to_owned()),
        }
    }
}
