//! Residuals of the constraints that are projected, and their scales.

use model::Trace;
use model::equations::{Equation, Level, constraints_of};
use symbolic::{Derivation, Sym};

/// The constraints of a model without stabilisation.
pub(super) struct Kept(Vec<Equation>);

impl Kept {
    /// The constraints of a trace that have no gains.
    pub fn of(trace: &Trace<'_>) -> Self {
        Kept(constraints_of(trace).into_iter().filter(|constraint| constraint.gains.is_none()).collect())
    }

    /// The number of these constraints.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The rows of J.
    pub fn rows(&self) -> Vec<&[Sym]> {
        self.0.iter().map(|constraint| &*constraint.row).collect()
    }

    /// True if a position constraint is among them.
    pub fn hold_positions(&self) -> bool {
        !self.places_of_positions().is_empty()
    }

    /// Indices of the position constraints.
    pub fn places_of_positions(&self) -> Vec<usize> {
        (0..self.0.len()).filter(|&place| self.0[place].level == Level::Position).collect()
    }

    fn of_positions(&self) -> impl Iterator<Item = &Equation> {
        self.0.iter().filter(|constraint| constraint.level == Level::Position)
    }

    /// Residuals: f of the position constraints, then df/dt of all constraints.
    pub fn residuals(&self) -> Vec<Sym> {
        let zeros = self.of_positions().map(|constraint| constraint.zero);
        zeros.chain(self.0.iter().map(|constraint| constraint.rate)).collect()
    }

    /// The entries of J that are not identically zero, with their rows and columns.
    pub fn slopes(&self) -> (Vec<(usize, usize)>, Vec<Sym>) {
        let entries = self.0.iter().enumerate().flat_map(|(row, constraint)| {
            constraint.row.iter().enumerate().map(move |(column, slope)| ((row, column), *slope))
        });
        entries.filter(|(_, slope)| *slope != Sym::ZERO).unzip()
    }

    /// The squares of the scales of the residuals.
    pub fn sizes(&self, trace: &Trace<'_>) -> Vec<Sym> {
        let own = trace.model.coordinates.len();
        // the scale of a rotation of a free frame is one radian
        let by_places = |slopes: &[Sym], expression: Sym| {
            let times = |(place, slope): (usize, &Sym)| match place < own {
                true => *slope * trace.coordinates[place],
                false => *slope,
            };
            let by_time = Derivation::new([(trace.time, Sym::ONE)]).of(expression) * trace.time;
            sum_of_squares(slopes.iter().enumerate().map(times).chain([by_time]))
        };
        let of_zeros = self.of_positions().map(|constraint| by_places(&constraint.row, constraint.zero));
        let of_rates = self.0.iter().map(|Equation { rate, row, .. }| {
            let by_coordinates: Vec<Sym> = (0..row.len()).map(|place| trace.by_coordinate(*rate, place)).collect();
            let by_speeds = row.iter().zip(&trace.speeds).map(|(slope, speed)| *slope * *speed);
            sum_of_squares(by_speeds) + by_places(&by_coordinates, *rate)
        });
        of_zeros.chain(of_rates).collect()
    }
}

fn sum_of_squares(parts: impl Iterator<Item = Sym>) -> Sym {
    parts.fold(Sym::ZERO, |sum, part| sum + part * part)
}
