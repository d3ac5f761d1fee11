//! Forces and torques: on one point or body, or with opposite signs on two.

use super::loads::{joule, newton};
use super::{Elaborator, Named, Sound, TARGET, TORQUE, Value, mismatch};
use crate::arena::{Scalar, Vector};
use crate::{Fault, Force, LoadSource, Material, PointId, ScalarId, Text, Torque, VectorId};
use symbolic::Dimension;

/// The target of a force.
pub(super) enum Acted {
    Moving(Material),
    /// A point of the ground. It determines the line of action; the reaction on it does no work.
    Ground(PointId),
}

impl Elaborator<'_> {
    /// Returns the value of `on` (as `Ok`) or of `between` (as `Err`); exactly one of them must be present.
    fn places<'a>(&self, load: &'a LoadSource, kind: &str) -> Sound<Result<&'a Text, &'a [Text; 2]>> {
        let accepted = match kind {
            "force" => "on = \"disc at P\", or between = [\"a at P\", \"b at Q\"], in [[force]]",
            _ => "on = \"disc\", or between = [\"ground\", \"disc\"], in [[torque]]",
        };
        let fault = |title: String, label: &str| Err(Box::new(Fault::at(load.at.clone(), title, label, accepted)));
        match (&load.on, &load.between) {
            (Some(on), None) => Ok(Ok(on)),
            (None, Some(between)) => Ok(Err(between)),
            (None, None) => fault(format!("a {kind} acts on something"), "neither `on` nor `between`"),
            (Some(_), Some(_)) => {
                fault(format!("a {kind} acts on one thing or between two"), "both `on` and `between`")
            }
        }
    }

    pub(super) fn force(&mut self, load: &LoadSource) -> Sound<Force> {
        let on_ground = |text: &Text| {
            let accepted = "on = \"disc at P\", or between = [\"ground at O\", \"disc at P\"]";
            Err(Box::new(Fault::at(
                text.span(),
                "a force on the ground moves nothing",
                "the ground is at rest",
                accepted,
            )))
        };
        match self.places(load, "force")? {
            Ok(on) => {
                let Acted::Moving(at) = self.acted(on)? else { return on_ground(on) };
                Ok(Force::On { at, is: self.vector_value(&load.is, "the force on a point", Some(newton()))? })
            }
            Err([first, second]) => {
                let acted = match (self.acted(first), self.acted(second)) {
                    (Ok(first), Ok(second)) => (first, second),
                    (Ok(_), Err(fault)) => return Err(fault),
                    (Err(fault), other) => {
                        self.kept(other);
                        return Err(fault);
                    }
                };
                let is = self.scalar_value(&load.is, "the force between two points", Some(newton()))?;
                let apart = |a: PointId, b: PointId| match a == b {
                    true => {
                        let accepted = "two points that are apart: the force acts along the line between them";
                        let title = "a force acts between two points, and these are one";
                        Err(Box::new(Fault::at(second.span(), title, "the point before", accepted)))
                    }
                    false => Ok(()),
                };
                match acted {
                    (Acted::Ground(_), Acted::Ground(_)) => on_ground(second),
                    (Acted::Ground(ground), Acted::Moving(at)) | (Acted::Moving(at), Acted::Ground(ground)) => {
                        apart(ground, at.point)?;
                        Ok(Force::On { at, is: self.away(ground, at.point, is) })
                    }
                    (Acted::Moving(first), Acted::Moving(second)) => {
                        apart(first.point, second.point)?;
                        Ok(Force::Between { points: [first, second], is })
                    }
                }
            }
        }
    }

    /// Returns a vector of magnitude `size` along the line from one point to another.
    fn away(&mut self, from: PointId, to: PointId, size: ScalarId) -> VectorId {
        let Some(dimension) = self.dimension_of(size.0) else { return self.vector(Vector::Zero, None) };
        let line = self.between(from, to);
        let length = self.scalar(Scalar::Norm(line), Some(Dimension::length()));
        let share = self.scalar(Scalar::Quotient(size, length), Some(dimension / Dimension::length()));
        self.vector(Vector::Scaled(share, line), Some(dimension))
    }

    pub(super) fn torque(&mut self, load: &LoadSource) -> Sound<Torque> {
        match self.places(load, "torque")? {
            Ok(on) => {
                let frame = self.turning_frame(on)?;
                if frame == crate::FrameId::GROUND {
                    let accepted = "on = \"disc\", or between = [\"ground\", \"disc\"]";
                    let title = "a torque on the ground moves nothing";
                    return Err(Box::new(Fault::at(on.span(), title, "the ground is at rest", accepted)));
                }
                Ok(Torque::On { frame, is: self.vector_value(&load.is, TORQUE, Some(joule()))? })
            }
            Err([first, second]) => {
                let frames = [self.turning_frame(first)?, self.turning_frame(second)?];
                if frames[0] == frames[1] {
                    let accepted = "two bodies or frames that turn against each other";
                    let title = "a torque acts between two bodies, and these turn together";
                    return Err(Box::new(Fault::at(second.span(), title, "the frame before", accepted)));
                }
                Ok(Torque::Between { frames, is: self.vector_value(&load.is, TORQUE, Some(joule()))? })
            }
        }
    }

    /// Returns the frame of a name or body. A point of a body is an error, since a torque acts on the whole body.
    pub(super) fn turning_frame(&self, text: &Text) -> Sound<crate::FrameId> {
        if let Some((body, _)) = text.text.split_once(" at ") {
            let title = "a torque acts on a body as a whole, at no point of it";
            let accepted = format!("\"{}\"", body.trim());
            return Err(Box::new(Fault::at(text.span(), title, "a point stands here", accepted)));
        }
        self.frame(text)
    }

    /// Reads the target of a force: `disc at G` for a point of a body, `P` for a point that moves by itself, `disc` for a body's centre of mass,
    /// `ground at P` for a point of the ground.
    pub(super) fn acted(&mut self, text: &Text) -> Sound<Acted> {
        let is_ground = |name: &str| matches!(name.trim(), "ground" | "N");
        if is_ground(&text.text) {
            let title = "a force acts at a point, and the ground is everywhere";
            return Err(Box::new(Fault::at(text.span(), title, "no point of it", "\"ground at O\"")));
        }
        if let Some((body, point)) = text.text.split_once(" at ") {
            let start = text.text.len() - point.len();
            let place = text.slice(start..text.text.len());
            if is_ground(body) {
                return Ok(Acted::Ground(self.point(&place)?));
            }
            let body = self.body(&text.slice(0..body.trim_end().len()))?;
            return Ok(Acted::Moving(Material { body: Some(body), point: self.point(&place)? }));
        }
        if let Some(Named::Body(body)) = self.names.get(text.text.trim()) {
            let body = *body;
            return Ok(Acted::Moving(Material { body: Some(body), point: self.centre(body, &text.span())? }));
        }
        match self.value(text)? {
            Value::Point { base, way } => Ok(Acted::Moving(Material { body: None, point: self.point_of(base, way) })),
            other => Err(mismatch(&text.span(), TARGET, "a point or a body at a point", &other)),
        }
    }
}
