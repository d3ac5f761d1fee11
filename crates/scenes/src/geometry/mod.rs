//! The geometry of a system for drawings: relations between its points that hold in all states, and their positions at a time.
//!
//! The relations are found numerically: points with constant coordinates in a frame at several distant states are fixed in this frame. A
//! link is found in this way even if its rotation is described by a massless frame, or by sines and cosines.

mod contact_places;
mod figure;
mod gears;
mod hinges;
mod inertia;
mod rigid;
mod wheels;

pub use figure::{Figure, Touch};
pub use gears::{GearPair, GearWheel};
pub use hinges::{Joint, Rotary, Spot};
pub use inertia::Ellipsoid;
pub use rigid::Link;

use crate::compiled_system::NotCompiled;
use crate::modes::mode_values_at_start;
use figure::Recorded;
use model::Model;
use model::geometry::Element;
use nalgebra::Vector3;
use rigid::Structure;
use std::sync::Arc;

/// The structure of a system, and the compiled positions of its points. Points, frames and bodies are given by their indices.
#[derive(Debug)]
pub struct Geometry {
    /// The model of the system.
    pub model: Arc<Model>,
    /// Names of the points; empty for points without a name.
    pub names: Vec<String>,
    /// For each point, the first point that coincides with it at all times.
    pub first: Vec<usize>,
    /// Points that are fixed in the ground.
    pub ground: Vec<usize>,
    /// Groups of points that are fixed relative to each other.
    pub links: Vec<Link>,
    /// Points that move on a line fixed in the ground, with the unit vector of the line.
    pub slides: Vec<(usize, Vector3<f64>)>,
    /// Pairs of points whose connecting vector has a constant direction in a moving frame, and a variable length.
    pub telescopes: Vec<[usize; 2]>,
    /// Springs and dashpots between two points.
    pub elements: Vec<Element>,
    /// Pairs of points at a constant distance.
    pub rods: Vec<[usize; 2]>,
    /// Bodies that roll, and round bodies that slide without turning.
    pub wheels: Vec<Wheel>,
    /// Torsion springs and rotary dashpots.
    pub rotaries: Vec<Rotary>,
    /// The joint of each torque of [`Figure::torques`].
    pub couples: Vec<Joint>,
    /// Gears and belts with known centres.
    pub gears: Vec<GearPair>,
    /// Sentences on gears whose centres are unknown.
    pub told_gears: Vec<String>,
    /// For each contact of [`Figure::touches`]: true if its surface is a plane, false for a curve.
    pub planes: Vec<bool>,
    /// True if a force or a torque depends on a condition, such as dry friction.
    pub has_switched_loads: bool,
    /// The unit normal of the plane in which all points move; `None` for a motion in space.
    pub plane: Option<Vector3<f64>>,
    /// The size of the system, m: the diagonal of the largest box around its points.
    pub size: f64,
    /// For each frame, the first frame that does not rotate relative to it.
    turning: Vec<usize>,
    /// The position of each point at the start, m.
    at_start: Vec<Vector3<f64>>,
    recorded: Recorded,
}

/// A body that rolls, or a round body that slides without turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// The index of the body.
    pub body: usize,
    /// The index of its contact point.
    pub point: usize,
    /// Radius, m.
    pub radius: f64,
    /// The index of the axis of rotation in its frame; `None` for a ball, and for a body that does not turn.
    pub axis: Option<usize>,
    /// True if the body can rotate.
    pub turns: bool,
}

