//! The equations of motion in matrix form, with constraints and their multipliers:
//!
//!   M u' + h = J^T lambda,    J u' + c = 0,    u = q'
//!
//! with h = inertia that depends on speeds less all forces. A constraint on positions enters twice differentiated, one on speeds
//! once.

mod articulated_bodies;
mod characteristics;
mod constraints;
mod elimination;
mod generic_point;
mod guides;
mod integrability;
mod residuals;
mod zero_test;

pub(crate) use characteristics::solved_in_short;
pub use characteristics::{Characteristics, SolvedMotion};
pub use constraints::{Equation, Level, equations as constraints_of, implied as implied_constraints};
pub(crate) use constraints::{ScalarConstraint, held_of, independent};
pub use elimination::{Pushes, Singular, solve_sparse};
pub(crate) use generic_point::{Dependence, circuits as generic_circuits, courses, depends};
pub use generic_point::{generic_rank, pivots as generic_pivots};
pub use guides::balances;
pub use integrability::{Integrability, Undecided};
pub use residuals::Residuals;
pub use zero_test::vanishes;

use crate::Trace;

use crate::principles::{NotApplicable, Principle};
use symbolic::{Sym, substitute_all};

/// Those of some equations of constraints that depend on the others at a general point too, and not on a branch of their positions alone.
pub fn dependent_everywhere(trace: &Trace<'_>, among: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let (these, others): (Vec<Equation>, Vec<Equation>) =
        constraints_of(trace).into_iter().partition(|one| among.contains(&one.of));
    let others: Vec<Vec<Sym>> = others.into_iter().map(|one| one.row).collect();
    these.into_iter().filter(|one| depends(&one.row, &others)).map(|one| one.of).collect()
}

/// Accelerations u' and multipliers lambda; otherwise the first coordinate, or constraint, whose pivot is the constant zero.
pub type Solved = Result<(Vec<Sym>, Vec<Sym>), Singular>;

/// The number of speeds beyond which the tree of bodies is used instead of the mass matrix, where there is one: the
/// result is shorter.
pub const MOST_COMPARED: usize = 8;

/// Accelerations and multipliers: over the tree of bodies, or from the mass matrix where that is shorter or there is no tree.
///
/// # Errors
/// The first coordinate, or constraint, without a pivot that is not zero as it stands.
pub fn solved(trace: &Trace<'_>) -> Solved {
    let by_matrix = || Equations::of(trace).solved();
    let Some(Ok(over_tree)) = solved_over_tree(trace) else { return by_matrix() };
    if trace.speeds.len() > MOST_COMPARED {
        return Ok(over_tree);
    }
    let length = |(accelerations, multipliers): &(Vec<Sym>, Vec<Sym>)| {
        Sym::operations_of(&[&accelerations[..], multipliers].concat())
    };
    Ok(by_matrix().ok().filter(|other| length(other) <= length(&over_tree)).unwrap_or(over_tree))
}

/// Accelerations and multipliers over the tree of bodies; none where there is no tree.
pub fn solved_over_tree(trace: &Trace<'_>) -> Option<Solved> {
    articulated_bodies::solved(trace)
}

/// Whether the accelerations of a model are found over a tree of bodies.
pub fn has_tree(trace: &Trace<'_>) -> bool {
    articulated_bodies::are_of(trace)
}

/// The equations of motion of a model, over the symbols of a trace.
#[derive(Clone, Debug)]
pub struct Equations {
    /// M, row after row; symmetric.
    pub mass: Vec<Vec<Sym>>,
    /// h.
    pub bias: Vec<Sym>,
    /// One for each scalar constraint.
    pub constraints: Vec<Equation>,
}

impl Equations {
    /// The equations by a principle.
    ///
    /// # Errors
    /// Where the principle does not apply to the model.
    pub fn by(principle: Principle, trace: &Trace<'_>) -> Result<Self, NotApplicable> {
        let residual = principle.residual(trace)?;
        let n = residual.len();
        let mass = residual.iter().map(|row| (0..n).map(|j| trace.by_acceleration(*row, j)).collect()).collect();
        let constraints = constraints::equations(trace);
        // multipliers drop out where a principle contains the constraints
        let none = constraints.iter().map(|constraint| constraint.multiplier);
        let at_rest: Vec<(Sym, Sym)> =
            trace.accelerations.iter().copied().chain(none).map(|symbol| (symbol, Sym::ZERO)).collect();
        let bias = substitute_all(&residual, &at_rest);
        Ok(Equations { mass, bias, constraints })
    }

    /// The equations by the first principle that applies: the bodies' projected ones, or Lagrange's where an energy is given.
    pub fn of(trace: &Trace<'_>) -> Self {
        let given = trace.model.energies.kinetic.is_some();
        let principle = if given { Principle::Lagrange } else { Principle::VirtualPower };
        Equations::by(principle, trace).unwrap_or_else(|_| Equations {
            mass: Vec::new(),
            bias: Vec::new(),
            constraints: Vec::new(),
        })
    }

    /// The accelerations u' and the multipliers lambda.
    ///
    /// # Errors
    /// The first coordinate, or constraint, without a pivot that is not zero as it stands.
    pub fn solved(&self) -> Solved {
        elimination::solved(self)
    }

    /// The accelerations with unknown multipliers.
    ///
    /// # Errors
    /// The first coordinate without a pivot that is not zero as it stands.
    pub fn pushes(&self) -> Result<Pushes, Singular> {
        elimination::pushes(self)
    }
}
