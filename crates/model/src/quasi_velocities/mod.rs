//! Quasi-velocities w, and the speeds u by them.
//!
//! Each w is affine in the speeds, w = B u + b. With the rates s = J u + c of the constraints that hold they determine the speeds,
//!
//!   u = C w + D s + d,    J C = 0,    B C = 1 ,
//!
//! and s = 0 along every motion. The columns of C are directions of admissible displacements. Programmed constraints are no part of s:
//! they need not hold, and stay equations with multipliers.
//!
//! Angular velocities of free frames are solved for along axes in which derivatives are short. The speeds have no other divisors than the
//! determinant of the whole change, up to its factors that are constants.

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

/// Quasi-velocities over the symbols of a trace.
pub struct QuasiVelocities<'t, 'm> {
    trace: &'t Trace<'m>,
    /// w.
    pub symbols: Vec<Sym>,
    /// w'.
    pub accelerations: Vec<Sym>,
    /// w by coordinates, speeds and the time.
    pub definitions: Vec<Sym>,
    /// u by coordinates, w and the time.
    pub speeds: Vec<Sym>,
    /// q' by coordinates, w and the time: kinematic equations.
    pub position_rates: Vec<Sym>,
    /// C: of each speed by each w.
    directions: Vec<Vec<Sym>>,
    /// D: of each speed by the rate of each independent constraint that holds.
    across: Vec<Vec<Sym>>,
    /// Constraints that hold.
    pub met: Vec<Equation>,
    /// Programmed constraints: their violation decays with the given gains.
    pub programmed: Vec<Equation>,
    /// The independent ones among the constraints that hold, by their places.
    independent: Vec<usize>,
    /// Expressions that the speeds are divided by: where one of them vanishes, the quasi-velocities do not determine the speeds.
    pub divisors: Vec<Sym>,
    /// Letters in the directions, where they are asked for.
    pub coefficients: Vec<Coefficient>,
    is_named: bool,
    /// Angular velocities of free frames in their parents, by w.
    turning: Vec<Vector>,
    /// Along the motion, over coordinates, w and w'.
    rate: RefCell<Derivation>,
    /// u and u' by w and w'.
    known: [Vec<(Sym, Sym)>; 2],
}

/// Constraints and definitions, before speeds are solved for.
struct Independent {
    met: Vec<Equation>,
    programmed: Vec<Equation>,
    definitions: Vec<Sym>,
    /// Places of the constraints that are independent.
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

/// Faults of the quasi-velocities of a model, and whether they may be none on the branch of the start: constraints of positions may be
/// dependent there, and at a general point are not.
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
    /// The quasi-velocities of a model.
    ///
    /// # Errors
    /// Each of them that is not affine in the speeds or depends on others; or how many are missing.
    pub fn of(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, false)
    }

    /// With letters for long derivatives of speeds: equations hold these and their rates. Hamel's equations cannot be written
    /// with them.
    ///
    /// # Errors
    /// As [`QuasiVelocities::of`].
    pub fn named(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, true)
    }

    /// The quasi-velocities of the same model with other loads, in the same form.
    pub(crate) fn beside<'o, 'n>(&self, trace: &'o Trace<'n>) -> Result<QuasiVelocities<'o, 'n>, Vec<Fault>> {
        QuasiVelocities::written(trace, self.is_named)
    }

    /// Expressions over speeds and accelerations by w and w'; masses that vary by their values.
    pub fn by_quasi_velocities(&self, expressions: &[Sym]) -> Vec<Sym> {
        let [speeds, accelerations] = &self.known;
        let with_masses = self.trace.with_masses(expressions);
        substitute_all(&substitute_all(&with_masses, accelerations), speeds)
    }

    /// One expression over w and w', in which letters of masses that vary stay.
    fn moved(&self, expression: Sym) -> Sym {
        let [speeds, accelerations] = &self.known;
        expression.substitute(accelerations).substitute(speeds)
    }

    fn moved_vector(&self, vector: Vector) -> Vector {
        vector.map(|component| self.moved(component))
    }

    /// The angular velocity of a frame, of a free one along the axes in which it is short.
    fn turning(&self, frame: FrameId) -> Vector {
        match self.trace.model.frames[frame.0].parent {
            Some((parent, Turn::Free { number })) => self.trace.sum(self.turning(parent), self.turning[number]),
            _ => self.moved_vector(self.trace.turning(frame)),
        }
    }

    /// The rate along the motion of an expression over coordinates and w.
    fn rate_of(&self, expression: Sym) -> Sym {
        self.rate.borrow_mut().of(expression)
    }

    /// The rate of a vector over coordinates and w, as the ground sees it.
    fn vector_rate(&self, vector: Vector) -> Vector {
        let own = vector.map(|component| self.rate_of(component));
        let turning = self.turning(vector.frame);
        self.trace.sum(own, self.trace.cross(turning, vector))
    }

    /// C^T v: values for each speed along each w.
    fn along(&self, values: &[Sym]) -> Vec<Sym> {
        let along = |r: usize| {
            let terms = values.iter().zip(&self.directions);
            terms.fold(Sym::ZERO, |sum, (&value, row)| sum + value * row[r])
        };
        (0..self.symbols.len()).map(along).collect()
    }
}
