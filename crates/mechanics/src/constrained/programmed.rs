//! Constraint stabilisation (Baumgarte and generalisations): multipliers by which violations of constraints obey a
//! prescribed differential equation.
//!
//! A geometric constraint has the violation y = f(x, t) with the rate y'. A kinematic one has only the rate y' = phi(x,
//! x', t). Lagrange's multipliers make y'' = 0, under which numerical errors grow: y = y_0 + y'_0 t. With
//!
//!   J M^-1 J^T lambda = Y - (rates at x'' = M^-1 X)
//!
//! the violations satisfy y'' = Y(y, y', x, x', t) exactly, also off the constraints, wherever the rows of J are
//! independent. If Y = 0 at y = y' = 0, a motion that begins on the constraints is that of Lagrange's equations.
//!
//! Source: Baumgarte (1972), for a linear equation of each constraint separately.

use super::multipliers::{Reaction, leading_to};
use super::rates::first_rates;
use super::{Constrained, Constraint, State};
use crate::definite::{NotDefinite, solve};
use crate::differentiate::unit;
use field::{Base, Over};

/// The violations of the constraints and their rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation<S, const C: usize> {
    /// The violations y: f of a geometric constraint, zero for a kinematic one.
    pub value: [S; C],
    /// The rates y': df/dt of a geometric constraint, phi of a kinematic one.
    pub rate: [S; C],
}

/// A prescribed equation y'' = Y for the violations of C constraints on N coordinates.
pub trait Programme<const N: usize, const C: usize> {
    /// The scalar type of the gains.
    type Given: Base;

    /// The value Y, prescribed for f'' of a geometric constraint and phi' of a kinematic one.
    fn prescribed<S: Over<Self::Given>>(&self, at: &State<S, N>, violation: &Violation<S, C>) -> [S; C];
}

/// The linear equation y'' = -c y' - k y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear<P, const C: usize> {
    /// The matrix c, 1/s.
    pub damping: [[P; C]; C],
    /// The matrix k, 1/s^2. The column of a kinematic constraint has no effect.
    pub stiffness: [[P; C]; C],
}

impl<P: Base, const C: usize> Linear<P, C> {
    /// The equation y'' + 2 alpha y' + beta^2 y = 0 for each constraint (Baumgarte); phi' = -2 alpha phi for a
    /// kinematic one. Gains in 1/s.
    pub fn baumgarte(alpha: P, beta: P) -> Self {
        let diagonal = |gain: P| std::array::from_fn(|k| unit::<P, C>(k).map(|one| gain * one));
        Linear { damping: diagonal(alpha + alpha), stiffness: diagonal(beta.squared()) }
    }

    /// The equation a y'' + c y' + k y = 0, with an inertia a, a damping c and a stiffness k.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first row of the inertia that depends on those before it.
    pub fn of_energies(a: [[P; C]; C], c: [[P; C]; C], k: [[P; C]; C]) -> Result<Self, NotDefinite> {
        Ok(Linear { damping: per_inertia(a, c)?, stiffness: per_inertia(a, k)? })
    }
}

/// The matrix a^-1 b.
fn per_inertia<P: Base, const C: usize>(a: [[P; C]; C], b: [[P; C]; C]) -> Result<[[P; C]; C], NotDefinite> {
    let mut quotient = [[P::zero(); C]; C];
    for column in 0..C {
        let solved = solve(a, b.map(|row| row[column]))?;
        for (row, value) in quotient.iter_mut().zip(solved) {
            row[column] = value;
        }
    }
    Ok(quotient)
}

impl<P: Base, const N: usize, const C: usize> Programme<N, C> for Linear<P, C> {
    type Given = P;

    fn prescribed<S: Over<P>>(&self, _at: &State<S, N>, violation: &Violation<S, C>) -> [S; C] {
        std::array::from_fn(|k| {
            (0..C).fold(S::zero(), |sum, j| {
                sum - S::lift(self.damping[k][j]) * violation.rate[j]
                    - S::lift(self.stiffness[k][j]) * violation.value[j]
            })
        })
    }
}

/// The violations y and rates y' of a system in a state.
pub fn violation<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
) -> Violation<S, C> {
    let value = system.constraints(at).map(|constraint| match constraint {
        Constraint::Geometric(f) => f,
        Constraint::Kinematic(_) => S::zero(),
    });
    Violation { value, rate: first_rates(system, at) }
}

/// Accelerations and multipliers under a force for which the violations satisfy the prescribed equation.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that depends on those before it.
pub fn programmed<Q, L, S, const N: usize, const C: usize>(
    system: &Q,
    programme: &L,
    at: &State<S, N>,
    force: [S; N],
) -> Result<Reaction<S, N, C>, NotDefinite>
where
    Q: Constrained<N, C>,
    L: Programme<N, C>,
    S: Over<Q::Given> + Over<L::Given>,
{
    leading_to(system, at, force, programme.prescribed(at, &violation(system, at)))
}
