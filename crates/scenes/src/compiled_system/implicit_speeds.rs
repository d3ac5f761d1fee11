//! Implicit algebraic speeds: speeds without inertia that no expression gives in a mode. Newton's method finds them as roots of their
//! laws, from their last values.

use crate::compiled_system::NotCompiled;
use crate::letters::Letters;
use crate::modes::{Mode, ModeMotion, Parted, eliminated};
use crate::program::recorded;
use integrators::Real;
use model::{Model, Trace};
use simulation::{Program, Running};
use symbolic::{Derivation, Sym, apart, substitute_all};

/// The largest number of steps of Newton's method. From the values in the previous mode five steps are usual.
const MOST_STEPS: usize = 60;

/// The Newton step of the implicit speeds, compiled as a function of the state.
#[derive(Debug)]
pub(crate) struct ImplicitSpeeds {
    /// Indices of the implicit speeds among all speeds.
    places: Vec<usize>,
    steps: Program,
}

impl ImplicitSpeeds {
    /// The implicit speeds of a mode; `None` if every algebraic speed has an expression.
    ///
    /// # Errors
    /// The mode has no motion, or the step cannot be compiled.
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

    /// Newton's step for algebraic reactions with every switch at 1/2, the middle of its cases. Its root is the first guess for the
    /// reactions in each case. `None` if the model has none.
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

    /// Moves the implicit speeds of a state to the roots of their laws, in place; `first` is the index of the first speed in `state`.
    /// Stops without an error if a step is not finite.
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

/// The program of Newton's step for pairs (symbol, equation); an equation is an expression whose value is zero at the root.
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
