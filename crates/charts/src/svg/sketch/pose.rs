//! A path with its motion over all instants: at rest, moved rigidly, stretched between two points, or another path at each instant.

use super::timeline::Timeline;
use crate::svg::drawing::Drawing;
use crate::svg::number::coordinate as n;

pub(super) type Flat = (f64, f64);

/// A path with its motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Pose {
    Still(String),
    /// A path about its own origin; for each instant the position of this origin, the rotation in degrees, and the stretch along its first axis.
    Moved {
        path: String,
        places: Vec<Flat>,
        angles: Vec<f64>,
        stretches: Vec<f64>,
    },
    Bent(Vec<String>),
}

/// The largest distance in pixels between points that count as equal.
const NEAR: f64 = 0.35;

/// The length in pixels of a path before it is stretched.
pub(super) const LENGTH: f64 = 100.0;

impl Pose {
    /// A path through points: at rest or moved rigidly where the points allow it, otherwise with another path at each instant.
    pub fn through(points: &[Vec<Flat>], path: impl Fn(&[Flat]) -> String) -> Self {
        let Some(first) = points.first().filter(|points| !points.is_empty()) else { return Pose::Still(String::new()) };
        let rests = |points: &Vec<Flat>| points.iter().zip(first).all(|(now, then)| near(*now, *then));
        if points.iter().all(rests) {
            return Pose::Still(path(first));
        }
        let origin = first[0];
        let reach = |point: &Flat| distance(*point, origin);
        let far = (1..first.len()).max_by(|a, b| reach(&first[*a]).total_cmp(&reach(&first[*b])));
        let angles: Vec<f64> = match far {
            None => Vec::new(),
            Some(far) => {
                let turn =
                    |points: &Vec<Flat>| (points[far].1 - points[0].1).atan2(points[far].0 - points[0].0).to_degrees();
                let first = turn(first);
                unwound(points.iter().map(|points| turn(points) - first))
            }
        };
        let is_rigid = points.iter().enumerate().all(|(instant, points)| {
            let (sin, cos) = angles.get(instant).copied().unwrap_or(0.0).to_radians().sin_cos();
            points.iter().zip(first).all(|(now, then)| {
                let (x, y) = (then.0 - origin.0, then.1 - origin.1);
                near(*now, (points[0].0 + cos * x - sin * y, points[0].1 + sin * x + cos * y))
            })
        });
        if !is_rigid {
            return Pose::Bent(points.iter().map(|points| path(points)).collect());
        }
        let own: Vec<Flat> = first.iter().map(|point| (point.0 - origin.0, point.1 - origin.1)).collect();
        let places = points.iter().map(|points| points[0]).collect();
        Pose::Moved { path: path(&own), places, angles: turning(angles), stretches: Vec::new() }
    }

    /// A path of [`LENGTH`] along its first axis, stretched between two points at each instant.
    pub fn between(ends: &[[Flat; 2]], path: &str) -> Self {
        let places = ends.iter().map(|[from, _]| *from).collect();
        let angles = ends.iter().map(|[from, to]| (to.1 - from.1).atan2(to.0 - from.0).to_degrees());
        let stretches = ends.iter().map(|[from, to]| distance(*from, *to) / LENGTH).collect();
        Pose::Moved { path: path.to_owned(), places, angles: unwound(angles), stretches }
    }

    pub fn draw(&self, drawing: &mut Drawing, class: &str, timeline: &Timeline) {
        match self {
            Pose::Still(path) => drawing.path(path, class),
            Pose::Bent(paths) => {
                let first = paths.first().map_or("", String::as_str);
                drawing.path_with(first, class, "", &timeline.values("d", paths));
            }
            Pose::Moved { path, places, angles, stretches } => {
                let pair = |(x, y): &Flat| format!("{} {}", n(*x), n(*y));
                let degrees = |angle: &f64| hundredths(*angle);
                let shares = |stretch: &f64| format!("{} 1", thousandths(*stretch));
                let parts = [
                    ("translate", places.iter().map(pair).collect::<Vec<_>>()),
                    ("rotate", angles.iter().map(degrees).collect()),
                    ("scale", stretches.iter().map(shares).collect()),
                ];
                let parts: Vec<_> = parts.into_iter().filter(|(_, values)| !values.is_empty()).collect();
                let first: String = parts.iter().map(|(kind, values)| format!("{kind}({})", values[0])).collect();
                let transform = format!(" transform=\"{first}\"");
                let moved: String = parts.iter().map(|(kind, values)| timeline.transform(kind, values)).collect();
                drawing.path_with(path, class, &transform, &moved);
            }
        }
    }
}

/// The angles in degrees with whole turns added, such that successive angles differ by at most half a turn.
fn unwound(angles: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for angle in angles {
        let last = all.last().copied().unwrap_or(angle);
        all.push(last + (angle - last + 180.0).rem_euclid(360.0) - 180.0);
    }
    all
}

/// The angles; an empty list where none differs from zero.
fn turning(angles: Vec<f64>) -> Vec<f64> {
    if angles.iter().all(|angle| angle.abs() < 0.005) { Vec::new() } else { angles }
}

pub(super) fn distance(a: Flat, b: Flat) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn near(a: Flat, b: Flat) -> bool {
    distance(a, b) < NEAR
}

fn hundredths(value: f64) -> String {
    short(&format!("{value:.2}"))
}

fn thousandths(value: f64) -> String {
    short(&format!("{value:.3}"))
}

/// A decimal number without trailing zeros.
fn short(decimal: &str) -> String {
    let short = decimal.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joined(points: &[Flat]) -> String {
        points.iter().map(|(x, y)| format!("{} {};", n(*x), n(*y))).collect()
    }

    #[test]
    fn what_turns_past_half_a_turn_turns_on() {
        let turned = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            vec![(10.0, 10.0), (10.0 + 50.0 * cos, 10.0 + 50.0 * sin)]
        };
        let points: Vec<Vec<Flat>> = [0.0, 100.0, 200.0, 300.0, 400.0].map(turned).into();
        let Pose::Moved { path, angles, .. } = Pose::through(&points, joined) else { panic!("it is rigid") };
        assert_eq!(path, "0 0;50 0;");
        assert!((angles[4] - 400.0).abs() < 1e-9, "{angles:?}");
    }

    #[test]
    fn what_changes_its_length_has_a_path_for_each_instant() {
        let points = [vec![(0.0, 0.0), (10.0, 0.0)], vec![(0.0, 0.0), (20.0, 0.0)]];
        assert_eq!(Pose::through(&points, joined), Pose::Bent(vec!["0 0;10 0;".into(), "0 0;20 0;".into()]));
        assert!(matches!(Pose::through(&points[..1], joined), Pose::Still(_)));
    }
}
