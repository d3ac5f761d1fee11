//! Angular velocities of free frames as unknowns: along the axes of the frame in which constraints and quasi-velocities hold the fewest
//! terms that move.
//!
//! A ball that rolls on a plane has constant derivatives along the axes of the plane, and direction cosines along its own. Its own are
//! W = R^T W_X, whatever X is: a change of unknowns that is regular everywhere.

use super::ShortForms;
use super::inverse::Reading as _;
use crate::equations::{Dependence, courses};
use crate::{Body, FrameId, Trace, Vector};
use symbolic::Sym;

/// The frame of the axes, for each free frame.
pub(super) struct Axes(Vec<FrameId>);

impl Axes {
    /// From the derivatives of all rows by all speeds.
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
            // axes that turn with their own frame are no others
            let is_above = |frame: &FrameId| *frame == own || !turns_in(trace, *frame, own);
            all.clone().filter(is_above).min_by_key(|axes| moving(*axes)).unwrap_or(own)
        });
        Axes(chosen.collect())
    }

    /// Slopes by the unknowns.
    pub fn of_unknowns(&self, trace: &Trace<'_>, slopes: &[Sym], forms: &mut ShortForms<'_, '_>) -> Vec<Sym> {
        let mut all = slopes.to_vec();
        for (number, (&own, &axes)) in trace.model.free.iter().zip(&self.0).enumerate() {
            let first = trace.model.free_speed(number);
            let along = expressed(trace, own, &slopes[first..first + 3], axes);
            all[first..first + 3].copy_from_slice(&along);
        }
        all.into_iter().map(|each| forms.read(each)).collect()
    }

    /// The angular velocity of a free frame in its parent, by values of its unknowns.
    pub fn turning(&self, trace: &Trace<'_>, number: usize, unknowns: &[Sym]) -> Vector {
        let first = trace.model.free_speed(number);
        Vector { frame: self.0[number], components: std::array::from_fn(|k| unknowns[first + k]) }
    }

    /// The unknowns with the own axes of every frame in whose body's inertia these stand: a ball's is the same in all.
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

    /// Rows of the speeds by rows of the unknowns.
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

/// Components along the axes of one frame as those along the axes of another.
fn expressed(trace: &Trace<'_>, from: FrameId, components: &[Sym], to: FrameId) -> [Sym; 3] {
    trace.express(Vector { frame: from, components: std::array::from_fn(|k| components[k]) }, to)
}

/// Whether a frame turns in another, at once or by others.
fn turns_in(trace: &Trace<'_>, frame: FrameId, other: FrameId) -> bool {
    let above = |frame: &FrameId| trace.model.frames[frame.0].parent.map(|(parent, _)| parent);
    std::iter::successors(Some(frame), above).any(|above| above == other)
}
