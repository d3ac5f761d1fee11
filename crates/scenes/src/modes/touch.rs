//! Possible phases of a contact at an instant, and the test whether its motion agrees with a phase.
//!
//! If gap and gap' are zero, three phases are possible. The contact opens if the first nonzero higher rate of the gap is positive. It
//! sticks if N and mu |N| - |T| are positive, or rise from zero. It slides if N is positive and the sliding velocity leaves zero in the
//! direction that friction opposes.

use super::consistency::Standing;
use super::decision::{FEW, SLACKS, TERMS};
use super::expansion::{Kind, Touching, direction};
use super::jet::Jet;
use super::mode::{Face, Phase};
use model::Sides;

/// The state of a contact by its positions and speeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Touch {
    /// Open, or opening.
    Open,
    /// Closed, with zero sliding velocity.
    Rest,
    /// Closed and sliding; `forwards` is true for a positive sliding velocity.
    Slides { forwards: bool },
    /// A diode without inertia in its circuit: its current follows from the conducting diodes.
    AtOnce,
}

impl Touch {
    /// The phases to be tried for a contact. Of the two phases without a reaction one suffices, since the gap distinguishes them.
    pub fn phases(self, Kind { sides, is_rough, is_guide, is_in_space, .. }: Kind) -> Vec<Phase> {
        let faces = || Face::of(sides).iter().copied();
        let glides = || faces().map(|face| Phase::Glides { face, begins: None });
        let slips = |forwards: bool| faces().map(move |face| Phase::Slips { forwards, face });
        let mut phases: Vec<Phase> = match self {
            Touch::Open => Vec::new(),
            Touch::Slides { .. } if is_in_space => glides().collect(),
            Touch::Rest if is_in_space => faces().map(Phase::Sticks).chain(glides()).collect(),
            Touch::Slides { forwards } => slips(forwards).collect(),
            Touch::Rest if is_rough => faces().map(Phase::Sticks).chain(slips(true)).chain(slips(false)).collect(),
            Touch::Rest | Touch::AtOnce => slips(true).collect(),
        };
        match sides {
            _ if is_guide => {}
            Sides::Both => phases.push(Phase::Carried),
            Sides::One => phases.push(Phase::Apart),
        }
        phases
    }
}

/// The margins of a closed contact, N: the pressure, then the reserve of friction forwards and backwards; in space twice (mu N)^2 - T^2,
/// N².
pub(super) fn margins<const N: usize>(contact: &Touching<N>, face: Face) -> [Jet<N>; 3] {
    let Touching { friction, reactions: [normal, tangent, aside], .. } = *contact;
    let pressure = normal * Jet::constant(face.sign(), 0.0);
    let most = friction * pressure;
    match contact.is_in_space {
        true => {
            let beyond = most * most - tangent * tangent - aside * aside;
            [pressure, beyond, beyond]
        }
        false => [pressure, most - tangent, most + tangent],
    }
}

/// The sliding velocity of a slip that begins, along the direction that friction at its bound opposes.
pub(super) fn leaving<const N: usize>(contact: &Touching<N>, phase: Phase) -> Jet<N> {
    match phase {
        Phase::Glides { begins: Some(heading), .. } => {
            let [cos, sin] = direction(heading);
            cos * contact.slide + sin * contact.aside
        }
        _ => contact.slide * Jet::constant(phase.way().unwrap_or(0.0), 0.0),
    }
}

/// True if a slip begins, so that the sliding velocity must leave zero.
fn begins<const N: usize>(contact: &Touching<N>, touch: Touch) -> bool {
    touch == Touch::Rest && contact.friction.terms[0] != 0.0
}

/// True if the first terms do not contradict a phase.
pub(super) fn possible(contact: &Touching<FEW>, phase: Phase, touch: Touch, slack: f64) -> bool {
    let not_negative = |jet: Jet<FEW>, order: usize| jet.sign_of(order, slack) >= 0.0;
    match phase {
        Phase::Apart if touch == Touch::AtOnce => not_negative(contact.gap, 0),
        Phase::Apart => touch == Touch::Open || not_negative(contact.gap_rate, 1),
        Phase::Carried => contact.gap_rate.sign_of(1, slack) == 0.0,
        Phase::Sticks(face) | Phase::Leans { face, .. } => {
            margins(contact, face).into_iter().all(|margin| not_negative(margin, 0))
        }
        Phase::Rests { face, .. } => not_negative(margins(contact, face)[0], 0),
        Phase::Slips { face, .. } | Phase::Glides { face, .. } => {
            let leaves = !begins(contact, touch) || not_negative(leaving(contact, phase), 1);
            leaves && not_negative(margins(contact, face)[0], 0)
        }
    }
}

/// A negative number above this relative size counts, even if its error bound is larger.
const SMALL: f64 = 1e-6;

/// Reference sizes for the numbers of a contact: relatively small numbers are rounding errors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    /// The sum of the pressures of the other contacts, N.
    pub others: f64,
    /// The largest rate of the state, SI.
    pub acceleration: f64,
}

