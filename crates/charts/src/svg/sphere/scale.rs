//! The colour scale along curves: twelve colours from dark to light, which differ in a grey print too.

use super::{
    super::{
        drawing::{Anchor, Drawing, WIDTH},
        number::significant,
    },
    number,
};

pub(crate) const LEVELS: usize = 12;

/// The colour scale: the bounds of the values, and the median of their magnitudes, `usual`. Colours are nearly linear in values below `usual`
/// and logarithmic above, so that a few large values do not take all colours. Outliers do not widen the bounds; they have the last colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    usual: f64,
    /// Whether values lie below the lower bound, and whether values lie above the upper bound.
    beyond: (bool, bool),
}

impl Scale {
    /// The scale for these values; `None` without finite values.
    pub fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (*values.first()?, *values.last()?);
        let mut sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let middle = sizes[sizes.len() / 2];
        let mut scale = Scale { low: first, high: last, usual: middle, beyond: (false, false) };
        if middle == 0.0 {
            scale.usual = first.abs().max(last).max(1.0);
        }
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        let (low, high) = (scale.bent(at(0.04)), scale.bent(at(0.96)));
        let room = 1.5 * (high - low);
        if scale.bent(first) < low - room {
            (scale.low, scale.beyond.0) = (at(0.04), true);
        }
        if scale.bent(last) > high + room {
            (scale.high, scale.beyond.1) = (at(0.96), true);
        }
        Some(scale)
    }

    /// The position of a value on the scale, asinh(value / usual).
    fn bent(&self, value: f64) -> f64 {
        (value / self.usual).asinh()
    }

    /// The value at this fraction of the scale, the inverse of `bent`.
    fn value(&self, share: f64) -> f64 {
        let (low, high) = (self.bent(self.low), self.bent(self.high));
        self.usual * (low + share * (high - low)).sinh()
    }

    /// The index of the colour of a value.
    pub fn level(&self, value: f64) -> usize {
        let (low, high) = (self.bent(self.low), self.bent(self.high));
        let share = if high > low { (self.bent(value) - low) / (high - low) } else { 0.5 };
        ((share * LEVELS as f64) as usize).min(LEVELS - 1)
    }

    pub fn json(&self) -> String {
        format!("[{},{},{}]", number(Some(self.low)), number(Some(self.high)), number(Some(self.usual)))
    }

    /// Draws a bar of the colours with its bounds below the picture.
    pub fn legend(&self, drawing: &mut Drawing, quantity: &str) {
        let (left, step) = (0.5 * WIDTH - 150.0, 300.0 / LEVELS as f64);
        let top = drawing.height;
        for level in 0..LEVELS {
            drawing.rect((left + step * level as f64, top), step + 0.3, 11.0, &format!("v{level} swatch"));
        }
        let sign = |beyond: bool, sign: &str| if beyond { format!("{sign} ") } else { String::new() };
        let short = |value: f64| significant(value, 2);
        let ends = [
            (0.0, sign(self.beyond.0, "≤") + &short(self.low)),
            (0.25, short(self.value(0.25))),
            (0.5, short(self.value(0.5))),
            (0.75, short(self.value(0.75))),
            (1.0, sign(self.beyond.1, "≥") + &short(self.high)),
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
        assert!(scale.high < 100.0 && scale.beyond == (false, true));
        assert_eq!((scale.level(-5.0), scale.level(1e9)), (0, LEVELS - 1));
    }

    #[test]
    fn a_few_large_values_leave_colours_for_the_small_ones() {
        let scale = Scale::of((-30..=30).map(|i| f64::from(i).powi(5))).unwrap();
        assert!(scale.level(1e6) > scale.level(1e3) && scale.level(-1e3) > scale.level(-1e6));
        assert!((scale.value(1.0) - scale.high).abs() < 1e-6 * scale.high);
    }

    #[test]
    fn equal_values_have_a_scale() {
        assert!(Scale::of([2.0, 2.0].into_iter()).unwrap().level(2.0) < LEVELS);
        assert_eq!(Scale::of([f64::NAN].into_iter()), None);
    }
}
