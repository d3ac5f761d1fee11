//! Points, axes, normals, loads and inertias of a system, compiled as functions of time and state.

use crate::compiled_system::NotCompiled;
use crate::letters::Letters;
use crate::modes::OF_CONTACT;
use crate::program::recorded;
use model::geometry::{Couple, Element, Gear, Torsion, frame_axes};
use model::{FrameId, Inertia, Model, Trace};
use nalgebra::Vector3;
use simulation::Program;
use symbolic::{Sym, substitute_all};

/// Points and vectors of a system at a time, in components along the axes of the ground, SI units.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Time, s.
    pub time: f64,
    /// The position of each point, m.
    pub places: Vec<Vector3<f64>>,
    /// The unit vectors of the axes x, y, z of each frame.
    pub frames: Vec<[Vector3<f64>; 3]>,
    /// All contacts except diodes and freewheels.
    pub touches: Vec<Touch>,
    /// Forces that do not act between two points, N, each with the index of its point.
    pub forces: Vec<(usize, Vector3<f64>)>,
    /// Torques that are neither of a spring nor of a dashpot, N m, in the order of `Geometry::couples`.
    pub torques: Vec<Vector3<f64>>,
    /// The mass, kg, and the entries xx, yy, zz, xy, xz, yz of the inertia tensor, kg m², of each body; zero if not given.
    pub inertias: Vec<[f64; 7]>,
    /// The acceleration of gravity, m/s².
    pub gravity: Vector3<f64>,
}

/// A contact at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// The index of the contact in the model.
    pub contact: usize,
    /// The index of the touching point in [`Figure::places`].
    pub point: usize,
    /// The unit normal of the surface.
    pub normal: Vector3<f64>,
    /// The distance from the surface, m.
    pub gap: f64,
    /// The friction force on the touching body, N; zero if it is unknown or below the rounding of the normal reaction.
    pub friction: Vector3<f64>,
}

/// The part of the geometry that does not depend on the state. Points and frames are given by their indices.
#[derive(Debug, Default)]
pub(super) struct Symbolic {
    /// The name of each point; empty if it has none.
    pub names: Vec<String>,
    /// For each point: the point from which the model defines it, and the frame of the connecting vector.
    pub bases: Vec<Option<(usize, FrameId)>>,
    /// Springs and dashpots between points.
    pub elements: Vec<Element>,
    /// Pairs of points at a constant distance.
    pub rods: Vec<[usize; 2]>,
    /// Torsion springs and rotary dashpots.
    pub torsions: Vec<Torsion>,
    /// The two frames of each torque.
    pub couples: Vec<[FrameId; 2]>,
    /// Constraints between two angles: gears and belts.
    pub gears: Vec<Gear>,
    /// True if a force or a torque depends on a condition.
    pub has_switched_loads: bool,
    /// Pairs of a body and a point whose velocity or force the model refers to this body. The point need not be fixed in the body, such
    /// as the contact point of a wheel.
    pub touched: Vec<(usize, usize)>,
    /// The points on which forces act.
    forces: Vec<usize>,
    /// Pairs (contact, touching point).
    pub contacts: Vec<(usize, usize)>,
}

/// The compiled geometry. The numbers of states, points, frames, bodies and loads give the layout of its inputs and outputs.
#[derive(Debug)]
pub(super) struct Recorded {
    program: Program,
    states: usize,
    positions: usize,
    places: usize,
    frames: usize,
    bodies: usize,
    switches: usize,
    forces: Vec<usize>,
    torques: usize,
    contacts: Vec<(usize, usize)>,
}

/// The number of sampled states near the start.
const SAMPLES: u64 = 5;
/// Friction below this part of the normal reaction is a rounding error.
const ROUNDING: f64 = 1e-9;
/// The largest number of iterations for the cases of conditions: one condition may depend on another.
const TRIALS: usize = 4;

impl Recorded {
    /// Compiles the geometry of a model.
    ///
    /// # Errors
    /// An expression has no value.
    pub fn of(model: &Model) -> Result<(Self, Symbolic), NotCompiled> {
        let states = model.positions() + model.speeds();
        let switches = model.switches.len();
        let mut symbolic = Symbolic::default();
        let program = recorded(states + switches, |time, inputs| {
            let (state, cases) = inputs.split_at(states);
            let (found, values) = written(model, (time, state), cases);
            symbolic = found;
            values
        })?;
        let (forces, contacts) = (symbolic.forces.clone(), symbolic.contacts.clone());
        let torques = symbolic.couples.len();
        let (places, frames, bodies) = (symbolic.names.len(), model.frames.len(), model.bodies.len());
        let positions = model.positions();
        let recorded =
            Recorded { program, states, positions, places, frames, bodies, switches, forces, torques, contacts };
        Ok((recorded, symbolic))
    }

