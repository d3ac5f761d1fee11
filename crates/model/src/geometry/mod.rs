//! The geometry of a model for drawings: its points, and the elements between two of them.

mod covectors;
mod distances;
mod elements;
mod gears;
mod hinges;
mod places;
mod samples;
mod torsion;

pub use elements::{Action, Element};
pub use gears::{Gear, GearTurn};
pub use places::Place;
pub use torsion::{Couple, Torsion};

use crate::arena::{Part, Scalar, Vector as Form};
use crate::{BodyId, FrameId, PointId, ScalarId, Trace, Vector};
use symbolic::Sym;

/// The points of a model, and the elements between them.
#[derive(Clone, Debug)]
pub struct Geometry {
    /// The points of the model by index, followed by unnamed points where the frame of a displacement changes.
    pub places: Vec<Place>,
    /// Forces along the line between two points.
    pub elements: Vec<Element>,
    /// Pairs of points whose distance is constrained.
    pub rods: Vec<[usize; 2]>,
    /// Torsional springs and dashpots about the axes of frames.
    pub torsions: Vec<Torsion>,
    /// Torques that are neither springs nor dashpots.
    pub couples: Vec<Couple>,
    pub gears: Vec<Gear>,
    /// The other forces, (index of the point, components along the axes of the ground in N).
    pub forces: Vec<(usize, [Sym; 3])>,
    /// Points at which the velocity of a body, or a force on it, is evaluated. They need not be fixed in the body, such as the contact point of a rolling wheel.
    pub touched: Vec<(BodyId, PointId)>,
}

impl Geometry {
    /// Determines the geometry of a traced model.
    pub fn of(trace: &Trace<'_>) -> Self {
        let places = places::places(trace);
        let (mut elements, mut loads) = elements::of_forces(trace);
        let hinges = hinges::hinges(trace);
        let mut sought = covectors::covectors(trace, &loads);
        let mut torsions = torsion::of_covectors(trace, &hinges, &mut sought);
        let (of_torques, mut couples) = torsion::of_torques(trace, &hinges);
        torsions.extend(of_torques.into_iter().filter(|torsion| !torsions.contains(torsion)).collect::<Vec<_>>());
        couples.extend(torsion::of_generalised(trace, &hinges, &sought));
        let gears = gears::gears(trace, &hinges, &sought);
        let (found, rods) = distances::along_distances(trace, &places, (&sought, &mut loads));
        for element in found {
            if !elements.contains(&element) {
                elements.push(element);
            }
        }
        let left = loads.into_iter().filter(|load| !load.terms.is_empty());
        let whole = |terms: &[Vector]| terms.iter().fold(Vector::ZERO, |sum, term| trace.sum(sum, *term));
        let forces = left.map(|load| (load.place, trace.express(whole(&load.terms), FrameId::GROUND))).collect();
        Geometry { places, elements, rods, torsions, couples, gears, forces, touched: touched(trace) }
    }
}

/// Returns the axes x, y, z of a frame, each as components along the axes of the ground.
pub fn frame_axes(trace: &Trace<'_>, frame: FrameId) -> [[Sym; 3]; 3] {
    std::array::from_fn(|axis| trace.express(Vector::axis(frame, axis), FrameId::GROUND))
}

/// Returns the bodies with the points at which velocities and forces refer to them.
fn touched(trace: &Trace<'_>) -> Vec<(BodyId, PointId)> {
    let of_velocities = trace.model.arena.parts.iter().filter_map(|part| match part {
        Part::Vector(Form::Velocity { of, .. }) => Some(*of),
        _ => None,
    });
    let of_forces = trace.model.forces.iter().filter_map(|force| match force {
        crate::Force::On { at, .. } => Some(*at),
        crate::Force::Between { .. } => None,
    });
    let mut found: Vec<(BodyId, PointId)> = Vec::new();
    for material in of_velocities.chain(of_forces) {
        let Some(body) = material.body else { continue };
        if trace.model.bodies[body.0].centre != Some(material.point) && !found.contains(&(body, material.point)) {
            found.push((body, material.point));
        }
    }
    found
}

/// Returns the terms of a sum, each with whether it is subtracted.
fn terms(trace: &Trace<'_>, sum: ScalarId) -> Vec<(ScalarId, bool)> {
    let (mut open, mut found) = (vec![(sum, false)], Vec::new());
    while let Some((id, is_negative)) = open.pop() {
        match trace.model.arena.scalar_at(id) {
            Some(Scalar::Sum(a, b)) => open.extend([(*b, is_negative), (*a, is_negative)]),
            Some(Scalar::Difference(a, b)) => open.extend([(*b, !is_negative), (*a, is_negative)]),
            Some(Scalar::Negation(a)) => open.push((*a, !is_negative)),
            _ => found.push((id, is_negative)),
        }
    }
    found
}

/// Returns pairs of points whose distance occurs literally in a scalar.
fn written_distances(trace: &Trace<'_>, scalar: ScalarId) -> Vec<[usize; 2]> {
    let arena = &trace.model.arena;
    let (mut open, mut found) = (vec![scalar], Vec::new());
    while let Some(id) = open.pop() {
        match arena.scalar_at(id) {
            Some(Scalar::Sum(a, b) | Scalar::Difference(a, b) | Scalar::Product(a, b) | Scalar::Quotient(a, b)) => {
                open.extend([*a, *b])
            }
            Some(Scalar::Negation(a) | Scalar::Power(a, _) | Scalar::Function(_, a) | Scalar::RateOf(a)) => {
                open.push(*a)
            }
            Some(Scalar::Norm(way) | Scalar::Dot(way, _)) => {
                if let Some(Form::Between { from, to }) = arena.vector_at(*way) {
                    found.push([from.0.min(to.0), from.0.max(to.0)]);
                }
            }
            _ => {}
        }
    }
    found
}
