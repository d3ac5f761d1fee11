//! A model over symbols, in the expression graph of one thread.
//!
//! Coordinates are symbols with their names; speeds and accelerations have primes. Parameters are symbols, which get values
//! when the system is run. Every vector has components along the axes of one frame, sums along those of the frame further down the tree.
//! Angles of successive rotations are therefore never added.

mod angle;
mod bodies;
mod contacts;
mod free_frame;
mod judgement;
mod motion;
mod parameter_divisors;
mod rotation;
mod step;
mod vector;

pub(crate) use free_frame::FreeFrame;
pub(crate) use free_frame::turned_axes;
pub(crate) use rotation::Rotation;
pub(crate) use rotation::quaternion_product;
pub use rotation::{quaternion_rates, turned_further};
pub(crate) use vector::Frames;
pub use vector::Vector;

use crate::arena::{Function, Number, Part, Scalar};
use crate::equations::held_of;
use crate::expression::Exponent;
use crate::joints::Joints;
use crate::presentation::FreeTurn;
use crate::principles::lagrange::inertia;
use crate::principles::loads::generalised;
use crate::{FrameId, Input, Model, ScalarId, Turn, VectorId};
use field::{Analytic, Over, Rational, Scalar as _};
use judgement::Judgement;
use std::cell::RefCell;
use std::f64::consts::{PI, TAU};
use step::step;
use symbolic::{Derivation, Sym};

/// A model over symbols: kinematics, energies and derivatives.
pub struct Trace<'m> {
    pub model: &'m Model,
    /// The symbol of the time t.
    pub time: Sym,
    /// The symbol of pi.
    pub pi: Sym,
    /// The symbols of the parameters, in the order of the model.
    pub parameters: Vec<Sym>,
    /// The coordinates q; the quaternions of free frames come last.
    pub coordinates: Vec<Sym>,
    /// The rates q' as functions of the speeds.
    pub position_rates: Vec<Sym>,
    /// The direction cosines of each free frame: entry (i, j) is axis i of the parent times axis j of the frame.
    pub cosines: Vec<[[Sym; 3]; 3]>,
    /// The speeds u: rates of coordinates, then angular velocities of free frames along their own axes.
    pub speeds: Vec<Sym>,
    /// The symbol of each switch, with value 1 or 0; its derivatives are zero.
    pub switches: Vec<Sym>,
    /// The accelerations u'.
    pub accelerations: Vec<Sym>,
    /// The time derivative along the motion: q' by the speeds, u' by its own symbols, t' = 1.
    rate: RefCell<Derivation>,
    /// The partial derivative by each speed.
    by_speed: Vec<RefCell<Derivation>>,
    /// The partial derivative by each acceleration.
    by_acceleration: Vec<RefCell<Derivation>>,
    /// For each speed, the derivative by its coordinate, or by a rotation about an axis of a free frame.
    by_coordinate: Vec<RefCell<Derivation>>,
    frames: Frames,
    points: RefCell<Vec<motion::PointMotion>>,
    scalars: Vec<Sym>,
    vectors: Vec<Vector>,
    /// Variable masses and moments of inertia, as (symbol, value).
    solid: RefCell<Vec<(Sym, Sym)>>,
    judgement: Judgement<'m>,
}

