//! Contacts that slide in space, from the start of sliding to rest.
//!
//! The friction T = -mu |N| v/|v| has no limit as v goes to zero, and |v| does not change its sign there. Three signals observe |v|,
//! relative to its value w and the unit vector d of v at the start of the observation:
//!
//!   |v| - w/10,    negative when the contact has slowed down by a factor of ten,
//!   1000 w - |v|,  negative when the contact is so fast that w/10 is no longer a useful threshold,
//!   v . d,         negative when v has turned by a right angle, or has passed zero within one step.
//!
//! When a signal becomes negative, the observation starts again with new w and d, until the remaining speed is small enough to be set to
//! zero: the error of the reactions is then the square of the remaining relative speed.

use super::course::Sets;
use super::expansion::{Instant, Touching, direction};
use super::headings::held;
use super::jet::{Jet, ROUNDING};
use super::mode::{Face, Mode, Phase};
use super::passage::SLACK;
use super::signals::{Fall, GLIDE};
use super::touch::Touch;
use super::{Current, Modes};
use field::Elementary;
use integrators::Event;

/// The relative speed below which the observation of a contact starts again.
const SLOWER: f64 = 0.1;

/// The multiple of this speed above which the observation starts again.
pub(super) const FASTER: i64 = 10_000;

/// The remaining speed, relative to the largest of the slide, that is set to zero.
const REST: f64 = 1e-7;

/// A reversed velocity below this part of the largest has passed through zero.
const REVERSED: f64 = 1e-5;

/// Contacts whose time to rest is below this multiple of that of another come to rest together: speeds of one body vanish together.
const TOGETHER: f64 = 10.0;

/// The least speed at which sliding begins, in m/s, and in multiples of the rounding error of the sliding velocity: below it v has no
/// direction.
const START: f64 = 1e-13;
const DIRECTED: f64 = 1e4;
/// The time in which that speed is reached has at least this number of roundings of the time.
const RESOLVED: f64 = 1e3;

/// The observation of a contact that slides in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Glide {
    heading: [f64; 2],
    speed: f64,
    /// The largest speed at the start of an observation during this slide, m/s.
    fastest: f64,
    /// The time in which the speed doubles, s, for a slide that began from rest.
    doubling: Option<f64>,
}

impl Glide {
    /// The observations of all contacts at a time (s); `None` for a contact that does not slide in space.
    pub fn of_all<const N: usize>(contacts: &[Touching<N>], phases: &[Phase], time: f64) -> Vec<Option<Self>> {
        let begins = |phase: &Phase| matches!(phase, Phase::Glides { begins: Some(_), .. });
        let all = || contacts.iter().zip(phases);
        // contacts that begin to slide together get the speeds of one instant
        let doubling = all().filter(|(_, phase)| begins(phase)).map(|(contact, _)| doubling(contact, time));
        let doubling = doubling.fold(0.0, f64::max);
        all().map(|(contact, phase)| Glide::of(contact, *phase, doubling)).collect()
    }

    fn of<const N: usize>(contact: &Touching<N>, phase: Phase, doubling: f64) -> Option<Self> {
        let Phase::Glides { begins, .. } = phase else { return None };
        let Some(heading) = begins else {
            let (speed, heading) = motion(contact.slide.terms[0], contact.aside.terms[0]);
            return Some(Glide { heading, speed, fastest: speed, doubling: None });
        };
        let then = |jet: &Jet<N>| jet.terms.iter().skip(1).rev().fold(0.0, |sum, term| (sum + term) * doubling);
        let (speed, heading) = match motion(then(&contact.slide), then(&contact.aside)) {
            (0.0, _) => (START, direction::<1>(heading).map(|part| part.terms[0])),
            begun => begun,
        };
        Some(Glide { heading, speed, fastest: speed, doubling: Some(doubling) })
    }

    /// The time in which the speed doubles, at most one second, for a slide that begins from rest.
    pub fn doubling(&self) -> Option<f64> {
        self.doubling
    }

    /// The constants of the signals: d, and w/10 (m/s).
    pub fn letters(&self) -> [f64; GLIDE] {
        [self.heading[0], self.heading[1], SLOWER * self.speed]
    }

    /// The sliding velocity at the start of the observation, m/s.
    pub fn start(&self) -> [f64; 2] {
        self.heading.map(|part| part * self.speed)
    }

    /// The next observation after a signal has become negative; `None` if the contact comes to rest.
    pub fn next<const N: usize>(&self, contact: &Touching<N>, fall: Fall) -> Option<Self> {
        let [slide, aside] = [contact.slide.terms, contact.aside.terms];
        let (speed, heading) = motion(slide[0], aside[0]);
        let turned = (SLOWER * self.speed).max(REVERSED * self.fastest);
        let rests = self.is_over(contact) || matches!(fall, Fall::Turns { .. }) && speed <= turned;
        let doubling = matches!(fall, Fall::Hastens { .. }).then(|| speed / slide[1].hypot(aside[1]));
        (!rests).then_some(Glide { heading, speed, fastest: speed.max(self.fastest), doubling })
    }

    /// The event in which the contact comes to rest.
    pub fn rest(&self, contact: usize) -> Sets {
        Sets::Rest { contact, fastest: self.fastest }
    }

    /// True if the speed is small enough to be set to zero.
    fn is_over<const N: usize>(&self, contact: &Touching<N>) -> bool {
        let rounding = SLACK * contact.slide.doubts[0].max(contact.aside.doubts[0]);
        let (speed, [along, aside]) = motion(contact.slide.terms[0], contact.aside.terms[0]);
        let has_reversed = along * self.heading[0] + aside * self.heading[1] < 0.0;
        let least = if has_reversed { REVERSED } else { 1.5 * REST };
        speed <= rounding.max(least * self.fastest)
    }
}

