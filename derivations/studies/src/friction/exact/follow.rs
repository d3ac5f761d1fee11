//! One method along the regimes of a run, event after event.

use super::slowed::Slowed;
use crate::friction::choose::departure;
use crate::friction::log::{Cause, Ending, Entry};
use crate::friction::run::Run;
use crate::friction::settle::{Held, settle};
use crate::friction::stretch::{Stretch, Watched, parts};
use field::{DoubleDouble, Over};
use integrators::{Failure, Happening, Real};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Mode, Touch};
use num_traits::Zero;
use simulation::references::{At, Followed, Means, Unknown};

/// A run in `f64`, which tells the regimes, and a method that follows it to all digits.
pub(super) struct Follower<'a, Q, const N: usize, const C: usize, const K: usize> {
    pub system: &'a Q,
    pub run: &'a Run<N, K>,
    pub start: &'a [f64],
    pub instants: &'a [f64],
    pub means: Means,
}

/// Newton's iteration doubles the digits: where a run knows thirteen one step comes to all that are kept, and the next finds so.
const MOST: usize = 8;
/// A correction so small, relative to the time, leaves nothing to correct.
const LAST: f64 = 1e-20;
/// A determinant so small beside that where it was slowed down is zero to all digits.
const VANISHED: f64 = 1e-31;
/// Doublings of the slowed time: the determinant goes as exp(-s^2).
const DOUBLINGS: usize = 40;

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Follower<'_, Q, N, C, K> {
    /// From the start to the end of the run.
    pub fn follow(mut self) -> Result<(Followed, Means), Unknown> {
        let run = self.run;
        let mut time = DoubleDouble::zero();
        let mut y: Vec<DoubleDouble> = self.start.iter().map(|y| DoubleDouble::lift(*y)).collect();
        let (mut states, mut events, mut left) = (Vec::new(), Vec::new(), self.instants);
        for (place, entry) in run.entries.iter().enumerate() {
            let next = run.entries.get(place + 1);
            let stretch = stretch(self.system, entry);
            let until = next.map_or(run.state.time, |next| next.time);
            let within = left.iter().take_while(|instant| next.is_none() || **instant < until).count();
            for &instant in &left[..within] {
                let instant = DoubleDouble::lift(instant);
                y = self.flow(&stretch, [time, instant], &y)?;
                time = instant;
                states.push(y.clone());
            }
            left = &left[within..];
            (time, y) = match (next, run.ending) {
                (Some(next), _) => self.event(&stretch, next, (time, y))?,
                (None, Ending::TouchDown { contact, .. }) => {
                    self.zero_of(&stretch, Watched::Gap(contact), until, (time, y))?
                }
                (None, Ending::Critical) => self.jam(&stretch, until, (time, y))?,
                (None, _) => break,
            };
            events.push((time, y.clone()));
        }
        Ok((Followed { states, events }, self.means))
    }

    fn flow(
        &mut self,
        stretch: &Stretch<'_, Q, N, C, K>,
        span: [DoubleDouble; 2],
        y: &[DoubleDouble],
    ) -> Result<Vec<DoubleDouble>, Failure> {
        if stretch.rests || is_rigid(stretch, y) { Ok(y.to_vec()) } else { self.means.flow(stretch, span, y) }
    }

    /// The event with which a regime gives way to the next one, its state made exact as in the run.
    fn event(&mut self, stretch: &Stretch<'_, Q, N, C, K>, next: &Entry<K>, (time, y): At) -> Result<At, Unknown> {
        let blunt = Unknown::Blunt { time: next.time };
        let Cause::Signal { watched, what, .. } = next.cause else { return Err(blunt) };
        let still = next.velocity.iter().all(|v| *v == 0.0);
        let (time, y) = match (watched, what) {
            (_, Happening::StartsBelow) => (time, y),
            (Watched::Rest | Watched::Uniqueness, _) if still => (self.release(next, &y).ok_or(blunt)?, y),
            (Watched::Condition(..) | Watched::Sliding(_) | Watched::Gap(_), Happening::Falls) => {
                self.zero_of(stretch, watched, next.time, (time, y))?
            }
            _ => return Err(blunt),
        };
        let held = std::array::from_fn(|k| Held {
            closed: stretch.regime[k] != Mode::Apart || watched == Watched::Gap(k),
            at_rest: matches!(stretch.regime[k], Mode::Stick(_)) || watched == Watched::Sliding(k),
        });
        let (settled, _) = settle(self.system, &parts::<_, N>(time, &y), held);
        let velocity = if still { [DoubleDouble::zero(); N] } else { settled.velocity };
        Ok((time, [&settled.place[..], &velocity, &y[2 * N..]].concat()))
    }

    /// When a system that rests is let go: the departure with which the next regime begins is zero.
    fn release(&self, next: &Entry<K>, y: &[DoubleDouble]) -> Option<DoubleDouble> {
        let moves = stretch(self.system, next);
        let touches = next.regime.map(|mode| if mode == Mode::Apart { Touch::Open } else { Touch::Rest });
        let mut time = DoubleDouble::lift(next.time);
        for _ in 0..MOST {
            let at = State { velocity: [DoubleDouble::zero(); N], ..parts(time, y) };
            let margin = departure(&moves, &at, &touches)?;
            let step = margin.value / margin.slope;
            time -= step.finite().then_some(step)?;
            if step.approx().abs() <= LAST * time.approx().abs() {
                return Some(time);
            }
        }
        None
    }

    /// Where a signal is zero, close to where the run found it: Newton's method on the instant, the motion followed to each.
    fn zero_of(
        &mut self,
        stretch: &Stretch<'_, Q, N, C, K>,
        watched: Watched,
        close: f64,
        (from, y): At,
    ) -> Result<At, Unknown> {
        let blunt = Unknown::Blunt { time: close };
        let mut time = DoubleDouble::lift(close);
        let mut y = self.flow(stretch, [from, time], &y)?;
        for _ in 0..MOST {
            let moving = stretch.moving(&parts(time, &y));
            let signal = moving.and_then(|moving| stretch.signal(watched, &moving)).ok_or_else(|| blunt.clone())?;
            let step = signal.value / signal.slope;
            if !step.finite() {
                return Err(blunt);
            }
            y = self.flow(stretch, [time, time - step], &y)?;
            time -= step;
            if step.approx().abs() <= LAST * time.approx().abs() {
                return Ok((time, y));
            }
        }
        Err(blunt)
    }

    /// The end of a regime whose determinant vanishes: the instant, and the places.
    fn jam(&mut self, stretch: &Stretch<'_, Q, N, C, K>, close: f64, (from, y): At) -> Result<At, Unknown> {
        let unknown = Unknown::Blunt { time: close };
        let slowed = Slowed { stretch };
        let first = slowed.determinant(from, &y).ok_or_else(|| unknown.clone())?.approx();
        let mut both = [&y[..2 * N], &[from]].concat();
        let mut length = (close - from.approx()) / first;
        for _ in 0..DOUBLINGS {
            both = self.means.run(&slowed, length, &both, &[close])?;
            let Some((&time, y)) = both.split_last() else { return Err(unknown) };
            let now = slowed.determinant(time, y).ok_or_else(|| unknown.clone())?.approx();
            if now / first <= VANISHED {
                return Ok((time, y[..N].to_vec()));
            }
            length *= 2.0;
        }
        Err(unknown)
    }
}

/// Whether nothing moves, as many conditions holding as there are coordinates: to follow would be to follow rounding.
fn is_rigid<Q, const N: usize, const C: usize, const K: usize>(
    stretch: &Stretch<'_, Q, N, C, K>,
    y: &[DoubleDouble],
) -> bool {
    let sticks = stretch.regime.iter().filter(|mode| matches!(mode, Mode::Stick(_))).count();
    C + 2 * sticks >= N && y[N..2 * N].iter().all(DoubleDouble::is_zero)
}

/// A regime of a run as a law; what is seen of its signals' sizes is not asked for.
fn stretch<'a, Q, const N: usize, const C: usize, const K: usize>(
    system: &'a Q,
    Entry { regime, determined, .. }: &Entry<K>,
) -> Stretch<'a, Q, N, C, K> {
    let (rough, orientation, speed, load) = ([true; K], 1.0, 0.0, 0.0);
    Stretch { system, regime: *regime, rough, rests: !determined, orientation, speed, load }
}
