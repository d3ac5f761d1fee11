//! Proved stability of a splitting for all step sizes of an interval: a motor on its bench, at a steady angle.
//!
//! Every sub-flow has this equilibrium, so that the linearised step is the product M(h) of the sub-flows' matrices for
//! every h. Over an interval of step sizes its entries are Taylor models in h; `grows` decides whether a multiplier
//! leaves the unit circle.

use super::motions::{Rotor, Stationed};
use super::multipliers::{Matrix, grows};
use super::step_intervals::{Found, Limits, Proved};
use super::subflows::{Piece, pieces};
use crate::scene::{Scene, Setup};
use algebra::real::{Ordered, TaylorModel};
use field::Rational;
use integrators::Splitting;

/// The linearised sub-flows of a motor at an equilibrium on its bench.
#[derive(Clone, Debug)]
pub struct Resting {
    pieces: [Piece; 2],
    /// The cosine and the sine of the angle g.
    angle: [TaylorModel; 2],
    /// Whether there is no dissipation: every sub-flow is then Hamiltonian, and multipliers come in pairs z, 1/z.
    symmetric: bool,
}

/// Intervals are bisected down to a relative width of 1e-9.
const LIMITS: Limits = Limits { sign: 1e-9, motion: 1e-9, most: 1_500 };

impl Resting {
    /// The sub-flows of a scene at a steady motion; `None` in a gyrostat, for motors
    /// without known flows, and for torques that are not linear in the slip.
    pub fn of(scene: &Scene, motion: &Stationed) -> Option<Self> {
        let (Setup::Bench { axial }, Rotor::InStep { .. }) = (&scene.system, &motion.rotor) else { return None };
        let (pieces, symmetric) = pieces(&scene.machine, *axial)?;
        Some(Resting { pieces, angle: motion.at.angle.each_ref().map(TaylorModel::enclosed), symmetric })
    }

    /// Decides whether the one-step map is unstable, for all step sizes of an interval, s.
    pub fn course(&self, splitting: Splitting, ends: [f64; 2]) -> Proved {
        let schedule: Vec<(usize, Rational)> =
            splitting.schedule::<f64>(2).into_iter().map(|(piece, share)| (piece, Rational::exactly(share))).collect();
        let look = |[low, high]: [f64; 2]| {
            let step = TaylorModel::over_range(low, high);
            let grows = self.map(&schedule, &step).and_then(|map| grows(&map, &step, self.symmetric));
            grows.map_or(Found::Open, Found::Grows)
        };
        Proved::by(look, ends, LIMITS)
    }

    /// The matrix of a step over a range of step sizes.
    fn map(&self, schedule: &[(usize, Rational)], step: &TaylorModel) -> Option<Matrix> {
        // a symmetric composition contains every flow twice
        let mut flows: Vec<(&(usize, Rational), Matrix)> = Vec::new();
        let mut whole: Option<Matrix> = None;
        for one in schedule {
            if flows.iter().all(|(other, _)| *other != one) {
                let (piece, share) = one;
                let length = step.times(&step.fraction(*share)?);
                flows.push((one, self.pieces[*piece].over(&self.angle, &length)?));
            }
            let (_, flow) = flows.iter().find(|(other, _)| *other == one)?;
            whole = Some(whole.map_or_else(|| flow.clone(), |before| product(flow, &before)));
        }
        whole
    }
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: &[TaylorModel], j: usize| {
        row.iter().zip(b).fold(TaylorModel::constant(0.0), |sum, (entry, other)| sum.plus(&entry.times(&other[j])))
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}
