//! A scene run with one of the reduced models of its hierarchy.

use super::Hierarchy;
use integrators::Reference;
use simulation::ivp_scene::Parameter;
use simulation::work_precision::{Configuration, Observed};
use simulation::{Axes, IvpScene, Problem, Run};
use std::borrow::Cow;
use std::sync::Arc;

/// A scene with one of its reduced models.
pub struct ReducedScene<'a> {
    scene: &'a dyn IvpScene,
    /// The hierarchies of models in the axes of each form of the scene, the first form first.
    ladders: Vec<Arc<Hierarchy>>,
    reduced: usize,
}

impl<'a> ReducedScene<'a> {
    /// A scene run with the reduced model of this name.
    ///
    /// # Errors
    /// The names of the known models.
    pub fn of(scene: &'a dyn IvpScene, ladders: Vec<Hierarchy>, name: &str) -> Result<Self, Vec<&'static str>> {
        let known: Vec<&str> =
            ladders.first().into_iter().flat_map(|ladder| &ladder.models).map(|reduced| reduced.name).collect();
        match known.iter().position(|known| *known == name) {
            Some(reduced) => Ok(ReducedScene { scene, ladders: ladders.into_iter().map(Arc::new).collect(), reduced }),
            None => Err(known),
        }
    }
}

impl IvpScene for ReducedScene<'_> {
    fn title(&self) -> &str {
        self.scene.title()
    }

    fn description(&self) -> &str {
        self.scene.description()
    }

    fn model(&self) -> &str {
        self.ladders[0].models[self.reduced].name
    }

    fn has_own_names(&self) -> bool {
        self.scene.has_own_names()
    }

    fn run(&self) -> &Run {
        self.scene.run()
    }

    fn problem(&self, axes: Axes) -> Problem {
        let ladder = match axes {
            Axes::First => &self.ladders[0],
            Axes::Second => self.ladders.last().unwrap_or(&self.ladders[0]),
        };
        let (ladder, at) = (Arc::clone(ladder), self.reduced);
        let (law, state) = (Arc::clone(&ladder.models[at].law), ladder.models[at].start.clone());
        let (span, columns) = (ladder.own.span, ladder.own.columns.clone());
        let lifted = move |time: f64, z: &[f64]| {
            let whole = ladder.models[at].lifted(time, z, ladder.start.len());
            (Arc::clone(&ladder), whole)
        };
        let of_margins = lifted.clone();
        Problem {
            law,
            state,
            metered: 0,
            span,
            invariants: Vec::new(),
            residual: None,
            columns,
            row: Box::new(move |time, z| {
                let (ladder, y) = lifted(time, z);
                ladder.row(time, &y)
            }),
            margins: Box::new(move |time, z, _| {
                let (ladder, y) = of_margins(time, z);
                let whole = (ladder.whole)(time, &y);
                (ladder.own.margins)(time, &whole, &vec![0.0; whole.len()])
            }),
            switching: None,
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
}
