//! Speeds without inertia that a mode does not give by an expression: roots of their laws, by Newton's method from their last values.

use crate::compiled_system::NotCompiled;
use crate::letters::Letters;
use crate::modes::{Mode, ModeMotion, Parted, eliminated};
use crate::program::recorded;
use integrators::Real;
use model::{Model, Trace};
use simulation::{Program, Running};
use symbolic::{Derivation, Sym, apart, substitute_all};

/// Steps of Newton's method: from the values in the mode before five are usual.
const MOST_STEPS: usize = 60;

/// The step by which these speeds come nearer to the roots of their laws, as a program of the state.
#[derive(Debug)]
pub(crate) struct ImplicitSpeeds {
    /// By their places among the speeds.
    places: Vec<usize>,
    steps: Program,
}

impl ImplicitSpeeds {
    /// The implicit speeds of a mode; `None` where each algebraic speed has an expression.
    pub fn of(model: &Model, mode: &Mode) -> Result<Option<Self>, NotCompiled> {
        let places = apart(|| -> Result<Vec<usize>, NotCompiled> {
            let trace = Trace::of(model);
            let implicit = ModeMotion::of(&trace, mode)?.implicit;
            let place = |letter: Sym| trace.speeds.iter().position(|speed| *speed == letter);
            Ok(implicit.into_iter().filter_map(|(letter, _)| place(letter)).collect())
        })?;
        if places.is_empty() {
            return Ok(None);
        }
        let implicit =
            |trace: &Trace<'_>| ModeMotion::of(trace, mode).map(|motion| motion.implicit).unwrap_or_default();
        Ok(Some(ImplicitSpeeds { places, steps: steps(model, implicit)? }))
    }

    /// The reactions of a model between the cases of its conditions, from which those of each case are sought; none where it has none.
    pub fn in_the_middle(model: &Model) -> Option<Self> {
        if model.impulses.is_empty() || model.algebraic_speeds != model.impulses {
            return None;
        }
        let laws = |trace: &Trace<'_>| {
            let half = Sym::ONE / (Sym::ONE + Sym::ONE);
            let Ok(Parted { letters, zeros, .. }) = Parted::of(trace) else { return Vec::new() };
            let middle: Vec<(Sym, Sym)> = trace.switches.iter().map(|&switch| (switch, half)).collect();
            letters.into_iter().zip(substitute_all(&zeros, &middle)).collect()
        };
        Some(ImplicitSpeeds { places: model.impulses.clone(), steps: steps(model, laws).ok()? })
    }

    /// Moves these speeds of a state to the roots of their laws; a state at which the steps are no numbers stays.
    pub fn set<S: Real + Running>(&self, time: S, (first, state): (usize, &mut [S])) {
        let mut step = vec![S::zero(); self.places.len()];
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            if self.steps.run(time, state, &mut step).is_none() {
                return;
            }
            let size = step.iter().fold(0.0, |size: f64, part| size.max(part.approx().abs()));
            // a step that no longer decreases is rounding
            if !size.is_finite() || size == 0.0 || size >= last && size < f64::EPSILON.sqrt() {
                return;
            }
            last = size;
            for (&place, &part) in self.places.iter().zip(&step) {
                state[first + place] += part;
            }
        }
    }
}

/// Newton's step for letters that sums keep at zero.
fn steps(model: &Model, laws: impl Fn(&Trace<'_>) -> Vec<(Sym, Sym)> + Send + Sync) -> Result<Program, NotCompiled> {
    let states = model.positions() + model.speeds();
    recorded(states, |time, state| {
        let trace = Trace::of(model);
        let laws = laws(&trace);
        let by = |zero: Sym, letter: Sym| Derivation::new([(letter, Sym::ONE)]).of(zero);
        let row = |zero: Sym| laws.iter().map(|(letter, _)| by(zero, *letter)).collect();
        let rows = laws.iter().map(|(_, zero)| row(*zero)).collect();
        let right = laws.iter().map(|(_, zero)| -*zero).collect();
        let steps = eliminated(rows, right).map(|(steps, _)| steps).unwrap_or_default();
        Letters::with_data(time, state).put_into(&trace, &steps)
    })
}
