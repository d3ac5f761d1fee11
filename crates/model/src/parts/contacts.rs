//! Contacts: a point of a body against a plane, a curve or a guide, with Coulomb friction.

use super::{Constraint, Zero};
use crate::{BodyId, PointId, ScalarId, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// The sides of a plane, curve or guide that react.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// Unilateral: the contact can open.
    One,
    /// Bilateral: the contact never opens.
    Both,
}

/// The law of an impact with the coefficient of restitution e.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Restitution {
    /// The rate of the gap after the impact is -e times that before it.
    #[default]
    Newton,
    /// The impulse of the restitution phase is e times that of the compression phase.
    Poisson,
    /// Newton's law for several contacts simultaneously (Moreau): a contact that is already closed may take part with its own impulse.
    Moreau,
}

/// An element that prevents a speed from becoming negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OneWay {
    /// The speed is an electric current.
    Diode,
    /// The speed is that of a shaft relative to another one.
    Freewheel,
}

impl OneWay {
    /// Returns the name in files and sentences.
    pub fn name(self) -> &'static str {
        match self {
            OneWay::Diode => "diode",
            OneWay::Freewheel => "freewheel",
        }
    }
}

/// A contact with normal reaction N, friction T, coefficient of friction mu, and sliding velocity v.
///
/// N acts on the body along the normal, T along the tangent; the opposite forces act on the other body. If the contact is closed,
/// |T| <= mu |N| for v = 0, otherwise T = -mu |N| v/|v|. For a unilateral contact N >= 0. If it is open, N = T = 0. In the plane
/// v and T have one component, in space two, along perpendicular tangents.
///
/// For a diode or freewheel the gap is a speed u: u >= 0, N >= 0, N u = 0, and the power is N u.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The name; empty if there is none.
    pub name: String,
    /// The gap in metres: positive for an open contact, zero for a closed one.
    pub gap: ScalarId,
    /// For a diode or freewheel, whose gap is a speed.
    pub one_way: Option<OneWay>,
    /// The voltage drop or torque of a conducting diode or freewheel.
    pub drop: Option<ScalarId>,
    /// The unit normal n.
    pub normal: VectorId,
    /// The velocity of the body's point relative to the other body.
    pub velocity: VectorId,
    /// The components of the sliding velocity along the tangents, in m/s.
    pub slides: Vec<ScalarId>,
    /// Whether the contact is unilateral or bilateral.
    pub sides: Sides,
    /// The symbols of N, and of T along each tangent.
    pub reactions: Vec<ScalarId>,
    /// The unit tangents.
    pub tangents: Vec<VectorId>,
    /// The unit of N.
    pub reaction_unit: String,
    /// The coefficient of friction mu; `None` for a frictionless contact.
    pub friction: Option<ScalarId>,
    /// The range of bytes of the coefficient of friction in the file; that of the contact if it is omitted.
    pub friction_at: Range<usize>,
    /// The coefficient of restitution e; zero if it is omitted.
    pub restitution: Option<ScalarId>,
    /// The range of bytes of the coefficient of restitution in the file; that of the contact if it is omitted.
    pub restitution_at: Range<usize>,
    /// The law of impact.
    pub law: Restitution,
    /// The other body; `None` for the ground.
    pub with: Option<BodyId>,
    /// The touching point.
    pub point: PointId,
    /// A point of the plane; `None` if the gap is given as an expression.
    pub through: Option<PointId>,
    /// Whether the contact is a guide along an axis.
    pub is_line: bool,
    /// For a guide that the coordinates satisfy identically: the index of its additional coordinate in the released model.
    pub guide: Option<usize>,
    /// Whether the contact is closed at the start.
    pub is_touching: bool,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

impl Contact {
    /// Returns the constraint gap = 0.
    pub fn closed(&self) -> Constraint {
        let name = if self.name.is_empty() { None } else { Some(format!("contact {}", self.name)) };
        let (zero, dimension) = (Zero::Scalar(self.gap), Dimension::length());
        Constraint { name, zero, dimension, gains: None, gains_at: self.at.clone(), at: self.at.clone() }
    }

    /// Returns whether the contact slides in two directions.
    pub fn is_in_space(&self) -> bool {
        self.slides.len() > 1
    }

    /// Returns the name in sentences; `place` is the index of the contact.
    pub fn title(&self, place: usize) -> String {
        let what = self.one_way.map_or("contact", OneWay::name);
        if self.name.is_empty() { format!("{what} {}", place + 1) } else { format!("{what} `{}`", self.name) }
    }
}
