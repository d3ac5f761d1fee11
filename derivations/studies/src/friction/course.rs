//! A run of a scene as names and numbers: for tables, pictures and checks.

use super::log::{Ending, Names, describe};
use super::rough::Rough;
use super::run::{Plan, run};
use super::scene::{ForRough, RoughScene};
use super::stretch::{motion_of_contacts, parts};
use integrators::{Observer, Samples, Work};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Direction, Mode};
use std::ops::ControlFlow;

/// What a run came to, whatever its system.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Of the columns: coordinates, velocities, angle and its rate, the velocity at each contact, works.
    pub names: Vec<String>,
    pub times: Vec<f64>,
    /// At the instants that were asked for, as far as the run went, and at its last.
    pub rows: Vec<Vec<f64>>,
    pub log: Vec<Line>,
    /// In words.
    pub ending: String,
    /// Whether that is the end of the span.
    pub reached: bool,
    /// Whether it went on until it was told to end.
    pub broken_off: bool,
    /// Whether the determinant of the last regime vanished, or the start had no motion.
    pub jammed: bool,
    /// The work of friction, J.
    pub friction_work: f64,
    /// What is left of the energy balance, J.
    pub imbalance: f64,
    pub settled: f64,
    pub work: Work,
}

/// A line of the log.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub time: f64,
    pub cause: String,
    pub regime: String,
    /// The state, as a row.
    pub row: Vec<f64>,
    /// Normal and tangential reaction at each contact, N.
    pub reactions: Vec<[f64; 2]>,
    /// Whether each contact slides: 1 forwards, -1 backwards, 0 not.
    pub slides: Vec<i8>,
}

impl Course {
    /// The column of a name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// The last row.
    pub fn last(&self) -> &[f64] {
        self.rows.last().map_or(&[], Vec::as_slice)
    }
}

/// Told of a fraction; whether to go on.
pub type Progress<'a> = dyn FnMut(f64) -> ControlFlow<()> + 'a;

impl RoughScene {
    /// The names of a row.
    pub fn columns(&self) -> Vec<String> {
        self.apply(Columns(&self.system))
    }

    /// Runs. `progress` is told the fraction of a stretch that is done.
    pub fn follow(&self, plan: &Plan, progress: &mut dyn FnMut(f64)) -> Course {
        self.follow_while(plan, &mut |fraction| {
            progress(fraction);
            ControlFlow::Continue(())
        })
    }

    /// Runs until `progress`, told the fraction of a stretch that is done, breaks it off; what there is is kept.
    pub fn follow_while(&self, plan: &Plan, progress: &mut Progress<'_>) -> Course {
        self.apply(Follow { scene: self, plan, progress })
    }
}

/// The names of a row.
pub fn names<const K: usize>(rough: &Rough, contacts: &Names<K>) -> Vec<String> {
    let coordinates = rough.coordinates();
    let velocities = coordinates.iter().map(|name| format!("d{name}"));
    let sliding = contacts.iter().map(|name| format!("sliding_{name}"));
    let names = coordinates.iter().map(|name| (*name).to_owned()).chain(velocities);
    let names = names.chain(["angle", "angular_velocity"].map(String::from)).chain(sliding);
    names.chain(WORKS.map(String::from)).collect()
}

struct Columns<'a>(&'a Rough);

impl ForRough for Columns<'_> {
    type Output = Vec<String>;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        _: &Q,
        _: State<f64, N>,
        contacts: Names<K>,
    ) -> Vec<String>
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        names(self.0, &contacts)
    }
}

/// The unit of a column by its name.
pub fn unit(name: &str) -> &'static str {
    match name {
        "cos" | "sin" => "1",
        "dcos" | "dsin" => "1/s",
        "angle" => "rad",
        "angular_velocity" => "rad/s",
        _ if WORKS.contains(&name) => "J",
        _ if name.starts_with(['d', 's']) => "m/s",
        _ => "m",
    }
}

/// Columns that are no state of the system.
pub const WORKS: [&str; 2] = ["friction_work", "force_work"];

/// What is shown of a state, with the works of friction and of the given forces until then.
pub fn row<Q, const N: usize, const C: usize, const K: usize>(
    rough: &Rough,
    system: &Q,
    at: &State<f64, N>,
    works: [f64; 2],
) -> Vec<f64>
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let [angle, spin] = rough.angle(&at.place, &at.velocity);
    let sliding = motion_of_contacts(system, at).map(|[_, along]| along.slope);
    [&at.place[..], &at.velocity[..], &[angle, spin], &sliding[..], &works[..]].concat()
}

struct Follow<'a> {
    scene: &'a RoughScene,
    plan: &'a Plan,
    progress: &'a mut Progress<'a>,
}

impl ForRough for Follow<'_> {
    type Output = Course;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        contacts: Names<K>,
    ) -> Course
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        let row = |at: &State<f64, N>, works: [f64; 2]| row(&self.scene.system, system, at, works);
        let (mut times, mut rows) = (Vec::new(), Vec::new());
        let found = {
            let keep = Samples(|time: f64, y: &[f64]| {
                times.push(time);
                rows.push(row(&parts(time, y), [y[2 * N], y[2 * N + 1]]));
            });
            run(system, &start, self.plan, &mut (keep, Told { progress: self.progress, broken_off: false }))
        };
        let last = row(&found.state, [found.friction_work, found.force_work]);
        if times.last().is_none_or(|time| *time < found.state.time) {
            times.push(found.state.time);
            rows.push(last);
        }
        let log = found.entries.iter().map(|entry| {
            let at = State {
                time: entry.time,
                place: std::array::from_fn(|i| entry.place[i]),
                velocity: std::array::from_fn(|i| entry.velocity[i]),
            };
            Line {
                time: entry.time,
                cause: entry.cause.describe(&contacts),
                regime: describe(&contacts, &entry.regime),
                row: row(&at, entry.works),
                reactions: entry.reactions.to_vec(),
                slides: entry.regime.iter().map(|mode| slide(*mode)).collect(),
            }
        });
        Course {
            names: names(&self.scene.system, &contacts),
            log: log.collect(),
            ending: found.ending.describe(&contacts),
            reached: found.ending == Ending::Reached,
            broken_off: found.ending == Ending::BrokenOff,
            jammed: matches!(found.ending, Ending::Critical | Ending::NoMotion),
            friction_work: found.friction_work,
            imbalance: found.imbalance,
            settled: found.settled,
            work: found.work,
            times,
            rows,
        }
    }
}

fn slide(mode: Mode) -> i8 {
    match mode {
        Mode::Slip(Direction::Forwards, _) => 1,
        Mode::Slip(Direction::Backwards, _) => -1,
        Mode::Stick(_) | Mode::Apart => 0,
    }
}

/// Passes the progress on, and ends the run where it is broken off.
struct Told<'a> {
    progress: &'a mut Progress<'a>,
    broken_off: bool,
}

impl Observer<f64> for Told<'_> {
    fn progress(&mut self, fraction: f64) {
        self.broken_off |= (self.progress)(fraction).is_break();
    }

    fn enough(&self) -> bool {
        self.broken_off
    }
}
