//! The one-step map of a splitting near its fixed point, by differentiation of the integrator's step.
//!
//! An equilibrium of the law need not be one of the sub-flows. A splitting therefore has a fixed point near the law's
//! steady motion, at a distance of its order; the two coincide if all sub-flows have the equilibrium (the carrier at
//! rest, a motor on its bench). The map is differentiated by central differences in double-double, accurate to 18
//! digits. A splitting conserves |v| and x.v, and its matrix is restricted to the leaf of these integrals. The test is
//! made for each requested step size. Proofs cover all step sizes between, and give the thresholds where they succeed.

use super::bench_proof::Resting;
use super::continuation::followed;
use super::gyrostat_proof::Turning;
use super::matrices::{complement, next_to, spectral_radius};
use super::motions::Stationed;
use super::reasons::Unproved;
use super::step_intervals::Proved;
use super::tested_steps::Tested;
use super::threshold_run_length::Crossing;
use crate::scene::Scene;
use field::DoubleDouble;
use integrators::{Composed, Real, Splitting};
use nalgebra::{DMatrix, DVector};
use simulation::{Axes, Invariant, Law, Problem};
use std::sync::Arc;

/// A scene's law at a steady motion.
pub struct SplitRuns {
    law: Arc<dyn Law>,
    state: Vec<f64>,
    /// All integrals except the energy, which a splitting does not conserve.
    kept: Vec<Invariant>,
    /// The data of a proof for all step sizes, or the reason against it.
    provable: Result<Provable, Unproved>,
}

/// The data of a proof.
enum Provable {
    Resting(Box<Resting>),
    Turning(Box<Turning>),
}

/// The fixed point of a splitting, with the multipliers there.
#[derive(Clone, Debug)]
pub struct Own {
    pub place: Vec<DoubleDouble>,
    /// The largest distance from the law's motion, by component.
    pub off: f64,
    /// The largest |multiplier|.
    pub radius: f64,
    /// The largest |multiplier| inside the radius, if multipliers could be separated.
    pub next: Option<f64>,
}

/// The increment of a difference quotient, relative to the maximum of the component and one.
const DIFFERENCE: f64 = 1e-9;
/// The largest number of Newton iterations for the fixed point, and the residual at which they end.
const ITERATIONS: usize = 12;
const CONVERGED: f64 = 1e-14;
/// The relative distance from a threshold at which the growth is evaluated.
const BESIDE: f64 = 1e-3;
/// A fixed point within this distance of the law's motion counts as equal to it.
const RESTS: f64 = 1e-9;
/// A spectral radius within this distance of one counts as one.
pub const ON_THE_CIRCLE: f64 = 1e-9;

impl SplitRuns {
    /// Splittings near a motion of a scene.
    pub fn near(scene: &Scene, motion: &Stationed) -> Self {
        let scene = Scene { start: motion.start.clone(), ..scene.clone() };
        let Problem { law, state, invariants, .. } = scene.problem(Axes::Second);
        let kept = invariants.into_iter().filter(|invariant| invariant.name != "jacobi").collect();
        let provable = match Resting::of(&scene, motion) {
            Some(resting) => Ok(Provable::Resting(Box::new(resting))),
            None => Turning::of(&scene, motion).map(Box::new).map(Provable::Turning),
        };
        SplitRuns { law, state, kept, provable }
    }

    /// Columns that span the tangent space of the leaf of the integrals at a state.
    fn surface(&self, place: &[DoubleDouble]) -> DMatrix<f64> {
        let place: Vec<f64> = place.iter().map(|y| y.hi()).collect();
        let gradients: Vec<DVector<f64>> = self.kept.iter().map(|invariant| gradient(invariant, &place)).collect();
        complement(&gradients, place.len())
    }

    /// The fixed point for a step size (s) by Newton's method, from that of another step size or from the law's motion.
    /// `None` where the law has no sub-flows, the step fails, or no fixed point is found.
    pub fn own(&self, splitting: Splitting, step: f64, near: Option<&Own>) -> Option<Own> {
        let mut map = self.law.composed_exact(splitting)?;
        map.prepare(DoubleDouble::from(step));
        let law = || self.state.iter().map(|y| DoubleDouble::from(*y)).collect();
        let mut place: Vec<DoubleDouble> = near.map_or_else(law, |own| own.place.clone());
        let mut surface = self.surface(&place);
        let mut matrix = derivative(&mut *map, &place, &surface)?;
        // an equilibrium of every sub-flow needs no search, however large the rounding
        let rests = matches!(&self.provable, Ok(Provable::Turning(turning)) if turning.rests());
        let mut found = false;
        for _ in 0..ITERATIONS {
            let end = after(&mut *map, &place)?;
            let missing = DVector::from_iterator(end.len(), end.iter().zip(&place).map(|(end, y)| (*end - *y).hi()));
            found = rests || missing.amax() < CONVERGED;
            if found {
                break;
            }
            let within = surface.transpose() * &missing;
            let identity = DMatrix::<f64>::identity(within.len(), within.len());
            let correction = &surface * (identity - &matrix).lu().solve(&within)?;
            for (y, by) in place.iter_mut().zip(correction.iter()) {
                *y += DoubleDouble::from(*by);
            }
            surface = self.surface(&place);
            matrix = derivative(&mut *map, &place, &surface)?;
        }
        let off = place.iter().zip(&self.state).map(|(own, law)| (own.hi() - law).abs()).fold(0.0, f64::max);
        let radius = spectral_radius(matrix.clone());
        let next = next_to(&matrix);
        (found && radius.is_finite()).then_some(Own { place, off, radius, next })
    }

