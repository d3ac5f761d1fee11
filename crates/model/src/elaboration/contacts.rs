//! Contacts: the gap, the sliding velocity, and the pair of forces that they put on bodies.

use super::forces::Acted;
use super::loads::newton;
use super::value::Value;
use super::{Elaborator, Sound};
use crate::arena::{Scalar, Vector};
use crate::equations::vanishes;
use crate::{
    Contact, ContactSource, Fault, Force, FrameId, Material, Model, PointId, ScalarId, Sides, Text, Trace, VectorId,
};
use symbolic::{Dimension, Sym, apart};

const GUIDE: &str = "between = \"slider, N along x\": a body, and an axis of a frame";
const AGAINST: &str = "of = \"ladder at B\", through = \"O\", normal = \"N.y\"; or between = \"slider, N along x\"";

/// The second body of a contact.
#[derive(Clone, Copy)]
enum Other {
    Ground,
    Body(crate::BodyId),
}

/// Refuses friction where the motion of a contact leaves the plane, or its normal does.
pub(super) fn planar(model: &Model) -> Result<(), Vec<Fault>> {
    let spatial: Vec<usize> = apart(|| {
        let trace = Trace::of(model);
        let up = crate::Vector::axis(FrameId::GROUND, 2);
        let leaves = |vector: VectorId| {
            let along = trace.dot(trace.vector(vector), up);
            along != Sym::ZERO && !vanishes(along)
        };
        let is_spatial =
            |contact: &Contact| contact.friction.is_some() && (leaves(contact.normal) || leaves(contact.velocity));
        (0..model.contacts.len()).filter(|place| is_spatial(&model.contacts[*place])).collect()
    });
    let fault = |place: usize| {
        let contact = &model.contacts[place];
        let title = format!("friction in space is not there yet: {} leaves the plane of x and y", contact.title(place));
        Fault::at(
            contact.at.clone(),
            title,
            "not there yet",
            "a contact without `friction`; or a motion in the plane of N.x and N.y",
        )
    };
    if spatial.is_empty() { Ok(()) } else { Err(spatial.into_iter().map(fault).collect()) }
}

