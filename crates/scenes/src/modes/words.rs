//! Names of modes and events as they appear in results and messages.

use super::mode::{Case, Mode, Phase};
use super::signals::Fall;
use model::{Model, OneWay, Trace};
use symbolic::{Sym, apart};

/// The names of a model's conditions, contacts and events.
pub(super) struct Words {
    /// The expressions that the conditions compare with zero.
    compared: Vec<String>,
    contacts: Vec<String>,
    /// Whether each contact has friction.
    are_rough: Vec<bool>,
    one_ways: Vec<Option<OneWay>>,
    events: Vec<String>,
}

impl Words {
    pub fn of(model: &Model, events: &[String], condition_lines: &[usize]) -> Self {
        // a long expression has a number and the line in which it stands
        let compared = |(place, letter): (usize, &Sym)| {
            let name = letter.to_string();
            let expression = name.strip_prefix('[').and_then(|rest| rest.strip_suffix(" > 0]")).unwrap_or(&name);
            match (expression.starts_with("condition "), condition_lines.get(place)) {
                (true, Some(line)) => format!("{expression} (line {line})"),
                _ => expression.to_owned(),
            }
        };
        let compared = apart(|| Trace::of(model).switches.iter().enumerate().map(compared).collect());
        let contacts = model.contacts.iter().enumerate().map(|(place, contact)| contact.title(place)).collect();
        let are_rough = model.contacts.iter().map(|contact| contact.friction.is_some()).collect();
        let one_ways = model.contacts.iter().map(|contact| contact.one_way).collect();
        Words { compared, contacts, are_rough, one_ways, events: events.to_vec() }
    }

    /// The name of a condition.
    pub fn condition(&self, switch: usize) -> String {
        format!("[{} > 0]", self.compared[switch])
    }

    /// The name of a contact.
    pub fn contact(&self, contact: usize) -> String {
        self.contacts[contact].clone()
    }

    /// The kind of one-way element, a diode or a freewheel; `None` for a mechanical contact.
    pub fn one_way(&self, contact: usize) -> Option<OneWay> {
        self.one_ways[contact]
    }

    pub fn is_rough(&self, contact: usize) -> bool {
        self.are_rough[contact]
    }

    /// The name of the quantity that is positive while the contact is closed.
    pub fn pressure(&self, contact: usize) -> &'static str {
        match self.one_ways[contact] {
            None => "normal reaction |N|",
            Some(OneWay::Diode) => "voltage that it blocks",
            Some(OneWay::Freewheel) => "torque that it holds",
        }
    }

    /// The name and the unit of the quantity that is positive while a diode conducts or a freewheel turns freely.
    pub fn passing(&self, contact: usize) -> [&'static str; 2] {
        match self.one_ways[contact] {
            Some(OneWay::Freewheel) => ["speed", "rad/s"],
            _ => ["current", "A"],
        }
    }

    /// The name of the quantity that becomes positive where the contact opens.
    pub fn leaving(&self, contact: usize) -> &'static str {
        match self.one_ways[contact] {
            None => "separation gap''",
            Some(OneWay::Diode) => "rate of its current",
            Some(OneWay::Freewheel) => "rate of its speed",
        }
    }

    /// The description of an event.
    pub fn fall(&self, fall: Fall) -> String {
        match fall {
            Fall::Passes { switch } => format!("{} reaches 0", self.compared[switch]),
            Fall::Leaves { switch, .. } => format!("{} leaves 0", self.compared[switch]),
            Fall::Frees { switch } => format!("the share of {} leaves its bound", self.condition(switch)),
            Fall::Closes { contact } | Fall::Lifts { contact } if self.one_ways[contact].is_some() => {
                let (name, is_diode) = (&self.contacts[contact], self.one_ways[contact] == Some(OneWay::Diode));
                match (fall, is_diode) {
                    (Fall::Closes { .. }, true) => format!("the current of {name} falls to zero"),
                    (Fall::Closes { .. }, false) => format!("the speed of {name} falls to zero"),
                    (_, true) => format!("the voltage across {name} falls to zero"),
                    (_, false) => format!("the load of {name} falls to zero"),
                }
            }
            Fall::Closes { contact } => format!("{} closes", self.contacts[contact]),
            Fall::Lifts { contact } => format!("the normal reaction of {} falls to zero", self.contacts[contact]),
            Fall::Slides { contact, .. } => format!("friction does not hold {} any more", self.contacts[contact]),
            Fall::Stops { contact } | Fall::Slows { contact } | Fall::Hastens { contact } | Fall::Turns { contact } => {
                format!("the sliding of {} stops", self.contacts[contact])
            }
            Fall::Smooths { contact } => {
                format!("the coefficient of friction of {} falls to zero", self.contacts[contact])
            }
            Fall::Jams => "the equations for the reactions become singular".to_owned(),
            Fall::Event { event } => self.events.get(event).cloned().unwrap_or_default(),
        }
    }

    /// The contacts of a mode that are closed, each with its phase.
    pub fn contacts_of(&self, mode: &Mode) -> String {
        let closed = mode.phases.iter().enumerate().filter(|(_, phase)| **phase != Phase::Apart);
        closed.map(|(contact, phase)| self.phase(contact, *phase)).collect::<Vec<String>>().join(", ")
    }

    fn phase(&self, contact: usize, phase: Phase) -> String {
        let (is_rough, one_way) = (self.are_rough[contact], self.one_ways[contact]);
        let what = match phase {
            Phase::Apart if one_way == Some(OneWay::Diode) => "conducts",
            Phase::Apart if one_way.is_some() => "runs free",
            _ if one_way == Some(OneWay::Diode) => "blocks",
            _ if one_way.is_some() => "holds",
            Phase::Slips { .. } if !is_rough => "touches",
            Phase::Apart => "is apart",
            Phase::Sticks(_) | Phase::Leans { .. } | Phase::Rests { .. } => "sticks",
            Phase::Glides { .. } => "slides",
            Phase::Slips { forwards: true, .. } => "slides forwards",
            Phase::Slips { forwards: false, .. } => "slides backwards",
            Phase::Carried => "touches without force",
        };
        format!("{} {what}", self.contacts[contact])
    }

    /// The cases of all conditions and the phases of all contacts in a mode.
    pub fn mode(&self, mode: &Mode) -> String {
        let case = |(name, case): (&String, &Case)| match case {
            Case::On => format!("{name} > 0"),
            Case::Off => format!("{name} < 0"),
            Case::Held | Case::Shared | Case::Spent { .. } => format!("{name} stays at 0"),
        };
        let cases = self.compared.iter().zip(&mode.cases).map(case);
        let phases = mode.phases.iter().enumerate().map(|(contact, phase)| self.phase(contact, *phase));
        cases.chain(phases).collect::<Vec<String>>().join(", ")
    }
}
