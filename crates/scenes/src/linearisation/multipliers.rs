//! Floquet multipliers of a periodic motion with the period T: eigenvalues of the monodromy matrix M of the independent variations x,
//!
//!   x(T) = M x(0) .
//!
//! The state-transition matrix of the run propagates all variations that satisfy the constraints at the start; M contains their
//! independent components at the end.

use super::recurrence::Recurrence;
use super::{Linearisation, NotLinear, VariedEquations};
use crate::changing_laws::is_watched;
use crate::compiled_system::NotCompiled;
use crate::conservation::keeps_energy;
use crate::scene::ModelScene;
use integrators::{Failure, Tolerance, eigenvalues, transition};

use nalgebra::{DMatrix, DVector};
use simulation::IvpScene;
use std::f64::consts::TAU;
use std::fmt;

/// Tolerances of the two runs that are compared; the second is the finer.
const TOLERANCES: [f64; 2] = [1e-9, 1e-12];

/// The largest distance between end and start of a period, relative to 1 + |component|.
const RETURN: f64 = 1e-6;

/// The largest distance between end and start of a period, relative to the path at the initial rates.
const APART: f64 = 1e-2;

/// A multiplier with a distance from the unit circle below this value plus its error does not decide stability.
const NEAR: f64 = 1e-8;

/// The Floquet multipliers of a periodic motion, computed numerically.
#[derive(Clone, Debug)]
pub struct Multipliers {
    /// The period, s.
    pub period: f64,
    /// The linear equations at the start.
    pub linear: Linearisation,
    /// The monodromy matrix over the states of `linear`.
    pub monodromy: DMatrix<f64>,
    /// Real and imaginary parts of all multipliers, by decreasing absolute value.
    pub values: Vec<[f64; 2]>,
    /// The largest change of a multiplier between the runs with the two tolerances.
    pub error: f64,
    /// The largest distance between end and start of the period, relative to 1 + |component|.
    pub distance: f64,
    /// The multipliers that are exactly one.
    pub ones: Ones,
}

/// Multipliers that are exactly one, by their causes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ones {
    /// The number of cyclic coordinates; each gives a multiplier of one.
    pub cyclic: usize,
    /// True if the law is autonomous and the system moves: a shift in time gives a multiplier of one.
    pub shift: bool,
    /// True if the energy is conserved, which gives one more multiplier of one.
    pub energy: bool,
}

/// Linear stability by the multipliers other than those that are exactly one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orbit {
    /// All these multipliers lie inside the unit circle.
    Asymptotic,
    /// This number of multipliers lies outside the unit circle.
    Unstable(usize),
    /// No multiplier lies outside; this number of them lies on the circle within the numerical error.
    Undecided(usize),
}

/// The reason for which no multipliers are computed.
#[derive(Clone, Debug)]
pub enum NoMultipliers {
    NotCompiled(NotCompiled),
    NotLinear(NotLinear),
    Failure(Failure),
    /// The law changes at conditions, contacts or events.
    Changes,
    /// The model has a free frame, or the problem has states beyond coordinates and speeds.
    States,
    /// The state does not return after the period. `component` is the index of the state component with the largest distance, relative to
    /// 1 + |component|.
    Open {
        component: usize,
        distance: f64,
    },
    /// The equations differ a period later.
    OtherLaw,
    /// The law or the motion changes so little within the period that a return cannot be recognised.
    Short,
}

impl fmt::Display for NoMultipliers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotCompiled(why) => write!(f, "{why}"),
            Self::NotLinear(why) => write!(f, "{why}"),
            Self::Failure(why) => write!(f, "{why}"),
            Self::Changes => write!(f, "the law changes at conditions, contacts or events"),
            Self::States => write!(f, "a frame turns freely"),
            Self::Open { distance, .. } => {
                write!(f, "the motion does not return: it misses its beginning by {distance:.3e}")
            }
            Self::Short => {
                write!(
                    f,
                    "the law, or the motion, hardly changes within this time, so that a return cannot be recognised"
                )
            }
            Self::OtherLaw => {
                write!(f, "the law is another one a period later: it depends on time, or on an angle beyond its turns")
            }
        }
    }
}

