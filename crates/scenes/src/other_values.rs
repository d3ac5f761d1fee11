//! Variants of a scene with changed values of parameters and of the start, or with parameters at the limits zero and infinity.

use crate::admissible::impossible;
use crate::branch::settled;
use crate::changing_laws::changes;
use crate::modes::Mode;
use crate::motion_matrix::MotionMatrix;
use crate::readiness::{Ready, ready, starting};
use crate::scene::ModelScene;
use crate::start::joined;
use model::{Fault, Model};
use reader::Issue;
use simulation::SymbolicLaw;
use simulation::models::{Limit, Modelled};
use std::sync::Arc;

impl ModelScene {
    fn state_place(&self, name: &str) -> Option<usize> {
        self.model.state_names().iter().position(|(known, _)| known == name)
    }
}

impl Modelled for ModelScene {
    fn symbolic_law(&self) -> Arc<dyn SymbolicLaw> {
        Arc::clone(&self.system) as Arc<dyn SymbolicLaw>
    }

    fn is_written(&self) -> bool {
        self.system.is_written() && !changes(&self.model)
    }

    fn states_behind(&self, columns: &[String]) -> Vec<bool> {
        self.system.states_behind(columns)
    }

    fn known_as(&self) -> Option<&'static str> {
        self.knowledge.map(|knowledge| knowledge.name)
    }

    fn value(&self, name: &str) -> Option<f64> {
        let parameter = self.model.parameters.iter().find(|parameter| parameter.name == name);
        parameter.map_or_else(|| Some(self.start[self.state_place(name)?]), |parameter| parameter.value)
    }

    fn with_values(&self, values: &[(&str, f64)]) -> Result<Arc<dyn Modelled>, String> {
        self.varied(values).map(|scene| Arc::new(scene) as Arc<dyn Modelled>)
    }

    fn in_the_limit(&self, Limit { zero, unbounded }: Limit<'_>) -> Result<Arc<dyn Modelled>, String> {
        let mut source = (*self.source).clone();
        source.absent.extend(zero.iter().map(|&name| name.to_owned()));
        source.rigid.extend(unbounded.iter().map(|&name| name.to_owned()));
        let elaborated = Model::of(&source).and_then(settled);
        let mut model = elaborated.map_err(|faults| faults.first().map_or_else(String::new, in_short))?;
        // parameters may have been changed after the file was read
        for (own, given) in model.parameters.iter_mut().zip(&self.model.parameters) {
            if !source.absent.contains(&own.name) {
                own.clone_from(given);
            }
        }
        model.start.clone_from(&self.model.start);
        model.start_speeds.clone_from(&self.model.start_speeds);
        if !unbounded.is_empty() {
            let matrix = MotionMatrix::of(&model, &Mode::off(&model)).and_then(|matrix| matrix.at(0.0, &self.start));
            let start = matrix.and_then(|terms| joined(&model, self.start.clone(), terms.mass(model.speeds())));
            let start = start.unwrap_or_else(|| self.start.clone());
            model.start = starting(&model, &start).start;
            // the completed start satisfies the constraints up to rounding; as a guess it may be corrected
            model.start.iter_mut().for_each(|start| start.is_guess = true);
            model.start_speeds.clear();
        }
        if model.regulator.is_some() {
            model.close_regulated_inputs();
        }
        Ok(Arc::new(self.started(model)?.of_source(source, self)))
    }
}

fn in_short(fault: &Fault) -> String {
    format!("{}: {}", fault.title, fault.label)
}

impl ModelScene {
    /// The scene with changed values; each is the name of a parameter or of a component of the start, and a number in SI units.
    ///
    /// # Errors
    /// The reason as a text, if a name is unknown or no motion starts from the changed values.
    pub(crate) fn varied(&self, values: &[(&str, f64)]) -> Result<Self, String> {
        let mut model = (*self.model).clone();
        model.set_values(values)?;
        self.started(model)
    }

    /// The scene with another model, whose start is completed first.
    fn started(&self, model: Model) -> Result<Self, String> {
        let told = |issue: Issue| format!("{}: {}", issue.title, issue.label);
        if let Some(issue) = impossible(&model).into_iter().next() {
            return Err(told(issue));
        }
        let mut model = Arc::new(model);
        let Ready { start, system, .. } = ready(&mut model).map_err(told)?;
        Ok(self.with(model, system, start))
    }
}
