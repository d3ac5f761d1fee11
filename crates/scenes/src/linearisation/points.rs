//! Instants of a run as points about which a model is linearised, and how a point moves.

use super::{Linearisation, NotLinear, VariedEquations};
use crate::scene::ModelScene;
use integrators::{Failure, Record, Span, Tolerance, integrate};
use std::time::{Duration, Instant};

/// A time and the state then: coordinates, then speeds.
pub type Instance = (f64, Vec<f64>);

/// The largest error of a step of the run that leads to an instant.
const FINE: f64 = 1e-11;

/// States of the run at times, by its own method, whose tolerance is made finer where it is coarse.
///
/// # Errors
/// Why the run does not get there.
pub fn along(scene: &ModelScene, times: &[f64], allowed: Duration) -> Result<Vec<Instance>, Failure> {
    let last = times.iter().copied().fold(0.0, f64::max);
    if last == 0.0 {
        return Ok(times.iter().map(|_| (0.0, scene.start.clone())).collect());
    }
    let mut sorted: Vec<f64> = times.iter().copied().filter(|time| *time > 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let mut span = Span::new(0.0, last, &scene.start).with_deadline(Instant::now() + allowed);
    span.outputs = sorted;
    let mut seen = Record::new();
    let tolerance = Tolerance::both(scene.run.tolerance.min(FINE));
    let outcome = integrate(&*scene.system.law(), scene.run.method, &tolerance, &span, &mut seen);
    if let Some(failure) = outcome.failure() {
        return Err(failure);
    }
    let state = |time: f64| {
        let place = seen.times.iter().position(|known| *known == time);
        place.map_or_else(|| scene.start.clone(), |place| seen.states[place].clone())
    };
    Ok(times.iter().map(|&time| (time, state(time))).collect())
}

/// Motion of the point of a linearisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Nothing moves, nothing accelerates.
    Equilibrium,
    /// Speeds stay as they are, and so do the linear equations.
    Steady,
    /// It moves, and the linear equations with it.
    Moving,
}

/// Accelerations below this part of what the linear equations make of variations of size one are taken for zero.
const STILL: f64 = 1e-9;

impl VariedEquations {
    /// The standing of a point: whether linear equations further along its straight way, at two times, are the same.
    ///
    /// # Errors
    /// Where there are none there.
    pub fn standing(&self, about: &Linearisation) -> Result<Standing, NotLinear> {
        let point = &about.point;
        let size = 1.0 + about.a.amax();
        if point.accelerations.amax() > STILL * size {
            return Ok(Standing::Moving);
        }
        for later in [0.37, 1.9] {
            let there = self.linearised(self.straight_on(point, later))?;
            let same = |one: &nalgebra::DMatrix<f64>, other: &nalgebra::DMatrix<f64>| {
                one.shape() == other.shape() && (one - other).iter().all(|gap| gap.abs() <= STILL * size)
            };
            let rests = there.point.accelerations.amax() <= STILL * size;
            if !rests || !same(&about.a, &there.a) || !same(&about.b, &there.b) {
                return Ok(Standing::Moving);
            }
        }
        Ok(if point.speeds.iter().all(|speed| *speed == 0.0) { Standing::Equilibrium } else { Standing::Steady })
    }
}
