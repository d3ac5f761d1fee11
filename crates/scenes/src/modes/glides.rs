//! Contacts that slide in space, and how they come to rest.
//!
//! T = -mu |N| v/|v| turns with v, and has no limit where v goes to zero. The speed |v| does not change its sign there, so that two signals
//! watch it from an instant at which it was w in the direction d:
//!
//!   |v| - w/10,  which falls where the contact has slowed down by ten,
//!   v . d,       which falls where v has turned by a right angle, or has come through zero within one step.
//!
//! After either the watch begins anew, until so little is left of the speed that it is taken away at once: what reactions do in the rest of
//! the way differs from that by the square of the part that is left.

use super::combinations::leaning;
use super::course::Sets;
use super::expansion::{Instant, Touching, direction};
use super::jet::ROUNDING;
use super::mode::Phase;
use super::passage::SLACK;
use super::signals::{Fall, GLIDE};
use super::touch::Touch;
use super::{Current, Modes};
use integrators::Event;

/// The part of a speed at which a contact is watched anew.
const SLOWER: f64 = 0.1;

/// The part of the largest speed of a slide that is taken away at once.
const REST: f64 = 1e-7;

/// Speed with which a slide begins, in m/s, and in multiples of the rounding of the sliding velocity: below it v has no direction.
const START: f64 = 1e-13;
const DIRECTED: f64 = 1e4;
/// Roundings of the clock in the time in which that speed is reached.
const RESOLVED: f64 = 1e3;

/// A contact that slides in space, from the instant at which its watch began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Glide {
    heading: [f64; 2],
    speed: f64,
    /// The largest speed at which a watch of this slide began.
    fastest: f64,
    /// The time in which the speed doubles, where it begins from rest.
    doubling: Option<f64>,
}

impl Glide {
    /// The watch of a contact in a phase; none where it does not slide in space.
    pub fn of<const N: usize>(contact: &Touching<N>, phase: Phase, time: f64) -> Option<Self> {
        let Phase::Glides { begins, .. } = phase else { return None };
        let Some(heading) = begins else {
            let (speed, heading) = motion(contact);
            return Some(Glide { heading, speed, fastest: speed, doubling: None });
        };
        let doubt = contact.slide.doubts[0].max(contact.aside.doubts[0]);
        // it doubles in a time that the clock resolves
        let rate = contact.slide.terms[1].hypot(contact.aside.terms[1]);
        let speed = START.max(DIRECTED * doubt).max(RESOLVED * ROUNDING * time.abs() * rate);
        let heading = direction::<1>(heading).map(|part| part.terms[0]);
        let grown = |order: usize| {
            let term = contact.slide.terms[order].hypot(contact.aside.terms[order]);
            (speed / term).powf(1.0 / order as f64)
        };
        let doubling = Some((1..N).map(grown).fold(1.0, f64::min));
        Some(Glide { heading, speed, fastest: speed, doubling })
    }

    /// The time in which the speed doubles, at most a second, where it begins from rest.
    pub fn doubling(&self) -> Option<f64> {
        self.doubling
    }

    /// Letters of its signals: d, and w/10.
    pub fn letters(&self) -> [f64; GLIDE] {
        [self.heading[0], self.heading[1], SLOWER * self.speed]
    }

    /// The sliding velocity with which it begins.
    pub fn start(&self) -> [f64; 2] {
        self.heading.map(|part| part * self.speed)
    }

    /// The next watch, after this one's speed or direction has fallen; none where the contact comes to rest.
    pub fn next<const N: usize>(&self, contact: &Touching<N>, has_turned: bool) -> Option<Self> {
        let (speed, heading) = motion(contact);
        let rests = self.is_over(contact) || has_turned && speed <= SLOWER * self.speed;
        (!rests).then_some(Glide { heading, speed, fastest: speed.max(self.fastest), doubling: None })
    }

    /// Its rest, of a contact.
    pub fn rest(&self, contact: usize) -> Sets {
        Sets::Rest { contact, fastest: self.fastest }
    }

    /// Whether so little is left of its speed that it is taken away at once.
    fn is_over<const N: usize>(&self, contact: &Touching<N>) -> bool {
        let rounding = SLACK * contact.slide.doubts[0].max(contact.aside.doubts[0]);
        motion(contact).0 <= rounding.max(1.5 * REST * self.fastest)
    }
}

/// |v| and v/|v|.
fn motion<const N: usize>(contact: &Touching<N>) -> (f64, [f64; 2]) {
    let [along, aside] = [contact.slide, contact.aside].map(|jet| jet.terms[0]);
    let speed = along.hypot(aside);
    (speed, [along / speed, aside / speed])
}

impl Modes {
    /// Gives contacts that begin to slide in space the speed from which they are followed.
    pub(super) fn push_off(&self, time: f64, state: &mut [f64], current: &Current) {
        let begins = |contact: usize| current.glides[contact].filter(|glide| glide.doubling.is_some());
        let Ok(expansions) = self.laws.expansions() else { return };
        if (0..current.glides.len()).all(|contact| begins(contact).is_none()) {
            return;
        }
        let start = |contact: usize| begins(contact).map_or([0.0; 2], |glide| glide.start());
        let held = |place: usize| {
            let mut held = current.moded.system.mode.clone();
            for (contact, phase) in held.phases.iter_mut().enumerate() {
                if let (Some(_), Some(face)) = (begins(contact), phase.face()) {
                    *phase = [vec![Phase::Sticks(face)], leaning(Phase::Sticks(face), true)].concat()[place];
                }
            }
            held
        };
        // others may hold it along one tangent
        (0..3).any(|place| expansions.return_to(time, state, &held(place), 0.0, start));
    }

    /// Contacts that slide in space rest with another one that has come to rest, where as little is left of their speed.
    pub(super) fn rest_with(&self, before: &Current, time: f64, state: &[f64], touches: &mut [Touch]) {
        let Ok(expansions) = self.laws.expansions() else { return };
        if before.glides.iter().flatten().next().is_none() {
            return;
        }
        let contacts = expansions.contacts(&Instant::at(time, state), &before.moded.system.mode.cases);
        for ((touch, glide), contact) in touches.iter_mut().zip(&before.glides).zip(&contacts) {
            if matches!(touch, Touch::Slides { .. }) && glide.is_some_and(|glide| glide.is_over(contact)) {
                *touch = Touch::Rest;
            }
        }
    }

    /// The time in which a contact that has slowed down comes to rest.
    pub(super) fn rest_of_a_glide(&self, before: &Current, event: &Event, state: &[f64]) -> f64 {
        let signals = &before.moded.signals;
        let Fall::Slows { contact } = signals.falls[event.signal] else { return 0.0 };
        let [value, rate] = signals.of_one(event.signal, event.time, state, &before.glide_letters());
        let slow = before.glides[contact].map_or(0.0, |glide| glide.letters()[2]);
        if rate < 0.0 { (value + slow) / -rate } else { 0.0 }
    }
}
