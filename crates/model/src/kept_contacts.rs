//! The law between two changes of contact states: one law for each set of closed contacts without friction.

use crate::arena::{Number, Part, Scalar};
use crate::{Contact, Model};

impl Model {
    /// Returns the model while its contacts keep their state. The gap of each closed contact becomes a constraint, whose reaction replaces that of the contact;
    /// friction is ignored. Open contacts exert no force. The result has no contacts.
    ///
    /// `touch` states for each contact whether it is closed. Returns `None` if a contact is a diode or a freewheel, or if a closed guide is satisfied identically by
    /// the coordinates.
    pub fn with_kept_contacts(&self, touch: &[bool]) -> Option<Self> {
        let is_refused =
            |(contact, touches): (&Contact, &bool)| contact.one_way.is_some() || *touches && contact.guide.is_some();
        if self.contacts.iter().zip(touch).any(is_refused) {
            return None;
        }
        let mut kept = self.clone();
        let none = Part::Scalar(Scalar::Number(Number { value: 0.0, times: 1.0, per: 1.0 }));
        for letter in self.contacts.iter().flat_map(|contact| &contact.reactions) {
            kept.arena.parts[letter.0] = none;
        }
        let touching = self.contacts.iter().zip(touch).filter(|(_, touches)| **touches);
        kept.constraints.extend(touching.map(|(contact, _)| contact.closed()));
        kept.contacts.clear();
        Some(kept)
    }
}
