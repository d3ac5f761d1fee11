//! Work-precision measurements of a scene: the trials, and the reference for their errors.

use super::atlas::{Atlas, Goal, Observed};
use super::configuration::Configuration;
use super::hybrid::Hybrid;
use crate::Problem;
use crate::references::{Stored, Unknown};
use integrators::{Failure, Method, Reference, Splitting};
use std::time::Duration;

const TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// The methods, tolerances and limits of the trials of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Trials {
    pub methods: Vec<Method>,
    pub tolerances: Vec<f64>,
    /// The budget of evaluations of a run.
    pub evaluations: u64,
    /// The time for all runs, without timing.
    pub allowed: Duration,
}

impl Trials {
    /// The numbers of steps for methods with a constant step size.
    pub const STEPS: [u32; 4] = [250, 1_000, 4_000, 16_000];
    /// The budget of evaluations for the run that gives the sizes of a state.
    pub(super) const SURVEY: u64 = 1_000_000;

    /// The trials with a further method.
    pub fn with(mut self, method: Method) -> Self {
        if !self.methods.contains(&method) {
            self.methods.push(method);
        }
        self
    }
}

impl Default for Trials {
    fn default() -> Self {
        let constant = Self::STEPS.map(|steps| Method::RungeKutta4 { steps });
        let split = [Splitting::BlanesMoan4, Splitting::BlanesMoan6]
            .into_iter()
            .flat_map(|splitting| [60, 250, 1_000, 4_000].map(|steps| Method::Split { splitting, steps }));
        let adaptive = [
            Method::DormandPrince5,
            Method::DormandPrince8,
            Method::Verner9,
            Method::GraggBulirschStoer,
            Method::Taylor,
            Method::Rodas4,
            Method::BaderDeuflhard,
            Method::Radau5,
            Method::RadauIIA { stages: 5 },
            Method::Gauss { stages: 6 },
        ];
        Trials {
            methods: adaptive.into_iter().chain(constant).chain(split).collect(),
            tolerances: TOLERANCES.to_vec(),
            evaluations: 100_000,
            allowed: Duration::from_secs(5),
        }
    }
}

/// The atlas of a scene without timing, so that several scenes can be evaluated in parallel. The first configuration
/// must be that of the problem. A stored reference is used if it belongs to the problem; else, or if `kept`
/// is `None`, a reference is computed within the time `patience`.
///
/// # Errors
/// [`Failure`] where there is no reference.
pub fn judged(
    observed: &dyn Fn(&Reference) -> Vec<Observed>,
    problem: &Problem,
    ways: Vec<Configuration>,
    trials: &Trials,
    kept: Option<&Stored>,
    patience: Duration,
) -> Result<Atlas, Failure> {
    let reference = match kept.filter(|kept| kept.serves(problem)) {
        Some(kept) => kept.reference.clone(),
        None => problem.reference(patience)?,
    };
    let goal = Goal::of(&problem.columns, &problem.row, &reference, observed(&reference));
    Ok(Atlas::judged(ways, reference, &goal, problem.span, trials))
}

/// The atlas without timing. A stored reference is used if it belongs to the scene; else, or if `kept` is
/// `None`, a reference is computed within the time `patience`. A motion that ends by itself is
/// compared until shortly before its end.
///
/// # Errors
/// [`Unknown`] where there is no reference.
pub fn judged_across_events(
    scene: &dyn Hybrid,
    trials: &Trials,
    kept: Option<&Stored>,
    patience: Duration,
) -> Result<Atlas, Unknown> {
    let reference = match kept.filter(|kept| kept.belongs_to(&*scene.owner())) {
        Some(kept) => kept.reference.clone(),
        None => scene.exact(patience)?.reference,
    };
    if !reference.is_trusted() {
        return Err(Unknown::FewDigits { digits: reference.digits });
    }
    let way = scene.way();
    let goal = Goal::of(&way.columns, &way.row, &reference, scene.observed(&way.columns, &reference));
    let end = reference.times.last().copied().unwrap_or(scene.end());
    Ok(Atlas::judged(vec![way], reference, &goal, end, trials))
}
