//! A way to run a scene: a formulation of its equations with a model of its motor.

use super::measured::Trials;
use crate::Problem;
use crate::law::Law;
use crate::problem::Row;
use integrators::{Attempt, HybridMotion, Index2DaeSystem, Index2Method, Method, Reference, Span, survey};
use std::fmt;
use std::sync::Arc;

/// A formulation of a scene's equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// A gyrostat, in the axes of A.
    First,
    /// A gyrostat, in the axes of A*.
    Second,
    /// In the angular momentum and the rotor's momentum: a sum of fields with known flows.
    Momenta,
    /// A motor on a bench: slip and currents.
    Bench,
    /// In coordinates that keep the constraints.
    Minimal,
    /// In redundant coordinates, the constraints led by the gains that the scene gives.
    Given,
    /// In redundant coordinates by Lagrange's multipliers, f'' = 0, and nothing else; a control that keeps an equation stands for
    /// the multiplier of one.
    IndexReduced,
    /// In redundant coordinates, f'' = -2 w f' - w^2 f with w = [`Formulation::RATE`] (Baumgarte).
    Led,
    /// Index-reduced, with projection onto f = 0 and f' = 0 after each step.
    Projected,
    /// In redundant coordinates held to f = 0 and f' = 0, each with its multiplier (Gear, Gupta, Leimkuhler).
    Held,
    /// In redundant coordinates with rough contacts: between two events as index-reduced, at an event made exact.
    Contacts,
}

impl Formulation {
    /// The rate w of [`Formulation::Led`], 1/s.
    pub const RATE: f64 = 10.0;

    /// The name in tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            Formulation::First => "first form",
            Formulation::Second => "second form",
            Formulation::Momenta => "momenta",
            Formulation::Bench => "motor alone",
            Formulation::Minimal => "minimal coordinates",
            Formulation::Given => "redundant, the scene's gains",
            Formulation::IndexReduced => "redundant, index reduction",
            Formulation::Led => "redundant, stabilised",
            Formulation::Projected => "redundant, projected",
            Formulation::Held => "Gear-Gupta-Leimkuhler",
            Formulation::Contacts => "regime by regime",
        }
    }
}

impl Formulation {
    /// The words within a sentence, behind a method.
    pub fn said(self) -> &'static str {
        match self {
            Formulation::First => "in the first form",
            Formulation::Second => "in the second form",
            Formulation::Momenta => "in momenta",
            Formulation::Bench => "for the motor alone",
            Formulation::Minimal => "in minimal coordinates",
            Formulation::Given => "in redundant coordinates stabilised by the scene's gains",
            Formulation::IndexReduced => "in redundant coordinates after index reduction",
            Formulation::Led => "in redundant coordinates, stabilised",
            Formulation::Projected => "in redundant coordinates, projected",
            Formulation::Held => "in the form of Gear, Gupta and Leimkuhler",
            Formulation::Contacts => "regime by regime",
        }
    }
}

impl fmt::Display for Formulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The relation between a model's motion and that of the scene's own model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// The scene's own motion.
    Own,
    /// Another with the same motion, which is proved.
    Exact,
    /// Another motion: its errors have a floor.
    Approximate,
}

/// A law with the treatment of its constraints, where it has some.
#[derive(Clone)]
pub enum Treated {
    Free(Arc<dyn Law>),
    Held(Arc<dyn SharedIndex2Dae>),
    /// Law after law, across events.
    Hybrid(Arc<dyn SharedHybridMotion>),
}

/// A held law that can be shared between threads.
pub trait SharedIndex2Dae: Index2DaeSystem + Send + Sync {}
impl<L: Index2DaeSystem + Send + Sync> SharedIndex2Dae for L {}

/// A motion across events that can be shared between threads.
pub trait SharedHybridMotion: HybridMotion + Send + Sync {}
impl<L: HybridMotion + Send + Sync> SharedHybridMotion for L {}

/// A formulation with a model, ready to be run by every method that it has.
pub struct Configuration {
    pub formulation: Formulation,
    /// The motor's model by its name; empty where there is no motor.
    pub model: &'static str,
    pub standing: Standing,
    pub law: Treated,
    pub state: Vec<f64>,
    /// The sizes of the state's components, to which their tolerances are relative.
    pub sizes: Vec<f64>,
    /// The names of a row's columns.
    pub columns: Vec<String>,
    pub row: Box<Row>,
}

impl Configuration {
    /// The configuration of a problem.
    pub fn of(formulation: Formulation, model: &'static str, standing: Standing, problem: Problem) -> Self {
        let Problem { law, state, columns, row, .. } = problem;
        Configuration { formulation, model, standing, law: Treated::Free(law), sizes: Vec::new(), state, columns, row }
    }

    /// Finds the sizes: those of the reference where it is the reference's own.
    pub(super) fn measure_itself(&mut self, span: f64, own: Option<&Reference>) {
        let found = match (&self.law, own) {
            (_, Some(reference)) => Some(reference.sizes.clone()),
            (Treated::Free(law), None) => survey(&**law, &self.span(span, Trials::SURVEY)).ok(),
            // no method with a constant step follows it
            _ => None,
        };
        self.sizes = found.unwrap_or_else(|| vec![1.0; self.state.len()]);
    }

    /// The span from time zero, with outputs at the instants of the reference.
    pub(super) fn span(&self, span: f64, evaluations: u64) -> Span<'static, f64> {
        Span::new(0.0, span, &self.state).with_even_outputs(crate::references::INSTANTS).with_evaluations(evaluations)
    }

    /// Every method of this configuration. Splitting methods belong to the momenta, all others to the rest.
    pub(super) fn attempts(&self, trials: &Trials) -> Vec<Attempt<'_>> {
        let split =
            |method: &&Method| matches!(method, Method::Split { .. }) == (self.formulation == Formulation::Momenta);
        match &self.law {
            Treated::Free(law) => {
                trials.methods.iter().filter(split).map(|method| Attempt::Integrated(&**law, *method)).collect()
            }
            Treated::Hybrid(motion) => {
                let steps = |method: &&Method| split(method) && (**method != Method::Taylor || motion.has_series());
                trials.methods.iter().filter(steps).map(|method| Attempt::Hybrid(&**motion, *method)).collect()
            }
            Treated::Held(law) => Trials::STEPS
                .into_iter()
                .flat_map(|steps| {
                    [
                        Index2Method::HalfExplicitRungeKutta4 { steps },
                        Index2Method::RadauIIA { stages: 3, steps },
                        Index2Method::ProjectedGauss { stages: 3, steps },
                    ]
                })
                .map(|holding| Attempt::Held(&**law, holding))
                .collect(),
        }
    }

    /// Whether every method's error tends to zero.
    pub fn is_exact(&self) -> bool {
        self.standing != Standing::Approximate
    }
}
