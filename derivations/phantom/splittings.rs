//! The one-step map of a splitting near a stationary motion of its own, by differentiation of the very step that runs.
//!
//! The pieces of a law do not rest where their sum does, so that a splitting has a stationary motion of its own near the
//! true one, with the error of its order; where all pieces rest (the carrier at rest, a motor on its bench) it is the
//! same. There the map is differentiated by central differences in double-double, which leave 18 digits. A splitting keeps |v|
//! and x.v, so that its matrix is looked at on the surface of these alone. So it is tested at each step that is asked for; what
//! it does at every step between them is proved besides, and the edges are those of the proof where that comes to them.

use super::crossing::Crossing;
use super::enclosed::Resting;
use super::matrices::{complement, next_to, spectral_radius};
use super::motions::Stationed;
use super::stretches::{Proved, does};
use super::turning::Turning;
use super::unproved::Unproved;
use crate::scene::problem::Law;
use crate::scene::{Axes, Invariant, Problem, Scene};
use field::DoubleDouble;
use integrators::{Composed, Real, Splitting};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// A scene's law at a stationary motion.
pub struct SplitRuns {
    law: Arc<dyn Law>,
    state: Vec<f64>,
    /// All but the energy, which is an integral of the law and not of a splitting.
    kept: Vec<Invariant>,
    /// What is known of every step.
    provable: Result<Provable, Unproved>,
}

/// What a proof starts from.
enum Provable {
    Resting(Box<Resting>),
    Turning(Turning),
}

/// A splitting's own stationary motion, and what its step makes of it.
#[derive(Clone, Debug)]
pub struct Own {
    /// The largest distance from the law's, by component.
    pub off: f64,
    /// The largest |multiplier|.
    pub radius: f64,
    /// The largest that is no further out, where the multipliers could be told apart.
    pub next: Option<f64>,
}

/// What a splitting was seen to do near a motion.
#[derive(Clone, Debug)]
pub struct Tested {
    pub splitting: Splitting,
    /// Whether anything grows, at each step, s, that was asked for; `None` where no step is taken, or no motion of the
    /// splitting's own is found.
    pub grows: Vec<(f64, Option<bool>)>,
    /// Between them, where that changes, s: by the proof where there is one.
    pub edges: Vec<f64>,
    /// What it does at every step between the first and the last, or why nothing is proved of that.
    pub proved: Result<Proved, Unproved>,
    /// The longest step that the program takes, s; zero where the law has no splitting.
    pub longest: f64,
}

impl Tested {
    /// In a line.
    pub fn told(&self) -> String {
        if self.longest == 0.0 {
            return format!("there is none, since {}", Unproved::Fed);
        }
        let known: Vec<(f64, bool)> = self.grows.iter().filter_map(|(step, grows)| Some((*step, (*grows)?))).collect();
        let (Some((from, grows)), Some((to, _))) = (known.first(), known.last()) else {
            return "no step is taken, or no stationary motion of its own is found".to_owned();
        };
        let longest =
            if self.longest.is_finite() { format!("; no step beyond {:.4e}", self.longest) } else { String::new() };
        match &self.proved {
            Ok(proved) => {
                let alone = proved.open().into_iter().map(|ends| self.tested_alone(proved, ends)).collect::<String>();
                format!("proved from {from:.1e} to {to:.1e}: the map {}{alone}{longest}", proved.told())
            }
            Err(reason) => {
                let turns = self
                    .edges
                    .iter()
                    .enumerate()
                    .map(|(place, edge)| format!(", {} from h = {edge:.4e} on", does(*grows != (place % 2 == 0))));
                let told = turns.fold(does(*grows).to_owned(), |told, turn| told + &turn);
                format!("tested from {from:.1e} to {to:.1e}, since {reason}: the map {told}{longest}")
            }
        }
    }

    /// What was seen where the proof leaves something open.
    fn tested_alone(&self, proved: &Proved, [low, high]: [f64; 2]) -> String {
        let inside = self.grows.iter().filter(|(step, _)| (low..=high).contains(step));
        let seen: Vec<(f64, bool)> = inside.filter_map(|(step, grows)| Some((*step, (*grows)?))).collect();
        let steps = seen.len();
        let growing = seen.iter().filter(|(_, grows)| *grows).count();
        let says = match seen.iter().filter(|(step, _)| proved.at(*step).is_some()).count() {
            0 => "tested".to_owned(),
            known if known == steps => "proved step by step".to_owned(),
            known => format!("tested, {known} proved,"),
        };
        if steps == 0 {
            return String::new();
        }
        format!("; {says} from {low:.4e} to {high:.4e}: grows at {growing} of {steps} steps")
    }

    /// Whether a step is refused, since what fades would grow on its way back.
    pub fn refuses(&self, step: f64) -> bool {
        step > self.longest
    }
}

/// Of a difference, relative to a component or one.
const DIFFERENCE: f64 = 1e-9;
/// Of Newton's iteration towards the own motion.
const ITERATIONS: usize = 12;
const CONVERGED: f64 = 1e-14;
/// So far beside an edge the growth is looked at, as a share of it.
const BESIDE: f64 = 1e-3;
/// A motion of a splitting's own that is no further from the law's is the law's.
const RESTS: f64 = 1e-9;
/// A radius so near to one is one.
pub const ON_THE_CIRCLE: f64 = 1e-9;