    /// The longest step (s) for which the splitting is accepted: negative sub-steps must not amplify decaying
    /// components too much.
    pub fn longest(&self, splitting: Splitting) -> f64 {
        let Some(mut map) = self.law.composed(splitting) else { return 0.0 };
        map.enter(&self.state);
        splitting.longest_step(map.decay_rate())
    }

    /// Tests and proofs at ascending step sizes (s), up to the longest accepted one.
    pub fn course(&self, splitting: Splitting, steps: &[f64]) -> Tested {
        let longest = self.longest(splitting);
        let taken: Vec<f64> = steps.iter().copied().filter(|step| *step <= longest).collect();
        let own = followed(&taken, |step, near| self.own(splitting, step, near));
        let found = |step: &f64| own.iter().find(|(at, _)| at == step).map(|(_, own)| own.grows());
        let grows = steps.iter().map(|step| (*step, found(step))).collect();
        let turns = own.windows(2).filter(|pair| pair[0].1.grows() != pair[1].1.grows());
        let edge = |pair: &[(f64, Own)]| self.edge(splitting, &pair[0], &pair[1]);
        let known: Vec<f64> = taken.into_iter().filter(|step| found(step).is_some()).collect();
        let proved = match (&self.provable, known.first().zip(known.last())) {
            (Ok(provable), Some((first, last))) => Ok(provable.course(splitting, [*first, *last], &known)),
            (Ok(_), None) => Err(Unproved::Motion),
            (Err(reason), _) => Err(*reason),
        };
        let mut edges: Vec<f64> = match &proved {
            Ok(proved) => {
                let open = proved.open();
                let alone = turns.map(edge).filter(|at| open.iter().any(|[low, high]| (low..=high).contains(&at)));
                proved.edges().into_iter().map(|(at, _)| at).chain(alone).collect()
            }
            Err(_) => turns.map(edge).collect(),
        };
        edges.sort_by(f64::total_cmp);
        Tested { splitting, own, grows, edges, proved, longest }
    }

    /// The threshold between two step sizes (s) with different stability, by bisection.
    fn edge(&self, splitting: Splitting, (from, below): &(f64, Own), (to, _): &(f64, Own)) -> f64 {
        let (mut low, mut high) = (*from, *to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let grows = self.own(splitting, middle, Some(below)).map(|own| own.grows());
            if grows == Some(below.grows()) { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// The crossing at a threshold, from the growth on both sides of it. `None` where the fixed point is not the law's
    /// motion, from which runs start.
    pub fn crossing(&self, splitting: Splitting, edge: f64) -> Option<Crossing> {
        let beside = [1.0 - BESIDE, 1.0 + BESIDE].map(|side| self.own(splitting, side * edge, None));
        let [Some(below), Some(above)] = beside else { return None };
        let rests = below.off.max(above.off) < RESTS;
        let rest = below.next?.max(above.next?);
        let steepness = (above.radius / below.radius).ln().abs() / (2.0 * BESIDE);
        rests.then_some(Crossing { steepness, rest: -rest.ln() })
    }
}

impl Own {
    fn grows(&self) -> bool {
        self.radius > 1.0 + ON_THE_CIRCLE
    }
}

impl Provable {
    /// The verdicts for all step sizes in an interval (s), and at the requested ascending ones.
    fn course(&self, splitting: Splitting, ends: [f64; 2], steps: &[f64]) -> Proved {
        match self {
            Provable::Resting(resting) => resting.course(splitting, ends),
            Provable::Turning(turning) => turning.course(splitting, ends, steps),
        }
    }
}

/// The number of bisections of a bracket.
const HALVINGS: usize = 16;
/// The derivative of a step, restricted to the space that columns span.
fn derivative(
    map: &mut dyn Composed<DoubleDouble>,
    place: &[DoubleDouble],
    surface: &DMatrix<f64>,
) -> Option<DMatrix<f64>> {
    let n = place.len();
    let mut whole = DMatrix::zeros(n, n);
    for column in 0..n {
        let by = DoubleDouble::from(DIFFERENCE * place[column].hi().abs().max(1.0));
        let mut moved = place.to_vec();
        moved[column] = place[column] + by;
        let above = after(map, &moved)?;
        moved[column] = place[column] - by;
        let below = after(map, &moved)?;
        for row in 0..n {
            whole[(row, column)] = ((above[row] - below[row]) / (by + by)).hi();
        }
    }
    Some(surface.transpose() * whole * surface)
}

/// The state after one step.
fn after(map: &mut dyn Composed<DoubleDouble>, from: &[DoubleDouble]) -> Option<Vec<DoubleDouble>> {
    map.enter(from);
    let mut end = from.to_vec();
    map.advance().then(|| map.leave(&mut end))?;
    end.iter().all(|y| y.finite()).then_some(end)
}

/// The gradient by central differences, which are exact for quadratic integrals.
fn gradient(invariant: &Invariant, state: &[f64]) -> DVector<f64> {
    let slope = |k: usize| {
        let at = |by: f64| {
            let mut moved = state.to_vec();
            moved[k] += by;
            (invariant.value)(0.0, &moved)
        };
        0.5 * (at(1.0) - at(-1.0))
    };
    DVector::from_iterator(state.len(), (0..state.len()).map(slope))
}
