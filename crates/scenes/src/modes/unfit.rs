//! Tests whether contacts, diodes and freewheels admit a start: gaps, their rates, coefficients of friction and restitution.

use super::expansion::{Expansions, Instant, Kind, Touching};
use super::mode::Case;
use super::passage::SLACK;
use super::touches::NEGATIVE;
use model::Sides;

const PENETRATES: &str = "a contact penetrates where a motion should begin: its gap is negative";
const LEFT: &str = "a guide is left where a motion should begin: its gap is not zero";
const LEFT_AT_ONCE: &str = "a guide is left where a motion should begin: the velocity of its gap is not zero";
const STIFF: &str = "the speed of a diode or a freewheel is one that nothing moves";
const TURNED: &str = "a diode or a freewheel starts with a speed against it";
const CLOSES: &str =
    "a contact closes with a velocity where a motion should begin: an impact, before which one has to begin";
const PULLS: &str =
    "a contact pulls where it should push: its normal does not point to where its gap grows, or nothing moves along it";
pub(crate) const RESTITUTION: &str = "a coefficient of restitution is not between 0 and 1";

/// A contact at which a motion cannot start, with the reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unfit {
    /// Index among the contacts of the model.
    pub contact: usize,
    /// The reason, as the second half of a message.
    pub why: &'static str,
    /// Values that the file may give instead.
    pub accepted: &'static str,
    /// The value that is not possible, with its unit.
    pub found: Option<(f64, &'static str)>,
}

impl Unfit {
    /// The first such contact at a state.
    pub(super) fn first(expansions: &Expansions, instant: &Instant<'_>, cases: &[Case]) -> Option<Self> {
        let contacts = expansions.contacts(instant, cases);
        contacts
            .iter()
            .enumerate()
            .find_map(|(contact, touching)| wrong(expansions, instant, (contact, cases), touching))
    }
}

fn wrong(
    expansions: &Expansions,
    instant @ Instant { time, state, .. }: &Instant<'_>,
    (contact, cases): (usize, &[Case]),
    touching: &Touching<1>,
) -> Option<Unfit> {
    let Kind { sides, is_rough, is_guide, is_one_way, is_direct, .. } = expansions.kinds[contact];
    // the mode determines the speed and the reaction of such a contact itself
    if is_direct {
        return None;
    }
    let [friction, restitution] = expansions.coefficients(*time, state, (contact, cases));
    let [gap, rate] = [touching.gap, touching.gap_rate].map(|jet| jet.sign_of(0, SLACK));
    let is_left = sides == Sides::Both && (gap, rate) != (0.0, 0.0);
    let one_sided = sides == Sides::One;
    let (gap_found, rate_found) = ((touching.gap.terms[0], "m"), (touching.gap_rate.terms[0], "m/s"));
    let faults = [
        (is_rough && friction < 0.0, NEGATIVE, "a number that is not negative", Some((friction, "1"))),
        (
            !(0.0..=1.0).contains(&restitution),
            RESTITUTION,
            "a number from 0 (no bounce) to 1 (no loss)",
            Some((restitution, "1")),
        ),
        (
            is_one_way && !expansions.yields(instant, contact),
            STIFF,
            "an inductance or an inertia that its speed moves",
            None,
        ),
        (
            !is_guide && !is_one_way && !expansions.yields(instant, contact),
            PULLS,
            "the direction in which the gap grows",
            None,
        ),
        (is_left && gap != 0.0, LEFT, "a start on the guide; `through` is a point of its line", Some(gap_found)),
        (is_left, LEFT_AT_ONCE, "a start without this velocity", Some(rate_found)),
        (is_one_way && gap < 0.0, TURNED, "a start with a speed that is zero or positive", None),
        (
            one_sided && gap < 0.0,
            PENETRATES,
            "a start where the gap is zero or positive; `touching = true` closes it",
            Some(gap_found),
        ),
        (
            one_sided && gap == 0.0 && rate < 0.0,
            CLOSES,
            "a start above the contact, or without this velocity",
            Some(rate_found),
        ),
    ];
    let (_, why, accepted, found) = faults.into_iter().find(|(is_wrong, ..)| *is_wrong)?;
    Some(Unfit { contact, why, accepted, found })
}
