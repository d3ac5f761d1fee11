//! The content of the workbench under one name: systems, motors, papers, theorems, studies.
//!
//! # Overview
//! * [`systems`]: mechanical systems, as data of bodies and laws of energy;
//! * [`machines`]: electric motors, each one file of energies and laws of force;
//! * [`papers`]: a paper a folder, its numbered equations as claims in the paper's own order and letters;
//! * [`theorems`]: the workbench's own theorems as claims;
//! * [`studies`]: steady motions, stability, numerical stability, model reduction.
//!
//! Tests of the whole repository stand beside this crate, in `tests/`.

pub use {machines, papers, studies, systems, theorems};

/// The examples of the book compile and hold.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../book/src/principles.md")]
    struct Principles;
    #[doc = include_str!("../book/src/verdicts.md")]
    struct Verdicts;
    #[doc = include_str!("../book/src/bounds.md")]
    struct Bounds;
}
