//! Points at which conditions of the law are zero: kinks, unless the equations have the same derivatives on all sides.

use super::VariedEquations;
use super::equations::Point;

/// With more conditions that are zero at once their sides are not compared.
const MOST_COMPARED: usize = 6;

impl VariedEquations {
    /// The first switch whose condition is zero at a point where the equations have no derivative: values or derivatives differ between the
    /// sides. In the middle of a play, say, where no spring acts on either side, they do not.
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
