//! Derivatives of the equations of motion by coordinates, speeds and inputs, for linearisation,
//! trim and inverse dynamics:
//!
//!   R = M z + h - Q - J^T lambda,    a = df/dt or f,    b = J z + c = da/dt,    z = u'
//!
//! The accelerations z and the multipliers lambda are symbols; the caller substitutes their values at the point.

use crate::Trace;
use crate::equations::Equations;
use symbolic::{Derivation, Sym};

/// Equations and their derivatives, over the symbols of a trace with n speeds. Rows are equations, columns the variables of
/// differentiation.
#[derive(Clone, Debug)]
pub struct Variations {
    /// The symbols of the multipliers lambda, one for each constraint.
    pub multipliers: Vec<Sym>,
    /// The residuals R of the equations of motion, n rows.
    pub motion: Varied,
    /// The constraints f.
    pub zero: Varied,
    /// The constraints a on the level of speeds.
    pub rate: Varied,
    /// The constraints b on the level of accelerations.
    pub acceleration: Varied,
    /// The outputs of a run.
    pub outputs: Varied,
}

/// Expressions with their partial derivatives.
#[derive(Clone, Debug)]
pub struct Varied {
    /// The expressions.
    pub values: Vec<Sym>,
    /// The derivatives by the coordinate of each speed (for a free frame by rotations about its axes): one row per expression.
    pub by_coordinates: Vec<Vec<Sym>>,
    /// The partial derivatives with respect to the speeds.
    pub by_speeds: Vec<Vec<Sym>>,
    /// The partial derivatives by the accelerations.
    pub by_accelerations: Vec<Vec<Sym>>,
    /// The partial derivatives by the multipliers.
    pub by_multipliers: Vec<Vec<Sym>>,
    /// The partial derivatives by the inputs.
    pub by_inputs: Vec<Vec<Sym>>,
    /// The partial derivatives with respect to the time, one for each expression.
    pub by_time: Vec<Sym>,
}

impl Variations {
    /// Differentiates the equations of the first principle that applies; `inputs` are symbols of the model.
    pub fn of(trace: &Trace<'_>, inputs: &[Sym]) -> Self {
        let Equations { mass, bias, constraints } = Equations::of(trace);
        let multipliers: Vec<Sym> = constraints.iter().map(|constraint| constraint.multiplier).collect();
        let accelerations = &trace.accelerations;
        let dot = |a: &[Sym], b: &[Sym]| a.iter().zip(b).fold(Sym::ZERO, |sum, (&a, &b)| sum + a * b);
        let motion = mass.iter().zip(&bias).enumerate().map(|(i, (row, &bias))| {
            let column: Vec<Sym> = constraints.iter().map(|constraint| constraint.row[i]).collect();
            dot(row, accelerations) + bias - dot(&column, &multipliers)
        });
        let motion: Vec<Sym> = motion.collect();
        let zero: Vec<Sym> = constraints.iter().map(|constraint| constraint.zero).collect();
        let rate: Vec<Sym> = constraints.iter().map(|constraint| constraint.rate).collect();
        let acceleration: Vec<Sym> =
            constraints.iter().map(|constraint| dot(&constraint.row, accelerations) + constraint.bias).collect();
        let outputs: Vec<Sym> = trace.model.outputs.iter().map(|output| trace.scalar(output.is)).collect();
        let mut by_multipliers = alone(&multipliers);
        let mut by_inputs = alone(inputs);
        let mut by_time = Derivation::new([(trace.time, Sym::ONE)]);
        let mut varied = |values: Vec<Sym>| {
            let n = trace.speeds.len();
            let matrix = |of: &dyn Fn(Sym, usize) -> Sym| -> Vec<Vec<Sym>> {
                values.iter().map(|&value| (0..n).map(|i| of(value, i)).collect()).collect()
            };
            let by = |derivations: &mut Vec<Derivation>| -> Vec<Vec<Sym>> {
                values.iter().map(|&value| derivations.iter_mut().map(|by| by.of(value)).collect()).collect()
            };
            Varied {
                by_coordinates: matrix(&|value, i| trace.by_coordinate(value, i)),
                by_speeds: matrix(&|value, i| trace.by_speed(value, i)),
                by_accelerations: matrix(&|value, i| trace.by_acceleration(value, i)),
                by_multipliers: by(&mut by_multipliers),
                by_inputs: by(&mut by_inputs),
                by_time: values.iter().map(|&value| by_time.of(value)).collect(),
                values,
            }
        };
        Variations {
            motion: varied(motion),
            zero: varied(zero),
            rate: varied(rate),
            acceleration: varied(acceleration),
            outputs: varied(outputs),
            multipliers,
        }
    }
}

fn alone(letters: &[Sym]) -> Vec<Derivation> {
    letters.iter().map(|&letter| Derivation::new([(letter, Sym::ONE)])).collect()
}
