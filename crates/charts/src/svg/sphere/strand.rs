//! Polygonal lines in space: the graticule, the axes, the curves.

use super::{
    super::{drawing::Drawing, marker::Look, path},
    Curve,
    circle::Circle,
    number,
    scale::Scale,
    view::View,
};
use std::f64::consts::TAU;

/// A polygonal line in space with a value at each point, fine enough to look smooth.
#[derive(Clone, Debug, Default)]
pub(super) struct Strand {
    class: String,
    name: String,
    points: Vec<([f64; 3], Option<f64>)>,
}

impl Strand {
    /// Draws the pieces on one side of the sphere, with one path for each run of segments of one colour.
    pub fn draw(&self, drawing: &mut Drawing, view: &View, scale: Option<&Scale>, front: bool) {
        let class = |level: Option<usize>| level.map_or(self.class.clone(), |level| format!("valued v{level}"));
        let mut piece: (Option<usize>, Vec<(f64, f64)>) = (None, Vec::new());
        for pair in self.points.windows(2) {
            let [(a, from), (b, to)] = pair else { continue };
            let (start, end) = (view.place(*a), view.place(*b));
            let value = from.zip(*to).map(|(from, to)| 0.5 * (from + to));
            let level = value.and_then(|value| scale.map(|scale| scale.level(value)));
            let here = (start.2 + end.2 >= 0.0) == front;
            let goes_on = here && piece.0 == level && piece.1.last() == Some(&(start.0, start.1));
            if !goes_on {
                drawing.path(&path::polyline(&piece.1), &class(piece.0));
                piece = (level, if here { vec![(start.0, start.1)] } else { Vec::new() });
            }
            if here {
                piece.1.push((end.0, end.1));
            }
        }
        drawing.path(&path::polyline(&piece.1), &class(piece.0));
    }

    /// The JSON list `[class, name, coordinates in thousandths, values or null]`.
    pub fn json(&self) -> String {
        let points: Vec<_> = self.points.iter().map(|(at, _)| integers(*at)).collect();
        let valued = self.points.iter().any(|(_, value)| value.is_some());
        let values: Vec<_> = self.points.iter().map(|(_, value)| number(*value)).collect();
        let values = if valued { format!("[{}]", values.join(",")) } else { "null".to_owned() };
        format!("[{},{},[{}],{values}]", super::quoted(&self.class), super::quoted(&self.name), points.join(","))
    }
}

/// The coordinates of a point in thousandths of the radius, about a fifth of a pixel, for the data of the page.
pub(super) fn integers(at: [f64; 3]) -> String {
    at.map(|x| format!("{}", (x * 1e3).round() as i64)).join(",")
}

/// Meridians and parallels, 30 degrees apart.
pub(super) fn graticule() -> Vec<Strand> {
    let points = |circle: Circle| (0..=60).map(|j| (circle.at(f64::from(j) * TAU / 60.0), None)).collect();
    let strand = |circle| Strand { class: "graticule".into(), points: points(circle), ..Default::default() };
    Circle::graticule().map(strand).collect()
}

/// The part of an axis outside the sphere.
pub(super) fn stub(axis: [f64; 3]) -> Strand {
    let points = [1.0, 1.2].map(|length| (axis.map(|x| length * x), None)).into();
    Strand { class: "axis".into(), name: String::new(), points }
}

/// The CSS class of the segments without a value; it is common to all curves that have values elsewhere.
pub(super) fn class(curve: &Curve, look: Look) -> String {
    let valued = curve.points.iter().any(|point| point.value.is_some());
    if valued && curve.class.is_none() { "curve beyond".to_owned() } else { format!("curve {}", look.class()) }
}

/// A curve as strands, and the number of its points that have no direction. A strand ends at such a point. With `length`, the radius of the sphere
/// stands for this length, and strands end where they leave the picture.
pub(super) fn curve(curve: &Curve, look: Look, length: Option<f64>) -> (Vec<Strand>, usize) {
    let class = class(curve, look);
    let fresh = || Strand { class: class.clone(), name: curve.name.clone(), points: Vec::new() };
    let (mut strands, mut lost) = (vec![fresh()], 0);
    for point in &curve.points {
        let at = match length {
            None => unit(point.at),
            Some(length) => Some(point.at.map(|x| x / length)).filter(is_near),
        };
        let Some(at) = at else {
            lost += usize::from(length.is_none() || point.at.iter().any(|x| !x.is_finite()));
            strands.push(fresh());
            continue;
        };
        if let Some(strand) = strands.last_mut() {
            let value = point.value.filter(|value| value.is_finite());
            if let (Some(&last), None) = (strand.points.last(), length) {
                strand.points.extend(between(last, (at, value)));
            }
            strand.points.push((at, value));
        }
    }
    strands.retain(|strand| !strand.points.is_empty());
    (strands, lost)
}

/// Whether a point in space is at most one and a half radii from the centre.
fn is_near(at: &[f64; 3]) -> bool {
    at.iter().map(|x| x * x).sum::<f64>() <= 1.5 * 1.5
}

/// Points on the great circle between two points, where these are far apart.
fn between((a, from): ([f64; 3], Option<f64>), (b, to): ([f64; 3], Option<f64>)) -> Vec<([f64; 3], Option<f64>)> {
    let chord = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let pieces = (chord / 0.06).ceil() as i32;
    let at = |share: f64| unit([0, 1, 2].map(|i| a[i] + share * (b[i] - a[i])));
    let value = |share: f64| from.zip(to).map(|(from, to)| from + share * (to - from));
    (1..pieces).map(|i| f64::from(i) / f64::from(pieces)).filter_map(|s| Some((at(s)?, value(s)))).collect()
}

/// The unit vector of a vector; `None` for zero and for components that are not finite.
pub(super) fn unit(at: [f64; 3]) -> Option<[f64; 3]> {
    let length = at.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length.is_finite() && length > 0.0).then(|| at.map(|x| x / length))
}

#[cfg(test)]
mod tests {
    use super::{super::CurvePoint, *};

    #[test]
    fn sparse_points_are_joined_on_the_sphere() {
        let points = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(|at| CurvePoint { at, value: Some(at[1]) }).to_vec();
        let (strands, lost) = curve(&Curve { points, ..Curve::default() }, Look::of(0), None);
        assert_eq!((strands.len(), lost), (1, 0));
        assert!(strands[0].points.len() > 20);
        assert!(strands[0].points.iter().all(|(at, _)| (at.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn every_piece_is_drawn_on_one_side() {
        let view = View::new((20.0, 30.0));
        let (mut back, mut front) = (Drawing::default(), Drawing::default());
        for strand in graticule() {
            strand.draw(&mut back, &view, None, false);
            strand.draw(&mut front, &view, None, true);
        }
        assert!(back.embedded("").contains("graticule") && front.embedded("").contains("graticule"));
    }
}
