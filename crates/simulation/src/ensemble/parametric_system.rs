//! Systems of one form that differ in numbers alone: the interface that an ensemble uses.

use super::run::Last;
use super::stop_reason::Stopped;
use crate::events::Margins;
use crate::{Run, RunFailure};
use integrators::{BatchSeries, Projection};
use std::borrow::Cow;
use std::fmt;

/// The number of members in a batch: their numbers fill one vector register.
pub const BATCH_SIZE: usize = 8;

/// A scene with the law written down once, a symbol for every number that may vary.
pub trait ParametricSystem: fmt::Debug + Send + Sync {
    /// The title in one line.
    fn title(&self) -> &str;

    /// Span and tolerance; the method is Taylor's.
    fn run(&self) -> &Run;

    /// The numbers of states of a member and of parameters of its law.
    fn sizes(&self) -> Sizes;

    /// The series of a batch of members, to this order; `None` where the law is too long for a batch.
    fn series(&self, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>>;

    /// The way in which members run, where they do not run in a batch.
    fn alone(&self) -> Option<&dyn IndividualMembers> {
        None
    }

    /// The member with these numbers in the place of the scene's own.
    ///
    /// # Errors
    /// Why there is no such member.
    fn member(&self, drawn: &[Drawn]) -> Result<Member<'_>, Stopped>;

    /// The failures of the member with these numbers, as its single run shows them; `goes_on` breaks that off.
    fn failures(&self, _drawn: &[Drawn], _goes_on: &dyn Fn() -> bool) -> Vec<RunFailure> {
        Vec::new()
    }

    /// The columns in which a row shows the end of a member: first its state, then quantities computed from it.
    fn columns(&self) -> Vec<Column>;

    /// Writes all that decides a member beside the drawn numbers, the span and the tolerance: law, data, start.
    ///
    /// # Errors
    /// Those of the writer.
    fn write_law(&self, out: &mut dyn fmt::Write) -> fmt::Result;

    /// The name of the machine, or of the kind of system.
    fn name(&self) -> &str;
}

/// Members that run one by one: their laws change at events, at times of their own.
pub trait IndividualMembers: Sync {
    /// Runs the member with these numbers, while it may go on.
    ///
    /// # Errors
    /// Why there is no such member.
    fn run_alone(&self, drawn: &[Drawn], goes_on: &dyn Fn() -> bool) -> Result<Ended, Stopped>;
}

/// A member after its run.
pub struct Ended {
    pub last: Last,
    pub steps: u64,
    /// Why it stopped before its end.
    pub stopped: Option<Stopped>,
}

/// The length of a member's state, and of the parameters of its law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    pub states: usize,
    pub parameters: usize,
}

/// A column of a row, with the unit of its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    pub name: String,
    pub unit: String,
}

/// The end of a member at a time and a state.
pub type EndOf<'a> = dyn Fn(f64, &[f64]) -> Last + Send + 'a;

/// A member before its run.
pub struct Member<'a> {
    pub parameters: Vec<f64>,
    /// The state at time zero, as the law has it.
    pub state: Vec<f64>,
    /// The end of its run as a row shows it, from the last good time and state.
    pub end: Box<EndOf<'a>>,
    /// The distance of a state from where the law ends; none for a law that holds everywhere.
    pub margins: Option<Box<Margins>>,
    /// The projection onto the constraints and integrals of its motion, where each step is to end on them.
    pub projection: Option<Box<dyn Projection<f64> + Send + 'a>>,
}

/// The numbers of a variable for one member, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The place of the variable in the list of all.
    pub variable: usize,
    pub numbers: Vec<f64>,
}

/// Numbers of a scene that may vary: a key of one of its tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The name of the table; empty at the top of the file.
    pub table: &'static str,
    pub key: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
    pub unit: Cow<'static, str>,
    pub shape: Shape,
}

/// The number of components of a variable, and their structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Independent numbers, this many.
    Numbers(usize),
    /// Three components of a unit vector; drawn numbers are normalised.
    Direction,
    /// 11, 12, 13, 22, 23, 33.
    SymmetricTensor,
}

impl Shape {
    /// The number of components.
    pub fn components(self) -> usize {
        match self {
            Shape::Numbers(count) => count,
            Shape::Direction => 3,
            Shape::SymmetricTensor => 6,
        }
    }
}

impl Variable {
    /// The name in a table of results.
    pub fn name(&self) -> String {
        if self.table.is_empty() { self.key.to_string() } else { format!("{}.{}", self.table, self.key) }
    }
}

impl fmt::Debug for Member<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Member { parameters, state, .. } = self;
        f.debug_struct("Member").field("parameters", parameters).field("state", state).finish_non_exhaustive()
    }
}
