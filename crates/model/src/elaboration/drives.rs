//! Drives: motors between two bodies, with gears and windings.
//!
//! The rotor of a motor is a frame that turns, relative to the body that carries the motor, by n times the angle of the shaft. The torque of the motor acts
//! between these two frames. Hence the gear does no work, and the reaction acts on the carrying body.

use super::loads::joule;
use super::windings::ampere;
use super::{Elaborator, Named, Sound, Value};
use crate::arena::{Scalar, Vector};
use crate::{Body, Coordinate, DriveSource, Fault, FrameId, Inertia, ScalarId, Text, Torque, Turn};
use field::Rational;
use std::ops::Range;
use symbolic::Dimension;

const EXAMPLE: &str = "turns = \"theta\", or between = [\"carriage\", \"wheel\"], in [[drive]]";
const WINDING: &str = "inductance = \"L\", resistance = \"R\", supply = \"U\", motional = \"k\" in [[drive.winding]]";

/// The quantities of a drive that expressions can use.
#[derive(Clone, Debug, Default)]
pub(super) struct Drive {
    pub name: String,
    /// The names of the currents, each with the index of its charge among the coordinates.
    pub currents: Vec<(String, usize)>,
    /// Angle, speed and torque of the motor; `None` until the bodies are known.
    angle: Option<ScalarId>,
    pub speed: Option<ScalarId>,
    torque: Option<ScalarId>,
}

/// The shaft of a drive: the frame that carries the motor, the axis in that frame, and the angle of the driven part.
struct Shaft {
    base: FrameId,
    axis: usize,
    angle: ScalarId,
}

/// The rotor of a drive: its frame `frame` turns about `axis` of the frame `base`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rotor {
    drive: usize,
    base: FrameId,
    axis: usize,
    frame: FrameId,
}

