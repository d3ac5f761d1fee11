//! Contacts: a point of a body against a plane, a curve or a guide, with Coulomb friction.

use super::{Constraint, Zero};
use crate::{BodyId, PointId, ScalarId, VectorId};
use std::ops::Range;
use symbolic::Dimension;

/// The sides of a plane, a curve or a guide that react.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The surface pushes, and lets go.
    One,
    /// The surface holds on either side.
    Both,
}

/// The law of an impact, with the coefficient of restitution e.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Restitution {
    /// The gap opens with e times the velocity with which it closed.
    #[default]
    Newton,
    /// The impulse of the restitution is e times that of the compression.
    Poisson,
    /// Newton's law for several contacts at once (Moreau): a contact in touch may take part with an impulse of its own.
    Moreau,
}

/// An element that keeps a speed from falling below zero, as a plane keeps a gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OneWay {
    /// A current.
    Diode,
    /// The speed of a shaft beside another one.
    Freewheel,
}

impl OneWay {
    /// The name in files and sentences.
    pub fn name(self) -> &'static str {
        match self {
            OneWay::Diode => "diode",
            OneWay::Freewheel => "freewheel",
        }
    }
}

/// A contact.
///
/// N acts on the body along the normal, T along the tangent, and both in the opposite direction on the other body. In touch
/// |T| <= mu |N| where the sliding velocity v is zero, else T = -mu |N| v/|v|; N >= 0 where one side reacts; N = T = 0 apart. In the plane
/// v and T have one component, in space two, along tangents that are at right angles.
///
/// A diode, and a freewheel, is one whose gap is a speed u: u >= 0, N >= 0, N u = 0, with the power N u.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Empty where it has none.
    pub name: String,
    /// Positive apart, zero in touch.
    pub gap: ScalarId,
    /// For a gap that is a speed.
    pub one_way: Option<OneWay>,
    /// The voltage or torque that a diode or a freewheel takes while it lets through.
    pub drop: Option<ScalarId>,
    /// The normal n, of length one, and the velocity of the place of the body beside the other one.
    pub normal: VectorId,
    pub velocity: VectorId,
    /// The sliding velocity along each tangent.
    pub slides: Vec<ScalarId>,
    pub sides: Sides,
    /// The letters N, and T along each tangent.
    pub reactions: Vec<ScalarId>,
    /// The tangents.
    pub tangents: Vec<VectorId>,
    /// The unit of N.
    pub reaction_unit: String,
    /// mu; none where it is smooth.
    pub friction: Option<ScalarId>,
    /// e, of an impact; zero where left out.
    pub restitution: Option<ScalarId>,
    pub law: Restitution,
    /// The body that is touched; none of the ground.
    pub with: Option<BodyId>,
    /// The point that touches.
    pub point: PointId,
    /// A point of the plane; none where the gap is given.
    pub through: Option<PointId>,
    /// Whether it is a guide along an axis.
    pub is_line: bool,
    /// The place of its coordinate in the released model, for a guide which the coordinates satisfy.
    pub guide: Option<usize>,
    /// Whether it is in touch at the start, which is completed so.
    pub is_touching: bool,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}

impl Contact {
    /// The constraint that keeps it in touch.
    pub fn closed(&self) -> Constraint {
        let name = if self.name.is_empty() { None } else { Some(format!("contact {}", self.name)) };
        let (zero, dimension) = (Zero::Scalar(self.gap), Dimension::length());
        Constraint { name, zero, dimension, gains: None, gains_at: self.at.clone(), at: self.at.clone() }
    }

    /// Whether it slides in two directions.
    pub fn is_in_space(&self) -> bool {
        self.slides.len() > 1
    }

    /// The name in sentences, by its place.
    pub fn title(&self, place: usize) -> String {
        let what = self.one_way.map_or("contact", OneWay::name);
        if self.name.is_empty() { format!("{what} {}", place + 1) } else { format!("{what} `{}`", self.name) }
    }
}
