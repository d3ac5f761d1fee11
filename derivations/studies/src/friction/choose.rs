//! The regime that goes on from a state.

use super::log::Ending;
use super::stretch::{Stretch, motion_of_contacts};
use field::{Over, Tangent};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::differentiate::fixed;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::verdict::differ;
use mechanics::regimes::{Condition, Found, Mode, Ordered, Seen, Touch, conditions, consistent};
use std::cmp::Ordering;

/// The one motion that goes on, or why there is none.
///
/// At a tie several regimes may name one motion. That one goes on all of whose vanishing margins rise along its own
/// motion; without any, one whose vanishing margins stay as they are. A regime that has just ceased to be the only
/// motion does not go on by another name of itself.
///
/// # Errors
/// The diagnosis.
pub fn choose<'a, Q, const N: usize, const C: usize, const K: usize>(
    system: &'a Q,
    at: &State<f64, N>,
    touches: &[Touch; K],
    ceased: Option<[Mode; K]>,
    stretch: impl Fn([Mode; K]) -> Stretch<'a, Q, N, C, K>,
) -> Result<Found<f64, K>, Ending<K>>
where
    Q: Contacts<N, C, K, Given = f64> + 'a,
{
    let dry = Seen::of(system, at, system.force(at)).map_err(|_| Ending::Undefined)?.dry;
    let mut first: Option<Found<f64, K>> = None;
    let mut problem = None;
    let mut best: Option<(Ordering, Found<f64, K>)> = None;
    consistent(&dry, touches, |found| {
        if !found.single {
            problem = problem.or(Some(Ending::Continuum(found.regime)));
        }
        match &first {
            Some(known) if differ(&dry, known, &found) => {
                problem = problem.or(Some(Ending::Several(known.regime, found.regime)));
            }
            _ => first = first.or(Some(found)),
        }
        if ceased == Some(found.regime) {
            return;
        }
        let trend = trend(&stretch(found.regime), at, touches, &found);
        if trend != Ordering::Less && best.as_ref().is_none_or(|(known, _)| trend > *known) {
            best = Some((trend, found));
        }
    });
    match (problem, first, best) {
        (Some(problem), ..) => Err(problem),
        (None, None, _) => Err(Ending::NoMotion),
        (None, Some(_), None) => Err(Ending::Tie),
        (None, Some(_), Some((_, found))) => Ok(found),
    }
}

/// The departure that vanishes in a regime as rest ends, with its rate while the system still rests: an event that was
/// located by a tie is as sharp as the tie, this margin says its time.
pub fn departure<Q, S: Over<f64>, const N: usize, const C: usize, const K: usize>(
    stretch: &Stretch<'_, Q, N, C, K>,
    at: &State<S, N>,
    touches: &[Touch; K],
) -> Option<Tangent<S>>
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let later = State { time: Tangent::variable(at.time), place: fixed(at.place), velocity: fixed(at.velocity) };
    let (seen, cramer) = stretch.solve(&later)?;
    let required = conditions(&seen.dry, touches, &stretch.regime);
    let departs = required.as_flattened().iter().flatten().find(|(name, _)| *name == Condition::Departs);
    Some(cramer.value(&departs?.1))
}

/// The least trend of the margins that vanish: `Greater` where none does.
fn trend<Q, const N: usize, const C: usize, const K: usize>(
    stretch: &Stretch<'_, Q, N, C, K>,
    at: &State<f64, N>,
    touches: &[Touch; K],
    found: &Found<f64, K>,
) -> Ordering
where
    Q: Contacts<N, C, K, Given = f64>,
{
    if !found.determined {
        return Ordering::Greater;
    }
    let Some((seen, cramer)) = stretch.solve(at) else { return Ordering::Less };
    let acceleration = seen.acceleration(&cramer.reactions());
    let moving = State {
        time: Tangent::variable(at.time),
        place: std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i])),
        velocity: std::array::from_fn(|i| Tangent::moving(at.velocity[i], acceleration[i])),
    };
    let Some((next, rising)) = stretch.solve(&moving) else { return Ordering::Less };
    let (now, later) = (conditions(&seen.dry, touches, &found.regime), conditions(&next.dry, touches, &found.regime));
    let mut least = Ordering::Greater;
    for k in 0..K {
        for (form, moving_form) in now[k].iter().flatten().zip(later[k].iter().flatten()) {
            let size = if matches!(form.0, Condition::Separates | Condition::Departs) {
                seen.dry.free[k].iter().map(|b| b.abs()).sum::<f64>()
                    + acceleration.iter().map(|a| a.abs()).sum::<f64>()
            } else {
                stretch.load
            };
            if cramer.value(&form.1).sign_among(size) == Ordering::Equal {
                let rate = rising.value(&moving_form.1).slope;
                least = least.min(rate.sign_among(size * (1.0 + stretch.speed)));
            }
        }
    }
    least
}

/// Closed contacts and those at rest, as a regime leaves them.
pub fn touches_after<Q, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<f64, N>,
    closed: [bool; K],
    at_rest: [bool; K],
    speed: f64,
) -> [Touch; K]
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let motions = motion_of_contacts(system, at);
    std::array::from_fn(|k| {
        if !closed[k] {
            return Touch::Open;
        }
        let along = if at_rest[k] { Ordering::Equal } else { motions[k][1].slope.sign_among(speed) };
        mechanics::regimes::Direction::of(along).map_or(Touch::Rest, Touch::Slides)
    })
}

/// The determinant of a regime at a state.
pub fn determinant<Q, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<f64, N>,
    regime: &[Mode; K],
) -> Option<f64>
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let seen = Seen::of(system, at, system.force(at)).ok()?;
    Some(Cramer::of(&seen.dry, regime).determinant)
}
