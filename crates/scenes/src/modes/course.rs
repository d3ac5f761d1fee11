//! The sequence of laws of a run, each with the event before it.

use super::Moded;
use integrators::Happening;
use std::sync::Arc;

/// The change that an event makes in the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sets {
    Nothing,
    /// No change: a signal crosses zero in a direction that does not count, or blocking diodes continue with a different distribution of
    /// voltages.
    Unseen,
    /// An event of the model sets coordinates and speeds.
    Event(usize),
    /// The contact with this index closes with a velocity: an impact.
    Impact(usize),
    /// An impact after which all further bounces are neglected.
    LastBounce,
    /// The small remaining sliding velocity of a contact in space is set to zero.
    Rest {
        contact: usize,
        /// The largest sliding speed before, m/s.
        fastest: f64,
    },
    /// The motion ends.
    End,
    /// The motion ends because the equations for the reactions become singular (jamming).
    Jam,
}

/// An event: `signal` is the index of the signal, of the law before the event, that crosses zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// The time, s.
    pub time: f64,
    pub signal: usize,
    /// The kind of zero crossing.
    pub what: Happening,
    /// The change of the state.
    pub sets: Sets,
}

/// A law of a run, valid from one event to the next.
#[derive(Clone)]
pub(super) struct Leg {
    /// The event before this law; none for the law at the start.
    pub cause: Option<Crossing>,
    pub moded: Arc<Moded>,
    /// Constants of contacts that slide in space, as inputs of the law.
    pub glides: Vec<f64>,
    /// True if one of these contacts begins to slide from rest.
    pub begins_to_glide: bool,
}

/// The laws of a run in their order.
#[derive(Default)]
pub struct RunTable {
    pub(super) legs: Vec<Leg>,
}