impl Elaborator<'_> {
    /// Adds the charges of all windings as coordinates, and the names of the drives.
    pub(super) fn charges(&mut self) {
        for (place, source) in self.source.drives.iter().enumerate() {
            let found = self.named_drive(place, source);
            if self.kept(found).is_none() {
                // a placeholder preserves the indices of the following drives
                self.drives.push(Drive::default());
            }
        }
    }

    fn named_drive(&mut self, place: usize, source: &DriveSource) -> Sound<()> {
        let name = match (&source.name, self.source.drives.len()) {
            (Some(name), _) => name.clone(),
            (None, 1) => Text::at("drive", source.at.start),
            (None, _) => {
                let title = "each of several drives has a name";
                return Err(Box::new(Fault::at(source.at.clone(), title, "this one has none", "name = \"left\"")));
            }
        };
        let mut drive = Drive { name: name.text.clone(), ..Drive::default() };
        for winding in &source.windings {
            let current = winding.current.as_ref().map_or("i", |current| current.text.as_str());
            let at = winding.current.as_ref().map_or_else(|| winding.at.clone(), Text::span);
            let is_taken = drive.currents.iter().any(|(known, _)| known == current);
            if is_taken || ["angle", "speed", "torque"].contains(&current) || !crate::expression::is_name(current) {
                let title = format!("`{current}` is no name for the current of this winding");
                let accepted = "current = \"i_a\", another name for each winding of a drive";
                return Err(Box::new(Fault::at(at, title, "here", accepted)));
            }
            let charge = match source.windings.len() {
                1 => format!("{}.q", drive.name),
                _ => format!("{}.q_{current}", drive.name),
            };
            let dimension = ampere() * Dimension::time();
            self.model.coordinates.push(Coordinate { name: charge, dimension, unit: "C".to_owned(), at });
            let coordinate = self.model.coordinates.len() - 1;
            let letter = self.scalar(Scalar::Rate { coordinate, order: 1 }, Some(ampere()));
            self.currents.insert(coordinate, letter);
            drive.currents.push((current.to_owned(), coordinate));
            self.model.currents.push((format!("{}.{current}", drive.name), coordinate));
        }
        self.drives.push(drive);
        self.give(&name, Named::Drive(place));
        Ok(())
    }

    /// Returns the fault for a drive's name that is used as a quantity.
    pub(super) fn bare_drive(&self, span: &Range<usize>, drive: usize) -> Box<Fault> {
        let name = &self.drives[drive].name;
        let title = format!("`{name}` is a drive, which is no quantity");
        Box::new(Fault::at(span.clone(), title, "a part of it is one", format!("{name}.speed, {name}.torque")))
    }

    /// Reads `left.i`, `left.angle`, `left.speed` or `left.torque`.
    pub(super) fn of_drive(&self, span: &Range<usize>, drive: usize, name: &str) -> Sound<Value> {
        let known = &self.drives[drive];
        if let Some((_, charge)) = known.currents.iter().find(|(current, _)| current == name) {
            return Ok(Value::Scalar(self.currents[charge]));
        }
        let quantity = match name {
            "angle" => known.angle,
            "speed" => known.speed,
            "torque" => known.torque,
            _ => {
                let currents = known.currents.iter().map(|(current, _)| format!("{}.{current}", known.name));
                let all = ["angle", "speed", "torque"].map(|part| format!("{}.{part}", known.name));
                let accepted = currents.chain(all).collect::<Vec<_>>().join(", ");
                let title = format!("the drive `{}` has no `{name}`", known.name);
                return Err(Box::new(Fault::at(span.clone(), title, "not known", accepted)));
            }
        };
        quantity.map(Value::Scalar).ok_or_else(|| {
            let title = format!("`{}.{name}` is not known here yet", known.name);
            let accepted =
                "it stands in forces, torques, constraints, events and outputs; elsewhere the angle of the shaft";
            Box::new(Fault::at(span.clone(), title, "before the drive", accepted))
        })
    }

    /// Adds the rotors of all drives.
    pub(super) fn rotors(&mut self) {
        for (place, source) in self.source.drives.iter().enumerate() {
            // a drive without a name is already reported
            if !self.drives[place].name.is_empty() {
                let found = self.rotor(place, source);
                self.kept(found);
            }
        }
    }

    /// Adds the torques and windings of all drives, whose laws may contain quantities of any drive.
    pub(super) fn windings(&mut self) {
        for (place, source) in self.source.drives.iter().enumerate() {
            if self.drives.get(place).is_some_and(|drive| drive.speed.is_some()) {
                let found = self.wound(place, source);
                self.kept(found);
            }
        }
    }

    fn rotor(&mut self, place: usize, source: &DriveSource) -> Sound<()> {
        let number = Some(Dimension::none());
        let Shaft { base, axis, angle: shaft } = match (&source.turns, &source.between) {
            (Some(turns), None) => {
                let angle = self.position(turns, "the angle of a shaft")?;
                self.warn_of_a_shaft_that_is_carried(turns, angle);
                Shaft { base: FrameId::GROUND, axis: 2, angle }
            }
            (None, Some([first, second])) => {
                let frames = [self.turning_frame(first)?, self.turning_frame(second)?];
                if frames[0] == frames[1] {
                    let title = "both bodies of a drive are fixed in one frame, so that they cannot turn relative to each other";
                    return Err(Box::new(Fault::at(second.span(), title, "the frame before", EXAMPLE)));
                }
                self.shaft(frames, [first, second])?
            }
            _ => {
                let title = "a drive has one of `turns` and `between`";
                return Err(Box::new(Fault::at(source.at.clone(), title, "here", EXAMPLE)));
            }
        };
        let angle = match &source.ratio {
            None => shaft,
            Some(ratio) => {
                let ratio = self.position(ratio, "the ratio of a gear")?;
                self.scalar(Scalar::Product(ratio, shaft), number)
            }
        };
        let speed = self.scalar(Scalar::RateOf(angle), Some(Dimension::none() / Dimension::time()));
        let name = self.drives[place].name.clone();
        let rotor = self.new_frame(&format!("rotor of {name}"), base, Turn::About { axis, angle });
        (self.drives[place].angle, self.drives[place].speed) = (Some(angle), Some(speed));
        self.rotor_frames.push(Rotor { drive: place, base, axis, frame: rotor });
        if let Some(text) = &source.inertia {
            let needed = Dimension::mass() * Dimension::length().power(Rational::new(2, 1));
            let inertia = self.scalar_value(text, "the moment of inertia", Some(needed))?;
            let at = text.span();
            self.model.bodies.push(Body {
                name: format!("rotor of {name}"),
                frame: Some(rotor),
                centre: None,
                mass: None,
                inertia: Some(Inertia::OfShaft { moment: inertia, axis }),
                mass_at: at.clone(),
                inertia_at: at.clone(),
                at,
            });
        }
        Ok(())
    }

    /// Reads a dimensionless number that depends on positions only.
    fn position(&mut self, text: &Text, what: &str) -> Sound<ScalarId> {
        let found = self.scalar_value(text, what, Some(Dimension::none()))?;
        if self.orders.of(found.0).is_some_and(|order| order > 0) {
            let title = format!("{what} depends on positions alone");
            return Err(Box::new(Fault::at(text.span(), title, "a rate stands in it", "an angle: turns = \"theta\"")));
        }
        Ok(found)
    }

    /// Warns if `turns` is the angle of a frame inside a moving frame, since this motor is mounted on the ground.
    fn warn_of_a_shaft_that_is_carried(&mut self, turns: &Text, angle: ScalarId) {
        let carried = self.model.frames.iter().find_map(|frame| match frame.parent {
            Some((parent, Turn::About { angle: own, .. })) if own == angle && parent != FrameId::GROUND => {
                Some((frame.name.clone(), self.model.frames[parent.0].name.clone()))
            }
            _ => None,
        });
        if let Some((frame, parent)) = carried {
            let title = format!("this motor sits on the ground, and turns by the angle of `{frame}` in `{parent}`");
            let accepted = format!("between = [\"{parent}\", \"{frame}\"] for a motor that `{parent}` carries");
            self.model.warnings.push(Fault::at(
                turns.span(),
                title,
                "it is not an angle relative to the ground",
                accepted,
            ));
        }
    }

    /// Returns the shaft between two frames: either one frame turns in the other about a common axis, or each turns about z of the ground.
    fn shaft(&mut self, [first, second]: [FrameId; 2], texts: [&Text; 2]) -> Sound<Shaft> {
        let number = Some(Dimension::none());
        if let Some((axis, angle)) = self.turned_in(second, first) {
            return Ok(Shaft { base: first, axis, angle });
        }
        if let Some((axis, angle)) = self.turned_in(first, second) {
            let angle = self.scalar(Scalar::Negation(angle), number);
            return Ok(Shaft { base: first, axis, angle });
        }
        let (on, of) = (self.about_z(first, texts[0])?, self.about_z(second, texts[1])?);
        Ok(Shaft { base: first, axis: 2, angle: self.scalar(Scalar::Difference(of, on), number) })
    }

    /// Returns the axis and the angle of a frame's rotation relative to a parent frame `above`; `None` for rotations about several axes, or free ones.
    fn turned_in(&mut self, mut frame: FrameId, above: FrameId) -> Option<(usize, ScalarId)> {
        let mut found: Option<(usize, ScalarId)> = None;
        while frame != above {
            let (parent, turn) = self.model.frames[frame.0].parent?;
            let Turn::About { axis, angle } = turn else { return None };
            found = Some(match found {
                None => (axis, angle),
                Some((known, sum)) if known == axis => {
                    (axis, self.scalar(Scalar::Sum(angle, sum), Some(Dimension::none())))
                }
                Some(_) => return None,
            });
            frame = parent;
        }
        found
    }

    /// Returns the angle of a frame relative to the ground; all its rotations must be about z.
    fn about_z(&mut self, mut frame: FrameId, text: &Text) -> Sound<ScalarId> {
        let number = Some(Dimension::none());
        let mut sum: Option<ScalarId> = None;
        while let Some((parent, turn)) = self.model.frames[frame.0].parent {
            let Turn::About { axis: 2, angle } = turn else {
                let title =
                    "the shaft of this drive has no axis: neither frame turns in the other about one axis of both";
                let accepted = "a second frame that turns in the first, W = \"C turned theta about x\"; or frames that turn about z alone";
                return Err(Box::new(Fault::at(
                    text.span(),
                    title,
                    "it turns about another axis than z, or freely",
                    accepted,
                )));
            };
            sum = Some(match sum {
                None => angle,
                Some(sum) => self.scalar(Scalar::Sum(angle, sum), number),
            });
            frame = parent;
        }
        Ok(sum.unwrap_or_else(|| {
            let zero = crate::arena::Number { value: 0.0, times: 1.0, per: 1.0 };
            self.scalar(Scalar::Number(zero), number)
        }))
    }

    fn wound(&mut self, place: usize, source: &DriveSource) -> Sound<()> {
        let Some(Rotor { base, axis, frame, .. }) = self.rotor_frames.iter().copied().find(|one| one.drive == place)
        else {
            return Ok(());
        };
        let mut torque = match &source.torque {
            None => None,
            Some(torque) => Some(self.law(torque, "the torque on a motor", joule())?),
        };
        if torque.is_none() && source.windings.is_empty() {
            let title = "a drive has a torque or windings";
            return Err(Box::new(Fault::at(source.at.clone(), title, "neither stands here", WINDING)));
        }
        for (number, winding) in source.windings.iter().enumerate() {
            let charge = self.drives[place].currents[number].1;
            if let Some(part) = self.winding(place, charge, winding)? {
                torque = Some(match torque {
                    None => part,
                    Some(sum) => self.scalar(Scalar::Sum(sum, part), Some(joule())),
                });
            }
        }
        let Some(torque) = torque else { return Ok(()) };
        self.drives[place].torque = Some(torque);
        let axis = self.vector(Vector::Axis { frame: base, axis }, Some(Dimension::none()));
        let is = self.vector(Vector::Scaled(torque, axis), Some(joule()));
        let at = source.torque.as_ref().map(Text::span);
        self.driving.0.push((Torque::Between { frames: [base, frame], is }, at));
        Ok(())
    }
}
