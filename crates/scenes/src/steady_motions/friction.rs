//! Stability of rest under dry friction. Such friction is a condition c = a(q) u, linear in the speeds u, with a force that jumps by J = -f a
//! where c becomes positive.
//!
//! At a rest q0 each friction acts with a fraction s strictly between 0 and 1. Near q0 the kinetic energy T satisfies
//!
//!   T' <= L |q - q0| |u| + C |u|^2 - sum_i d_i f_i |a_i u| ,   d_i = min(s_i, 1 - s_i) ,
//!
//! with bounds L and C of the other forces. If every f_i is positive and the vectors a_i together with the gradients of constraints span all
//! directions, T' <= -k |u| near q0 for small u, with some k > 0: after a small push the system moves at most a distance T/k and stops. The rest
//! is then stable for any other forces. If every f_i is negative, T grows at such a rate, and the rest is unstable.

use super::conditions::Case;
use super::definiteness::signs;
use super::rows::Rows;
use field::Interval;
use model::equations::vanishes;
use symbolic::{Sym, Tape, substitute_all};

/// The effect of dry friction on small motions about a position of rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// Friction dissipates energy in every motion: the rest is stable.
    Resists,
    /// Friction supplies energy to every motion, since its coefficient is negative: the rest is unstable.
    Feeds,
    /// Friction acts in some directions only.
    Partial,
    /// Friction depends on normal reactions of contacts, which may change when these slide.
    OfContacts,
    /// Not decided.
    Open,
}

/// The dry friction in one combination of cases, as a function of the unknowns.
#[derive(Debug)]
pub(super) struct FrictionLaw {
    /// The indices of the fractions s among the unknowns.
    shares: Vec<usize>,
    /// Computes f, then a, for each friction; then the gradient of each constraint.
    tape: Option<Tape>,
    speeds: usize,
    of_contacts: bool,
}

/// Expressions of the equations at rest.
pub(super) struct AtRest<'a> {
    pub speeds: &'a [Sym],
    /// The residuals before substitution of the data.
    pub residuals: &'a [Sym],
    /// The letters of the unknowns; `multipliers` are those of the reactions.
    pub letters: &'a [Sym],
    pub multipliers: &'a [Sym],
}

impl FrictionLaw {
    /// The friction law; `None` if neither a condition nor a contact with friction sticks.
    pub fn of(rows: &Rows, cases: &[Case], rest: &AtRest<'_>, put: &dyn Fn(&[Sym]) -> Vec<Sym>) -> Option<Self> {
        let held = |place: &usize| cases[*place] == Case::Between;
        let conditions = rows.condition_letters.len();
        let own: Vec<usize> =
            (0..conditions).filter(held).filter(|&k| rest.letters.contains(&rows.condition_letters[k])).collect();
        let of_contacts =
            rows.contacts.iter().enumerate().any(|(k, own)| own.friction.is_some() && held(&(conditions + k)));
        // a bouncing contact may gain energy from other forces in each flight
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

    /// The effect at every rest in a box of the unknowns whose fractions s are strictly between 0 and 1.
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

    /// The effect at one rest; `Friction::Open` if a fraction may be 0 or 1.
    pub fn at_motion(&self, enclosure: &[Interval]) -> Friction {
        let is_inside = |&share: &usize| enclosure[share].low() > 0.0 && enclosure[share].high() < 1.0;
        if self.shares.iter().all(is_inside) { self.at(enclosure) } else { Friction::Open }
    }
}

/// The expressions f and a of one friction; `None` if the condition or the force has another form.
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
