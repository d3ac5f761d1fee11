//! Ensembles: one scene many times, with data and starts that differ, run side by side.
//!
//! # Overview
//! * [`EnsembleScene`]: a scene with a motor and a table `[ensemble]` that says what varies, from a file;
//! * [`known`]: the numbers that may vary; [`vary`], [`draw`]: the distributions, and random numbers that depend on seed, member and datum alone;
//! * [`kind`]: the law written down once, with a symbol for every datum;
//! * [`member`], [`run`]: a member's data, and all members in lanes and threads;
//! * [`fingerprint`]: what decides a member, so that rows of different ensembles are told apart.

pub mod draw;
pub mod fingerprint;
pub mod kind;
pub mod known;
pub mod member;
pub mod run;
mod stop_reason;
pub mod vary;

pub use fingerprint::Fingerprint;
pub use member::Member;
pub use run::{Last, Row};
pub use stop_reason::Stopped;

use crate::scene::file::Opening;
use crate::scene::issue::Issue;
use crate::scene::read::Table;
use crate::scene::{Axes, Family, Scene};
use kind::Kind;
use vary::Varied;

/// A scene of which many members are run.
#[derive(Clone, Debug)]
pub struct EnsembleScene {
    pub scene: Scene,
    pub members: u64,
    seed: u64,
    varied: Vec<Varied>,
    kind: Kind,
    axes: Axes,
}

impl Family for EnsembleScene {
    const KIND: &'static str = "a system with a motor, which ensembles have";

    fn systems() -> Vec<(&'static str, &'static str)> {
        Scene::systems()
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        let place = opening.system.span.clone();
        let scene = Scene::read(opening, top, issues);
        let variation = vary::read(top, issues, scene.as_ref());
        let (scene, variation) = (scene?, variation?);
        let axes = Axes::Second;
        let kind = Kind::record(&scene.system, &scene.machine, &scene.machine_data, axes);
        let kind =
            kind.map_err(|wrong| issues.push(Issue::at(place, "the law cannot be written down", wrong.to_string())));
        Some(EnsembleScene {
            scene,
            members: variation.members,
            seed: variation.seed,
            varied: variation.varied,
            kind: kind.ok()?,
            axes,
        })
    }
}
