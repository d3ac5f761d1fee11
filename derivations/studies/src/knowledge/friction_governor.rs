//! The friction governor with a force along the wheel's axle, and its reduced model without lateral friction of the
//! wheel.

use crate::model_reduction::models::Reductions;
use crate::model_reduction::{Loss, Lower, ReducedModel};
use simulation::Axes;
use simulation::knowledge::{Knowledge, submit};
use simulation::models::Modelled;

const NAME: &str = "friction_governor";

/// The parameter of lateral friction of the wheel at both contacts.
pub(super) const LATERAL: &str = "lateral";

submit! { Knowledge {
    name: NAME,
    summary: "a friction governor whose wheel is pushed along its axle",
    parameters: &[LATERAL],
    columns: &["rho"],
    equations: &[include_str!("../../../../scenes/governors/released.toml")],
    ..Knowledge::EMPTY
} }

submit! { Reductions { name: NAME, models: |scene| frictionless(scene).into_iter().collect() } }

/// The reduced model in which the wheel slides along its axle without friction; `None` where the scene has no such
/// friction.
pub(super) fn frictionless(scene: &dyn Modelled) -> Option<ReducedModel> {
    if scene.value(LATERAL) == Some(0.0) {
        return None;
    }
    let smooth = scene.with_values(&[(LATERAL, 0.0)]).ok()?;
    let lower = Lower::other(&smooth.symbolic_law());
    let loss = match lower.is_exact(&*scene.symbolic_law()) {
        true => Loss::Nothing { claim: None },
        false => Loss::Small { parameter: "F11 + F22 over the force along the axle" },
    };
    let start = scene.problem(Axes::First).state;
    ReducedModel::new("frictionless across", "the friction across the wheel at both contacts", loss, lower, start)
}
