//! The parts of a trace that judgements share: the directions that constraints leave, a listener, names of directions.

use super::Trace;
use crate::Work;
use crate::equations::{Characteristics, constraints_of};
use std::cell::OnceCell;

/// A listener to work that is about to begin.
type Listener<'m> = Box<dyn Fn(&Work) + 'm>;

#[derive(Default)]
pub(super) struct Judgement<'m> {
    /// The directions that the constraints leave, found once for all principles along them.
    characteristics: OnceCell<Characteristics>,
    /// Hears of the work of each comparison before it begins.
    listener: Option<Listener<'m>>,
}

impl<'m> Trace<'m> {
    /// The trace with a listener to the work of each comparison before it begins.
    pub fn heard_by(self, listener: impl Fn(&Work) + 'm) -> Self {
        let judgement = Judgement { listener: Some(Box::new(listener)), ..self.judgement };
        Trace { judgement, ..self }
    }

    /// The directions that its constraints leave.
    pub(crate) fn characteristics(&self) -> &Characteristics {
        self.judgement.characteristics.get_or_init(|| Characteristics::of(self, &constraints_of(self)))
    }

    pub(crate) fn announce(&self, work: &Work) {
        self.judgement.listener.iter().for_each(|hears| hears(work));
    }

    /// The name of the direction of a speed: its coordinate, or for a free frame the speed itself.
    pub fn direction(&self, speed: usize) -> String {
        match self.model.coordinates.get(speed) {
            Some(coordinate) => coordinate.name.clone(),
            None => self.speeds[speed].to_string(),
        }
    }
}
