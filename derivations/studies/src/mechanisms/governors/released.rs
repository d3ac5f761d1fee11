//! The friction governor whose wheel is pushed along its axle, as text: the same without the friction across the wheel.

use super::gear::FRICTIONLESS;
use crate::ladder::models::Reductions;
use crate::ladder::{Loss, Lower, Rung};
use simulation::knowledge::Knowledge;
use simulation::models::Modelled;

const NAME: &str = "friction_governor";

/// The friction across the wheel at both contacts.
const LATERAL: &str = "lateral";

simulation::knowledge::submit! { Knowledge {
    name: NAME,
    summary: "a friction governor whose wheel is pushed along its axle",
    parameters: &[LATERAL],
    columns: &["rho"],
    ..Knowledge::EMPTY
} }

simulation::knowledge::submit! { Reductions { name: NAME, rungs } }

fn rungs(scene: &dyn Modelled) -> Vec<Rung> {
    if scene.value(LATERAL) == Some(0.0) {
        return Vec::new();
    }
    let Ok(smooth) = scene.with_values(&[(LATERAL, 0.0)]) else { return Vec::new() };
    let lower = Lower::other(&smooth.symbolic_law());
    let [name, dropped, parameter] = FRICTIONLESS;
    let loss = match lower.is_exact(&*scene.symbolic_law()) {
        true => Loss::Nothing { claim: None },
        false => Loss::Small { parameter },
    };
    let start = scene.problem(simulation::Axes::First).state;
    Rung::new(name, dropped, loss, lower, start).into_iter().collect()
}
