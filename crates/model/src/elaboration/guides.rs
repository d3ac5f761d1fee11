//! Guides: a body slides along an axis of a frame.

use super::{Elaborator, Sound};
use crate::arena::Vector;
use crate::{BodyId, ContactSource, Fault, FrameId, Text, Trace, VectorId};
use symbolic::{Dimension, Sym, apart};

const GUIDE: &str = "between = \"slider, N along x\": a body, and an axis of a frame";

/// The text `slider, N along x` in its parts: body, frame and axis.
pub(super) struct Guide {
    pub body: Text,
    pub frame: Text,
    /// The axis x (0) or y (1) of the frame.
    axis: usize,
}

impl Guide {
    /// Splits a text into its parts. The error is the reason for a message.
    pub fn of(between: &Text) -> Result<Self, &'static str> {
        let (body, rest) = between.text.split_once(',').ok_or("no comma")?;
        let (frame, axis) = rest.split_once(" along ").ok_or("no axis")?;
        let axis = ["x", "y"].iter().position(|name| *name == axis.trim()).ok_or("x and y are the axes of a plane")?;
        let first = body.len() + 1 + frame.len() - frame.trim_start().len();
        let frame = between.slice(first..first + frame.trim().len());
        Ok(Guide { body: between.slice(0..body.trim_end().len()), frame, axis })
    }

    /// Returns the normal of the guide as a text: y for the axis x, -x for the axis y.
    pub fn normal(&self) -> String {
        let frame = if self.frame.text == "ground" { "N" } else { &self.frame.text };
        match self.axis {
            0 => format!("{frame}.y"),
            _ => format!("-{frame}.x"),
        }
    }
}

impl Elaborator<'_> {
    /// Returns the body in a guide, the normal vector of the guide, and the body to which the guide belongs.
    pub(super) fn guide(&mut self, between: &Text, source: &ContactSource) -> Sound<(Text, VectorId, Option<BodyId>)> {
        for (key, text) in [("normal", &source.normal), ("with", &source.with)] {
            if let Some(text) = text {
                let title = "`between` names the body that has the guide, and its axis";
                return Err(Box::new(Fault::at(text.span(), title, format!("a guide has no `{key}`"), GUIDE)));
            }
        }
        let guide = Guide::of(between)
            .map_err(|label| Box::new(Fault::at(between.span(), "a guide is read differently", label, GUIDE)))?;
        let (frame, body) = match guide.frame.text.as_str() {
            "ground" | "N" => (FrameId::GROUND, None),
            _ => {
                let frame = self.frame(&guide.frame)?;
                (frame, self.carrier(frame, &guide.frame)?)
            }
        };
        let across = self.vector(Vector::Axis { frame, axis: 1 - guide.axis }, Some(Dimension::none()));
        let normal = match guide.axis {
            0 => across,
            _ => self.vector(Vector::Negation(across), Some(Dimension::none())),
        };
        Ok((guide.body, normal, body))
    }

    /// Returns the body on which the reaction of a guide acts, given the frame of the guide; `None` if the frame belongs to the ground or moves as a function of time only.
    fn carrier(&self, frame: FrameId, name: &Text) -> Sound<Option<BodyId>> {
        if let Some(super::Named::Body(body)) = self.names.get(name.text.trim()) {
            return Ok(Some(*body));
        }
        let mut found = (0..self.model.bodies.len()).filter(|&body| self.model.bodies[body].frame == Some(frame));
        match (found.next(), found.count()) {
            (Some(body), 0) => Ok(Some(BodyId(body))),
            (None, _) if !self.turns_with_coordinates(frame) => Ok(None),
            (first, others) => {
                let count = others + usize::from(first.is_some());
                let title = format!("the reaction of this guide acts on a body, and {count} turn with `{}`", name.text);
                let accepted = "the name of a body in the place of the frame";
                Err(Box::new(Fault::at(name.span(), title, "which body?", accepted)))
            }
        }
    }

    /// Returns whether the orientation of a frame depends on coordinates.
    fn turns_with_coordinates(&self, frame: FrameId) -> bool {
        let model = &self.model;
        apart(|| {
            let trace = Trace::of(model);
            let moves =
                |component: Sym| (0..trace.speeds.len()).any(|speed| trace.by_speed(component, speed) != Sym::ZERO);
            trace.turning(frame).components.into_iter().any(moves)
        })
    }
}
