//! The sequence of laws of a run, each with the event that led to it.

use super::Moded;
use integrators::Happening;
use std::sync::Arc;

/// The change that an event makes in the state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sets {
    Nothing,
    /// No change: an expression passes zero in a direction that does not count, or diodes continue to block with other shares.
    Unseen,
    /// An event of the model sets coordinates and speeds.
    Event(usize),
    /// A contact closes with a velocity.
    Impact(usize),
    /// An impact after which the remaining bounces are neglected.
    LastBounce,
    /// The remaining sliding velocity of a contact in space is set to zero.
    Rest {
        contact: usize,
        /// The largest speed of the slide.
        fastest: f64,
    },
    /// The motion ends.
    End,
    /// The motion ends since the equations for the reactions become singular.
    Jam,
}

/// An event, by the signal of the law before it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub time: f64,
    pub signal: usize,
    pub what: Happening,
    pub sets: Sets,
}

/// A law of a run.
#[derive(Clone)]
pub(super) struct Leg {
    /// The event before this law; none for the law at the start.
    pub cause: Option<Crossing>,
    pub moded: Arc<Moded>,
    /// Letters of contacts that slide in space.
    pub glides: Vec<f64>,
    /// Whether one of these contacts begins to slide from rest.
    pub begins_to_glide: bool,
}

/// The laws of a run, in their order.
#[derive(Default)]
pub struct RunTable {
    pub(super) legs: Vec<Leg>,
}
