//! The law between two changes of its contacts: one law for each set of smooth contacts that are in touch.

use crate::arena::{Number, Part, Scalar};
use crate::{Contact, Model};

impl Model {
    /// The model while its contacts keep their state, those in touch without friction: the gap of each is a constraint, whose reaction takes
    /// the place of the contact's; those apart exert no force. It has no contacts.
    ///
    /// `touch` says of each contact whether it is in touch. None where a contact is a diode or a freewheel, or where a guide that the
    /// coordinates keep is in touch.
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
