//! The integration methods and their properties.

use std::fmt;

use crate::{Refusal, Splitting};

/// The largest number of stages of a collocation method; tested to 30 digits.
pub const MOST_STAGES: u8 = 20;

/// The largest number of unknowns n of one implicit step: its matrix has n^2 entries.
const MOST_UNKNOWNS: usize = 4000;

/// A method of integration. Those with `steps` make equal steps over the span; the others control the step size by the
/// tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// The explicit Euler method.
    Euler { steps: u32 },
    /// The classical Runge-Kutta method of order 4.
    RungeKutta4 { steps: u32 },
    /// The backward Euler method.
    BackwardEuler { steps: u32 },
    /// The implicit midpoint rule.
    ImplicitMidpoint { steps: u32 },
    /// A splitting method, for systems that provide the flows of their pieces.
    Split { splitting: Splitting, steps: u32 },
    /// Dormand-Prince 5(4).
    DormandPrince5,
    /// Dormand-Prince 8(5,3).
    DormandPrince8,
    /// Verner's 6(5), crate `differential-equations`.
    Verner6,
    /// Verner's 9(8), crate `differential-equations`.
    Verner9,
    /// Hairer and Wanner's Radau5, crate `differential-equations`.
    Radau5,
    /// Kvaerno's ESDIRK 5(4) with 7 stages, crate `differential-equations`.
    Kvaerno5,
    /// Gragg-Bulirsch-Stoer extrapolation, variable order.
    GraggBulirschStoer,
    /// Gauss collocation, order 2s.
    Gauss { stages: u8 },
    /// Radau IIA collocation, order 2s - 1.
    RadauIIA { stages: u8 },
    /// Hairer and Wanner's Rosenbrock pair 4(3) with 6 stages.
    Rodas4,
    /// Bader and Deuflhard's extrapolation of the linearly implicit midpoint rule, variable order.
    BaderDeuflhard,
    /// Taylor's method after Jorba and Zou (2005), for systems that provide Taylor series.
    Taylor,
}

/// Properties of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Traits {
    /// The order of convergence; `None` where it varies.
    pub order: Option<u32>,
    /// Whether each step solves equations: such methods are suited for stiff problems.
    pub implicit: bool,
    /// Whether the step size is controlled by a tolerance; otherwise it is constant.
    pub adaptive: bool,
    /// Whether the method also runs in double-double.
    pub exact: bool,
}

impl Method {
    /// The method's properties.
    pub fn traits(self) -> Traits {
        let adaptive = Traits { order: None, implicit: false, adaptive: true, exact: true };
        match self {
            Method::Euler { .. } => Traits { order: Some(1), adaptive: false, ..adaptive },
            Method::RungeKutta4 { .. } => Traits { order: Some(4), adaptive: false, ..adaptive },
            Method::BackwardEuler { .. } => Traits { order: Some(1), adaptive: false, implicit: true, ..adaptive },
            Method::ImplicitMidpoint { .. } => Traits { order: Some(2), adaptive: false, implicit: true, ..adaptive },
            Method::Split { splitting, .. } => {
                Traits { order: Some(splitting.order()), adaptive: false, exact: splitting.exact(), ..adaptive }
            }
            Method::DormandPrince5 => Traits { order: Some(5), exact: false, ..adaptive },
            Method::DormandPrince8 => Traits { order: Some(8), exact: false, ..adaptive },
            Method::Verner6 => Traits { order: Some(6), exact: false, ..adaptive },
            Method::Verner9 => Traits { order: Some(9), exact: false, ..adaptive },
            Method::Radau5 | Method::Kvaerno5 => Traits { order: Some(5), exact: false, implicit: true, ..adaptive },
            Method::GraggBulirschStoer | Method::Taylor => adaptive,
            Method::Gauss { stages } => Traits { order: Some(2 * u32::from(stages)), implicit: true, ..adaptive },
            Method::RadauIIA { stages } => {
                Traits { order: Some((2 * u32::from(stages)).saturating_sub(1)), implicit: true, ..adaptive }
            }
            Method::Rodas4 => Traits { order: Some(4), exact: false, implicit: true, ..adaptive },
            Method::BaderDeuflhard => Traits { implicit: true, exact: false, ..adaptive },
        }
    }

