//! First integrals of a scene's motion as functions of its state: the energy and momenta of cyclic coordinates.
//!
//! Loads without a given energy have a potential if their power is Q . u with a gradient Q(q) that does not depend on speeds. From the
//! start q0,
//!
//!   V(q) = -integral of Q(q0 + s (q - q0)) . (q - q0) over s from 0 to 1 ,
//!
//! computed by Gauss quadrature, whose error is below rounding for smooth loads.

use crate::changing_laws::is_watched;
use crate::letters::Letters;
use crate::program::recorded;
use crate::scene::ModelScene;
use integrators::{Collocation, Family};
use model::equations::vanishes;
use model::{Model, PowerBalance, Trace, kept_momenta};
use simulation::integral_drift::Integral;
use simulation::problem::Function;
use simulation::{Axes, IvpScene, Problem};
use std::f64::consts::TAU;
use std::sync::Arc;
use symbolic::{Sym, apart};

/// The number of nodes of the Gauss quadrature.
const POINTS: usize = 20;

/// The largest number of speeds for which the gradient is tested: the work is quadratic in this number.
const MOST_ASKED: usize = 10;

/// A scene as a problem with its first integrals.
pub struct SceneWithIntegrals {
    /// The problem, without the integrals.
    pub problem: Problem,
    /// The first integrals; momenta of cyclic coordinates are last.
    pub integrals: Vec<Integral>,
    /// Indices of state components that may differ after a period: cyclic coordinates and work.
    idle: Vec<usize>,
    /// Indices of the coordinates without a dimension, which are treated as angles.
    angles: Vec<usize>,
    /// Indices in the state of the speeds of cyclic coordinates.
    cyclic: Vec<usize>,
}

impl SceneWithIntegrals {
    /// A problem with the invariants that it defines itself.
    pub fn plain(mut problem: Problem) -> Self {
        let integrals = std::mem::take(&mut problem.invariants).into_iter().map(Integral::from).collect();
        SceneWithIntegrals { problem, integrals, idle: Vec::new(), angles: Vec::new(), cyclic: Vec::new() }
    }

    /// A scene with its integrals; `None` if its law changes at conditions, contacts or events.
    pub fn of(scene: &ModelScene) -> Option<Self> {
        let model = &*scene.model;
        if is_watched(model) {
            return None;
        }
        let plain = scene.problem(Axes::default());
        let mut integrals: Vec<Integral> = Vec::new();
        let metered = scene.metered(Axes::default());
        let balanced = if metered.metered == 0 { None } else { energy_of_loads(model, &plain.state) };
        let mut problem =
            if metered.metered == 0 || balanced.is_some() { plain } else { scene.metered(Axes::default()) };
        match balanced {
            Some(energy) => integrals.push(energy),
            None => integrals.extend(metered.invariants.into_iter().map(Integral::from)),
        }
        problem.invariants.clear();
        let (momenta, idle) = momenta(model, problem.state.len() - problem.metered);
        integrals.extend(momenta);
        let angles = |k: &usize| model.coordinates[*k].is_angle();
        let work = problem.state.len() - problem.metered..problem.state.len();
        Some(SceneWithIntegrals {
            angles: (0..model.coordinates.len()).filter(angles).collect(),
            cyclic: idle.iter().map(|k| model.positions() + k).collect(),
            idle: idle.into_iter().chain(work).collect(),
            problem,
            integrals,
        })
    }

    /// The integral E - sum u p, J, minus its value at a steady motion, with the energy E, the cyclic speeds u of the steady motion and
    /// their momenta p. The integral is of second order in the deviation from the steady motion.
    pub fn energy_about(&self, steady: &[f64]) -> Integral {
        let first = self.integrals.len() - self.cyclic.len();
        let energy = self.integrals.first().map(|energy| (1.0, Arc::clone(&energy.value)));
        let momenta = self.integrals.iter().skip(first).zip(&self.cyclic);
        let parts =
            energy.into_iter().chain(momenta.map(|(momentum, &speed)| (-steady[speed], Arc::clone(&momentum.value))));
        let parts: Vec<(f64, Arc<Function>)> = parts.filter(|(factor, _)| *factor != 0.0).collect();
        let sum = move |time: f64, state: &[f64]| -> f64 {
            parts.iter().map(|(factor, value)| factor * value(time, state)).sum()
        };
        let about = sum(0.0, steady);
        let value = Arc::new(move |time: f64, state: &[f64]| sum(time, state) - about);
        Integral { name: "energy of the oscillation".to_owned(), unit: "J".to_owned(), value, size: None }
    }

    /// The difference of a state component between end and start: modulo 2 pi for angles, zero for cyclic coordinates and work.
    pub fn gap(&self, component: usize, end: f64, start: f64) -> f64 {
        let gap = end - start;
        match component {
            k if self.idle.contains(&k) => 0.0,
            k if self.angles.contains(&k) => gap - (gap / TAU).round() * TAU,
            _ => gap,
        }
    }
}

