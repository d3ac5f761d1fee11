//! The mode of a law: the case of each condition, and the phase of each contact.

use model::{Model, Sides};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// Its expression is positive.
    On,
    /// It is negative.
    Off,
    /// It stays at zero, since either case drives it back: dry friction that sticks.
    Held,
    /// It stays at zero since conditions that are held imply it; its switch takes a part of what keeps them there.
    Shared,
    /// The same, and its switch stays at 1 (on) or at 0, since its part would be larger.
    Spent { on: bool },
}

impl Case {
    /// Whether the condition stays at zero.
    pub(super) fn rests(self) -> bool {
        !matches!(self, Case::On | Case::Off)
    }

    /// Whether the switch is 1, where the case says it, or 0.
    pub(super) fn fixed(self) -> Option<bool> {
        match self {
            Case::On | Case::Spent { on: true } => Some(true),
            Case::Off | Case::Spent { on: false } => Some(false),
            Case::Held | Case::Shared => None,
        }
    }
}

/// The side of a plane, a curve or a guide that presses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// N > 0.
    Front,
    /// N < 0, where both sides react.
    Back,
}

impl Face {
    /// The sign of N.
    pub fn sign(self) -> f64 {
        if self == Face::Front { 1.0 } else { -1.0 }
    }

    /// The faces of a contact.
    pub fn of(sides: Sides) -> &'static [Face] {
        match sides {
            Sides::One => &[Face::Front],
            Sides::Both => &[Face::Front, Face::Back],
        }
    }
}

/// The phase of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// No reaction.
    Apart,
    /// In touch, the sliding velocity stays zero, |T| <= mu |N|.
    Sticks(Face),
    /// In touch, sliding or beginning to, T = -mu |N| sign(v): whether v is positive. Of a smooth contact the direction means nothing.
    Slips { forwards: bool, face: Face },
    /// In touch and at rest since other contacts hold it there, with T at its bound: of a body that is held by more reactions than motions
    /// determine.
    Rests { forwards: bool, face: Face },
    /// In touch without a reaction, since other contacts keep the gap at zero: a foot of a body that stands on more feet than determine it.
    Carried,
}

impl Phase {
    /// The face that presses, in touch.
    pub fn face(self) -> Option<Face> {
        match self {
            Phase::Apart | Phase::Carried => None,
            Phase::Sticks(face) | Phase::Slips { face, .. } | Phase::Rests { face, .. } => Some(face),
        }
    }

    /// The sign of the sliding velocity that friction opposes at its bound.
    pub fn way(self) -> Option<f64> {
        match self {
            Phase::Slips { forwards, .. } | Phase::Rests { forwards, .. } => Some(if forwards { 1.0 } else { -1.0 }),
            Phase::Apart | Phase::Carried | Phase::Sticks(_) => None,
        }
    }
}

/// The mode of a law.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Mode {
    pub cases: Vec<Case>,
    pub phases: Vec<Phase>,
}

impl Mode {
    /// Every condition off, every contact apart.
    pub fn off(model: &Model) -> Self {
        Mode { cases: vec![Case::Off; model.switches.len()], phases: vec![Phase::Apart; model.contacts.len()] }
    }

    /// Whether nothing is chosen.
    pub fn is_only_one(&self) -> bool {
        self.cases.is_empty() && self.phases.is_empty()
    }
}