impl<'m> Trace<'m> {
    /// Evaluates the expressions of a model over symbols, in the order of the model.
    pub fn of(model: &'m Model) -> Self {
        let letters = |primes: &str, dots: &str| -> Vec<Sym> {
            let named = |coordinate: &crate::Coordinate| {
                let letter = Sym::symbol(&coordinate.name).latex();
                Sym::named(&format!("{}{primes}", coordinate.name), &format!("{dots}{{{letter}}}"))
            };
            model.coordinates.iter().map(named).collect()
        };
        let ordinary: Vec<Sym> = model.coordinates.iter().map(|coordinate| Sym::symbol(&coordinate.name)).collect();
        let time = Sym::symbol("t");
        let (mut speeds, mut accelerations) = (letters("'", r"\dot"), letters("''", r"\ddot"));
        let alone = |symbols: &[Sym]| -> Vec<RefCell<Derivation>> {
            symbols.iter().map(|&symbol| RefCell::new(Derivation::new([(symbol, Sym::ONE)]))).collect()
        };
        let mut by_coordinate = alone(&ordinary);
        let mut coordinates = ordinary;
        let mut position_rates = speeds.clone();
        let (mut cosines, mut turned) = (Vec::new(), Vec::new());
        for frame in &model.free {
            let free = FreeFrame::named(&model.frames[frame.0].name);
            by_coordinate.extend(free.displacements().map(|alone| RefCell::new(Derivation::new(alone))));
            turned.extend(free.turned(free.speeds));
            cosines.push(free.cosines);
            position_rates.extend(free.rates());
            coordinates.extend(free.quaternion);
            speeds.extend(free.speeds);
            accelerations.extend(free.accelerations);
        }
        let along = coordinates.iter().zip(&position_rates).chain(speeds.iter().zip(&accelerations));
        let rates = along.map(|(&symbol, &rate)| (symbol, rate)).chain([(time, Sym::ONE)]).chain(turned);
        let mut trace = Trace {
            model,
            time,
            pi: angle::pi(),
            parameters: model.parameters.iter().map(|parameter| Sym::symbol(&parameter.name)).collect(),
            rate: RefCell::new(Derivation::new(rates)),
            by_speed: alone(&speeds),
            by_acceleration: alone(&accelerations),
            by_coordinate,
            coordinates,
            position_rates,
            cosines,
            speeds,
            switches: Vec::new(),
            accelerations,
            frames: Frames::default(),
            points: RefCell::new(Vec::new()),
            scalars: vec![Sym::ZERO; model.arena.parts.len()],
            vectors: vec![Vector::ZERO; model.arena.parts.len()],
            solid: RefCell::default(),
            judgement: Judgement::default(),
        };
        trace.turn_frames(0);
        for &ahead in &model.ahead {
            trace.scalars[ahead.0] = model.arena.scalar_at(ahead).map_or(Sym::ZERO, |scalar| trace.scalar_of(scalar));
        }
        for (place, part) in model.arena.parts.iter().enumerate() {
            match part {
                Part::Scalar(Scalar::Switch(switch, _)) => {
                    // comparisons that differ only at equality share a switch
                    if *switch == trace.switches.len() {
                        let letter = trace.letter_of_next_switch();
                        trace.switches.push(letter);
                    }
                    trace.scalars[place] = trace.switches[*switch];
                }
                Part::Scalar(scalar) => trace.scalars[place] = trace.scalar_of(scalar),
                Part::Vector(vector) => trace.vectors[place] = trace.vector_of(vector),
            }
            trace.turn_frames(place + 1);
        }
        trace
    }

    /// Returns the symbol of the next switch, Iverson's bracket: 1 where the condition holds, otherwise 0.
    fn letter_of_next_switch(&self) -> Sym {
        let number = self.switches.len();
        let condition = self.scalar(self.model.switches[number]);
        let (text, latex) = match Sym::operations_of(&[condition]) {
            few if few <= MOST_IN_BRACKETS => (condition.to_string(), condition.latex()),
            _ => (format!("condition {}", number + 1), format!(r"\text{{condition {}}}", number + 1)),
        };
        Sym::named(&format!("[{text} > 0]"), &format!("[{latex} > 0]"))
    }

    /// Adds the frames whose angles are among the first `traced` nodes.
    fn turn_frames(&mut self, traced: usize) {
        while let Some(frame) = self.model.frames.get(self.frames.count()) {
            let turned = match frame.parent {
                None => None,
                Some((parent, Turn::About { axis, angle })) if angle.0 < traced => {
                    let angle = self.scalar(angle);
                    let mut rate = [Sym::ZERO; 3];
                    rate[axis] = self.rate_of(angle);
                    Some((parent, Rotation::About { axis, angle: angle::circle(angle) }, rate))
                }
                Some((parent, Turn::Free { number })) => {
                    let first = self.model.free_speed(number);
                    let rate = std::array::from_fn(|k| self.speeds[first + k]);
                    Some((parent, Rotation::Matrix(self.cosines[number]), rate))
                }
                Some(_) => return,
            };
            self.frames.push(turned);
        }
    }

    /// Returns the transposition term (w x p)_i for the speed i of a free frame with momenta p; zero for other speeds. The term is added to the rate of a
    /// momentum, since rotations about the axes of a free frame do not commute.
    pub(crate) fn transposition(&self, speed: usize, momentum: impl Fn(usize) -> Sym) -> Sym {
        let Some(turn) = speed.checked_sub(self.model.coordinates.len()) else { return Sym::ZERO };
        let first = speed - turn % 3;
        let [next, last] = [first + (turn + 1) % 3, first + (turn + 2) % 3];
        self.speeds[next] * momentum(last) - self.speeds[last] * momentum(next)
    }

    /// Returns the value of a scalar expression.
    pub fn scalar(&self, id: ScalarId) -> Sym {
        self.scalars[id.0]
    }

