//! Circles on the sphere. Their projections are ellipses, of which arcs are drawn.

use super::super::number::coordinate;
use super::{RADIUS, view::View};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A circle on the unit sphere, `centre + radius (u cos t + v sin t)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    centre: [f64; 3],
    radius: f64,
    /// The orthogonal unit vectors u and v.
    across: [[f64; 3]; 2],
}

impl Circle {
    /// Meridians and parallels, 30 degrees apart; each meridian is a full circle through both poles.
    pub fn graticule() -> impl Iterator<Item = Self> {
        let meridian = |i: i32| {
            let (sin, cos) = (f64::from(i) * PI / 6.0).sin_cos();
            Circle { centre: [0.0; 3], radius: 1.0, across: [[cos, sin, 0.0], [0.0, 0.0, 1.0]] }
        };
        let parallel = |i: i32| {
            let (sin, cos) = (f64::from(i) * PI / 6.0).sin_cos();
            Circle { centre: [0.0, 0.0, sin], radius: cos, across: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] }
        };
        (0..6).map(meridian).chain((-2..=2).map(parallel))
    }

    /// The point at the parameter t, in radians.
    pub fn at(&self, turn: f64) -> [f64; 3] {
        let (sin, cos) = turn.sin_cos();
        let [u, v] = self.across;
        std::array::from_fn(|i| self.centre[i] + self.radius * (u[i] * cos + v[i] * sin))
    }

    /// The interval of t on which the circle lies on the front or on the back of the sphere; empty where no part does.
    fn turns(&self, view: &View, front: bool) -> (f64, f64) {
        let depth = |at: [f64; 3]| view.place(at).2;
        let [u, v] = self.across.map(depth);
        let nearest = v.atan2(u);
        // a point is in front where cos(t - nearest) is at least this; NaN for the limb itself
        let least = -depth(self.centre) / (self.radius * u.hypot(v));
        let half = if least.is_nan() { PI } else { least.clamp(-1.0, 1.0).acos() };
        if front { (nearest - half, nearest + half) } else { (nearest + half, nearest - half + TAU) }
    }

    /// The part on the front or on the back as an SVG path of two arcs, each at most half of the ellipse.
    pub fn path(&self, view: &View, front: bool) -> String {
        let (from, to) = self.turns(view, front);
        if to - from < 1e-6 {
            return String::new();
        }
        let screen = |at: [f64; 3]| -> [f64; 2] {
            let ((x, y, _), (x0, y0, _)) = (view.place(at), view.place([0.0; 3]));
            [x - x0, y - y0]
        };
        let [u, v] = self.across;
        let (su, sv) = (screen(u), screen(v));
        let clockwise = su[0] * sv[1] - su[1] * sv[0] > 0.0;
        let [tilt_u, tilt_v] = [u, v].map(|axis| view.place(axis).2);
        // the radius of the circle that is parallel to the plane of the picture
        let (sin, cos) = (tilt_v.atan2(tilt_u) + FRAC_PI_2).sin_cos();
        let [x, y] = screen(std::array::from_fn(|i| u[i] * cos + v[i] * sin));
        let long = RADIUS * self.radius;
        let short = long * (1.0 - tilt_u * tilt_u - tilt_v * tilt_v).max(0.0).sqrt();
        let place = |turn: f64| {
            let (x, y, _) = view.place(self.at(turn));
            format!("{} {}", coordinate(x), coordinate(y))
        };
        let [long, short, angle] = [long, short, y.atan2(x).to_degrees()].map(coordinate);
        let arc = |to: f64| format!("A{long} {short} {angle} 0 {} {}", u8::from(clockwise), place(to));
        format!("M{}{}{}", place(from), arc(0.5 * (from + to)), arc(to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_parted_where_it_meets_the_limb() {
        for view in [(30.0, 20.0), (-110.0, -55.0), (10.0, 0.0)].map(View::new) {
            for circle in Circle::graticule() {
                let depth = |turn: f64| view.place(circle.at(turn)).2;
                let ((from, to), (back, end)) = (circle.turns(&view, true), circle.turns(&view, false));
                assert!((to - from + end - back - TAU).abs() < 1e-9);
                assert!(to - from < 1e-6 || depth(0.5 * (from + to)) >= 0.0);
                assert!(end - back < 1e-6 || depth(0.5 * (back + end)) <= 0.0);
                let meets = to - from > 1e-6 && end - back > 1e-6;
                assert!(!meets || depth(from).abs() < 1e-9 && depth(to).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_parallel_seen_from_the_pole_is_a_circle_in_front() {
        let view = View::new((0.0, 90.0));
        let north = Circle::graticule().last().unwrap();
        assert_eq!(north.path(&view, false), "");
        assert!(north.path(&view, true).contains("A93 93 "), "{}", north.path(&view, true));
    }
}
