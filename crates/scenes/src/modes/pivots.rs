//! Cases of many conditions that are zero at one instant, by pivots, whose number grows polynomially with the number of conditions.
//!
//! The rates g' = a + B s with 0 <= s <= 1, s = 1 for g' > 0 and s = 0 for g' < 0, form a linear complementarity problem. For dry
//! friction B = -G R with a semidefinite matrix G and the bounds R of the forces, and criss-cross pivots in a fixed order terminate
//! (Klafszky and Terlaky 1992). The signs are those of Taylor series in time, ordered lexicographically.

use super::consistency::contradicted;
use super::decision::TERMS;
use super::expansion::{Expansion, Expansions, Instant, Slopes, solved};
use super::jet::Jet;
use super::mode::{Case, Mode};
use num_traits::Zero;

/// The number of block pivots, which change all contradicted cases at once, that are accepted without progress (Judice and Pires 1994).
const PATIENCE: usize = 3;

/// The largest number of pivots, for each open condition.
const PIVOTS: usize = 40;

/// A number counts as zero if it is below this multiple of its error bound.
const PIVOT: f64 = 64.0;

/// Result of a search without consistent cases.
#[derive(Clone, Copy, Debug)]
pub(super) struct NotFound {
    /// True if every condition that had to be held at zero could be held.
    pub is_held: bool,
}

/// Consistent cases of the conditions `open`, with the motion in these cases. The search starts from the cases of `mode`.
///
/// # Errors
/// [`NotFound`] if the pivots do not end, or a condition cannot be held.
pub(super) fn pivoted(
    expansions: &Expansions,
    instant: &Instant<'_>,
    mode: &Mode,
    open: &[usize],
    slack: f64,
) -> Result<(Mode, Expansion<TERMS>), NotFound> {
    let (mut mode, mut fewest, mut patience) = (mode.clone(), usize::MAX, PATIENCE);
    for _ in 0..PIVOTS * open.len() {
        expansions.mirror(&mut mode);
        let Some(expansion) = expansions.at::<TERMS>(instant, &mode) else { return Err(NotFound { is_held: false }) };
        let turned: Vec<(usize, Case)> = open
            .iter()
            .filter_map(|&switch| Some((switch, contradicted(&expansion, mode.cases[switch], switch, slack)?)))
            .collect();
        let Some(&(last, case)) = turned.last() else { return Ok((mode, expansion)) };
        patience = if turned.len() < fewest { PATIENCE } else { patience.saturating_sub(1) };
        fewest = fewest.min(turned.len());
        let slopes = &expansion.slopes;
        let before = mode.clone();
        if patience > 0 {
            let (held, leaving): (Vec<_>, Vec<_>) = turned.into_iter().partition(|(_, case)| *case == Case::Held);
            leaving.into_iter().for_each(|(switch, case)| mode.cases[switch] = case);
            for (switch, _) in held {
                if Implied::of(slopes, &expansions.held(&mode), switch).is_none() {
                    mode.cases[switch] = Case::Held;
                }
            }
        }
        if mode != before {
            continue;
        }
        let implied = if case == Case::Held { Implied::of(slopes, &expansions.held(&mode), last) } else { None };
        if let Some(implied) = implied {
            let Some((other, case)) = leaving(&implied, slopes, (&expansions.held(&mode), last), mode.cases[last])
            else {
                return Err(NotFound { is_held: true });
            };
            mode.cases[other] = case;
        }
        mode.cases[last] = case;
    }
    Err(NotFound { is_held: true })
}

/// The held condition that is released in exchange for a condition whose rate depends on it, and the case that it gets.
fn leaving(
    implied: &Implied,
    slopes: &Slopes<TERMS>,
    (held, switch): (&[usize], usize),
    case: Case,
) -> Option<(usize, Case)> {
    let changes = replaced(slopes, held, switch)?;
    let moves = |other: usize| changes.iter().any(|(held, sign)| *held == other && *sign != 0.0);
    let (other, factor) = implied.terms().filter(|(other, _)| moves(*other)).last()?;
    let rises = (case == Case::On) == (factor > 0.0);
    Some((other, if rises { Case::On } else { Case::Off }))
}

/// A condition whose rate is a linear combination of the rates of held conditions.
#[derive(Debug)]
pub(super) struct Implied {
    held: Vec<usize>,
    factors: Vec<Jet<TERMS>>,
}

impl Implied {
    /// The combination; `None` if the rate of the condition changes with its switch while the others are held.
    pub fn of(slopes: &Slopes<TERMS>, held: &[usize], switch: usize) -> Option<Self> {
        let rows = held.iter().map(|&column| held.iter().map(|&row| slopes[row][column]).collect()).collect();
        let right = held.iter().map(|&column| slopes[switch][column]).collect();
        let factors = solved(rows, right)?;
        let through = held.iter().zip(&factors).map(|(&row, factor)| slopes[row][switch] * *factor);
        let left = slopes[switch][switch] - through.fold(Jet::zero(), |sum, term| sum + term);
        // a derivative that is zero only at this instant is not dependence
        (0..TERMS).all(|order| left.sign_of(order, PIVOT) == 0.0).then(|| Implied { held: held.to_vec(), factors })
    }

    /// The held conditions with nonzero factors, and these factors.
    pub fn terms(&self) -> impl Iterator<Item = (usize, f64)> {
        self.held
            .iter()
            .zip(&self.factors)
            .filter(|(_, factor)| factor.sign_of(0, PIVOT) != 0.0)
            .map(|(&condition, factor)| (condition, factor.terms[0]))
    }
}

/// For each held condition, the sign of the derivative of its switch by the switch of another condition at zero. `None` if the held
/// conditions are dependent.
pub(super) fn replaced(slopes: &Slopes<TERMS>, held: &[usize], switch: usize) -> Option<Vec<(usize, f64)>> {
    let rows = held.iter().map(|&row| held.iter().map(|&column| slopes[row][column]).collect()).collect();
    let right = held.iter().map(|&row| -slopes[row][switch]).collect();
    let changes = solved(rows, right)?;
    let signs = changes.iter().map(|change| change.sign_of(0, PIVOT));
    Some(held.iter().copied().zip(signs).collect())
}
