//! The critical friction: for smaller coefficients of friction, the reactions of contacts are determined for all loads.
//!
//! The normal reactions N of closed contacts solve A N = b. The friction of a sliding contact contributes to the column of its N:
//!
//!   A = W_nn - mu sign(v) W_nt .
//!
//! If all coefficients are multiplied by s, the determinant of A is a polynomial in s, positive at s = 0. At its smallest positive zero the
//! reactions are unbounded, and beyond it there may be no motion with this sliding, or several (Painlevé 1895). This zero is the reciprocal of
//! the largest real eigenvalue of W_nn^-1 mu sign(v) W_nt. The result is the minimum over all sets of pressing contacts and directions of sliding.

use super::contacts::PARTS;
use super::expansion::{Expansions, Instant, Kind};
use super::mode::{Face, Mode, Phase};
use super::touch::Touch;
use integrators::eigenvalues;
use nalgebra::DMatrix;

/// The largest number of closed contacts: three states of each are combined.
const MOST: usize = 7;

/// An eigenvalue counts as real if its imaginary part is below this fraction of its real part.
const REAL: f64 = 1e-9;

/// An eigenvalue below this value is a rounding error: no friction is critical.
const LEAST: f64 = 1e-12;

/// Contacts whose responses have a relative singular value below this value are dependent and cannot press together.
const RANK: f64 = 1e-11;

/// The factor by which all coefficients of friction must be multiplied until reactions are not determined, and the mode in which this
/// happens.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Critical {
    /// The factor of all coefficients of friction.
    pub factor: f64,
    /// The mode: contacts of the critical set slide, all others are open.
    pub mode: Mode,
}

/// The index of a sliding contact, and its phase, which gives the sign of the friction.
type Sliding = (usize, Phase);

impl Critical {
    /// The critical friction at a state; `None` if no factor is critical, a contact slides in space, or more than [`MOST`] contacts are
    /// closed.
    pub fn of(expansions: &Expansions, instant: &Instant<'_>, mode: &Mode, touches: &[Touch]) -> Option<Self> {
        let in_touch = |kind: &Kind, touch: Touch| touch != Touch::Open && !kind.is_one_way;
        let touching: Vec<usize> = (0..touches.len()).filter(|&k| in_touch(&expansions.kinds[k], touches[k])).collect();
        if touching.len() > MOST || touching.iter().any(|&contact| expansions.kinds[contact].is_in_space) {
            return None;
        }
        let responses = expansions.responses_of_contacts(instant);
        let friction = |contact: usize| {
            let is_rough = expansions.kinds[contact].is_rough;
            if is_rough { expansions.coefficients(instant.time, instant.state, (contact, &mode.cases))[0] } else { 0.0 }
        };
        let friction: Vec<f64> = (0..touches.len()).map(friction).collect();
        let mut sets: Vec<Vec<Sliding>> = vec![Vec::new()];
        for &contact in &touching {
            let phases = directions(expansions.kinds[contact], touches[contact]);
            let with = |set: &Vec<Sliding>| {
                let added = phases.iter().map(|&phase| [&set[..], &[(contact, phase)]].concat());
                [set.clone()].into_iter().chain(added).collect::<Vec<_>>()
            };
            sets = sets.iter().flat_map(with).collect();
        }
        let of = |set: Vec<Sliding>| Some((factor(&responses, &friction, &set)?, set));
        let (factor, set) = sets.into_iter().filter_map(of).min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        let mut mode = mode.clone();
        mode.phases.fill(Phase::Apart);
        set.into_iter().for_each(|(contact, phase)| mode.phases[contact] = phase);
        Some(Critical { factor, mode })
    }
}

/// The sliding phases that are possible for a contact.
fn directions(kind: Kind, touch: Touch) -> Vec<Phase> {
    let both = match touch {
        Touch::Slides { forwards } => vec![forwards],
        _ if kind.is_rough => vec![true, false],
        _ => vec![true],
    };
    let faces = Face::of(kind.sides);
    both.into_iter().flat_map(|forwards| faces.iter().map(move |&face| Phase::Slips { forwards, face })).collect()
}

/// The smallest factor of friction at which the reactions of a set of sliding contacts are not determined; `None` if there is none.
fn factor(responses: &DMatrix<f64>, friction: &[f64], set: &[Sliding]) -> Option<f64> {
    if set.is_empty() {
        return None;
    }
    let place = |contact: usize, part: usize| PARTS * contact + part;
    let own = DMatrix::from_fn(set.len(), set.len(), |row, column| {
        responses[(place(set[row].0, 0), place(set[column].0, 0))]
    });
    let tied = DMatrix::from_fn(set.len(), set.len(), |row, column| {
        let (contact, phase) = set[column];
        let sign = phase.way().unwrap_or(0.0) * phase.face().map_or(1.0, Face::sign);
        friction[contact] * sign * responses[(place(set[row].0, 0), place(contact, 1))]
    });
    if !own.iter().chain(tied.iter()).all(|entry| entry.is_finite()) {
        return None;
    }
    let singular = own.singular_values();
    if singular.min() <= RANK * singular.max() {
        return None;
    }
    let values = eigenvalues(&own.lu().solve(&tied)?)?;
    let real = values.iter().filter(|value| value.re > 0.0 && value.im.abs() <= REAL * value.re).map(|value| value.re);
    let largest = real.fold(0.0, f64::max);
    (largest > LEAST).then(|| 1.0 / largest)
}

#[cfg(test)]
mod tests {
    use super::{Face, Phase, factor};
    use nalgebra::DMatrix;

    /// A rod with W_nn = 1 + 3 c^2 and W_nt = -3 s c has the critical friction (1 + 3 c^2)/(3 s c) for backward sliding; for forward
    /// sliding no friction is critical (Painlevé 1895).
    #[test]
    fn a_rod_has_the_friction_of_painleve() {
        let (s, c) = 1.0_f64.sin_cos();
        let mut responses = DMatrix::zeros(3, 3);
        (responses[(0, 0)], responses[(0, 1)]) = (1.0 + 3.0 * c * c, -3.0 * s * c);
        let slides = |forwards: bool| factor(&responses, &[0.5], &[(0, Phase::Slips { forwards, face: Face::Front })]);
        assert_eq!(slides(true), None);
        let known = (1.0 + 3.0 * c * c) / (3.0 * s * c) / 0.5;
        assert!((slides(false).unwrap() - known).abs() < 1e-14 * known);
    }
}
