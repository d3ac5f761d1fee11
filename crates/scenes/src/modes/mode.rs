//! The mode of a law: the case of each condition, and the phase of each contact.

use model::{Constraint, Model, Sides, Zero};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// The condition's expression is positive.
    On,
    /// The condition's expression is negative.
    Off,
    /// The expression stays at zero, since both cases drive it back (sliding mode), as for sticking dry friction.
    Held,
    /// The expression stays at zero as a consequence of held conditions; its switch takes a share of their forces.
    Shared,
    /// The expression stays at zero as for `Shared`, but the share exceeds a bound: the switch is 1 (`on`) or 0.
    Spent { on: bool },
}

impl Case {
    /// True if the condition stays at zero.
    pub(super) fn rests(self) -> bool {
        !matches!(self, Case::On | Case::Off)
    }

    /// The switch, if the case fixes it: true for 1, false for 0.
    pub(super) fn fixed(self) -> Option<bool> {
        match self {
            Case::On | Case::Spent { on: true } => Some(true),
            Case::Off | Case::Spent { on: false } => Some(false),
            Case::Held | Case::Shared => None,
        }
    }
}

/// The side of a plane, a curve or a guide that presses; N is the normal reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// N > 0.
    Front,
    /// N < 0, for two-sided contacts only.
    Back,
}

impl Face {
    /// The sign of N.
    pub fn sign(self) -> f64 {
        if self == Face::Front { 1.0 } else { -1.0 }
    }

    /// The faces of a contact that may press.
    pub fn of(sides: Sides) -> &'static [Face] {
        match sides {
            Sides::One => &[Face::Front],
            Sides::Both => &[Face::Front, Face::Back],
        }
    }
}

/// The direction in which a contact in space begins to slide: an angle from the first tangent, and the rate of this angle. Stored as
/// bits, for hashing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Heading {
    angle: u64,
    turn: u64,
    doubt: u64,
}

impl Heading {
    /// A direction with its angle (rad), the rate of the angle (rad/s), and the error of the angle (rad).
    pub fn of(angle: f64, turn: f64, doubt: f64) -> Self {
        Heading { angle: angle.to_bits(), turn: turn.to_bits(), doubt: doubt.to_bits() }
    }

    /// The angle from the first tangent, rad.
    pub fn angle(self) -> f64 {
        f64::from_bits(self.angle)
    }

    /// The rate of the angle, rad/s.
    pub fn turn(self) -> f64 {
        f64::from_bits(self.turn)
    }

    /// The error of the angle, rad.
    pub fn doubt(self) -> f64 {
        f64::from_bits(self.doubt)
    }
}

/// The phase of a contact, with normal reaction N, friction T, sliding velocity v and coefficient of friction mu.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// Open: no reaction.
    Apart,
    /// Closed and sticking: v stays zero, |T| <= mu |N|.
    Sticks(Face),
    /// Closed in space and sticking with others: v stays zero, by friction along the tangents that are `held`, by other contacts along
    /// the others.
    Leans { face: Face, held: [bool; 2] },
    /// Closed and sliding, or beginning to slide: T = -mu |N| sign(v). `forwards` is true for v > 0; it does not matter for a smooth
    /// contact.
    Slips { forwards: bool, face: Face },
    /// Closed and sliding in space: T = -mu |N| v/|v|. If v is still zero, `begins` is the direction in which sliding begins.
    Glides { face: Face, begins: Option<Heading> },
    /// Closed at rest with T at its bound, because other contacts hold the body, which has more reactions than the motion determines.
    Rests { forwards: bool, face: Face },
    /// Closed without a reaction, since other contacts keep the gap at zero, as for a superfluous foot of a body.
    Carried,
}

impl Phase {
    /// The face that presses; `None` without a reaction.
    pub fn face(self) -> Option<Face> {
        match self {
            Phase::Apart | Phase::Carried => None,
            Phase::Sticks(face)
            | Phase::Leans { face, .. }
            | Phase::Slips { face, .. }
            | Phase::Glides { face, .. }
            | Phase::Rests { face, .. } => Some(face),
        }
    }

    /// The sign of the sliding velocity that friction at its bound opposes; `None` for other phases, and in space.
    pub fn way(self) -> Option<f64> {
        match self {
            Phase::Slips { forwards, .. } | Phase::Rests { forwards, .. } => Some(if forwards { 1.0 } else { -1.0 }),
            Phase::Apart | Phase::Carried | Phase::Sticks(_) | Phase::Leans { .. } | Phase::Glides { .. } => None,
        }
    }

    /// The face of a contact that sticks; `None` for other phases.
    pub fn sticking(self) -> Option<Face> {
        match self {
            Phase::Sticks(face) | Phase::Leans { face, .. } => Some(face),
            _ => None,
        }
    }

    /// True if T is proportional to N.
    pub fn has_friction(self) -> bool {
        self.moves() || matches!(self, Phase::Rests { .. })
    }

    /// True if the contact slides or begins to slide.
    pub fn moves(self) -> bool {
        matches!(self, Phase::Slips { .. } | Phase::Glides { .. })
    }
}

/// A mode: one law of a hybrid model.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Mode {
    /// The case of each condition.
    pub cases: Vec<Case>,
    /// The phase of each contact.
    pub phases: Vec<Phase>,
}

impl Mode {
    /// The mode with every condition off and every contact open.
    pub fn off(model: &Model) -> Self {
        Mode { cases: vec![Case::Off; model.switches.len()], phases: vec![Phase::Apart; model.contacts.len()] }
    }

    /// The mode without directions of beginning sliding: the law does not depend on them.
    pub fn without_headings(mut self) -> Self {
        for phase in &mut self.phases {
            if let Phase::Glides { begins, .. } = phase {
                *begins = None;
            }
        }
        self
    }

    /// The mode with contacts that slide in space set to open.
    pub fn without_glides(mut self) -> Self {
        for phase in &mut self.phases {
            if let Phase::Glides { .. } = phase {
                *phase = Phase::Apart;
            }
        }
        self
    }

    /// The model with its closed contacts, and the sliding velocities of sticking contacts, as constraints.
    pub fn with_closed_contacts(&self, model: &Model) -> Model {
        let mut with = model.clone();
        for (contact, phase) in model.contacts.iter().zip(&self.phases) {
            if *phase == Phase::Apart || contact.guide.is_some() {
                continue;
            }
            let slides = if phase.sticking().is_some() { &contact.slides[..] } else { &[] };
            let slides = slides.iter().map(|&slide| Constraint { zero: Zero::Scalar(slide), ..contact.closed() });
            with.constraints.extend(slides.chain([contact.closed()]));
        }
        with
    }

    /// True if the model has neither conditions nor contacts, so that this is its only mode.
    pub fn is_only_one(&self) -> bool {
        self.cases.is_empty() && self.phases.is_empty()
    }
}
