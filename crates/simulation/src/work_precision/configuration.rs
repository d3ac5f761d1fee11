//! A configuration of a scene: a formulation of its equations with a model of its motor.

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
    /// A gyrostat in the principal axes of body A.
    First,
    /// A gyrostat in the principal axes of body A*.
    Second,
    /// Angular momentum and rotor momentum as states: a sum of fields with known flows, for splitting methods.
    Momenta,
    /// A motor on a bench: slip and currents as states.
    Bench,
    /// Minimal coordinates, which satisfy the constraints.
    Minimal,
    /// Redundant coordinates with stabilised constraints, with the gains of the scene.
    Given,
    /// Redundant coordinates with multipliers from f'' = 0, without stabilisation. A control that enforces an equation
    /// takes the role of a multiplier.
    IndexReduced,
    /// Redundant coordinates with Baumgarte stabilisation f'' = -2 w f' - w^2 f, w = [`Formulation::RATE`].
    Led,
    /// Index-reduced, with projection onto f = 0 and f' = 0 after each step.
    Projected,
    /// Redundant coordinates with multipliers for f = 0 and for f' = 0 (Gear, Gupta, Leimkuhler).
    Held,
    /// Redundant coordinates with frictional contacts: index-reduced between events, projected at events.
    Contacts,
}

impl Formulation {
    /// The rate w of the Baumgarte stabilisation, 1/s.
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
    /// The phrase for use in a sentence, after the name of a method.
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

/// The relation of a configuration's motion to that of the scene's own model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// The scene's own model.
    Own,
    /// Another formulation with the same motion, which is proved.
    Exact,
    /// A reduced model: its error has a lower bound.
    Approximate,
}

/// A law, by the treatment of its constraints.
#[derive(Clone)]
pub enum Treated {
    Free(Arc<dyn Law>),
    Held(Arc<dyn SharedIndex2Dae>),
    /// A hybrid motion across events.
    Hybrid(Arc<dyn SharedHybridMotion>),
}

/// An index-2 DAE that can be shared between threads.
pub trait SharedIndex2Dae: Index2DaeSystem + Send + Sync {}
impl<L: Index2DaeSystem + Send + Sync> SharedIndex2Dae for L {}

/// A hybrid motion that can be shared between threads.
pub trait SharedHybridMotion: HybridMotion + Send + Sync {}
impl<L: HybridMotion + Send + Sync> SharedHybridMotion for L {}

/// A formulation with a model, ready for all methods that apply to it.
pub struct Configuration {
    pub formulation: Formulation,
    /// The name of the motor's model; empty where there is no motor.
    pub model: &'static str,
    pub standing: Standing,
    pub law: Treated,
    pub state: Vec<f64>,
    /// The size of each component of the state, to which tolerances are relative.
    pub sizes: Vec<f64>,
    /// The column names of a row.
    pub columns: Vec<String>,
    pub row: Box<Row>,
}

impl Configuration {
    /// The configuration of a problem.
    pub fn of(formulation: Formulation, model: &'static str, standing: Standing, problem: Problem) -> Self {
        let Problem { law, state, columns, row, .. } = problem;
        Configuration { formulation, model, standing, law: Treated::Free(law), sizes: Vec::new(), state, columns, row }
    }

    /// Sets the sizes: from the reference `own` if it belongs to this configuration, otherwise from a coarse run.
    pub(super) fn measure_itself(&mut self, span: f64, own: Option<&Reference>) {
        let found = match (&self.law, own) {
            (_, Some(reference)) => Some(reference.sizes.clone()),
            (Treated::Free(law), None) => survey(&**law, &self.span(span, Trials::SURVEY)).ok(),
            // methods with a constant step do not use them
            _ => None,
        };
        self.sizes = found.unwrap_or_else(|| vec![1.0; self.state.len()]);
    }

    /// The span from time zero, with outputs at the times of the reference.
    pub(super) fn span(&self, span: f64, evaluations: u64) -> Span<'static, f64> {
        Span::new(0.0, span, &self.state).with_even_outputs(crate::references::INSTANTS).with_evaluations(evaluations)
    }

    /// All methods of this configuration. Splitting methods apply to [`Formulation::Momenta`] only, all others to the
    /// rest.
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

    /// Whether the error of every method tends to zero.
    pub fn is_exact(&self) -> bool {
        self.standing != Standing::Approximate
    }
}
