//! Orders of time derivatives that a law does not allow. Points, potential energies and angles of rotation may depend on coordinates and time only. Constraints,
//! loads, masses and other energies may also depend on speeds, but not on accelerations, which would change the mass matrix.

use super::Elaborator;
use super::orders::{ACCELERATIONS, Orders, SPEEDS};
use crate::{Constraint, Fault, Force, Inertia, ScalarId, Text, Torque, Turn, VectorId, Zero};
use std::ops::Range;

/// An expression with a bound of the order of its time derivatives.
struct Bounded {
    what: String,
    order: Option<usize>,
    /// The highest allowed order.
    most: usize,
    span: Option<Range<usize>>,
}

impl Bounded {
    fn fault(self) -> Option<Fault> {
        let order = self.order.filter(|order| *order > self.most)?;
        let accepted = match self.most {
            0 => "coordinates and the time; speeds stand in forces and constraints",
            _ => "coordinates, speeds and the time",
        };
        let held = if order < ACCELERATIONS { "speeds" } else { "accelerations" };
        Some(Fault::at(self.span.unwrap_or(0..0), format!("{} holds {held}", self.what), "this", accepted))
    }
}

/// The fault of an energy that holds accelerations, of whichever dimension it is.
pub(super) fn accelerated(energy: &str, order: Option<usize>, span: Range<usize>) -> Option<Fault> {
    let order = order.filter(|order| *order >= ACCELERATIONS);
    let most = if energy == "potential" { 0 } else { SPEEDS };
    Bounded { what: called(energy), order, most, span: Some(span) }.fault()
}

/// Returns the highest order in some nodes.
fn highest(orders: &Orders, ids: &[ScalarId]) -> Option<usize> {
    ids.iter().filter_map(|id| orders.of(id.0)).max()
}

/// Returns the moments and products of inertia of a body.
pub(super) fn moments(body: &crate::Body) -> Vec<ScalarId> {
    match &body.inertia {
        None => Vec::new(),
        Some(Inertia::Axial(moment) | Inertia::OfShaft { moment, .. }) => vec![*moment],
        Some(Inertia::Tensor { entries, .. }) => entries.iter().flatten().copied().collect(),
    }
}

