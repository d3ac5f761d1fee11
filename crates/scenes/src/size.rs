//! Limits of size for the commands, checked before equations are derived.
//!
//! Equations with a mass matrix are sums over all bodies for each pair of speeds; work and memory grow with speeds squared times bodies. The
//! limits were measured on plane chains of links with as many speeds as bodies. Trees of bodies run without a mass matrix.

use crate::elimination::is_tree;
use model::Model;
use reader::Issue;

/// The task for which a model is used; it determines the largest accepted size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Run with a mass matrix: a chain of 80 links starts after 4 s.
    Run,
    /// Derivation and comparison of equations: 64 links take 2 s and 0.8 GB.
    Write,
    /// Derivatives of all equations: 40 links take 4 s and 0.7 GB.
    Vary,
}

impl Task {
    /// The largest accepted number speeds squared times bodies.
    fn most(self) -> usize {
        match self {
            Task::Run => 550_000,
            Task::Write => 330_000,
            Task::Vary => 66_000,
        }
    }
}

/// The largest number of speeds of a tree of bodies, whose equations grow linearly with the bodies.
const MOST_IN_TREE: usize = 1_000;

/// The fault of a model that is too large for a task; `None` if its size is accepted.
pub fn too_large(model: &Model, task: Task) -> Option<Issue> {
    let (speeds, bodies) = (model.speeds(), model.bodies.len().max(1));
    if task == Task::Run && speeds <= MOST_IN_TREE && is_tree(model) {
        return None;
    }
    let size = speeds.saturating_mul(speeds).saturating_mul(bodies);
    if size <= task.most() {
        return None;
    }
    let at = model.coordinates.first().map_or(0..0, |first| first.at.clone());
    let links = (task.most() as f64).cbrt().floor();
    let what = match task {
        Task::Run => "to run",
        Task::Write => "for its equations to be written down and compared",
        Task::Vary => "for linear equations",
    };
    let title = format!("this system is too large {what}: {speeds} speeds and {bodies} bodies");
    let label = format!("{size} for the square of the speeds times the bodies");
    let accepted = format!("up to {} of it, as of a chain of {links} links", task.most());
    Some(Issue::at(at, title, label).accepted(accepted))
}