impl Geometry {
    /// The geometry of a model, found from samples around a state. Parameters and inputs must have values.
    ///
    /// # Errors
    /// A parameter, an input or an expression has no value.
    pub fn of(model: &Arc<Model>, state: &[f64]) -> Result<Self, NotCompiled> {
        let (recorded, symbolic) = Recorded::of(model)?;
        let samples = recorded.samples(state);
        let structure = Structure::of(model, &samples, &symbolic);
        let mut wheels = wheels::wheels(model, &samples, &symbolic, &structure);
        wheels.extend(contact_places::rounds(model, (&samples, &wheels), &symbolic, &structure));
        let planes = contact_places::planes(model, &samples, &symbolic, &structure);
        let passes = |ends: &[usize; 2]| contact_places::is_passing(model, &symbolic, &structure, ends);
        let first = |place: usize| structure.first[place];
        let once = |pairs: &[[usize; 2]]| {
            let mut found: Vec<[usize; 2]> = pairs.iter().map(|ends| ends.map(first)).collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        let mut elements: Vec<Element> = symbolic
            .elements
            .iter()
            .map(|element| Element { ends: element.ends.map(first), ..*element })
            .filter(|element| element.ends[0] != element.ends[1])
            .collect();
        elements.sort_by_key(|element| (element.ends, element.action));
        elements.dedup();
        let is_joined = |ends: &[usize; 2]| {
            elements.iter().any(|element| element.ends == *ends || element.ends == [ends[1], ends[0]])
        };
        let telescopes: Vec<[usize; 2]> =
            once(&structure.telescopes).into_iter().filter(|ends| !is_joined(ends) && !passes(ends)).collect();
        let is_radius = |ends: &[usize; 2]| {
            let centre = |wheel: &Wheel| model.bodies[wheel.body].centre.map(|centre| first(centre.0));
            let of_wheel = |wheel: &Wheel| centre(wheel).is_some_and(|centre| ends.contains(&centre));
            wheels.iter().any(|wheel| ends.contains(&first(wheel.point)) && of_wheel(wheel))
        };
        let rods = once(&[&symbolic.rods[..], &structure.rods].concat());
        let rods = rods.into_iter().filter(|ends| !is_radius(ends) && !passes(ends)).collect();
        let bars: Vec<rigid::Link> =
            structure.links.iter().filter(|link| !link.pair().is_some_and(|ends| passes(&ends))).cloned().collect();
        let links = rigid::without_touched(bars, &wheels, model, &structure.first);
        let at_start = samples.first().map(|at| at.places.clone()).unwrap_or_default();
        let mut geometry = Geometry {
            model: Arc::clone(model),
            names: symbolic.names.clone(),
            first: structure.first,
            ground: structure.ground,
            links,
            slides: structure.slides,
            telescopes,
            rods,
            elements,
            wheels,
            rotaries: Vec::new(),
            couples: Vec::new(),
            gears: Vec::new(),
            told_gears: Vec::new(),
            planes,
            has_switched_loads: symbolic.has_switched_loads,
            plane: structure.plane,
            size: structure.size,
            turning: structure.turning,
            at_start,
            recorded,
        };
        geometry.rotaries = geometry.rotaries_of(&symbolic, &samples);
        geometry.couples = geometry.couples_of(&symbolic, &samples);
        (geometry.gears, geometry.told_gears) = geometry.gears_of(&symbolic, &samples);
        Ok(geometry)
    }

    /// The figure at a time (s) and a state (coordinates, then speeds).
    pub fn figure(&self, time: f64, state: &[f64]) -> Figure {
        self.recorded.figure(time, state)
    }

    /// The figure with values that the mode of a run determines: switches, then friction and normal reactions of contacts.
    pub fn figure_with(&self, time: f64, state: &[f64], of_mode: &[f64]) -> Figure {
        self.recorded.figure_with(time, state, of_mode)
    }

    /// The figure at time zero with the friction of the motion that continues from `start`.
    pub fn first_figure(&self, start: &[f64]) -> Figure {
        let has_friction = self.model.contacts.iter().any(|contact| contact.friction.is_some());
        let is_of_mode = self.has_switched_loads || has_friction;
        let of_mode = if is_of_mode { mode_values_at_start(&self.model, start) } else { None };
        self.figure_with(0.0, start, &of_mode.unwrap_or_default())
    }

    /// The index of the point at a body's centre of mass.
    pub fn centre(&self, body: usize) -> Option<usize> {
        Some(self.first[self.model.bodies.get(body)?.centre?.0])
    }

    /// True if two frames do not rotate relative to each other.
    pub fn turn_together(&self, one: usize, other: usize) -> bool {
        self.turning[one] == self.turning[other]
    }

    /// True if there is something to draw: more than one point, a body that turns, or a frame.
    pub fn is_seen(&self) -> bool {
        self.first.iter().any(|place| *place != self.first[0])
            || self.model.bodies.iter().any(|body| body.frame.is_some())
            || self.model.frames.len() > 1
    }
}