    /// Returns the value of a vector expression.
    pub fn vector(&self, id: VectorId) -> Vector {
        self.vectors[id.0]
    }

    /// Returns the time derivative of a scalar along the motion.
    pub fn rate_of(&self, scalar: Sym) -> Sym {
        self.rate.borrow_mut().of(scalar)
    }

    /// Returns the partial derivative of a scalar by a speed.
    pub fn by_speed(&self, scalar: Sym, speed: usize) -> Sym {
        self.by_speed[speed].borrow_mut().of(scalar)
    }

    /// Returns the partial derivative of a scalar by an acceleration.
    pub fn by_acceleration(&self, scalar: Sym, acceleration: usize) -> Sym {
        self.by_acceleration[acceleration].borrow_mut().of(scalar)
    }

    /// Returns the partial derivative of a scalar by the coordinate of a speed; for a free frame by a rotation about one of its axes.
    pub fn by_coordinate(&self, scalar: Sym, coordinate: usize) -> Sym {
        self.by_coordinate[coordinate].borrow_mut().of(scalar)
    }

    /// Returns the scalar product of two vectors.
    pub fn dot(&self, a: Vector, b: Vector) -> Sym {
        self.frames.dot(a, b)
    }

    /// Returns the sum of two vectors.
    pub fn sum(&self, a: Vector, b: Vector) -> Vector {
        self.frames.sum(a, b)
    }

    /// Returns the vector product of two vectors.
    pub fn cross(&self, a: Vector, b: Vector) -> Vector {
        self.frames.cross(a, b)
    }

    /// Returns the components of a vector along the axes of a frame.
    pub fn express(&self, vector: Vector, frame: FrameId) -> [Sym; 3] {
        self.frames.express(vector, frame).components
    }

    /// Returns the quaternion and the direction cosines of each free frame.
    pub(crate) fn turns(&self) -> impl Iterator<Item = FreeTurn> {
        let quaternions = self.coordinates[self.model.coordinates.len()..].chunks_exact(4);
        quaternions.map(|parts| std::array::from_fn(|k| parts[k])).zip(self.cosines.iter().copied())
    }

    /// Returns the parent of a frame; the ground for the ground itself.
    pub(crate) fn parent(&self, frame: FrameId) -> FrameId {
        self.model.frames[frame.0].parent.map_or(frame, |(parent, _)| parent)
    }

    /// Returns the rate of a vector relative to the ground.
    pub fn vector_rate(&self, vector: Vector) -> Vector {
        let own = vector.map(|component| self.rate_of(component));
        self.frames.sum(own, self.frames.cross(self.frames.turning(vector.frame), vector))
    }

    fn scalar_of(&self, scalar: &Scalar) -> Sym {
        let of = |id: &ScalarId| self.scalar(*id);
        match scalar {
            Scalar::Number(number) => exactly(number),
            Scalar::Parameter(place) => self.parameters[*place],
            Scalar::Coordinate(place) => self.coordinates[*place],
            Scalar::Rate { coordinate, order: 1 } => self.speeds[*coordinate],
            Scalar::Rate { coordinate, .. } => self.accelerations[*coordinate],
            Scalar::Time => self.time,
            Scalar::Switch(switch, _) => self.switches[*switch],
            Scalar::Step(a, at_zero) => step(of(a), *at_zero),
            Scalar::Input(input) => match &self.model.inputs[*input] {
                Input { value: Some(value), .. } => self.scalar(*value),
                Input { name, value: None, .. } => Sym::symbol(name),
            },
            Scalar::Pi => self.pi,
            Scalar::Negation(a) => -of(a),
            Scalar::Sum(a, b) => of(a) + of(b),
            Scalar::Difference(a, b) => of(a) - of(b),
            Scalar::Product(a, b) => of(a) * of(b),
            Scalar::Quotient(a, b) => of(a) / of(b),
            Scalar::Power(a, _) | Scalar::Function(_, a) => of_argument(scalar, of(a)),
            Scalar::Elementary(function, a, b) => of(a).elementary(*function, of(b)),
            Scalar::Dot(a, b) => self.dot(self.vector(*a), self.vector(*b)),
            Scalar::Norm(a) => {
                let a = self.vector(*a);
                self.dot(a, a).sqrt()
            }
            Scalar::RateOf(a) => self.rate_of(of(a)),
            // a redundant constraint has no reaction
            Scalar::Reaction { constraint } => match self.model.is_implied([*constraint, 0]) {
                true => Sym::ZERO,
                false => Trace::multiplier([*constraint, 0]),
            },
            Scalar::Contact { contact, component } => self.reaction(*contact, *component),
            Scalar::Law { number } => self.with_mass(self.law(&self.model.laws[*number])),
            Scalar::KineticEnergy => self.with_mass(self.kinetic_energy()),
            Scalar::PotentialEnergy => self.with_mass(self.potential_energy()),
            Scalar::Momentum { speed } => self.with_mass(self.by_speed(self.kinetic_and_coenergy(), *speed)),
        }
    }

