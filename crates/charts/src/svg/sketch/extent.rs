//! The bounding box of a mechanism over all instants.

use super::{Sketch, SketchPart};

/// A bounding box: the lowest and the highest values of two coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    /// The lowest coordinates (to the right, upwards) in metres; `high` contains the highest.
    low: (f64, f64),
    high: (f64, f64),
}

impl Extent {
    /// The bounding box of all points of the parts at all instants, including the rings and axes about them.
    pub fn of(sketch: &Sketch, flat: impl Fn([f64; 3]) -> (f64, f64)) -> Self {
        let mut extent = Extent { low: (f64::INFINITY, f64::INFINITY), high: (f64::NEG_INFINITY, f64::NEG_INFINITY) };
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
                let reach =
                    own.fold((0.0, 0.0), |(right, up): (f64, f64), axis| (right.hypot(axis.0), up.hypot(axis.1)));
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

    /// The width and the height in metres; one metre each for a mechanism that is a single point.
    pub fn size(&self) -> (f64, f64) {
        let (width, height) = (self.high.0 - self.low.0, self.high.1 - self.low.1);
        if width > 0.0 || height > 0.0 { (width, height) } else { (1.0, 1.0) }
    }
}

impl SketchPart {
    /// The indices of the points of a part.
    pub(super) fn stands_at(&self) -> Vec<usize> {
        match self {
            SketchPart::Plate { corners, .. } => corners.clone(),
            SketchPart::Rod(ends)
            | SketchPart::Strand(ends)
            | SketchPart::Telescope(ends)
            | SketchPart::Spring(ends)
            | SketchPart::Dashpot(ends)
            | SketchPart::Actuator(ends)
            | SketchPart::Field(ends) => ends.to_vec(),
            SketchPart::Centre(at)
            | SketchPart::Pin(at)
            | SketchPart::Support(at)
            | SketchPart::Particle { at, .. }
            | SketchPart::Block { at, .. }
            | SketchPart::Guide { at, .. }
            | SketchPart::Ring { at, .. }
            | SketchPart::Triad { at, .. }
            | SketchPart::Surface { at, .. }
            | SketchPart::TorsionSpring { at, .. }
            | SketchPart::RotaryDashpot { at, .. }
            | SketchPart::Torque { at, .. }
            | SketchPart::Arrow { at, .. } => vec![*at],
        }
    }
}