    /// The figure at a time (s) and a state. A condition at zero gives the middle of its two cases.
    pub fn figure(&self, time: f64, state: &[f64]) -> Figure {
        let mut cases = vec![1.0; self.switches];
        let mut values = Vec::new();
        for _ in 0..TRIALS {
            values = self.values(time, state, &cases);
            let of = |value: &f64| if *value == 0.0 { 0.5 } else { f64::from(u8::from(*value > 0.0)) };
            let found: Vec<f64> = values[values.len() - self.switches..].iter().map(of).collect();
            if cases == found {
                break;
            }
            cases = found;
        }
        self.read(time, values)
    }

    /// The figure with values that the mode of a run determines: switches, then for each contact its friction vector and normal reaction,
    /// N. Switches that are not numbers follow from their conditions.
    pub fn figure_with(&self, time: f64, state: &[f64], of_mode: &[f64]) -> Figure {
        let (switches, contacts) = of_mode.split_at(self.switches.min(of_mode.len()));
        let mut figure = match switches.len() == self.switches && switches.iter().all(|switch| switch.is_finite()) {
            true => self.read(time, self.values(time, state, switches)),
            false => self.figure(time, state),
        };
        for (touch, values) in figure.touches.iter_mut().zip(contacts.chunks_exact(OF_CONTACT)) {
            let (friction, normal) = (Vector3::new(values[0], values[1], values[2]), values[3]);
            if friction.norm() > ROUNDING * normal.abs() {
                touch.friction = friction;
            }
        }
        figure
    }

    /// All outputs of the program; NaN for a state of another length.
    fn values(&self, time: f64, state: &[f64], cases: &[f64]) -> Vec<f64> {
        let vectors = self.places + 3 * self.frames + self.contacts.len() + self.forces.len() + self.torques + 1;
        let length = 3 * vectors + self.contacts.len() + 7 * self.bodies + self.switches;
        let mut values = vec![f64::NAN; length];
        let inputs = [state.get(..self.states).unwrap_or(state), cases].concat();
        let _ = self.program.run(time, &inputs, &mut values);
        values
    }

    fn read(&self, time: f64, values: Vec<f64>) -> Figure {
        let mut left = values.into_iter();
        let mut vector = || Vector3::from_fn(|_, _| left.next().unwrap_or(f64::NAN));
        let places = (0..self.places).map(|_| vector()).collect();
        let frames = (0..self.frames).map(|_| [vector(), vector(), vector()]).collect();
        let normals: Vec<Vector3<f64>> = self.contacts.iter().map(|_| vector()).collect();
        let forces = self.forces.iter().map(|place| (*place, vector())).collect();
        let torques = (0..self.torques).map(|_| vector()).collect();
        let gravity = vector();
        let touches = self.contacts.iter().zip(normals);
        let touches = touches.map(|((contact, point), normal)| {
            let gap = left.next().unwrap_or(f64::NAN);
            Touch { contact: *contact, point: *point, normal, gap, friction: Vector3::zeros() }
        });
        let touches = touches.collect();
        let inertias = (0..self.bodies).map(|_| std::array::from_fn(|_| left.next().unwrap_or(f64::NAN))).collect();
        Figure { time, places, frames, touches, forces, torques, inertias, gravity }
    }

    /// Figures at `state` and at pseudo-random states around it; coordinates and time are varied, speeds are not.
    pub fn samples(&self, state: &[f64]) -> Vec<Figure> {
        let moved = |sample: u64, share: f64| {
            let part = |place: u64| 2.0 * fraction(sample * 1_009 + place) - 1.0;
            let step = |(place, value): (usize, &f64)| value + share * (0.3 + value.abs()) * part(place as u64 + 1);
            let coordinates = state.iter().take(self.positions).enumerate().map(step);
            let speeds = state.iter().skip(self.positions).copied();
            self.figure(share * fraction(sample), &coordinates.chain(speeds).collect::<Vec<_>>())
        };
        let mut found = vec![self.figure(0.0, state)];
        for sample in 1..=SAMPLES {
            // an expression may have no value far from the start
            let near = [1.0, 0.1, 0.01].into_iter().map(|share| moved(sample, share)).find(Figure::has_values);
            found.extend(near);
        }
        found
    }
}

