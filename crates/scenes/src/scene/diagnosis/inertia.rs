//! Diagnosis of singular mass matrices: at some position a direction that the constraints allow has no inertia.
//!
//! Let D be the diagonal matrix of the largest sqrt(M_ii) along the run, and Z a basis of the directions that the constraints allow. The smallest
//! eigenvalue of Z^T D^-1 M D^-1 Z is compared with its median along the run, so that the result does not depend on units. If the kinetic
//! energy is that of bodies, M v = 0 means that no body moves in the direction v: the coordinates are singular there (a singular chart).

use super::samples::Samples;
use crate::modes::{Case, Mode};
use crate::motion_matrix::MotionMatrix;
use model::{Model, Trace};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use simulation::{FailureKind, RunFailure};
use symbolic::apart;

/// An eigenvalue below this multiple of its median is zero. For angles this is a distance of 1e-3 rad from a pole.
const SINGULAR: f64 = 1e-6;

/// The multiple for runs that did not stop but needed many steps; their samples come within 1e-2 rad of a pole.
const PASSED: f64 = 1e-4;

/// Largest number of speeds; the cost grows with the cube of the number.
const MOST_SPEEDS: usize = 64;

/// Largest number of samples that are examined.
const MOST_LOOKS: usize = 400;

/// Number of minima along the run that are refined between samples, and number of steps of each search.
const REFINED: usize = 8;
const SEARCHES: usize = 40;

/// Eigenvalues of J^T J below `RANK`^(3/2) times the largest eigenvalue are rounding errors.
const RANK: f64 = 1e-9;

/// A message names the speeds whose components are at least this fraction of the largest component of the direction.
const NAMED: f64 = 0.1;

/// Displacement of a coordinate in SI units, or of the time in spans, that shows whether the singularity depends on it.
const ASIDE: f64 = 0.05;

/// A coordinate below this part of its largest value along the run is shown as zero.
const ZERO: f64 = 1e-6;

/// Least ratio of the eigenvalue after the displacement to that before. With less, the eigenvalue is small but not singular at the place.
const RISE: f64 = 20.0;

/// The remedy for a singular chart.
const OTHER_COORDINATES: &str = "other coordinates: `F = \"N free\"` in [frames] in the place of three angles, or Cartesian coordinates with a \
                     [[constraint]] in the place of polar or spherical ones; or a start whose motion stays away from there";

/// The failure of a run that comes to a position with a singular mass matrix.
pub(super) fn singular(run: &Samples<'_>) -> Option<RunFailure> {
    let model = run.model();
    if model.speeds() > MOST_SPEEDS {
        return None;
    }
    let mode = Mode { cases: vec![Case::On; model.switches.len()], phases: Vec::new() };
    let look = Look::of(model, MotionMatrix::of(model, &mode)?, run)?;
    let sound = run.sound();
    let every = sound.len().div_ceil(MOST_LOOKS).max(1);
    let mut places: Vec<usize> = (0..sound.len()).step_by(every).collect();
    if places.last() != Some(&(sound.len() - 1)) {
        places.push(sound.len() - 1);
    }
    let seen: Vec<(usize, f64)> =
        places.iter().filter_map(|&place| Some((place, look.least(sound[place].0, &sound[place].1)?.0))).collect();
    let mut sorted: Vec<f64> = seen.iter().map(|(_, least)| *least).collect();
    sorted.sort_by(f64::total_cmp);
    let usual = *sorted.get(sorted.len() / 2)?;
    let part = if run.trajectory.stopped().is_some() { SINGULAR } else { PASSED };
    if usual <= 0.0 {
        return None;
    }
    let (time, state, least) = first_below(run, &look, &seen, part * usual)?;
    let (_, direction) = look.least(time, &state)?;
    let names: Vec<String> = named(model, &direction);
    let place = match look.cause(time, &state, run.scene.run.span, least)? {
        Cause::Coordinate(place) => {
            let largest = sound.iter().map(|(_, state)| state[place].abs()).fold(0.0, f64::max);
            let value = if state[place].abs() < ZERO * largest { 0.0 } else { state[place] };
            format!(" at {}", run.told(place, value))
        }
        Cause::Time => String::new(),
    };
    let is_of_bodies = model.energies.kinetic.is_none() && apart(|| has_constant_masses(model));
    let smaller =
        format!("the least eigenvalue of the mass matrix is {:.1e} of its median along the run", least / usual);
    let (together, moves) = if names.len() > 1 { (" together", "move") } else { ("", "moves") };
    let names = names.join(", ");
    let work = run.trajectory.outcome.work;
    let cost = format!("{} steps and {} rejected ones were made in all", work.steps, work.rejected);
    // a fixed step does not shorten near the position
    let step = match run.choice.method.steps() {
        Some(_) => {
            "first a smaller step or a method that adapts its step, since a step that is too large comes there by its error; or "
        }
        None => "",
    };
    Some(match is_of_bodies {
        true => RunFailure {
            kind: FailureKind::SingularChart,
            at: time,
            evidence: format!("{names}{together} {moves} no body{place}: {smaller}; {cost}"),
            remedy: format!("{step}{OTHER_COORDINATES}"),
        },
        false => RunFailure {
            kind: FailureKind::SingularMassMatrix,
            at: time,
            evidence: format!("no inertia resists {names}{together}{place}: {smaller}; {cost}"),
            remedy: "an inertia that stays positive there: add the mass that was left out of `kinetic`; or end the run before, by an \
                     [[event]] with `end = true`"
                .to_owned(),
        },
    })
}

