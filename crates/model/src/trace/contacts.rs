//! Contacts over symbols: the symbols of their reactions, and the rates of their gaps.

use super::Trace;
use crate::Contact;
use symbolic::Sym;

impl Trace<'_> {
    /// Returns the symbol of a contact's reaction: normal (component 0), or along tangent 1, in space also 2.
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

    /// Returns the symbols of all reactions of contacts.
    pub fn reactions(&self) -> Vec<Sym> {
        let contacts = self.model.contacts.iter().enumerate();
        contacts
            .flat_map(|(place, contact)| (0..contact.reactions.len()).map(move |component| (place, component)))
            .map(|(place, component)| self.reaction(place, component))
            .collect()
    }

    /// Returns the rate of a contact's gap; for a diode or freewheel the speed that replaces the gap.
    pub fn gap_rate(&self, contact: &Contact) -> Sym {
        let gap = self.scalar(contact.gap);
        if contact.one_way.is_some() { gap } else { self.rate_of(gap) }
    }
}
