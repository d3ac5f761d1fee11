//! Scenes whose law changes at events: reference solutions, and runs of every method across the events.

use crate::modes::{Modes, RunTable};
use crate::scene::ModelScene;
use field::DoubleDouble;
use integrators::{End, Failure, HybridMotion, Method, Observer, Outcome, Reference, Sizes, Span, Tolerance};
use simulation::Problem;
use simulation::events::Switching;
use simulation::references::Owner;
use simulation::references::{Exact, Unknown, agreed, instants};
use simulation::work_precision::Hybrid;
use simulation::work_precision::{Configuration, Formulation, Observed, Standing, Treated};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Tolerance and method of the run in `f64` that determines the sequence of laws.
const TOLERANCE: f64 = 1e-13;
const METHOD: Method = Method::DormandPrince8;

/// The number of evaluations of a first attempt. When a contact jams, reactions grow without bound, rounding makes steps ever shorter,
/// and the run must not use its whole budget.
const FEW: u64 = 1_000_000;

/// Sizes below this part of the largest of their kind are rounding errors.
const ROUNDING: f64 = 1e-9;

/// A run in `f64` that determines the sequence of laws.
struct Told {
    modes: Arc<Modes>,
    /// The laws of the run, with the times of the events between them.
    course: RunTable,
    /// The largest absolute value of each component of the state.
    sizes: Vec<f64>,
    /// The time of the end, s.
    end: f64,
    /// True if the run reached the end of the time span.
    is_whole: bool,
}

impl ModelScene {
    fn told_laws(&self, deadline: Option<Instant>) -> Result<Told, Unknown> {
        let (problem, modes) = self.switched();
        let Some(modes) = modes else { return Err(Unknown::Ends("its law does not change".to_owned())) };
        let mut sizes = Sizes(self.start.iter().map(|part| part.abs()).collect());
        let mut span = Span::new(0.0, self.run.span, &self.start);
        span.budget.deadline = deadline;
        let usual = span.budget.evaluations;
        span.budget.evaluations = FEW;
        let (mut outcome, mut left) = problem.integrate(METHOD, &Tolerance::both(TOLERANCE), &span, &mut sizes);
        if left.is_none() && matches!(outcome.failure(), Some(Failure::TooManyEvaluations { .. })) {
            span.budget.evaluations = usual;
            (outcome, left) = problem.integrate(METHOD, &Tolerance::both(TOLERANCE), &span, &mut sizes);
        }
        match (left, outcome.end) {
            (Some(why), _) if modes.passages().is_empty() => return Err(Unknown::Ends(why.to_owned())),
            (Some(_), _) | (None, End::Reached) => {}
            (None, End::Stopped(failure)) => return Err(Unknown::Failed(failure)),
            (None, End::Halted) => return Err(Unknown::Ends("it was broken off".to_owned())),
        }
        let (course, end) = (modes.course(), outcome.time);
        let positions = self.model.positions();
        let sizes = [&sizes.0[..positions], &sizes.0[positions..]].map(of_kind).concat();
        Ok(Told { modes, course, sizes, end, is_whole: end == self.run.span })
    }
}

impl Hybrid for ModelScene {
    fn exact(&self, allowed: Duration) -> Result<Exact, Unknown> {
        let begun = Instant::now();
        let Told { modes, course, sizes, end, is_whole } = self.told_laws(begun.checked_add(allowed))?;
        let times = instants(&self.start, end, is_whole);
        let left = allowed.saturating_sub(begun.elapsed());
        let passages = modes.passages();
        let words = |place: usize| {
            let passage = passages.get(place + 1);
            let what = passage.map_or_else(String::new, |passage| passage.what.clone());
            [what, passage.and_then(|passage| passage.then.clone()).unwrap_or_default()]
        };
        let follow = |means| modes.exactly(&course, &self.start, &times, means);
        agreed(times.clone(), sizes, left, follow, words)
    }

    fn owner(&self) -> Box<dyn Owner + '_> {
        let course = self.told_laws(None).map_or_else(|_| RunTable::default(), |told| told.course);
        Box::new(Laws { start: &self.start, course })
    }

    fn way(&self) -> Configuration {
        let (problem, modes) = self.switched();
        let columns = self.model.state_names().into_iter().map(|(name, _)| name).collect();
        let state = self.start.clone();
        let law = match modes {
            Some(modes) => Treated::Hybrid(Arc::new(Motion { problem, modes, dimension: state.len() })),
            None => Treated::Free(problem.law),
        };
        let row = Box::new(|_: f64, state: &[f64]| state.to_vec());
        let (formulation, standing) = (Formulation::Contacts, Standing::Own);
        Configuration { formulation, model: "", standing, law, state, sizes: Vec::new(), columns, row }
    }

    fn observed(&self, columns: &[String], reference: &Reference) -> Vec<Observed> {
        let all = columns.iter().zip(&reference.sizes);
        all.map(|(name, size)| Observed { name: name.clone(), size: *size }).collect()
    }

    fn end(&self) -> f64 {
        self.run.span
    }
}

/// Sizes of positions, or of speeds, for relative errors. A component that is only rounding error gets the largest size.
fn of_kind(sizes: &[f64]) -> Vec<f64> {
    let whole = sizes.iter().copied().fold(0.0, f64::max);
    let whole = if whole > 0.0 { whole } else { 1.0 };
    sizes.iter().map(|size| if *size > ROUNDING * whole { *size } else { whole }).collect()
}

/// A start, and the sequence of laws from this start.
struct Laws<'a> {
    start: &'a [f64],
    course: RunTable,
}

impl Owner for Laws<'_> {
    fn start(&self) -> &[f64] {
        self.start
    }

    fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        self.course.rates_at(time, state, rates);
    }
}

/// The motion of a scene across its events, for any method.
struct Motion {
    problem: Problem,
    modes: Arc<Modes>,
    dimension: usize,
}

impl HybridMotion for Motion {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn has_series(&self) -> bool {
        true
    }

    fn run(
        &self,
        method: Method,
        tolerance: &Tolerance,
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64> {
        // concurrent runs need modes of their own
        self.problem.across(&self.modes.of_another_run(), (method, tolerance), span, observer)
    }
}
