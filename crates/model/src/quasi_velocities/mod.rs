//! Quasi-velocities w, and the speeds u as functions of them.
//!
//! Each w is affine in the speeds, w = B u + b. Together with the rates s = J u + c of the constraints, they determine the speeds,
//!
//!   u = C w + D s + d,    J C = 0,    B C = 1 ,
//!
//! with s = 0 along every motion. The columns of C are directions of admissible displacements. Stabilised (programmed) constraints are not part of s:
//! they may be violated, and remain equations with multipliers.
//!
//! Angular velocities of free frames are computed along axes in which the derivatives are short. The only divisors of the speeds are the
//! factors of the determinant of the whole change of variables that are not constant.

mod appell;
mod axes;
mod coefficients;
mod construction;
mod hamel;
mod independence;
mod independent_rates;
mod integrals;
mod inverse;
mod maggi;
mod reduced_equations;
mod short_forms;
mod shulgin;
mod virtual_power;

pub use coefficients::Coefficient;
pub use integrals::INTEGRAL;
pub use reduced_equations::{QuasiPrinciple, quasi_agreement};

use crate::equations::{Equation, Level, constraints_of};
use crate::{Fault, FrameId, Trace, Turn, Vector};
use independence::Dependence;
use short_forms::ShortForms;
use std::cell::RefCell;
use symbolic::{Derivation, Sym, substitute_all};

/// The quasi-velocities of a model, over the symbols of a trace.
pub struct QuasiVelocities<'t, 'm> {
    trace: &'t Trace<'m>,
    /// The symbols w.
    pub symbols: Vec<Sym>,
    /// The symbols of the rates w'.
    pub accelerations: Vec<Sym>,
    /// The quasi-velocities w as functions of coordinates, speeds and the time.
    pub definitions: Vec<Sym>,
    /// The speeds u as functions of coordinates, w and the time.
    pub speeds: Vec<Sym>,
    /// The rates q' as functions of coordinates, w and the time: the kinematic equations.
    pub position_rates: Vec<Sym>,
    /// The matrix C: a row for each speed, a column for each w.
    directions: Vec<Vec<Sym>>,
    /// The matrix D: a row for each speed, a column for each independent constraint.
    across: Vec<Vec<Sym>>,
    /// Constraints that are satisfied identically.
    pub met: Vec<Equation>,
    /// Stabilised (programmed) constraints, whose violation decays with the given gains.
    pub programmed: Vec<Equation>,
    /// The indices of the independent constraints in `met`.
    independent: Vec<usize>,
    /// Expressions by which the speeds are divided. Where one of them vanishes, the quasi-velocities do not determine the speeds.
    pub divisors: Vec<Sym>,
    /// Symbols of long derivatives, if requested by [`QuasiVelocities::named`].
    pub coefficients: Vec<Coefficient>,
    is_named: bool,
    /// The angular velocities of free frames relative to their parents, as functions of w.
    turning: Vec<Vector>,
    /// The time derivative along the motion, of functions of coordinates, w and w'.
    rate: RefCell<Derivation>,
    /// u as functions of w, and u' as functions of w and w'.
    known: [Vec<(Sym, Sym)>; 2],
}

/// Constraints and definitions, before the speeds are solved for.
struct Independent {
    met: Vec<Equation>,
    programmed: Vec<Equation>,
    definitions: Vec<Sym>,
    /// The indices of the independent constraints.
    independent: Vec<usize>,
}

impl Independent {
    fn of(trace: &Trace<'_>) -> Result<Self, Dependence> {
        let (met, programmed): (Vec<Equation>, Vec<Equation>) =
            constraints_of(trace).into_iter().partition(|constraint| constraint.gains.is_none());
        let quasi_velocities = trace.model.quasi_velocities.iter();
        let definitions: Vec<Sym> = quasi_velocities.map(|speed| trace.scalar(speed.is)).collect();
        let independent = independence::independent(trace, &met, &definitions)?;
        Ok(Independent { met, programmed, definitions, independent })
    }
}

/// Returns the faults of a model's quasi-velocities, and whether they may disappear on the branch of the start: constraints of positions that are independent
/// generically may be dependent there.
pub(crate) fn faults(trace: &Trace<'_>) -> (Vec<Fault>, bool) {
    match Independent::of(trace) {
        Ok(_) => (Vec::new(), false),
        Err(Dependence::Forms(faults)) => (faults, false),
        Err(Dependence::Ranks(fault)) => {
            let is_kept = |one: &Equation| one.gains.is_none() && one.level == Level::Position;
            (vec![fault], constraints_of(trace).iter().any(is_kept))
        }
    }
}

impl<'t, 'm> QuasiVelocities<'t, 'm> {
    /// Solves the definitions of a model's quasi-velocities for the speeds.
    ///
    /// # Errors
    /// Quasi-velocities that are not affine in the speeds, dependent, too many or too few.
    pub fn of(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, false)
    }

    /// Solves for the speeds, with symbols for their long derivatives: the equations contain these symbols and their rates. Hamel's equations are not
    /// available in this form.
    ///
    /// # Errors
    /// The errors of [`QuasiVelocities::of`].
    pub fn named(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, true)
    }

    /// Returns the quasi-velocities in the same form for another trace of the model, with other loads.
    pub(crate) fn beside<'o, 'n>(&self, trace: &'o Trace<'n>) -> Result<QuasiVelocities<'o, 'n>, Vec<Fault>> {
        QuasiVelocities::written(trace, self.is_named)
    }

    /// Substitutes speeds and accelerations by functions of w and w', and variable masses by their expressions.
    pub fn by_quasi_velocities(&self, expressions: &[Sym]) -> Vec<Sym> {
        let [speeds, accelerations] = &self.known;
        let with_masses = self.trace.with_masses(expressions);
        substitute_all(&substitute_all(&with_masses, accelerations), speeds)
    }

    /// Substitutes speeds and accelerations by functions of w and w'; symbols of variable masses are retained.
    fn moved(&self, expression: Sym) -> Sym {
        let [speeds, accelerations] = &self.known;
        expression.substitute(accelerations).substitute(speeds)
    }

    fn moved_vector(&self, vector: Vector) -> Vector {
        vector.map(|component| self.moved(component))
    }

    /// Returns the angular velocity of a frame; for a free frame along the axes in which it is short.
    fn turning(&self, frame: FrameId) -> Vector {
        match self.trace.model.frames[frame.0].parent {
            Some((parent, Turn::Free { number })) => self.trace.sum(self.turning(parent), self.turning[number]),
            _ => self.moved_vector(self.trace.turning(frame)),
        }
    }

    /// Returns the time derivative along the motion of a function of coordinates and w.
    fn rate_of(&self, expression: Sym) -> Sym {
        self.rate.borrow_mut().of(expression)
    }

    /// Returns the rate, relative to the ground, of a vector that is a function of coordinates and w.
    fn vector_rate(&self, vector: Vector) -> Vector {
        let own = vector.map(|component| self.rate_of(component));
        let turning = self.turning(vector.frame);
        self.trace.sum(own, self.trace.cross(turning, vector))
    }

    /// Returns C^T v for a vector v with one entry per speed.
    fn along(&self, values: &[Sym]) -> Vec<Sym> {
        let along = |r: usize| {
            let terms = values.iter().zip(&self.directions);
            terms.fold(Sym::ZERO, |sum, (&value, row)| sum + value * row[r])
        };
        (0..self.symbols.len()).map(along).collect()
    }
}
