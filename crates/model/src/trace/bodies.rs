//! Momenta and energies of bodies.
//!
//! A variable mass or moment of inertia is treated as constant at each instant (Meshchersky): the law is m a = F, and mass that
//! leaves or arrives acts by a force that the model must give. Until the equations are complete, a constant symbol replaces it.

use super::{Trace, Vector};
use crate::equations::vanishes;
use crate::{Body, FrameId, Inertia, ScalarId};
use symbolic::{Sym, substitute_all};

impl Trace<'_> {
    /// Returns the mass of a body, and velocity and acceleration of its centre of mass; `None` without a mass.
    pub fn carried(&self, body: &Body) -> Option<(Sym, Vector, Vector)> {
        let (mass, centre) = (body.mass?, body.centre?);
        Some((self.solidified(mass), self.velocity(centre), self.acceleration(centre)))
    }

    /// Returns a mass or moment of inertia; a constant symbol if it is variable.
    pub(crate) fn solidified(&self, id: ScalarId) -> Sym {
        let value = self.scalar(id);
        let moving =
            |symbol: &Sym| *symbol == self.time || self.coordinates.contains(symbol) || self.speeds.contains(symbol);
        if !value.symbols_of().iter().any(moving) {
            return value;
        }
        let mut known = self.solid.borrow_mut();
        if let Some((letter, _)) = known.iter().find(|(_, own)| *own == value) {
            return *letter;
        }
        let letter = Sym::symbol(&format!("solidified {}", known.len() + 1));
        known.push((letter, value));
        letter
    }

    /// Returns whether a mass or moment of inertia of any body is variable.
    pub(crate) fn varies(&self) -> bool {
        // evaluates all bodies, which registers the variable quantities
        self.kinetic_energy();
        !self.solid.borrow().is_empty()
    }

    /// Returns the variable masses and moments of inertia, as (symbol, value).
    pub fn solid(&self) -> Vec<(Sym, Sym)> {
        self.solid.borrow().clone()
    }

    /// Substitutes variable masses and moments of inertia by their values.
    pub(crate) fn with_masses(&self, expressions: &[Sym]) -> Vec<Sym> {
        match &self.solid()[..] {
            [] => expressions.to_vec(),
            solid => substitute_all(expressions, solid),
        }
    }

    /// Returns the inertia of a body and its angular velocity; `None` if it has no inertia or no frame.
    pub fn turned<'b>(&self, body: &'b Body) -> Option<(&'b Inertia, Vector)> {
        body.inertia.as_ref().zip(body.frame).map(|(inertia, frame)| (inertia, self.turning(frame)))
    }

    /// Returns whether an inertia tensor has equal moments about all axes.
    pub(crate) fn is_of_ball(&self, inertia: &Inertia) -> bool {
        let Inertia::Tensor { entries: [Some(xx), Some(yy), Some(zz), None, None, None], .. } = inertia else {
            return false;
        };
        let [xx, yy, zz] = [xx, yy, zz].map(|moment| self.scalar(*moment));
        xx == yy && yy == zz
    }

    /// Returns I v, along the axes of the inertia tensor; for equal moments along the axes of v.
    pub fn inertia_times(&self, inertia: &Inertia, vector: Vector) -> Vector {
        match inertia {
            Inertia::Axial(axial) => self.about_axis(*axial, 2, vector),
            Inertia::OfShaft { moment, axis } => self.about_axis(*moment, *axis, vector),
            Inertia::Tensor { entries: [Some(moment), ..], .. } if self.is_of_ball(inertia) => {
                let moment = self.solidified(*moment);
                vector.map(|component| moment * component)
            }
            Inertia::Tensor { axes, entries } => {
                let [x, y, z] = self.express(vector, *axes);
                let [xx, yy, zz, xy, xz, yz] =
                    entries.map(|entry| entry.map_or(Sym::ZERO, |entry| self.solidified(entry)));
                let components = [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z];
                Vector { frame: *axes, components }
            }
        }
    }

    fn about_axis(&self, moment: ScalarId, axis: usize, vector: Vector) -> Vector {
        let mut components = [Sym::ZERO; 3];
        components[axis] = self.solidified(moment) * vector.components[axis];
        Vector { frame: vector.frame, components }
    }

    /// Returns the names of bodies with an axial inertia that rotate about another axis than z.
    pub fn tilted(&self) -> Vec<&str> {
        let tilted = |body: &&Body| match (&body.inertia, body.frame) {
            (Some(Inertia::Axial(_)), Some(frame)) => {
                let [x, y, _] = self.turning(frame).components;
                (x, y) != (Sym::ZERO, Sym::ZERO)
            }
            _ => false,
        };
        self.model.bodies.iter().filter(tilted).map(|body| body.name.as_str()).collect()
    }

    /// Returns the kinetic energy of all bodies plus the given one, in J.
    pub fn kinetic_energy(&self) -> Sym {
        let half = Sym::constant(field::Rational::new(1, 2));
        let mut sum = self.model.energies.kinetic.map_or(Sym::ZERO, |kinetic| self.scalar(kinetic));
        for body in &self.model.bodies {
            if let Some((mass, velocity, _)) = self.carried(body) {
                sum += half * mass * self.dot(velocity, velocity);
            }
            if let Some((inertia, turning)) = self.turned(body) {
                sum += half * self.dot(turning, self.inertia_times(inertia, turning));
            }
        }
        sum
    }

    /// Returns the co-energy W'(i, q) of magnetic fields, in J.
    pub fn coenergy(&self) -> Sym {
        self.model.energies.coenergy.map_or(Sym::ZERO, |coenergy| self.scalar(coenergy))
    }

    /// Returns T + W', whose derivatives with respect to the speeds are momenta and magnetic fluxes.
    pub fn kinetic_and_coenergy(&self) -> Sym {
        self.kinetic_energy() + self.coenergy()
    }

    /// Returns psi' - dW'/dq for the flux psi = dW'/di: Faraday's law for a charge, the force of the magnetic field for a position, where psi = 0.
    pub(crate) fn induced(&self, speed: usize) -> Sym {
        let coenergy = self.coenergy();
        if coenergy == Sym::ZERO {
            return coenergy;
        }
        let flux = |i: usize| self.by_speed(coenergy, i);
        self.rate_of(flux(speed)) + self.transposition(speed, flux) - self.by_coordinate(coenergy, speed)
    }

    /// Returns whether T + W' is homogeneous of second degree in the speeds. If so, no body moves when all speeds are zero.
    pub fn has_quadratic_kinetic_energy(&self) -> bool {
        let kinetic = self.kinetic_and_coenergy();
        let moved = (0..self.speeds.len()).fold(Sym::ZERO, |sum, i| sum + self.by_speed(kinetic, i) * self.speeds[i]);
        vanishes(moved - kinetic - kinetic)
    }

    /// Returns the gravitational acceleration if it is constant in space and time; weights then have the potential energy -m g . r.
    pub fn uniform_gravity(&self) -> Option<Vector> {
        let gravity = self.vector(self.model.gravity?);
        let is_constant = |component: &Sym| self.rate_of(*component) == Sym::ZERO;
        (gravity.frame == FrameId::GROUND && gravity.components.iter().all(is_constant)).then_some(gravity)
    }

    /// Returns the potential energy of the weights of all bodies in uniform gravity.
    pub fn potential_of_weights(&self) -> Sym {
        let mut sum = Sym::ZERO;
        if let Some(gravity) = self.uniform_gravity() {
            for body in &self.model.bodies {
                if let (Some(mass), Some(centre)) = (body.mass, body.centre) {
                    sum -= self.solidified(mass) * self.dot(gravity, self.position(centre));
                }
            }
        }
        sum
    }

    /// Returns the potential energy: that of the weights of all bodies in uniform gravity, plus the given one.
    pub fn potential_energy(&self) -> Sym {
        let given = self.model.energies.potential.map_or(Sym::ZERO, |potential| self.scalar(potential));
        given + self.potential_of_weights()
    }
}
