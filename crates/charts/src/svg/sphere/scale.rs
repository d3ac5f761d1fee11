//! The scale of colours along curves: twelve steps, dark to light also in grey.

use super::{
    super::drawing::{Anchor, Drawing, WIDTH},
    number, shown,
};

pub(crate) const LEVELS: usize = 12;

/// Bounds of the colours. Outliers do not stretch them: they take the last colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    /// Values lie below or above the bounds.
    beyond: (bool, bool),
}

impl Scale {
    /// The scale for these values, if there are any.
    pub fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (*values.first()?, *values.last()?);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        let (low, high) = (at(0.04), at(0.96));
        let room = 1.5 * (high - low);
        let low = if first < low - room { low } else { first };
        let high = if last > high + room { high } else { last };
        Some(Scale { low, high, beyond: (first < low, last > high) })
    }

    /// Which of the colours a value has.
    pub fn level(&self, value: f64) -> usize {
        let share = if self.high > self.low { (value - self.low) / (self.high - self.low) } else { 0.5 };
        ((share * LEVELS as f64) as usize).min(LEVELS - 1)
    }

    pub fn json(&self) -> String {
        format!("[{},{}]", number(Some(self.low)), number(Some(self.high)))
    }

    /// A bar of the colours with its bounds, below the picture.
    pub fn legend(&self, drawing: &mut Drawing, quantity: &str) {
        let (left, step) = (0.5 * WIDTH - 150.0, 300.0 / LEVELS as f64);
        let top = drawing.height;
        for level in 0..LEVELS {
            drawing.rect((left + step * level as f64, top), step + 0.3, 11.0, &format!("v{level} swatch"));
        }
        let sign = |beyond: bool, sign: &str| if beyond { format!("{sign} ") } else { String::new() };
        let ends = [
            (0.0, sign(self.beyond.0, "≤") + &shown(self.low)),
            (0.5, shown(0.5 * (self.low + self.high))),
            (1.0, sign(self.beyond.1, "≥") + &shown(self.high)),
        ];
        for (share, text) in ends {
            drawing.text((left + 300.0 * share, top + 27.0), Anchor::Middle, "", &text);
        }
        drawing.text((0.5 * WIDTH, top + 47.0), Anchor::Middle, "", quantity);
        drawing.height = top + 58.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outlier_does_not_stretch_the_scale() {
        let scale = Scale::of((0..100).map(f64::from).chain([1e9])).unwrap();
        assert_eq!((scale.low, scale.beyond), (0.0, (false, true)));
        assert!(scale.high < 100.0);
        assert_eq!((scale.level(-5.0), scale.level(1e9)), (0, LEVELS - 1));
    }

    #[test]
    fn equal_values_have_a_scale() {
        assert!(Scale::of([2.0, 2.0].into_iter()).unwrap().level(2.0) < LEVELS);
        assert_eq!(Scale::of([f64::NAN].into_iter()), None);
    }
}
