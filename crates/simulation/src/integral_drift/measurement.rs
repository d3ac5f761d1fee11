//! Measurement of the drift of an integral along a run, from its means over whole windows.

use super::{Integral, MotionWithIntegrals, Window};
use integrators::{Failure, Method, Observer, Span, Tolerance, integrate};
use std::ops::ControlFlow;

/// The relative change of an integral beyond which the run counts as another motion.
const OTHER_MOTION: f64 = 0.1;

/// The number of steps between two readings of the clock.
const A_LOOK: u64 = 1 << 10;

/// A drift counts as proportional to time if longer and shorter runs agree to this fraction.
const IN_PROPORTION: f64 = 0.02;

/// A change of an integral is zero below this fraction of its size and swing.
const NO_CHANGE: f64 = 1e-9;
const OF_SWING: f64 = 0.1;

/// A drift per window, and the number of windows between the two means that determine it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    pub drift: f64,
    pub windows: u32,
}

/// The measured drift of an integral along a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The change per window, in the unit of the integral; `None` where the run leaves the motion within the first
    /// windows.
    pub change: Option<Slope>,
    /// The relative change per window; `None` where the ratio of the means is undefined.
    pub part: Option<Slope>,
    /// The difference of the largest and smallest value within the first window.
    pub swing: f64,
}

/// The value over the largest number of windows that is proportional to time. `sums` are pairs of a number of windows
/// and the total drift.
fn in_proportion(sums: &[(u64, f64)], no_change: f64) -> Option<Slope> {
    let slope = |(windows, sum): &(u64, f64)| Slope { drift: sum / *windows as f64, windows: *windows as u32 };
    let last = sums.last()?;
    if last.1.abs() <= no_change {
        return Some(slope(last));
    }
    let agree = |pair: &&[(u64, f64)]| {
        let [short, long] = [slope(&pair[0]).drift, slope(&pair[1]).drift];
        (short - long).abs() <= IN_PROPORTION * short.abs()
    };
    sums.windows(2).rfind(agree).map(|pair| slope(&pair[1]))
}

/// The mean of each integral over selected windows of a run.
struct Means<'a> {
    integrals: &'a [Integral],
    /// The number of steps in a window.
    steps: u64,
    last: u64,
    done: u64,
    sums: Vec<f64>,
    /// The number of the window, and the means in it.
    means: Vec<(u64, Vec<f64>)>,
    /// The smallest and the largest value in the first window.
    first: Vec<[f64; 2]>,
    sizes: &'a [f64],
    goes_on: &'a dyn Fn() -> ControlFlow<()>,
    ended: bool,
}

impl Means<'_> {
    /// Whether the means of a window are recorded: the windows 0, 1, 2, 4, 9, 19, 49, ... and the last one.
    fn is_watched(&self, window: u64) -> bool {
        let mut count = window + 1;
        while count.is_multiple_of(10) {
            count /= 10;
        }
        window <= 1 || window == self.last || [1, 2, 5].contains(&count)
    }
}

impl Observer<f64> for Means<'_> {
    fn step(&mut self, time: f64, state: &[f64]) {
        let window = self.done / self.steps;
        self.done += 1;
        if self.done.is_multiple_of(A_LOOK) {
            self.ended |= (self.goes_on)().is_break();
        }
        if !self.is_watched(window) {
            return;
        }
        for (place, integral) in self.integrals.iter().enumerate() {
            let value = (integral.value)(time, state);
            self.sums[place] += value;
            if window == 0 {
                let [least, most] = &mut self.first[place];
                (*least, *most) = (least.min(value), most.max(value));
            }
        }
        if self.done.is_multiple_of(self.steps) {
            let means: Vec<f64> = self.sums.iter_mut().map(|sum| std::mem::take(sum) / self.steps as f64).collect();
            if let Some((_, first)) = self.means.first() {
                let has_left = first.iter().zip(&means).zip(self.sizes);
                self.ended |= has_left.clone().all(|((first, mean), size)| (mean - first).abs() > OTHER_MOTION * size);
            }
            match means.iter().all(|mean| mean.is_finite()) {
                true => self.means.push((window, means)),
                false => self.ended = true,
            }
        }
    }

    fn enough(&self) -> bool {
        self.ended
    }
}

