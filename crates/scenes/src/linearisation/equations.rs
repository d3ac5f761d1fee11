//! The varied equations of a model as numbers at a point.

use crate::compiled_system::{NotCompiled, has_values_but, plain, values};
use derivations::taped::Program;
use model::equations::{Equation, Level, constraints_of};
use model::{Model, Trace, Variations, Varied};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use symbolic::{Sym, substitute_all};

/// A point of a motion: everything that the equations ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    pub time: f64,
    pub coordinates: DVector<f64>,
    pub speeds: DVector<f64>,
    pub accelerations: DVector<f64>,
    /// Of constraints of positions first, as everywhere here.
    pub multipliers: DVector<f64>,
    /// Values of the parameters that are inputs.
    pub inputs: DVector<f64>,
}

/// A constraint as the model has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Known {
    pub level: Level,
    pub name: String,
    pub at: Range<usize>,
}

/// Values of equations and their derivatives; rows are equations.
#[derive(Clone, Debug)]
pub struct Values {
    pub values: DVector<f64>,
    pub by_coordinates: DMatrix<f64>,
    pub by_speeds: DMatrix<f64>,
    pub by_accelerations: DMatrix<f64>,
    pub by_multipliers: DMatrix<f64>,
    pub by_inputs: DMatrix<f64>,
}

/// Everything at a point.
#[derive(Clone, Debug)]
pub struct At {
    /// M z + h - Q - J^T lambda.
    pub motion: Values,
    pub zero: Values,
    pub rate: Values,
    /// J z + c.
    pub acceleration: Values,
    pub outputs: Values,
}

/// The varied equations of a model, compiled.
#[derive(Debug)]
pub struct VariedEquations {
    program: Program,
    /// Coordinates, constraints, inputs, outputs.
    sizes: [usize; 4],
    pub constraints: Vec<Known>,
    /// Parameters that are inputs, by their places.
    pub inputs: Vec<usize>,
    /// The first input in which the equations of motion are not linear.
    pub nonlinear_input: Option<usize>,
}

impl VariedEquations {
    /// Some parameters are inputs: their values are those of the point, and they may have none in the model.
    ///
    /// # Errors
    /// Why there are no equations with numbers.
    pub fn of(model: &Model, inputs: &[usize]) -> Result<Self, NotCompiled> {
        has_values_but(model, inputs)?;
        plain(model)?;
        let n = model.coordinates.len();
        let known: Vec<Known> = symbolic::apart(|| {
            let trace = Trace::of(model);
            if let Some(body) = trace.tilted().first() {
                return Err(NotCompiled::Tilted { body: (*body).to_owned() });
            }
            let known = |each: Equation| Known { level: each.level, name: each.name, at: each.at };
            Ok(constraints_of(&trace).into_iter().map(known).collect())
        })?;
        // constraints of positions first
        let m = known.len();
        let mut order: Vec<usize> = (0..m).collect();
        order.sort_by_key(|&k| known[k].level != Level::Position);
        let length = 3 * n + m + inputs.len();
        let mut nonlinear_input = None;
        let program = Program::of_any_length(length, |time, state| {
            let trace = Trace::of(model);
            let letters: Vec<Sym> = inputs.iter().map(|&place| trace.parameters[place]).collect();
            let varied = Variations::of(&trace, &letters);
            let holds_input = |slope: &Sym| slope.symbols_of().iter().any(|symbol| letters.contains(symbol));
            nonlinear_input = inputs.iter().enumerate().find_map(|(column, &place)| {
                varied.motion.by_inputs.iter().any(|row| holds_input(&row[column])).then_some(place)
            });
            let everything: Vec<usize> = (0..n).collect();
            let shown: Vec<usize> = (0..model.outputs.len()).collect();
            let mut all = Vec::new();
            flatten(&varied.motion, &everything, &order, &mut all);
            for part in [&varied.zero, &varied.rate, &varied.acceleration] {
                flatten(part, &order, &order, &mut all);
            }
            flatten(&varied.outputs, &shown, &order, &mut all);
            let (motion, rest) = state.split_at(3 * n);
            let (multipliers, given) = rest.split_at(m);
            let mut known = values(&trace, time, &motion[..2 * n]);
            known.retain(|(letter, _)| !letters.contains(letter));
            known.extend(trace.accelerations.iter().copied().zip(motion[2 * n..].iter().copied()));
            known.extend(order.iter().map(|&k| varied.multipliers[k]).zip(multipliers.iter().copied()));
            known.extend(letters.into_iter().zip(given.iter().copied()));
            substitute_all(&all, &known)
        });
        Ok(VariedEquations {
            program: program.ok_or(NotCompiled::TooLong)?,
            sizes: [n, m, inputs.len(), model.outputs.len()],
            constraints: order.iter().map(|&k| known[k].clone()).collect(),
            inputs: inputs.to_vec(),
            nonlinear_input,
        })
    }

    /// The number of constraints of positions, which stand first.
    pub fn positions(&self) -> usize {
        self.constraints.iter().filter(|known| known.level == Level::Position).count()
    }

    /// A point without accelerations and multipliers.
    pub fn point(&self, model: &Model, time: f64, state: &[f64]) -> Point {
        let [n, m, ..] = self.sizes;
        let value = |&place: &usize| model.parameters[place].value.unwrap_or(0.0);
        Point {
            time,
            coordinates: DVector::from_column_slice(&state[..n]),
            speeds: DVector::from_column_slice(&state[n..2 * n]),
            accelerations: DVector::zeros(n),
            multipliers: DVector::zeros(m),
            inputs: DVector::from_iterator(self.inputs.len(), self.inputs.iter().map(value)),
        }
    }

    /// Everything at a point.
    pub fn at(&self, point: &Point) -> At {
        let [n, m, k, shown] = self.sizes;
        let parts = [&point.coordinates, &point.speeds, &point.accelerations, &point.multipliers, &point.inputs];
        let state: Vec<f64> = parts.into_iter().flat_map(|part| part.iter().copied()).collect();
        let width = 1 + 3 * n + m + k;
        let mut numbers = vec![f64::NAN; (n + 3 * m + shown) * width];
        self.program.run(point.time, &state, &mut numbers);
        let mut rest = &numbers[..];
        let mut next = |rows: usize| {
            let (own, behind) = rest.split_at(rows * width);
            rest = behind;
            let block = |first: usize, columns: usize| {
                DMatrix::from_fn(rows, columns, |row, column| own[row * width + first + column])
            };
            Values {
                values: DVector::from_fn(rows, |row, _| own[row * width]),
                by_coordinates: block(1, n),
                by_speeds: block(1 + n, n),
                by_accelerations: block(1 + 2 * n, n),
                by_multipliers: block(1 + 3 * n, m),
                by_inputs: block(1 + 3 * n + m, k),
            }
        };
        At { motion: next(n), zero: next(m), rate: next(m), acceleration: next(m), outputs: next(shown) }
    }
}

/// Row after row: the value, then its derivatives.
fn flatten(varied: &Varied, rows: &[usize], multipliers: &[usize], all: &mut Vec<Sym>) {
    for &row in rows {
        all.push(varied.values[row]);
        all.extend_from_slice(&varied.by_coordinates[row]);
        all.extend_from_slice(&varied.by_speeds[row]);
        all.extend_from_slice(&varied.by_accelerations[row]);
        all.extend(multipliers.iter().map(|&k| varied.by_multipliers[row][k]));
        all.extend_from_slice(&varied.by_inputs[row]);
    }
}
