//! Zero eigenvalues and their reasons: cyclic coordinates, conserved quantities, families of motions, constraints of speeds.
//!
//! The linear equations conserve the differential of every first integral. Each conserved momentum of a cyclic coordinate, and the energy,
//! gives a left null vector, unless its differential vanishes. At an equilibrium with constraints of speeds there are fewer independent speeds
//! than displacements, so that some rates of displacements are dependent: equilibria form a family.

use super::reduction::{Matrix, Reduced, independent};
use crate::linearisation::AllSlopes;
use algebra::real::{Ball, Ordered};
use num_traits::Zero;

/// The reason of a zero eigenvalue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ZeroReason {
    /// The named coordinate is cyclic.
    Cyclic(String),
    /// The momentum of the named cyclic coordinate is conserved.
    Momentum(String),
    /// The energy is conserved, and its differential is independent of those of momenta.
    Energy,
    /// There are steady motions for every value of a speed.
    Family,
    /// Constraints of speeds leave fewer speeds than displacements, and equilibria form a family.
    SpeedConstraints,
}

/// The conserved quantities of a model at a motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    /// Indices and names of coordinates with conserved momenta.
    pub momenta: Vec<(usize, String)>,
    pub energy: bool,
    /// The number of speeds for all values of which there are steady motions; each gives a right null vector of the linear equations.
    pub free: usize,
}

/// The reasons of zero eigenvalues of a reduced matrix, one for each.
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
    // free speeds give right null vectors, conserved quantities left ones: the larger number is that of zeros
    let known: Vec<ZeroReason> = own.chain(side_by_side).collect();
    let more = kept.free.saturating_sub(known.len());
    known.into_iter().chain((0..more).map(|_| ZeroReason::Family)).collect()
}

/// The number of dependent rates of displacements: displacements minus speeds on which the rates depend; zero if the rates depend on displacements.
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