    /// Returns inertia minus forces for a linear combination of speeds.
    pub(crate) fn law(&self, combination: &[(usize, i64)]) -> Sym {
        let forces = generalised(self, true);
        let of = |&(speed, factor): &(usize, i64)| Sym::int(factor) * (inertia(self, speed) - forces[speed]);
        combination.iter().map(of).fold(Sym::ZERO, |sum, each| sum + each)
    }

    /// Substitutes variable masses by their expressions.
    fn with_mass(&self, expression: Sym) -> Sym {
        self.with_masses(&[expression])[0]
    }

    /// Returns the derivative of a power or function by its argument.
    pub(crate) fn slope(&self, scalar: &Scalar, argument: ScalarId) -> Sym {
        // names of systems contain no spaces
        let letter = Sym::symbol("its argument");
        of_argument(scalar, letter).diff(letter).substitute(&[(letter, self.scalar(argument))])
    }

    fn vector_of(&self, vector: &crate::arena::Vector) -> Vector {
        use crate::arena::Vector as Form;
        let of = |id: &VectorId| self.vector(*id);
        match vector {
            Form::Zero => Vector::ZERO,
            Form::Axis { frame, axis } => Vector::axis(*frame, *axis),
            Form::Negation(a) => of(a).map(|component| -component),
            Form::Sum(a, b) => self.sum(of(a), of(b)),
            Form::Difference(a, b) => self.sum(of(a), of(b).map(|component| -component)),
            Form::Scaled(scale, a) => {
                let scale = self.scalar(*scale);
                of(a).map(|component| scale * component)
            }
            Form::Cross(a, b) => self.frames.cross(of(a), of(b)),
            Form::Between { from, to } => self.between(*from, *to),
            Form::Velocity { of, seen } => self.seen_velocity(*of, *seen),
            Form::Acceleration { of, seen } => self.seen_acceleration(*of, *seen),
            Form::AngularVelocity { of, seen } => self.turning_beside(*of, *seen),
            Form::RateOf { of: vector, seen } => self.rate_seen(of(vector), *seen),
            Form::Reaction { constraint } => {
                let held = held_of(self, *constraint).into_iter();
                held.filter_map(|held| {
                    let multiplier = Trace::multiplier([*constraint, held.component]);
                    held.axis.map(|axis| axis.map(|component| multiplier * component))
                })
                .fold(Vector::ZERO, |sum, each| self.sum(sum, each))
            }
            Form::JointForce(body) => self.joints().load(*body).0.unwrap_or(Vector::ZERO),
            Form::JointTorque(body) => self.joints().load(*body).1,
        }
    }

    /// Returns the bodies with their joint loads.
    pub(crate) fn joints(&self) -> Joints<'_, 'm> {
        Joints::of(self)
    }
}

/// Applies a power or function to an argument.
fn of_argument(scalar: &Scalar, a: Sym) -> Sym {
    match scalar {
        Scalar::Power(_, Exponent { numerator, denominator: 1 }) => a.powi(*numerator),
        Scalar::Power(_, Exponent { numerator, .. }) => a.sqrt().powi(*numerator),
        Scalar::Function(Function::Sin, _) => angle::circle(a).sin,
        Scalar::Function(Function::Cos, _) => angle::circle(a).cos,
        Scalar::Function(Function::Tan, _) => angle::circle(a).sin / angle::circle(a).cos,
        Scalar::Function(Function::Sqrt, _) => a.sqrt(),
        _ => a,
    }
}

/// Longer conditions, in operations, are printed by their numbers.
const MOST_IN_BRACKETS: usize = 12;

/// Returns the exact value of a decimal number with its unit.
fn exactly(number: &Number) -> Sym {
    let Number { value, times, per } = *number;
    let factor = |value: f64| -> Sym {
        match value {
            PI => angle::pi(),
            TAU => angle::pi() * Sym::int(2),
            other => Sym::lift(other),
        }
    };
    let decimal: Sym = Sym::constant(Rational::decimal(value));
    match (times == 1.0, per == 1.0) {
        (true, true) => decimal,
        _ => decimal * factor(times) / factor(per),
    }
}
