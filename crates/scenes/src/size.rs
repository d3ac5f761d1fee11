//! The largest systems that commands accept, checked before the equations are derived.
//!
//! Equations of motion with a mass matrix are sums over bodies for each pair of speeds: work and memory grow as the square of the speeds
//! times the bodies. The limits were measured on chains of links in a plane, with as many speeds as bodies. Runs of bodies in a tree
//! need no mass matrix.

use crate::elimination::is_tree;
use model::Model;
use reader::Issue;

/// The task for which a system is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Runs with a mass matrix: a chain of 80 links begins after 4 s.
    Run,
    /// Equations written down and compared: 64 links take 2 s and 0.8 GB.
    Write,
    /// Derivatives of all equations: 40 links take 4 s and 0.7 GB.
    Vary,
}

impl Task {
    /// The largest square of the speeds times the bodies.
    fn most(self) -> usize {
        match self {
            Task::Run => 550_000,
            Task::Write => 330_000,
            Task::Vary => 66_000,
        }
    }
}

/// The largest number of speeds for bodies in a tree, whose equations grow linearly with the bodies.
const MOST_IN_TREE: usize = 1_000;

/// The refusal of a system that is too large.
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
