//! The regulated nonlinear model: the reference motion, the motion from a displaced start under feedback, and its cost.

use super::METHOD;
use super::criterion::opened;
use super::horizon::Backwards;
use super::states::States;
use crate::compiled_system::{NotCompiled, rates, values};
use crate::letters::Letters;
use crate::modes::Mode;
use crate::program::recorded;
use field::{DoubleDouble, Over, Rational};
use integrators::{Dual8, Ode, Outcome, Real, Record, Span, System, Tolerance, integrate};
use model::{Model, Regulator, Trace};
use nalgebra::DMatrix;
use simulation::Program;
use simulation::events::Passage;
use std::borrow::Cow;
use std::cell::RefCell;
use std::time::Instant;
use symbolic::{Sym, apart, substitute_all};

/// Feedback gains K of u = u0 - K x: constant, or functions of the time on a finite horizon.
#[derive(Clone, Debug)]
pub(super) enum Gains {
    Lasting(DMatrix<f64>),
    Along(Backwards),
}

impl Gains {
    /// The gain matrix at a time in seconds, inputs by states; empty where the Riccati equation has no solution.
    pub fn at(&self, time: f64) -> Cow<'_, DMatrix<f64>> {
        match self {
            Gains::Lasting(gains) => Cow::Borrowed(gains),
            Gains::Along(backwards) => Cow::Owned(backwards.gains(time).unwrap_or_default()),
        }
    }
}

/// The largest number of gains that is supported.
pub(super) const MOST: usize = 256;

/// Rates of the reference state, the regulated state and the cost, compiled with the gains as further inputs. The program returns the
/// rates and then the inputs u.
struct ClosedLoop<'a> {
    program: Program,
    gains: &'a Gains,
    states: usize,
    count: usize,
    chosen: usize,
    room: (Room<f64>, Room<Dual8>, Room<DoubleDouble>),
}

/// Buffers for the inputs and outputs of the program.
type Room<S> = RefCell<[Vec<S>; 2]>;

macro_rules! runs {
    ($($field:ty, $room:tt, $approximate:expr);*) => {$(
        impl Ode<$field> for ClosedLoop<'_> {
            fn dimension(&self) -> usize {
                2 * self.states + 1
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                let [all, out] = &mut *self.room.$room.borrow_mut();
                all.resize(y.len() + self.count, <$field>::lift(0.0));
                out.resize(y.len() + self.chosen, <$field>::lift(0.0));
                all[..y.len()].copy_from_slice(y);
                let approximate: fn($field) -> f64 = $approximate;
                // NaN as a gain makes all rates NaN, which ends the run
                all[y.len()..].fill(<$field>::lift(f64::NAN));
                for (place, gain) in all[y.len()..].iter_mut().zip(self.gains.at(approximate(t)).iter()) {
                    *place = <$field>::lift(*gain);
                }
                self.program.run(t, all, out).unwrap_or(());
                dy.copy_from_slice(&out[..y.len()]);
            }
        }
    )*};
}
runs!(f64, 0, |t| t; Dual8, 1, |t| t.re; DoubleDouble, 2, |t| t.approx());

impl System for ClosedLoop<'_> {}

impl ClosedLoop<'_> {
    /// The inputs u of the regulated system at a state of the closed loop.
    fn inputs(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; state.len()];
        Ode::<f64>::rates(self, time, state, &mut rates);
        self.room.0.borrow()[1][state.len()..].to_vec()
    }
}

/// A run of the regulated system.
#[derive(Clone, Debug)]
pub struct ClosedRun {
    /// The end of the integration of the reference, the regulated motion and the cost together.
    pub outcome: Outcome<f64>,
    /// Times of the samples in seconds, from 0.
    pub times: Vec<f64>,
    /// The states of the regulated motion at `times` (s): coordinates, then speeds.
    pub states: Vec<Vec<f64>>,
    /// The regulated states minus those of the reference motion.
    pub deviations: Vec<Vec<f64>>,
    /// The inputs u at `times`, in SI units.
    pub inputs: Vec<Vec<f64>>,
    /// The integral of the cost from 0 to each time.
    pub costs: Vec<f64>,
    /// Instants at which the law or, by an event, the state changes.
    pub passages: Vec<Passage>,
    /// The reason if the law of the run ends before its span.
    pub left: Option<&'static str>,
}