impl Elaborator<'_> {
    pub(super) fn contact(&mut self, place: usize, source: &ContactSource) -> Sound<Contact> {
        let refused = |title: &str, label: &str| Err(Box::new(Fault::at(source.at.clone(), title, label, AGAINST)));
        let name = source.name.as_ref().map_or_else(String::new, |name| name.text.clone());
        if let Some(name) = &source.name
            && (self.model.contacts.iter().any(|other| other.name == name.text)
                || self.model.constraints.iter().any(|other| other.name.as_ref() == Some(&name.text)))
        {
            let title = format!("`{}` is the name of another contact, or of a constraint", name.text);
            return Err(Box::new(Fault::at(name.span(), title, "again", "a name of its own for each")));
        }
        let (of, normal, other, sides) = match (&source.of, &source.between) {
            (Some(of), None) => {
                let Some(normal) = &source.normal else {
                    return refused("a contact has a normal", "`normal` is missing");
                };
                let normal = self.vector_value(normal, "the normal of a contact", None)?;
                let other = match &source.with {
                    None => Other::Ground,
                    Some(with) if matches!(with.text.trim(), "ground" | "N") => Other::Ground,
                    Some(with) => Other::Body(self.body(with)?),
                };
                (of.clone(), normal, other, Sides::One)
            }
            (None, Some(between)) => {
                if let Some(normal) = &source.normal {
                    let title = "a guide has the normal of its axis";
                    return Err(Box::new(Fault::at(normal.span(), title, "a second one", GUIDE)));
                }
                let (body, normal, other) = self.guide(between)?;
                (body, normal, other, Sides::Both)
            }
            _ => return refused("a contact has one of `of` and `between`", "here"),
        };
        let sides = match source.sides.as_ref().map(|sides| (sides, sides.text.trim())) {
            None => sides,
            Some((_, "one")) => Sides::One,
            Some((_, "both")) => Sides::Both,
            Some((sides, _)) => {
                let title = "a contact reacts on one side or on both";
                return Err(Box::new(Fault::at(sides.span(), title, "neither", "sides = \"one\", sides = \"both\"")));
            }
        };
        let Acted::Moving(on) = self.acted(&of)? else {
            let title = "a contact is one of a point that moves";
            return Err(Box::new(Fault::at(of.span(), title, "the ground is at rest", AGAINST)));
        };
        let normal = self.unit_of(normal);
        let up = self.vector(Vector::Axis { frame: FrameId::GROUND, axis: 2 }, Some(Dimension::none()));
        let tangent = self.vector(Vector::Cross(normal, up), Some(Dimension::none()));
        let beside = match other {
            Other::Ground => None,
            Other::Body(body) => Some(Material { body: Some(body), point: on.point }),
        };
        let gap = match (&source.gap, &source.through) {
            (Some(gap), None) => self.scalar_value(gap, "the gap of a contact", Some(Dimension::length()))?,
            (Some(gap), Some(_)) => {
                let title = "a contact has one of `through` and `gap`";
                return Err(Box::new(Fault::at(gap.span(), title, "both stand here", AGAINST)));
            }
            (None, through) => {
                let through = match (through, other) {
                    (Some(through), _) => self.point(through)?,
                    (None, Other::Ground) if source.between.is_some() => PointId::ORIGIN,
                    (None, Other::Body(body)) if source.between.is_some() => self.centre(body, &source.at)?,
                    _ => return refused("a contact has a point of the plane, or a gap", "`through` is missing"),
                };
                let away = self.between(through, on.point);
                self.scalar(Scalar::Dot(away, normal), Some(Dimension::length()))
            }
        };
        let speed = Dimension::length() / Dimension::time();
        let seen = FrameId::GROUND;
        let mut velocity = self.vector(Vector::Velocity { of: on, seen }, Some(speed));
        if let Some(of) = beside {
            let carried = self.vector(Vector::Velocity { of, seen }, Some(speed));
            velocity = self.vector(Vector::Difference(velocity, carried), Some(speed));
        }
        let slide = self.scalar(Scalar::Dot(velocity, tangent), Some(speed));
        let number = |elaborator: &mut Self, text: &Option<Text>, what: &str| match text {
            Some(text) => elaborator.scalar_value(text, what, Some(Dimension::none())).map(Some),
            None => Ok(None),
        };
        let friction = number(self, &source.friction, "the coefficient of friction")?;
        let restitution = number(self, &source.restitution, "the coefficient of restitution")?;
        let reactions: [ScalarId; 2] =
            std::array::from_fn(|component| self.scalar(Scalar::Contact { contact: place, component }, Some(newton())));
        self.pair_of_forces(on, beside, reactions, [normal, tangent], friction.is_some());
        let is_touching = source.touching || sides == Sides::Both;
        let (point, at) = (on.point, source.at.clone());
        let guide = None;
        Ok(Contact {
            name,
            gap,
            normal,
            velocity,
            slide,
            sides,
            reactions,
            friction,
            restitution,
            point,
            guide,
            is_touching,
            at,
        })
    }

    /// N n + T t on a point of a body, and the opposite on the same place of the other one.
    fn pair_of_forces(
        &mut self,
        on: Material,
        beside: Option<Material>,
        reactions: [ScalarId; 2],
        axes: [VectorId; 2],
        is_rough: bool,
    ) {
        let newton = Some(newton());
        let mut is = self.vector(Vector::Scaled(reactions[0], axes[0]), newton);
        if is_rough {
            let along = self.vector(Vector::Scaled(reactions[1], axes[1]), newton);
            is = self.vector(Vector::Sum(is, along), newton);
        }
        self.model.forces.push(Force::On { at: on, is });
        if let Some(at) = beside {
            let is = self.vector(Vector::Negation(is), newton);
            self.model.forces.push(Force::On { at, is });
        }
    }

    /// `slider, N along x`: the body, the normal of the axis in the plane, and whose axis it is.
    fn guide(&mut self, between: &Text) -> Sound<(Text, VectorId, Other)> {
        let fault = |label: &str| Err(Box::new(Fault::at(between.span(), "a guide is read differently", label, GUIDE)));
        let Some((body, rest)) = between.text.split_once(',') else { return fault("no comma") };
        let Some((frame, axis)) = rest.split_once(" along ") else { return fault("no axis") };
        let axis = match axis.trim() {
            "x" => 0,
            "y" => 1,
            _ => return fault("x and y are the axes of a plane"),
        };
        let first = body.len() + 1 + frame.len() - frame.trim_start().len();
        let named = between.slice(first..first + frame.trim().len());
        let (frame, other) = match named.text.as_str() {
            "ground" | "N" => (FrameId::GROUND, Other::Ground),
            _ => {
                let frame = self.frame(&named)?;
                (frame, Other::Body(self.carrier(frame, &named)?))
            }
        };
        // x has the normal y, y the normal -x
        let across = self.vector(Vector::Axis { frame, axis: 1 - axis }, Some(Dimension::none()));
        let normal = match axis {
            0 => across,
            _ => self.vector(Vector::Negation(across), Some(Dimension::none())),
        };
        Ok((between.slice(0..body.trim_end().len()), normal, other))
    }

    /// The body on which a guide that is fixed in a frame acts.
    fn carrier(&self, frame: FrameId, name: &Text) -> Sound<crate::BodyId> {
        let carries = |body: &&usize| self.model.bodies[**body].frame == Some(frame);
        let bodies: Vec<usize> = (0..self.model.bodies.len()).collect();
        let found: Vec<&usize> = bodies.iter().filter(carries).collect();
        match found.as_slice() {
            [body] => Ok(crate::BodyId(**body)),
            _ => {
                let title =
                    format!("the reaction of this guide acts on a body, and {} turn with `{}`", found.len(), name.text);
                let accepted = "the name of a body in the place of the frame";
                Err(Box::new(Fault::at(name.span(), title, "which body?", accepted)))
            }
        }
    }

    /// A vector over its length; an axis as it is.
    fn unit_of(&mut self, vector: VectorId) -> VectorId {
        let is_axis = |of: VectorId| matches!(self.model.arena.vector_at(of), Some(Vector::Axis { .. }));
        let is_unit = match self.model.arena.vector_at(vector) {
            Some(Vector::Negation(of)) => is_axis(*of),
            _ => is_axis(vector),
        };
        if is_unit {
            return vector;
        }
        match self.length(&(0..0), true, Value::Vector(vector)) {
            Ok(Value::Vector(unit)) => unit,
            _ => vector,
        }
    }
}
