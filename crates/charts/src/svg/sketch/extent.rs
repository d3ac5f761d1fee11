//! The box that a mechanism takes over all instants, and the scale beside it.

use super::camera::Camera;
use super::{Drawing, Sketch, SketchPart};
use crate::svg::drawing::{Anchor, WIDTH};
use crate::svg::number::{coordinate, significant};

/// The least and the largest of two coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    low: (f64, f64),
    high: (f64, f64),
}

impl Extent {
    /// Of all places that parts stand at, and of rings about them.
    pub fn of(sketch: &Sketch, flat: impl Fn([f64; 3]) -> (f64, f64)) -> Self {
        let mut extent =
            Extent { low: (f64::INFINITY, f64::INFINITY), high: (f64::NEG_INFINITY, f64::NEG_INFINITY) };
        for instant in &sketch.instants {
            let place = |at: &usize| instant.places.get(*at).map(|place| flat(*place));
            for part in &sketch.parts {
                part.stands_at().iter().filter_map(place).for_each(|place| extent.hold(place));
                let (SketchPart::Ring { at, .. } | SketchPart::Triad { at, .. }) = part else { continue };
                let Some((x, y)) = place(at) else { continue };
                let axes: &[usize] = match part {
                    SketchPart::Ring { axes, .. } => axes,
                    SketchPart::Triad { axes, .. } => axes,
                    _ => &[],
                };
                let own = axes.iter().filter_map(|axis| instant.directions.get(*axis).map(|axis| flat(*axis)));
                let reach = own.fold((0.0, 0.0), |(right, up): (f64, f64), axis| {
                    (right.hypot(axis.0), up.hypot(axis.1))
                });
                extent.hold((x - reach.0, y - reach.1));
                extent.hold((x + reach.0, y + reach.1));
            }
        }
        if extent.low.0 > extent.high.0 {
            extent = Extent { low: (0.0, 0.0), high: (0.0, 0.0) };
        }
        extent
    }

    fn hold(&mut self, (x, y): (f64, f64)) {
        if x.is_finite() && y.is_finite() {
            self.low = (self.low.0.min(x), self.low.1.min(y));
            self.high = (self.high.0.max(x), self.high.1.max(y));
        }
    }

    pub fn middle(&self) -> (f64, f64) {
        (0.5 * (self.low.0 + self.high.0), 0.5 * (self.low.1 + self.high.1))
    }

    /// Width and height; of a mechanism that is one place the size of a metre.
    pub fn size(&self) -> (f64, f64) {
        let (width, height) = (self.high.0 - self.low.0, self.high.1 - self.low.1);
        if width > 0.0 || height > 0.0 { (width, height) } else { (1.0, 1.0) }
    }
}

impl SketchPart {
    /// The places that a part stands at.
    pub(super) fn stands_at(&self) -> Vec<usize> {
        match self {
            SketchPart::Plate { corners, .. } => corners.clone(),
            SketchPart::Rod(ends)
            | SketchPart::Telescope(ends)
            | SketchPart::Spring(ends)
            | SketchPart::Dashpot(ends)
            | SketchPart::Actuator(ends) => ends.to_vec(),
            SketchPart::Centre(at)
            | SketchPart::Pin(at)
            | SketchPart::Support(at)
            | SketchPart::Particle { at, .. }
            | SketchPart::Block { at, .. }
            | SketchPart::Guide { at, .. }
            | SketchPart::Ring { at, .. }
            | SketchPart::Triad { at, .. }
            | SketchPart::Surface { at, .. }
            | SketchPart::Arrow { at, .. } => vec![*at],
        }
    }
}

/// A bar whose length is a round number of metres.
pub(super) fn scale_bar(drawing: &mut Drawing, camera: &Camera) {
    let most = 90.0 / camera.scale;
    let power = 10_f64.powf(most.log10().floor());
    let round = [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|length| *length <= most);
    let Some(length) = round.filter(|length| length.is_finite()) else { return };
    let (right, y) = (WIDTH - 16.0, camera.height - 14.0);
    let left = right - length * camera.scale;
    let [from, to, at] = [left, right, y].map(coordinate);
    drawing.path(&format!("M{from} {at}m0-4v8m0-4H{to}m0-4v8"), "axis");
    drawing.text((0.5 * (left + right), y - 8.0), Anchor::Middle, "small", &metres(length));
}

/// A length as people write it.
fn metres(length: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm")];
    // centimetres are read more easily than tens of millimetres
    let (of, unit) = units.into_iter().find(|(of, _)| length >= 0.999 * of).unwrap_or((1.0, "m"));
    if unit == "mm" && length >= 0.0099 {
        return format!("{} cm", significant(100.0 * length, 2));
    }
    format!("{} {unit}", significant(length / of, 2))
}

#[cfg(test)]
mod tests {
    use super::metres;

    #[test]
    fn lengths_have_the_unit_that_people_use() {
        let shown: Vec<String> = [2000.0, 5.0, 0.2, 0.05, 0.002, 2e-5].map(metres).into();
        assert_eq!(shown, ["2 km", "5 m", "20 cm", "5 cm", "2 mm", "20 µm"]);
    }
}