impl Beside {
    /// True if a contact contradicts its phase by more than rounding.
    fn contradicts(self, contact: &Touching<TERMS>, phase: Phase, touch: Touch) -> bool {
        let is_below = |jet: Jet<TERMS>, order: usize, size: f64| {
            size > 0.0 && jet.terms[order] < -(SLACKS[0] * jet.doubts[order]).max(SMALL * size)
        };
        let Some(face) = phase.face() else {
            return phase == Phase::Apart
                && matches!(touch, Touch::Rest | Touch::Slides { .. })
                && is_below(contact.gap_rate, 1, self.acceleration);
        };
        let [pressure, forwards, backwards] = margins(contact, face);
        let most = contact.friction.terms[0] * (self.others + pressure.terms[0].abs());
        let own = contact.friction.terms[0] * pressure.terms[0].abs();
        let size = if contact.is_in_space { most * (most + own) } else { most };
        let turns = rate_beside(contact, [most, own]);
        let is_left = |margin: Jet<TERMS>| {
            let is_zero = margin.terms[0] <= (SLACKS[0] * margin.doubts[0]).max(SMALL * size);
            is_below(margin, 0, size) || is_zero && is_below(margin, 1, turns)
        };
        let slips = phase.sticking().is_some() && (is_left(forwards) || is_left(backwards));
        slips || is_below(pressure, 0, self.others)
    }
}

/// The size of the rate of a friction margin: the sum of the absolute rates of its terms.
fn rate_beside<const N: usize>(contact: &Touching<N>, [most, own]: [f64; 2]) -> f64 {
    let Touching { friction, reactions: [normal, tangent, aside], .. } = *contact;
    let rate = |jet: Jet<N>| jet.terms[1].abs();
    let of_bound = (friction.terms[0] * normal.terms[1]).abs() + (friction.terms[1] * normal.terms[0]).abs();
    match contact.is_in_space {
        true => {
            let held = [tangent, aside].map(|part| part.terms[0].abs() * rate(part));
            (most + own) * of_bound + held[0] + held[1]
        }
        false => of_bound + rate(tangent),
    }
}

/// The degree of consistency of the motion of a contact with its phase; `None` for a contradiction. `is_alone` is true if no other
/// contact is closed.
pub(super) fn standing_of(
    contact: &Touching<TERMS>,
    phase: Phase,
    (touch, is_alone): (Touch, bool),
    beside: Beside,
    slack: f64,
) -> Option<Standing> {
    if beside.contradicts(contact, phase, touch) {
        return None;
    }
    let leaves = |jet: Jet<TERMS>| jet.way(slack * jet.doubts[0], slack);
    let (bounds, leaving): (Vec<f64>, Vec<f64>) = match phase {
        Phase::Apart if touch == Touch::Open => (Vec::new(), Vec::new()),
        Phase::Apart if touch == Touch::AtOnce && contact.gap.sign(slack) != 0.0 => {
            (Vec::new(), vec![contact.gap.sign(slack)])
        }
        Phase::Apart | Phase::Carried if leaves(contact.gap_rate) == 0.0 => {
            return Some(if is_alone { Standing::Rests } else { Standing::Carries });
        }
        Phase::Apart => (Vec::new(), vec![leaves(contact.gap_rate)]),
        Phase::Carried => return None,
        Phase::Sticks(face) | Phase::Leans { face, .. } => {
            (margins(contact, face).map(|margin| margin.sign(slack)).to_vec(), Vec::new())
        }
        Phase::Rests { face, .. } => (vec![margins(contact, face)[0].sign(slack)], Vec::new()),
        Phase::Slips { face, .. } | Phase::Glides { face, .. } => {
            let leaving = if begins(contact, touch) { vec![leaves(leaving(contact, phase))] } else { Vec::new() };
            (vec![margins(contact, face)[0].sign(slack)], leaving)
        }
    };
    let contradicts = |sign: &f64| sign.is_nan() || *sign < 0.0;
    match () {
        () if bounds.iter().chain(&leaving).any(contradicts) => None,
        // a slip in space without acceleration has no direction
        () if leaving.contains(&0.0) && matches!(phase, Phase::Glides { .. }) => None,
        () if leaving.contains(&0.0) => Some(Standing::Rests),
        () if bounds.contains(&0.0) => Some(Standing::AtBound),
        () => Some(Standing::Moves),
    }
}

/// The phase of a contact after the decision: a contact that should leave zero, but remains there, rests or is carried.
pub(super) fn at_rest(contact: &Touching<TERMS>, phase: Phase, (touch, is_alone): (Touch, bool), slack: f64) -> Phase {
    let stays = |jet: &Jet<TERMS>| jet.way(slack * jet.doubts[0], slack) == 0.0;
    match phase {
        // a diode with a nonzero current keeps its phase; one without current may be kept there by other diodes
        Phase::Apart if touch == Touch::AtOnce && contact.gap.sign(slack) != 0.0 => phase,
        Phase::Apart if touch == Touch::AtOnce && !is_alone && stays(&contact.gap_rate) => Phase::Carried,
        Phase::Slips { forwards, face } if begins(contact, touch) && stays(&contact.slide) => {
            Phase::Rests { forwards, face }
        }
        other => other,
    }
}
