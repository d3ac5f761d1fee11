//! Speed against accuracy: every method on a scene, measured by a reference.

use super::{Axes, Problem, Scene};
use integrators::{Failure, Method, Point, Reference, Span, Splitting, judge, measure, reference};
use std::time::{Duration, Instant};

/// Times, beside the start, at which an error is taken: few, so that landing on them costs no method much.
const INSTANTS: usize = 8;

const TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// What is tried on a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Trials {
    pub methods: Vec<Method>,
    pub tolerances: Vec<f64>,
    /// Evaluations of the rates in one run.
    pub evaluations: u64,
    /// For the reference, and again for the measurements.
    pub allowed: Duration,
}

/// What came out.
pub struct Measured {
    pub reference: Reference,
    pub points: Vec<Point>,
}

impl Trials {
    /// The same with one more method, where it is not yet among them.
    pub fn with(mut self, method: Method) -> Self {
        if !self.methods.contains(&method) {
            self.methods.push(method);
        }
        self
    }
}

impl Default for Trials {
    fn default() -> Self {
        let constant = [250, 1_000, 4_000, 16_000].map(|steps| Method::RungeKutta4 { steps });
        let split = [Splitting::BlanesMoan4, Splitting::BlanesMoan6]
            .into_iter()
            .flat_map(|splitting| [60, 250, 1_000, 4_000].map(|steps| Method::Split { splitting, steps }));
        let adaptive = [
            Method::DormandPrince5,
            Method::DormandPrince8,
            Method::Verner9,
            Method::GraggBulirschStoer,
            Method::Taylor,
            Method::Rodas4,
            Method::BaderDeuflhard,
            Method::Radau5,
            Method::RadauIIA { stages: 5 },
            Method::Gauss { stages: 6 },
        ];
        Trials {
            methods: adaptive.into_iter().chain(constant).chain(split).collect(),
            tolerances: TOLERANCES.to_vec(),
            evaluations: 100_000,
            allowed: Duration::from_secs(5),
        }
    }
}

impl Scene {
    /// Runs every method at every tolerance, and measures each by a reference that two methods confirm.
    ///
    /// # Errors
    /// Where there is no reference.
    pub fn measure(&self, axes: Axes, trials: &Trials) -> Result<Measured, Failure> {
        self.problem(axes).measure(trials)
    }
}

impl Problem {
    /// Runs every method at every tolerance, and measures each by a reference that two methods confirm.
    ///
    /// # Errors
    /// Where there is no reference.
    pub fn measure(&self, trials: &Trials) -> Result<Measured, Failure> {
        let mut measured = self.judge_by(self.reference(trials.allowed)?, trials);
        self.take_times(&mut measured, trials);
        Ok(measured)
    }

    /// What errors are measured by: many problems' at a time, if there are processors, since it is not timed.
    ///
    /// # Errors
    /// Where a method stopped, or the two do not agree.
    pub fn reference(&self, allowed: Duration) -> Result<Reference, Failure> {
        reference(&*self.law, &self.instants().with_deadline(Instant::now() + allowed))
    }

    /// Runs every method at every tolerance without timing them: many problems' at a time too.
    pub fn judge_by(&self, reference: Reference, trials: &Trials) -> Measured {
        let span = self.instants().with_evaluations(trials.evaluations);
        let Trials { methods, tolerances, allowed, .. } = trials;
        let points = judge(&*self.law, &span, methods, tolerances, &reference, *allowed / 2);
        Measured { reference, points }
    }

    /// Takes the times of the methods that reached the end, while nothing else runs.
    pub fn take_times(&self, measured: &mut Measured, trials: &Trials) {
        let span = self.instants().with_evaluations(trials.evaluations);
        measure(&*self.law, &span, &mut measured.points, &measured.reference, trials.allowed / 2);
    }

    fn instants(&self) -> Span<'static, f64> {
        Span::new(0.0, self.span, &self.state).with_even_outputs(INSTANTS)
    }
}
