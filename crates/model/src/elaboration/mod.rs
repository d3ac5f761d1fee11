//! Elaboration of a system from its texts to a model: resolves names in the order of their dependence, and checks dimensions.

mod absent;
mod angles;
mod axial;
mod bodies;
mod body_momenta;
mod choices;
mod conditions_of_law;
mod constants;
mod contact_checks;
mod contacts;
mod drives;
mod elementary;
mod energies_shown;
mod events;
mod expressions;
mod forces;
mod frame_angles;
mod functions;
mod guides;
mod headings;
mod inertialess;
mod loads;
mod names;
mod neighbours;
mod one_sided_loads;
mod one_ways;
mod operations;
mod order;
mod orders;
mod orientation;
mod oversights;
mod parts;
mod quasi_velocities;
mod rates;
mod reactions;
mod regulator;
mod released;
mod resolution;
mod rigid;
mod system;
mod tangents;
#[cfg(test)]
mod tests;
mod turning_inertias;
mod unheld_axes;
mod value;
mod windings;

use crate::arena::{Arena, Scalar, Vector};
use crate::expression::{Expression, read};
use crate::{
    BodyId, Fault, Frame, FrameId, GeneralisedForce, Model, Point, PointId, ScalarId, Source, Text, Torque, VectorId,
};
use constants::Constant;
use drives::Drive;
use names::{defined_twice, unknown};
use one_sided_loads::Load;
use orders::Orders;
use reactions::ReactionLetter;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use symbolic::Dimension;
use value::{Value, mismatch};

pub use angles::bare_angle;
pub use constants::HALF_TURN;
pub use headings::misplaced;
pub(crate) use inertialess::with_changing_laws;
pub(crate) use resolution::elaborate;

/// Names of vectors in messages.
const TORQUE: &str = "a torque";
const TARGET: &str = "the target of a force";
const GRAVITY: &str = "the acceleration of free fall";

/// Names with a predefined meaning.
const RESERVED: [&str; 5] = ["t", "pi", "N", "O", "ground"];

/// Returns whether a name has a predefined meaning.
pub fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// The largest number of coordinates, of bodies, of points, and of each other kind of items in a system.
const MOST: usize = 1000;

/// The meaning of a name in the system.
#[derive(Clone, Debug)]
enum Named {
    Value(Value),
    Body(BodyId),
    Drive(usize),
}

/// A torque of a drive, with the position of its expression if it has one.
type DrivingTorque = (Torque, Option<Range<usize>>);

/// The result of elaborating one part. A fault ends the elaboration of this part only.
type Sound<T> = Result<T, Box<Fault>>;

struct Elaborator<'s> {
    source: &'s Source,
    model: Model,
    names: FxHashMap<String, Named>,
    /// The dimension of each node; `None` for zero, which has every dimension.
    dimensions: Vec<Option<Dimension>>,
    /// The exact value of each node that is formed from constants.
    constants: Vec<Option<Constant>>,
    /// The highest time derivative of a coordinate in each node.
    orders: Orders,
    /// Whether reactions and joint loads are allowed here, as in outputs.
    shows_loads: bool,
    /// Names with a wrong definition; uses of them are not reported.
    broken: FxHashSet<String>,
    faults: Vec<Fault>,
    drives: Vec<Drive>,
    /// For each charge, given by the index of its coordinate, the current.
    currents: FxHashMap<usize, ScalarId>,
    /// For each drive, the frame that carries the motor, and the frame of the rotor.
    rotor_frames: Vec<drives::Rotor>,
    /// The loads of the file, each with the position of its expression.
    loads: Vec<(Load, Range<usize>)>,
    /// Torques and voltages of drives, added after the loads of the file.
    driving: (Vec<DrivingTorque>, Vec<GeneralisedForce>),
    /// Tables that contain keys of another table, whose heading is missing.
    headless: Vec<(String, Fault)>,
    /// Reactions that loads and events depend on.
    reaction_letters: Vec<ReactionLetter>,
    /// Names of constraints whose reactions occur in expressions.
    constraints_read: Vec<String>,
    /// Free frames described by three angles.
    by_angles: Vec<FrameId>,
}

