//! Points of linearisation along a run, and the classification of a point as equilibrium, steady or moving.

use super::{Linearisation, NotLinear, VariedEquations};
use crate::modes::Modes;
use crate::scene::ModelScene;
use integrators::{Failure, Observer, Record, Span, Tolerance};
use std::fmt;
use std::time::{Duration, Instant};

/// A time (s) and the state at this time: coordinates, then speeds.
pub type Instance = (f64, Vec<f64>);

/// The largest tolerance of a run to an instant.
const FINE: f64 = 1e-11;

/// The reason for which a run has no state at a time (s), or no linearisation exists there.
#[derive(Clone, Debug, PartialEq)]
pub enum NoInstance {
    Failure(Failure),
    /// The run ends at `time`, before the requested time.
    Ended {
        time: f64,
        why: String,
    },
    /// The condition with this index stays at zero at this time (sliding mode).
    Held {
        time: f64,
        switch: usize,
    },
}

impl fmt::Display for NoInstance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Failure(failure) => write!(f, "{failure}"),
            Self::Ended { time, why } => write!(f, "it ends at t = {time} s: {why}"),
            Self::Held { time, switch } => {
                write!(f, "at t = {time} s condition {} stays at zero, as in dry friction that sticks", switch + 1)
            }
        }
    }
}

/// The states of a run at `times` (s), across its events. The method is that of the scene; its tolerance is at most 1e-11. `allowed`
/// limits the computing time.
///
/// # Errors
/// [`NoInstance`] if the run does not reach a time, or a condition stays at zero there.
pub fn along(scene: &ModelScene, times: &[f64], allowed: Duration) -> Result<Vec<Instance>, NoInstance> {
    let last = times.iter().copied().fold(0.0, f64::max);
    if last == 0.0 {
        return Ok(times.iter().map(|_| (0.0, scene.start.clone())).collect());
    }
    let mut sorted: Vec<f64> = times.iter().copied().filter(|time| *time > 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let deadline = Instant::now() + allowed;
    let tolerance = Tolerance::both(scene.run.tolerance.min(FINE));
    let (problem, modes) = scene.switched();
    let mut span = Span::new(0.0, last, &scene.start).with_deadline(deadline);
    span.outputs.clone_from(&sorted);
    let mut seen = Seen { record: Record::new(), modes: modes.as_deref(), held: Vec::new() };
    let (outcome, left) = problem.integrate(scene.run.method, &tolerance, &span, &mut seen);
    let ended = |why: String| NoInstance::Ended { time: outcome.time, why };
    match (left, outcome.failure()) {
        (Some(why), _) => return Err(ended(why.to_owned())),
        (None, Some(failure)) => return Err(NoInstance::Failure(failure)),
        (None, None) if outcome.time < last => return Err(ended("an event of the file ends the run".to_owned())),
        (None, None) => {}
    }
    let Seen { record, held, .. } = seen;
    if let Some((place, switch)) = held.iter().enumerate().find_map(|(place, held)| Some((place, (*held)?))) {
        return Err(NoInstance::Held { time: record.times[place], switch });
    }
    let state = |time: f64| {
        let place = record.times.iter().position(|known| *known == time);
        place.map_or_else(|| scene.start.clone(), |place| record.states[place].clone())
    };
    Ok(times.iter().map(|&time| (time, state(time))).collect())
}

/// The recorded states, each with the index of a condition that stays at zero at its time.
struct Seen<'a> {
    record: Record<f64>,
    modes: Option<&'a Modes>,
    held: Vec<Option<usize>>,
}

impl Observer<f64> for Seen<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.record.sample(time, state);
        self.held.push(self.modes.and_then(Modes::held_condition));
    }
}

/// The kind of motion at a point of linearisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// All speeds and accelerations are zero.
    Equilibrium,
    /// All speeds are zero except steady currents.
    SteadyCurrents,
    /// A steady motion: the speeds and the linear equations are constant.
    Steady,
    /// The linear equations change along the motion.
    Moving,
}

/// Accelerations, and changes of the linear equations, below this value times 1 + |A| count as zero.
const STILL: f64 = 1e-9;

impl VariedEquations {
    /// The kind of motion at a point. The linear equations there are compared with those at two later times, after motion with constant
    /// speeds.
    ///
    /// # Errors
    /// [`NotLinear`] if a later point has no linear equations.
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
        let moving: Vec<usize> = (0..point.speeds.len()).filter(|&place| point.speeds[place] != 0.0).collect();
        Ok(match moving.as_slice() {
            [] => Standing::Equilibrium,
            all if all.iter().all(|place| self.charges.contains(place)) => Standing::SteadyCurrents,
            _ => Standing::Steady,
        })
    }
}
