//! The configurations of a scene with a motor: both forms and the momenta, with every motor model that its data allow.

use crate::scene::Scene;
use crate::scene::state::ROTOR_SPEED;
use integrators::Reference;
use simulation::Axes;
use simulation::work_precision::{Configuration, Formulation, Observed, Standing};

/// Models with equal motions, as `konosevich2022/damper` proves for every number of bars.
const EQUAL: [&str; 2] = ["multi_current", "equivalent_windings"];

impl Scene {
    /// The scene's own model first, then the others from the largest.
    pub(super) fn all_ways(&self) -> Vec<Configuration> {
        let own = self.machine.name();
        let others = self.given.models().into_iter().rev().filter(|model| *model != own);
        let others = others.filter_map(|model| self.with_model(model).ok());
        std::iter::once(self.clone())
            .chain(others)
            .flat_map(|scene| scene.formulations(self.standing(&scene)))
            .collect()
    }

    fn standing(&self, other: &Scene) -> Standing {
        let names = [self.machine.name(), other.machine.name()];
        match names {
            [own, other] if own == other => Standing::Own,
            names if names.iter().all(|name| EQUAL.contains(name)) => Standing::Exact,
            _ => Standing::Approximate,
        }
    }

    fn formulations(&self, standing: Standing) -> Vec<Configuration> {
        let model = self.machine.name();
        let way = |formulation, axes| Configuration::of(formulation, model, standing, self.problem(axes));
        if self.names().is_empty() {
            return Vec::new(); // on a bench a rotor of constant speed has no state at all
        }
        if self.on_bench() {
            return vec![way(Formulation::Bench, Axes::First), way(Formulation::Momenta, Axes::First)];
        }
        // a free rotor needs only three squares in the axes of A, one with prescribed speed in the axes of A*
        let fewest = if self.keeps_speed() { Axes::Second } else { Axes::First };
        vec![
            way(Formulation::First, Axes::First),
            way(Formulation::Second, Axes::Second),
            way(Formulation::Momenta, fewest),
        ]
    }

    /// Angular velocity and vertical, each relative to the size of the vector; rotor angle and slip, if the model has
    /// them. The rotor's speed represents the slip: every model has it, and they differ by a constant.
    pub(super) fn observables(&self, reference: &Reference) -> Vec<Observed> {
        let names = self.names();
        let size_of = |wanted: &str| {
            let squares = names.iter().zip(&reference.sizes).filter(|(name, _)| name.starts_with(wanted));
            squares.map(|(_, size)| size * size).sum::<f64>().sqrt()
        };
        let mut observed: Vec<Observed> = Vec::new();
        for (vector, components) in [("w", ["w1", "w2", "w3"]), ("v", ["v1", "v2", "v3"])] {
            let present = components.iter().filter(|name| names.iter().any(|known| known == *name));
            observed.extend(present.map(|name| Observed { name: (*name).to_owned(), size: size_of(vector) }));
        }
        for (shown, state) in [("angle", "angle"), (ROTOR_SPEED, "slip")] {
            if names.iter().any(|name| name == state) {
                observed.push(Observed { name: shown.to_owned(), size: size_of(state) });
            }
        }
        observed
    }
}
