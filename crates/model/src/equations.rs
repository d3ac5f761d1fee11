//! The equations of motion in matrix form, with constraints and their multipliers:
//!
//!   M u' + h = J^T lambda,    J u' + c = 0,    u = q'
//!
//! Here h contains the inertia terms without accelerations, minus all forces. A constraint on positions is differentiated twice, one on speeds
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

/// Returns those of the equations `among` that depend on the other equations at a generic point, and not only on a branch of the constraints' positions.
pub fn dependent_everywhere(trace: &Trace<'_>, among: &[[usize; 2]]) -> Vec<[usize; 2]> {
    let (these, others): (Vec<Equation>, Vec<Equation>) =
        constraints_of(trace).into_iter().partition(|one| among.contains(&one.of));
    let others: Vec<Vec<Sym>> = others.into_iter().map(|one| one.row).collect();
    these.into_iter().filter(|one| depends(&one.row, &others)).map(|one| one.of).collect()
}

/// The accelerations u' and the multipliers lambda; the error is the first coordinate or constraint whose pivot is the constant zero.
pub type Solved = Result<(Vec<Sym>, Vec<Sym>), Singular>;

/// If there are more speeds, and the bodies form a tree, only the recursion over the tree is used. Otherwise its result is compared with that of the mass matrix.
pub const MOST_COMPARED: usize = 8;

/// Solves for accelerations and multipliers, by recursion over the tree of bodies or by elimination in the mass matrix, whichever result is shorter.
///
/// # Errors
/// The first coordinate or constraint whose pivots are all the constant zero.
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

/// Solves for accelerations and multipliers by recursion over the tree of bodies; `None` if the bodies do not form a tree.
pub fn solved_over_tree(trace: &Trace<'_>) -> Option<Solved> {
    articulated_bodies::solved(trace)
}

/// Returns whether the recursion over a tree of bodies applies to a model.
pub fn has_tree(trace: &Trace<'_>) -> bool {
    articulated_bodies::are_of(trace)
}

/// The equations of motion of a model with n speeds, over the symbols of a trace.
#[derive(Clone, Debug)]
pub struct Equations {
    /// The mass matrix M, n x n by rows; symmetric.
    pub mass: Vec<Vec<Sym>>,
    /// The vector h, of length n.
    pub bias: Vec<Sym>,
    /// One equation for each scalar constraint.
    pub constraints: Vec<Equation>,
}

impl Equations {
    /// Forms the equations by a principle.
    ///
    /// # Errors
    /// The principle does not apply to the model.
    pub fn by(principle: Principle, trace: &Trace<'_>) -> Result<Self, NotApplicable> {
        let residual = principle.residual(trace)?;
        let n = residual.len();
        let mass = residual.iter().map(|row| (0..n).map(|j| trace.by_acceleration(*row, j)).collect()).collect();
        let constraints = constraints::equations(trace);
        // principles that contain the constraints have no multipliers
        let none = constraints.iter().map(|constraint| constraint.multiplier);
        let at_rest: Vec<(Sym, Sym)> =
            trace.accelerations.iter().copied().chain(none).map(|symbol| (symbol, Sym::ZERO)).collect();
        let bias = substitute_all(&residual, &at_rest);
        Ok(Equations { mass, bias, constraints })
    }

    /// Forms the equations by virtual power, or by Lagrange's principle if a kinetic energy is given.
    pub fn of(trace: &Trace<'_>) -> Self {
        let given = trace.model.energies.kinetic.is_some();
        let principle = if given { Principle::Lagrange } else { Principle::VirtualPower };
        Equations::by(principle, trace).unwrap_or_else(|_| Equations {
            mass: Vec::new(),
            bias: Vec::new(),
            constraints: Vec::new(),
        })
    }

    /// Solves for the accelerations u' and the multipliers lambda.
    ///
    /// # Errors
    /// The first coordinate or constraint whose pivots are all the constant zero.
    pub fn solved(&self) -> Solved {
        elimination::solved(self)
    }

    /// Solves for the accelerations as affine functions of unknown multipliers.
    ///
    /// # Errors
    /// The first coordinate whose pivots are all the constant zero.
    pub fn pushes(&self) -> Result<Pushes, Singular> {
        elimination::pushes(self)
    }
}
