//! Thresholds by runs: the step from which on a perturbed motion stays near under a method, or leaves.

use super::methods::OneStep;
use super::motions::Stationed;
use crate::scene::problem::Law;
use crate::scene::{Axes, Scene};
use field::Scalar;
use integrators::{
    Family, Held, HeldSystem, Holding, Method, Observer, Ode, Span, Splitting, Tolerance, hold, integrate,
};
use std::sync::Arc;

/// What is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    OneStep(OneStep),
    /// Where all pieces rest: elsewhere its own stationary motion is not the law's.
    Splitting(Splitting),
}

/// A scene's law at a stationary motion.
pub struct Runs {
    law: Arc<dyn Law>,
    state: Vec<f64>,
}

/// How far a run begins from the motion, against the size of each component or one.
const OFF: f64 = 1e-7;
/// Steps of a run, of the windows over which its last differences are looked at, and of its beginning.
const STEPS: usize = 1_600;
const WINDOW: usize = 160;
const FIRST: usize = 2;
/// Less, or more, than this of the first differences, and the run has told its fate.
const GONE: f64 = 1e-5;
const LOST: f64 = 1e4;
/// Halvings of an interval of steps.
const HALVINGS: u32 = 9;

impl Runs {
    /// Near a motion of a scene.
    pub fn near(scene: &Scene, motion: &Stationed) -> Self {
        let scene = Scene { start: motion.start.clone(), ..scene.clone() };
        let problem = scene.problem(Axes::Second);
        Runs { law: problem.law, state: problem.state }
    }

    /// The step, s, near a known one at which runs turn from staying to leaving, or from leaving to staying; `None` where they
    /// do the same on both sides.
    pub fn threshold(&self, method: Run, near: f64) -> Option<f64> {
        let (mut low, mut high) = (0.8 * near, 1.25 * near);
        let below = self.leaves(method, low);
        if self.leaves(method, high) == below {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.leaves(method, middle) == below { low = middle } else { high = middle }
        }
        Some(0.5 * (low + high))
    }

    /// Whether a run with this step leaves the motion.
    ///
    /// The differences of neighbouring states tell: what integrals keep of a perturbation drops out of them.
    pub fn leaves(&self, method: Run, step: f64) -> bool {
        let off = |(k, y): (usize, &f64)| y + OFF * y.abs().max(1.0) * (1.0 + 0.37 * k as f64).sin();
        let start: Vec<f64> = self.state.iter().enumerate().map(off).collect();
        let mut watched = Watched { last: start.clone(), sizes: Vec::with_capacity(STEPS) };
        let span = Span::new(0.0, step * STEPS as f64, &start);
        let steps = STEPS as u32;
        let mut run = |method: Method| integrate(&*self.law, method, &Tolerance::both(1e-9), &span, &mut watched);
        let reached = match method {
            Run::OneStep(OneStep::Classical(scheme)) => run(scheme.method(steps)).reached(),
            Run::Splitting(splitting) => run(Method::Split { splitting, steps }).reached(),
            Run::OneStep(OneStep::Collocation(family, stages)) => {
                let holding = match family {
                    Family::Gauss => Holding::ProjectedGauss { stages, steps },
                    Family::RadauIIA => Holding::RadauIIA { stages, steps },
                };
                hold(&Free(&*self.law), holding, &span, &mut watched).reached()
            }
        };
        let seen = &watched.sizes;
        let most = |window: std::ops::Range<usize>| seen[window].iter().copied().fold(0.0, f64::max);
        match watched.share() {
            Some(share) if share < GONE => false,
            Some(share) if share > LOST => true,
            _ if seen.len() < STEPS => !reached,
            _ => most(STEPS - WINDOW..STEPS) >= most(STEPS - 2 * WINDOW..STEPS - WINDOW),
        }
    }
}

/// The sizes of the differences of neighbouring states.
struct Watched {
    last: Vec<f64>,
    sizes: Vec<f64>,
}

impl Watched {
    /// The last difference against the largest of the first.
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

/// A law that nothing holds: what has a constant step among the methods for held laws runs it too.
struct Free<'a>(&'a dyn Law);

impl<'a, S: Scalar> Held<S> for Free<'a>
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

impl HeldSystem for Free<'_> {}