/// Whether all masses and moments of inertia are constant.
fn has_constant_masses(model: &Model) -> bool {
    let trace = Trace::of(model);
    // adds every body to the trace
    trace.kinetic_energy();
    trace.solid().is_empty()
}

/// The first place of the run at which the least eigenvalue is at most `bound`, refined between samples: time (s), state and eigenvalue.
fn first_below(run: &Samples<'_>, look: &Look<'_>, seen: &[(usize, f64)], bound: f64) -> Option<(f64, Vec<f64>, f64)> {
    let is_valley = |at: &usize| {
        let beside = [at.checked_sub(1), Some(at + 1)];
        beside.iter().flatten().filter_map(|&other| seen.get(other)).all(|(_, least)| seen[*at].1 <= *least)
    };
    let mut valleys: Vec<usize> = (0..seen.len()).filter(is_valley).collect();
    valleys.sort_by(|a, b| seen[*a].1.total_cmp(&seen[*b].1));
    valleys.truncate(REFINED);
    valleys.sort_unstable();
    for at in valleys {
        let (own, value) = seen[at];
        let (time, state) = &run.states[own];
        let mut best = (*time, state.clone(), value);
        let from = seen[at.saturating_sub(1)].0;
        let to = seen[(at + 1).min(seen.len() - 1)].0;
        for k in from..to {
            let least = |part: f64| {
                let (time, state) = run.between(k, part);
                look.least(time, &state).map_or(f64::INFINITY, |(least, _)| least)
            };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..SEARCHES {
                let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
                if least(a) < least(b) { high = b } else { low = a }
            }
            let middle = 0.5 * (low + high);
            if least(middle) < best.2 {
                let (time, state) = run.between(k, middle);
                best = (time, state, least(middle));
            }
        }
        if best.2 <= bound {
            return Some(best);
        }
    }
    None
}

/// The names of the speeds with large components in a direction.
fn named(model: &Model, direction: &[f64]) -> Vec<String> {
    let largest = direction.iter().fold(0.0, |size: f64, part| size.max(part.abs()));
    let names = model.state_names();
    let own = direction.iter().zip(&names[model.positions()..]);
    own.filter(|(part, _)| part.abs() >= NAMED * largest).map(|(_, (name, _))| format!("`{name}`")).collect()
}

/// The mass matrix of a model, scaled by `sizes`, the largest sqrt(M_ii) along a run.
struct Look<'a> {
    model: &'a Model,
    matrix: MotionMatrix,
    sizes: DVector<f64>,
}

impl<'a> Look<'a> {
    fn of(model: &'a Model, matrix: MotionMatrix, run: &Samples<'_>) -> Option<Self> {
        let n = model.speeds();
        let mut sizes = DVector::zeros(n);
        let sound = run.sound();
        for (time, state) in sound.iter().step_by(sound.len().div_ceil(MOST_LOOKS).max(1)) {
            let [mass, _] = matrix.at(*time, state)?.blocks(n);
            for i in 0..n {
                let size = mass[(i, i)].abs().sqrt();
                if size.is_finite() && size > sizes[i] {
                    sizes[i] = size;
                }
            }
        }
        sizes.iter_mut().filter(|size| **size == 0.0).for_each(|size| *size = 1.0);
        Some(Look { model, matrix, sizes })
    }

    /// The least absolute eigenvalue of the scaled mass matrix and its direction in scaled speeds; `None` if the constraints allow no motion.
    fn least(&self, time: f64, state: &[f64]) -> Option<(f64, Vec<f64>)> {
        let n = self.model.speeds();
        let [mut mass, mut rows] = self.matrix.at(time, state)?.blocks(n);
        for i in 0..n {
            for j in 0..n {
                mass[(i, j)] /= self.sizes[i] * self.sizes[j];
            }
            rows.column_mut(i).iter_mut().for_each(|part| *part /= self.sizes[i]);
        }
        if !mass.iter().chain(rows.iter()).all(|part| part.is_finite()) {
            return None;
        }
        let left = left_by(&rows)?;
        if left.ncols() == 0 {
            return None;
        }
        let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(left.transpose() * mass * &left);
        let (least, value) = eigenvalues.abs().argmin();
        Some((value, (left * eigenvectors.column(least)).iter().copied().collect()))
    }

    /// The coordinate, or the time, whose change increases the eigenvalue most; `None` if no change increases it by the factor `RISE`.
    fn cause(&self, time: f64, state: &[f64], span: f64, least: f64) -> Option<Cause> {
        let at = |time: f64, state: &[f64]| self.least(time, state).map_or(0.0, |(least, _)| least);
        let moved = |place: usize| {
            let mut moved = state.to_vec();
            moved[place] += ASIDE * moved[place].abs().max(1.0);
            (Cause::Coordinate(place), at(time, &moved))
        };
        let by_time = [-ASIDE, ASIDE].map(|part| (Cause::Time, at(time + part * span, state)));
        let all = by_time.into_iter().chain((0..self.model.positions()).map(moved));
        all.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, risen)| *risen >= RISE * least).map(|(cause, _)| cause)
    }
}

enum Cause {
    Coordinate(usize),
    Time,
}

/// A basis, as columns, of the kernel of `rows`.
fn left_by(rows: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = rows.ncols();
    if rows.nrows() == 0 {
        return Some(DMatrix::identity(n, n));
    }
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(rows.transpose() * rows);
    let largest = eigenvalues.amax();
    let free: Vec<usize> = (0..n).filter(|&i| eigenvalues[i] <= RANK * RANK.sqrt() * largest).collect();
    Some(DMatrix::from_fn(n, free.len(), |i, j| eigenvectors[(i, free[j])]))
}
