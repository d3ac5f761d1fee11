//! Reduced models with simpler motor models that can be made from a scene's data.

use super::motors::written;
use super::reduced_model::Lower;
use super::{Hierarchy, Loss, ReducedModel};
use crate::scene::Scene;
use crate::scene::state::outputs;
use field::Over;
use motor::Machine;
use simulation::Axes;
use std::sync::Arc;
use symbolic::Sym;

/// The reduced model with a simpler motor model, lifted by the names of the states: a missing angle is the integral of
/// the slip, missing currents are zero.
pub(super) fn reduced_model(
    scene: &Scene,
    axes: Axes,
    ladder: &Hierarchy,
    model: &'static str,
) -> Option<ReducedModel> {
    let smaller = scene.with_model(model).ok()?;
    let names = smaller.names();
    if names.is_empty() {
        return None; // on a bench a rotor of constant speed has no state at all
    }
    let law = written(&scene.system, axes, smaller.machine.clone());
    let lag = smaller.machine.frame_speed() - scene.machine.frame_speed();
    let own = scene.names();
    let states = ladder.start.len();
    let count = names.len();
    let turning = own.iter().any(|name| name == "angle") && !names.iter().any(|name| name == "angle");
    let slip = names.iter().position(|name| name == "slip");
    let from: Vec<(usize, Option<usize>, String)> = own
        .iter()
        .take(states)
        .enumerate()
        .filter(|(_, name)| ["w", "v", "a", "s"].iter().any(|first| name.starts_with(first)))
        .map(|(place, name)| (place, names.iter().position(|known| known == name), name.clone()))
        .collect();
    let slipping = move |z: &[Sym]| slip.map_or(Sym::ZERO, |slip| z[slip]) + Sym::lift(lag);
    let lift = move |_: Sym, z: &[Sym]| {
        let mut y = vec![Sym::ZERO; states];
        for (place, known, name) in &from {
            y[*place] = match (name.as_str(), known) {
                ("slip", _) => slipping(z),
                ("angle", None) => z[count],
                (_, known) => known.map_or(Sym::ZERO, |known| z[known]),
            };
        }
        y
    };
    let rates = move |time: Sym, z: &[Sym]| {
        let mut dz = vec![Sym::ZERO; count];
        law.rates(time, &z[..count], &mut dz);
        dz.extend(turning.then(|| slipping(z)));
        dz
    };
    let mut start = smaller.state(axes);
    start.extend(turning.then_some(scene.start.rotor_angle));
    let lower = Lower { dimension: start.len(), lift: Arc::new(lift), rates: Arc::new(rates), kept: None };
    let (dropped, parameter) = dropped(model);
    let mut reduced = ReducedModel::new(model, dropped, Loss::Small { parameter }, lower, start)?;
    // a run of the simpler machine measures the slip relative to its own field
    let shown = outputs(scene.on_bench(), &smaller.machine);
    reduced.shows = shown.into_iter().filter(|name| name != "slip" || lag == 0.0).collect();
    Some(reduced)
}

/// The parts that a simpler machine neglects, and the parameter that must be small, in words.
fn dropped(model: &str) -> (&'static str, &'static str) {
    match model {
        "synchronous" => ("all currents and the damping by slip", "damping of the swing over one swing"),
        "kloss" | "asynchronous" => {
            ("the angle to the field: the torque is one of slip alone", "b0 over the torque of slip")
        }
        "free_rotor" => ("the motor's torque", "M t over the rotor's momentum"),
        _ => (
            "the rotor's own motion: its speed is prescribed and does not depend on the torque",
            "change of speed over the speed",
        ),
    }
}
