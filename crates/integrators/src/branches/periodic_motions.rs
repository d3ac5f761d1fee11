//! Motions that are periodic up to a shift, by shooting: y(T) = y(0) + shift.
//!
//! With a shift of zero these are periodic orbits; with a whole turn of an angle, rotations. The section fixes the
//! value of one state at time zero; the period T replaces this state among the unknowns. The derivatives come from the
//! state-transition matrix. One of its eigenvalues (Floquet multipliers) is 1, with an eigenvector along the motion.
//! The return map of the section (Poincare map) has exactly the other eigenvalues.

use super::Curve;
use crate::{Failure, Ode, System, Tolerance, transition};

/// The periodic motions of an autonomous law, whose last state is a constant parameter.
pub struct PeriodicMotions<'a> {
    law: &'a dyn System,
    tolerance: Tolerance,
    /// The increase of each state but the parameter over a period.
    shift: Vec<f64>,
    section: usize,
    value: f64,
    start: Vec<f64>,
    rates: Vec<f64>,
    /// The transition matrix of the last evaluation, including the parameter.
    transition: Vec<f64>,
}

impl<'a> PeriodicMotions<'a> {
    /// The equations y(T) - y(0) = shift, one for each state but the parameter. State number `section` has the value `value` at time zero; the period T
    /// replaces it among the unknowns.
    pub fn new(law: &'a dyn System, tolerance: f64, shift: &[f64], (section, value): (usize, f64)) -> Self {
        let count = Ode::<f64>::dimension(law);
        PeriodicMotions {
            law,
            tolerance: Tolerance::both(tolerance),
            shift: shift.to_vec(),
            section,
            value,
            start: vec![0.0; count],
            rates: vec![0.0; count],
            transition: Vec::new(),
        }
    }

    /// The state at time zero, parameter included, and the period T in s, from the unknowns x.
    pub fn motion(&self, x: &[f64]) -> (Vec<f64>, f64) {
        let mut start = x.to_vec();
        let lasts = std::mem::replace(&mut start[self.section], self.value);
        (start, lasts)
    }

    /// The Jacobian of the return map, with respect to all states but that of the section and the parameter: its
    /// dimension m, and its m x m entries in row order.
    ///
    /// # Errors
    /// [`Failure`] where the run over one period fails.
    pub fn returning(&mut self, x: &[f64]) -> Result<(usize, Vec<f64>), Failure> {
        let end = self.run(x)?;
        Ode::<f64>::rates(self.law, 0.0, &end, &mut self.rates);
        let (count, section) = (x.len(), self.section);
        let across: Vec<usize> = (0..count.saturating_sub(1)).filter(|&i| i != section).collect();
        let entry = |i: usize, j: usize| self.transition[i * count + j];
        let pace = |i: usize| self.rates[i] / self.rates[section];
        let returning = |i: usize| across.iter().map(move |&j| entry(i, j) - pace(i) * entry(section, j));
        Ok((across.len(), across.iter().flat_map(|&i| returning(i)).collect()))
    }

    /// The state at time T. Stores the transition matrix.
    fn run(&mut self, x: &[f64]) -> Result<Vec<f64>, Failure> {
        self.start.copy_from_slice(x);
        self.start[self.section] = self.value;
        let found = transition(self.law, &self.tolerance, (0.0, x[self.section]), &self.start)?;
        self.transition = found.matrix;
        Ok(found.state)
    }
}

impl Curve for PeriodicMotions<'_> {
    fn unknowns(&self) -> usize {
        self.start.len()
    }

    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure> {
        let end = self.run(x)?;
        Ode::<f64>::rates(self.law, 0.0, &end, &mut self.rates);
        let count = x.len();
        matrix.copy_from_slice(&self.transition[..matrix.len()]);
        for (i, residual) in residual.iter_mut().enumerate() {
            *residual = end[i] - self.start[i] - self.shift[i];
            matrix[i * count + i] -= 1.0;
            matrix[i * count + self.section] = self.rates[i];
        }
        Ok(())
    }
}
