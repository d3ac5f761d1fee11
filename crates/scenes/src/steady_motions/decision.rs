//! The result of a search: isolated motions, families of motions if there are fewer independent equations than unknowns, and undecided boxes.

use super::angle_sums::AngleSums;
use super::equations::{SteadyEquations, Unknown};
use super::families::{self, Family};
use super::search::Boxes;
use super::tapes::Tapes;
use algebra::boxes::{Found, Limits, Zero, zeros};
use field::Interval;

/// Number of boxes examined before families are searched with the help of identities.
const FIRST: usize = 2_000;

/// A box is not divided along an unknown if its width is below this fraction of the range.
const SMALLEST: f64 = 1e-7;

/// The result of a search.
#[derive(Default)]
pub(super) struct Decision {
    pub found: Found,
    pub families: Vec<Family>,
    /// The volume of undecided boxes as a fraction of the whole.
    pub undecided_part: f64,
}

impl Decision {
    /// Searches the box `domain` with at most `most` boxes; ends early when `goes_on` returns false.
    pub fn of(
        equations: &SteadyEquations,
        boxes: &mut Boxes<'_>,
        domain: &[Interval],
        most: usize,
        mut goes_on: impl FnMut() -> bool,
    ) -> Self {
        if equations.is_unbalanced {
            return Decision::default();
        }
        let is_fewer = equations.rows < equations.unknowns.len() + equations.reactions;
        let first = if equations.identities.is_empty() { most } else { most.min(FIRST) };
        let mut found = match &equations.by_sums {
            _ if is_fewer => Found { undecided: vec![domain.to_vec()], ..Found::default() },
            Some(by_sums) => {
                let own = Self::by_sums(equations, by_sums, first, &mut goes_on);
                if own.found.undecided.is_empty() || equations.identities.is_empty() {
                    return own;
                }
                // families are described by the angles, not by their sums
                Found { undecided: vec![domain.to_vec()], examined: own.found.examined, ..Found::default() }
            }
            None => zeros(boxes, domain, Limits { boxes: first, smallest: SMALLEST }, &mut goes_on),
        };
        let mut families = Vec::new();
        if is_fewer || !(found.undecided.is_empty() || equations.identities.is_empty()) {
            let open = std::mem::take(&mut found.undecided);
            let left = most.saturating_sub(found.examined);
            let own = families::families(equations, boxes, (domain, open), left, goes_on);
            found.examined += own.examined;
            found.undecided = own.undecided;
            families = own.families;
        }
        let undecided_part = part(&found.undecided, domain);
        Decision { found, families, undecided_part }
    }

    /// Searches with sums of angles as unknowns; the result is converted to the angles.
    fn by_sums(
        equations: &SteadyEquations,
        (sums, tapes): &(AngleSums, Tapes),
        most: usize,
        mut goes_on: impl FnMut() -> bool,
    ) -> Self {
        let unknowns = &equations.unknowns;
        let domain: Vec<Interval> = unknowns.iter().map(|unknown| unknown.range.interval()).collect();
        let mut turned = Boxes::of(equations, tapes);
        let limits = Limits { boxes: most, smallest: SMALLEST };
        let found = zeros(&mut turned, &domain, limits, &mut goes_on);
        let undecided_part = part(&found.undecided, &domain);
        let told = |at: &[Interval]| sums.unknowns(&at[..unknowns.len()], unknowns);
        let mut own = Found { examined: found.examined, ..Found::default() };
        own.zeros.extend(found.zeros.iter().map(|zero| sums.zero(zero, unknowns)));
        own.undecided.extend(found.undecided.iter().map(|at| told(at)));
        Decision { found: own, families: Vec::new(), undecided_part }
    }
}

/// The volume of boxes as a fraction of a box that contains them.
pub(super) fn part(boxes: &[Vec<Interval>], whole: &[Interval]) -> f64 {
    let volume =
        |at: &Vec<Interval>| at.iter().zip(whole).map(|(at, whole)| at.width() / whole.width()).product::<f64>();
    boxes.iter().map(volume).sum::<f64>().clamp(0.0, 1.0) + 0.0
}

/// Whether a zero may lie in the ranges of the search.
pub(super) fn is_in_range(unknowns: &[Unknown], zero: &Zero) -> bool {
    let meets = |(unknown, at): (&Unknown, &Interval)| unknown.is_circle || at.and(unknown.range.interval()).is_some();
    unknowns.iter().zip(&zero.enclosure).all(meets)
}
