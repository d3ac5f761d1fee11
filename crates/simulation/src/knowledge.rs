//! Knowledge of a system beyond its equations, attached to files that ask for it by name.
//!
//! A crate submits a [`Knowledge`]; a file with the key `known_as` has its theory in every run. Other crates attach more under the same
//! name, such as smaller models.
//!
//! ```
//! use dalembert_simulation::knowledge::{Knowledge, submit};
//!
//! submit! { Knowledge {
//!     name: "pendulum",
//!     summary: "a point on a thread",
//!     parameters: &["l", "g"],
//!     columns: &["phi"],
//!     theory: |scene| {
//!         let [l, g] = ["l", "g"].map(|name| scene.value(name).unwrap_or(f64::NAN));
//!         vec![format!("small swings take {:.6} s", std::f64::consts::TAU * (l / g).sqrt())]
//!     },
//! } }
//! # fn main() {}
//! ```

pub use inventory::submit;

use crate::models::Modelled;

/// The knowledge of a system beside its equations.
#[derive(Debug)]
pub struct Knowledge {
    /// As files call it.
    pub name: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// The parameters that it reads, by their names in the file.
    pub parameters: &'static [&'static str],
    /// The states and outputs that it reads.
    pub columns: &'static [&'static str],
    /// Sentences of theory on the run, without the run.
    pub theory: fn(&dyn Modelled) -> Vec<String>,
}

inventory::collect!(Knowledge);

/// All that is known by some crate of the program, by name.
pub fn entries() -> Vec<&'static Knowledge> {
    let mut all: Vec<&Knowledge> = inventory::iter::<Knowledge>().collect();
    all.sort_by_key(|knowledge| knowledge.name);
    all
}
