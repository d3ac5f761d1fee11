//! Rates along a motion, with the magnitude of their terms as a measure of rounding.

use field::Tangent;

/// The rate of a quantity, and the sum of the absolute values of its terms.
#[derive(Clone, Copy, Debug)]
pub struct Rate {
    pub value: f64,
    pub size: f64,
}

/// The rate by the chain rule, coordinate by coordinate.
pub fn rate(quantity: impl Fn(&[Tangent<f64>]) -> Tangent<f64>, y: &[f64], dy: &[f64]) -> Rate {
    let mut moving: Vec<Tangent<f64>> = y.iter().map(|&y| Tangent::fixed(y)).collect();
    let terms: Vec<f64> = (0..y.len())
        .map(|i| {
            moving[i].slope = dy[i];
            let slope = quantity(&moving).slope;
            moving[i].slope = 0.0;
            slope
        })
        .collect();
    Rate { value: terms.iter().sum(), size: terms.iter().map(|term| term.abs()).sum() }
}

impl Rate {
    /// Whether the rate equals a sum of powers, up to rounding of the terms on both sides.
    pub fn is(self, powers: &[f64]) -> bool {
        let size: f64 = self.size + powers.iter().map(|p| p.abs()).sum::<f64>();
        (self.value - powers.iter().sum::<f64>()).abs() <= 1e-12 * (1.0 + size)
    }
}
