//! Pieces of the cone of permanent rotations: connected sets of directions with one kind of stability.

use nalgebra::{Matrix3, Vector3};
use std::collections::HashMap;
use studies::stationary::branches::Branch;
use studies::stationary::motions::Case;
use studies::stationary::stability::cone::Fates;
use studies::stationary::stability::reduced::Fate;

/// A connected set of directions with one kind of stability.
pub(super) struct Piece {
    /// The stability; `None` where no real angular velocity belongs to the directions.
    pub fate: Option<Fate>,
    /// Directions v with their angular velocities w, rad/s, sorted by w.
    pub points: Vec<(Vector3<f64>, f64)>,
}

/// Cuts a branch of the cone where the stability changes. The stability at each point is decided exactly; adjacent pieces share a
/// point. A point that is not an isolated motion belongs to a circle of motions, along which the energy is constant.
pub(super) fn pieces(known: &mut Known<'_>, branch: Branch) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (v, w) in branch.points {
        let fate = branch.kind.map(|_| known.fate(v, w));
        match pieces.last_mut() {
            Some(piece) if piece.fate == fate => piece.points.push((v, w)),
            last => {
                let shared = last.and_then(|piece| piece.points.last().copied());
                pieces.push(Piece { fate, points: shared.into_iter().chain([(v, w)]).collect() });
            }
        }
    }
    pieces
}

/// A cache of the verdicts on stability for each angular velocity; directions in it are in the axes of the data.
pub(super) struct Known<'a> {
    pub fates: &'a Fates,
    pub case: &'a Case,
    /// The principal axes as columns.
    pub axes: Matrix3<f64>,
    /// For each angular velocity (its bits), the directions of the motions with their verdicts.
    pub at: HashMap<u64, Vec<(Vector3<f64>, Fate)>>,
}

/// The largest distance between a drawn direction and the direction of the motion whose verdict it takes.
const SAME: f64 = 1e-6;

impl Known<'_> {
    fn fate(&mut self, v: Vector3<f64>, w: f64) -> Fate {
        let all = self.at.entry(w.to_bits()).or_insert_with(|| self.fates.at(self.case, w));
        let off = |known: &Vector3<f64>| (self.axes.transpose() * known - v).norm();
        let nearest = all.iter().min_by(|a, b| off(&a.0).total_cmp(&off(&b.0)));
        nearest.filter(|(known, _)| off(known) < SAME).map_or(Fate::Edge, |(_, fate)| *fate)
    }
}

/// The index of the class of a piece, which determines its colour, and the name of its stability.
pub(super) fn class(piece: &Piece) -> (usize, &'static str) {
    match piece.fate {
        Some(fate) => (Fate::ALL.iter().position(|known| *known == fate).unwrap_or(0), fate.name()),
        None => (Fate::ALL.len(), "no rotation: its square would be negative"),
    }
}
