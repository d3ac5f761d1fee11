//! The mode of a law: the case of each condition, and the phase of each contact.

use model::{Constraint, Model, Sides, Zero};

/// The case of a condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Case {
    /// The condition's expression is positive.
    On,
    /// The condition's expression is negative.
    Off,
    /// The expression stays at zero, since either case drives it back (sliding mode), as for sticking dry friction.
    Held,
    /// The expression stays at zero since this follows from held conditions; its switch takes a share of their forces.
    Shared,
    /// As `Shared`, with the switch at its bound 1 (on) or 0, since its share would exceed it.
    Spent { on: bool },
}

impl Case {
    /// Whether the condition stays at zero.
    pub(super) fn rests(self) -> bool {
        !matches!(self, Case::On | Case::Off)
    }

    /// Whether the switch is 1 or 0, if the case determines it.
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

/// The direction in which a contact in space begins to slide, by its angle from the first tangent, and the rate of this angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Heading {
    angle: u64,
    turn: u64,
    doubt: u64,
}

impl Heading {
    /// A direction from its angle, the rate of the angle, and the error of the angle.
    pub fn of(angle: f64, turn: f64, doubt: f64) -> Self {
        Heading { angle: angle.to_bits(), turn: turn.to_bits(), doubt: doubt.to_bits() }
    }

    /// The angle from the first tangent.
    pub fn angle(self) -> f64 {
        f64::from_bits(self.angle)
    }

    /// The rate of the angle.
    pub fn turn(self) -> f64 {
        f64::from_bits(self.turn)
    }

    /// The error of the angle.
    pub fn doubt(self) -> f64 {
        f64::from_bits(self.doubt)
    }
}

/// The phase of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// Not in touch: no reaction.
    Apart,
    /// In touch and sticking: the sliding velocity stays zero, |T| <= mu |N|.
    Sticks(Face),
    /// In touch in space, the sliding velocity stays zero: by friction along the tangents that are `held`, by other contacts along the
    /// others.
    Leans { face: Face, held: [bool; 2] },
    /// In touch, sliding or beginning to slide, T = -mu |N| sign(v): whether v is positive. The direction does not matter for a smooth contact.
    Slips { forwards: bool, face: Face },
    /// In touch and sliding in space, T = -mu |N| v/|v|; if v is still zero, with the direction in which it begins to slide.
    Glides { face: Face, begins: Option<Heading> },
    /// In touch, with T at its bound, but at rest since other contacts hold it: the body has more reactions than its motion determines.
    Rests { forwards: bool, face: Face },
    /// In touch without a reaction, since other contacts keep the gap at zero: a superfluous foot of a body.
    Carried,
}

impl Phase {
    /// The face that presses, in touch.
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

    /// The sign of the sliding velocity that friction opposes at its bound.
    pub fn way(self) -> Option<f64> {
        match self {
            Phase::Slips { forwards, .. } | Phase::Rests { forwards, .. } => Some(if forwards { 1.0 } else { -1.0 }),
            Phase::Apart | Phase::Carried | Phase::Sticks(_) | Phase::Leans { .. } | Phase::Glides { .. } => None,
        }
    }

    /// The face of a contact that friction holds.
    pub fn sticking(self) -> Option<Face> {
        match self {
            Phase::Sticks(face) | Phase::Leans { face, .. } => Some(face),
            _ => None,
        }
    }

    /// Whether T is tied to N.
    pub fn has_friction(self) -> bool {
        self.moves() || matches!(self, Phase::Rests { .. })
    }

    /// Whether it slides, or begins to.
    pub fn moves(self) -> bool {
        matches!(self, Phase::Slips { .. } | Phase::Glides { .. })
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

    /// The mode in which beginning sliding is ordinary sliding: both have one law.
    pub fn without_headings(mut self) -> Self {
        for phase in &mut self.phases {
            if let Phase::Glides { begins, .. } = phase {
                *begins = None;
            }
        }
        self
    }

    /// The mode in which contacts that slide in space are apart.
    pub fn without_glides(mut self) -> Self {
        for phase in &mut self.phases {
            if let Phase::Glides { .. } = phase {
                *phase = Phase::Apart;
            }
        }
        self
    }

    /// The model with contacts that stay in touch, and the sliding velocities of those that stick, among its constraints.
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

    /// Whether the reactions are unique.
    pub fn is_only_one(&self) -> bool {
        self.cases.is_empty() && self.phases.is_empty()
    }
}
