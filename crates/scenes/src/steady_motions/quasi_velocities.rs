//! Quasi-velocities as independent speeds of systems with constraints of speeds.
//!
//! If a knife edge moves in a circle, the rates of its Cartesian coordinates vary, but its velocity along the edge is constant.
//! Quasi-velocities of the file, then components of the velocities of bodies along their axes are tried, and the set that makes the most
//! coordinates cyclic is chosen. Each chosen quasi-velocity becomes the rate of an additional coordinate, its integral, so that the search
//! handles coordinates only.

use super::NoSteadyMotions;
use super::determinacy::Wanted;
use super::rows::Rows;
use crate::letters::Letters;
use model::equations::{Level, constraints_of};
use model::{Event, INTEGRAL, Model, QuasiVelocity, StartValue, Trace};
use symbolic::Tape;

/// A model extended by coordinates whose rates are the quasi-velocities `speeds`.
pub(super) struct Extended {
    original: Model,
    pub model: Model,
    pub speeds: Vec<QuasiVelocity>,
}

/// Largest number of velocity components that are tried.
const MOST_TRIED: usize = 24;

impl Extended {
    /// The extended model, if quasi-velocities make more coordinates cyclic than the rates of coordinates do, or if `asked` names a quasi-velocity.
    /// The constraints must be regular at `state`, or at the start if there is none.
    pub fn of(model: &Model, asked: &[&str], state: Option<&[f64]>) -> Option<Self> {
        if !may_be_extended(model) || model.positions() != model.speeds() || !model.algebraic_speeds.is_empty() {
            return None;
        }
        symbolic::apart(|| Self::chosen(model, asked, state))
    }

    /// The extended model and state if quasi-velocities are useful at this state; otherwise both unchanged.
    pub fn about(model: &Model, state: &[f64]) -> (Model, Vec<f64>) {
        let extended = Self::of(model, &[], Some(state));
        let moved = extended.and_then(|extended| extended.extended(state).map(|state| (extended.model, state)));
        moved.unwrap_or_else(|| (model.clone(), state.to_vec()))
    }

    fn chosen(model: &Model, asked: &[&str], state: Option<&[f64]>) -> Option<Self> {
        let (named, holds_speeds) = {
            let trace = Trace::of(model);
            let named = model.quasi_velocities.iter().filter(|own| trace.combination(own).is_some());
            (named.cloned().collect::<Vec<_>>(), constraints_of(&trace).iter().any(|one| one.level == Level::Speed))
        };
        let is_asked = |own: &QuasiVelocity| asked.contains(&own.name.as_str());
        let must: Vec<QuasiVelocity> = named.iter().filter(|own| is_asked(own)).cloned().collect();
        let open = asked.iter().any(|name| name.starts_with("velocity("));
        if !holds_speeds && must.is_empty() && !open {
            return None;
        }
        let least = match must.is_empty() && !open {
            true => score(model, asked, state),
            false => None,
        };
        if least.is_some_and(|(count, is_regular, most)| count >= most && is_regular) {
            return None;
        }
        // first all those of the file, then each of them, then components of velocities
        let mut model = model.clone();
        let components = model.body_velocities();
        let trace = Trace::of(&model);
        let components: Vec<QuasiVelocity> =
            components.into_iter().filter(|own| trace.combination(own).is_some()).collect();
        let must: Vec<QuasiVelocity> =
            must.into_iter().chain(components.iter().filter(|own| is_asked(own)).cloned()).collect();
        let each = named.iter().chain(components.iter().take(MOST_TRIED)).map(|own| vec![own.clone()]);
        let mut sets: Vec<Vec<QuasiVelocity>> = vec![must.clone(), named.clone()];
        sets.extend(each);
        for set in &mut sets {
            let missing: Vec<QuasiVelocity> = must.iter().filter(|own| !set.contains(own)).cloned().collect();
            set.splice(0..0, missing);
        }
        let mut best = least.map(|(count, is_regular, _)| ((count, is_regular), None));
        for set in sets.into_iter().filter(|set| !set.is_empty()) {
            let Some(extended) = Self::at(&model, set, state) else { continue };
            let state = match state {
                Some(state) => match extended.extended(state) {
                    Some(state) => Some(state),
                    None => continue,
                },
                None => None,
            };
            let Some((count, is_regular, most)) = score(&extended.model, asked, state.as_deref()) else { continue };
            // the additional coordinates occur in no equation and do not count
            let own = (count - extended.speeds.len(), is_regular);
            if best.as_ref().is_none_or(|(known, _)| own > *known) {
                let reached = count >= most && is_regular;
                best = Some((own, Some(extended)));
                if reached {
                    break;
                }
            }
        }
        best.and_then(|(_, extended)| extended)
    }

