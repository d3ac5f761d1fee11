//! Replacement of the gains of constraint stabilisation.

use crate::Model;
use crate::arena::{Number, Scalar};
use symbolic::Dimension;

impl Model {
    /// Returns the model with all constraints stabilised critically damped at the rate w in 1/s (Baumgarte): f'' + 2 w f' + w^2 f = 0 for
    /// constraints of positions, f' + 2 w f = 0 for constraints of speeds. With `None` the constraints are f'' = 0 and f' = 0.
    #[must_use]
    pub fn led_at(&self, rate: Option<f64>) -> Model {
        let mut led = self.clone();
        let mut written = |value: f64| {
            led.arena.scalar(Scalar::Number(Number { value, times: 1.0, per: 1.0 }), Some(Dimension::none()))
        };
        let gains = rate.map(|rate| vec![written(2.0 * rate), written(rate * rate)]);
        led.constraints.iter_mut().for_each(|constraint| constraint.gains.clone_from(&gains));
        led
    }
}
