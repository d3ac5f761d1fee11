//! Zero eigenvalues and their reasons: cyclic coordinates, conserved quantities, families, constraints of speeds.
//!
//! The linear equations conserve the differential of every first integral: each conserved momentum of a cyclic coordinate, and the energy,
//! gives a left null vector where its differential does not vanish. At an equilibrium with constraints of speeds the rates of displacements
//! depend on fewer speeds than there are displacements: equilibria form a family.

use super::reduction::{Matrix, Reduced, independent};
use crate::linearisation::AllSlopes;
use algebra::real::{Ball, Ordered};
use num_traits::Zero;

/// The reason of a zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ZeroReason {
    /// Nothing depends on this coordinate.
    Cyclic(String),
    /// The momentum of this cyclic coordinate is kept.
    Momentum(String),
    /// The energy is kept, where momenta do not say so already.
    Energy,
    /// There are steady motions at every other value of a speed too.
    Family,
    /// Constraints of speeds leave fewer speeds than displacements: positions of rest stand side by side.
    SpeedConstraints,
}

/// The conserved quantities of a model.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    /// Coordinates whose momenta are kept, with their names.
    pub momenta: Vec<(usize, String)>,
    pub energy: bool,
    /// The number of speeds for every value of which there are steady motions: each gives a null vector of the linear equations.
    pub free: usize,
}

/// Reasons of zeros of a reduced matrix, each of one zero.
pub(super) fn reasons(at: &AllSlopes<Ball>, speeds: &[Ball], reduced: &Reduced<Ball>, kept: &Kept) -> Vec<ZeroReason> {
    let mass = &at.motion.by_accelerations;
    let product = |row: &[Ball], column: usize| {
        row.iter().zip(&reduced.by_speeds).fold(Ball::zero(), |sum, (a, b)| sum + *a * b[column])
    };
    let wide = reduced.matrix.len() - reduced.displacements;
    let differential = |row: &[Ball]| -> Vec<Ball> { (0..wide).map(|column| product(row, column)).collect() };
    let mut rows: Matrix<Ball> = kept.momenta.iter().map(|(place, _)| differential(&mass[*place])).collect();
    if kept.energy {
        let impulse: Vec<Ball> = (0..speeds.len())
            .map(|k| speeds.iter().zip(mass).fold(Ball::zero(), |sum, (speed, row)| sum + *speed * row[k]))
            .collect();
        rows.push(differential(&impulse));
    }
    let named = |number: usize| match kept.momenta.get(number) {
        Some((_, name)) => ZeroReason::Momentum(name.clone()),
        None => ZeroReason::Energy,
    };
    let own = independent(&rows).into_iter().map(named);
    let side_by_side = (0..beyond_speeds(reduced)).map(|_| ZeroReason::SpeedConstraints);
    // as many right null vectors as free speeds, as many left ones as quantities are kept: the larger number of both
    let known: Vec<ZeroReason> = own.chain(side_by_side).collect();
    let more = kept.free.saturating_sub(known.len());
    known.into_iter().chain((0..more).map(|_| ZeroReason::Family)).collect()
}

/// Rows of displacements that are zero but for fewer columns.
fn beyond_speeds(reduced: &Reduced<Ball>) -> usize {
    let first = reduced.displacements;
    let is_zero = |value: &Ball| value.sign() == Some(0);
    let rows = &reduced.matrix[..first];
    if !rows.iter().all(|row| row[..first].iter().all(is_zero)) {
        return 0;
    }
    let columns = (first..reduced.matrix.len()).filter(|&column| !rows.iter().all(|row| is_zero(&row[column])));
    first.saturating_sub(columns.count())
}
