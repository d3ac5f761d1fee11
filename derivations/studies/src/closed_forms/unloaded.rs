//! A synchronous motor alone, without friction or load: the pendulum A' g'' = -b0 sin g.
//!
//! The function u = cos g satisfies u'^2 = 2/A' (E + b0 u)(1 - u^2) with E = A' g'^2/2 - b0 cos g.

use super::{ClosedForm, Quadrature, Shown};
use crate::scene::Start;
use integrators::Real;
use motor::Motor;

/// The closed form of cos g; `None` for a motor without the data of a synchronous motor.
pub fn solution<S: Real>(motor: &Motor, axial: f64, start: &Start) -> Option<ClosedForm<S>> {
    let (b0, axial) = (S::lift(motor.datum("b0")?), S::lift(axial));
    let angle = S::lift(start.rotor_angle).circle();
    let slip = S::lift(start.rotor_speed) - S::lift(motor.datum("field_speed")?);
    let energy = (axial * slip * slip).half() - b0 * angle.cos;
    let f = [energy, b0, -energy, -b0, S::zero()].map(|f| S::int(2) * f / axial);
    Some(ClosedForm {
        name: "the pendulum's, of the cosine of the rotor's angle",
        shown: Shown::Cosine(0),
        motion: Quadrature::new(f, angle.cos, -(slip * angle.sin)),
    })
}
