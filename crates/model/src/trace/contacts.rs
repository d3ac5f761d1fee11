//! Contacts over symbols: the letters of their reactions, and the rates of their gaps.

use super::Trace;
use crate::Contact;
use symbolic::Sym;

impl Trace<'_> {
    /// The letter of a contact's reaction, normal (0) or along a tangent (1, in space 2 too).
    pub fn reaction(&self, contact: usize, component: usize) -> Sym {
        let name = match self.model.contacts.get(contact) {
            Some(contact) if !contact.name.is_empty() => contact.name.clone(),
            Some(Contact { one_way: Some(one_way), .. }) => format!("{}{}", one_way.name(), contact + 1),
            _ => format!("contact{}", contact + 1),
        };
        let is_in_space = self.model.contacts.get(contact).is_some_and(Contact::is_in_space);
        let (letter, number) = match component {
            0 => ("N", String::new()),
            1 if !is_in_space => ("T", String::new()),
            _ => ("T", component.to_string()),
        };
        Sym::named(&format!("{name}.{letter}{number}"), &format!("{letter}_{{{number}\\text{{{name}}}}}"))
    }

    /// The letters of all reactions of contacts.
    pub fn reactions(&self) -> Vec<Sym> {
        let contacts = self.model.contacts.iter().enumerate();
        contacts
            .flat_map(|(place, contact)| (0..contact.reactions.len()).map(move |component| (place, component)))
            .map(|(place, component)| self.reaction(place, component))
            .collect()
    }

    /// The rate of the gap of a contact; of a diode or a freewheel the speed that is its gap.
    pub fn gap_rate(&self, contact: &Contact) -> Sym {
        let gap = self.scalar(contact.gap);
        if contact.one_way.is_some() { gap } else { self.rate_of(gap) }
    }
}
