//! The stability functions of the Runge-Kutta methods with constant step size, derived from their steps.

use crate::stabilisation::schemes::Scheme;
use field::Scalar;
use integrators::{Family, nodal};
use mechanics::one_step_stability::StabilityFunction;
use std::fmt;
use symbolic::{Hypotheses, Sym, normal, univariate};

/// A Runge-Kutta method with constant step size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OneStep {
    Classical(Scheme),
    Collocation(Family, u8),
}

impl OneStep {
    /// The classical methods, and collocation with two and three stages. Gauss with one stage is the midpoint rule,
    /// Radau IIA with one stage is backward Euler.
    pub const ALL: [OneStep; 8] = [
        OneStep::Classical(Scheme::Euler),
        OneStep::Classical(Scheme::RungeKutta4),
        OneStep::Classical(Scheme::ImplicitMidpoint),
        OneStep::Collocation(Family::Gauss, 2),
        OneStep::Collocation(Family::Gauss, 3),
        OneStep::Classical(Scheme::BackwardEuler),
        OneStep::Collocation(Family::RadauIIA, 2),
        OneStep::Collocation(Family::RadauIIA, 3),
    ];

    /// R(z) for any expression `z`, by a step for y' = z y.
    ///
    /// For collocation u' - z u vanishes at the nodes, hence is a multiple of their polynomial N, and u of degree s is
    /// sum_k N^(k) z^(s-k); R is its value at the end divided by that at the start.
    pub fn run(self, z: Sym) -> Sym {
        match self {
            OneStep::Classical(scheme) => scheme.step([[z]], [Sym::int(1)]).map_or(Sym::UNDEFINED, |[end]| end),
            OneStep::Collocation(family, stages) => {
                let place = Sym::symbol("c");
                let course = course(family, stages, place, z);
                let at = |c: i64| course.substitute(&[(place, Sym::int(c))]);
                at(1) / at(0)
            }
        }
    }

    /// R as a quotient of polynomials; `None` where it is not rational.
    pub fn function(self) -> Option<StabilityFunction> {
        let z = Sym::symbol("z");
        let form = normal(self.run(z), &Hypotheses::none()).ok()?;
        let dense = |part: Sym| univariate(part, z).ok();
        let (mut numerator, mut denominator) = (dense(form.numerator())?, dense(form.denominator())?);
        let first = *denominator.first()?;
        numerator.iter_mut().chain(&mut denominator).for_each(|c| *c /= first);
        Some(StabilityFunction { numerator, denominator })
    }
}

/// u(c), up to a factor, with u' - z u = -z^(s+1) N.
pub fn course(family: Family, stages: u8, place: Sym, z: Sym) -> Sym {
    let mut derivative = nodal(family, stages.into(), place);
    let mut sum = Sym::ZERO;
    for power in (0..=i32::from(stages)).rev() {
        sum += derivative * z.powi(power);
        derivative = derivative.diff(place);
    }
    sum
}

impl fmt::Display for OneStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OneStep::Classical(scheme) => write!(f, "{}", scheme.name()),
            OneStep::Collocation(Family::Gauss, stages) => write!(f, "Gauss, {stages} stages"),
            OneStep::Collocation(Family::RadauIIA, stages) => write!(f, "Radau IIA, {stages} stages"),
        }
    }
}
