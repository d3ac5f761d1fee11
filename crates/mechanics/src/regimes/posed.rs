//! The data of a state that determine its regimes.

use super::{Dry, Ordered, Sizes, Touch, Unfit, touches};
use crate::constrained::State;
use crate::constrained::contacts::Contacts;
use crate::definite::NotDefinite;
use field::Over;
use std::fmt;

/// The reason why a state has no regimes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unposed {
    /// A contact penetrates or collides.
    Contact(Unfit),
    /// The system's own constraints are dependent.
    Constraints(NotDefinite),
}

impl fmt::Display for Unposed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Contact(unfit) => unfit.fmt(f),
            Self::Constraints(dependent) => dependent.fmt(f),
        }
    }
}

impl std::error::Error for Unposed {}

/// The accelerations of the contacts under the system's force, and the state of each contact.
///
/// # Errors
/// [`Unposed`] where a contact is violated or collides, or constraints are dependent.
pub fn posed<Q, S, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
) -> Result<(Dry<S, K>, [Touch; K]), Unposed>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given> + Ordered,
{
    let touch = touches(system, at, Sizes::of(at)).map_err(Unposed::Contact)?;
    let dry = Dry::of(system, at, system.force(at)).map_err(Unposed::Constraints)?;
    Ok((dry, touch))
}
