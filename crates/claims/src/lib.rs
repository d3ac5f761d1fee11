//! Claims of papers, and the verdict that the program finds for each.
//!
//! # Overview
//! This crate is for authors who check a paper in Rust. A [`Page`] lists the claims of a paper in its order and with its letters. A [`Claim`]
//! consists of a statement and the way to decide it. [`Claim::judge`] decides the claim by exact arithmetic alone and returns a [`Judged`] claim:
//! a [`Verdict`] with its evidence. The author states only an *expected* verdict, which a test compares with the verdict found.
//!
//! | statement | decided by |
//! |---|---|
//! | [`Line`]s: derived = printed, for all values | the normal form of the difference |
//! | [`Theorem`]: a conclusion follows from conditions | a [`Proof`]: normal form, combination, signs, or an exact point |
//! | definition | nothing: it makes no claim |
//!
//! Every claim is cross-examined ([`examine`]): its dimensions agree, its two sides are not the same expression, a mutated right
//! side is refuted, and its hypotheses can be satisfied. [`review`](mod@review) reports the terms that differ between two versions of a
//! page. With a [`certificate`] another program can repeat the proof of a verdict.
//!
//! # Example
//! ```
//! use dalembert_claims::{Line, Page, Verdict};
//! use field::Scalar;
//! use symbolic::{Dimension, Sym};
//!
//! let [m, v] = ["m", "v"].map(Sym::symbol);
//! let mut page = Page::of("textbook", |name| match name {
//!     "m" => Some(Dimension::of(1, 0, 0, 0)),
//!     "v" => Some(Dimension::of(0, 1, -1, 0)),
//!     _ => None,
//! });
//! // the derived side, here the derivative of m v^2/2 by v, and the right side as printed
//! let derived = (m * v * v).half().diff(v);
//! page.claim("eq1", "momentum", "the rate of the kinetic energy by the speed").holds([Line::equation(derived, m * v, Sym::ZERO)]);
//! page.claim("eq2", "momentum", "the rate of the kinetic energy by the speed, without the mass").fails([Line::equation(derived, v, Sym::ZERO)]);
//! let verdicts: Vec<Verdict> = page.judge().iter().map(|claim| claim.verdict).collect();
//! assert_eq!(verdicts, [Verdict::Proved, Verdict::Refuted]);
//! ```

pub mod alphabet;
pub mod catalogue;
pub mod certificate;
mod claim;
mod condition;
pub mod derivation;
pub mod examine;
pub mod finding;
mod judge;
mod ledger;
mod page;
mod paper;
mod premises;
mod proof;
pub mod review;
mod snapshot;
mod univariate;
mod verdict;

pub use catalogue::Catalogue;
pub use claim::{Claim, Line, Statement, Theorem};
pub use condition::{Condition, Point};
/// Registers a [`Catalogue`] of papers or a [`derivation::Derivation`], which is then found wherever the crate is linked.
pub use inventory::submit;
pub use judge::Judged;
pub use ledger::{Entry, entries};
pub use page::{Draft, Page};
pub use paper::Paper;
pub use proof::{Combination, Proof};
pub use snapshot::render;
pub use verdict::Verdict;

/// Re-exported for the functions that [`read_by!`] defines.
#[doc(hidden)]
pub use symbolic;
