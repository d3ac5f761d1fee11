//! Residuals of the equations of motion:
//!
//!   r = J^T lambda - (M z + h) ,    s = -(J z + c) .
//!
//! They vanish at the accelerations z and the multipliers lambda of the motion. Derivatives of z and lambda then do not require derivatives of the factors of M:
//!
//!   M dz - J^T dlambda = dr ,    J dz = ds ,    with constant z and lambda in dr and ds .

use super::{Equation, Equations, MOST_COMPARED, Solved, articulated_bodies, constraints_of};
use crate::trace::Trace;
use symbolic::Sym;

/// The residuals as expressions, and the solution of the linear equations with symbols as right sides.
pub struct Residuals {
    /// Residuals of the equations of motion, then of the constraints, as functions of positions, speeds, accelerations and multipliers.
    pub residuals: Vec<Sym>,
    /// A symbol for each right side.
    pub letters: Vec<Sym>,
    /// The solution of M z - J^T lambda = letters, J z = letters: accelerations, then multipliers.
    pub answers: Vec<Sym>,
}

impl Residuals {
    /// Returns the available forms: by recursion over the tree of bodies, and by the mass matrix except for large trees.
    pub fn of(trace: &Trace<'_>) -> Vec<Self> {
        let over_tree = Self::over_tree(trace);
        let is_large = over_tree.is_some() && trace.speeds.len() > MOST_COMPARED;
        let by_matrix = if is_large { None } else { Self::by_matrix(trace) };
        over_tree.into_iter().chain(by_matrix).collect()
    }

    fn over_tree(trace: &Trace<'_>) -> Option<Self> {
        Self::made(trace, articulated_bodies::residuals(trace)?, |(pushes, constraints)| {
            articulated_bodies::answers(trace, pushes, &constraints)
        })
    }

    fn by_matrix(trace: &Trace<'_>) -> Option<Self> {
        let equations = Equations::of(trace);
        let residual = |(row, bias): (&Vec<Sym>, &Sym)| {
            row.iter().zip(&trace.accelerations).fold(-*bias, |rest, (&entry, &rate)| rest - entry * rate)
        };
        let of_motion = equations.mass.iter().zip(&equations.bias).map(residual).collect();
        Self::made(trace, of_motion, |(pushes, constraints)| {
            let bias = pushes.iter().map(|push| -*push).collect();
            Some(Equations { mass: equations.mass.clone(), bias, constraints }.solved())
        })
    }

    /// Builds the form from residuals without reactions, and a function that solves the linear equations for given right sides.
    fn made(
        trace: &Trace<'_>,
        mut residuals: Vec<Sym>,
        answer: impl FnOnce((&[Sym], Vec<Equation>)) -> Option<Solved>,
    ) -> Option<Self> {
        let constraints = constraints_of(trace);
        for (speed, residual) in residuals.iter_mut().enumerate() {
            *residual = constraints.iter().fold(*residual, |sum, one| sum + one.row[speed] * one.multiplier);
        }
        residuals.extend(constraints.iter().map(|one| {
            one.row.iter().zip(&trace.accelerations).fold(-one.bias, |rest, (&entry, &rate)| rest - entry * rate)
        }));
        let letters: Vec<Sym> = (0..residuals.len()).map(|place| Sym::symbol(&format!("right side {place}"))).collect();
        let (pushes, rates) = letters.split_at(trace.speeds.len());
        let asked = constraints.into_iter().zip(rates).map(|(one, &rate)| Equation { bias: -rate, ..one }).collect();
        let (accelerations, multipliers) = answer((pushes, asked))?.ok()?;
        Some(Residuals { residuals, letters, answers: [accelerations, multipliers].concat() })
    }
}
