//! A continuum of motions from one state: the equations of a mode for the reactions are singular but solvable.
//!
//! At the critical friction the matrix A of A N = b is singular. If the system is solvable, N + s n with A n = 0 is a solution for every s, each
//! with a different motion. If the conditions of the mode, which are linear in s, hold on an interval, the motions form a continuum.

use super::expansion::{Accelerations, Expansions, Instant, Reacting};
use super::mode::{Face, Mode, Phase};
use super::touch::Touch;
use nalgebra::{DMatrix, DVector};

/// A singular value below the first constant, relative to the largest, counts as zero. A residual of b below the second constant relative
/// to b, or below the third times its error estimate, counts as zero.
const SINGULAR: f64 = 1e-12;
const LEFT: f64 = 1e-10;
const DOUBTS: f64 = 16.0;

/// Relative changes below this value are rounding errors.
const ROUNDED: f64 = 1e-9;

/// True if a mode with contacts that slide in the plane has a continuum of motions; `touches` are the states of the contacts.
pub(super) fn is_continuum(expansions: &Expansions, instant: &Instant<'_>, mode: &Mode, touches: &[Touch]) -> bool {
    let slides = |phase: &Phase| matches!(phase, Phase::Slips { .. });
    let in_space = |phase: &Phase| matches!(phase, Phase::Glides { .. } | Phase::Leans { .. });
    if !mode.phases.iter().any(slides) || mode.phases.iter().any(in_space) {
        return false;
    }
    let Some(accelerations) = Accelerations::of(expansions, instant, mode) else { return false };
    let equations = accelerations.equations(mode);
    let Some([one, direction]) = line(&equations.slopes, &equations.right, equations.doubt) else { return false };
    let [at, beyond] = [one.clone(), one + direction].map(|found| accelerations.contacts(mode, &equations, &found));
    let contacts = mode.phases.iter().zip(touches).zip(at.iter().zip(&beyond));
    let margins = contacts.clone().flat_map(|((&phase, &touch), (at, beyond))| {
        margins(at, phase, touch).into_iter().zip(margins(beyond, phase, touch))
    });
    let moves = |(_, (at, beyond)): (_, (&Reacting, &Reacting))| {
        let mut parts = at.accelerations.iter().zip(beyond.accelerations);
        parts.any(|(at, beyond)| (beyond - at).abs() > ROUNDED * at.abs().max(1.0))
    };
    is_interval(margins) && contacts.clone().any(moves)
}

/// A particular solution of singular equations, and the direction of the line of all solutions. `None` if the equations are regular or
/// have no solution. `doubt` is the error estimate of the right side.
fn line(slopes: &DMatrix<f64>, right: &DVector<f64>, doubt: f64) -> Option<[DVector<f64>; 2]> {
    if right.is_empty() || !slopes.iter().chain(right.iter()).all(|entry| entry.is_finite()) {
        return None;
    }
    let decomposed = slopes.clone().svd(true, true);
    let values = &decomposed.singular_values;
    let zero = SINGULAR * values.max();
    let (smallest, least) = values.argmin();
    if least > zero {
        return None;
    }
    let one = decomposed.solve(right, zero).ok()?;
    let left = slopes * &one - right;
    let direction = decomposed.v_t.as_ref()?.row(smallest).transpose();
    (left.amax() <= (LEFT * right.amax()).max(DOUBTS * doubt)).then_some([one, direction])
}

/// The quantities of a contact that must not be negative in its phase.
fn margins(contact: &Reacting, phase: Phase, touch: Touch) -> Vec<f64> {
    let Reacting { reactions: [normal, tangent, _], accelerations: [away, along, _], friction } = *contact;
    let pressure = phase.face().map_or(0.0, Face::sign) * normal;
    match phase {
        Phase::Apart if touch == Touch::Open => Vec::new(),
        Phase::Apart => vec![away],
        Phase::Carried => vec![away, -away],
        Phase::Sticks(_) => vec![pressure, friction * pressure - tangent, friction * pressure + tangent],
        Phase::Slips { forwards, .. } if touch == Touch::Rest && friction != 0.0 => {
            vec![pressure, if forwards { along } else { -along }]
        }
        _ => vec![pressure],
    }
}

/// True if functions that are linear in s, given by their values at s = 0 and s = 1, are all nonnegative on an interval of positive
/// length.
fn is_interval(numbers: impl Iterator<Item = (f64, f64)>) -> bool {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for (at, beyond) in numbers {
        let slope = beyond - at;
        match slope.abs() <= ROUNDED * at.abs() {
            true if at < 0.0 => return false,
            true => {}
            false if slope > 0.0 => low = low.max(-at / slope),
            false => high = high.min(-at / slope),
        }
    }
    high - low > ROUNDED * low.abs().min(high.abs()).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::{is_interval, line};
    use nalgebra::{dmatrix, dvector};

    #[test]
    fn solutions_of_singular_equations_lie_on_a_line_where_they_hold() {
        let slopes = dmatrix![1.0, 2.0; 2.0, 4.0];
        let [one, direction] = line(&slopes, &dvector![3.0, 6.0], 0.0).expect("they hold");
        assert!((&slopes * (one + 5.0 * direction) - dvector![3.0, 6.0]).amax() < 1e-13);
        assert_eq!(line(&slopes, &dvector![3.0, 7.0], 0.0), None);
        assert_eq!(line(&dmatrix![1.0, 2.0; 2.0, 1.0], &dvector![3.0, 6.0], 0.0), None);
    }

    #[test]
    fn an_interval_is_longer_than_a_point() {
        assert!(is_interval([(1.0, 0.0), (1.0, 2.0)].into_iter()));
        assert!(!is_interval([(1.0, 0.0), (-1.0, 0.0)].into_iter()));
        assert!(!is_interval([(1.0, 0.0), (-1.0, -1.0)].into_iter()));
    }
}
