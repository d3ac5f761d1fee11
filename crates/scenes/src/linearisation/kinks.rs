//! Kinks: points at which a condition is zero and the equations have different values or derivatives on its two sides.

use super::VariedEquations;
use super::equations::Point;

/// If more conditions are zero at one point, their sides are not compared, and the point counts as a kink.
const MOST_COMPARED: usize = 6;

impl VariedEquations {
    /// The index of the first condition that is zero at a kink. `None` if the equations are equal on all sides, as in the middle of a
    /// backlash without spring force.
    pub fn kinked_switch(&self, point: &Point) -> Option<usize> {
        let inputs = point.inputs.len();
        let values = self.conditions(point);
        let zeros: Vec<usize> = (0..point.switches.len()).filter(|&switch| values[inputs + switch] == 0.0).collect();
        let first = *zeros.first()?;
        if zeros.len() > MOST_COMPARED {
            return Some(first);
        }
        let here = self.at(point);
        let is_like = |sides: u32| {
            let mut there = point.clone();
            for (bit, &switch) in zeros.iter().enumerate() {
                there.switches[switch] = f64::from(sides >> bit & 1);
            }
            let own = self.conditions(&there);
            let keeps = |switch: usize| {
                zeros.contains(&switch) || (own[inputs + switch] > 0.0) == (point.switches[switch] > 0.0)
            };
            own[..inputs] == values[..inputs] && (0..point.switches.len()).all(keeps) && self.at(&there) == here
        };
        (!(0..1 << zeros.len()).all(is_like)).then_some(first)
    }
}
