//! The projection of a state as one compiled function, with its linear equations eliminated symbolically. A step needs two evaluations:
//! the first gives the displacement of the coordinates, the second the change of the speeds.

use super::residuals::Kept;
use super::{LEFT, MET, ROUNDS, WITHOUT_INERTIA};
use crate::layout::Layout;
use crate::letters::Letters;
use field::Over;
use model::equations::solve_sparse;
use model::{Model, Trace};
use simulation::Program;
use symbolic::{Sym, substitute_all};

/// The largest number of constraints that are eliminated symbolically: the length of the program grows with its third power.
const MOST: usize = 24;

/// The compiled projection of a model whose constraints are independent.
#[derive(Debug)]
pub(super) struct Corrections {
    /// Outputs: residuals of position constraints, then of all rates; the square of the scale of each; the displacement of the
    /// coordinates; the change of the speeds; the residuals of the rates after this change.
    program: Program,
    positions: usize,
    rates: usize,
    speeds: usize,
}

/// The outputs of [`Corrections::program`] at a state, by name.
struct Found<'a> {
    positions: Residuals<'a>,
    rates: Residuals<'a>,
    displacement: &'a [f64],
    change: &'a [f64],
    rates_after: Residuals<'a>,
}

/// Residuals, and the squares of their scales.
struct Residuals<'a> {
    values: &'a [f64],
    squares: &'a [f64],
}

impl Residuals<'_> {
    /// True if every residual is at most `roundings` machine epsilons times its scale; false for NaN.
    fn are_below(&self, roundings: f64) -> bool {
        let least = (roundings * f64::EPSILON).powi(2);
        self.values.iter().zip(self.squares).all(|(value, square)| value * value <= least * square)
    }

    fn sum_of_squares(&self) -> f64 {
        self.values.iter().map(|value| value * value).sum()
    }
}

impl Corrections {
    /// Compiles the projection over `inputs` input numbers. `None` if there are too many constraints, constraints are dependent or not
    /// linear in the speeds, or an expression has no value.
    pub fn over(
        model: &Model,
        inputs: usize,
        letters: impl Fn(Sym, &[Sym]) -> Letters<'_> + Send + Sync,
    ) -> Option<Self> {
        let (speeds, mut counts) = (model.speeds(), None);
        let program = Program::of(inputs, |time, inputs| {
            let trace = Trace::of(model);
            let kept = Kept::of(&trace);
            let Some(all) = written(&trace, &kept) else { return vec![Sym::UNDEFINED] };
            counts = Some((kept.places_of_positions().len(), kept.count()));
            // the metric needs some inertia, not the exact one: every condition is set to its positive case
            let on: Vec<(Sym, Sym)> = trace.switches.iter().map(|&switch| (switch, Sym::ONE)).collect();
            letters(time, inputs).put_into(&trace, &substitute_all(&all, &on))
        })?;
        let (positions, rates) = counts?;
        Some(Corrections { program, positions, rates, speeds })
    }

    /// The number of outputs of the program.
    pub fn values(&self) -> usize {
        2 * (self.positions + self.rates + self.speeds) + self.rates
    }

    fn found<'a>(&self, values: &'a [f64]) -> Found<'a> {
        let count = self.positions + self.rates;
        let (residuals, rest) = values.split_at(count);
        let (squares, rest) = rest.split_at(count);
        let (displacement, rest) = rest.split_at(self.speeds);
        let (change, after) = rest.split_at(self.speeds);
        let part = |from: usize, to: usize| Residuals { values: &residuals[from..to], squares: &squares[from..to] };
        Found {
            positions: part(0, self.positions),
            rates: part(self.positions, count),
            displacement,
            change,
            rates_after: Residuals { values: after, squares: &squares[self.positions..] },
        }
    }

    /// Projects the state `y` in place, and returns whether it was moved. `None` if the iteration does not converge; `y` is then
    /// undefined. `values` is work space for [`Self::values`] numbers.
    pub fn bring(&self, layout: Layout, t: f64, y: &mut [f64], values: &mut [f64]) -> Option<bool> {
        let (mut is_moved, mut last) = (false, f64::INFINITY);
        for _ in 0..=ROUNDS {
            self.program.run(t, y, values)?;
            let found = self.found(values);
            if !is_moved && found.positions.are_below(LEFT) && found.rates.are_below(LEFT) {
                return Some(false);
            }
            if found.positions.are_below(MET) {
                if !found.rates.are_below(MET) {
                    displace(layout, y, 1, found.change);
                    return found.rates_after.are_below(MET).then_some(true);
                }
                return Some(is_moved);
            }
            let size = found.positions.sum_of_squares();
            if size.is_nan() || size >= last {
                return None;
            }
            displace(layout, y, 0, found.displacement);
            (is_moved, last) = (true, size);
        }
        None
    }
}

