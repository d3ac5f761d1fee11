//! Pseudo-arclength continuation of a curve: predictor along the tangent, corrector across it, step size by the
//! change of direction.

use super::Curve;
use super::corrector::Corrector;
use nalgebra::DVector;

/// The settings of a continuation. Lengths are in unknowns divided by their sizes.
pub struct ContinuationSettings<'a> {
    /// The usual size of each unknown.
    pub sizes: &'a [f64],
    /// The unknown whose turning points are folds.
    pub parameter: usize,
    /// The longest step.
    pub step: f64,
    /// The largest number of points.
    pub most: usize,
    /// The continuation ends at a point, in the unknowns as they are, for which this is false.
    pub within: &'a dyn Fn(&[f64]) -> bool,
}

/// A point of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    pub x: Vec<f64>,
    /// Whether the parameter turns back here.
    pub fold: bool,
}

/// Why a continuation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BranchEnd {
    /// The next point is not within the bounds.
    Outside,
    /// The curve came back to its beginning.
    Closed,
    /// The largest number of points was reached.
    Enough,
    /// No step succeeded, down to the shortest.
    Stalled,
}

/// A part of a curve, its folds among its points.
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

/// The shortest step, as a share of the longest.
const SHORTEST: f64 = 1e-9;
/// The least cosine between the directions at both ends of a step.
const STRAIGHT: f64 = 0.95;
/// Corrections within which a step counts as easy.
const EASY: u32 = 6;
/// Trials for a fold: a bracketed secant takes about ten.
const MOST_TRIALS: u32 = 60;

/// Follows a curve from a point near it. `towards` points into the direction in which it begins: at the start the curve
/// is sought across it. `None` where there is no curve near the start.
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
        // the beginning lies between this point and the next, and nowhere near beside them
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

/// The point a step ahead with the direction there; `None` where the step is too long.
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

/// The fold, less than a step ahead: the root of the parameter's rate along the curve, by the secant in its bracket
/// (Illinois).
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
