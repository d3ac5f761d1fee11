//! The interface of a system to an ensemble: systems of one form that differ only in numbers.

use super::run::Last;
use super::stop_reason::Stopped;
use crate::events::Margins;
use crate::{Run, RunFailure};
use integrators::{BatchSeries, Projection};
use std::borrow::Cow;
use std::fmt;

/// The number of members in a batch: their numbers fill one SIMD register.
pub const BATCH_SIZE: usize = 8;

/// A scene whose law has a symbol for every number that may vary.
pub trait ParametricSystem: fmt::Debug + Send + Sync {
    /// The title in one line.
    fn title(&self) -> &str;

    /// Span and tolerance; the method is Taylor's.
    fn run(&self) -> &Run;

    /// The numbers of states of a member, and of parameters of its law.
    fn sizes(&self) -> Sizes;

    /// The Taylor series of a batch of members, of the given order; `None` where the law is too long for a batch.
    fn series(&self, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>>;

    /// The alternative to batches for systems whose members must run one by one.
    fn alone(&self) -> Option<&dyn IndividualMembers> {
        None
    }

    /// The member with these drawn numbers instead of the scene's own.
    ///
    /// # Errors
    /// [`Stopped`] with the reason why the member does not exist.
    fn member(&self, drawn: &[Drawn]) -> Result<Member<'_>, Stopped>;

    /// The failures that a single run of the member reports; `_goes_on` may stop the search.
    fn failures(&self, _drawn: &[Drawn], _goes_on: &dyn Fn() -> bool) -> Vec<RunFailure> {
        Vec::new()
    }

    /// The columns of a result row: first the state at the end, then quantities computed from it.
    fn columns(&self) -> Vec<Column>;

    /// Writes everything that determines a member besides the drawn numbers, the span and the tolerance: law, data,
    /// start.
    ///
    /// # Errors
    /// Those of the writer.
    fn write_law(&self, out: &mut dyn fmt::Write) -> fmt::Result;

    /// The name of the machine, or of the kind of system.
    fn name(&self) -> &str;
}

/// Members that run one by one, since their laws change at events at individual times.
pub trait IndividualMembers: Sync {
    /// Runs the member with these drawn numbers; stops when `goes_on` returns false.
    ///
    /// # Errors
    /// [`Stopped`] with the reason why the member does not exist.
    fn run_alone(&self, drawn: &[Drawn], goes_on: &dyn Fn() -> bool) -> Result<Ended, Stopped>;
}

/// The result of a member's run.
pub struct Ended {
    pub last: Last,
    pub steps: u64,
    /// The reason if the run stopped before its end.
    pub stopped: Option<Stopped>,
}

/// The number of states of a member, and of parameters of its law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    pub states: usize,
    pub parameters: usize,
}

/// A column of the result rows, with its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    pub name: String,
    pub unit: String,
}

/// Computes the result columns of a member from a time and a state.
pub type EndOf<'a> = dyn Fn(f64, &[f64]) -> Last + Send + 'a;

/// A member before its run.
pub struct Member<'a> {
    pub parameters: Vec<f64>,
    /// The state at time zero, in the form of the law.
    pub state: Vec<f64>,
    /// Computes the result columns from the last valid time and state.
    pub end: Box<EndOf<'a>>,
    /// The margins of the law; `None` for a law that is valid everywhere.
    pub margins: Option<Box<Margins>>,
    /// The projection onto constraints and integrals, if each step must satisfy them.
    pub projection: Option<Box<dyn Projection<f64> + Send + 'a>>,
}

/// The drawn values of a variable for one member, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The index of the variable.
    pub variable: usize,
    pub numbers: Vec<f64>,
}

/// A quantity of a scene that may vary: a key of one of its tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// The name of the table; empty for keys at the top of the file.
    pub table: &'static str,
    pub key: Cow<'static, str>,
    pub meaning: Cow<'static, str>,
    pub unit: Cow<'static, str>,
    pub shape: Shape,
}

/// The structure of a variable's components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The given number of independent components.
    Numbers(usize),
    /// The three components of a unit vector; drawn vectors are normalised.
    Direction,
    /// The components 11, 12, 13, 22, 23, 33 of a symmetric tensor.
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
    /// The column name in a table of results.
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
