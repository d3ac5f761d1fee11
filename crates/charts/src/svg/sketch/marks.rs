//! Symbols at one point, as SVG paths.

use super::pose::Flat;
use crate::svg::number::coordinate as n;

/// The path of a circle about a point.
pub(super) fn circle((x, y): Flat, r: f64) -> String {
    format!("M{} {}a{r} {r} 0 1 0 .1 0z", n(x), n(y - r), r = n(r))
}

/// The two filled quarters of the symbol for a centre of mass.
pub(super) fn quarters((x, y): Flat, r: f64) -> String {
    let (x, y, r) = (n(x), n(y), n(r));
    format!("M{x} {y}v-{r}a{r} {r} 0 0 1 {r} {r}zM{x} {y}v{r}a{r} {r} 0 0 1-{r}-{r}z")
}

/// The symbol for a pin on the ground: a triangle on hatching.
pub(super) fn support((x, y): Flat) -> String {
    format!("M{} {}l-9 15h18zm-14 15h28{}", n(x), n(y), "m-4 0l-5 6m-1-6l-5 6m-1-6l-5 6m-1-6l-5 6")
}

/// The path of a rectangular block with its long side along a direction; both in pixels.
pub(super) fn block(at: Flat, along: Flat) -> String {
    let length = along.0.hypot(along.1).max(1e-9);
    let (ux, uy) = (along.0 / length, along.1 / length);
    let corner = |a: f64, b: f64| (at.0 + a * ux - b * uy, at.1 + a * uy + b * ux);
    polygon(&[corner(-15.0, -9.0), corner(15.0, -9.0), corner(15.0, 9.0), corner(-15.0, 9.0)])
}

/// A closed path.
pub(super) fn polygon(corners: &[Flat]) -> String {
    format!("M{}z", corners.iter().map(point).collect::<Vec<_>>().join("L"))
}

/// An open path.
pub(super) fn polyline(points: &[Flat]) -> String {
    format!("M{}", points.iter().map(point).collect::<Vec<_>>().join("L"))
}

/// Segments, each by its two ends.
pub(super) fn segments(ends: &[Flat]) -> String {
    ends.chunks_exact(2).map(polyline).collect()
}

/// The ellipse about a centre through the ends of two conjugate half-axes, as four cubic Bézier curves.
pub(super) fn ellipse(centre: Flat, a: Flat, b: Flat) -> String {
    let (a, b) = ((a.0 - centre.0, a.1 - centre.1), (b.0 - centre.0, b.1 - centre.1));
    let at = |p: f64, q: f64| (centre.0 + p * a.0 + q * b.0, centre.1 + p * a.1 + q * b.1);
    // the factor of the control points that approximates a quarter of a circle best
    let k = 0.552_284_75;
    let quarter =
        |c: [f64; 6]| format!("C{} {} {}", point(&at(c[0], c[1])), point(&at(c[2], c[3])), point(&at(c[4], c[5])));
    let quarters = [
        [1.0, k, k, 1.0, 0.0, 1.0],
        [-k, 1.0, -1.0, k, -1.0, 0.0],
        [-1.0, -k, -k, -1.0, 0.0, -1.0],
        [k, -1.0, 1.0, -k, 1.0, 0.0],
    ];
    format!("M{}{}z", point(&at(1.0, 0.0)), quarters.map(quarter).concat())
}

fn point((x, y): &Flat) -> String {
    format!("{} {}", n(*x), n(*y))
}