/// The speed |v| and the unit vector v/|v|.
fn motion(along: f64, aside: f64) -> (f64, [f64; 2]) {
    let speed = along.hypot(aside);
    (speed, [along / speed, aside / speed])
}

/// The time, s, after which the velocity of a contact that begins to slide has a direction.
fn doubling<const N: usize>(contact: &Touching<N>, time: f64) -> f64 {
    let term = |order: usize| contact.slide.terms[order].hypot(contact.aside.terms[order]);
    let doubt = contact.slide.doubts[0].max(contact.aside.doubts[0]);
    let speed = START.max(DIRECTED * doubt).max(RESOLVED * ROUNDING * time.abs() * term(1));
    // reproducible bits on every machine
    let root = |value: f64, order: usize| Elementary::Exp.of(Elementary::Ln.of(value, 0.0) / order as f64, 0.0);
    (1..N).map(|order| root(speed / term(order), order)).fold(1.0, f64::min)
}

impl Modes {
    /// Sets the initial speed of contacts that begin to slide in space.
    pub(super) fn push_off(&self, time: f64, state: &mut [f64], current: &Current) {
        let Ok(expansions) = self.laws.expansions() else { return };
        let start = |contact: usize| {
            let begun = current.glides[contact].filter(|glide| glide.doubling.is_some());
            begun.map_or([0.0; 2], |glide| glide.start())
        };
        let mode = &current.moded.system.mode;
        let begins = |contact: &usize| start(*contact) != [0.0; 2];
        let beginning: Vec<(usize, Face)> =
            (0..current.glides.len()).filter(begins).filter_map(|one| Some((one, mode.phases[one].face()?))).collect();
        if let Some(held) = held(expansions, &Instant::at(time, state), mode, &beginning)
            && !beginning.is_empty()
        {
            expansions.return_to(time, state, &held, 0.0, start);
        }
    }

    /// The index of the first contact in space whose sliding speed is to be set to zero.
    pub(super) fn is_over(&self, before: &Current, instant: &Instant<'_>) -> Option<usize> {
        let contacts = self.laws.expansions().ok()?.contacts(instant, &before.moded.system.mode.cases);
        let mut glides = before.glides.iter().zip(&contacts);
        glides.position(|(glide, contact)| glide.is_some_and(|glide| glide.is_over(contact)))
    }

    /// For each contact: true if it slides in space and comes to rest together with the contact of an event, by its remaining speed or by
    /// the remaining time to rest.
    pub(super) fn rest_together(&self, before: &Current, event: &Event, state: &[f64]) -> Vec<bool> {
        let Ok(expansions) = self.laws.expansions() else { return vec![false; before.glides.len()] };
        let contacts = expansions.contacts(&Instant::at(event.time, state), &before.moded.system.mode.cases);
        let own = match before.moded.signals.falls[event.signal] {
            Fall::Slows { contact } | Fall::Turns { contact } => time_to_rest(before, contact, event, state),
            _ => 0.0,
        };
        let rests = |(contact, glide): (usize, &Option<Glide>)| {
            let Some(glide) = glide else { return false };
            let left = time_to_rest(before, contact, event, state);
            glide.is_over(&contacts[contact]) || left > 0.0 && left <= TOGETHER * own
        };
        before.glides.iter().enumerate().map(rests).collect()
    }

    /// Sets the remaining speeds of contacts in space to zero, and their state in `touches` to rest. `together` marks the contacts.
    pub(super) fn bring_to_rest(
        &self,
        mode: &Mode,
        together: &[bool],
        time: f64,
        state: &mut [f64],
        touches: &mut [Touch],
    ) {
        let Ok(expansions) = self.laws.expansions() else { return };
        for (touch, _) in touches.iter_mut().zip(together).filter(|(_, rests)| **rests) {
            *touch = if matches!(touch, Touch::Slides { .. }) { Touch::Rest } else { *touch };
        }
        let resting = touches.iter().zip(&expansions.kinds).zip(&mode.phases).enumerate();
        let resting = resting.filter(|(_, ((touch, kind), _))| **touch == Touch::Rest && kind.is_in_space);
        let resting: Vec<(usize, Face)> =
            resting.filter_map(|(contact, (_, phase))| Some((contact, phase.face()?))).collect();
        if resting.len() > 1
            && let Some(held) = held(expansions, &Instant::at(time, state), mode, &resting)
        {
            expansions.return_to_zero(time, state, &held, 0.0);
        }
    }

    /// The time, s, in which the contact of an event comes to rest; zero for events other than [`Fall::Slows`].
    pub(super) fn rest_of_a_glide(before: &Current, event: &Event, state: &[f64]) -> f64 {
        let Fall::Slows { contact } = before.moded.signals.falls[event.signal] else { return 0.0 };
        time_to_rest(before, contact, event, state)
    }
}

/// The time, s, in which a contact comes to rest at its present deceleration; zero if it does not slow down.
fn time_to_rest(before: &Current, contact: usize, event: &Event, state: &[f64]) -> f64 {
    let signals = &before.moded.signals;
    let Some(signal) = signals.falls.iter().position(|fall| *fall == Fall::Slows { contact }) else { return 0.0 };
    let [value, rate] = signals.of_one(signal, event.time, state, &before.glide_letters());
    let slow = before.glides[contact].map_or(0.0, |glide| glide.letters()[2]);
    if rate < 0.0 { (value + slow) / -rate } else { 0.0 }
}
