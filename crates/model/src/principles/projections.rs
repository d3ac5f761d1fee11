//! Principles that include the constraints: one equation for each independent speed, without multipliers.

use super::loads::generalised;
use super::{NotApplicable, Principle};
use crate::Trace;
use crate::equations::{Characteristics, Equation, SolvedMotion};
use std::fmt;
use symbolic::Sym;

/// A principle whose equations are projected onto the admissible directions of the constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// Maggi: sum (d/dt dT/du_i - dT/dq_i - Q_i) du_i/dw_j = 0, with the kinematic characteristics du/dw.
    Maggi,
    /// Shulgin: d/dt dT*/dw_j - X_j(T*) - lost_j = sum Q_i du_i/dw_j. The constraints are substituted into T*, which requires the term lost_j.
    Shulgin,
}

impl Projection {
    pub const ALL: [Projection; 2] = [Projection::Maggi, Projection::Shulgin];

    /// Returns the name in commands.
    pub fn name(self) -> &'static str {
        match self {
            Projection::Maggi => "maggi",
            Projection::Shulgin => "shulgin",
        }
    }
}

impl fmt::Display for Projection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.name())
    }
}

/// Lagrange's operator applied to a kinetic energy T* into which the constraints are substituted.
///
/// With the vector fields X_j = d/dq_j + sum (du_d/dw_j) d/dq_d of the virtual displacements
///
///   d/dt dT*/dw_j - X_j(T*) = sum (d/dt dT/du_i - dT/dq_i) du_i/dw_j + lost_j ,
///   lost_j = sum (dT/du_d) (d/dt du_d/dw_j - X_j(u_d)) .
///
/// Rotations of a free frame add w x dT/dw to both operators, with the momenta of T* on the left and those of T on the right; their difference
/// belongs to the lost term.
///
/// The lost term vanishes if the constraints are integrable, or if its momenta vanish.
#[derive(Clone, Debug)]
pub struct Operator {
    /// d/dt dT*/dw_j - X_j(T*), for each independent speed.
    pub energy: Vec<Sym>,
    /// The parts of lost_j: a row for each independent speed, a column for each dependent speed and a last one for the rotations of free frames.
    pub lost: Vec<Vec<Sym>>,
    /// The factors d/dt du_d/dw_j - X_j(u_d) of the momenta: all are zero if the constraints are integrable.
    pub brackets: Vec<Vec<Sym>>,
}

/// Computes the operator and the lost terms, for states that satisfy the constraints.
pub fn operator(trace: &Trace<'_>, characteristics: &Characteristics, motion: &SolvedMotion) -> Operator {
    let kinetic = trace.kinetic_and_coenergy();
    let reduced = motion.on_constraints(&[kinetic])[0];
    let momenta: Vec<Sym> = characteristics.dependent.iter().map(|&(d, _)| trace.by_speed(kinetic, d)).collect();
    let momenta = motion.on_constraints(&momenta);
    let rate = |expression: Sym| motion.on_constraints(&[trace.rate_of(expression)])[0];
    let slopes = &characteristics.slopes;
    // X_j(f)
    let along = |expression: Sym, place: usize| {
        let own = trace.by_coordinate(expression, characteristics.independent[place]);
        let dependent = characteristics.dependent.iter().zip(slopes);
        dependent.fold(own, |sum, (&(d, _), slopes)| sum + slopes[place] * trace.by_coordinate(expression, d))
    };
    let turned = |j: usize| motion.on_constraints(&[trace.transposition(j, |k| trace.by_speed(reduced, k))])[0];
    let energy = |(place, &j): (usize, &usize)| rate(trace.by_speed(reduced, j)) + turned(j) - along(reduced, place);
    // the term of free rotations with the momenta of T*, minus that with the momenta of T along the same displacement
    let of_whole = |i: usize| trace.transposition(i, |k| trace.by_speed(kinetic, k));
    let whole: Vec<Sym> = (0..trace.speeds.len()).map(of_whole).collect();
    let whole = motion.on_constraints(&characteristics.along(&whole));
    let brackets = |place: usize| -> Vec<Sym> {
        let dependent = motion.speeds.iter().zip(slopes);
        dependent.map(|(&(_, speed), slopes)| rate(slopes[place]) - along(speed, place)).collect()
    };
    let brackets: Vec<Vec<Sym>> = (0..characteristics.independent.len()).map(brackets).collect();
    let lost = |place: usize| {
        let parts = momenta.iter().zip(&brackets[place]).map(|(&momentum, &bracket)| momentum * bracket);
        parts.chain([turned(characteristics.independent[place]) - whole[place]]).collect()
    };
    Operator {
        energy: characteristics.independent.iter().enumerate().map(energy).collect(),
        lost: (0..characteristics.independent.len()).map(lost).collect(),
        brackets,
    }
}

impl Projection {
    /// Returns inertia minus forces along each independent speed.
    ///
    /// # Errors
    /// The principle does not apply to the constraints.
    pub fn residual(
        self,
        trace: &Trace<'_>,
        constraints: &[Equation],
        characteristics: &Characteristics,
    ) -> Result<Vec<Sym>, NotApplicable> {
        match self {
            Projection::Maggi => Ok(characteristics.along(&Principle::Lagrange.residual(trace)?)),
            Projection::Shulgin => {
                let motion = linear(constraints, characteristics.motion(trace, constraints))?;
                let Operator { energy, lost, .. } = operator(trace, characteristics, &motion);
                let forces = motion.on_constraints(&characteristics.along(&generalised(trace, true)));
                let lost = lost.iter().map(|parts| parts.iter().fold(Sym::ZERO, |sum, &part| sum + part));
                Ok(energy
                    .into_iter()
                    .zip(lost)
                    .zip(forces)
                    .map(|((energy, lost), force)| energy - lost - force)
                    .collect())
            }
        }
    }
}

/// Returns the motion on the constraints; the error names a constraint that is nonlinear in the speeds, or stabilised.
pub(crate) fn linear(
    constraints: &[Equation],
    motion: Result<SolvedMotion, usize>,
) -> Result<SolvedMotion, NotApplicable> {
    if let Some(place) = constraints.iter().position(|constraint| constraint.gains.is_some()) {
        let title = constraints[place].title(place);
        return Err(NotApplicable(format!("{title} is programmed: it need not hold along a motion")));
    }
    motion.map_err(|place| NotApplicable(format!("{} is not linear in the speeds", constraints[place].title(place))))
}
