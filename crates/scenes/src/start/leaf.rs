//! The positions that motions can reach under constraints of speeds.
//!
//! The constraints J u = 0 admit paths whose tangents d satisfy J d = 0. If the constraints are integrable, their integrals are constant
//! along every path, such as the distance of a ball from the centre of its bowl, and the reachable positions form a leaf of a foliation.
//! Otherwise paths lead to all positions (Chow 1939).

use super::constraints::Constraints;
use super::{RANK, start_speeds};
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Largest step along a path, in rad or m; the error of the classical Runge-Kutta method is about 1e-12 of the path.
const PART: f64 = 0.004;

/// Largest number of steps along a path.
const MOST_PARTS: f64 = 1_000.0;

/// Paths along which the constraints of speeds hold.
pub(crate) struct Leaf<'m> {
    model: &'m Model,
    constraints: Constraints,
    /// Indices of the enforced constraints of speeds.
    rows: Vec<usize>,
    parameters: Vec<f64>,
}

impl<'m> Leaf<'m> {
    /// The paths of a model; `None` if it has no constraint of speeds.
    pub fn of(model: &'m Model) -> Option<Self> {
        let constraints = Constraints::of(model).ok()??;
        // a constraint that involves coordinates at rest, such as the law of a charge, restricts no displacement
        let is_of_speeds = |row: &usize| {
            let known = &constraints.known[*row];
            known.level == Level::Speed && !known.is_of_places
        };
        let rows: Vec<usize> = (0..constraints.kept).filter(is_of_speeds).collect();
        let values: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let parameters = [values, start_speeds(model)].concat();
        (!rows.is_empty()).then_some(Leaf { model, constraints, rows, parameters })
    }

    /// An orthonormal basis, as columns over the speeds `free`, of the directions that the constraints admit when all other speeds are zero.
    pub fn directions(&self, coordinates: &[f64], free: &[usize]) -> DMatrix<f64> {
        let projector = self.projector(coordinates, free);
        if projector.is_empty() || !projector.iter().all(|entry| entry.is_finite()) {
            return DMatrix::zeros(free.len(), 0);
        }
        let parts = projector.symmetric_eigen();
        // eigenvalues of a projector are 1 and 0
        let left: Vec<usize> = (0..free.len()).filter(|&place| parts.eigenvalues[place] > 0.5).collect();
        parts.eigenvectors.select_columns(&left)
    }

    /// The projector I - J^+ J onto the admissible directions.
    fn projector(&self, coordinates: &[f64], free: &[usize]) -> DMatrix<f64> {
        let layout = self.constraints.layout;
        let state = [coordinates, &vec![0.0; layout.speeds()]].concat();
        let values = self.constraints.values(0.0, &state, &self.parameters);
        let all = self.constraints.rows(&values, self.constraints.known.len());
        let jacobian = DMatrix::from_fn(self.rows.len(), free.len(), |row, place| all[(self.rows[row], free[place])]);
        let identity = DMatrix::identity(free.len(), free.len());
        if free.is_empty() || !jacobian.iter().all(|entry| entry.is_finite()) {
            return identity * f64::NAN;
        }
        let decomposed = jacobian.clone().svd(true, true);
        let least = RANK * decomposed.singular_values.amax();
        match decomposed.solve(&jacobian, least) {
            Ok(along) => identity - along,
            Err(_) => identity * f64::NAN,
        }
    }

    /// The coordinates at the end of a path; its tangent is the projection of `displacement` onto the admissible directions at each position.
    pub fn along(&self, coordinates: &[f64], free: &[usize], displacement: &DVector<f64>) -> Vec<f64> {
        let parts = (displacement.amax() / PART).ceil().clamp(1.0, MOST_PARTS);
        let step = 1.0 / parts;
        let rate = |at: &DVector<f64>| -> DVector<f64> {
            let moving = self.projector(at.as_slice(), free) * displacement;
            let mut state = at.as_slice().to_vec();
            state.resize(at.len() + self.constraints.layout.speeds(), 0.0);
            for (&speed, part) in free.iter().zip(moving.iter()) {
                state[at.len() + speed] = *part;
            }
            let mut rates = vec![0.0; at.len()];
            self.model.position_rates(&state, &mut rates);
            DVector::from_vec(rates)
        };
        let mut at = DVector::from_column_slice(coordinates);
        for _ in 0..parts as usize {
            let first = rate(&at);
            let second = rate(&(&at + &first * (step / 2.0)));
            let third = rate(&(&at + &second * (step / 2.0)));
            let last = rate(&(&at + &third * step));
            at += (first + (second + third) * 2.0 + last) * (step / 6.0);
            for (_, own) in self.constraints.layout.turning() {
                let length = at.rows(own, 4).norm();
                at.rows_mut(own, 4).unscale_mut(length);
            }
        }
        at.as_slice().to_vec()
    }
}