/// Runs the closed loop from a start and a displaced start; `places` are the indices of the variations in the state.
///
/// # Errors
/// If the equations of motion cannot be compiled.
pub(super) fn run(
    (model, regulator): (&Model, &Regulator),
    (places, known, gains_of): (&[usize], &States, &Gains),
    [start, displaced]: [&[f64]; 2],
    (span, tolerance, samples): (f64, f64, usize),
    deadline: Instant,
) -> Result<ClosedRun, NotCompiled> {
    let open = opened(model, regulator);
    let (states, chosen, count) = (start.len(), regulator.inputs.len(), known.kept.len() * regulator.inputs.len());
    let written = |time: Sym, state: &[Sym]| rates(&open, &Mode::default(), Letters::with_data(time, state));
    // reports the reason if the equations cannot be compiled
    apart(|| {
        let state: Vec<Sym> = (0..states).map(|place| Sym::symbol(&format!("y{place}"))).collect();
        written(Sym::symbol("t"), &state).map(|_| ())
    })?;
    let program = recorded(2 * states + 1 + count, |time, all| {
        let (own, rest) = all.split_at(states);
        let (moved, rest) = rest.split_at(states);
        let gains = &rest[1..];
        let (trace, given) = (Trace::of(&open), Trace::of(model));
        let inputs = || regulator.inputs.iter().map(|&input| &model.inputs[input]);
        let letters: Vec<Sym> = inputs().map(|input| Sym::symbol(&input.name)).collect();
        // inputs of the reference motion
        let values_given: Vec<Sym> =
            inputs().map(|input| input.value.map_or(Sym::ZERO, |value| given.scalar(value))).collect();
        let values_given = substitute_all(&values_given, &values(&given, time, own));
        let deviation = |place: usize| moved[place] - own[place];
        // states of the linear equations from deviations of the nonlinear state
        let varied = known.by_variations.row_iter().map(|row| {
            let parts = places.iter().zip(row.iter()).filter(|(_, factor)| **factor != 0.0);
            parts.fold(Sym::ZERO, |sum, (&place, &factor)| {
                sum + Sym::constant(Rational::exactly(factor)) * deviation(place)
            })
        });
        let varied: Vec<Sym> = varied.collect();
        let added: Vec<Sym> = (0..chosen)
            .map(|row| {
                let terms = varied.iter().enumerate().map(|(k, &state)| gains[k * chosen + row] * state);
                -terms.fold(Sym::ZERO, |sum, term| sum + term)
            })
            .collect();
        let sums: Vec<Sym> = values_given.iter().zip(&added).map(|(given, by)| *given + *by).collect();
        let with = |state: &[Sym], by: &[Sym]| -> Vec<Sym> {
            let known: Vec<(Sym, Sym)> = letters.iter().copied().zip(by.iter().copied()).collect();
            substitute_all(&written(time, state).unwrap_or_default(), &known)
        };
        let own_letters = trace.coordinates.iter().chain(&trace.speeds).copied();
        let deviations = own_letters.clone().enumerate().map(|(place, letter)| (letter, deviation(place)));
        let deviations: Vec<(Sym, Sym)> =
            deviations.chain(letters.iter().copied().zip(added.iter().copied())).collect();
        let state: Vec<Sym> = own_letters.collect();
        let cost = Letters::with_data(time, &state).put_into(&trace, &[trace.scalar(regulator.cost)])[0];
        let of_own = match gains_of {
            // the reference is an equilibrium or a steady motion: its speeds are constant, also against rounding
            Gains::Lasting(_) => own[states / 2..].iter().copied().chain(vec![Sym::ZERO; states / 2]).collect(),
            Gains::Along(_) => with(own, &values_given),
        };
        [of_own, with(moved, &sums), vec![cost.substitute(&deviations)], sums].concat()
    })?;
    let law = ClosedLoop { program, gains: gains_of, states, count, chosen, room: Default::default() };
    let both = [start, displaced, &[0.0]].concat();
    let mut span = Span::new(0.0, span, &both).with_deadline(deadline);
    span.outputs = (1..=samples).map(|k| span.end * k as f64 / samples as f64).collect();
    let mut record = Record::new();
    let outcome = integrate(&law, METHOD, &Tolerance::both(tolerance), &span, &mut record);
    let (mut times, mut all) = (record.times, record.states);
    if times.first().is_none_or(|first| *first > 0.0) {
        times.insert(0, 0.0);
        all.insert(0, both.clone());
    }
    let part = |from: usize, to: usize| all.iter().map(|state| state[from..to].to_vec()).collect::<Vec<_>>();
    let (own, moved) = (part(0, states), part(states, 2 * states));
    let deviations = moved.iter().zip(&own).map(|(one, other)| one.iter().zip(other).map(|(a, b)| a - b).collect());
    Ok(ClosedRun {
        deviations: deviations.collect(),
        inputs: times.iter().zip(&all).map(|(&time, state)| law.inputs(time, state)).collect(),
        costs: all.iter().map(|state| state[2 * states]).collect(),
        states: moved,
        passages: Vec::new(),
        left: None,
        times,
        outcome,
    })
}
