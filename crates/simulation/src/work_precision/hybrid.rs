//! Scenes whose law changes at events: every method across the same events.

use super::atlas::Observed;
use super::configuration::Configuration;
use crate::references::{Exact, Owner, Unknown};
use integrators::Reference;
use std::time::Duration;

/// A scene whose law changes at events.
pub trait Hybrid {
    /// The motion to all digits, each of two methods in half of the time.
    ///
    /// # Errors
    /// Why the motion is not known.
    fn exact(&self, allowed: Duration) -> Result<Exact, Unknown>;

    /// The owner of its reference.
    fn owner(&self) -> Box<dyn Owner + '_>;

    /// The configuration that runs law after law, by any method.
    fn way(&self) -> Configuration;

    /// The columns of [`Self::way`] that are compared, with their sizes along the motion.
    fn observed(&self, columns: &[String], reference: &Reference) -> Vec<Observed>;

    /// The end of the run, s.
    fn end(&self) -> f64;
}
