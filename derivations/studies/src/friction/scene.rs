//! Scenes of systems with rough contacts, read from TOML files.

use super::log::Names;
use super::rough::Rough;
use super::run::Plan;
use integrators::Tolerance;
use mechanics::constrained::State;
use mechanics::constrained::contacts::{Contacts, Sides};
use reader::{At, Family, Issue, Opening, Table};
use simulation::run::of_any_family;
use std::f64::consts::{FRAC_PI_2, PI};
use systems::climbed_ladder::ClimbedLadder;
use systems::ladder::Ladder;
use systems::rod::Rod;
use systems::slender_rod::SlenderRod;
use systems::steered_rod::SteeredRod;

/// A scene whose data are all admissible.
#[derive(Clone, Debug, PartialEq)]
pub struct RoughScene {
    pub title: String,
    /// What happens and why.
    pub description: String,
    pub system: Rough,
    /// rad, from the wall to a ladder, from the line to a rod
    pub angle: f64,
    /// rad/s; a steered rod has none of its own
    pub spin: f64,
    /// of a rod's contact along its line, m/s
    pub slide: f64,
    pub plan: Plan,
}

/// What is done with a system once its type is known.
pub trait ForRough {
    type Output;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        names: Names<K>,
    ) -> Self::Output
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static;
}

reader::submit! { reader::KnownSystems(<RoughScene as Family>::systems) }

impl Family for RoughScene {
    const KIND: &'static str = "a system with rough contacts";

    fn systems() -> Vec<(&'static str, &'static str)> {
        Rough::LIST.to_vec()
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        let Opening { title, description, system: name } = opening;
        let gravity = positive(top, "gravity", "acceleration of gravity", "m/s^2");
        let system = body(top, issues, &name.value, gravity);
        let mut start = top.table("start", "the initial state");
        let angle = start.scalar("angle", "angle from the wall to a ladder, from the line to a rod", "rad");
        let is_ladder = name.value.ends_with("ladder");
        let (most, accepted) = match is_ladder {
            true => (FRAC_PI_2, "an angle from 0 to 90 degrees is accepted"),
            false => (PI, "an angle from 0 to 180 degrees is accepted"),
        };
        bounded(&mut start, "angle", &angle, (0.0..=most).contains(&angle.value), accepted);
        let spin = match name.value.as_str() {
            "steered_rod" => 0.0,
            _ => start.scalar("angular_velocity", "rate of the angle", "rad/s").value,
        };
        let slide = if is_ladder { 0.0 } else { start.scalar("sliding", "velocity of the contact", "m/s").value };
        let mut sound = start.exists() && !start.has_issues();
        issues.extend(start.finish());
        let mut table = top.table("run", "the span of time");
        let run = of_any_family(&mut table, 1e-14, 0);
        sound &= table.exists() && !table.has_issues() && !top.has_issues();
        issues.extend(table.finish());
        let (system, run) = (system.filter(|_| sound)?, run?);
        let plan = Plan { tolerance: Tolerance::both(run.tolerance), method: run.method, ..Plan::until(run.span) };
        let plan = plan.with_samples(run.samples);
        Some(RoughScene { title, description, system, angle: angle.value, spin, slide, plan })
    }
}

impl RoughScene {
    /// The system with its type, its initial state and the names of its contacts.
    pub fn apply<F: ForRough>(&self, then: F) -> F::Output {
        let (s, c) = self.angle.sin_cos();
        let (w, u) = (self.spin, self.slide);
        let at = |place, velocity| State { time: 0.0, place, velocity };
        let leaning = |l: f64| at([l * s, l * c, c, s], [l * w * c, -l * w * s, -w * s, w * c]);
        match &self.system {
            Rough::Ladder(ladder) => then.apply(ladder, leaning(ladder.half_length), ["wall", "floor"]),
            Rough::ClimbedLadder(climbed) => {
                then.apply(climbed, leaning(climbed.ladder.half_length), ["wall", "floor", "top"])
            }
            Rough::SlenderRod(rod) => {
                let l = rod.half_length;
                then.apply(rod, at([l * c, l * s, c, s], [u - l * w * s, l * w * c, -w * s, w * c]), ["end"])
            }
            Rough::Rod(rod) => {
                let l = rod.length;
                then.apply(rod, at([0.0, 0.0, l * c, l * s], [u, 0.0, u - l * w * s, l * w * c]), ["guide"])
            }
            Rough::SteeredRod(rod) => {
                let (l, w) = (rod.length, 2.0 * u * s / rod.length);
                then.apply(rod, at([0.0, 0.0, l * c, l * s], [u, 0.0, u - l * w * s, l * w * c]), ["guide"])
            }
        }
    }
}

