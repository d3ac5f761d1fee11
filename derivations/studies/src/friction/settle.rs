//! A state made to satisfy what holds in it exactly: constraints, closed gaps, contacts at rest.
//!
//! The least change in the metric of the masses, dx = M^-1 (sum of rows), row after row orthogonalised: a row that
//! depends on those before it (a body held more than needed) changes nothing.

use super::stretch::motion_of_contacts;
use field::Tangent;
use integrators::Real;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::differentiate::{fixed, gradient};

/// Which of a contact's coordinates are zero: closed means gap and its rate, at rest the rate along the curve too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Held {
    pub closed: bool,
    pub at_rest: bool,
}

/// Rows below this, after what they share with others is taken off, depend on them.
const DEPENDENT: f64 = 1e-10;

/// Twice: places of constraints that are not linear converge quadratically from the accuracy of the run.
const PASSES: usize = 3;

/// The state closest to this one that satisfies everything held, and how far it is: the largest change of a place.
pub fn settle<Q, S: Real, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    held: [Held; K],
) -> (State<S, N>, f64)
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let mut settled = *at;
    let masses: [S; N] = system.masses();
    for _ in 0..PASSES {
        let mut change = Change::new(masses);
        let own = system.constraints(&settled);
        for (c, constraint) in own.into_iter().enumerate() {
            if let mechanics::constrained::Constraint::Geometric(value) = constraint {
                change.require(own_gradient(system, &settled, c), value);
            }
        }
        let contacts = system.contacts(settled.time, settled.place);
        for k in (0..K).filter(|&k| held[k].closed) {
            change.require(contact_gradient(system, &settled, k, 0), contacts[k].gap);
        }
        (0..N).for_each(|i| settled.place[i] += change.total[i]);
    }
    let mut change = Change::new(masses);
    let rows: [[S; N]; C] = mechanics::constrained::rates::jacobian(system, &settled);
    let values = first_rates(system, &settled);
    for c in 0..C {
        change.require(rows[c], values[c]);
    }
    let motions = motion_of_contacts(system, &settled);
    for k in 0..K {
        for (i, held) in [held[k].closed, held[k].at_rest].into_iter().enumerate() {
            if held {
                change.require(contact_gradient(system, &settled, k, i), motions[k][i].slope);
            }
        }
    }
    (0..N).for_each(|i| settled.velocity[i] += change.total[i]);
    let moved = (0..N).map(|i| (settled.place[i] - at.place[i]).approx().abs()).fold(0.0, f64::max);
    (settled, moved)
}

/// df/dt of the geometric constraints, the values of the kinematic ones.
fn first_rates<Q, S: Real, const N: usize, const C: usize, const K: usize>(system: &Q, at: &State<S, N>) -> [S; C]
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let moving = State {
        time: Tangent::variable(at.time),
        place: std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i])),
        velocity: fixed(at.velocity),
    };
    system.constraints(&moving).map(|constraint| match constraint {
        mechanics::constrained::Constraint::Geometric(f) => f.slope,
        mechanics::constrained::Constraint::Kinematic(phi) => phi.value,
    })
}

fn own_gradient<Q, S: Real, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    c: usize,
) -> [S; N]
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let value = |place| {
        let moved = State { time: Tangent::fixed(at.time), place, velocity: fixed(at.velocity) };
        system.constraints(&moved)[c].value()
    };
    gradient(value, at.place)
}

fn contact_gradient<Q, S: Real, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
    k: usize,
    component: usize,
) -> [S; N]
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let time = Tangent::fixed(at.time);
    let value = |place| {
        let contact = system.contacts(time, place)[k];
        [contact.gap, contact.along][component]
    };
    gradient(value, at.place)
}

/// A change that meets requirements one after another.
struct Change<S, const N: usize> {
    masses: [S; N],
    total: [S; N],
    /// Rows met so far, orthonormal in the metric of the inverse masses.
    rows: [Option<[S; N]>; N],
}

impl<S: Real, const N: usize> Change<S, N> {
    fn new(masses: [S; N]) -> Self {
        Change { masses, total: [S::zero(); N], rows: [None; N] }
    }

    fn product(&self, a: &[S; N], b: &[S; N]) -> S {
        (0..N).fold(S::zero(), |sum, i| sum + a[i] * b[i] / self.masses[i])
    }

    /// row . total = -value, keeping what was required before.
    fn require(&mut self, row: [S; N], value: S) {
        let whole = self.product(&row, &row);
        let mut own = row;
        for met in self.rows.iter().flatten() {
            let share = self.product(&own, met);
            (0..N).for_each(|i| own[i] -= share * met[i]);
        }
        let rest = self.product(&own, &own);
        let independent = rest > S::lift(DEPENDENT) * whole;
        let Some(place) = self.rows.iter().position(Option::is_none).filter(|_| independent) else {
            return;
        };
        let missing = (0..N).fold(-value, |missing, i| missing - row[i] * self.total[i]);
        (0..N).for_each(|i| self.total[i] += own[i] / self.masses[i] * (missing / rest));
        self.rows[place] = Some(own.map(|entry| entry / rest.sqrt()));
    }
}
