//! The run of an ensemble: batches in several threads, results in the order of the members.

use super::member_end::LaneEnd;
use super::parametric_system::{BATCH_SIZE, Column, Ended, IndividualMembers, Member};
use super::{EnsembleScene, Stopped};
use crate::Margin;
use integrators::{BatchStep, Ensemble, Failure, Members, clock};
use std::collections::BTreeMap;
use std::ops::{ControlFlow, RangeInclusive};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;

/// The largest number of steps of a member.
pub(super) const MOST_STEPS: u64 = 1_000_000;

/// The result row of a member.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The number of the member, counted from one.
    pub number: u64,
    /// The drawn numbers of the member, in SI units.
    pub drawn: Vec<f64>,
    /// The reason why the member stopped early, if it did: a [`Stopped`] as text.
    pub stopped: Option<String>,
    pub steps: u64,
    /// The last valid state; `None` where the member does not exist.
    pub last: Option<Last>,
}

/// The last valid state of a member, in the columns of its system.
#[derive(Clone, Debug, PartialEq)]
pub struct Last {
    pub time: f64,
    pub state: Vec<f64>,
    /// Functions of the state, and the change of each invariant; `None` where undefined for a member.
    pub derived: Vec<Option<f64>>,
}

impl EnsembleScene {
    /// Runs the given members and passes the rows to `take` in their order, not in that of completion. The rows do not
    /// depend on the number of threads.
    ///
    /// `take` may stop the run; unfinished members are then lost.
    pub fn run(&self, members: RangeInclusive<u64>, threads: usize, mut take: impl FnMut(Row) -> ControlFlow<()>) {
        let (next, stop) = (AtomicU64::new(*members.start()), AtomicBool::new(false));
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::sync_channel(1024);
            for _ in 0..threads.max(1) {
                let worker = Worker {
                    scene: self,
                    next: &next,
                    last: *members.end(),
                    stop: &stop,
                    aboard: Vec::with_capacity(BATCH_SIZE + 1),
                    rows: sender.clone(),
                };
                scope.spawn(move || worker.work());
            }
            drop(sender);
            let (mut waiting, mut expected) = (BTreeMap::new(), *members.start());
            for row in receiver {
                waiting.insert(row.number, row);
                while let Some(row) = waiting.remove(&expected) {
                    expected += 1;
                    if !stop.load(Ordering::Relaxed) && take(row).is_break() {
                        stop.store(true, Ordering::Relaxed);
                    }
                }
            }
        });
    }

    /// The column titles of a row, with units.
    pub fn headings(&self) -> Vec<String> {
        let drawn =
            self.varied.iter().flat_map(|varied| varied.columns().into_iter().map(|name| (name, varied.unit())));
        let mut headings = vec!["member".to_owned()];
        headings.extend(drawn.map(|(name, unit)| format!("{name} [{unit}]")));
        headings.extend(["stopped", "time [s]", "steps"].map(String::from));
        headings.extend(self.system.columns().into_iter().map(|Column { name, unit }| format!("{name} [{unit}]")));
        headings.push("fingerprint".to_owned());
        headings
    }

    /// The column names of a row.
    pub fn columns(&self) -> Vec<String> {
        let mut columns = vec!["member".to_owned()];
        columns.extend(self.varied.iter().flat_map(super::vary::Varied::columns));
        columns.extend(["stopped", "time", "steps"].map(String::from));
        columns.extend(self.system.columns().into_iter().map(|column| column.name));
        columns
    }
}

/// The state of one thread.
struct Worker<'a> {
    scene: &'a EnsembleScene,
    next: &'a AtomicU64,
    last: u64,
    stop: &'a AtomicBool,
    /// The members in the lanes.
    aboard: Vec<Aboard<'a>>,
    rows: mpsc::SyncSender<Row>,
}

/// A member in a lane.
struct Aboard<'a> {
    number: u64,
    member: Member<'a>,
    margins: Vec<Margin>,
    /// The reason why the member reached the end of the validity of its law.
    left: Option<&'static str>,
}

