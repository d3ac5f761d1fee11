//! The end of a run at which a constraint that followed from others does so no longer: the motion has come to where it branches.

use super::{Constraints, LOOSE, start_speeds};
use derivations::scene::law_end::Margin;
use model::Model;
use model::equations::Level;

const BRANCHES: &str =
    "a constraint that followed from others does so no longer: the motion came to a place where it branches";

/// The constraints of positions that follow from others, beside those that hold.
pub(crate) struct Followed {
    constraints: Constraints,
    /// Rows of those that follow, and of those that hold.
    rows: [Vec<usize>; 2],
    parameters: Vec<f64>,
}

impl Followed {
    /// None where no constraint of positions without the time follows from others.
    pub fn of(model: &Model) -> Option<Self> {
        let mut whole = model.clone();
        whole.implied.clear();
        let constraints = Constraints::of(&whole).ok()??;
        let is_position = |row: &usize| constraints.known[*row].level == Level::Position;
        let follows = |row: &usize| constraints.known[*row].of.is_some_and(|of| model.is_implied(of));
        let (implied, held): (Vec<usize>, Vec<usize>) = (0..constraints.kept).filter(is_position).partition(follows);
        if implied.is_empty() || constraints.knows_time {
            return None;
        }
        let values: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
        let parameters = [values, start_speeds(model)].concat();
        Some(Followed { rows: [implied, held], constraints, parameters })
    }

    /// How far each is from what errors of the run leave of the others, a hundred times.
    pub fn margins(&self, state: &[f64]) -> Vec<Margin> {
        let values = self.constraints.values(0.0, state, &self.parameters);
        let count = self.constraints.known.len();
        // the size of a residual, and its rate
        let sized = |row: &usize| (values[*row].abs(), values[*row].signum() * values[count + *row]);
        let [implied, held] = &self.rows;
        let (most, grows) = held.iter().map(sized).max_by(|one, other| one.0.total_cmp(&other.0)).unwrap_or((0.0, 0.0));
        let margin = |row: &usize| {
            let (size, rate) = sized(row);
            Margin { value: LOOSE + 100.0 * most - size, rate: 100.0 * grows - rate, what: BRANCHES }
        };
        implied.iter().map(margin).collect()
    }
}