impl Elaborator<'_> {
    /// Reports orders that a law does not allow. Only the first affected group is reported (angles of frames, then points, laws, loads), since it may cause the others.
    pub(super) fn rates(&mut self) {
        if !self.faults.is_empty() || !self.headless.is_empty() {
            return;
        }
        let orders = &self.orders;
        let groups = [self.angles(orders), self.ways(orders), self.laws(orders), self.acting(orders)];
        let faults = groups.map(|group| group.into_iter().filter_map(Bounded::fault).collect::<Vec<Fault>>());
        let first = faults.into_iter().find(|group| !group.is_empty());
        let (solidified, weightless) = (self.solidified(orders), self.weightless(orders));
        self.faults.extend(first.unwrap_or_default());
        self.model.warnings.extend(solidified.into_iter().chain(weightless));
    }

    /// Returns the position of the text that defines a name.
    fn written(&self, name: &str) -> Option<Range<usize>> {
        let entries = [&self.source.points, &self.source.frames, &self.source.definitions];
        let entry = entries.into_iter().flatten().find(|entry| entry.name.text == name).map(|entry| &entry.value);
        let turns = self.source.bodies.iter().find(|body| body.name.text == name).and_then(|body| body.turns.as_ref());
        entry.or(turns).map(Text::span)
    }

    /// Returns warnings about masses and moments of inertia that depend on coordinates or speeds.
    fn solidified(&self, orders: &Orders) -> Vec<Fault> {
        let varies = |body: &&crate::Body| {
            let mass = body.mass.and_then(|mass| orders.of(mass.0));
            let inertia = highest(orders, &moments(body));
            mass.or(inertia).is_some()
        };
        let warning = |body: &crate::Body| {
            let title = format!(
                "the inertia of `{}` depends on the motion: its law is m a = F, as if it were solid at each instant",
                body.name
            );
            let mass = body.mass.and_then(|mass| orders.of(mass.0));
            let at = if mass.is_some() { body.mass_at.clone() } else { body.inertia_at.clone() };
            let accepted =
                "a force of its own for what arrives or leaves; or [energies] kinetic, for the law of Lagrange";
            Fault::at(at, title, "no term in the rate of the mass", accepted)
        };
        self.model.bodies.iter().filter(varies).map(warning).collect()
    }

    /// Returns warnings about bodies with inertia and a moving centre of mass, but without mass.
    fn weightless(&self, orders: &Orders) -> Vec<Fault> {
        let moves = |body: &&crate::Body| {
            let centre = body.centre.and_then(|centre| orders.of_point(&self.model, centre));
            body.mass.is_none() && body.inertia.is_some() && centre.is_some()
        };
        let warning = |body: &crate::Body| {
            let title = format!("the body `{}` has an inertia, a centre that moves, and no mass", body.name);
            let accepted = "`mass`; without `centre` the inertia alone is meant";
            Fault::at(body.at.clone(), title, "it has no weight, and its centre no inertia", accepted)
        };
        self.model.bodies.iter().filter(moves).map(warning).collect()
    }

    fn angles(&self, orders: &Orders) -> Vec<Bounded> {
        let of = |frame: &crate::Frame| {
            let Some((_, Turn::About { angle, .. })) = frame.parent else { return None };
            let what = format!("the angle of `{}`", frame.name);
            Some(Bounded { what, order: orders.of(angle.0), most: 0, span: self.written(&frame.name) })
        };
        self.model.frames.iter().filter_map(of).collect()
    }

    fn ways(&self, orders: &Orders) -> Vec<Bounded> {
        let of = |point: &crate::Point| {
            let (_, way) = point.base?;
            let what = if point.name.is_empty() { "a point".to_owned() } else { format!("the point `{}`", point.name) };
            Some(Bounded { what, order: orders.of(way.0), most: 0, span: self.written(&point.name) })
        };
        self.model.points.iter().filter_map(of).collect()
    }

    /// Returns the bounds for gravity, forces and torques.
    fn acting(&self, orders: &Orders) -> Vec<Bounded> {
        let model = &self.model;
        let at_places = model.forces.iter().map(|force| match force {
            Force::On { is, .. } => is.0,
            Force::Between { is, .. } => is.0,
        });
        let along = model.generalised.iter().map(|force| force.is.0);
        let torques = model.torques.iter().map(|(Torque::On { is, .. } | Torque::Between { is, .. })| is.0);
        let written = |is_along: bool| self.source.forces.iter().filter(move |load| load.along.is_some() == is_along);
        let forces = at_places.zip(written(false)).chain(along.zip(written(true)));
        let forces = forces.map(|(part, load)| ("a force", part, load.is.span()));
        let torques = torques.zip(&self.source.torques).map(|(part, load)| ("a torque", part, load.is.span()));
        let gravity = model.gravity.map(|gravity| gravity.0).zip(self.source.gravity.as_ref());
        let gravity = gravity.map(|(part, text)| ("gravity", part, text.span()));
        let bounded = |(what, part, span): (&str, usize, Range<usize>)| Bounded {
            what: what.to_owned(),
            order: orders.of(part),
            most: 1,
            span: Some(span),
        };
        forces.chain(torques).chain(gravity).map(bounded).collect()
    }

    /// Returns the bounds for energies, constraints, quasi-velocities, masses and moments of inertia.
    fn laws(&self, orders: &Orders) -> Vec<Bounded> {
        let model = &self.model;
        let highest = |ids: &[ScalarId]| highest(orders, ids);
        let energies = [
            ("potential", model.energies.potential, 0),
            ("kinetic", model.energies.kinetic, 1),
            ("dissipation", model.energies.dissipation, 1),
            ("coenergy", model.energies.coenergy, 1),
        ];
        let energies = energies.into_iter().map(|(name, given, most)| {
            let entry = self.source.energies.iter().find(|entry| entry.name.text == name);
            let order = given.and_then(|id| orders.of(id.0));
            Bounded { what: called(name), order, most, span: entry.map(|entry| entry.value.span()) }
        });
        let constraints = model.constraints.iter().map(|Constraint { zero, gains, at, .. }| {
            let (Zero::Scalar(ScalarId(zero)) | Zero::Vector(VectorId(zero))) = zero;
            let order = orders.of(*zero).max(highest(gains.as_deref().unwrap_or_default()));
            Bounded { what: "a constraint".to_owned(), order, most: 1, span: Some(at.clone()) }
        });
        let speeds = model.quasi_velocities.iter().map(|speed| {
            let entry = self.source.speeds.iter().find(|entry| entry.name.text == speed.name);
            let what = format!("the quasi-velocity `{}`", speed.name);
            let order = orders.of(speed.is.0);
            Bounded { what, order, most: 1, span: entry.map(|entry| entry.value.span()) }
        });
        let bodies = model.bodies.iter().map(|body| {
            let order = highest(&moments(body)).max(body.mass.and_then(|mass| orders.of(mass.0)));
            Bounded { what: format!("the inertia of `{}`", body.name), order, most: 1, span: Some(body.at.clone()) }
        });
        energies.chain(constraints).chain(speeds).chain(bodies).collect()
    }
}

/// Returns the name of an energy in sentences.
pub(super) fn called(energy: &str) -> String {
    match energy {
        "coenergy" => "the co-energy".to_owned(),
        "dissipation" => "the dissipation".to_owned(),
        other => format!("the {other} energy"),
    }
}