/// A number above zero.
fn positive(table: &mut Table<'_>, key: &'static str, meaning: &str, unit: &str) -> f64 {
    let found = table.scalar(key, meaning, unit);
    bounded(table, key, &found, found.value > 0.0, "a positive value is accepted");
    found.value
}

/// A coefficient of friction.
fn friction(table: &mut Table<'_>, key: &'static str) -> f64 {
    let found = table.scalar(key, "coefficient of friction", "1");
    bounded(table, key, &found, found.value >= 0.0, "zero or a positive number is accepted");
    found.value
}

fn bounded(table: &mut Table<'_>, key: &str, found: &At<f64>, holds: bool, accepted: &str) {
    if table.exists() && !holds && !table.has_issue_at(&found.span) && !found.span.is_empty() {
        let issue = Issue::at(found.span.clone(), format!("`{key}` is out of range"), format!("it is {}", found.value));
        table.report(issue.accepted(accepted));
    }
}

/// The table `[body]`, and `[load]` where there is one.
fn body(top: &mut Table<'_>, issues: &mut Vec<Issue>, name: &str, gravity: f64) -> Option<Rough> {
    let mut table = top.table("body", "the masses, the length and the friction");
    let system = match name {
        "ladder" | "climbed_ladder" | "slender_rod" => {
            let mass = positive(&mut table, "mass", "mass", "kg");
            let half_length = positive(&mut table, "half_length", "half of the length", "m");
            let inertia = table.optional_scalar("inertia", "moment of inertia about the centre", "kg m^2");
            if let Some(found) = &inertia {
                bounded(&mut table, "inertia", found, found.value > 0.0, "a positive value is accepted");
            }
            let inertia = inertia.map_or(mass * half_length * half_length / 3.0, |found| found.value);
            if name == "slender_rod" {
                let friction = friction(&mut table, "friction");
                Rough::SlenderRod(SlenderRod { mass, inertia, half_length, gravity, friction })
            } else {
                let friction = ["friction_wall", "friction_floor"].map(|key| friction(&mut table, key));
                Rough::Ladder(Ladder { mass, inertia, half_length, gravity, friction })
            }
        }
        _ => {
            let guided = positive(&mut table, "guided", "mass on the guide", "kg");
            let free = positive(&mut table, "free", "other mass", "kg");
            let length = positive(&mut table, "length", "length of the rod", "m");
            let friction = friction(&mut table, "friction");
            let sides = Sides::Two;
            if name == "painleve_rod" {
                Rough::Rod(Rod { guided, free, length, gravity, friction, sides })
            } else {
                let drive = table.optional_scalar("drive", "force along the guide", "N").map_or(0.0, |x| x.value);
                Rough::SteeredRod(SteeredRod { guided, free, length, gravity, drive, friction, sides })
            }
        }
    };
    let mut sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    let system = match (name, system) {
        ("climbed_ladder", Rough::Ladder(ladder)) => {
            let mut load = top.table("load", "the weight that is carried up");
            let weight = positive(&mut load, "weight", "weight that is carried up", "N");
            let speed = positive(&mut load, "speed", "speed along the ladder", "m/s");
            sound &= load.exists() && !load.has_issues();
            issues.extend(load.finish());
            Rough::ClimbedLadder(ClimbedLadder { ladder, weight, speed })
        }
        (_, system) => system,
    };
    sound.then_some(system)
}