impl<'s> Elaborator<'s> {
    /// Starts the elaboration with the predefined names. Each entry of `reaction_letters`, a reaction on which the loads depend, becomes the rate of a coordinate.
    fn new(source: &'s Source, reaction_letters: Vec<ReactionLetter>) -> Self {
        let mut model = Model::default();
        model.frames.push(Frame { name: "N".to_owned(), parent: None });
        model.points.push(Point { name: "O".to_owned(), base: None });
        let mut made = Elaborator {
            source,
            model,
            names: FxHashMap::default(),
            dimensions: Vec::new(),
            constants: Vec::new(),
            orders: Orders::default(),
            shows_loads: false,
            broken: FxHashSet::default(),
            faults: Vec::new(),
            drives: Vec::new(),
            currents: FxHashMap::default(),
            rotor_frames: Vec::new(),
            loads: Vec::new(),
            driving: (Vec::new(), Vec::new()),
            headless: Vec::new(),
            reaction_letters,
            constraints_read: Vec::new(),
            by_angles: Vec::new(),
        };
        let time = made.scalar(Scalar::Time, Some(Dimension::time()));
        made.names.insert("t".to_owned(), Named::Value(Value::Scalar(time)));
        let pi = made.scalar(Scalar::Pi, Some(Dimension::none()));
        made.names.insert("pi".to_owned(), Named::Value(Value::Scalar(pi)));
        for ground in ["N", "ground"] {
            made.names.insert(ground.to_owned(), Named::Value(Value::Frame(FrameId::GROUND)));
        }
        made.names.insert("O".to_owned(), Named::Value(Value::Point { base: PointId::ORIGIN, way: None }));
        made
    }

    fn arena(&mut self) -> &mut Arena {
        &mut self.model.arena
    }

    fn scalar(&mut self, scalar: Scalar, dimension: Option<Dimension>) -> ScalarId {
        let constant = self.constant_of(&scalar);
        let order = self.orders.of_scalar(&self.model, &scalar);
        let id = self.arena().scalar(scalar, dimension);
        // an existing scalar has its dimension already
        if id.0 == self.dimensions.len() {
            self.dimensions.push(dimension);
            self.constants.push(constant);
            self.orders.push(order);
        }
        id
    }

    fn vector(&mut self, vector: Vector, dimension: Option<Dimension>) -> VectorId {
        let order = self.orders.of_vector(&self.model, &vector);
        let id = self.arena().vector(vector);
        if id.0 == self.dimensions.len() {
            self.dimensions.push(dimension);
            self.constants.push(None);
            self.orders.push(order);
        }
        id
    }

    fn dimension_of(&self, part: usize) -> Option<Dimension> {
        self.dimensions[part]
    }

    /// Stores a fault. Elaboration continues with independent parts.
    fn kept<T>(&mut self, found: Sound<T>) -> Option<T> {
        match found {
            Ok(found) => Some(found),
            Err(fault) => {
                self.faults.extend((!fault.is_consequence()).then_some(*fault));
                None
            }
        }
    }

    /// Stores the fault of a definition, and marks its name as broken.
    fn kept_as<T>(&mut self, name: &Text, found: Sound<T>) -> Option<T> {
        if found.is_err() {
            self.broken.insert(name.text.clone());
        }
        self.kept(found)
    }

    /// Assigns a name its meaning; a second meaning is a fault.
    fn give(&mut self, name: &Text, named: Named) {
        let text = name.text.as_str();
        let refused = |why: &str, accepted: &str| Fault::at(name.span(), format!("`{text}` {why}"), "here", accepted);
        let fault = if !crate::expression::is_name(text) || text.ends_with(['\'', '′', '″']) {
            Some(refused("is no name", "letters, digits and _ after a first letter; primes are for rates"))
        } else if is_reserved(text) {
            Some(refused(
                "has a meaning of its own",
                "t is the time, pi the number, N the ground's frame, O its origin; another name is accepted",
            ))
        } else if self.names.contains_key(text) {
            Some(defined_twice(self.source, name))
        } else {
            None
        };
        match fault {
            Some(fault) => {
                // the name is ambiguous, hence its other uses are not reported
                self.broken.insert(text.to_owned());
                self.faults.push(fault);
            }
            None => {
                self.names.insert(text.to_owned(), named);
            }
        }
    }

    fn read(&self, text: &Text) -> Sound<Expression> {
        read(&text.text).map_err(|wrong| {
            let title = "this expression cannot be read";
            Box::new(Fault::at(text.part(&wrong.span), title, wrong.reason.to_string(), EXAMPLES))
        })
    }

    /// Returns the value of an expression.
    fn value(&mut self, text: &Text) -> Sound<Value> {
        let expression = self.read(text)?;
        self.value_of(text, &expression)
    }

