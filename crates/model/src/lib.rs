//! A mechanical system as data (bodies, loads, constraints), and its equations of motion by every principle.
//!
//! # Overview
//! The crate is for programs that derive equations of motion. The example derives the equation of a pendulum.
//!
//! * [`Source`]: the text of a system, as keys whose values are expressions ([`expression`]);
//! * [`Model`]: the system after resolution of all names and a check of all dimensions. It owns its expressions and can be sent
//!   to other threads;
//! * [`Trace`]: the model over symbols, in the expression graph of one thread. Positions, velocities and accelerations are computed recursively,
//!   each in the frame in which its expression is short;
//! * [`principles`]: derivations of the equations of motion; each principle differentiates automatically.
//!
//! ```
//! use dalembert_model::{Model, Source, Trace, principles::Principle};
//!
//! let mut source = Source::default();
//! source.parameters = vec![("m", "2 kg").into(), ("l", "1 m").into(), ("g", "9.81 m/s^2").into()];
//! source.coordinates = vec![("theta", "rad").into()];
//! source.points = vec![("P", "O + l*(sin(theta)*N.x - cos(theta)*N.y)").into()];
//! source.bodies = vec![dalembert_model::BodySource::particle("bob", "P", "m")];
//! source.gravity = Some("-g*N.y".into());
//! let model = Model::of(&source).unwrap();
//! let left = symbolic::apart(|| Principle::Lagrange.residual(&Trace::of(&model)).unwrap()[0].to_string());
//! assert!(left.contains("theta''"));
//! ```

mod agreement;
mod arena;
mod closed_loop;
mod conformity;
mod constraint_gains;
mod divisors;
mod elaboration;
pub mod equations;
pub mod expression;
mod fault;
pub mod geometry;
mod joints;
mod judgements;
mod kept_contacts;
mod lengths_at_rest;
mod parts;
mod presentation;
pub mod principles;
mod quasi_velocities;
mod real_points;
mod source;
mod statements;
mod theorem;
mod trace;
mod values;
mod variations;
mod work;

pub use agreement::{Agreement, Projected, agreement, projected_agreement};
pub use arena::{Function, Number, ScalarId, VectorId};
pub use closed_loop::Feedback;
pub use conformity::{Pairs, forces_without_potential};
pub use elaboration::{HALF_TURN, bare_angle, is_reserved, misplaced};
pub use fault::Fault;
pub use judgements::{Judgement, Subject, judged_mistake, judgements};
pub use parts::{
    Along, Assignment, Body, BodyId, Constraint, Contact, Coordinate, Defined, Direction, Domain, DomainEnd, Energies,
    Event, Force, Frame, FrameId, GeneralisedForce, Implied, Inertia, Input, Material, Model, Moves, OneWay, Output,
    Parameter, Point, PointId, QuasiVelocity, Regulator, Restitution, Sides, StartSpeed, StartValue, Torque, Turn,
    UnsolvedLaw, Zero,
};
pub use presentation::{
    Cosine, DerivedVector, Divisor, HeldEquation, InQuasiVelocities, Lines, MatrixForm, Typeset, axes, casadi, code,
    code_from, conditions_by_name, constraints, derived_vectors, exchange, latex, left_out, modelica, shorter, sympy,
    text, titles, typeset, vectors,
};
pub use quasi_velocities::{Coefficient, INTEGRAL, QuasiPrinciple, QuasiVelocities, quasi_agreement};
pub use source::{
    BodySource, ConstraintSource, ContactSource, DriveSource, Entry, EventSource, FrameAngles, InertiaSource,
    InputSource, LoadSource, OneWaySource, RegulatorSource, Source, Text, WindingSource,
};
pub use statements::{Mistake, Mistaken, PowerBalance, Statement, kept_momenta, mistaken, statements};
pub use trace::{Trace, Vector, quaternion_rates, turned_further};
pub use variations::{Variations, Varied};
pub use work::{Work, forming};
