//! Ensembles: many runs of one scene with varied data and starts, computed in batches.
//!
//! # Overview
//! * [`EnsembleScene`]: a scene with a table `[ensemble]`, which lists the data that vary;
//! * [`parametric_system`]: the interface of a scene to an ensemble: the names of the numbers that may vary, a law with
//!   a symbol for each of them, and the members;
//! * [`vary`], [`draw`]: distributions, and random numbers that depend only on seed, member and datum;
//! * [`run`]: the run of all members in batches and threads; [`batch_series()`]: Taylor series for a batch;
//! * [`fingerprint`]: identifies the data of an ensemble, so that rows of different ensembles are not mixed.

pub mod batch_series;
pub mod draw;
pub mod fingerprint;
mod member_end;
mod one_by_one;
pub mod parametric_system;
pub mod run;
mod stop_reason;
pub mod vary;

pub use batch_series::batch_series;
pub use fingerprint::Fingerprint;
pub use parametric_system::{
    BATCH_SIZE, Column, Drawn, Ended, IndividualMembers, Member, ParametricSystem, Shape, Sizes, Variable,
};
pub use run::{Last, Row};
pub use stop_reason::Stopped;

use crate::RunFailure;
use std::fmt;
use std::sync::Arc;
use vary::{Variation, Varied};

/// A scene with its ensemble of members.
#[derive(Clone, Debug)]
pub struct EnsembleScene {
    pub system: Arc<dyn ParametricSystem>,
    pub members: u64,
    seed: u64,
    varied: Vec<Varied>,
}

/// The error for a law that has more quantities than a batch supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

impl fmt::Display for TooLong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "its series has more quantities than a batch of members can hold")
    }
}

impl EnsembleScene {
    /// An ensemble of members of a system.
    ///
    /// # Errors
    /// [`TooLong`] where the law is too long for a batch.
    pub fn new(system: Arc<dyn ParametricSystem>, variation: Variation) -> Result<Self, TooLong> {
        let Variation { members, seed, varied } = variation;
        // the number of quantities does not depend on the order of the series
        if system.alone().is_none() {
            system.series(integrators::batch_order(1.0)).ok_or(TooLong)?;
        }
        Ok(EnsembleScene { system, members, seed, varied })
    }

    /// The member with a number, counted from one.
    ///
    /// # Errors
    /// [`Stopped`] with the reason why the member does not exist.
    pub fn member(&self, number: u64) -> Result<Member<'_>, Stopped> {
        self.system.member(&self.numbers(number)?)
    }

    /// The failures that a single run of a member reports; `goes_on` may stop the search.
    pub fn failures(&self, number: u64, goes_on: &dyn Fn() -> bool) -> Vec<RunFailure> {
        self.numbers(number).map_or_else(|_| Vec::new(), |drawn| self.system.failures(&drawn, goes_on))
    }

    /// The drawn numbers of a member, all finite.
    fn numbers(&self, number: u64) -> Result<Vec<Drawn>, Stopped> {
        let drawn: Vec<Drawn> = self.varied.iter().map(|varied| varied.drawn(self.seed, number)).collect();
        for (varied, Drawn { numbers, .. }) in self.varied.iter().zip(&drawn) {
            if numbers.iter().any(|x| !x.is_finite()) {
                return Err(Stopped::NotFinite { datum: varied.name.clone() });
            }
        }
        Ok(drawn)
    }

    /// The drawn numbers of a member, in the order of the columns.
    pub fn drawn(&self, number: u64) -> Vec<f64> {
        self.varied.iter().flat_map(|varied| varied.drawn(self.seed, number).numbers).collect()
    }
}
