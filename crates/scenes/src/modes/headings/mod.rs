//! Directions in which contacts in space begin to slide from rest.
//!
//! A contact that begins to slip in the direction d has the friction T = -mu |N| d. Its acceleration a depends on all directions, and
//! must have the direction d: a = |a| d. If friction is exactly at its bound, a is zero; then d = -T/|T| with the friction T of sticking,
//! and the directions rotate such that the rate of each a is parallel to its d.

mod alone;
mod together;

use super::combinations::leaning;
use super::expansion::{Accelerations, Expansions, Instant};
use super::jet::ROUNDING;
use super::mode::{Face, Heading, Mode, Phase};
use super::passage::SLACK;
use super::touch::margins;
use field::{Analytic, Circle, Elementary};
use nalgebra::{DMatrix, DVector};

/// The accuracy of a direction, in machine epsilons.
const FOUND: f64 = 8.0;

/// A component normal to the direction below this part of the component along it is a rounding error.
const STRAIGHT: f64 = 1e-10;

/// All directions in which the contacts `beginning` may begin to slide together; each result has one direction for each contact. Other
/// contacts have the phases of `mode`.
pub(super) fn headings(
    expansions: &Expansions,
    instant: &Instant<'_>,
    mode: &Mode,
    beginning: &[(usize, Face)],
) -> Vec<Vec<Heading>> {
    let slip =
        Slip { expansions, instant, mode, beginning, accelerations: Accelerations::of(expansions, instant, mode) };
    let held = held(expansions, instant, mode, beginning).and_then(|held| slip.by_friction(&held));
    match held {
        Some((headings, true)) => slip.at_bound(&headings).into_iter().collect(),
        _ if beginning.len() == 1 => slip.of_one(),
        held => slip.of_several(held.map(|(headings, _)| headings)),
    }
}

/// The mode with the contacts `beginning` held instead of sliding, along both tangents, one or none, as far as other contacts leave them
/// free. All normals are added before tangents. `None` if the mode has no motion.
pub(super) fn held(
    expansions: &Expansions,
    instant: &Instant<'_>,
    mode: &Mode,
    beginning: &[(usize, Face)],
) -> Option<Mode> {
    let mut held = mode.clone();
    for &(contact, face) in beginning {
        held.phases[contact] = Phase::Leans { face, held: [false; 2] };
    }
    expansions.at::<1>(instant, &held)?;
    for &(contact, face) in beginning {
        let (by_normal, sticks) = (held.phases[contact], Phase::Sticks(face));
        let mut ways = [sticks].into_iter().chain(leaning(sticks, true));
        let found = ways.find(|&phase| {
            held.phases[contact] = phase;
            expansions.at::<1>(instant, &held).is_some()
        });
        held.phases[contact] = found.unwrap_or(by_normal);
    }
    Some(held)
}

/// A constant direction with rounding error only.
fn exact(angle: f64) -> Heading {
    Heading::of(angle, 0.0, FOUND * ROUNDING)
}

/// The contacts that begin to slide, at a state in a mode.
struct Slip<'a> {
    expansions: &'a Expansions,
    instant: &'a Instant<'a>,
    mode: &'a Mode,
    beginning: &'a [(usize, Face)],
    /// Accelerations by linear equations; `None` if they are not linear in reactions.
    accelerations: Option<Accelerations<'a>>,
}

impl Slip<'_> {
    fn along(&self, headings: &[Heading]) -> Mode {
        let mut mode = self.mode.clone();
        for (&(contact, face), &heading) in self.beginning.iter().zip(headings) {
            mode.phases[contact] = Phase::Glides { face, begins: Some(heading) };
        }
        mode
    }

    /// For each contact, the components of its acceleration normal to its direction and along it.
    fn accelerations(&self, headings: &[Heading]) -> Option<Vec<[f64; 2]>> {
        match &self.accelerations {
            Some(accelerations) => self.parts(headings, &accelerations.along_tangents(&self.along(headings))?),
            None => self.terms::<2>(headings, 1),
        }
    }

    /// For each contact, these components of the Taylor coefficient of given order of its sliding velocity.
    fn terms<const N: usize>(&self, headings: &[Heading], order: usize) -> Option<Vec<[f64; 2]>> {
        let found = self.expansions.at::<N>(self.instant, &self.along(headings))?;
        let tangential: Vec<[f64; 2]> =
            found.contacts.iter().map(|contact| [contact.slide, contact.aside].map(|jet| jet.terms[order])).collect();
        self.parts(headings, &tangential)
    }

    fn parts(&self, headings: &[Heading], tangential: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
        let of = |(&(contact, _), heading): (&(usize, Face), &Heading)| {
            let (Circle { cos, sin }, [along, aside]) = (heading.angle().circle(), tangential[contact]);
            let parts = [cos * aside - sin * along, cos * along + sin * aside];
            parts.iter().all(|part| part.is_finite()).then_some(parts)
        };
        self.beginning.iter().zip(headings).map(of).collect()
    }

    /// The directions opposite to the friction of sticking, and true if friction is at its bound for all contacts.
    fn by_friction(&self, held: &Mode) -> Option<(Vec<Heading>, bool)> {
        let found = self.expansions.at::<2>(self.instant, held)?;
        let mut all_at_bound = true;
        let against = |&(contact, face): &(usize, Face)| {
            let contact = &found.contacts[contact];
            let [_, first, second] = contact.reactions.map(|reaction| reaction.terms[0]);
            let doubt = contact.reactions[1].doubts[0].max(contact.reactions[2].doubts[0]) / first.hypot(second);
            all_at_bound &= margins(contact, face)[1].sign_of(0, SLACK) == 0.0;
            doubt
                .is_finite()
                .then(|| Heading::of(Elementary::Atan2.of(-second, -first), 0.0, doubt.max(FOUND * ROUNDING)))
        };
        let headings = self.beginning.iter().map(against).collect::<Option<Vec<Heading>>>()?;
        Some((headings, all_at_bound))
    }

    /// The directions with their rates of rotation, if friction is at its bound for all contacts.
    fn at_bound(&self, headings: &[Heading]) -> Option<Vec<Heading>> {
        let count = headings.len();
        let turning = |turns: &[f64]| -> Vec<Heading> {
            headings.iter().zip(turns).map(|(at, &turn)| Heading::of(at.angle(), turn, at.doubt())).collect()
        };
        // components normal to the directions are linear in the rates of the angles
        let parts = |turns: &[f64]| self.terms::<3>(&turning(turns), 2);
        let none = parts(&vec![0.0; count])?;
        // a direction that is the only one possible does not rotate
        let mut turns = vec![0.0; count];
        if none.iter().any(|[across, along]| across.abs() > STRAIGHT * along.abs()) {
            let mut slopes = DMatrix::zeros(count, count);
            for own in 0..count {
                let unit: Vec<f64> = (0..count).map(|place| if place == own { 1.0 } else { 0.0 }).collect();
                let moved = parts(&unit)?;
                (0..count).for_each(|row| slopes[(row, own)] = moved[row][0] - none[row][0]);
            }
            let right = DVector::from_iterator(count, none.iter().map(|[across, _]| -across));
            let decomposed = slopes.svd(true, true);
            let smallest = STRAIGHT * decomposed.singular_values.max().max(right.amax());
            if let Ok(found) = decomposed.solve(&right, smallest) {
                turns = found.as_slice().to_vec();
            }
        }
        Some(turning(&turns))
    }
}
