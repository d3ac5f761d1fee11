//! Ensembles: one scene many times, with data and starts that differ, run side by side.
//!
//! # Overview
//! * [`EnsembleScene`]: a scene with a table `[ensemble]`, which lists the data that vary;
//! * [`parametric_system`]: the interface of a scene to an ensemble: names of the numbers that may vary, a law with a symbol for each,
//!   members;
//! * [`vary`], [`draw`]: the distributions, and random numbers that depend on seed, member and datum alone;
//! * [`run`]: all members in lanes and threads; [`batch_series()`]: the series of a recurrence in lanes;
//! * [`fingerprint`]: the data that decide a member, by which rows of different ensembles are distinguished.

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

/// A scene with many members, which are run.
#[derive(Clone, Debug)]
pub struct EnsembleScene {
    pub system: Arc<dyn ParametricSystem>,
    pub members: u64,
    seed: u64,
    varied: Vec<Varied>,
}

/// The law of a system has more quantities than members side by side have room for.
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
    /// [`TooLong`].
    pub fn new(system: Arc<dyn ParametricSystem>, variation: Variation) -> Result<Self, TooLong> {
        let Variation { members, seed, varied } = variation;
        // the number of quantities does not depend on the order
        if system.alone().is_none() {
            system.series(integrators::batch_order(1.0)).ok_or(TooLong)?;
        }
        Ok(EnsembleScene { system, members, seed, varied })
    }

    /// A member.
    ///
    /// # Errors
    /// Why there is no such member.
    pub fn member(&self, number: u64) -> Result<Member<'_>, Stopped> {
        self.system.member(&self.numbers(number)?)
    }

    /// The failures of a member, as its single run shows them; `goes_on` breaks that off.
    pub fn failures(&self, number: u64, goes_on: &dyn Fn() -> bool) -> Vec<RunFailure> {
        self.numbers(number).map_or_else(|_| Vec::new(), |drawn| self.system.failures(&drawn, goes_on))
    }

    /// The numbers of a member, all finite.
    fn numbers(&self, number: u64) -> Result<Vec<Drawn>, Stopped> {
        let drawn: Vec<Drawn> = self.varied.iter().map(|varied| varied.drawn(self.seed, number)).collect();
        for (varied, Drawn { numbers, .. }) in self.varied.iter().zip(&drawn) {
            if numbers.iter().any(|x| !x.is_finite()) {
                return Err(Stopped::NotFinite { datum: varied.name.clone() });
            }
        }
        Ok(drawn)
    }

    /// The numbers of a member that vary, in the order of the columns.
    pub fn drawn(&self, number: u64) -> Vec<f64> {
        self.varied.iter().flat_map(|varied| varied.drawn(self.seed, number).numbers).collect()
    }
}
