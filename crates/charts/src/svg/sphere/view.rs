//! The orthographic projection of the sphere.

use super::{CENTRE, RADIUS};

/// An orthographic projection from a direction given by azimuth and elevation, in degrees.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// The azimuth in degrees; `height` is the elevation in degrees.
    azimuth: f64,
    height: f64,
    /// The unit vectors to the right, upwards, and towards the viewer.
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
}

impl View {
    pub fn new((azimuth, height): (f64, f64)) -> Self {
        let azimuth = if azimuth.is_finite() { azimuth } else { 0.0 };
        let height = if height.is_finite() { height.clamp(-90.0, 90.0) } else { 0.0 };
        let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
        let (sin_h, cos_h) = height.to_radians().sin_cos();
        View {
            azimuth,
            height,
            right: [-sin_a, cos_a, 0.0],
            up: [-sin_h * cos_a, -sin_h * sin_a, cos_h],
            towards: [cos_h * cos_a, cos_h * sin_a, sin_h],
        }
    }

    pub fn degrees(&self) -> (f64, f64) {
        (self.azimuth, self.height)
    }

    /// The position of a point in the picture in pixels, and its depth in front of the centre in radii.
    pub fn place(&self, at: [f64; 3]) -> (f64, f64, f64) {
        let along = |axis: [f64; 3]| axis.iter().zip(at).map(|(a, b)| a * b).sum::<f64>();
        (CENTRE.0 + RADIUS * along(self.right), CENTRE.1 - RADIUS * along(self.up), along(self.towards))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_eye_sees_its_own_direction_in_the_centre() {
        let (x, y, depth) = View::new((90.0, 0.0)).place([0.0, 1.0, 0.0]);
        assert!((x - CENTRE.0).abs() < 1e-9 && (y - CENTRE.1).abs() < 1e-9 && (depth - 1.0).abs() < 1e-9);
    }
}
