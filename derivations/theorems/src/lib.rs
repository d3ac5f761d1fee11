//! The workbench's own theorems, as pages of claims: those on which its studies rest, and the equality of the principles.
//!
//! # Overview
//! * [`principles`]: the principles of mechanics, equal on every system;
//! * [`regimes`]: existence and uniqueness of motion with friction;
//! * [`stabilisation`]: constraint stabilisation under discretisation;
//! * [`stationary`], [`stability`]: all steady motions of a gyrostat with any motor, and their stability;
//! * [`numerical_stability`]: stability of a method's one-step map against that of the motion;
//! * [`synchronism`]: a synchronous motor under load.
//!
//! # Example
//! ```
//! let page = (dalembert_theorems::synchronism::PAPER.page)();
//! let judged = page.judge();
//! assert!(judged.iter().all(|claim| claim.verdict != claims::Verdict::Undecided));
//! ```

pub mod numerical_stability;
pub mod principles;
pub mod regimes;
pub mod stabilisation;
pub mod stability;
pub mod stationary;
pub mod synchronism;

claims::submit! {
    claims::Catalogue {
        name: "theorems",
        papers: &[
            &principles::PAPER,
            &regimes::PAPER,
            &stabilisation::PAPER,
            &stationary::PAPER,
            &numerical_stability::PAPER,
            &synchronism::PAPER,
            &stability::PAPER,
        ],
    }
}