impl Figure {
    /// True if all points and frames have finite components.
    pub fn has_values(&self) -> bool {
        self.places.iter().chain(self.frames.iter().flatten()).flatten().all(|value| value.is_finite())
    }
}

/// The geometry, and all outputs of the program as expressions; conditions are last.
fn written(model: &Model, (time, state): (Sym, &[Sym]), cases: &[Sym]) -> (Symbolic, Vec<Sym>) {
    let trace = Trace::of(model);
    let geometry = model::geometry::Geometry::of(&trace);
    let letters = Letters::with_data(time, state);
    let choice: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(cases.iter().copied()).collect();
    let put = |expressions: &[Sym]| letters.put_into(&trace, &substitute_all(expressions, &choice));
    let inputs = [state, cases, &[time]].concat();
    let has_value = |expressions: &[Sym]| {
        put(expressions).iter().all(|each| each.symbols_of().iter().all(|letter| inputs.contains(letter)))
    };
    let contacts = model.contacts.iter().enumerate().filter(|(_, contact)| contact.one_way.is_none());
    let contacts: Vec<(usize, usize)> = contacts.map(|(place, contact)| (place, contact.point.0)).collect();
    let forces: Vec<(usize, [Sym; 3])> = geometry.forces.into_iter().filter(|(_, is)| has_value(is)).collect();
    let couples: Vec<Couple> = geometry.couples.into_iter().filter(|couple| has_value(&couple.torque)).collect();
    let loads: Vec<Sym> =
        forces.iter().map(|(_, is)| is).chain(couples.iter().map(|couple| &couple.torque)).flatten().copied().collect();
    let has_switched_loads =
        loads.iter().any(|part| part.symbols_of().iter().any(|letter| trace.switches.contains(letter)));
    let ground = |vector| trace.express(vector, FrameId::GROUND);
    let mut values: Vec<Sym> = geometry.places.iter().flat_map(|place| place.position).collect();
    values.extend((0..model.frames.len()).flat_map(|frame| frame_axes(&trace, FrameId(frame)).into_iter().flatten()));
    values.extend(contacts.iter().flat_map(|(contact, _)| ground(trace.vector(model.contacts[*contact].normal))));
    values.extend(loads);
    values.extend(model.gravity.map_or([Sym::ZERO; 3], |gravity| ground(trace.vector(gravity))));
    values.extend(contacts.iter().map(|(contact, _)| trace.scalar(model.contacts[*contact].gap)));
    for body in &model.bodies {
        values.push(body.mass.map_or(Sym::ZERO, |mass| trace.scalar(mass)));
        values.extend(moments(&trace, body.inertia.as_ref()));
    }
    values.extend(model.switches.iter().map(|switch| trace.scalar(*switch)));
    let values = put(&values);
    // expressions with unknown letters, such as reactions, are left out
    let known =
        |each: Sym| if each.symbols_of().iter().all(|letter| inputs.contains(letter)) { each } else { Sym::ZERO };
    let symbolic = Symbolic {
        bases: geometry.places.iter().map(|place| place.base).collect(),
        names: geometry.places.into_iter().map(|place| place.name).collect(),
        elements: geometry.elements,
        rods: geometry.rods,
        torsions: geometry.torsions,
        couples: couples.into_iter().map(|couple| couple.frames).collect(),
        gears: geometry.gears,
        has_switched_loads,
        touched: geometry.touched.into_iter().map(|(body, point)| (body.0, point.0)).collect(),
        forces: forces.into_iter().map(|(place, _)| place).collect(),
        contacts,
    };
    (symbolic, values.into_iter().map(known).collect())
}

/// The entries xx, yy, zz, xy, xz, yz of an inertia tensor; zero if not given.
fn moments(trace: &Trace<'_>, inertia: Option<&Inertia>) -> [Sym; 6] {
    let mut moments = [Sym::ZERO; 6];
    match inertia {
        None => {}
        Some(Inertia::Axial(axial)) => moments[2] = trace.scalar(*axial),
        Some(Inertia::OfShaft { moment, axis }) => moments[*axis] = trace.scalar(*moment),
        Some(Inertia::Tensor { entries, .. }) => {
            moments = entries.map(|entry| entry.map_or(Sym::ZERO, |entry| trace.scalar(entry)));
        }
    }
    moments
}

/// A pseudo-random number in [0, 1) that depends on `place` alone (splitmix64; Steele, Lea and Flood 2014).
fn fraction(place: u64) -> f64 {
    let mut bits = place.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}
