//! The wrench of a constraint's reaction, computed by reverse differentiation of the constraint's expression.
//!
//! A constraint f = 0 has the virtual power lambda df, where df is the rate of f for arbitrary speeds. In the form
//!
//!   df = sum F . v_P + sum T . w_B + sum c u
//!
//! over points P, frames B and coordinates it gives the reaction: the force lambda F at P, the torque lambda T on B,
//! and the generalised force lambda c along a coordinate that occurs by name in f.

use crate::arena::{Part, Scalar, Vector as Form};
use crate::equations::Level;
use crate::{FrameId, Material, ScalarId, Trace, Vector, VectorId};
use num_traits::Zero;
use rustc_hash::FxHashMap;
use symbolic::Sym;

/// The wrench of a constraint's reaction for the multiplier one.
#[derive(Clone, Debug, Default)]
pub(super) struct Wrench {
    /// Forces with their points of action.
    pub forces: Vec<(Material, Vector)>,
    /// Torques with the frames on which they act.
    pub torques: Vec<(FrameId, Vector)>,
    /// Generalised forces along coordinates that occur by name in the constraint.
    pub along: Vec<(usize, Sym)>,
}

/// The quantities with respect to which a node is differentiated: positions, or speeds at constant positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Varied {
    Positions,
    Speeds,
}

struct Backward<'t, 'm> {
    trace: &'t Trace<'m>,
    scalars: FxHashMap<(usize, Varied), Sym>,
    vectors: FxHashMap<(usize, Varied), Vector>,
    wrench: Wrench,
}

/// Returns the wrench of a scalar constraint.
pub(super) fn of_scalar(trace: &Trace<'_>, zero: ScalarId, level: Level) -> Wrench {
    let mut backward = Backward::new(trace);
    backward.add(zero, varied(level), Sym::ONE);
    backward.run(zero.0)
}

/// Returns the wrench of a component of a vector constraint along an axis.
pub(super) fn along_axis(trace: &Trace<'_>, zero: VectorId, axis: Vector, level: Level) -> Wrench {
    let mut backward = Backward::new(trace);
    backward.add_vector(zero, varied(level), axis);
    if level == Level::Position {
        // the axis rotates with its frame
        let turned = trace.cross(axis, trace.vector(zero));
        backward.torque(axis.frame, turned);
    }
    backward.run(zero.0)
}

fn varied(level: Level) -> Varied {
    if level == Level::Position { Varied::Positions } else { Varied::Speeds }
}

impl<'t, 'm> Backward<'t, 'm> {
    fn new(trace: &'t Trace<'m>) -> Self {
        Backward { trace, scalars: FxHashMap::default(), vectors: FxHashMap::default(), wrench: Wrench::default() }
    }

    fn add(&mut self, part: ScalarId, varied: Varied, weight: Sym) {
        let sum = self.scalars.entry((part.0, varied)).or_insert(Sym::ZERO);
        *sum += weight;
    }

    fn add_vector(&mut self, part: VectorId, varied: Varied, weight: Vector) {
        let sum = self.vectors.entry((part.0, varied)).or_insert(Vector::ZERO);
        *sum = self.trace.sum(*sum, weight);
    }

    fn force(&mut self, at: Material, is: Vector) {
        if !is.is_zero() {
            self.wrench.forces.push((at, is));
        }
    }

    fn torque(&mut self, on: FrameId, is: Vector) {
        if on != FrameId::GROUND && !is.is_zero() {
            self.wrench.torques.push((on, is));
        }
    }

    /// Propagates weights from a node to its operands, which have smaller indices.
    fn run(mut self, whole: usize) -> Wrench {
        for place in (0..=whole).rev() {
            for varied in [Varied::Speeds, Varied::Positions] {
                match &self.trace.model.arena.parts[place] {
                    Part::Scalar(scalar) => {
                        if let Some(weight) = self.scalars.remove(&(place, varied)).filter(|weight| !weight.is_zero()) {
                            self.scalar(scalar, varied, weight, self.trace.scalar(ScalarId(place)));
                        }
                    }
                    Part::Vector(vector) => {
                        if let Some(weight) = self.vectors.remove(&(place, varied)).filter(|weight| !weight.is_zero()) {
                            self.vector(vector, varied, weight);
                        }
                    }
                }
            }
        }
        self.wrench
    }

