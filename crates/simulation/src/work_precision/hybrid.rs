//! Work-precision for scenes whose law changes at events.

use super::atlas::Observed;
use super::configuration::Configuration;
use crate::references::{Exact, Owner, Unknown};
use integrators::Reference;
use std::time::Duration;

/// A scene whose law changes at events.
pub trait Hybrid {
    /// The reference solution; each of the two methods may take half of the time.
    ///
    /// # Errors
    /// [`Unknown`] with the reason why there is no reference.
    fn exact(&self, allowed: Duration) -> Result<Exact, Unknown>;

    /// The problem of the reference.
    fn owner(&self) -> Box<dyn Owner + '_>;

    /// The configuration that integrates across events.
    fn way(&self) -> Configuration;

    /// The columns of [`Self::way`] that are compared, with their sizes along the motion.
    fn observed(&self, columns: &[String], reference: &Reference) -> Vec<Observed>;

    /// The end of the run, s.
    fn end(&self) -> f64;
}
