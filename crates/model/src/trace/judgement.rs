//! Data that checks of a trace share: the admissible directions of the constraints, a callback, names of directions.

use super::Trace;
use crate::Work;
use crate::equations::{Characteristics, constraints_of};
use std::cell::OnceCell;

/// A callback that is called before a check begins.
type Listener<'m> = Box<dyn Fn(&Work) + 'm>;

#[derive(Default)]
pub(super) struct Judgement<'m> {
    /// The admissible directions of the constraints, computed once for all principles.
    characteristics: OnceCell<Characteristics>,
    /// Called with the estimated cost of each comparison before it begins.
    listener: Option<Listener<'m>>,
}

impl<'m> Trace<'m> {
    /// Sets a callback that receives the estimated cost of each comparison before it begins.
    pub fn heard_by(self, listener: impl Fn(&Work) + 'm) -> Self {
        let judgement = Judgement { listener: Some(Box::new(listener)), ..self.judgement };
        Trace { judgement, ..self }
    }

    /// Returns the admissible directions of the constraints.
    pub(crate) fn characteristics(&self) -> &Characteristics {
        self.judgement.characteristics.get_or_init(|| Characteristics::of(self, &constraints_of(self)))
    }

    pub(crate) fn announce(&self, work: &Work) {
        self.judgement.listener.iter().for_each(|hears| hears(work));
    }

    /// Returns the name of the direction of a speed: its coordinate, or for a free frame the speed itself.
    pub fn direction(&self, speed: usize) -> String {
        match self.model.coordinates.get(speed) {
            Some(coordinate) => coordinate.name.clone(),
            None => self.speeds[speed].to_string(),
        }
    }
}
