//! Hinges: pairs of frames that rotate relative to each other about a common axis.

use super::samples::{POINTS, value};
use crate::{FrameId, Trace, Turn};

/// The largest squared sine between covectors that count as parallel.
const PARALLEL: f64 = 1e-12;
/// The relative difference below which numbers count as equal.
const SAME: f64 = 1e-9;
/// If the squared number of frames times the speeds exceeds this number, only pairs with the parent frame or the ground are hinges.
const MOST: usize = 60_000;

/// Two frames with a common axis.
#[derive(Clone, Debug)]
pub(super) struct Hinge {
    pub frames: [FrameId; 2],
    /// The common axis: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// The angle from the first frame to the second, and its gradient, at each sample point.
    pub turned: Vec<Turned>,
    /// Whether the second frame is defined in the first.
    is_joint: bool,
}

/// An angle in radians and its gradient along the coordinates, at one sample point.
#[derive(Clone, Debug, Default)]
pub(super) struct Turned {
    pub angle: f64,
    pub slope: Vec<f64>,
}

impl Turned {
    fn plus(&self, other: &Turned, sign: f64) -> Turned {
        let slope = self.slope.iter().zip(&other.slope).map(|(a, b)| a + sign * b).collect();
        Turned { angle: self.angle + sign * other.angle, slope }
    }
}

/// Returns all hinges whose angle depends on coordinates. Hinges of a frame and its parent come first.
pub(super) fn hinges(trace: &Trace<'_>) -> Vec<Hinge> {
    let frames = &trace.model.frames;
    let own: Vec<Option<(usize, Vec<Turned>)>> = (0..frames.len()).map(|frame| own_turn(trace, frame)).collect();
    let is_small = frames.len() * frames.len() * trace.speeds.len() <= MOST;
    let parent = |frame: usize| frames[frame].parent.map(|(parent, _)| parent.0);
    let mut found = Vec::new();
    for second in 1..frames.len() {
        for first in (0..frames.len()).filter(|first| *first != second) {
            let is_joint = parent(second) == Some(first);
            if (is_small && first < second) || is_joint || first == 0 {
                found.extend(between(trace, &own, [first, second], is_joint));
            }
        }
    }
    found.sort_by_key(|hinge: &Hinge| !hinge.is_joint);
    found
}

/// Returns the axis and angle of a frame relative to its parent, at each sample point; `None` for the ground and for free frames.
fn own_turn(trace: &Trace<'_>, frame: usize) -> Option<(usize, Vec<Turned>)> {
    let (_, Turn::About { axis, angle }) = trace.model.frames[frame].parent? else { return None };
    let angle = trace.scalar(angle);
    let at = |point: u64| {
        let slope = (0..trace.speeds.len()).map(|i| value(trace, trace.by_coordinate(angle, i), point));
        Some(Turned { angle: value(trace, angle, point)?, slope: slope.collect::<Option<_>>()? })
    };
    Some((axis, (0..POINTS).map(at).collect::<Option<_>>()?))
}

/// Returns the hinge of two frames; `None` if they have no common axis, or do not rotate relative to each other.
fn between(
    trace: &Trace<'_>,
    own: &[Option<(usize, Vec<Turned>)>],
    [first, second]: [usize; 2],
    is_joint: bool,
) -> Option<Hinge> {
    let path = |mut frame: usize| {
        let mut path = vec![frame];
        while let Some((parent, _)) = trace.model.frames[frame].parent {
            frame = parent.0;
            path.push(frame);
        }
        path
    };
    let paths = [path(first), path(second)];
    let shared = paths[0].iter().rev().zip(paths[1].iter().rev()).take_while(|(a, b)| a == b).count();
    let mut axis = None;
    let none = Turned { angle: 0.0, slope: vec![0.0; trace.speeds.len()] };
    let mut turned = vec![none; POINTS as usize];
    for (path, sign) in paths.iter().zip([-1.0, 1.0]) {
        for frame in &path[..path.len() - shared] {
            let (about, angles) = own[*frame].as_ref()?;
            if *axis.get_or_insert(*about) != *about {
                return None;
            }
            turned = turned.iter().zip(angles).map(|(sum, angle)| sum.plus(angle, sign)).collect();
        }
    }
    let moves = turned.iter().all(|at| at.slope.iter().any(|part| part.abs() > SAME));
    moves.then_some(Hinge { frames: [FrameId(first), FrameId(second)], axis: axis?, turned, is_joint })
}

impl Hinge {
    /// Returns the torque about the axis at each sample point, if a covector is parallel to the gradient of the angle.
    pub fn torque(&self, covector: &[Vec<f64>]) -> Option<Vec<f64>> {
        let one = |(at, covector): (&Turned, &Vec<f64>)| {
            let [square, product, other] = [(&at.slope, &at.slope), (&at.slope, covector), (covector, covector)]
                .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>());
            let is_parallel = square * other - product * product <= PARALLEL * square * other;
            (other > 0.0 && is_parallel).then_some(product / square)
        };
        self.turned.iter().zip(covector).map(one).collect()
    }

    /// Returns whether a restoring torque increases linearly with the angle.
    pub fn is_spring(&self, torque: &[f64]) -> bool {
        let (Some(first), Some(start)) = (self.turned.first(), torque.first()) else { return false };
        let rise = |(at, torque): (&Turned, &f64)| (at.angle - first.angle, torque - start);
        let rises: Vec<(f64, f64)> = self.turned.iter().zip(torque).skip(1).map(rise).collect();
        let Some(&(run, rise)) = rises.first() else { return false };
        let is_straight =
            |(x, y): &(f64, f64)| (y * run - x * rise).abs() <= SAME * (x * rise).abs().max((y * run).abs());
        run * rise > 0.0 && rises.iter().all(is_straight)
    }

    /// Returns whether the gradient of the angle is equal at all sample points.
    pub fn is_even(&self) -> bool {
        is_even(self.turned.iter().map(|at| &at.slope))
    }
}

/// Returns whether covectors are equal at all sample points.
pub(super) fn is_even<'a>(mut covectors: impl Iterator<Item = &'a Vec<f64>>) -> bool {
    let Some(first) = covectors.next() else { return true };
    let size = first.iter().fold(0.0, |size: f64, part| size.max(part.abs()));
    covectors.all(|other| first.iter().zip(other).all(|(a, b)| (a - b).abs() <= SAME * size))
}