impl Worker<'_> {
    fn work(mut self) {
        let (system, run) = (&self.scene.system, self.scene.system.run());
        if let Some(alone) = system.alone() {
            return self.work_alone(alone);
        }
        // a scene without a series was rejected earlier
        let Some(series) = system.series(integrators::batch_order(run.tolerance)) else { return };
        let sizes = system.sizes();
        Ensemble::new(series, run.tolerance, run.span, sizes.states, sizes.parameters)
            .with_most_steps(MOST_STEPS)
            .run(&mut self);
    }

    /// Runs members one by one.
    fn work_alone(&self, alone: &dyn IndividualMembers) {
        let goes_on = || !self.stop.load(Ordering::Relaxed);
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            if !goes_on() || number > self.last {
                return;
            }
            let ended = self.scene.numbers(number).and_then(|drawn| alone.run_alone(&drawn, &goes_on));
            let drawn = self.scene.drawn(number);
            // a run that the clock has broken off is no result of its member, which is run anew when the table is continued
            if !goes_on() || clock::over().is_some() {
                return;
            }
            self.hand_on(match ended {
                Ok(Ended { last, steps, stopped }) => {
                    let stopped = stopped.map(|stopped| stopped.to_string());
                    Row { number, drawn, stopped, steps, last: Some(last) }
                }
                Err(why) => Row { number, drawn, stopped: Some(why.to_string()), steps: 0, last: None },
            });
        }
    }

    /// Sends a row. The receiver exists as long as the run.
    fn hand_on(&self, row: Row) {
        let _ = self.rows.send(row);
    }
}

impl Members for Worker<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            if number > self.last || self.stop.load(Ordering::Relaxed) {
                return None;
            }
            match self.scene.member(number) {
                Ok(member) => {
                    parameters.copy_from_slice(&member.parameters);
                    state.copy_from_slice(&member.state);
                    let margins = member.margins.as_ref();
                    let margins = margins.map(|margins| margins(0.0, state, &vec![0.0; state.len()]));
                    self.aboard.push(Aboard { number, member, margins: margins.unwrap_or_default(), left: None });
                    return Some(number);
                }
                Err(why) => {
                    let drawn = self.scene.drawn(number);
                    self.hand_on(Row { number, drawn, stopped: Some(why.to_string()), steps: 0, last: None });
                }
            }
        }
    }

    fn watches(&self) -> bool {
        self.aboard.iter().any(|aboard| aboard.member.margins.is_some())
    }

    fn leaves(&mut self, number: u64, step: &BatchStep<'_>) -> Option<f64> {
        let aboard = self.aboard.iter_mut().find(|aboard| aboard.number == number)?;
        let margins = aboard.member.margins.as_ref()?;
        let mut member_end = LaneEnd::new(&**margins, step, aboard.member.state.len());
        let end = member_end.look(step.end);
        let left = member_end.first([(step.begin, &aboard.margins), (step.end, &end)]);
        aboard.margins = end;
        aboard.left = left.map(|(_, what)| what);
        left.map(|(time, _)| time)
    }

    fn projects(&self) -> bool {
        self.aboard.iter().any(|aboard| aboard.member.projection.is_some())
    }

    fn project(&mut self, number: u64, time: f64, state: &mut [f64]) -> bool {
        let aboard = self.aboard.iter().find(|aboard| aboard.number == number);
        let projection = aboard.and_then(|aboard| aboard.member.projection.as_ref());
        projection.is_some_and(|projection| projection.project(time, state))
    }

    fn ended(&mut self, number: u64, state: &[f64], steps: u64, at: f64, failure: Option<Failure>) {
        let Some(place) = self.aboard.iter().position(|aboard| aboard.number == number) else { return };
        let Aboard { member, left, .. } = self.aboard.swap_remove(place);
        let stopped = failure.map(Stopped::Run).or(left.map(Stopped::Left)).map(|stopped| stopped.to_string());
        let drawn = self.scene.drawn(number);
        self.hand_on(Row { number, drawn, stopped, steps, last: Some((member.end)(at, state)) });
    }
}
