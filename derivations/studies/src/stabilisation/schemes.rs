//! One step of a method for the equation y'' = -b y' - k y of a constraint violation, over any scalar type.
//!
//! In the variables (y, h y') the matrix of a step h depends only on beta = h b and kappa = h^2 k. The explicit methods
//! are those of `integrators`; the implicit ones solve for their stage.

use field::Scalar;
use integrators::{Method, euler_step, runge_kutta_4_step};
use mechanics::definite::{NotDefinite, solve};

/// Methods with constant step size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    Euler,
    RungeKutta4,
    BackwardEuler,
    ImplicitMidpoint,
}

impl Scheme {
    /// All schemes, explicit ones first.
    pub const ALL: [Scheme; 4] = [Scheme::Euler, Scheme::RungeKutta4, Scheme::BackwardEuler, Scheme::ImplicitMidpoint];

    /// The name in headings.
    pub fn name(self) -> &'static str {
        match self {
            Scheme::Euler => "Euler",
            Scheme::RungeKutta4 => "Runge-Kutta 4",
            Scheme::BackwardEuler => "backward Euler",
            Scheme::ImplicitMidpoint => "implicit midpoint",
        }
    }

    /// The integration method with a number of equal steps.
    pub fn method(self, steps: u32) -> Method {
        match self {
            Scheme::Euler => Method::Euler { steps },
            Scheme::RungeKutta4 => Method::RungeKutta4 { steps },
            Scheme::BackwardEuler => Method::BackwardEuler { steps },
            Scheme::ImplicitMidpoint => Method::ImplicitMidpoint { steps },
        }
    }

    /// The scheme of an integration method over a span (s), with its step size (s); `None` for a variable step size or
    /// another method.
    pub fn of(method: Method, span: f64) -> Option<(Self, f64)> {
        let steps = method.steps()?;
        let scheme = Self::ALL.into_iter().find(|scheme| scheme.method(steps) == method)?;
        Some((scheme, span / f64::from(steps)))
    }

    /// The gains (beta, kappa) of the fastest decay, for which the matrix of a step is nilpotent or zero. Backward
    /// Euler has none: the decay becomes faster with larger gains.
    pub fn best(self) -> Option<(f64, f64)> {
        match self {
            Scheme::Euler => Some((2.0, 1.0)),
            Scheme::RungeKutta4 => {
                let kappa = 3.781_252_789_774_63;
                Some((deadbeat_damping(kappa), kappa))
            }
            Scheme::BackwardEuler => None,
            Scheme::ImplicitMidpoint => Some((4.0, 4.0)),
        }
    }

    /// The solution of y' = A y after one step of size one.
    ///
    /// # Errors
    /// [`NotDefinite`] where elimination without pivoting fails for the stage of an implicit method.
    pub fn step<S: Scalar, const N: usize>(self, matrix: [[S; N]; N], before: [S; N]) -> Result<[S; N], NotDefinite> {
        let rates = |_time: S, y: &[S], dy: &mut [S]| {
            for (slope, row) in dy.iter_mut().zip(matrix) {
                *slope = row.into_iter().zip(y).fold(S::zero(), |sum, (a, y)| sum + a * *y);
            }
        };
        let mut after = [S::zero(); N];
        match self {
            Scheme::Euler => euler_step(rates, S::zero(), &before, S::one(), &mut [S::zero(); N], &mut after),
            Scheme::RungeKutta4 => {
                let mut slopes = std::array::from_fn(|_| vec![S::zero(); N]);
                runge_kutta_4_step(rates, S::zero(), &before, S::one(), &mut slopes, &mut [S::zero(); N], &mut after);
            }
            Scheme::BackwardEuler => return implicit(S::one(), matrix, before),
            Scheme::ImplicitMidpoint => return implicit(S::ratio(1, 2), matrix, before),
        }
        Ok(after)
    }

    /// The matrix of a step in (y, h y').
    ///
    /// # Errors
    /// [`NotDefinite`] where elimination without pivoting fails for the stage of an implicit method.
    pub fn transition<S: Scalar>(self, beta: S, kappa: S) -> Result<[[S; 2]; 2], NotDefinite> {
        let law = [[S::zero(), S::one()], [-kappa, -beta]];
        let [first, second] = [[S::one(), S::zero()], [S::zero(), S::one()]].map(|unit| self.step(law, unit));
        let (first, second) = (first?, second?);
        Ok([[first[0], second[0]], [first[1], second[1]]])
    }
}

/// The damping beta for which a step of Runge-Kutta 4 is nilpotent, given the stiffness kappa.
pub fn deadbeat_damping<S: Scalar>(kappa: S) -> S {
    kappa * (S::int(24) - S::int(4) * kappa) / (S::int(24) - kappa.squared())
}

/// An implicit step with one stage: (I - c A) Y = y, then y + (Y - y) / c.
fn implicit<S: Scalar, const N: usize>(node: S, matrix: [[S; N]; N], before: [S; N]) -> Result<[S; N], NotDefinite> {
    let one = |yes: bool| if yes { S::one() } else { S::zero() };
    let left = std::array::from_fn(|i| std::array::from_fn(|j| one(i == j) - node * matrix[i][j]));
    let stage = solve(left, before)?;
    Ok(std::array::from_fn(|i| before[i] + (stage[i] - before[i]) / node))
}

/// Three expressions that are positive if and only if both roots of l^2 - T l + D are inside the unit circle:
/// 1 - D, 1 - T + D, 1 + T + D (Schur, Cohn; Jury).
pub fn inside_unit_circle<S: Scalar>([[a, b], [c, d]]: [[S; 2]; 2]) -> [S; 3] {
    let (trace, determinant) = (a + d, a * d - b * c);
    [S::one() - determinant, S::one() - trace + determinant, S::one() + trace + determinant]
}
