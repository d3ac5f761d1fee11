//! A scene run with a reduced model of its system.

use super::Simplification;
use super::reduced_law::lower;
use crate::model_reduction::{Loss, ReducedModel};
use integrators::Reference;
use simulation::ivp_scene::Parameter;
use simulation::models::{Limit, Modelled};
use simulation::problem::Problem;
use simulation::work_precision::{Configuration, Hybrid, Observed};
use simulation::{Axes, IvpScene, Run};
use std::borrow::Cow;
use std::sync::Arc;

/// The scene, with the elements of a simplification neglected.
pub struct SimplifiedScene {
    /// The scene with zero parameters and limits applied.
    scene: Arc<dyn Modelled>,
    name: String,
    /// The reduced law, if states are neglected.
    reduced: Option<Arc<ReducedModel>>,
    /// For each column, whether it depends on a neglected state.
    hidden: Vec<bool>,
}

impl SimplifiedScene {
    /// A scene without the elements of a simplification.
    ///
    /// # Errors
    /// An unknown name, or the reason why there is no such model.
    pub fn of(scene: &Arc<dyn Modelled>, simplification: &Simplification) -> Result<Self, String> {
        let zero: Vec<&str> = simplification.without.iter().map(String::as_str).collect();
        let unbounded: Vec<&str> = simplification.rigid.iter().map(String::as_str).collect();
        let parameters: Vec<String> = scene.parameters().into_iter().map(|one| one.name.into_owned()).collect();
        if let Some(wrong) = zero.iter().chain(&unbounded).find(|name| !parameters.iter().any(|known| known == *name)) {
            return Err(format!("no parameter is called `{wrong}`; known: {}", parameters.join(", ")));
        }
        let scene = match zero.is_empty() && unbounded.is_empty() {
            true => Arc::clone(scene),
            false => scene.in_the_limit(Limit { zero: &zero, unbounded: &unbounded })?,
        };
        let name = simplification.to_string();
        let own = scene.problem(Axes::First);
        if !simplification.has_own_law() {
            let hidden = vec![false; own.columns.len()];
            return Ok(SimplifiedScene { scene, name, reduced: None, hidden });
        }
        if !scene.is_written() || own.residual.is_some() {
            return Err(
                "states are left out of a system without constraints, contacts, conditions and events, whose accelerations can be \
                 written down; \"without P\" and \"rigid P\" with parameters are accepted of any system"
                    .to_owned(),
            );
        }
        let states = &own.columns[..own.state.len()];
        let lower = lower(&scene.symbolic_law(), states, &own.state, simplification)?;
        let start = lower.kept.iter().flatten().map(|&place| own.state[place]).collect();
        let loss = Loss::Small { parameter: "time of the transients relative to that of the motion" };
        let reduced = ReducedModel::new("a smaller model", &simplification.dropped(), loss, lower, start);
        let reduced = reduced.ok_or("its equations have no values")?;
        let hidden = match simplification.unfollowed.is_empty() {
            true => vec![false; own.columns.len()],
            false => {
                let unfollowed: Vec<bool> =
                    states.iter().map(|name| simplification.unfollowed.contains(name)).collect();
                let depends = |column: &String| {
                    let behind = scene.states_behind(std::slice::from_ref(column));
                    behind.iter().zip(&unfollowed).any(|(behind, unfollowed)| *behind && *unfollowed)
                };
                own.columns.iter().map(depends).collect()
            }
        };
        Ok(SimplifiedScene { scene, name, reduced: Some(Arc::new(reduced)), hidden })
    }

    /// Whether this model has no values for a column of a run.
    pub fn hides(&self, column: usize) -> bool {
        self.hidden[column]
    }

    /// The number of retained states.
    pub fn states(&self) -> usize {
        self.reduced.as_ref().map_or_else(|| self.scene.problem(Axes::First).state.len(), |reduced| reduced.start.len())
    }

    /// The problem with all columns of the scene's own run; columns of neglected states keep their initial values.
    pub fn whole_problem(&self) -> Problem {
        let own = self.scene.problem(Axes::First);
        let Some(reduced) = &self.reduced else { return own };
        let states = own.state.len();
        let lift = {
            let reduced = Arc::clone(reduced);
            move |time: f64, z: &[f64]| reduced.lifted(time, z, states)
        };
        let (of_row, of_margins) = (lift.clone(), lift);
        let Problem { span, columns, row, margins, .. } = own;
        Problem {
            law: Arc::clone(&reduced.law),
            state: reduced.start.clone(),
            metered: 0,
            span,
            invariants: Vec::new(),
            residual: None,
            columns,
            row: Box::new(move |time, z| row(time, &of_row(time, z))),
            margins: Box::new(move |time, z, _| {
                let y = of_margins(time, z);
                margins(time, &y, &vec![0.0; y.len()])
            }),
            switching: None,
        }
    }

    /// The reduced model, if states are neglected.
    pub(crate) fn reduced(&self) -> Option<&ReducedModel> {
        self.reduced.as_deref()
    }
}

impl IvpScene for SimplifiedScene {
    fn title(&self) -> &str {
        self.scene.title()
    }

    fn description(&self) -> &str {
        self.scene.description()
    }

    fn model(&self) -> &str {
        &self.name
    }

    fn has_own_names(&self) -> bool {
        self.scene.has_own_names()
    }

    fn run(&self) -> &Run {
        self.scene.run()
    }

    fn problem(&self, _axes: Axes) -> Problem {
        let whole = self.whole_problem();
        if !self.hidden.contains(&true) {
            return whole;
        }
        let shown: Vec<usize> = (0..whole.columns.len()).filter(|&column| !self.hidden[column]).collect();
        let Problem { columns, row, .. } = whole;
        Problem {
            columns: shown.iter().map(|&column| columns[column].clone()).collect(),
            row: Box::new(move |time, z| {
                let all = row(time, z);
                shown.iter().map(|&column| all[column]).collect()
            }),
            ..self.whole_problem()
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        self.scene.parameters()
    }

    fn ways(&self) -> Vec<Configuration> {
        self.scene.ways()
    }

    fn observed(&self, reference: &Reference) -> Vec<Observed> {
        self.scene.observed(reference)
    }

    fn unit(&self, name: &str) -> Cow<'static, str> {
        self.scene.unit(name)
    }

    fn hybrid(&self) -> Option<&dyn Hybrid> {
        self.scene.hybrid()
    }
}
