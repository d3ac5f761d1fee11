//! Contacts: the gap, the sliding velocity, and the pair of forces on the two bodies.

use super::forces::Acted;
use super::loads::newton;
use super::{Elaborator, Sound};
use crate::arena::{Scalar, Vector};
use crate::equations::vanishes;
use crate::{
    BodyId, Contact, ContactSource, Fault, Force, FrameId, Material, PointId, Restitution, ScalarId, Sides, Text,
    Trace, VectorId,
};
use symbolic::{Dimension, Sym, apart};

const AGAINST: &str = "of = \"ladder at B\", through = \"O\", normal = \"N.y\"; or between = \"slider, N along x\"";

/// The plane, curve or guide that a point touches.
struct Plane {
    normal: VectorId,
    /// The body to which the plane belongs; `None` for the ground.
    body: Option<BodyId>,
    sides: Sides,
}

impl Elaborator<'_> {
    pub(super) fn contact(&mut self, place: usize, source: &ContactSource) -> Sound<Contact> {
        if let Some(name) = &source.name {
            self.contact_name_is_free(name)?;
        }
        let (of, mut plane) = match (&source.of, &source.between) {
            (Some(of), None) => (of.clone(), self.plane(source)?),
            (None, Some(between)) => {
                let (of, normal, body) = self.guide(between, source)?;
                (of, Plane { normal, body, sides: Sides::Both })
            }
            _ => return Err(refused(source, "a contact has one of `of` and `between`", "here")),
        };
        if let Some(sides) = &source.sides {
            plane.sides = sides_of(sides)?;
        }
        let Acted::Moving(on) = self.acted(&of)? else {
            let title = "a contact is one of a point that moves";
            return Err(Box::new(Fault::at(of.span(), title, "the ground is at rest", AGAINST)));
        };
        if on.body.is_none() && !self.source.bodies.is_empty() {
            self.model.warnings.push(Fault::at(
                of.span(),
                "this contact acts at a point of no body: its forces turn none",
                "a point that moves by itself",
                "a point of a body, of = \"ball at P\"; a body of its own, where it has a mass",
            ));
        }
        if on.body.is_some() && on.body == plane.body {
            let title = "a contact is one of two bodies, and this one touches itself";
            return Err(Box::new(Fault::at(of.span(), title, "the body that it touches too", AGAINST)));
        }
        if let Some(body) = plane.body {
            self.centre(body, &source.with.as_ref().map_or_else(|| source.at.clone(), Text::span))?;
        }
        let normal = self.unit_of(plane.normal);
        let beside = plane.body.map(|body| Material { body: Some(body), point: on.point });
        let (gap, through) = self.gap(source, &plane, on.point, normal)?;
        let speed = Some(Dimension::length() / Dimension::time());
        let seen = FrameId::GROUND;
        let mut velocity = self.vector(Vector::Velocity { of: on, seen }, speed);
        // a plane of the ground may move as a prescribed function of time
        let carried =
            beside.or_else(|| Some(Material { body: None, point: through.filter(|at| *at != PointId::ORIGIN)? }));
        if let Some(of) = carried {
            let carried = self.vector(Vector::Velocity { of, seen }, speed);
            velocity = self.vector(Vector::Difference(velocity, carried), speed);
        }
        let tangents = self.tangents(source.friction.is_some(), normal, velocity);
        let slides = tangents.iter().map(|&tangent| self.scalar(Scalar::Dot(velocity, tangent), speed)).collect();
        let friction = self.coefficient(source.friction.as_ref(), "the coefficient of friction")?;
        let restitution = self.coefficient(source.restitution.as_ref(), "the coefficient of restitution")?;
        if let (Some(text), Sides::Both) = (&source.restitution, plane.sides) {
            let title = "a contact that holds on both sides has no impacts";
            return Err(Box::new(Fault::at(text.span(), title, "a coefficient of them", "no `restitution` here")));
        }
        let law = law_of(source)?;
        let letter = |component| Scalar::Contact { contact: place, component };
        let reactions: Vec<ScalarId> =
            (0..=tangents.len()).map(|component| self.scalar(letter(component), Some(newton()))).collect();
        let axes: Vec<VectorId> = [normal].into_iter().chain(tangents.iter().copied()).collect();
        let acting = if friction.is_some() { reactions.len() } else { 1 };
        self.pair_of_forces(on, beside, &reactions[..acting], &axes);
        Ok(Contact {
            name: source.name.as_ref().map_or_else(String::new, |name| name.text.clone()),
            gap,
            one_way: None,
            drop: None,
            normal,
            velocity,
            slides,
            tangents,
            sides: plane.sides,
            reactions,
            reaction_unit: "N".to_owned(),
            friction,
            restitution,
            law,
            with: plane.body,
            point: on.point,
            through,
            friction_at: source.friction.as_ref().map_or_else(|| source.at.clone(), Text::span),
            restitution_at: source.restitution.as_ref().map_or_else(|| source.at.clone(), Text::span),
            is_line: source.between.is_some(),
            guide: None,
            is_touching: source.touching || plane.sides == Sides::Both,
            at: source.at.clone(),
        })
    }

    pub(super) fn contact_name_is_free(&self, name: &Text) -> Sound<()> {
        let is_taken = self.model.contacts.iter().any(|other| other.name == name.text)
            || self.model.constraints.iter().any(|other| other.name.as_ref() == Some(&name.text));
        if !is_taken {
            return Ok(());
        }
        let title = format!("`{}` is the name of another contact, or of a constraint", name.text);
        Err(Box::new(Fault::at(name.span(), title, "again", "a name of its own for each")))
    }

    /// Reads the plane of a contact that is defined by `of`.
    fn plane(&mut self, source: &ContactSource) -> Sound<Plane> {
        let Some(text) = &source.normal else {
            return Err(refused(source, "a contact has a normal", "`normal` is missing"));
        };
        let normal = self.vector_value(text, "the normal of a contact", None)?;
        if self.is_zero(normal) {
            let title = "the normal of a contact has a direction";
            return Err(Box::new(Fault::at(text.span(), title, "this vector is zero", "normal = \"N.y\"")));
        }
        let body = match &source.with {
            None => None,
            Some(with) if matches!(with.text.trim(), "ground" | "N") => None,
            Some(with) => Some(self.body(with)?),
        };
        Ok(Plane { normal, body, sides: Sides::One })
    }

    /// Returns the gap, in metres, and the point of the plane from which it is measured, if there is one.
    fn gap(
        &mut self,
        source: &ContactSource,
        plane: &Plane,
        point: PointId,
        normal: VectorId,
    ) -> Sound<(ScalarId, Option<PointId>)> {
        let through = match (&source.gap, &source.through) {
            (Some(gap), None) => {
                let found = self.scalar_value(gap, "the gap of a contact", Some(Dimension::length()))?;
                if self.orders.of(found.0).is_some_and(|order| order > 0) {
                    let title = "the gap of a contact is a length by positions";
                    let accepted = "coordinates and the time: gap = \"y - a*x^2\"";
                    return Err(Box::new(Fault::at(gap.span(), title, "a speed stands in it", accepted)));
                }
                return Ok((found, None));
            }
            (Some(gap), Some(_)) => {
                let title = "a contact has one of `through` and `gap`";
                return Err(Box::new(Fault::at(gap.span(), title, "both stand here", AGAINST)));
            }
            (None, Some(through)) => self.point(through)?,
            (None, None) => match plane.body {
                None if source.between.is_some() => PointId::ORIGIN,
                Some(body) if source.between.is_some() => self.centre(body, &source.at)?,
                _ => {
                    return Err(refused(
                        source,
                        "a contact has a point of the plane, or a gap",
                        "`through` is missing",
                    ));
                }
            },
        };
        let away = self.between(through, point);
        Ok((self.scalar(Scalar::Dot(away, normal), Some(Dimension::length())), Some(through)))
    }

    fn coefficient(&mut self, text: Option<&Text>, what: &str) -> Sound<Option<ScalarId>> {
        text.map(|text| self.scalar_value(text, what, Some(Dimension::none()))).transpose()
    }

    /// Returns whether a vector is zero in every position.
    fn is_zero(&self, vector: VectorId) -> bool {
        let model = &self.model;
        self.faults.is_empty()
            && apart(|| {
                let components = Trace::of(model).vector(vector).components;
                components.into_iter().all(|component| component == Sym::ZERO || vanishes(component))
            })
    }

    /// Adds the contact force N n + T t (in space N n + T1 t1 + T2 t2) on a point of one body, and its reaction at the coincident point of the other body.
    fn pair_of_forces(&mut self, on: Material, beside: Option<Material>, reactions: &[ScalarId], axes: &[VectorId]) {
        let newton = Some(newton());
        let is = self.along_axes(reactions, axes, newton);
        self.model.forces.push(Force::On { at: on, is });
        if let Some(at) = beside {
            let is = self.vector(Vector::Negation(is), newton);
            self.model.forces.push(Force::On { at, is });
        }
    }
}

fn refused(source: &ContactSource, title: &str, label: &str) -> Box<Fault> {
    Box::new(Fault::at(source.at.clone(), title, label, AGAINST))
}

fn sides_of(text: &Text) -> Sound<Sides> {
    match text.text.trim() {
        "one" => Ok(Sides::One),
        "both" => Ok(Sides::Both),
        _ => {
            let title = "a contact reacts on one side or on both";
            Err(Box::new(Fault::at(text.span(), title, "neither", "sides = \"one\", sides = \"both\"")))
        }
    }
}

fn law_of(source: &ContactSource) -> Sound<Restitution> {
    let Some(text) = &source.impact else { return Ok(Restitution::default()) };
    match text.text.trim() {
        // Moreau's law also applies to contacts that are already closed
        "moreau" => Ok(Restitution::Moreau),
        "newton" => Ok(Restitution::Newton),
        "poisson" => Ok(Restitution::Poisson),
        _ => Err(Box::new(Fault::at(
            text.span(),
            "the law of restitution is Newton's, Poisson's or Moreau's",
            "not one of these",
            "impact = \"newton\", impact = \"poisson\", impact = \"moreau\"",
        ))),
    }
}
