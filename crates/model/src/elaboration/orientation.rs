//! The orientation of a free frame at time zero, given by successive rotations.

use super::{Elaborator, Sound};
use crate::trace::quaternion_product;
use crate::{Entry, Fault, FrameId, StartValue, Text};
use std::ops::Range;
use symbolic::Dimension;

const ACCEPTED: &str = "turns one after the other: \"30 deg about x, then 10 deg about z\"";

impl Elaborator<'_> {
    /// Returns the number of the free frame with this name.
    pub(super) fn free_frame(&self, name: &str) -> Option<usize> {
        self.model.free.iter().position(|FrameId(frame)| self.model.frames[*frame].name == name)
    }

    /// Reads an orientation such as `F = "30 deg about x, then 10 deg about z"`, or a guess of one. Returns the four components of the quaternion.
    pub(super) fn orientation(&mut self, number: usize, Entry { name, value }: &Entry) -> Sound<Vec<StartValue>> {
        let (is_guess, text) = match value.text.trim_start().strip_prefix("guess ") {
            Some(rest) => (true, value.slice(value.text.len() - rest.len()..value.text.len())),
            None => (false, value.clone()),
        };
        let mut quaternion = [1.0, 0.0, 0.0, 0.0];
        let mut from = 0;
        for turn in text.text.split(',') {
            let place = from..from + turn.len();
            from = place.end + 1;
            quaternion = quaternion_product(quaternion, self.turn(name, &text, turn, place)?);
        }
        let first = self.model.free_position(number);
        let part = |(at, value): (usize, f64)| StartValue { coordinate: first + at, order: 0, value, is_guess };
        Ok(quaternion.into_iter().enumerate().map(part).collect())
    }

    /// Reads one rotation, such as `30 deg about x`. Returns its quaternion.
    fn turn(&mut self, name: &Text, whole: &Text, turn: &str, place: Range<usize>) -> Sound<[f64; 4]> {
        let fault = |label: String| {
            let title = format!("the start of `{}` is a turn", name.text);
            Box::new(Fault::at(whole.part(&place), title, label, ACCEPTED))
        };
        let plain = turn.trim().strip_prefix("then ").unwrap_or(turn.trim());
        let Some((angle, axis)) = plain.rsplit_once(" about ") else { return Err(fault("this is none".to_owned())) };
        let Some(axis) = ["x", "y", "z"].iter().position(|known| *known == axis.trim()) else {
            return Err(fault("about another axis than x, y or z".to_owned()));
        };
        self.judge_angle(whole.part(&place), angle, &format!("{{}} deg about {}", ["x", "y", "z"][axis]));
        let (angle, dimension) = units::quantity::parse_any(angle).map_err(|wrong| fault(wrong.to_string()))?;
        if dimension.of_expressions() != Dimension::none() {
            return Err(fault(format!("this has the dimension {}", dimension.of_expressions())));
        }
        let half = angle / 2.0;
        let mut quaternion = [half.cos(), 0.0, 0.0, 0.0];
        quaternion[1 + axis] = half.sin();
        Ok(quaternion)
    }
}