impl Multipliers {
    /// The multipliers of the motion from the start of a scene with a period (s).
    ///
    /// # Errors
    /// [`NoMultipliers`] with the reason.
    pub fn of(scene: &ModelScene, period: f64) -> Result<Self, NoMultipliers> {
        let model = &*scene.model;
        if is_watched(model) {
            return Err(NoMultipliers::Changes);
        }
        let equations = VariedEquations::with_inputs(model, &[], &[]).map_err(NoMultipliers::NotCompiled)?;
        let problem = scene.problem(simulation::Axes::default());
        let n = model.speeds();
        if model.positions() != n || problem.state.len() != 2 * n {
            return Err(NoMultipliers::States);
        }
        let about = |time: f64, state: &[f64]| {
            equations.linearised(equations.point(time, state)).map_err(NoMultipliers::NotLinear)
        };
        let linear = about(0.0, &problem.state)?;
        let run = |tolerance: f64| {
            let found = transition(&*problem.law, &Tolerance::both(tolerance), (0.0, period), &problem.state)
                .map_err(NoMultipliers::Failure)?;
            let all = DMatrix::from_row_slice(2 * n, 2 * n, &found.matrix) * &linear.variations;
            let rows = linear.coordinates.iter().copied().chain(linear.speeds.iter().map(|k| n + k));
            let rows: Vec<usize> = rows.collect();
            Ok((found.state, all.select_rows(&rows)))
        };
        let (_, coarse) = run(TOLERANCES[0])?;
        let (end, monodromy) = run(TOLERANCES[1])?;
        let points = equations.around(&linear.point);
        let (begin, idle) = (&problem.state, |k: usize| equations.cyclic(&points, &[k]).ncols() > 0);
        let missed = |k: usize| {
            let gap = end[k] - begin[k];
            let is_angle = k < n && model.coordinates[k].is_angle();
            let gap = if is_angle { gap - (gap / TAU).round() * TAU } else { gap };
            if k < n && idle(k) { 0.0 } else { gap.abs() / (1.0 + begin[k].abs()) }
        };
        let (component, distance) =
            (0..2 * n).map(|k| (k, missed(k))).fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
        if distance > RETURN || end.iter().any(|value| !value.is_finite()) {
            return Err(NoMultipliers::Open { component, distance });
        }
        let recurrence = Recurrence::of(&equations, &linear, &problem.state, (period, scene.run.span));
        match recurrence {
            Recurrence::Returns => {}
            Recurrence::Hidden => return Err(NoMultipliers::Short),
            Recurrence::Differs => return Err(NoMultipliers::OtherLaw),
        }
        let later = about(period, &end)?;
        let size = RETURN * 10.0 * (1.0 + linear.a.amax());
        let is_same = later.coordinates == linear.coordinates
            && later.speeds == linear.speeds
            && (&later.a - &linear.a).amax() <= size
            && (&later.point.accelerations - &linear.point.accelerations).amax() <= size;
        if !is_same {
            return Err(NoMultipliers::OtherLaw);
        }
        let values = by_size(&monodromy);
        let error = farthest(&values, &by_size(&coarse));
        let knows_time = points.iter().any(|at| {
            [&at.motion, &at.zero, &at.rate, &at.acceleration]
                .iter()
                .any(|part| part.by_time.iter().any(|by| *by != 0.0))
        });
        let free: Vec<usize> = linear.coordinates.iter().copied().filter(|&k| idle(k)).collect();
        let rate = rate(&linear);
        let drifts = |row: usize| linear.coordinates.get(row).is_some_and(|k| free.contains(k));
        let fastest = (0..rate.len()).filter(|&row| !drifts(row)).map(|row| rate[row].abs()).fold(0.0, f64::max);
        let moves = fastest > RETURN;
        // a motion that did not leave its start has not returned
        if moves && distance > APART * fastest * period {
            return Err(NoMultipliers::Short);
        }
        let ones = Ones {
            cyclic: free.len(),
            shift: !knows_time && moves,
            energy: !knows_time && moves && keeps_energy(model),
        };
        Ok(Multipliers { period, linear, monodromy, values, error, distance, ones })
    }

    /// The multipliers without those that are exactly one: for each cause the multiplier nearest to one is left out.
    pub fn others(&self) -> Vec<[f64; 2]> {
        let mut rest = self.values.clone();
        let ones = self.ones.cyclic + usize::from(self.ones.shift) + usize::from(self.ones.energy);
        for _ in 0..ones.min(rest.len()) {
            let from_one = |[re, im]: &[f64; 2]| (re - 1.0).hypot(*im);
            let nearest = (0..rest.len()).min_by(|&a, &b| from_one(&rest[a]).total_cmp(&from_one(&rest[b])));
            nearest.map(|nearest| rest.remove(nearest));
        }
        rest
    }

    /// Stability of the motion in the first approximation, by numbers with error estimates.
    pub fn orbit(&self) -> Orbit {
        let margin = NEAR + 10.0 * self.error;
        // rounding splits a multiple eigenvalue by the square root of the error
        let split = (margin + self.distance).sqrt();
        let is_one = |[re, im]: &[f64; 2]| (re - 1.0).hypot(*im) <= split;
        let are_several = self.values.iter().filter(|value| is_one(value)).count() > 1;
        let size = |value: [f64; 2]| if are_several && is_one(&value) { 1.0 } else { value[0].hypot(value[1]) };
        let sizes: Vec<f64> = self.others().into_iter().map(size).collect();
        let outside = sizes.iter().filter(|size| **size > 1.0 + margin).count();
        let inside = sizes.iter().filter(|size| **size < 1.0 - margin).count();
        match (outside, sizes.len() - inside) {
            (0, 0) if !sizes.is_empty() => Orbit::Asymptotic,
            (0, on_circle) => Orbit::Undecided(on_circle),
            (outside, _) => Orbit::Unstable(outside),
        }
    }
}

/// The rates of the states of a linearisation at its point.
fn rate(linear: &Linearisation) -> DVector<f64> {
    let point = &linear.point;
    let speeds = linear.coordinates.iter().map(|&k| point.speeds[k]);
    let rates: Vec<f64> = speeds.chain(linear.speeds.iter().map(|&k| point.accelerations[k])).collect();
    DVector::from_vec(rates)
}

/// The eigenvalues by decreasing absolute value; empty if they are not found.
fn by_size(matrix: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let values = eigenvalues(matrix).unwrap_or_default();
    let mut all: Vec<[f64; 2]> = values.iter().map(|value| [value.re, value.im]).collect();
    let size = |[re, im]: &[f64; 2]| re.hypot(*im);
    all.sort_by(|a, b| size(b).total_cmp(&size(a)).then(b[1].total_cmp(&a[1])));
    all
}

/// The largest distance in a greedy matching of two lists of complex numbers.
fn farthest(some: &[[f64; 2]], others: &[[f64; 2]]) -> f64 {
    let mut left = others.to_vec();
    let mut most = 0.0_f64;
    for [re, im] in some {
        let gap = |other: &[f64; 2]| (re - other[0]).hypot(im - other[1]);
        let Some(nearest) = (0..left.len()).min_by(|&a, &b| gap(&left[a]).total_cmp(&gap(&left[b]))) else { break };
        most = most.max(gap(&left.remove(nearest)));
    }
    most
}
