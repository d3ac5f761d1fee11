//! Unknowns for the angular velocities of free frames: components along the axes of the frame in which constraints and quasi-velocities have the fewest
//! variable coefficients.
//!
//! For a ball rolling on a plane the coefficients are constant along the axes of the plane, but direction cosines along the ball's own axes. The components
//! along own axes are W = R^T W_X for any frame X, a change of unknowns that is regular everywhere.

use super::ShortForms;
use super::inverse::Reading as _;
use crate::equations::{Dependence, courses};
use crate::{Body, FrameId, Trace, Vector};
use symbolic::Sym;

/// For each free frame, the frame along whose axes its angular velocity is expressed.
pub(super) struct Axes(Vec<FrameId>);

impl Axes {
    /// Chooses the frames from the derivatives of all rows by all speeds.
    pub fn of(trace: &Trace<'_>, slopes: &[Vec<Sym>]) -> Self {
        let model = trace.model;
        let all = (0..model.frames.len()).map(FrameId);
        let chosen = model.free.iter().enumerate().map(|(number, &own)| {
            let first = model.free_speed(number);
            let moving = |axes: FrameId| {
                let along = |row: &Vec<Sym>| expressed(trace, own, &row[first..first + 3], axes);
                let entries: Vec<Sym> = slopes.iter().flat_map(along).collect();
                let found = courses(&entries, &trace.parameters);
                let count = |course: Dependence| found.iter().filter(|own| **own == course).count();
                (count(Dependence::Varying), count(Dependence::Constant), axes != own)
            };
            // excludes axes that rotate with the free frame itself
            let is_above = |frame: &FrameId| *frame == own || !turns_in(trace, *frame, own);
            all.clone().filter(is_above).min_by_key(|axes| moving(*axes)).unwrap_or(own)
        });
        Axes(chosen.collect())
    }

    /// Converts derivatives by speeds to derivatives by the unknowns.
    pub fn of_unknowns(&self, trace: &Trace<'_>, slopes: &[Sym], forms: &mut ShortForms<'_, '_>) -> Vec<Sym> {
        let mut all = slopes.to_vec();
        for (number, (&own, &axes)) in trace.model.free.iter().zip(&self.0).enumerate() {
            let first = trace.model.free_speed(number);
            let along = expressed(trace, own, &slopes[first..first + 3], axes);
            all[first..first + 3].copy_from_slice(&along);
        }
        all.into_iter().map(|each| forms.read(each)).collect()
    }

    /// Returns the angular velocity of a free frame relative to its parent, from values of its unknowns.
    pub fn turning(&self, trace: &Trace<'_>, number: usize, unknowns: &[Sym]) -> Vector {
        let first = trace.model.free_speed(number);
        Vector { frame: self.0[number], components: std::array::from_fn(|k| unknowns[first + k]) }
    }

    /// Replaces the unknowns of every free frame whose body has an inertia other than a ball's by components along its own axes, in which the inertia is constant.
    pub fn with_own_of_bodies(mut self, trace: &Trace<'_>, mut rows: Vec<Vec<Sym>>) -> (Self, Vec<Vec<Sym>>) {
        for (number, &own) in trace.model.free.iter().enumerate() {
            let is_on = |body: &&Body| body.frame == Some(own) && body.inertia.is_some();
            let mut bodies = trace.model.bodies.iter().filter(is_on);
            if bodies.any(|body| body.inertia.as_ref().is_some_and(|inertia| !trace.is_of_ball(inertia))) {
                let others = Axes(
                    self.0
                        .iter()
                        .enumerate()
                        .map(|(at, &axes)| if at == number { axes } else { trace.model.free[at] })
                        .collect(),
                );
                rows = others.of_speeds(trace, rows);
                self.0[number] = own;
            }
        }
        (self, rows)
    }

    /// Converts rows of the unknowns to rows of the speeds.
    pub fn of_speeds(&self, trace: &Trace<'_>, mut rows: Vec<Vec<Sym>>) -> Vec<Vec<Sym>> {
        for (number, (&own, &axes)) in trace.model.free.iter().zip(&self.0).enumerate() {
            let first = trace.model.free_speed(number);
            for place in 0..rows[first].len() {
                let column: Vec<Sym> = rows[first..first + 3].iter().map(|row| row[place]).collect();
                for (row, value) in rows[first..first + 3].iter_mut().zip(expressed(trace, axes, &column, own)) {
                    row[place] = value;
                }
            }
        }
        rows
    }
}

/// Converts components along the axes of one frame to those along the axes of another.
fn expressed(trace: &Trace<'_>, from: FrameId, components: &[Sym], to: FrameId) -> [Sym; 3] {
    trace.express(Vector { frame: from, components: std::array::from_fn(|k| components[k]) }, to)
}

/// Returns whether `other` is a parent frame of `frame`, directly or indirectly.
fn turns_in(trace: &Trace<'_>, frame: FrameId, other: FrameId) -> bool {
    let above = |frame: &FrameId| trace.model.frames[frame.0].parent.map(|(parent, _)| parent);
    std::iter::successors(Some(frame), above).any(|above| above == other)
}
