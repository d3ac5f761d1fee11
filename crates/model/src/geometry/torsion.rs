//! Torsional springs and dashpots between two frames, and the other torques.
//!
//! A term of an energy, of a generalised force or of a torque acts at a hinge if its covector is parallel to the gradient of the hinge's angle.
//! It is a spring if the restoring torque increases linearly with the angle.

use super::Action;
use super::covectors::{Covector, Kind, action_of};
use super::elements::vector_terms;
use super::hinges::Hinge;
use super::samples::{POINTS, value, values};
use crate::{Along, FrameId, Torque, Trace, Vector};
use symbolic::Sym;

/// A torsional spring or dashpot about a common axis of two frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Torsion {
    /// The two frames.
    pub frames: [FrameId; 2],
    /// The common axis: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// A spring ([`Action::Elastic`]) or a dashpot ([`Action::Viscous`]).
    pub action: Action,
}

/// A torque on the second of two frames, with its reaction on the first.
#[derive(Clone, Debug)]
pub struct Couple {
    /// The frame on which the reaction acts, and the frame on which the torque acts.
    pub frames: [FrameId; 2],
    /// The components along the axes of the ground, in N m.
    pub torque: [Sym; 3],
}

/// Returns springs and dashpots among the covectors, and removes these from the list.
pub(super) fn of_covectors(trace: &Trace<'_>, hinges: &[Hinge], sought: &mut Vec<Covector>) -> Vec<Torsion> {
    let mut found = Vec::new();
    sought.retain(|covector| {
        let torsion = torsion(trace, hinges, covector);
        found.extend(torsion);
        torsion.is_none()
    });
    found.dedup();
    found
}

/// Returns the spring or dashpot that a covector represents; `None` for other covectors.
fn torsion(trace: &Trace<'_>, hinges: &[Hinge], Covector { kind, slope, written }: &Covector) -> Option<Torsion> {
    let (Kind::Energy(action) | Kind::Generalised(action)) = *kind else { return None };
    let is_angle = |(speed, part): (usize, &Sym)| *part == Sym::ZERO || is_angle(trace, speed);
    if action == Action::Given || !written.is_empty() || !slope.iter().enumerate().all(is_angle) {
        return None;
    }
    let slope = values(trace, slope)?;
    let fits = |hinge: &&Hinge| {
        let torque = hinge.torque(&slope);
        torque.is_some_and(|torque| action == Action::Viscous || hinge.is_spring(&torque))
    };
    let hinge = hinges.iter().find(fits)?;
    Some(Torsion { frames: hinge.frames, axis: hinge.axis, action })
}

/// Returns whether a speed is the rate of an angle.
pub(super) fn is_angle(trace: &Trace<'_>, speed: usize) -> bool {
    trace.model.coordinates.get(speed).is_some_and(|coordinate| coordinate.unit == "rad")
}

/// Returns the springs and dashpots among the torques, and the remaining torques.
pub(super) fn of_torques(trace: &Trace<'_>, hinges: &[Hinge]) -> (Vec<Torsion>, Vec<Couple>) {
    let (mut found, mut couples) = (Vec::new(), Vec::new());
    for torque in &trace.model.torques {
        let (frames, is) = match torque {
            Torque::On { frame, is } => ([FrameId::GROUND, *frame], *is),
            Torque::Between { frames, is } => (*frames, *is),
        };
        let hinge = hinges.iter().find_map(|hinge| match hinge.frames {
            own if own == frames => Some((hinge, 1.0)),
            [second, first] if [first, second] == frames => Some((hinge, -1.0)),
            _ => None,
        });
        let mut left = Vector::ZERO;
        for term in vector_terms(trace, is) {
            match hinge.and_then(|(hinge, sign)| of_term(trace, hinge, (term, sign))) {
                Some(action) => found.extend(hinge.map(|(hinge, _)| Torsion { frames, axis: hinge.axis, action })),
                None => left = trace.sum(left, term),
            }
        }
        if !left.is_zero() {
            couples.push(Couple { frames, torque: trace.express(left, FrameId::GROUND) });
        }
    }
    found.dedup();
    (found, couples)
}

/// Returns the action of one term of a torque about a hinge; `None` if it is neither a spring nor a dashpot.
fn of_term(trace: &Trace<'_>, hinge: &Hinge, (term, sign): (Vector, f64)) -> Option<Action> {
    let about = trace.dot(term, Vector::axis(hinge.frames[1], hinge.axis));
    match action_of(trace, &term.components)? {
        Action::Viscous => Some(Action::Viscous),
        Action::Elastic => {
            let against = |point: u64| Some(-sign * value(trace, about, point)?);
            let torque = (0..POINTS).map(against).collect::<Option<Vec<f64>>>()?;
            hinge.is_spring(&torque).then_some(Action::Elastic)
        }
        Action::Given | Action::Field => None,
    }
}

/// Returns generalised forces along angles, other than springs and dashpots, as torques about hinges.
pub(super) fn of_generalised(trace: &Trace<'_>, hinges: &[Hinge], sought: &[Covector]) -> Vec<Couple> {
    let along_angles = trace.model.generalised.iter().any(|force| matches!(force.along, Along::Speed(_)));
    let given = sought.iter().filter(|covector| along_angles && matches!(covector.kind, Kind::Generalised(_)));
    let couple = |covector: &Covector| {
        let speed = covector.slope.iter().position(|part| *part != Sym::ZERO)?;
        let alone = |at: &Vec<f64>| at.iter().enumerate().all(|(i, part)| i == speed || *part == 0.0);
        let hinge =
            hinges.iter().find(|hinge| is_angle(trace, speed) && hinge.turned.iter().all(|at| alone(&at.slope)))?;
        let size = -covector.slope[speed];
        let axis = Vector::axis(hinge.frames[1], hinge.axis);
        let sense = hinge.turned.first()?.slope[speed].signum();
        let size = if sense < 0.0 { -size } else { size };
        Some(Couple { frames: hinge.frames, torque: trace.express(axis.map(|part| size * part), FrameId::GROUND) })
    };
    given.filter_map(couple).collect()
}
