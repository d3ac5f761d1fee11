//! Recognition of distances between two points, of which energies, generalised forces and constraints are functions.
//!
//! The gradient of a function of one distance is parallel to the gradient of the distance, at every point. Hence a term k (r - l)^2/2 of the potential
//! energy is recognised as a spring, and a constraint x^2 + y^2 = l^2 as a rod, in any equivalent form.

use super::covectors::{Covector, Kind};
use super::elements::{Load, grows};
use super::samples::{POINTS, value, values};
use super::{Action, Element, Place};
use crate::Trace;
use symbolic::Sym;

/// The largest squared sine between gradients that count as parallel.
const PARALLEL: f64 = 1e-12;
/// The relative difference below which numbers count as equal.
const VARIES: f64 = 1e-6;
/// If pairs of points times coordinates exceed this number, distances are not examined.
const MOST: usize = 60_000;

/// A covector at each sample point.
type Slopes = Vec<Vec<f64>>;

/// The position of a point, and its derivative along each coordinate, at one sample point.
type Displaced = ([f64; 3], Vec<[f64; 3]>);

/// Returns elements from energies and forces, and rods from constraints. Recognised terms are removed from `loads`.
pub(super) fn along_distances(
    trace: &Trace<'_>,
    places: &[Place],
    (sought, loads): (&[Covector], &mut [Load]),
) -> (Vec<Element>, Vec<[usize; 2]>) {
    let pairs = places.len() * places.len() / 2;
    if sought.is_empty() || pairs * trace.speeds.len() > MOST {
        return (Vec::new(), Vec::new());
    }
    let displaced = displaced(trace, places);
    let (mut elements, mut rods, mut taken) = (Vec::new(), Vec::new(), Vec::new());
    for Covector { kind, slope, written } in sought {
        let action = match *kind {
            Kind::Energy(action) | Kind::Generalised(action) | Kind::Load(action, _) if action != Action::Given => {
                Some(action)
            }
            Kind::Position(_) => None,
            _ => continue,
        };
        let Some(slope) = values(trace, slope) else { continue };
        let of_ends = |ends: [usize; 2]| {
            let found = stretched(&displaced, ends, &slope)?;
            let is_force = action != Some(Action::Elastic) || varies(found.iter().map(|one| one.force));
            // in one dimension every distance is a function of any other
            let is_own = written.contains(&ends) || along_several(&slope) || !varies(found.iter().map(|one| one.rate));
            (is_force && is_own).then_some((ends, found))
        };
        let others = (0..places.len()).flat_map(|b| (0..b).map(move |a| [a, b]));
        // a distance that occurs literally is preferred; then named points, then points with small indices
        let unnamed =
            |(ends, _): &([usize; 2], Vec<Stretched>)| ends.iter().filter(|end| places[**end].name.is_empty()).count();
        let found = written.iter().copied().find_map(of_ends);
        let Some((ends, found)) = found.or_else(|| others.filter_map(of_ends).min_by_key(unnamed)) else { continue };
        if let Kind::Load(_, term) = kind {
            taken.push(*term);
        }
        let forces: Vec<(f64, f64)> = found.iter().map(|one| (one.distance, one.force)).collect();
        match action {
            Some(Action::Elastic) if !grows(&forces) => elements.push(Element { ends, action: Action::Field }),
            Some(action) => elements.push(Element { ends, action }),
            None => rods.push(ends),
        }
    }
    for (number, load) in loads.iter_mut().enumerate() {
        let mut term = 0..;
        load.terms.retain(|_| !taken.contains(&[number, term.next().unwrap_or_default()]));
    }
    elements.dedup();
    (elements, rods)
}

/// Returns whether a covector has more than one nonzero component.
fn along_several(slope: &Slopes) -> bool {
    slope.iter().all(|slope| slope.iter().filter(|part| **part != 0.0).count() > 1)
}

/// A distance at one sample point.
#[derive(Clone, Copy)]
struct Stretched {
    /// The force along the distance.
    force: f64,
    /// The norm of the gradient of the distance.
    rate: f64,
    distance: f64,
}

/// Returns the force along a distance at each sample point, if a covector is parallel to the gradient of the distance.
fn stretched(displaced: &[Vec<Displaced>], [a, b]: [usize; 2], slope: &Slopes) -> Option<Vec<Stretched>> {
    let one = |(places, slope): (&Vec<Displaced>, &Vec<f64>)| {
        let (first, second) = (&places[a], &places[b]);
        let way: [f64; 3] = std::array::from_fn(|k| second.0[k] - first.0[k]);
        let distance = way.iter().map(|part| part * part).sum::<f64>().sqrt();
        let along = |i: usize| (0..3).map(|k| way[k] * (second.1[i][k] - first.1[i][k])).sum::<f64>() / distance;
        let own: Vec<f64> = (0..slope.len()).map(along).collect();
        let [square, product, other] = [(&own, &own), (&own, slope), (slope, slope)]
            .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>());
        // the squared sine of the angle between them
        let is_parallel = square * other - product * product <= PARALLEL * square * other;
        let found = Stretched { force: product / square, rate: square.sqrt(), distance };
        (square > PARALLEL && other > 0.0 && is_parallel && distance.is_finite()).then_some(found)
    };
    displaced.iter().zip(slope).map(one).collect()
}

/// Returns whether the numbers differ.
fn varies(numbers: impl Iterator<Item = f64>) -> bool {
    let (low, high) = numbers.fold((f64::MAX, f64::MIN), |(low, high), number| (low.min(number), high.max(number)));
    high - low > VARIES * low.abs().max(high.abs())
}

/// Returns the positions of points and their derivatives, at each sample point.
fn displaced(trace: &Trace<'_>, places: &[Place]) -> Vec<Vec<Displaced>> {
    let speeds = trace.speeds.len();
    let at = |point: u64| {
        let value = |of: Sym| value(trace, of, point).unwrap_or(f64::NAN);
        let one = |place: &Place| {
            let slope = |i: usize| place.position.map(|part| value(trace.by_coordinate(part, i)));
            (place.position.map(value), (0..speeds).map(slope).collect())
        };
        places.iter().map(one).collect()
    };
    (0..POINTS).map(at).collect()
}
