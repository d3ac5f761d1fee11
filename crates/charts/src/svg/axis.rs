//! Axes: maps from values to pixels, with ticks at powers of ten or at round steps.

use super::number::{significant, superscript};

/// The smallest value on a logarithmic axis, the relative precision of double-double numbers.
pub(crate) const FLOOR: f64 = 1e-32;

/// A tick of an axis; its label is `None` where labels would be too close.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// The value; on a logarithmic axis its logarithm to base ten.
    pub at: f64,
    pub label: Option<String>,
}

/// An affine map from values to pixels. The bounds of a logarithmic axis are stored as logarithms to base ten.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    logarithmic: bool,
    /// The lower bound of the values; `high` is the upper one.
    low: f64,
    high: f64,
    /// The pixel of the lower bound; `to` is that of the upper one.
    from: f64,
    to: f64,
    pub ticks: Vec<Tick>,
}

impl Axis {
    /// A logarithmic axis over these positive values, from the pixel `from` to the pixel `to`, with at least one decade.
    pub fn log(values: impl Iterator<Item = f64>, from: f64, to: f64, spacing: f64) -> Self {
        let (low, high) = bounds(values.map(|value| value.max(FLOOR).log10())).unwrap_or((0.0, 1.0));
        let margin = 0.12 + 0.025 * (high - low);
        let (mut low, mut high) = (low - margin, high + margin);
        if high.floor() - low.ceil() < 1.0 {
            (low, high) = (low.floor(), high.ceil());
        }
        let decades = low.ceil() as i32..=high.floor() as i32;
        let room = ((to - from).abs() / spacing).max(1.0);
        let steps = [1, 2, 4, 5, 10, 20, 50, 100, 400];
        let step =
            steps.into_iter().find(|step| f64::from((decades.end() - decades.start()) / step) <= room).unwrap_or(400);
        let plain = *decades.start() >= -2 && *decades.end() <= 3;
        let label = |decade: i32| match (decade, plain) {
            (0, _) => "1".to_owned(),
            (_, true) => significant(10_f64.powi(decade), 1),
            _ => format!("10{}", superscript(decade)),
        };
        let mut ticks = Vec::new();
        for decade in low.floor() as i32..=high.ceil() as i32 {
            let named = decade.rem_euclid(step) == 0;
            ticks.push(Tick { at: f64::from(decade), label: named.then(|| label(decade)) });
            if step == 1 && room > 2.0 * (high - low) {
                let between = (2..10).map(|i| Tick { at: f64::from(decade) + f64::from(i).log10(), label: None });
                ticks.extend(between);
            }
        }
        ticks.retain(|tick| (low..=high).contains(&tick.at));
        Axis { logarithmic: true, low, high, from, to, ticks }
    }

    /// A linear axis over these values, with ticks at 1, 2 or 5 times a power of ten. `margin` is the empty fraction at each end.
    pub fn linear(values: impl Iterator<Item = f64>, from: f64, to: f64, spacing: f64, margin: f64) -> Self {
        let (low, high) = bounds(values).unwrap_or((0.0, 1.0));
        let flat = (high - low) <= 1e-12 * low.abs().max(high.abs());
        let extra = match flat {
            true if low == 0.0 => 1.0,
            true => 0.1 * low.abs(),
            false => (high - low) * margin,
        };
        let (low, high) = (low - extra, high + extra);
        let step = round_step((high - low) * spacing / (to - from).abs());
        let digits = decimals(step);
        let ticks = ((low / step).ceil() as i64..=(high / step).floor() as i64)
            .map(|k| k as f64 * step)
            .map(|at| Tick { at, label: Some(tick_label(at, step, digits)) })
            .collect();
        Axis { logarithmic: false, low, high, from, to, ticks }
    }

    /// Removes a common power of ten from the labels where each would be too long with its own, and returns this power as text.
    pub fn share_power(&mut self) -> Option<String> {
        let has_power = |tick: &Tick| tick.label.as_deref().is_some_and(|label| label.contains('·'));
        if self.logarithmic || !self.ticks.iter().any(has_power) {
            return None;
        }
        let largest = self.ticks.iter().fold(0.0, |most: f64, tick| most.max(tick.at.abs()));
        let exponent = largest.log10().floor();
        let power = 10_f64.powf(exponent);
        let apart = self.ticks.windows(2).map(|pair| (pair[1].at - pair[0].at) / power).fold(f64::INFINITY, f64::min);
        let digits = decimals(apart * (1.0 + 1e-9));
        if digits > 4 {
            return None;
        }
        for tick in &mut self.ticks {
            tick.label = Some(tick_label(tick.at / power, apart, digits));
        }
        Some(format!("10{}", superscript(exponent as i32)))
    }