impl SplitRuns {
    /// Near a motion of a scene.
    pub fn near(scene: &Scene, motion: &Stationed) -> Self {
        let scene = Scene { start: motion.start.clone(), ..scene.clone() };
        let Problem { law, state, invariants, .. } = scene.problem(Axes::Second);
        let kept = invariants.into_iter().filter(|invariant| invariant.name != "jacobi").collect();
        let provable = match Resting::of(&scene, motion) {
            Some(resting) => Ok(Provable::Resting(Box::new(resting))),
            None => Turning::of(&scene, motion).map(Provable::Turning),
        };
        SplitRuns { law, state, kept, provable }
    }

    /// Columns that span the surface of the integrals at a state.
    fn surface(&self, place: &[DoubleDouble]) -> DMatrix<f64> {
        let place: Vec<f64> = place.iter().map(|y| y.hi()).collect();
        let gradients: Vec<DVector<f64>> = self.kept.iter().map(|invariant| gradient(invariant, &place)).collect();
        complement(&gradients, place.len())
    }

    /// With steps of a length, s. `None` where the law has no pieces, the step leads nowhere, or no stationary motion is
    /// found near the law's.
    pub fn own(&self, splitting: Splitting, step: f64) -> Option<Own> {
        let mut map = self.law.composed_exact(splitting)?;
        map.prepare(DoubleDouble::from(step));
        let mut place: Vec<DoubleDouble> = self.state.iter().map(|y| DoubleDouble::from(*y)).collect();
        let mut surface = self.surface(&place);
        let mut matrix = derivative(&mut *map, &place, &surface)?;
        // what keeps every piece needs no search, however fast rounding grows
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
        (found && radius.is_finite()).then_some(Own { off, radius, next })
    }

    /// The longest step, s, with which the program takes the splitting at all: what fades must not grow on the way back.
    pub fn longest(&self, splitting: Splitting) -> f64 {
        let Some(mut map) = self.law.composed(splitting) else { return 0.0 };
        map.enter(&self.state);
        splitting.longest_step(map.fading())
    }

    /// What the map does with steps up to the longest of these, s, in ascending order.
    pub fn course(&self, splitting: Splitting, steps: &[f64]) -> Tested {
        let longest = self.longest(splitting);
        let grows = |step: f64| self.own(splitting, step).map(|own| own.radius > 1.0 + ON_THE_CIRCLE);
        let each: Vec<(f64, Option<bool>)> =
            steps.iter().map(|step| (*step, if *step <= longest { grows(*step) } else { None })).collect();
        let known: Vec<(f64, bool)> = each.iter().filter_map(|(step, grows)| Some((*step, (*grows)?))).collect();
        let turns = known.windows(2).filter(|pair| pair[0].1 != pair[1].1);
        let edge = |pair: &[(f64, bool)]| {
            let (mut low, mut high) = (pair[0].0, pair[1].0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if grows(middle).unwrap_or(pair[1].1) == pair[0].1 { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        };
        let proved = match (&self.provable, known.first().zip(known.last())) {
            (Ok(provable), Some((first, last))) => {
                let mut proved = provable.course(splitting, [first.0, last.0]);
                let open = known.iter().filter(|(step, _)| proved.at(*step).is_none());
                let alone = open.filter_map(|(step, _)| Some((*step, provable.at(splitting, *step)?)));
                proved.alone = alone.collect();
                Ok(proved)
            }
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
        Tested { splitting, edges, longest, grows: each, proved }
    }

    /// How a run can see an edge: by the growth beside it, which changes evenly there. `None` where the splitting does not rest with
    /// the law: then its runs see the motion of its own too.
    pub fn crossing(&self, splitting: Splitting, edge: f64) -> Option<Crossing> {
        let beside = [1.0 - BESIDE, 1.0 + BESIDE].map(|side| self.own(splitting, side * edge));
        let [Some(below), Some(above)] = beside else { return None };
        let rests = below.off.max(above.off) < RESTS;
        let rest = below.next?.max(above.next?);
        let steepness = (above.radius / below.radius).ln().abs() / (2.0 * BESIDE);
        rests.then_some(Crossing { steepness, rest: -rest.ln() })
    }
}

impl Provable {
    fn course(&self, splitting: Splitting, ends: [f64; 2]) -> Proved {
        match self {
            Provable::Resting(resting) => resting.course(splitting, ends),
            Provable::Turning(turning) => turning.course(splitting, ends),
        }
    }

    /// At one step, s. On a bench ranges are narrowed down to thresholds.
    fn at(&self, splitting: Splitting, step: f64) -> Option<bool> {
        match self {
            Provable::Resting(_) => None,
            Provable::Turning(turning) => turning.at(splitting, step),
        }
    }
}

/// Halvings of a bracket.
const HALVINGS: usize = 16;
/// The derivative of a step on the surface that columns span.
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

/// One step.
fn after(map: &mut dyn Composed<DoubleDouble>, from: &[DoubleDouble]) -> Option<Vec<DoubleDouble>> {
    map.enter(from);
    let mut end = from.to_vec();
    map.advance().then(|| map.leave(&mut end))?;
    end.iter().all(|y| y.finite()).then_some(end)
}

/// By central differences, which are exact for the squares that these integrals are.
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
