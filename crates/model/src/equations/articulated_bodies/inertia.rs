//! Articulated-body inertia (Featherstone 1983): a symmetric matrix that maps the twist (w, v) of a link at its joint to the wrench (torque,
//! force):
//!
//!   torque = A w + B v ,    force = B^T w + C v

use crate::trace::{Trace, Vector};
use crate::{Body, FrameId};
use symbolic::Sym;

pub(super) type Matrix = [[Sym; 3]; 3];

const NONE: Matrix = [[Sym::ZERO; 3]; 3];

/// The blocks A (`turning`), B (`coupling`) and C (`mass`) in the axes of a frame.
#[derive(Clone, Copy)]
pub(super) struct Inertia {
    pub frame: FrameId,
    pub turning: Matrix,
    pub coupling: Matrix,
    pub mass: Matrix,
}

/// A twist (angular velocity, velocity) or a wrench (torque, force) in the axes of a frame.
#[derive(Clone, Copy)]
pub(super) struct Pair(pub [[Sym; 3]; 2]);

impl Pair {
    pub const ZERO: Pair = Pair([[Sym::ZERO; 3]; 2]);

    pub fn dot(&self, other: &Pair) -> Sym {
        let products = self.0.iter().flatten().zip(other.0.iter().flatten()).map(|(a, b)| *a * *b);
        products.fold(Sym::ZERO, |sum, each| sum + each)
    }

    /// Returns `self + factor * other`.
    pub fn and(&self, factor: Sym, other: &Pair) -> Pair {
        Pair(std::array::from_fn(|half| std::array::from_fn(|k| self.0[half][k] + factor * other.0[half][k])))
    }

    pub fn is_zero(&self) -> bool {
        self.0 == [[Sym::ZERO; 3]; 2]
    }
}

impl Inertia {
    pub fn none(frame: FrameId) -> Self {
        Inertia { frame, turning: NONE, coupling: NONE, mass: NONE }
    }

    /// Returns the inertia of a body about a point; `arm` is the vector from this point to the centre of mass.
    pub fn of(trace: &Trace<'_>, body: &Body, frame: FrameId, arm: Vector) -> Self {
        let mut all = Inertia::none(frame);
        if let Some(inertia) = body.inertia.as_ref().filter(|_| body.frame.is_some()) {
            let columns: [[Sym; 3]; 3] = std::array::from_fn(|axis| {
                let unit = Vector::axis(frame, axis);
                trace.express(trace.inertia_times(inertia, unit), frame)
            });
            all.turning = transposed(&columns);
        }
        if let (Some(mass), Some(_)) = (body.mass, body.centre) {
            let mass = trace.solidified(mass);
            let across = cross_matrix(trace.express(arm, frame));
            let scaled = |matrix: &Matrix| matrix.map(|row| row.map(|entry| mass * entry));
            all.mass = multiple_of_one(mass);
            all.coupling = scaled(&across);
            all.turning = difference(&all.turning, &scaled(&product(&across, &across)));
        }
        all
    }

    /// Returns the wrench for a twist.
    pub fn times(&self, Pair([turning, velocity]): &Pair) -> Pair {
        let by = |matrix: &Matrix, vector: &[Sym; 3]| matrix.map(|row| dot(&row, vector));
        let sum = |a: [Sym; 3], b: [Sym; 3]| std::array::from_fn(|k| a[k] + b[k]);
        Pair([
            sum(by(&self.turning, turning), by(&self.coupling, velocity)),
            sum(by(&transposed(&self.coupling), turning), by(&self.mass, velocity)),
        ])
    }

    /// Returns the inertia minus u u^T/d, for a wrench u and `inverse` = 1/d.
    pub fn without(&self, Pair([torque, force]): &Pair, inverse: Sym) -> Self {
        let less = |matrix: &Matrix, a: &[Sym; 3], b: &[Sym; 3]| -> Matrix {
            std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] - a[i] * inverse * b[j]))
        };
        Inertia {
            frame: self.frame,
            turning: symmetric(&less(&self.turning, torque, torque)),
            coupling: less(&self.coupling, torque, force),
            mass: symmetric(&less(&self.mass, force, force)),
        }
    }

    pub fn and(&self, other: &Inertia) -> Self {
        let sum = |a: &Matrix, b: &Matrix| std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] + b[i][j]));
        Inertia {
            frame: self.frame,
            turning: sum(&self.turning, &other.turning),
            coupling: sum(&self.coupling, &other.coupling),
            mass: sum(&self.mass, &other.mass),
        }
    }

    /// Returns the inertia referred to the joint of the parent link; `arm` is the vector from that joint to the joint of this link. Without `is_carried`,
    /// the angular velocity of the link does not contain that of the parent.
    pub fn carried(&self, trace: &Trace<'_>, is_carried: bool, (frame, arm): (FrameId, Vector)) -> Self {
        let turned = |matrix: &Matrix| -> Matrix {
            let rows = matrix.map(|row| trace.express(Vector { frame: self.frame, components: row }, frame));
            transposed(
                &transposed(&rows).map(|row| trace.express(Vector { frame: self.frame, components: row }, frame)),
            )
        };
        let is_of_one_mass = self.mass == multiple_of_one(self.mass[0][0]);
        let mass = if is_of_one_mass { self.mass } else { symmetric(&turned(&self.mass)) };
        let across = cross_matrix(trace.express(arm, frame));
        let by_mass = product(&across, &mass);
        // [r] C [r] is symmetric
        let around = product(&by_mass, &across);
        if !is_carried {
            return Inertia { frame, turning: symmetric(&difference(&NONE, &around)), coupling: by_mass, mass };
        }
        let coupling = turned(&self.coupling);
        let mixed = product(&coupling, &across);
        let turning = difference(&symmetric(&turned(&self.turning)), &around);
        let turning: Matrix =
            std::array::from_fn(|i| std::array::from_fn(|j| turning[i][j] - mixed[i][j] - mixed[j][i]));
        let coupling = std::array::from_fn(|i| std::array::from_fn(|j| coupling[i][j] + by_mass[i][j]));
        Inertia { frame, turning: symmetric(&turning), coupling, mass }
    }
}

fn multiple_of_one(factor: Sym) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { factor } else { Sym::ZERO }))
}

/// Replaces the lower triangle by the upper one, so that both use equal expressions.
fn symmetric(matrix: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[i.min(j)][i.max(j)]))
}

/// Returns the matrix [r] with [r] v = r x v.
fn cross_matrix([x, y, z]: [Sym; 3]) -> Matrix {
    [[Sym::ZERO, -z, y], [z, Sym::ZERO, -x], [-y, x, Sym::ZERO]]
}

fn transposed(matrix: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}

fn dot(a: &[Sym; 3], b: &[Sym; 3]) -> Sym {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    std::array::from_fn(|i| std::array::from_fn(|j| dot(&a[i], &columns[j])))
}

fn difference(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i][j]))
}
