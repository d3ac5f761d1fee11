//! The axes in which the equations of a gyrostat are written.

use std::fmt;
use std::str::FromStr;

/// The principal axes in which the equations are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Axes {
    /// Axes of A: the paper's first form.
    #[default]
    First,
    /// Axes of A*: the second form.
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