/// The energy including the potential of the loads, J; `None` if the loads have no potential.
fn energy_of_loads(model: &Model, start: &[f64]) -> Option<Integral> {
    let n = model.speeds();
    if model.positions() != n || start.len() != 2 * n || n > MOST_ASKED {
        return None;
    }
    let mut has_energy = false;
    let program = recorded(2 * n, |time, state| {
        let trace = Trace::of(model);
        let PowerBalance { energy, power } = PowerBalance::of(&trace);
        let loads: Vec<Sym> = trace.speeds.iter().map(|&speed| power.diff(speed)).collect();
        has_energy = are_gradient(&trace, power, &loads) && vanishes(energy.diff(trace.time));
        let all: Vec<Sym> =
            [energy, trace.kinetic_energy(), trace.potential_energy()].into_iter().chain(loads).collect();
        Letters::with_data(time, state).put_into(&trace, &all)
    });
    let program = program.ok().filter(|_| has_energy)?;
    let rule = Collocation::<f64>::new(Family::Gauss, POINTS);
    let values = move |time: f64, state: &[f64]| {
        let mut values = vec![f64::NAN; 3 + n];
        // the program was compiled for this length, so it cannot fail
        program.run(time, state, &mut values).unwrap_or(());
        values
    };
    let begin = start[..n].to_vec();
    let energies = move |time: f64, state: &[f64]| -> [f64; 4] {
        let at = values(time, state);
        let mut between = state.to_vec();
        let work = rule.nodes.iter().zip(&rule.weights).map(|(node, weight)| {
            between.iter_mut().zip(&begin).zip(state).for_each(|((q, from), to)| *q = from + node * (to - from));
            let loads = values(time, &between);
            weight * (0..n).map(|i| loads[3 + i] * (state[i] - begin[i])).sum::<f64>()
        });
        [at[0], at[1], at[2], -work.sum::<f64>()]
    };
    let (of_size, [_, _, first, _]) = (energies.clone(), energies(0.0, start));
    let size = move |time: f64, state: &[f64]| {
        let [_, kinetic, potential, of_loads] = of_size(time, state);
        kinetic.abs() + (potential - first).abs() + of_loads.abs()
    };
    let value = move |time: f64, state: &[f64]| {
        let [energy, _, _, of_loads] = energies(time, state);
        energy + of_loads
    };
    Some(Integral {
        name: "energy".to_owned(),
        unit: "J".to_owned(),
        value: Arc::new(value),
        size: Some(Arc::new(size)),
    })
}

/// True if loads with this power are the gradient of a function of the coordinates.
fn are_gradient(trace: &Trace<'_>, power: Sym, loads: &[Sym]) -> bool {
    let all = loads.iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&load, &speed)| sum + load * speed);
    let knows_more = |load: &Sym| {
        let known = load.symbols_of();
        let is_other = |letter: &Sym| *letter == trace.time || trace.speeds.contains(letter);
        known.iter().any(|letter| is_other(letter) || trace.accelerations.contains(letter))
    };
    let (n, q) = (loads.len(), &trace.coordinates);
    !loads.iter().any(knows_more)
        && vanishes(power - all)
        && (0..n).all(|i| (0..i).all(|j| vanishes(loads[i].diff(q[j]) - loads[j].diff(q[i]))))
}

/// Momenta of cyclic coordinates, and the indices of these coordinates. `states` is the number of state components without work.
fn momenta(model: &Model, states: usize) -> (Vec<Integral>, Vec<usize>) {
    let kept = apart(|| {
        let trace = Trace::of(model);
        kept_momenta(&trace).into_iter().map(|(speed, _)| (speed, trace.direction(speed))).collect::<Vec<_>>()
    });
    let program = recorded(states, |time, state| {
        let trace = Trace::of(model);
        let momenta: Vec<Sym> = kept_momenta(&trace).into_iter().map(|(_, momentum)| momentum).collect();
        Letters::with_data(time, state).put_into(&trace, &momenta)
    });
    let Ok(program) = program else { return (Vec::new(), Vec::new()) };
    let count = kept.len();
    let of = |(place, (_, name)): (usize, &(usize, String))| {
        let program = program.clone();
        let value = move |time: f64, state: &[f64]| {
            let mut values = vec![f64::NAN; count];
            // integrated quantities, such as work, are behind the state
            program.run(time, &state[..states], &mut values).unwrap_or(());
            values[place]
        };
        Integral { name: format!("momentum of {name}"), unit: String::new(), value: Arc::new(value), size: None }
    };
    let integrals = kept.iter().enumerate().map(of).collect();
    let own = model.positions() == model.speeds();
    (integrals, kept.iter().map(|(speed, _)| *speed).filter(|_| own).collect())
}
