//! The hierarchy of models of a scene with a motor: its own model, lumped windings, currents at quasi-steady values or
//! zero, and smaller motor models with the scene's data.

use super::lumping::{Lumped, Lumping};
use super::reduced_model::Lower;
use super::{Hierarchy, Loss, ReducedModel, Whole, quasi_steady, smaller_machines};
use crate::scene::{Scene, Setup};
use field::Rational;
use motor::{Bench, Machine, Motor, catalogue};
use simulation::{Axes, SymbolicLaw};
use std::sync::Arc;
use systems::gyrostat::driven::Driven;

/// The claim that bars at any angles have closed equations in the sums of their currents.
const CLOSURE: &str = "konosevich2022/beyond-damper/closure";

impl Hierarchy {
    /// The hierarchy of models of a scene in the axes of a form.
    pub fn of_scene(scene: &Scene, axes: Axes) -> Self {
        let own = scene.problem(axes);
        let Within { written, start, whole, lumping, models } = Within::of(scene, axes, &own.state);
        let law = match (&lumping, models.first()) {
            (Some(_), Some(lumped)) => Arc::clone(&lumped.law),
            _ => Arc::clone(&own.law),
        };
        let model = scene.machine.name().to_owned();
        let mut ladder = Hierarchy { model, own, metered: None, written, law, start, whole, models, lumping };
        let known =
            catalogue::entries().into_iter().map(|entry| entry.name).take_while(|name| *name != scene.machine.name());
        // lumping finds the equivalent windings
        let known = known.filter(|name| *name != "equivalent_windings").collect::<Vec<_>>();
        for model in known.into_iter().rev() {
            ladder.models.extend(smaller_machines::reduced_model(scene, axes, &ladder, model));
        }
        ladder
    }
}

/// The reduced models from the scene's own machine, with the law from which they are derived.
struct Within {
    written: Arc<dyn SymbolicLaw>,
    start: Vec<f64>,
    whole: Box<Whole>,
    lumping: Option<Lumping>,
    models: Vec<ReducedModel>,
}

impl Within {
    fn of(scene: &Scene, axes: Axes, start: &[f64]) -> Self {
        let machine = scene.machine.clone();
        let windings = machine.windings();
        let mechanical = start.len() - windings;
        let Some(lumping) = Lumping::of(&machine.decimals()) else {
            return unlumped(scene, axes, machine, start);
        };
        let lumped = Lumped { machine, windings: lumping.over(Rational::to_f64) };
        let written = written(&scene.system, axes, lumped.clone());
        let (mechanics, currents) = start.split_at(mechanical);
        let inner = [mechanics, &lumping.lumped(currents)].concat();
        let dropped = format!(
            "of {windings} currents those {} combinations that feel no field and do no work",
            windings - lumping.windings.len()
        );
        let loss = Loss::Nothing { claim: Some(CLOSURE) };
        let lower = Lower::other(&written);
        let Some(exact) = ReducedModel::new("lumped windings", &dropped, loss, lower, inner.clone()) else {
            return unlumped(scene, axes, lumped.machine, start);
        };
        let models = std::iter::once(exact).chain(quasi_steady::models(&lumped, &written, &inner)).collect();
        let recovery = lumping.recovery(currents);
        let whole = move |time: f64, y: &[f64]| {
            let (mechanics, lumped) = y.split_at(mechanical);
            mechanics.iter().copied().chain(recovery.currents(time, lumped)).collect()
        };
        Within { written, start: inner, whole: Box::new(whole), lumping: Some(lumping), models }
    }
}

/// The reduced models from a machine without lumping.
fn unlumped(scene: &Scene, axes: Axes, machine: Motor, start: &[f64]) -> Within {
    let written = written(&scene.system, axes, machine.clone());
    let models = quasi_steady::models(&machine, &written, start);
    Within { written, start: start.to_vec(), whole: Box::new(|_, y| y.to_vec()), lumping: None, models }
}

/// The symbolic law of a system with a machine.
pub(super) fn written<M: Machine<f64> + Send + Sync + 'static>(
    system: &Setup,
    axes: Axes,
    machine: M,
) -> Arc<dyn SymbolicLaw> {
    match (system, axes) {
        (Setup::Gyrostat(bodies), Axes::First) => Arc::new(Driven::new(bodies.first_form().0, machine)),
        (Setup::Gyrostat(bodies), Axes::Second) => Arc::new(Driven::new(bodies.second_form().0, machine)),
        (Setup::Bench { axial }, _) => Arc::new(Bench { machine, axial: *axial }),
    }
}