    /// Returns the value of a scalar expression. Its dimension must be `needed`, if given.
    fn scalar_value(&mut self, text: &Text, what: &str, needed: Option<Dimension>) -> Sound<ScalarId> {
        match self.value(text)? {
            Value::Scalar(id) => {
                self.must_measure(&text.span(), id.0, what, needed)?;
                Ok(id)
            }
            other => Err(mismatch(&text.span(), what, "a scalar", &other)),
        }
    }

    /// Returns the value of a vector expression. Its dimension must be `needed`, if given.
    fn vector_value(&mut self, text: &Text, what: &str, needed: Option<Dimension>) -> Sound<VectorId> {
        match self.value(text)? {
            Value::Vector(id) => {
                self.must_measure(&text.span(), id.0, what, needed)?;
                Ok(id)
            }
            Value::Scalar(id) if self.dimension_of(id.0).is_none() => Ok(self.vector(Vector::Zero, None)),
            other => Err(mismatch(&text.span(), what, "a vector", &other)),
        }
    }

    fn must_measure(&self, span: &Range<usize>, part: usize, what: &str, needed: Option<Dimension>) -> Sound<()> {
        match (self.dimension_of(part), needed) {
            (Some(found), Some(needed)) if found != needed => Err(Box::new(Fault::at(
                span.clone(),
                format!("{what} must have the dimension {needed}"),
                format!("this has the dimension {found}"),
                format!("an expression of the dimension {needed}"),
            ))),
            _ => Ok(()),
        }
    }

    fn body(&self, name: &Text) -> Sound<BodyId> {
        match self.names.get(name.text.trim()) {
            Some(Named::Body(body)) => Ok(*body),
            _ => {
                let known = self
                    .names
                    .iter()
                    .filter(|(_, named)| matches!(named, Named::Body(_)))
                    .map(|(name, _)| name.as_str());
                Err(Box::new(unknown(&self.broken, name.span(), &name.text, "body", known)))
            }
        }
    }

    fn centre(&self, body: BodyId, span: &Range<usize>) -> Sound<PointId> {
        self.model.bodies[body.0].centre.ok_or_else(|| {
            let name = &self.model.bodies[body.0].name;
            // a mass without a centre is reported at the body
            if self.source.bodies.iter().any(|body| body.name.text == *name && body.mass.is_some()) {
                return Box::new(Fault::consequence(span.clone()));
            }
            Box::new(Fault::at(
                span.clone(),
                format!("the body `{name}` has no centre of mass"),
                "no point of it is known",
                format!("`centre` in [bodies.{name}], or a point: `{name} at P`"),
            ))
        })
    }

    fn point(&mut self, text: &Text) -> Sound<PointId> {
        match self.value(text)? {
            Value::Point { base, way } => Ok(self.point_of(base, way)),
            other => Err(mismatch(&text.span(), "this", "a point", &other)),
        }
    }

    /// Returns the point displaced from `base` by the vector `way`; a new one if `way` is given.
    fn point_of(&mut self, base: PointId, way: Option<VectorId>) -> PointId {
        let Some(way) = way else { return base };
        self.model.points.push(Point { name: String::new(), base: Some((base, way)) });
        PointId(self.model.points.len() - 1)
    }

    /// Returns a frame by its name; for a body, the frame in which it is fixed.
    fn frame(&self, name: &Text) -> Sound<FrameId> {
        match self.names.get(name.text.trim()).filter(|_| !self.broken.contains(name.text.trim())) {
            Some(Named::Value(Value::Frame(frame))) => Ok(*frame),
            Some(Named::Body(body)) => self.model.bodies[body.0].frame.ok_or_else(|| {
                let title = format!("the body `{}` does not turn", name.text);
                let accepted = format!("`frame` or `turns` in [bodies.{}] says how it turns", name.text);
                Box::new(Fault::at(name.span(), title, "a particle", accepted))
            }),
            _ => {
                let is_frame = |named: &Named| matches!(named, Named::Value(Value::Frame(_)) | Named::Body(_));
                let known = self.names.iter().filter(|(_, named)| is_frame(named)).map(|(name, _)| name.as_str());
                Err(Box::new(unknown(&self.broken, name.span(), &name.text, "frame", known)))
            }
        }
    }
}

const EXAMPLES: &str =
    "for example `k*(x - (20 mm))`, `O + l*(cos(theta)*N.x + sin(theta)*N.y)`, `velocity(disc at P) . N.x`";