    /// The model extended by `speeds`, with their start values from the file or from the state.
    fn at(model: &Model, speeds: Vec<QuasiVelocity>, state: Option<&[f64]>) -> Option<Self> {
        let mut extended = Extended { original: model.clone(), model: model.with_integrals(&speeds), speeds };
        let start = model.start_state();
        let values = extended.values(state.unwrap_or(&start))?;
        let first = model.coordinates.len();
        for (place, (own, value)) in extended.speeds.iter().zip(values).enumerate() {
            let given = model.start_speeds.iter().find(|given| model.quasi_velocities[given.of].is == own.is);
            let value = given.map_or(value, |given| given.value);
            extended.model.start.push(StartValue { coordinate: first + place, order: 1, value, is_guess: true });
        }
        Some(extended)
    }

    /// The values of the quasi-velocities at a state of the original model.
    fn values(&self, state: &[f64]) -> Option<Vec<f64>> {
        let trace = Trace::of(&self.original);
        let letters = [&trace.coordinates[..], &trace.speeds].concat();
        let own: Vec<_> = self.speeds.iter().map(|speed| trace.scalar(speed.is)).collect();
        let own = Letters::with_decimals(trace.time, &letters).put_into(&trace, &own);
        let tape = Tape::record(&[&letters[..], &[trace.time]].concat(), &own).ok()?;
        let mut values = vec![0.0; own.len()];
        tape.over::<f64>().evaluate(&[state, &[0.0]].concat(), &mut values);
        values.iter().all(|value| value.is_finite()).then_some(values)
    }

    /// A state of the extended model: the additional coordinates are zero, their rates are the quasi-velocities.
    pub fn extended(&self, state: &[f64]) -> Option<Vec<f64>> {
        let (coordinates, speeds) = state.split_at(state.len() / 2);
        let values = self.values(state)?;
        Some([coordinates, &vec![0.0; values.len()], speeds, &values].concat())
    }

    /// The state of the original model and its quasi-velocities, from a state of the extended model.
    pub fn original(&self, state: &[f64]) -> (Vec<f64>, Vec<(String, f64)>) {
        let n = self.original.speeds();
        let (coordinates, speeds) = state.split_at(state.len() / 2);
        let own = self.speeds.iter().zip(&speeds[n..]).map(|(own, value)| (own.name.clone(), *value));
        ([&coordinates[..n], &speeds[..n]].concat(), own.collect())
    }
}

/// Whether coordinates can be added: the model has no contacts, which refer to coordinates by index, and no events that set a state.
fn may_be_extended(model: &Model) -> bool {
    let is_end = |event: &Event| event.ends && event.set.is_empty();
    model.contacts.is_empty() && model.events.iter().all(is_end)
}

/// The quasi-velocities that equal the rate of one coordinate, each with the name of this rate.
pub(super) fn rates_by_name(model: &Model) -> Vec<(String, String)> {
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let names = model.state_names();
        let rate = |own: &QuasiVelocity| {
            let is = trace.scalar(own.is);
            let place = trace.speeds.iter().position(|speed| *speed == is)?;
            Some((own.name.clone(), names.get(trace.coordinates.len() + place)?.0.clone()))
        };
        model.quasi_velocities.iter().filter_map(rate).collect()
    })
}

/// The names of the state's components; the rate of an integral has the name of its quasi-velocity.
pub(super) fn state_names(model: &Model) -> Vec<String> {
    let own = |name: String| match name.strip_prefix(INTEGRAL) {
        Some(rest) => rest.strip_suffix('\'').unwrap_or(&name).to_owned(),
        None => name,
    };
    model.state_names().into_iter().map(|(name, _)| own(name)).collect()
}

/// Whether a coordinate is the integral of a quasi-velocity.
pub(super) fn is_integral(model: &Model, place: usize) -> bool {
    model.coordinates.get(place).is_some_and(|own| own.name.starts_with(INTEGRAL))
}

/// For each coordinate whether it occurs in no equation.
pub(super) fn without_part(model: &Model) -> Result<Vec<bool>, NoSteadyMotions> {
    let trace = Trace::of(model);
    let start = model.start_state();
    let wanted = Wanted { free: Vec::new(), state: &start, is_near: false };
    Rows::of(model, &trace, &wanted).map(|rows| rows.is_cyclic)
}

/// The number of coordinates that occur in no equation, whether the constraints determine the dependent speeds at the state, and the largest
/// possible number of such coordinates.
fn score(model: &Model, asked: &[&str], state: Option<&[f64]>) -> Option<(usize, bool, usize)> {
    let trace = Trace::of(model);
    let n = trace.speeds.len();
    let names = state_names(model);
    let free = (0..n).filter(|&k| asked.contains(&names[n + k].as_str()) || is_integral(model, k)).collect();
    let start = model.start_state();
    let wanted = Wanted { free, state: state.unwrap_or(&start), is_near: state.is_some() };
    let rows = Rows::of(model, &trace, &wanted).ok()?;
    Some((rows.cyclic_count(), rows.is_regular, rows.most_cyclic))
}
