//! Pseudo-arclength continuation of a curve: predictor along the tangent, corrector in the plane normal to it, step
//! size from the change of direction.

use super::Curve;
use super::corrector::Corrector;
use nalgebra::DVector;

/// Settings of a continuation. Lengths are measured in the unknowns divided by `sizes`.
pub struct ContinuationSettings<'a> {
    /// The typical magnitude of each unknown.
    pub sizes: &'a [f64],
    /// The index of the unknown that is the bifurcation parameter: its turning points are folds.
    pub parameter: usize,
    /// The longest step.
    pub step: f64,
    /// The largest number of points of the branch.
    pub most: usize,
    /// The range of the continuation: it ends at the first point, in unscaled unknowns, for which the function returns
    /// false.
    pub within: &'a dyn Fn(&[f64]) -> bool,
}

/// A point of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    pub x: Vec<f64>,
    /// Whether this point is a fold: the parameter has a turning point here.
    pub fold: bool,
}

/// The reason why a continuation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BranchEnd {
    /// The next point is outside the range `within`.
    Outside,
    /// The curve is closed: it returned to its first point.
    Closed,
    /// The largest number of points was reached.
    Enough,
    /// No step converged, down to the shortest step size.
    Stalled,
}

/// A part of a curve: its points in order, folds included, and the reason of its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    pub places: Vec<CurvePoint>,
    pub last: BranchEnd,
}

impl Branch {
    /// The folds of the branch.
    pub fn folds(&self) -> impl Iterator<Item = &CurvePoint> {
        self.places.iter().filter(|place| place.fold)
    }
}

/// The shortest step size, as a fraction of the largest.
const SHORTEST: f64 = 1e-9;
/// The smallest allowed cosine of the angle between the tangents at both ends of a step.
const STRAIGHT: f64 = 0.95;
/// The step size grows after a step that took at most this many corrections.
const EASY: u32 = 6;
/// The largest number of iterations for a fold; the bracketed secant method takes about ten.
const MOST_TRIALS: u32 = 60;

/// Continues a curve from a point near it. `towards` is the initial direction; the first point is found in the plane
/// through `start` normal to `towards`. `None` where Newton's iteration finds no point of the curve near the start.
pub fn continue_branch(
    curve: &mut dyn Curve,
    start: &[f64],
    towards: &[f64],
    walk: &ContinuationSettings<'_>,
) -> Option<Branch> {
    let scaled = |x: &[f64]| DVector::from_iterator(x.len(), x.iter().zip(walk.sizes).map(|(x, size)| x / size));
    let mut corrector = Corrector::new(curve, walk.sizes);
    let along = scaled(towards).normalize();
    let mut x = corrector.onto(&scaled(start), &along, f64::INFINITY)?;
    let mut direction = corrector.direction(&x, &along)?;
    let place = |x: &DVector<f64>, fold| {
        let x = x.iter().zip(walk.sizes).map(|(x, size)| x * size).collect();
        CurvePoint { x, fold }
    };
    let first = (x.clone(), direction.clone());
    let mut places = vec![place(&x, false)];
    let mut step = 0.1 * walk.step;
    while places.len() < walk.most {
        let Some((next, ahead)) = taken(&mut corrector, &x, &direction, step) else {
            step *= 0.5;
            if step < SHORTEST * walk.step {
                return Some(Branch { places, last: BranchEnd::Stalled });
            }
            continue;
        };
        let easy = corrector.corrections <= EASY;
        if direction[walk.parameter] * ahead[walk.parameter] < 0.0
            && let Some(fold) = turning(&mut corrector, (&x, &direction), (step, ahead[walk.parameter]), walk.parameter)
        {
            places.push(place(&fold, true));
        }
        let arrived = place(&next, false);
        if !(walk.within)(&arrived.x) {
            return Some(Branch { places, last: BranchEnd::Outside });
        }
        // the curve is closed if the first point lies within this step, close to the tangent
        let back = &first.0 - &x;
        let passed = direction.dot(&back);
        let beside = (&back - &direction * passed).norm();
        let closed =
            places.len() > 3 && passed > 0.0 && passed <= step && beside < 0.1 * step && ahead.dot(&first.1) > 0.0;
        if closed {
            places.push(place(&first.0, false));
            return Some(Branch { places, last: BranchEnd::Closed });
        }
        places.push(arrived);
        (x, direction) = (next, ahead);
        if easy {
            step = (1.5 * step).min(walk.step);
        }
    }
    Some(Branch { places, last: BranchEnd::Enough })
}

/// The point of the curve one step ahead, and the tangent there; `None` where the step is too long.
fn taken(
    corrector: &mut Corrector<'_>,
    x: &DVector<f64>,
    direction: &DVector<f64>,
    step: f64,
) -> Option<(DVector<f64>, DVector<f64>)> {
    let next = corrector.onto(&(x + direction * step), direction, step)?;
    let corrections = corrector.corrections;
    let ahead = corrector.direction(&next, direction)?;
    corrector.corrections = corrections;
    (ahead.dot(direction) >= STRAIGHT).then_some((next, ahead))
}

/// The fold within a step: the zero of the parameter's derivative along the curve, by the Illinois variant of the
/// secant method in its bracket.
fn turning(
    corrector: &mut Corrector<'_>,
    (x, direction): (&DVector<f64>, &DVector<f64>),
    (step, rate): (f64, f64),
    parameter: usize,
) -> Option<DVector<f64>> {
    let (mut low, mut high) = ((0.0, direction[parameter]), (step, rate));
    let mut best = None;
    for _ in 0..MOST_TRIALS {
        let length = high.0 - high.1 * (high.0 - low.0) / (high.1 - low.1);
        let (point, ahead) = taken(corrector, x, direction, length)?;
        let rate = ahead[parameter];
        best = Some(point);
        if rate == 0.0 || (length - low.0).abs().min((length - high.0).abs()) <= f64::EPSILON * step {
            break;
        }
        match rate * low.1 > 0.0 {
            true => {
                low = (length, rate);
                high.1 *= 0.5;
            }
            false => {
                high = (length, rate);
                low.1 *= 0.5;
            }
        }
    }
    best
}
