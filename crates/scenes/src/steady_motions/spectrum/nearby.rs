//! Enclosed eigenvalues at the steady motion near a given state.

use super::along::{ExactAlong, along};
use super::{EnclosedSpectrum, MOST_STATES, NotEnclosed, layout};
use crate::conservation::keeps_energy;
use crate::linearisation::{VariedEquations, law_at_rest};
use crate::steady_motions::conditions::Case;
use crate::steady_motions::equations::SteadyEquations;
use crate::steady_motions::kept_contacts::without_outputs;
use crate::steady_motions::quasi_velocities::Extended;
use crate::steady_motions::search::Boxes;
use crate::steady_motions::stability::is_smooth;
use crate::steady_motions::{ASIDE, NoSteadyMotions};
use algebra::boxes::{Limits, zeros};
use field::Interval;
use model::Model;

/// Number of boxes of the search near the state.
const BOXES: usize = 200;

impl EnclosedSpectrum {
    /// The eigenvalues at the steady motion near a state; it is proved to be the only one there with the cyclic speeds of the state. The search ends when
    /// `goes_on` returns false.
    ///
    /// # Errors
    /// If no such motion is proved, the model is not supported, or the eigenvalues cannot be enclosed.
    pub fn near(model: &Model, state: &[f64], goes_on: impl FnMut() -> bool) -> Result<Self, NotEnclosed> {
        let states = 2 * model.speeds();
        if states > 2 * MOST_STATES {
            return Err(NotEnclosed::Large { states, most: MOST_STATES });
        }
        let (model, state) = &Extended::about(model, state);
        let varied = VariedEquations::with_inputs(&law_at_rest(&without_outputs(model), state), &[], &[]);
        let varied = varied.map_err(|_| NotEnclosed::NoEquations)?;
        let cases = cases_at(&varied, state);
        let equations =
            SteadyEquations::near(model, state, &cases).map_err(|why| NotEnclosed::NotSought(why_not(&why)))?;
        if equations.is_unbalanced {
            return Err(NotEnclosed::NoMotion);
        }
        let domain: Vec<Interval> = equations.unknowns.iter().map(|unknown| unknown.range.interval()).collect();
        let limits = Limits { boxes: BOXES, smallest: 1e-3 };
        let mut boxes = Boxes::of(&equations, &equations.tapes);
        let found = zeros(&mut boxes, &domain, limits, goes_on);
        let [zero] = &found.zeros[..] else { return Err(NotEnclosed::NoMotion) };
        if boxes.lies_aside(&zero.enclosure) != Some(true) && !is_smooth(model, &equations, &mut boxes, &zero.enclosure)
        {
            return Err(NotEnclosed::AtCondition);
        }
        if !moves_as(&equations, &zero.enclosure, state) {
            return Err(NotEnclosed::NoMotion);
        }
        let keeps_energy = equations.energy_integral.is_some() || keeps_energy(model);
        EnclosedSpectrum::of(model, &equations, &varied, (&zero.enclosure, &equations.state), keeps_energy)
    }
}

/// The cases of the conditions of a law at a state, by their signs; zero counts as `Case::Fails`.
pub(super) fn cases_at(varied: &VariedEquations, state: &[f64]) -> Vec<Case> {
    let case = |holds: &f64| if *holds > 0.0 { Case::Holds } else { Case::Fails };
    varied.point(0.0, state).switches.iter().map(case).collect()
}

/// Whether a steady motion has the speeds of a state, which the equations may determine otherwise.
fn moves_as(equations: &SteadyEquations, enclosure: &[Interval], state: &[f64]) -> bool {
    let unknowns: Vec<f64> = equations.unknowns.iter().zip(enclosure).map(|(_, at)| at.middle()).collect();
    let moving = equations.state_at(unknowns.into_iter());
    let first = state.len() / 2;
    moving[first..]
        .iter()
        .zip(&state[first..])
        .all(|(own, asked)| (own - asked).abs() <= 2.0 * ASIDE * (1.0 + asked.abs()))
}

impl ExactAlong {
    /// Exact stability boundaries along the parameter with this name. The state must be a steady motion for every value of the parameter, and
    /// all numbers must be rational.
    ///
    /// # Errors
    /// If the name is unknown, these conditions do not hold, or the law changes at conditions.
    pub fn of(model: &Model, state: &[f64], parameter: &str) -> Result<Self, NotEnclosed> {
        let place = model.parameters.iter().position(|own| own.name == parameter);
        let place = place.ok_or(NotEnclosed::NotSought("no parameter is called so"))?;
        let (model, state) = &Extended::about(model, state);
        let varied = VariedEquations::with_inputs(model, &[], &[]).map_err(|_| NotEnclosed::NoEquations)?;
        if !model.switches.is_empty() {
            return Err(NotEnclosed::NotSought("the law changes at conditions"));
        }
        let equations =
            SteadyEquations::near(model, state, &[]).map_err(|why| NotEnclosed::NotSought(why_not(&why)))?;
        // the number of zero eigenvalues with reasons is that at the value of the file
        let found = EnclosedSpectrum::near(model, state, || true)?;
        let reasons = found.zeros.len() - equations.cyclic.len();
        along(model, &layout(&equations, &varied), (state, place), reasons)
    }
}

fn why_not(why: &NoSteadyMotions) -> &'static str {
    match why {
        NoSteadyMotions::Changes => "the law changes with contacts, or some speeds have no inertia",
        NoSteadyMotions::FreeFrame { .. } => "a frame turns freely",
        NoSteadyMotions::OfTime => "the law depends on time",
        NoSteadyMotions::OfSpeeds { .. } => "a constraint of speeds has gains, or cannot be solved",
        NoSteadyMotions::Singular | NoSteadyMotions::Empty { .. } => "no inertia resists a coordinate",
        NoSteadyMotions::At { why, .. } => why_not(why),
        NoSteadyMotions::Unequal { .. } => "steady motions form a family",
        _ => "the equations of steady motions have no values there",
    }
}
