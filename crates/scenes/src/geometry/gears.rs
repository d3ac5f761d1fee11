//! Gears and belts: as pairs of circles if the model gives their centres, otherwise as sentences.

use super::Geometry;
use super::figure::{Figure, Symbolic};
use model::geometry::{Gear, GearTurn};

/// Relative differences of distances below this value are rounding errors.
const SAME: f64 = 1e-7;
/// The drawn radius of the larger pulley of a belt, as a part of the distance of the centres. The model gives only the ratio of the
/// radii.
const PULLEY: f64 = 0.3;

/// Two wheels with proportional angles.
#[derive(Clone, Debug, PartialEq)]
pub struct GearPair {
    /// The two wheels.
    pub wheels: [GearWheel; 2],
    /// True if both turn in one direction, as the pulleys of a belt; false for a pair of toothed wheels.
    pub is_belt: bool,
}

/// A wheel of a gear or a belt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearWheel {
    /// The index of the point at its centre.
    pub centre: usize,
    /// Radius, m.
    pub radius: f64,
    /// The index of the frame that turns with the wheel.
    pub frame: usize,
    /// The index of the axis of rotation in this frame: 0, 1, 2 for x, y, z.
    pub axis: usize,
}

impl Geometry {
    /// Gears as pairs of circles, and sentences on those whose centres are unknown.
    pub(super) fn gears_of(&self, symbolic: &Symbolic, samples: &[Figure]) -> (Vec<GearPair>, Vec<String>) {
        let (mut pairs, mut told) = (Vec::new(), Vec::new());
        for gear in &symbolic.gears {
            match self.pair(gear, samples) {
                Some(pair) => pairs.push(pair),
                None => told.push(self.told(gear)),
            }
        }
        (pairs, told)
    }

    fn pair(&self, gear: &Gear, samples: &[Figure]) -> Option<GearPair> {
        let wheel = |turn: &GearTurn| match turn {
            GearTurn::Frame { carrier, frame, axis } => {
                let centre = self.axle([carrier.0, frame.0])?;
                Some(GearWheel { centre, radius: 0.0, frame: frame.0, axis: *axis })
            }
            GearTurn::Coordinate(_) => None,
        };
        let mut wheels = [wheel(&gear.turns[0])?, wheel(&gear.turns[1])?];
        let way = |at: &Figure| at.places[wheels[1].centre] - at.places[wheels[0].centre];
        let distance = way(samples.first()?).norm();
        let is_fixed = |at: &Figure| {
            let across = way(at).dot(&at.frames[wheels[0].frame][wheels[0].axis]).abs();
            (way(at).norm() - distance).abs() <= SAME * distance && across <= SAME * distance
        };
        let ratio = gear.ratio.abs();
        let is_parallel = wheels[0].axis == wheels[1].axis;
        if !(is_parallel && distance > 0.0 && ratio.is_finite() && samples.iter().all(is_fixed)) {
            return None;
        }
        let is_belt = gear.ratio > 0.0;
        // equal speeds at the rims
        let second = if is_belt { PULLEY * distance / ratio.max(1.0) } else { distance / (1.0 + ratio) };
        (wheels[0].radius, wheels[1].radius) = (ratio * second, second);
        Some(GearPair { wheels, is_belt })
    }

    fn told(&self, gear: &Gear) -> String {
        let name = |turn: &GearTurn| match turn {
            GearTurn::Frame { frame, .. } => {
                let body = self.model.bodies.iter().find(|body| body.frame == Some(*frame));
                body.map_or_else(|| self.model.frames[frame.0].name.clone(), |body| body.name.clone())
            }
            GearTurn::Coordinate(place) => self.model.coordinates[*place].name.clone(),
        };
        let [first, second] = [name(&gear.turns[0]), name(&gear.turns[1])];
        let held = match gear.name.as_str() {
            "" => "A constraint".to_owned(),
            name => format!("The constraint {name}"),
        };
        let times = written(gear.ratio.abs());
        let way = if gear.ratio > 0.0 { "the same way" } else { "the other way" };
        format!("{held} ties two angles: {second} turns {times} times as fast as {first}, {way}.")
    }
}

/// A ratio as text with at most four significant digits.
fn written(ratio: f64) -> String {
    let digits = 3_i32.saturating_sub(ratio.log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{ratio:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