    /// The number of equal steps; `None` for a method with step size control.
    pub fn steps(self) -> Option<u32> {
        match self {
            Method::Euler { steps }
            | Method::RungeKutta4 { steps }
            | Method::BackwardEuler { steps }
            | Method::ImplicitMidpoint { steps }
            | Method::Split { steps, .. } => Some(steps),
            _ => None,
        }
    }

    /// The method with another number of equal steps; unchanged with step size control.
    fn with_steps(self, steps: u32) -> Self {
        match self {
            Method::Euler { .. } => Method::Euler { steps },
            Method::RungeKutta4 { .. } => Method::RungeKutta4 { steps },
            Method::BackwardEuler { .. } => Method::BackwardEuler { steps },
            Method::ImplicitMidpoint { .. } => Method::ImplicitMidpoint { steps },
            Method::Split { splitting, .. } => Method::Split { splitting, steps },
            _ => self,
        }
    }

    /// The method with a single step over the span; unchanged with step size control.
    pub fn once(self) -> Self {
        self.with_steps(1)
    }

    /// The method with `times` as many steps; `None` for a method with step size control, or on overflow.
    pub fn refined(self, times: u32) -> Option<Self> {
        Some(self.with_steps(self.steps()?.checked_mul(times)?))
    }

    /// Checks the settings of the method.
    pub(crate) fn check(self, dimension: usize) -> Result<(), Refusal> {
        match self {
            Method::Euler { steps: 0 }
            | Method::RungeKutta4 { steps: 0 }
            | Method::BackwardEuler { steps: 0 }
            | Method::ImplicitMidpoint { steps: 0 }
            | Method::Split { steps: 0, .. } => Err(Refusal::Steps { given: 0 }),
            Method::Gauss { stages } | Method::RadauIIA { stages } if !(1..=MOST_STAGES).contains(&stages) => {
                Err(Refusal::Stages { given: stages.into(), least: 1, most: MOST_STAGES.into() })
            }
            Method::Gauss { stages } | Method::RadauIIA { stages }
                if dimension > MOST_UNKNOWNS / usize::from(stages) =>
            {
                Err(Refusal::TooLarge { dimension, most: MOST_UNKNOWNS / usize::from(stages) })
            }
            Method::Rodas4
            | Method::BaderDeuflhard
            | Method::BackwardEuler { .. }
            | Method::ImplicitMidpoint { .. }
                if dimension > MOST_UNKNOWNS =>
            {
                Err(Refusal::TooLarge { dimension, most: MOST_UNKNOWNS })
            }
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Method::Euler { steps } => write!(f, "Euler, {steps} steps"),
            Method::RungeKutta4 { steps } => write!(f, "Runge-Kutta 4, {steps} steps"),
            Method::BackwardEuler { steps } => write!(f, "backward Euler, {steps} steps"),
            Method::ImplicitMidpoint { steps } => write!(f, "implicit midpoint, {steps} steps"),
            Method::Split { splitting, steps } => write!(f, "{} splitting, {steps} steps", splitting.name()),
            Method::DormandPrince5 => write!(f, "Dormand-Prince 5(4)"),
            Method::DormandPrince8 => write!(f, "Dormand-Prince 8(5,3)"),
            Method::Verner6 => write!(f, "Verner 6(5)"),
            Method::Verner9 => write!(f, "Verner 9(8)"),
            Method::Radau5 => write!(f, "Radau5"),
            Method::Kvaerno5 => write!(f, "Kvaerno 5(4)"),
            Method::GraggBulirschStoer => write!(f, "Gragg-Bulirsch-Stoer"),
            Method::Gauss { stages } => write!(f, "Gauss, {stages} stages"),
            Method::RadauIIA { stages } => write!(f, "Radau IIA, {stages} stages"),
            Method::Rodas4 => write!(f, "Rodas4"),
            Method::BaderDeuflhard => write!(f, "Bader-Deuflhard"),
            Method::Taylor => write!(f, "Taylor"),
        }
    }
}
