//! Floquet multipliers of a periodic motion: the eigenvalues of the monodromy matrix M over independent variations x,
//!
//!   x(T) = M x(0) .
//!
//! The state-transition matrix of the run carries all variations that constraints allow; those of the end are told by their independent
//! parts.

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

/// Errors of a step of the two runs that are compared, the finer one last.
const TOLERANCES: [f64; 2] = [1e-9, 1e-12];

/// The largest part of one, and of a component's size, by which a state may miss its beginning.
const RETURN: f64 = 1e-6;

/// The part of the way at the speeds of the beginning by which a motion that returns may miss it.
const APART: f64 = 1e-2;

/// Multipliers nearer to the unit circle than this, beside their error, do not decide.
const NEAR: f64 = 1e-8;

/// The multipliers of a periodic motion, as numbers.
#[derive(Clone, Debug)]
pub struct Multipliers {
    pub period: f64,
    /// About the start.
    pub linear: Linearisation,
    /// Over its states.
    pub monodromy: DMatrix<f64>,
    /// Real and imaginary parts, by falling size; those that are one for a reason are among them.
    pub values: Vec<[f64; 2]>,
    /// The largest change of a multiplier between runs of two tolerances.
    pub error: f64,
    /// The distance from the end of the period to its beginning, each component as a part of its size.
    pub distance: f64,
    /// Reasons for which multipliers are one.
    pub ones: Ones,
}

/// Numbers of multipliers that are one, by their reasons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ones {
    /// Coordinates on which nothing depends.
    pub cyclic: usize,
    /// Whether the law is autonomous, so that a shift in time gives a multiplier of one.
    pub shift: bool,
    /// Whether the energy is conserved.
    pub energy: bool,
}

/// The stability by the multipliers, without those that are one for a reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orbit {
    /// All other multipliers lie inside the unit circle.
    Asymptotic,
    /// Number of multipliers outside the unit circle.
    Unstable(usize),
    /// No multiplier lies outside; this number of them lies on the circle within the numerical error.
    Undecided(usize),
}

/// The reason for which there are no multipliers.
#[derive(Clone, Debug)]
pub enum NoMultipliers {
    NotCompiled(NotCompiled),
    NotLinear(NotLinear),
    Failure(Failure),
    /// The law changes at conditions, contacts or events.
    Changes,
    /// A frame turns freely, or the law has states of its own.
    States,
    /// The state does not return: the component that misses most, by how much, as a part of its size.
    Open {
        component: usize,
        distance: f64,
    },
    /// The equations are others a period later.
    OtherLaw,
    /// Within the period neither the law nor the motion changes enough that its return can be told.
    Short,
}

impl fmt::Display for NoMultipliers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotCompiled(why) => write!(f, "{why:?}"),
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
    /// Multipliers of the motion from the start of a scene, which returns after a period.
    ///
    /// # Errors
    /// The reason for which there are no multipliers.
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
            let is_angle = k < n && model.coordinates[k].dimension == symbolic::Dimension::none();
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
        // a motion that never left its beginning has not returned to it
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

    /// The multipliers without those that are one for a reason: for each reason the one nearest to one is left out.
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

    /// The meaning for the stability of the motion, by numbers.
    pub fn orbit(&self) -> Orbit {
        let margin = NEAR + 10.0 * self.error;
        // an error splits several ones by its root: those that belong to reasons and others
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

/// Rates of the states.
fn rate(linear: &Linearisation) -> DVector<f64> {
    let point = &linear.point;
    let speeds = linear.coordinates.iter().map(|&k| point.speeds[k]);
    let rates: Vec<f64> = speeds.chain(linear.speeds.iter().map(|&k| point.accelerations[k])).collect();
    DVector::from_vec(rates)
}

fn by_size(matrix: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let values = eigenvalues(matrix).unwrap_or_default();
    let mut all: Vec<[f64; 2]> = values.iter().map(|value| [value.re, value.im]).collect();
    let size = |[re, im]: &[f64; 2]| re.hypot(*im);
    all.sort_by(|a, b| size(b).total_cmp(&size(a)).then(b[1].total_cmp(&a[1])));
    all
}

/// The largest distance from one of some numbers to the nearest one of others, of which each serves once.
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
