//! Normal forms of expressions, and decisions by them.

mod convert;
mod decide;
mod enclosure;
mod failure;
mod fraction;
mod generators;
mod hypotheses;
mod identity;
mod kernel;
mod lowest;
mod normal;
mod reduce;
mod witness;

pub use decide::{Decision, Proof, decide, decide_modulo};
pub use enclosure::differs_from_zero;
pub use hypotheses::{Hypotheses, Refused};
pub use identity::{Identity, IdentityTest, identified};
pub use normal::{NormalForm, NotNormal, normal};
pub use witness::Witness;