    fn scalar(&mut self, scalar: &Scalar, varied: Varied, weight: Sym, value: Sym) {
        let of = |id: &ScalarId| self.trace.scalar(*id);
        match scalar {
            Scalar::Number(_)
            | Scalar::Parameter(_)
            | Scalar::Time
            | Scalar::Pi
            | Scalar::Switch(..)
            | Scalar::Step(..) => {}
            // constraints contain none of these scalars, which belong to outputs and contacts
            Scalar::Reaction { .. }
            | Scalar::Contact { .. }
            | Scalar::KineticEnergy
            | Scalar::PotentialEnergy
            | Scalar::Momentum { .. } => {}
            Scalar::Law { .. } => {
                let slope = |speed: usize| match varied {
                    Varied::Positions => self.trace.by_coordinate(value, speed),
                    Varied::Speeds => self.trace.by_speed(value, speed),
                };
                for speed in 0..self.trace.speeds.len() {
                    let slope = slope(speed);
                    if slope != Sym::ZERO {
                        self.wrench.along.push((speed, weight * slope));
                    }
                }
            }
            Scalar::Input(input) => {
                if let Some(value) = self.trace.model.inputs[*input].value {
                    self.add(value, varied, weight);
                }
            }
            Scalar::Elementary(function, a, b) => {
                let [by_a, by_b] = function.slopes(of(a), of(b), value);
                self.add(*a, varied, weight * by_a);
                if function.arguments() == 2 {
                    self.add(*b, varied, weight * by_b);
                }
            }
            Scalar::Coordinate(place) => {
                if varied == Varied::Positions {
                    self.wrench.along.push((*place, weight));
                }
            }
            Scalar::Rate { coordinate, order } => {
                if (varied, *order) == (Varied::Speeds, 1) {
                    self.wrench.along.push((*coordinate, weight));
                }
            }
            Scalar::Negation(a) => self.add(*a, varied, -weight),
            Scalar::Sum(a, b) => {
                self.add(*a, varied, weight);
                self.add(*b, varied, weight);
            }
            Scalar::Difference(a, b) => {
                self.add(*a, varied, weight);
                self.add(*b, varied, -weight);
            }
            Scalar::Product(a, b) => {
                let (by_a, by_b) = (weight * of(b), weight * of(a));
                self.add(*a, varied, by_a);
                self.add(*b, varied, by_b);
            }
            Scalar::Quotient(a, b) => {
                let (by_a, by_b) = (weight / of(b), -(weight * value / of(b)));
                self.add(*a, varied, by_a);
                self.add(*b, varied, by_b);
            }
            Scalar::Power(a, _) | Scalar::Function(_, a) => {
                let slope = self.trace.slope(scalar, *a);
                self.add(*a, varied, weight * slope);
            }
            Scalar::Dot(a, b) => {
                let (by_a, by_b) = (scaled(weight, self.trace.vector(*b)), scaled(weight, self.trace.vector(*a)));
                self.add_vector(*a, varied, by_a);
                self.add_vector(*b, varied, by_b);
            }
            Scalar::Norm(a) => {
                let by_a = scaled(weight / value, self.trace.vector(*a));
                self.add_vector(*a, varied, by_a);
            }
            // the derivative of a position's rate with respect to the speeds equals that of the position with respect to the positions
            Scalar::RateOf(a) => {
                if varied == Varied::Speeds {
                    self.add(*a, Varied::Positions, weight);
                }
            }
        }
    }

    fn vector(&mut self, vector: &Form, varied: Varied, weight: Vector) {
        let of = |id: &VectorId| self.trace.vector(*id);
        let trace = self.trace;
        let opposite = || scaled(-Sym::ONE, weight);
        match (vector, varied) {
            (Form::Zero, _) => {}
            (Form::Axis { frame, axis }, Varied::Positions) => {
                let turned = trace.cross(Vector::axis(*frame, *axis), weight);
                self.torque(*frame, turned);
            }
            (Form::Between { from, to }, Varied::Positions) => {
                self.force(Material { body: None, point: *to }, weight);
                self.force(Material { body: None, point: *from }, opposite());
            }
            (Form::Negation(a), _) => self.add_vector(*a, varied, opposite()),
            (Form::Sum(a, b), _) => {
                self.add_vector(*a, varied, weight);
                self.add_vector(*b, varied, weight);
            }
            (Form::Difference(a, b), _) => {
                self.add_vector(*a, varied, weight);
                self.add_vector(*b, varied, opposite());
            }
            (Form::Scaled(scale, a), _) => {
                let by_scale = trace.dot(weight, of(a));
                self.add(*scale, varied, by_scale);
                self.add_vector(*a, varied, scaled(trace.scalar(*scale), weight));
            }
            (Form::Cross(a, b), _) => {
                let (by_a, by_b) = (trace.cross(of(b), weight), trace.cross(weight, of(a)));
                self.add_vector(*a, varied, by_a);
                self.add_vector(*b, varied, by_b);
            }
            (Form::Velocity { of, seen }, Varied::Speeds) => {
                self.force(*of, weight);
                let carried = trace.cross(trace.position(of.point), opposite());
                self.torque(*seen, carried);
            }
            (Form::AngularVelocity { of, seen }, Varied::Speeds) => {
                self.torque(*of, weight);
                self.torque(*seen, opposite());
            }
            (Form::RateOf { of: a, seen }, Varied::Speeds) => {
                self.add_vector(*a, Varied::Positions, weight);
                let carried = trace.cross(of(a), opposite());
                self.torque(*seen, carried);
            }
            // positions are constant when speeds vary; constraints of speeds are not differentiated by positions
            (
                Form::Axis { .. }
                | Form::Between { .. }
                | Form::Velocity { .. }
                | Form::AngularVelocity { .. }
                | Form::RateOf { .. }
                | Form::Acceleration { .. }
                | Form::Reaction { .. }
                | Form::JointForce(_)
                | Form::JointTorque(_),
                _,
            ) => {}
        }
    }
}

fn scaled(scale: Sym, vector: Vector) -> Vector {
    vector.map(|component| scale * component)
}