    /// The position of a value in pixels.
    pub fn place(&self, value: f64) -> f64 {
        self.place_tick(if self.logarithmic { value.max(FLOOR).log10() } else { value })
    }

    /// The position of a tick in pixels; on a logarithmic axis `at` is the logarithm.
    pub fn place_tick(&self, at: f64) -> f64 {
        self.from + (at - self.low) / (self.high - self.low) * (self.to - self.from)
    }
}

fn bounds(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter(|value| value.is_finite()).fold(None, |bounds, value| match bounds {
        None => Some((value, value)),
        Some((low, high)) => Some((value.min(low), value.max(high))),
    })
}

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|factor| factor * power).find(|step| *step >= least).unwrap_or(10.0 * power)
}

/// The number of decimals that suffices to tell multiples of the step apart.
fn decimals(step: f64) -> usize {
    (-step.log10().floor()).max(0.0) as usize
}

fn tick_label(at: f64, step: f64, digits: usize) -> String {
    let extreme = digits > 5 || at.abs() >= 1e6;
    let text = if extreme {
        // down to the decade of the step
        let decades = at.abs().log10().floor() - step.log10().floor();
        significant(at, 1 + decades.max(0.0) as usize)
    } else {
        format!("{at:.digits$}")
    };
    if text == "-0" { "0".to_owned() } else { text.replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().filter_map(|tick| tick.label.as_deref()).collect()
    }

    #[test]
    fn ticks_of_small_numbers_are_told_apart() {
        let axis = Axis::linear([0.0, -2.3e-12].into_iter(), 0.0, 150.0, 26.0, 0.0);
        assert_eq!(labels(&axis), ["−2·10⁻¹²", "−1.5·10⁻¹²", "−1·10⁻¹²", "−5·10⁻¹³", "0"]);
    }

    #[test]
    fn ticks_of_small_and_large_numbers_share_their_power() {
        let shared = |values: [f64; 2]| {
            let mut axis = Axis::linear(values.into_iter(), 0.0, 150.0, 26.0, 0.0);
            let power = axis.share_power();
            (power, labels(&axis).join(" "))
        };
        assert_eq!(shared([0.0, -2.3e-8]), (Some("10⁻⁸".to_owned()), "−2.0 −1.5 −1.0 −0.5 0.0".to_owned()));
        assert_eq!(shared([1e6, 3e6]), (Some("10⁶".to_owned()), "1.0 1.5 2.0 2.5 3.0".to_owned()));
        assert_eq!(shared([0.0, 5.0]).0, None);
        // a common power of ten is left out where numbers that are almost equal need all their digits
        assert_eq!(shared([1e7, 1e7 + 20.0]).0, None);
    }

    #[test]
    fn log_ticks_are_decades() {
        let axis = Axis::log([3e-4, 2e3].into_iter(), 0.0, 400.0, 40.0);
        assert_eq!(labels(&axis), ["10⁻³", "10⁻²", "10⁻¹", "1", "10¹", "10²", "10³"]);
        assert!((axis.place(1.0) - axis.place(0.1) - axis.place(10.0) + axis.place(1.0)).abs() < 1e-9);
    }

    #[test]
    fn log_axes_reach_down_to_the_last_digit_of_double_double() {
        let axis = Axis::log([1e-32, 1.0].into_iter(), 300.0, 0.0, 30.0);
        assert_eq!(labels(&axis).first(), Some(&"10⁻³²"));
        assert!(labels(&axis).len() <= 11);
        assert_eq!(axis.place(1e-300), axis.place(FLOOR));
    }

    #[test]
    fn a_single_value_has_a_decade_about_it() {
        let axis = Axis::log([5.0].into_iter(), 0.0, 100.0, 40.0);
        assert_eq!(labels(&axis), ["1", "10"]);
        assert!((0.0..=100.0).contains(&axis.place(5.0)));
    }

    #[test]
    fn linear_ticks_are_round() {
        let axis = Axis::linear([-0.31, 0.92].into_iter(), 0.0, 400.0, 60.0, 0.0);
        assert_eq!(labels(&axis), ["−0.2", "0.0", "0.2", "0.4", "0.6", "0.8"]);
    }

    #[test]
    fn no_values_and_equal_values_still_make_an_axis() {
        for values in [vec![], vec![7.0, 7.0], vec![0.0], vec![f64::NAN]] {
            let axis = Axis::linear(values.into_iter(), 0.0, 400.0, 60.0, 0.05);
            assert!(axis.place(7.0).is_finite() && axis.ticks.len() > 1, "{axis:?}");
        }
        assert!(!Axis::log(std::iter::empty(), 0.0, 1.0, 40.0).ticks.is_empty());
    }
}
