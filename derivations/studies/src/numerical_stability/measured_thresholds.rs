//! Stability thresholds by runs: step sizes at which a perturbed motion begins or ceases to leave the steady motion.

use super::methods::OneStep;
use super::motions::Stationed;
use super::threshold_run_length::{Crossing, INTERVALS, SHOWN};
use crate::scene::Scene;
use field::Scalar;
use integrators::{
    Family, Index2Dae, Index2DaeSystem, Index2Method, Method, Observer, Ode, Outcome, Record, Span, Splitting,
    Tolerance, integrate, integrate_index2,
};
use nalgebra::{DMatrix, DVector};
use simulation::{Axes, Law};
use std::sync::Arc;

/// The method of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    OneStep(OneStep),
    /// A splitting; only if all sub-flows have the equilibrium: otherwise the splitting's fixed point is not the law's
    /// motion.
    Splitting(Splitting),
}

/// A scene's law at a steady motion.
pub struct Runs {
    law: Arc<dyn Law>,
    state: Vec<f64>,
}

/// The initial deviation from the motion, relative to the size of each component or one.
const OFF: f64 = 1e-7;
/// The increment of a difference quotient, relative to the size of a component or one.
const DIFFERENCE: f64 = 1e-5;
/// The factor by which other modes are reduced before a run, and the largest number of squarings of a step for that.
const FADED: f64 = 1e-16;
const SQUARINGS: f64 = 24.0;
/// The number of first differences with which the others are compared.
const FIRST: usize = 2;
/// A run is decided when differences fall below this fraction of the first ones, or rise above it.
const GONE: f64 = 1e-5;
const LOST: f64 = 1e4;
/// The initial bracket of the bisection, as a relative distance to both sides of the known threshold, and the number of
/// bisections, which give an accuracy of 1/10000.
const REACH: f64 = 0.2;
const HALVINGS: u32 = 11;
/// The relative distance from a threshold that runs must resolve.
pub const APART: f64 = 2.5e-4;

impl Runs {
    /// Runs near a motion of a scene.
    pub fn near(scene: &Scene, motion: &Stationed) -> Self {
        let scene = Scene { start: motion.start.clone(), ..scene.clone() };
        let problem = scene.problem(Axes::Second);
        Runs { law: problem.law, state: problem.state }
    }

    /// The threshold, s, near a known one, at which runs begin or cease to leave the motion, to twice [`APART`]; `None`
    /// where no run can decide, or runs on both sides agree.
    pub fn threshold(&self, method: Run, near: f64, crossing: Crossing) -> Option<f64> {
        let steps = crossing.steps(APART)?;
        let start = self.along_the_mode(method, near, crossing.rest)?;
        // within the range where a step grows by at most e: a faster growth saturates before it is compared
        let reach = REACH.min(1.0 / crossing.steepness);
        let [mut low, mut high] = [1.0 - reach, 1.0 + reach].map(|share| share * near);
        let below = self.leaves(method, low, steps, &start);
        if self.leaves(method, high, steps, &start) == below {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.leaves(method, middle, steps, &start) == below { low = middle } else { high = middle }
        }
        Some(0.5 * (low + high))
    }

    /// An initial state displaced along the mode that crosses the unit circle at this step size: the others have
    /// decayed after many steps, and displacements that integrals conserve cancel in the difference of a step. `None`
    /// where a step fails.
    fn along_the_mode(&self, method: Run, step: f64, rest: f64) -> Option<Vec<f64>> {
        let n = self.state.len();
        let sizes = DVector::from_iterator(n, self.state.iter().map(|y| y.abs().max(1.0)));
        let mut map = DMatrix::zeros(n, n);
        for column in 0..n {
            let by = DIFFERENCE * sizes[column];
            let after = |by: f64| {
                let mut moved = self.state.clone();
                moved[column] += by;
                let outcome = self.run(method, step, 1, &moved, &mut Record::new());
                outcome.reached().then(|| DVector::from_vec(outcome.state))
            };
            map.set_column(column, &((after(by)? - after(-by)?) / (2.0 * by)));
        }
        let squarings = (-FADED.ln() / rest).log2().ceil().clamp(0.0, SQUARINGS) as usize;
        let power = (0..squarings).fold(map.clone(), |power, _| &power * &power);
        let any = DVector::from_fn(n, |k, _| sizes[k] * (1.0 + 0.37 * k as f64).sin());
        let moved = (map - DMatrix::identity(n, n)) * (power * any);
        let largest = moved.component_div(&sizes).amax();
        let start = self.state.iter().zip(moved.iter()).map(|(y, moved)| y + OFF * moved / largest);
        Some(start.collect()).filter(|start: &Vec<f64>| start.iter().all(|y| y.is_finite()))
    }

