//! Speed against accuracy of a scene with rough contacts: every method across the events of the same motion.

use super::course::{WORKS, names, row};
use super::exact::Regimes;
use super::log::{Ending, Names};
use super::run::{Plan, run};
use super::stretch::parts;
use super::{ForRough, RoughScene};
use integrators::{Across, End, Failure, Method, Observer, Outcome, Reference, Span, Tolerance};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use simulation::references::Owner;
use simulation::references::{Exact, Unknown};
use simulation::work_precision::Hybrid;
use simulation::work_precision::{AcrossEvents, Formulation, Observed, Standing, Treated, Way};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A system with its start.
struct Motion<Q, const N: usize, const C: usize, const K: usize> {
    system: Q,
    start: State<f64, N>,
}

/// Events of a run.
const EVENTS: usize = 1000;

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Across for Motion<Q, N, C, K> {
    fn dimension(&self) -> usize {
        2 * N + 2
    }

    fn run(
        &self,
        method: Method,
        tolerance: &Tolerance,
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64> {
        let plan = Plan {
            method,
            tolerance: tolerance.clone(),
            end: span.end,
            outputs: span.outputs.clone(),
            most_events: EVENTS,
            allowed: span.budget.deadline.map(|deadline| deadline.saturating_duration_since(Instant::now())),
            evaluations: Some(span.budget.evaluations),
        };
        let found = run(&self.system, &self.start, &plan, observer);
        let end = match found.ending {
            Ending::Reached => End::Reached,
            Ending::BrokenOff => End::Halted,
            Ending::Failed(failure) => End::Stopped(failure),
            _ => End::Stopped(Failure::OtherCourse { at: found.state.time }),
        };
        let State { time, place, velocity } = found.state;
        let state = [&place[..], &velocity[..], &[found.friction_work, found.force_work]].concat();
        Outcome { end, time, state, work: found.work, deviations: Vec::new() }
    }
}

impl Hybrid for RoughScene {
    fn exact(&self, allowed: Duration) -> Result<Exact, Unknown> {
        RoughScene::exact(self, allowed)
    }

    fn owner(&self) -> Box<dyn Owner + '_> {
        Box::new(Regimes::of(self))
    }

    fn way(&self) -> Way {
        let regimes = Regimes::of(self);
        self.apply(OneWay { scene: self, state: regimes.start() })
    }

    fn observed(&self, columns: &[String], reference: &Reference) -> Vec<Observed> {
        observed(columns, reference)
    }

    fn end(&self) -> f64 {
        self.plan.end
    }
}

/// The state as it is integrated: coordinates, velocities, works.
fn observed(columns: &[String], reference: &Reference) -> Vec<Observed> {
    let of_state = reference.sizes.len() - WORKS.len();
    let names = columns.iter().take(of_state).chain(columns.iter().skip(columns.len() - WORKS.len()));
    names.zip(&reference.sizes).map(|(name, size)| Observed { name: name.clone(), size: *size }).collect()
}

struct OneWay<'a> {
    scene: &'a RoughScene,
    state: &'a [f64],
}

impl ForRough for OneWay<'_> {
    type Output = Way;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        contacts: Names<K>,
    ) -> Way
    where
        Q: Contacts<N, C, K, Given = f64> + Copy + Send + Sync + 'static,
    {
        let (rough, system) = (self.scene.system, *system);
        let motion: Arc<dyn AcrossEvents> = Arc::new(Motion { system, start });
        Way {
            formulation: Formulation::Contacts,
            model: "",
            standing: Standing::Own,
            law: Treated::Across(motion),
            state: self.state.to_vec(),
            sizes: Vec::new(),
            columns: names(&rough, &contacts),
            row: Box::new(move |time, y| row(&rough, &system, &parts::<f64, N>(time, y), [y[2 * N], y[2 * N + 1]])),
        }
    }
}
