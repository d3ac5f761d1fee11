//! Contacts over symbols: the letters of their reactions, and the rates of their gaps.

use super::Trace;
use crate::Contact;
use symbolic::Sym;

impl Trace<'_> {
    /// The letter of a contact's reaction, normal (0) or tangential (1).
    pub fn reaction(&self, contact: usize, component: usize) -> Sym {
        let name = match self.model.contacts.get(contact) {
            Some(contact) if !contact.name.is_empty() => contact.name.clone(),
            Some(Contact { one_way: Some(one_way), .. }) => format!("{}{}", one_way.name(), contact + 1),
            _ => format!("contact{}", contact + 1),
        };
        let letter = ["N", "T"][component];
        Sym::named(&format!("{name}.{letter}"), &format!("{letter}_{{\\text{{{name}}}}}"))
    }

    /// The rate of the gap of a contact; of a diode or a freewheel the speed that is its gap.
    pub fn gap_rate(&self, contact: &Contact) -> Sym {
        let gap = self.scalar(contact.gap);
        if contact.one_way.is_some() { gap } else { self.rate_of(gap) }
    }
}