    /// Whether a run with this step size, s, and number of steps leaves the motion.
    ///
    /// The differences of successive states decide, since perturbations that integrals conserve cancel in them.
    fn leaves(&self, method: Run, step: f64, count: usize, start: &[f64]) -> bool {
        let mut watched = Watched { last: start.to_vec(), sizes: Vec::with_capacity(count) };
        let reached = self.run(method, step, count, start, &mut watched).reached();
        let seen = &watched.sizes;
        let stretch = (count as f64 / INTERVALS) as usize;
        let most = |window: std::ops::Range<usize>| seen[window].iter().copied().fold(0.0, f64::max);
        match watched.share() {
            Some(share) if share < GONE => false,
            Some(share) if share > LOST => true,
            _ if seen.len() < count => !reached,
            // growth may have saturated: only decreasing differences count as staying
            _ => most(count - stretch..count) >= (-0.5 * SHOWN).exp() * most(count - 2 * stretch..count - stretch),
        }
    }
}

impl Runs {
    fn run(
        &self,
        method: Run,
        step: f64,
        count: usize,
        start: &[f64],
        observer: &mut dyn Observer<f64>,
    ) -> Outcome<f64> {
        let span = Span::new(0.0, step * count as f64, start);
        let steps = u32::try_from(count).unwrap_or(u32::MAX);
        let run = |method: Method, observer| integrate(&*self.law, method, &Tolerance::both(1e-9), &span, observer);
        match method {
            Run::OneStep(OneStep::Classical(scheme)) => run(scheme.method(steps), observer),
            Run::Splitting(splitting) => run(Method::Split { splitting, steps }, observer),
            Run::OneStep(OneStep::Collocation(family, stages)) => {
                let holding = match family {
                    Family::Gauss => Index2Method::ProjectedGauss { stages, steps },
                    Family::RadauIIA => Index2Method::RadauIIA { stages, steps },
                };
                integrate_index2(&Free(&*self.law), holding, &span, observer)
            }
        }
    }
}

/// The magnitudes of the differences of successive states.
struct Watched {
    last: Vec<f64>,
    sizes: Vec<f64>,
}

impl Watched {
    /// The last difference relative to the largest of the first ones.
    fn share(&self) -> Option<f64> {
        let (first, rest) = self.sizes.split_at_checked(FIRST)?;
        Some(rest.last()? / first.iter().copied().fold(0.0, f64::max))
    }
}

impl Observer<f64> for Watched {
    fn step(&mut self, _time: f64, y: &[f64]) {
        let change = y.iter().zip(&self.last).map(|(y, last)| (y - last) * (y - last)).sum::<f64>();
        self.sizes.push(change.sqrt());
        self.last.copy_from_slice(y);
    }

    fn enough(&self) -> bool {
        self.share().is_some_and(|share| !(GONE..LOST).contains(&share))
    }
}

/// A law as a DAE without constraints, for collocation methods with a constant step size.
struct Free<'a>(&'a dyn Law);

impl<'a, S: Scalar> Index2Dae<S> for Free<'a>
where
    dyn Law + 'a: Ode<S>,
{
    fn sizes(&self) -> (usize, usize) {
        (Ode::<S>::dimension(self.0), 0)
    }

    fn rates(&self, t: S, y: &[S], _z: &[S], dy: &mut [S]) {
        Ode::<S>::rates(self.0, t, y, dy);
    }

    fn parts(&self, t: S, y: &[S], dy: &mut [S], _columns: &mut [S]) {
        Ode::<S>::rates(self.0, t, y, dy);
    }

    fn constraints(&self, _t: S, _y: &[S], _g: &mut [S]) {}
}

impl Index2DaeSystem for Free<'_> {}
