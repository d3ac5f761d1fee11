//! Paths through many points, thinned to the resolution of a pixel and written in tenths of a pixel.

use super::number::{Tenths, tenths};

/// The largest distance in pixels of a point that is left out from the thinned line.
const TOLERANCE: f64 = 0.25;

/// The SVG path through the thinned points.
pub(crate) fn polyline(points: &[(f64, f64)]) -> String {
    let mut out = String::new();
    let mut pen = (0, 0);
    for (position, (x, y)) in thin(points).into_iter().enumerate() {
        let (Tenths(x), Tenths(y)) = (tenths(x), tenths(y));
        if position == 0 {
            out.push('M');
        } else if (x, y) == pen {
            continue;
        } else if position == 1 {
            out.push('l');
        }
        let dx = Tenths(x - pen.0).to_string_tenths();
        let dy = Tenths(y - pen.1).to_string_tenths();
        if position > 1 && !dx.starts_with('-') {
            out.push(' ');
        }
        out += &dx;
        if !dy.starts_with('-') {
            out.push(' ');
        }
        out += &dy;
        pen = (x, y);
    }
    if out.is_empty() || out.contains('l') { out } else { out + "h0" }
}

/// The points that the algorithm of Ramer, Douglas and Peucker retains: the line through them is within [`TOLERANCE`] of all points.
fn thin(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut keep = vec![false; points.len()];
    for end in [0, points.len().saturating_sub(1)] {
        if let Some(flag) = keep.get_mut(end) {
            *flag = true;
        }
    }
    let mut stack = vec![(0, points.len().saturating_sub(1))];
    while let Some((first, last)) = stack.pop() {
        let farthest = (first + 1..last)
            .map(|middle| (middle, distance(points[middle], points[first], points[last])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((middle, away)) = farthest
            && away > TOLERANCE
        {
            keep[middle] = true;
            stack.extend([(first, middle), (middle, last)]);
        }
    }
    points.iter().zip(keep).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// The distance from a point to the segment between two points.
fn distance((x, y): (f64, f64), (ax, ay): (f64, f64), (bx, by): (f64, f64)) -> f64 {
    let (ux, uy) = (bx - ax, by - ay);
    let length = ux * ux + uy * uy;
    let along = if length > 0.0 { (((x - ax) * ux + (y - ay) * uy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (x - ax - along * ux).hypot(y - ay - along * uy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_keeps_its_ends() {
        let line: Vec<_> = (0..100).map(|i| (f64::from(i), 2.0 * f64::from(i))).collect();
        assert_eq!(polyline(&line), "M0 0l99 198");
    }

    #[test]
    fn a_peak_survives() {
        let mut line: Vec<_> = (0..100).map(|i| (f64::from(i), 0.0)).collect();
        line[50].1 = 7.0;
        assert_eq!(polyline(&line), "M0 0l49 0 1 7 1-7 48 0");
    }

    #[test]
    fn nothing_and_a_single_point_are_paths() {
        assert_eq!(polyline(&[]), "");
        assert_eq!(polyline(&[(1.0, 2.0)]), "M1 2h0");
    }
}
