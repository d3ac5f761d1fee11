//! The workbench's own pages of claims: theorems on which its studies rest, and the principles on every system.
//!
//! # Overview
//! * [`principles`]: the principles of mechanics, equal on every system;
//! * [`regimes`]: when motion with friction is determined;
//! * [`stabilisation`]: stabilised constraints in steps;
//! * [`stationary`], [`stability`]: all stationary motions of a gyrostat with any motor, and whether they are stable;
//! * [`numerical_stability`]: stability of a motion beside that of a method's steps on it;
//! * [`synchronism`]: a synchronous motor under load.

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
