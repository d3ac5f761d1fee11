//! Error estimate for the time of an event, from the residual of its signal.

use super::Current;
use super::decision::TERMS;
use super::expansion::Expansion;
use super::jet::{Jet, ROUNDING};
use super::mode::Case;
use super::passage::SLACK;
use super::signals::Fall;
use super::touch::margins;
use integrators::{Event, Happening};

/// An upper limit of the error estimate, in roundings of the time, for systems with algebraic speeds: an exponentially decaying signal
/// reaches zero by rounding, with an equally small rate, so that its residual gives no error estimate.
const LOCATED: f64 = 64.0;

/// The error estimate, s, of the time of an event; zero if none is available.
pub(super) fn late(before: &Current, known: &Expansion<TERMS>, event: &Event) -> f64 {
    let fall = before.moded.signals.falls[event.signal];
    let (signal, near) = match fall {
        Fall::Passes { switch } => {
            let side = if before.moded.system.mode.cases[switch] == Case::On { 1.0 } else { -1.0 };
            (known.conditions[switch], side * before.near[switch])
        }
        Fall::Leaves { switch, to } => {
            let bound = usize::from(to == Case::On);
            (known.margins(switch)[bound], before.near_bounds[switch][bound])
        }
        Fall::Frees { switch } => {
            let bound = usize::from(before.moded.system.mode.cases[switch].fixed() == Some(true));
            (-known.margins(switch)[bound], before.near_bounds[switch][bound])
        }
        Fall::Closes { contact } => (known.contacts[contact].gap, before.near_contacts[contact][0]),
        Fall::Lifts { contact } | Fall::Slides { contact, .. } | Fall::Stops { contact } => {
            let touching = &known.contacts[contact];
            let phase = before.moded.system.mode.phases[contact];
            let margins = phase.face().map(|face| margins(touching, face));
            let own = match (before.moded.signals.falls[event.signal], margins) {
                (Fall::Slides { margin, .. }, Some(margins)) => (margins[margin], margin),
                (Fall::Lifts { .. }, Some(margins)) => (margins[0], 0),
                _ => (Jet::constant(phase.way().unwrap_or(1.0), 0.0) * touching.slide, 1),
            };
            (own.0, before.near_contacts[contact][own.1])
        }
        Fall::Slows { .. } | Fall::Hastens { .. } | Fall::Turns { .. } | Fall::Jams | Fall::Smooths { .. } => {
            return 0.0;
        }
        Fall::Event { event } => (known.events[event], before.sides[event].sign * before.near_events[event]),
    };
    let near = if before.passes_at_zero(fall) { 0.0 } else { near };
    let is_passed = event.what == Happening::Falls && signal.sign_of(1, SLACK).abs() == 1.0;
    let late = if is_passed { 2.0 * ((signal.terms[0] + near) / signal.terms[1]).abs() } else { 0.0 };
    let system = &before.moded.system;
    // implicit speeds violate their laws by the error of the run
    let is_located = !system.model().algebraic_speeds.is_empty() && !system.has_implicit_speeds();
    if is_located { late.min(LOCATED * ROUNDING * event.time.abs()) } else { late }
}
