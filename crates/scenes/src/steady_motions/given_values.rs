//! Motions at which the user gives values of coordinates: their stability is that of the same motions with these coordinates sought, since all
//! coordinates move after a push.

use super::conditions::Case;
use super::equations::SteadyEquations;
use super::quasi_velocities::state_names;
use super::{Range, SteadyMotion, SteadyMotions, SteadySearch};
use model::Model;

/// The number of boxes that are examined about a motion.
const BOXES: usize = 500;

impl SteadyMotions {
    /// With the stability that a search next to each motion finds, where it shows the motion to be alone there.
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

/// The only motion of a search next to a motion.
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
