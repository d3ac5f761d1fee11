//! Modes of a contact (open, sticking, slipping), and the modes possible for its gap and velocity.

use super::Ordered;
use crate::constrained::State;
use crate::constrained::contacts::{Contact, Contacts, Sides};
use field::{Over, Scalar, Tangent};
use std::cmp::Ordering;
use std::fmt;

/// The direction of sliding along the contact's curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The position along the curve increases.
    Forwards,
    /// The position along the curve decreases.
    Backwards,
}

/// The side of a curve that exerts the normal reaction. A bilateral contact has both, a unilateral one the front only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The normal reaction acts in the direction of a growing gap.
    Front,
    /// The normal reaction acts in the direction of a decreasing gap.
    Back,
}

/// The mode of one contact in a regime.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Without reaction; the gap does not decrease.
    Apart,
    /// At rest along the curve, with the reaction within the friction cone.
    Stick(Face),
    /// Sliding, or beginning to slide, in a direction, with friction at its limit in the opposite direction.
    Slip(Direction, Face),
}

/// The state of a contact by its gap and its velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Open or separating: without reaction.
    Open,
    /// Closed, with the sliding velocity zero.
    Rest,
    /// Closed and sliding.
    Slides(Direction),
}

/// The reason why no motion with finite accelerations starts at a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The gap is negative, or a bilateral contact is violated.
    Penetrates { contact: usize },
    /// The contact is closed and approaching: an impact, which these laws do not describe.
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

    /// The sign of the direction, 1 or -1.
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
    /// The possible faces of a contact.
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

/// The largest number of modes of a contact: for a bilateral contact at rest, two faces each with stick and two slips.
const MOST: usize = 6;

/// The possible modes of a contact, in a fixed order. A frictionless contact has no sticking, and one slip mode for
/// both directions.
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

/// The magnitudes relative to which a rounded gap or velocity counts as zero; exact scalars ignore them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes<S> {
    pub length: S,
    pub speed: S,
}

impl<S: Ordered> Sizes<S> {
    /// The magnitudes of the coordinates and velocities of a state.
    pub fn of<const N: usize>(at: &State<S, N>) -> Self {
        let total = |v: [S; N]| v.into_iter().fold(S::zero(), |sum, x| sum + x.size());
        Sizes { length: total(at.place), speed: total(at.velocity) }
    }
}

/// The state of every contact: open, at rest or sliding.
///
/// # Errors
/// [`Unfit`] with the index of the first contact that penetrates or collides.
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
