//! Stability of motions at which the user fixed coordinates: since all coordinates move after a push, the motion is found again with these
//! coordinates as unknowns.

use super::conditions::Case;
use super::equations::SteadyEquations;
use super::quasi_velocities::state_names;
use super::{Range, SteadyMotion, SteadyMotions, SteadySearch};
use model::Model;

/// Number of boxes of the search near a motion.
const BOXES: usize = 500;

impl SteadyMotions {
    /// Replaces the stability of each motion by that found with all coordinates as unknowns, if the motion is proved to be isolated then.
    pub(super) fn with_free_values(
        mut self,
        model: &Model,
        asked: &SteadySearch,
        cases: &[Case],
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Self {
        let names = state_names(model);
        let coordinates = &names[..names.len() / 2];
        if !self.given.iter().any(|(name, _)| coordinates.contains(name)) {
            return self;
        }
        for motion in &mut self.motions {
            let mut near = SteadySearch { boxes: BOXES, ..asked.clone() };
            let is_placed = |name: &String| {
                self.given.iter().any(|(own, _)| own == name) || self.unknowns.iter().any(|own| own.name == *name)
            };
            let placed = coordinates.iter().zip(&motion.state).filter(|(name, _)| is_placed(name));
            near.ranges.extend(placed.map(|(name, value)| (name.clone(), Range::about(*value))));
            if let Some(found) = alone(model, &near, cases, goes_on) {
                motion.stability = found.stability;
            }
        }
        self
    }
}

/// The only motion of a complete search near a motion; `None` if it is not isolated.
fn alone(
    model: &Model,
    near: &SteadySearch,
    cases: &[Case],
    goes_on: &mut dyn FnMut() -> bool,
) -> Option<SteadyMotion> {
    let equations = match cases {
        [] => SteadyEquations::of(model, near),
        cases => SteadyEquations::in_cases(model, near, cases),
    };
    let found = SteadyMotions::found(model, equations.ok()?, near, goes_on);
    let is_alone = found.is_complete() && found.families.is_empty() && found.motions.len() == 1;
    found.motions.into_iter().next().filter(|_| is_alone)
}
