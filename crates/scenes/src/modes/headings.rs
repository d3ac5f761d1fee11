//! Directions in which a contact in space begins to slide from rest.
//!
//! With T = -mu |N| d the slip begins with an acceleration a that depends on d, and d is its own direction: a = |a| d. Where friction is
//! just at its bound a is zero; then d = -T/|T| of the contact that sticks so far, and d turns so that the rate of a lies along d.

use super::combinations::leaning;
use super::expansion::{Expansion, Expansions, Instant, direction};
use super::mode::{Face, Heading, Mode, Phase};
use super::passage::SLACK;
use super::touch::margins;
use std::f64::consts::TAU;

/// A part across below this part of the one along is rounding.
const STRAIGHT: f64 = 1e-10;

/// Directions that are tried, and steps to where a direction is its own.
const TRIED: usize = 64;
const STEPS: usize = 80;

/// Every direction in which a contact may begin to slide, the phases of the others being those of a mode.
pub(super) fn headings(
    expansions: &Expansions,
    instant: &Instant<'_>,
    mode: &Mode,
    (contact, face): (usize, Face),
) -> Vec<Heading> {
    let slip = Slip { expansions, instant, mode, contact, face };
    match slip.at_bound() {
        Some(heading) => vec![heading],
        None => slip.own_directions(),
    }
}

struct Slip<'a> {
    expansions: &'a Expansions,
    instant: &'a Instant<'a>,
    mode: &'a Mode,
    contact: usize,
    face: Face,
}

impl Slip<'_> {
    fn in_phase<const N: usize>(&self, phase: Phase) -> Option<Expansion<N>> {
        let mut mode = self.mode.clone();
        mode.phases[self.contact] = phase;
        self.expansions.at::<N>(self.instant, &mode)
    }

    /// The component of a term of the sliding velocity across a direction, and that along it.
    fn parts<const N: usize>(&self, heading: Heading, order: usize) -> Option<[f64; 2]> {
        let found = self.in_phase::<N>(Phase::Glides { face: self.face, begins: Some(heading) })?;
        let [cos, sin] = direction::<1>(Heading::of(heading.angle(), 0.0)).map(|jet| jet.terms[0]);
        let contact = &found.contacts[self.contact];
        let [along, aside] = [contact.slide, contact.aside].map(|jet| jet.terms[order]);
        let parts = [cos * aside - sin * along, cos * along + sin * aside];
        parts.iter().all(|part| part.is_finite()).then_some(parts)
    }

    /// The direction where friction is at its bound.
    fn at_bound(&self) -> Option<Heading> {
        let sticks = Phase::Sticks(self.face);
        let mut held = [sticks].into_iter().chain(leaning(sticks, true));
        let held = held.find_map(|phase| self.in_phase::<2>(phase))?;
        let contact = &held.contacts[self.contact];
        let [_, first, second] = contact.reactions.map(|reaction| reaction.terms[0]);
        if margins(contact, self.face)[1].sign_of(0, SLACK) != 0.0 || first == 0.0 && second == 0.0 {
            return None;
        }
        let angle = (-second).atan2(-first);
        // the part across is linear in the rate of the angle
        let parts = |turn: f64| self.parts::<3>(Heading::of(angle, turn), 2);
        let ([none, along], [one, _]) = (parts(0.0)?, parts(1.0)?);
        // on a line that constraints leave it does not turn
        let is_straight = none.abs() <= STRAIGHT * along.abs() || (one - none).abs() <= STRAIGHT * none.abs();
        Some(Heading::of(angle, if is_straight { 0.0 } else { -none / (one - none) }))
    }

    /// Directions along which the slip that they give begins.
    fn own_directions(&self) -> Vec<Heading> {
        let at = |angle: f64| self.parts::<2>(Heading::of(angle, 0.0), 1);
        let step = TAU / TRIED as f64;
        // no multiple of a right angle, along which a slip often begins
        let tried: Vec<(f64, Option<[f64; 2]>)> =
            (0..=TRIED).map(|place| (place as f64 - 0.382) * step).map(|angle| (angle, at(angle))).collect();
        let between = |pair: &[(f64, Option<[f64; 2]>)]| {
            let [(low, at_low), (high, at_high)] = [pair[0], pair[1]];
            let [at_low, at_high] = [at_low?[0], at_high?[0]];
            if at_low == 0.0 || (at_low > 0.0) == (at_high > 0.0) {
                return (at_low == 0.0).then_some(low);
            }
            Some(zero(|angle| at(angle).map_or(f64::NAN, |parts| parts[0]), [low, high], [at_low, at_high]))
        };
        let own = tried.windows(2).filter_map(between);
        own.filter(|&angle| at(angle).is_some_and(|[_, along]| along > 0.0))
            .map(|angle| Heading::of(angle, 0.0))
            .collect()
    }
}

/// The zero of a function between places where its signs differ: by secants, the end that stays counts half (Dowell and Jarratt 1971).
fn zero(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2], [mut at_low, mut at_high]: [f64; 2]) -> f64 {
    let mut side = 0;
    for _ in 0..STEPS {
        let place = (low * at_high - high * at_low) / (at_high - at_low);
        let value = of(place);
        if value == 0.0 || place == low || place == high || !value.is_finite() {
            return place;
        }
        if (value > 0.0) == (at_high > 0.0) {
            (high, at_high) = (place, value);
            if side == 1 {
                at_low /= 2.0;
            }
            side = 1;
        } else {
            (low, at_low) = (place, value);
            if side == -1 {
                at_high /= 2.0;
            }
            side = -1;
        }
        if (high - low).abs() <= 2.0 * f64::EPSILON * low.abs().max(high.abs()) {
            return place;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::zero;

    #[test]
    fn a_zero_is_found_to_rounding() {
        let found = zero(|x| x.cos() - x, [0.0, 1.5], [1.0, 1.5_f64.cos() - 1.5]);
        assert!((found - 0.739_085_133_215_160_6).abs() < 1e-15);
    }
}
