//! Gears: constraints that are linear in the angles of two frames.

use super::covectors::{Covector, Kind};
use super::hinges::{Hinge, is_even};
use super::samples::values;
use super::torsion::is_angle;
use crate::{FrameId, Trace};

/// Components of a covector below this relative size count as zero.
const NONE: f64 = 1e-9;
/// The largest number of pairs of hinges that are compared.
const MOST: usize = 20_000;

/// Two angles that are coupled by a constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct Gear {
    /// The name of the constraint; empty if it has none.
    pub name: String,
    /// The two angles.
    pub turns: [GearTurn; 2],
    /// The ratio of the second angular velocity to the first.
    pub ratio: f64,
}

/// An angle of a gear.
#[derive(Clone, Debug, PartialEq)]
pub enum GearTurn {
    /// The angle of a frame relative to the carrier of the gear, about a common axis.
    Frame { carrier: FrameId, frame: FrameId, axis: usize },
    /// A coordinate that is an angle, without a frame.
    Coordinate(usize),
}

/// Returns the gears among the constraints.
pub(super) fn gears(trace: &Trace<'_>, hinges: &[Hinge], sought: &[Covector]) -> Vec<Gear> {
    let even: Vec<&Hinge> = hinges.iter().filter(|hinge| hinge.is_even()).collect();
    let one = |covector: &Covector| {
        let (Kind::Position(place) | Kind::Speed(place)) = covector.kind else { return None };
        let slopes = values(trace, &covector.slope)?;
        let slope = slopes.first()?;
        if !is_even(slopes.iter()) {
            return None;
        }
        let name = trace.model.constraints[place].name.clone().unwrap_or_default();
        of_frames(&even, slope).or_else(|| of_coordinates(trace, slope)).map(|(turns, ratio)| Gear {
            name,
            turns,
            ratio,
        })
    };
    sought.iter().filter_map(one).collect()
}

/// Finds two hinges with a common carrier whose gradients combine to a covector. The ground is the preferred carrier.
fn of_frames(hinges: &[&Hinge], covector: &[f64]) -> Option<([GearTurn; 2], f64)> {
    let mut order: Vec<&Hinge> = hinges.to_vec();
    order.sort_by_key(|hinge| hinge.frames[0]);
    let pairs = order
        .iter()
        .enumerate()
        .flat_map(|(number, second)| order[..number].iter().map(move |first| (*first, *second)));
    let mut fitting = pairs.take(MOST).filter(|(first, second)| first.frames[0] == second.frames[0]);
    fitting.find_map(|(first, second)| {
        let [one, other] = shares([slope(first), slope(second)], covector)?;
        let turn = |hinge: &Hinge| {
            let [carrier, frame] = hinge.frames;
            GearTurn::Frame { carrier, frame, axis: hinge.axis }
        };
        Some(([turn(first), turn(second)], -one / other))
    })
}

fn slope(hinge: &Hinge) -> &[f64] {
    hinge.turned.first().map_or(&[], |at| &at.slope)
}

/// Returns the two nonzero coefficients with which two covectors combine to a third.
fn shares([a, b]: [&[f64]; 2], covector: &[f64]) -> Option<[f64; 2]> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let determinant = aa * bb - ab * ab;
    if determinant <= NONE * aa * bb {
        return None;
    }
    let (ac, bc) = (dot(a, covector), dot(b, covector));
    let [one, other] = [(ac * bb - bc * ab) / determinant, (bc * aa - ac * ab) / determinant];
    let size = covector.iter().fold(0.0, |size: f64, part| size.max(part.abs()));
    let mut parts = covector.iter().zip(a.iter().zip(b)).map(|(c, (a, b))| (c - one * a - other * b).abs());
    (one.abs() > NONE * size && other.abs() > NONE * size && parts.all(|part| part <= NONE * size))
        .then_some([one, other])
}

/// Returns the two coordinates of a constraint, if both are angles.
fn of_coordinates(trace: &Trace<'_>, covector: &[f64]) -> Option<([GearTurn; 2], f64)> {
    let held: Vec<usize> = (0..covector.len()).filter(|i| covector[*i] != 0.0).collect();
    let [first, second] = held.try_into().ok()?;
    let turns = [first, second].map(GearTurn::Coordinate);
    (is_angle(trace, first) && is_angle(trace, second)).then(|| (turns, -covector[first] / covector[second]))
}
