//! The project's own theorems, as pages of claims: the theorems on which the studies rest, and the equality of the
//! principles of mechanics.
//!
//! # Overview
//! * [`principles`]: the principles of mechanics give equal accelerations for every system;
//! * [`regimes`]: existence and uniqueness of motion with dry friction;
//! * [`stabilisation`]: constraint stabilisation with discrete time steps;
//! * [`stationary`], [`stability`]: all steady motions of a gyrostat with any motor, and their stability;
//! * [`numerical_stability`]: the stability of a method's one-step map compared with that of the motion;
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
