//! The geometry of a system: relations between its places that hold in all states, and their positions at a time.
//!
//! The structure is found, not declared: places that keep their coordinates in a frame at several distant states are fixed in it.
//! Thus links are found by their ends, whether a body, a massless frame, or cosines and sines describe their rotation.

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

/// The structure of a system with the program of its places.
#[derive(Debug)]
pub struct Geometry {
    pub model: Arc<Model>,
    /// Names of places, empty where they have none.
    pub names: Vec<String>,
    /// For each place the first one that coincides with it at all times.
    pub first: Vec<usize>,
    /// Places that are fixed in the ground.
    pub ground: Vec<usize>,
    pub links: Vec<Link>,
    /// Places that move along a line of the ground, with its direction.
    pub slides: Vec<(usize, Vector3<f64>)>,
    /// Places that move along a line of a frame from another place.
    pub telescopes: Vec<[usize; 2]>,
    pub elements: Vec<Element>,
    pub rods: Vec<[usize; 2]>,
    /// Bodies that roll, and round ones that slide without turning.
    pub wheels: Vec<Wheel>,
    pub rotaries: Vec<Rotary>,
    /// The joint of each torque of a figure.
    pub couples: Vec<Joint>,
    pub gears: Vec<GearPair>,
    /// Sentences on gears whose centres no place tells.
    pub told_gears: Vec<String>,
    /// For each contact of a figure whether it is one of a plane, and not of a curve.
    pub planes: Vec<bool>,
    /// Whether a force or a torque changes at a condition, such as dry friction.
    pub has_switched_loads: bool,
    /// The normal of the plane in which everything moves; none of a system in space.
    pub plane: Option<Vector3<f64>>,
    /// The largest distance of two places.
    pub size: f64,
    /// The first of the frames that turn together with each.
    turning: Vec<usize>,
    at_start: Vec<Vector3<f64>>,
    recorded: Recorded,
}

/// A body that rolls, or a round one that slides without turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    pub body: usize,
    /// The point where it touches.
    pub point: usize,
    pub radius: f64,
    /// The axis of its frame; none of a ball, and of a body that does not turn.
    pub axis: Option<usize>,
    pub turns: bool,
}

impl Geometry {
    /// The geometry of a model whose parameters and inputs have values, about a state.
    ///
    /// # Errors
    /// An expression of a place has no value.
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

    /// The places at a time and a state.
    pub fn figure(&self, time: f64, state: &[f64]) -> Figure {
        self.recorded.figure(time, state)
    }

    /// The same with the values that the mode of a run determines: of switches, then of the friction of contacts.
    pub fn figure_with(&self, time: f64, state: &[f64], of_mode: &[f64]) -> Figure {
        self.recorded.figure_with(time, state, of_mode)
    }

    /// The figure of the motion that goes on from a start.
    pub fn first_figure(&self, start: &[f64]) -> Figure {
        let has_friction = self.model.contacts.iter().any(|contact| contact.friction.is_some());
        let is_of_mode = self.has_switched_loads || has_friction;
        let of_mode = if is_of_mode { mode_values_at_start(&self.model, start) } else { None };
        self.figure_with(0.0, start, &of_mode.unwrap_or_default())
    }

    /// The place of a body's centre of mass.
    pub fn centre(&self, body: usize) -> Option<usize> {
        Some(self.first[self.model.bodies.get(body)?.centre?.0])
    }

    /// Whether two frames keep their angles to each other.
    pub fn turn_together(&self, one: usize, other: usize) -> bool {
        self.turning[one] == self.turning[other]
    }

    /// Whether anything has a place: more than the origin, or a body that turns.
    pub fn is_seen(&self) -> bool {
        self.first.iter().any(|place| *place != self.first[0])
            || self.model.bodies.iter().any(|body| body.frame.is_some())
            || self.model.frames.len() > 1
    }
}
