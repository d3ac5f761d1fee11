//! Dry friction at rest, which is a condition c = a(q) u on the speeds u, linear in them, with a force that jumps by J = -f a where c becomes
//! positive.
//!
//! At a rest q0 with the share s of each friction strictly between 0 and 1 the equations balance. About it the kinetic energy T has the rate
//!
//!   T' <= L |q - q0| |u| + C |u|^2 - sum_i d_i f_i |a_i u| ,   d_i = min(s_i, 1 - s_i) ,
//!
//! with bounds L and C of the other forces. Where every f_i is positive, and the a_i with the gradients of constraints span all directions,
//! T' <= -k |u| near q0 and for small u with some k > 0: after a small push the system moves by at most T/k and stops. The rest is stable,
//! whatever the other forces are. Where every f_i is negative, T grows as fast, and the rest is unstable.

use super::conditions::Case;
use super::definiteness::signs;
use super::rows::Rows;
use field::Interval;
use model::equations::vanishes;
use symbolic::{Sym, Tape, substitute_all};

/// The effect of dry friction on small motions about a rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// It resists every motion: the rest is stable.
    Resists,
    /// It feeds every motion, since its coefficient is negative: the rest is unstable.
    Feeds,
    /// It acts on some motions only.
    Partial,
    /// Its force depends on normal forces of contacts, which may change when they slide.
    OfContacts,
    /// Not decided.
    Open,
}

/// The friction of a combination of cases, over the unknowns.
#[derive(Debug)]
pub(super) struct FrictionLaw {
    /// The places of its shares among the unknowns.
    shares: Vec<usize>,
    /// For each friction f, then a; then the gradient of each constraint.
    tape: Option<Tape>,
    speeds: usize,
    of_contacts: bool,
}

/// The expressions of a combination at rest.
pub(super) struct AtRest<'a> {
    pub speeds: &'a [Sym],
    /// The residuals before the data are put in.
    pub residuals: &'a [Sym],
    /// The letters of the unknowns, and those of reactions.
    pub letters: &'a [Sym],
    pub multipliers: &'a [Sym],
}

impl FrictionLaw {
    /// None where no condition is held at zero.
    pub fn of(rows: &Rows, cases: &[Case], rest: &AtRest<'_>, put: &dyn Fn(&[Sym]) -> Vec<Sym>) -> Option<Self> {
        let held = |place: &usize| cases[*place] == Case::Between;
        let conditions = rows.condition_letters.len();
        let own: Vec<usize> =
            (0..conditions).filter(held).filter(|&k| rest.letters.contains(&rows.condition_letters[k])).collect();
        let of_contacts =
            rows.contacts.iter().enumerate().any(|(k, own)| own.friction.is_some() && held(&(conditions + k)));
        // a contact that bounces may gain energy from the other forces in every flight
        let bounces = rows.contacts.iter().enumerate().any(|(k, own)| {
            own.bounces && matches!(cases[conditions + k], Case::Between | Case::Forward | Case::Backward)
        });
        let share = |k: &usize| rest.letters.iter().position(|letter| *letter == rows.condition_letters[*k]);
        let shares: Vec<usize> = own.iter().filter_map(share).collect();
        if shares.is_empty() && !of_contacts {
            return None;
        }
        let jumping: Vec<Sym> = own.iter().map(|&k| rows.condition_letters[k]).collect();
        let laws: Option<Vec<Vec<Sym>>> =
            own.iter().map(|&k| law((rows.conditions[k], rows.condition_letters[k]), &jumping, rest, put)).collect();
        let gradients = rest.multipliers.iter().flat_map(|&by| rest.residuals.iter().map(move |row| row.diff(by)));
        let gradients = put(&gradients.collect::<Vec<_>>());
        let tape = laws
            .filter(|_| !bounces)
            .and_then(|laws| Tape::record(rest.letters, &[laws.concat(), gradients].concat()).ok());
        Some(FrictionLaw { shares, tape, speeds: rest.speeds.len(), of_contacts })
    }

    /// The effect at every rest in an enclosure of the unknowns whose shares lie strictly inside their ranges.
    pub fn at(&self, enclosure: &[Interval]) -> Friction {
        if self.of_contacts {
            return Friction::OfContacts;
        }
        let Some(tape) = &self.tape else { return Friction::Open };
        let n = self.speeds;
        let mut values = vec![Interval::EVERYTHING; tape.outputs()];
        tape.over::<Interval>().evaluate(enclosure, &mut values);
        let (laws, gradients) = values.split_at(self.shares.len() * (n + 1));
        let laws: Vec<&[Interval]> = laws.chunks(n + 1).collect();
        let directions: Vec<&[Interval]> = laws.iter().map(|law| &law[1..]).chain(gradients.chunks(n)).collect();
        let entry =
            |at: usize| directions.iter().fold(Interval::point(0.0), |sum, own| sum + own[at / n] * own[at % n]);
        let spans = signs(&(0..n * n).map(entry).collect::<Vec<_>>(), n) == Some([0, n]);
        let resists = laws.iter().all(|law| law[0].low() > 0.0);
        let feeds = laws.iter().all(|law| law[0].high() < 0.0);
        match (resists, feeds) {
            (true, _) if spans => Friction::Resists,
            (_, true) if spans => Friction::Feeds,
            (true, _) | (_, true) if directions.len() < n => Friction::Partial,
            _ => Friction::Open,
        }
    }

    /// The effect at one rest, whose shares may lie at the ends of their ranges.
    pub fn at_motion(&self, enclosure: &[Interval]) -> Friction {
        let is_inside = |&share: &usize| enclosure[share].low() > 0.0 && enclosure[share].high() < 1.0;
        if self.shares.iter().all(is_inside) { self.at(enclosure) } else { Friction::Open }
    }
}

/// f and a of one friction; none where the condition or its force is another one.
fn law(
    (condition, letter): (Sym, Sym),
    jumping: &[Sym],
    rest: &AtRest<'_>,
    put: &dyn Fn(&[Sym]) -> Vec<Sym>,
) -> Option<Vec<Sym>> {
    let at_rest: Vec<(Sym, Sym)> = rest.speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let along: Vec<Sym> = rest.speeds.iter().map(|&speed| condition.diff(speed).substitute(&at_rest)).collect();
    let linear = along.iter().zip(rest.speeds).fold(Sym::ZERO, |sum, (by, speed)| sum + *by * *speed);
    let jumps: Vec<Sym> = rest.residuals.iter().map(|row| row.diff(letter)).collect();
    let jumps = substitute_all(&jumps, &at_rest);
    let (along, jumps, excess) = (put(&along), put(&jumps), put(&[condition - linear]));
    let is_fixed = |jump: &Sym| jumping.iter().all(|&own| vanishes(jump.diff(own)));
    let first = (0..along.len()).find(|&k| !vanishes(along[k]))?;
    let is_parallel = (0..along.len()).all(|k| vanishes(jumps[k] * along[first] - jumps[first] * along[k]));
    let is_friction = vanishes(excess[0]) && is_parallel && jumps.iter().all(is_fixed);
    is_friction.then(|| [&[-jumps[first] / along[first]][..], &along].concat())
}
