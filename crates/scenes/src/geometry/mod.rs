//! The geometry of a system: relations between its places that hold in all states, and their positions at a time.
//!
//! The structure is found, not declared: places that keep their coordinates in a frame at several distant states are fixed in it.
//! Thus links are found by their ends, whether a body, a massless frame, or cosines and sines describe their rotation.

mod figure;
mod inertia;
mod rigid;
mod wheels;

pub use figure::{Figure, Touch};
pub use inertia::Ellipsoid;
pub use rigid::Link;

use crate::compiled_system::NotCompiled;
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
    /// Bodies that roll.
    pub wheels: Vec<Wheel>,
    /// The normal of the plane in which everything moves; none of a system in space.
    pub plane: Option<Vector3<f64>>,
    /// The largest distance of two places.
    pub size: f64,
    recorded: Recorded,
}

/// A body that rolls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    pub body: usize,
    /// The point where it touches.
    pub point: usize,
    pub radius: f64,
    /// The axis of its frame; none of a ball.
    pub axis: Option<usize>,
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
        let wheels = wheels::wheels(model, &samples, &symbolic, &structure);
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
            once(&structure.telescopes).into_iter().filter(|ends| !is_joined(ends)).collect();
        let is_radius = |ends: &[usize; 2]| {
            let centre = |wheel: &Wheel| model.bodies[wheel.body].centre.map(|centre| first(centre.0));
            let of_wheel = |wheel: &Wheel| centre(wheel).is_some_and(|centre| ends.contains(&centre));
            wheels.iter().any(|wheel| ends.contains(&first(wheel.point)) && of_wheel(wheel))
        };
        let rods = once(&[&symbolic.rods[..], &structure.rods].concat());
        let rods = rods.into_iter().filter(|ends| !is_radius(ends)).collect();
        let links = rigid::without_touched(structure.links, &wheels, model, &structure.first);
        Ok(Geometry {
            model: Arc::clone(model),
            names: symbolic.names,
            first: structure.first,
            ground: structure.ground,
            links,
            slides: structure.slides,
            telescopes,
            rods,
            elements,
            wheels,
            plane: structure.plane,
            size: structure.size,
            recorded,
        })
    }

    /// The places at a time and a state.
    pub fn figure(&self, time: f64, state: &[f64]) -> Figure {
        self.recorded.figure(time, state)
    }

    /// The place of a body's centre of mass.
    pub fn centre(&self, body: usize) -> Option<usize> {
        Some(self.first[self.model.bodies.get(body)?.centre?.0])
    }

    /// Whether anything has a place: more than the origin, or a body that turns.
    pub fn is_seen(&self) -> bool {
        self.first.iter().any(|place| *place != self.first[0])
            || self.model.bodies.iter().any(|body| body.frame.is_some())
            || self.model.frames.len() > 1
    }
}
