//! The end of a run at which a constraint that followed from others does so no longer: the motion has come to where it branches.

use super::{Constraints, LOOSE, start_speeds};
use derivations::scene::law_end::Margin;
use model::Model;
use model::equations::Level;

const BRANCHES: &str =
    "a constraint that followed from others does so no longer: the motion came to a place where it branches";

/// A constraint that follows from others leaves at most so many times the residual of these.
const TIMES: f64 = 100.0;

/// The constraints that follow from others, beside those that hold.
pub(crate) struct Branching {
    constraints: Constraints,
    /// Rows of those that follow.
    implied: Vec<usize>,
    /// Rows of those that hold.
    held: Vec<usize>,
    parameters: Vec<f64>,
}

impl Branching {
    /// None where no constraint follows from others.
    pub fn of(model: &Model) -> Option<Self> {
        if model.implied.is_empty() {
            return None;
        }
        let mut whole = model.clone();
        whole.implied.clear();
        let constraints = Constraints::of(&whole).ok()??;
        let follows = |row: &usize| constraints.known[*row].of.is_some_and(|of| model.is_implied(of));
        let (implied, held): (Vec<usize>, Vec<usize>) = (0..constraints.kept).partition(follows);
        let values: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let parameters = [values, start_speeds(model)].concat();
        Some(Branching { implied, held, constraints, parameters })
    }

    /// Why the law does not hold at an instant, where some constraint does not follow.
    pub fn broken(&self, time: f64, state: &[f64]) -> Option<&'static str> {
        let values = self.constraints.values(time, state, &self.parameters);
        let count = self.constraints.known.len();
        let size = |row: &usize| values[*row].abs().max(values[count + *row].abs());
        let most = self.held.iter().map(size).fold(0.0, f64::max);
        let is_broken = |row: &usize| size(row) > TIMES * (LOOSE + most);
        self.implied.iter().any(is_broken).then_some(BRANCHES)
    }

    /// Margins of the constraints of positions: many times the residual of the others, less their own; none where the time decides.
    pub fn margins(&self, state: &[f64]) -> Vec<Margin> {
        if self.constraints.knows_time {
            return Vec::new();
        }
        let values = self.constraints.values(0.0, state, &self.parameters);
        let count = self.constraints.known.len();
        // the size of a residual, and its rate
        let sized = |row: &usize| (values[*row].abs(), values[*row].signum() * values[count + *row]);
        let of_positions = |rows: &[usize]| -> Vec<usize> {
            rows.iter().copied().filter(|row| self.constraints.known[*row].level == Level::Position).collect()
        };
        let (implied, held) = (of_positions(&self.implied), of_positions(&self.held));
        let (most, grows) = held.iter().map(sized).max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or((0.0, 0.0));
        let margin = |row: &usize| {
            let (size, rate) = sized(row);
            Margin { value: LOOSE + TIMES * most - size, rate: TIMES * grows - rate, what: BRANCHES }
        };
        implied.iter().map(margin).collect()
    }
}
