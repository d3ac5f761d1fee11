//! Motions in closed form, by which runs and reference solutions are checked.
//!
//! # Overview
//! * `volterra`: a gyrostat without weight whose free rotor lies along a principal axis (Zhukovskii 1885, Volterra 1899);
//! * `lagrange`: a heavy gyrostat with an axis of symmetry, the rotor and the weight along it (Lagrange's top);
//! * `unloaded`: a synchronous motor alone on a bench, without friction or load;
//! * each is an equation u'^2 = f(u), a [`Quadrature`], solved by [`Weierstrass`]' function; [`Scene::closed_form`]
//!   gives the closed form of a scene.

mod lagrange;
mod quadrature;
mod unloaded;
mod volterra;
mod weierstrass;

pub use quadrature::Quadrature;
pub use weierstrass::{Lattice, Weierstrass};

use crate::scene::state::principal;
use crate::scene::{Scene, Setup};
use field::Over;
use integrators::Real;
use nalgebra::Vector3;
use simulation::Axes;

/// The closed form of one function of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm<S> {
    /// The authors of the solution, and the function of the state.
    pub name: &'static str,
    shown: Shown,
    motion: Quadrature<S>,
}

/// The function of the state that a closed form gives.
#[derive(Clone, Debug, PartialEq)]
enum Shown {
    /// The component of a vector, whose components start at the index `first`, along a principal axis; `given` is this
    /// axis in the axes of the data.
    Along { first: usize, axis: Vector3<f64>, given: Vector3<f64> },
    /// The cosine of the state with this index.
    Cosine(usize),
}

/// A gyrostat in the principal axes of A, with its initial state.
struct Start<S> {
    moments: Vector3<S>,
    /// The rotor's axial moment of inertia A', kg m^2.
    axial: S,
    weight: Vector3<S>,
    w: Vector3<S>,
    v: Vector3<S>,
    rotor_speed: S,
    /// The index of the principal axis along the rotor; `sense` is its sign.
    along: usize,
    sense: S,
    /// The rotor's axis in the axes of the data.
    given: Vector3<f64>,
}

impl<S: Real> ClosedForm<S> {
    /// The value of the function at a state.
    pub fn shown(&self, state: &[S]) -> S {
        match &self.shown {
            Shown::Along { first, axis, .. } => component(&state[*first..], axis),
            Shown::Cosine(index) => state[*index].circle().cos,
        }
    }

    /// The function at a row of a run, whose vectors are in the axes of the data.
    pub fn shown_in_row(&self, row: &[S]) -> S {
        match &self.shown {
            Shown::Along { first, given, .. } => component(&row[*first..], given),
            Shown::Cosine(_) => self.shown(row),
        }
    }

    /// The value of the closed form at a time, s.
    pub fn at(&self, time: S) -> S {
        self.motion.at(time)
    }

    /// The period, s.
    pub fn period(&self) -> S {
        self.motion.period()
    }
}

fn component<S: Real>(vector: &[S], axis: &Vector3<f64>) -> S {
    (0..3).fold(S::zero(), |sum, i| sum + vector[i] * S::lift(axis[i]))
}

impl Scene {
    /// The closed form of this scene's motion, if one is known, for states in the axes of the first form.
    pub fn closed_form<S: Real>(&self) -> Option<ClosedForm<S>> {
        match (&self.system, self.machine.name()) {
            (Setup::Gyrostat(_), "free_rotor") => {
                let start = self.aligned()?;
                volterra::solution(&start).or_else(|| lagrange::solution(&start))
            }
            (Setup::Bench { axial }, "synchronous") if self.machine.datum("f") == Some(0.0) => {
                unloaded::solution(&self.machine, *axial, &self.start)
            }
            _ => None,
        }
    }

    /// The start, if the rotor lies along a principal axis.
    fn aligned<S: Real>(&self) -> Option<Start<S>> {
        let Setup::Gyrostat(bodies) = &self.system else { return None };
        let (moments, axis, axial, weight) = bodies.form_data(&principal(Axes::First, bodies));
        let along = axis.iamax();
        let off = (0..3).filter(|i| *i != along).map(|i| axis[i].abs()).fold(0.0, f64::max);
        let state: Vec<S> = self.state(Axes::First).into_iter().map(S::lift).collect();
        let lifted = |v: Vector3<f64>| v.map(<S as Over<f64>>::lift);
        (off <= f64::EPSILON).then(|| Start {
            moments: lifted(moments),
            axial: S::lift(axial),
            weight: lifted(weight),
            w: Vector3::new(state[0], state[1], state[2]),
            v: Vector3::new(state[3], state[4], state[5]),
            rotor_speed: state[6],
            along,
            sense: S::lift(axis[along].signum()),
            given: bodies.rotor.axis * axis[along].signum(),
        })
    }
}

impl<S: Real> Start<S> {
    /// The indices i, j, k of a right-handed frame with e_k along the rotor.
    fn indices(&self) -> [usize; 3] {
        [(self.along + 1) % 3, (self.along + 2) % 3, self.along]
    }

    /// The momentum of the rotor about its axis, along e_k: A' (w.l + phi') l.
    fn spin(&self) -> S {
        self.axial * (self.w[self.along] + self.sense * self.rotor_speed)
    }

    /// The component along e_k of the vector that starts at the index `first`.
    fn component(&self, first: usize) -> Shown {
        let mut axis = Vector3::zeros();
        axis[self.along] = 1.0;
        Shown::Along { first, axis, given: self.given }
    }
}