/// The change of each integral from the start to the end of a span.
fn over_span(motion: &MotionWithIntegrals<'_>, method: Method, length: f64) -> Result<Vec<Option<Measured>>, Failure> {
    let span = Span::new(0.0, length, motion.start).with_evaluations(u64::MAX);
    let outcome = integrate(motion.law, method, &Tolerance::both(1e-10), &span, &mut ());
    if let Some(failure) = outcome.failure() {
        return Err(failure);
    }
    let of = |integral: &Integral| {
        let drift = (integral.value)(length, &outcome.state) - (integral.value)(0.0, motion.start);
        let change = Some(Slope { drift, windows: 1 }).filter(|slope| slope.drift.is_finite());
        Some(Measured { change, part: None, swing: 0.0 })
    };
    Ok(motion.integrals.iter().map(of).collect())
}

/// Measures each integral along a run of several windows with a method with equal steps, whose number per window is an
/// integer. Changes are relative to `sizes`, one for each integral. `windows` is the number of windows of the
/// run. For a motion without a period the run is its span alone. `None` for an
/// integral for which no two windows agree.
///
/// # Errors
/// [`Failure`] where the run ends before its second window.
pub fn measured(
    motion: &MotionWithIntegrals<'_>,
    method: Method,
    (window, windows): (Window, u32),
    sizes: &[f64],
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vec<Option<Measured>>, Failure> {
    if let Window::Span(length) = window {
        return over_span(motion, method, length);
    }
    let steps = u64::from(method.steps().unwrap_or(1));
    let windows = windows.max(2).min(u32::MAX / steps as u32);
    let count = motion.integrals.len();
    let mut means = Means {
        integrals: motion.integrals,
        steps,
        last: u64::from(windows) - 1,
        done: 0,
        sums: vec![0.0; count],
        means: Vec::new(),
        first: vec![[f64::INFINITY, f64::NEG_INFINITY]; count],
        sizes,
        goes_on,
        ended: false,
    };
    let end = window.length() * f64::from(windows);
    let span = Span::new(0.0, end, motion.start).with_evaluations(u64::MAX);
    let whole = method.refined(windows).unwrap_or(method);
    let outcome = integrate(motion.law, whole, &Tolerance::both(1e-10), &span, &mut means);
    if let (Some(failure), true) = (outcome.failure(), means.means.len() < 2) {
        return Err(failure);
    }
    let of = |place: usize| {
        let ((_, first), rest) = means.means.split_first()?;
        let first = first[place];
        let later: Vec<(u64, f64)> = rest.iter().map(|(at, mean)| (*at, mean[place])).collect();
        let changes: Vec<(u64, f64)> = later.iter().map(|(at, mean)| (*at, mean - first)).collect();
        let powers = later.iter().map(|(at, mean)| (*at, (mean / first).ln()));
        let powers: Vec<(u64, f64)> = powers.take_while(|(_, power)| power.is_finite()).collect();
        let stays = changes.first().is_some_and(|(_, change)| change.abs() <= OTHER_MOTION * sizes[place]);
        // a run that leaves the motion within a few windows has no two values that agree
        let first_change = || changes.first().map(|(_, change)| Slope { drift: *change, windows: 1 });
        let swing = means.first[place][1] - means.first[place][0];
        let change = in_proportion(&changes, (NO_CHANGE * sizes[place]).max(OF_SWING * swing))
            .or_else(first_change)
            .filter(|_| stays);
        let power = in_proportion(&powers, NO_CHANGE)
            .or_else(|| powers.first().map(|(_, power)| Slope { drift: *power, windows: 1 }));
        let part = power.map(|power| Slope { drift: power.drift.exp_m1(), ..power });
        Some(Measured { change, part, swing })
    };
    Ok((0..count).map(of).collect())
}