fn displace(layout: Layout, y: &mut [f64], order: usize, by: &[f64]) {
    by.iter().enumerate().filter(|(_, by)| **by != 0.0).for_each(|(speed, by)| layout.displace(y, (speed, order), *by));
}

/// The outputs of the program as expressions; `None` if there are more than [`MOST`] constraints, or they are dependent or not linear in
/// the speeds.
fn written(trace: &Trace<'_>, kept: &Kept) -> Option<Vec<Sym>> {
    let rows = kept.rows();
    let is_moved = |entry: &Sym| entry.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol));
    // rates that are not linear in the speeds need more than one correction
    if rows.len() > MOST || rows.iter().copied().flatten().any(is_moved) {
        return None;
    }
    let (mobilities, residuals, positions) = (mobilities(trace), kept.residuals(), kept.places_of_positions());
    let product = |one: &[Sym], other: &[Sym]| {
        let products = one.iter().zip(other).filter(|(a, b)| **a != Sym::ZERO && **b != Sym::ZERO);
        products.fold(Sym::ZERO, |sum, (&a, &b)| sum + a * b)
    };
    let moved: Vec<Vec<Sym>> =
        rows.iter().map(|row| row.iter().zip(&mobilities).map(|(&a, &w)| a * w).collect()).collect();
    let matrix: Vec<Vec<Sym>> =
        rows.iter().map(|row| moved.iter().map(|other| product(row, other)).collect()).collect();
    // -W J^T (J W J^T)^-1 r
    let correction = |right: Vec<Sym>| {
        let shares = solve_sparse(&matrix, &right).ok()?;
        let of_speed = |speed: usize| {
            let shares = moved.iter().zip(&shares).filter(|(row, _)| row[speed] != Sym::ZERO);
            -shares.fold(Sym::ZERO, |sum, (row, &share)| sum + row[speed] * share)
        };
        Some((0..mobilities.len()).map(of_speed).collect::<Vec<Sym>>())
    };
    let mut of_positions = vec![Sym::ZERO; rows.len()];
    positions.iter().zip(&residuals).for_each(|(&row, &residual)| of_positions[row] = residual);
    let of_rates = &residuals[positions.len()..];
    let (displacement, change) = (correction(of_positions)?, correction(of_rates.to_vec())?);
    let after: Vec<Sym> = rows.iter().zip(of_rates).map(|(row, &rate)| rate + product(row, &change)).collect();
    Some([residuals.clone(), kept.sizes(trace), displacement, change, after].concat())
}

/// The diagonal of W: inverse diagonal entries of the mass matrix. A speed without inertia has a large entry and takes most of the
/// correction.
fn mobilities(trace: &Trace<'_>) -> Vec<Sym> {
    let energy = trace.kinetic_and_coenergy();
    let inertias = (0..trace.speeds.len()).map(|speed| trace.by_speed(trace.by_speed(energy, speed), speed));
    let own: Vec<Option<Sym>> = inertias.map(|inertia| (inertia != Sym::ZERO).then(|| Sym::ONE / inertia)).collect();
    let sum = own.iter().flatten().fold(Sym::ZERO, |sum, &mobility| sum + mobility);
    let most = if sum == Sym::ZERO { Sym::ONE } else { Sym::lift(WITHOUT_INERTIA) * sum };
    own.into_iter().map(|own| own.unwrap_or(most)).collect()
}
