//! Modes of a contact: apart, stick, slip; and the modes that its gap and velocity leave open.

use super::Ordered;
use crate::constrained::State;
use crate::constrained::contacts::{Contact, Contacts, Sides};
use field::{Over, Scalar, Tangent};
use std::cmp::Ordering;
use std::fmt;

/// The direction of sliding along the contact's curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The place along the curve grows.
    Forwards,
    /// The place along the curve falls.
    Backwards,
}

/// The side of a curve that presses. A guide has both, a one-sided curve the front only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The curve pushes towards a growing gap.
    Front,
    /// The curve pulls back.
    Back,
}

/// The mode of one contact in a regime.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// No reaction; the gap does not shrink.
    Apart,
    /// At rest along the curve, friction within its cone.
    Stick(Face),
    /// Sliding, or about to slide, in a direction; friction on the cone, against it.
    Slip(Direction, Face),
}

/// The state of a contact by its gap and its velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Not in touch, or leaving: it cannot react.
    Open,
    /// In touch, sliding velocity zero.
    Rest,
    /// In touch and sliding.
    Slides(Direction),
}

/// A contact at which no motion with finite accelerations can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The gap is negative, or a guide is left.
    Penetrates { contact: usize },
    /// In touch and approaching: an impact, on which these laws do not decide.
    Impact { contact: usize },
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Penetrates { contact } => {
                write!(f, "contact {} is not on the admitted side of its curve", contact + 1)
            }
            Self::Impact { contact } => {
                write!(
                    f,
                    "contact {} closes with a velocity: an impact, which the laws of friction do not decide",
                    contact + 1
                )
            }
        }
    }
}

impl std::error::Error for Unfit {}

impl Direction {
    /// Both directions.
    pub const ALL: [Direction; 2] = [Direction::Forwards, Direction::Backwards];

    /// 1 or -1.
    pub fn sign<S: Scalar>(self) -> S {
        if self == Self::Forwards { S::one() } else { -S::one() }
    }

    /// The direction of a velocity or an acceleration with this sign; `None` for zero.
    pub fn of(sign: Ordering) -> Option<Self> {
        match sign {
            Ordering::Less => Some(Self::Backwards),
            Ordering::Equal => None,
            Ordering::Greater => Some(Self::Forwards),
        }
    }
}

impl Face {
    /// The faces of a curve.
    pub fn of(sides: Sides) -> &'static [Face] {
        match sides {
            Sides::One => &[Face::Front],
            Sides::Two => &[Face::Front, Face::Back],
        }
    }

    /// 1 or -1: the sign of the normal reaction.
    pub fn sign<S: Scalar>(self) -> S {
        if self == Self::Front { S::one() } else { -S::one() }
    }
}

/// The most modes that one contact has: a guide at rest, two faces each with stick and two slips.
const MOST: usize = 6;

/// The modes that a contact may be in, in a fixed order. A smooth curve has no stick, and one slip for both directions.
pub fn modes<S: Scalar>(touch: Touch, sides: Sides, friction: S) -> impl Iterator<Item = Mode> {
    use Direction::Forwards;
    let mut list = [None; MOST];
    let mut count = 0;
    let mut add = |mode| {
        list[count] = Some(mode);
        count += 1;
    };
    if touch == Touch::Open || sides == Sides::One {
        add(Mode::Apart);
    }
    for &face in Face::of(sides) {
        match touch {
            Touch::Open => {}
            Touch::Slides(direction) => add(Mode::Slip(direction, face)),
            Touch::Rest if friction.is_zero() => add(Mode::Slip(Forwards, face)),
            Touch::Rest => {
                add(Mode::Stick(face));
                Direction::ALL.into_iter().for_each(|direction| add(Mode::Slip(direction, face)));
            }
        }
    }
    list.into_iter().flatten()
}

/// The sizes relative to which a rounded gap and a rounded velocity count as zero; an exact field does not need them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes<S> {
    pub length: S,
    pub speed: S,
}

impl<S: Ordered> Sizes<S> {
    /// The sizes of the places and the velocities of a state.
    pub fn of<const N: usize>(at: &State<S, N>) -> Self {
        let total = |v: [S; N]| v.into_iter().fold(S::zero(), |sum, x| sum + x.size());
        Sizes { length: total(at.place), speed: total(at.velocity) }
    }
}

/// The state of every contact: open, at rest or sliding.
///
/// # Errors
/// [`Unfit`] names the first contact that penetrates or collides.
pub fn touches<Q, S, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    sizes: Sizes<S>,
) -> Result<[Touch; K], Unfit>
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given> + Ordered,
{
    let moving = std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i]));
    let contacts = system.contacts(Tangent::moving(at.time, S::one()), moving);
    let Sizes { length, speed } = sizes;
    let mut touches = [Touch::Open; K];
    for (k, Contact { gap, along, sides, .. }) in contacts.into_iter().enumerate() {
        let slides = || Direction::of(along.slope.sign_among(speed)).map_or(Touch::Rest, Touch::Slides);
        touches[k] = match (sides, gap.value.sign_among(length), gap.slope.sign_among(speed)) {
            (_, Ordering::Equal, Ordering::Equal) => slides(),
            (Sides::Two, ..) | (Sides::One, Ordering::Less, _) => return Err(Unfit::Penetrates { contact: k }),
            (Sides::One, Ordering::Equal, Ordering::Less) => return Err(Unfit::Impact { contact: k }),
            (Sides::One, ..) => Touch::Open,
        };
    }
    Ok(touches)
}
