//! Drift and error as functions of the gain, and the gain of the smallest error.
//!
//! With constant gains a method of order p has the error h^p e(t; b, k) + O(h^(p+1)) for h -> 0, where e does not
//! depend on h. The gains of the smallest error therefore tend to a limit, while those of the fastest decay grow as 1/h
//! and 1/h^2. The limit is measured, since no theory here gives it.

use super::goal::{Goal, SPAN};
use super::run::{Keeping, Run};
use crate::stabilisation::schemes::Scheme;

/// Drift and error as functions of the rate w of critically damped gains, b = 2 w, k = w^2, with a constant step size.
#[derive(Clone, Debug)]
pub struct Scan {
    pub scheme: Scheme,
    pub steps: u32,
    /// The measurements at the rates for which the run stays bounded, in ascending order.
    pub points: Vec<Measure>,
    /// The error without gains.
    pub without: f64,
}

/// The drift and error at a rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The rate w, 1/s.
    pub rate: f64,
    /// The largest |f|, m^2.
    pub drift: f64,
    pub error: f64,
}

impl Scan {
    /// Scans from the slowest rate to the stability limit, five rates per decade, finer near the smallest error.
    pub fn of(scheme: Scheme, steps: u32, goal: &Goal) -> Self {
        let h = SPAN / f64::from(steps);
        let measure = |rate: f64| {
            let (beta, kappa) = (2.0 * h * rate, (h * rate).powi(2));
            let found = Run { scheme, steps, way: Keeping::Led(beta, kappa) }.measure(goal).ok()?;
            (found.error < LOST).then_some(Measure { rate, drift: found.drift, error: found.error })
        };
        let between = |low: f64, high: f64, count: u32| {
            (0..=count).map(move |k| low * (high / low).powf(f64::from(k) / f64::from(count)))
        };
        let decades = (FASTEST / h / SLOWEST).log10();
        let count = (decades * A_DECADE).round() as u32;
        let mut points: Vec<Measure> = between(SLOWEST, FASTEST / h, count).filter_map(measure).collect();
        if let Some(best) = least(&points) {
            let neighbour = |place: usize| points.get(place).map_or(best.rate, |point| point.rate);
            let place = points.iter().position(|point| *point == best).unwrap_or(0);
            let (low, high) = (neighbour(place.saturating_sub(1)), neighbour(place + 1));
            points.extend(between(low, high, FINER).filter_map(measure));
            points.sort_by(|a, b| a.rate.total_cmp(&b.rate));
            points.dedup_by(|a, b| a.rate == b.rate);
        }
        let without = Run { scheme, steps, way: Keeping::Led(0.0, 0.0) }.measure(goal);
        Scan { scheme, steps, points, without: without.map_or(f64::INFINITY, |found| found.error) }
    }

    /// The measurement with the smallest error; `None` if no gain is better than the run without gains.
    pub fn best(&self) -> Option<Measure> {
        least(&self.points).filter(|best| best.error < self.without)
    }
}

fn least(points: &[Measure]) -> Option<Measure> {
    points.iter().copied().min_by(|a, b| a.error.total_cmp(&b.error))
}

/// The slowest rate, 1/s: a violation would decay by a tenth during the span.
const SLOWEST: f64 = 0.01;
/// The largest h w: beyond it no explicit method is stable.
const FASTEST: f64 = 10.0;
/// Rates per decade, and rates between the neighbours of the smallest error.
const A_DECADE: f64 = 5.0;
const FINER: u32 = 12;
/// An error above which a run is discarded.
const LOST: f64 = 10.0;
