//! The content of the workbench under one name: systems, motors, papers, theorems, studies.
//!
//! # Overview
//! * [`systems`]: mechanical systems, as bodies and energies;
//! * [`machines`]: electric motors, each in one file of energies and force laws;
//! * [`papers`]: a folder for each paper, with its numbered equations as claims in the paper's order and notation;
//! * [`theorems`]: theorems of the workbench itself, as claims;
//! * [`studies`]: steady motions, stability, numerical stability, model reduction.
//!
//! The tests of the whole repository are in `tests/`.

pub use {machines, papers, studies, systems, theorems};

/// Compiles and runs the examples of the book as doc tests.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../book/src/principles.md")]
    struct Principles;
    #[doc = include_str!("../book/src/verdicts.md")]
    struct Verdicts;
    #[doc = include_str!("../book/src/bounds.md")]
    struct Bounds;
}
