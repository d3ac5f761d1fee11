//! A stretch of motion in one regime.

use field::{Analytic, DoubleDouble, Over, Scalar, Tangent};
use integrators::{Directions, Ode, Signal, Switches};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::conditions::Conditions;
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Condition, Dry, Found, Mode, Ordered, Seen, Touch, Verdict, conditions, verdict};
use std::cmp::Ordering;

/// A system in a regime. The integrated state is (x, x', work of friction, work of the given forces).
#[derive(Clone, Copy, Debug)]
pub struct Stretch<'a, Q, const N: usize, const C: usize, const K: usize> {
    pub system: &'a Q,
    pub regime: [Mode; K],
    /// Whether a contact has friction: at a smooth one the direction of sliding changes nothing.
    pub rough: [bool; K],
    /// Whether the system rests, held by more reactions than are determined: nothing moves while this stays possible.
    pub rests: bool,
    /// The sign of the regime's determinant at the start.
    pub orientation: f64,
    /// The largest speed of the run, and the force at its start: what rounding is measured by.
    pub speed: f64,
    pub load: f64,
}

/// What a signal stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// A condition of the regime, at a contact.
    Condition(usize, Condition),
    /// The velocity of sliding at a contact, in the direction of its slip.
    Sliding(usize),
    /// The gap of an open contact.
    Gap(usize),
    /// The determinant of the regime.
    Determinant,
    /// 1 while the regime is the only motion, -1 where it is not.
    Uniqueness,
    /// 1 while rest is the only motion, -1 where it is not.
    Rest,
}

/// At most so many signals a contact: three conditions and the sliding, or the gap alone.
const EACH: usize = 4;

/// The parts of an integrated state.
pub fn parts<S: Scalar, const N: usize>(time: S, y: &[S]) -> State<S, N> {
    State { time, place: std::array::from_fn(|i| y[i]), velocity: std::array::from_fn(|i| y[N + i]) }
}

/// Gap and place along the curve of each contact with their rates along the velocity.
pub fn motion_of_contacts<Q, S, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    at: &State<S, N>,
) -> [[Tangent<S>; 2]; K]
where
    Q: Contacts<N, C, K>,
    S: Over<Q::Given>,
{
    let moving = std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i]));
    system.contacts(Tangent::moving(at.time, S::one()), moving).map(|contact| [contact.gap, contact.along])
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Stretch<'_, Q, N, C, K> {
    /// What the contacts are during the stretch: a slip slides, however slowly it began.
    pub fn touches(&self, open: [bool; K]) -> [Touch; K] {
        std::array::from_fn(|k| match self.regime[k] {
            Mode::Apart if open[k] => Touch::Open,
            Mode::Slip(direction, _) => Touch::Slides(direction),
            Mode::Apart | Mode::Stick(_) => Touch::Rest,
        })
    }

    /// The contacts' view and the regime's reactions; `None` where the constraints are dependent.
    pub fn solve<S: Over<f64>>(&self, at: &State<S, N>) -> Option<(Seen<S, N, K>, Cramer<S, K>)> {
        let seen = Seen::of(self.system, at, self.system.force(at)).ok()?;
        let cramer = Cramer::of(&seen.dry, &self.regime);
        Some((seen, cramer))
    }

    /// The list of the signals.
    pub fn watched(&self) -> impl Iterator<Item = Watched> {
        let of_contact = |k: usize| {
            let mut list = [None; EACH];
            match self.regime[k] {
                Mode::Apart => list[0] = Some(Watched::Gap(k)),
                Mode::Stick(_) => {
                    let limits = [Condition::Presses, Condition::HoldsForwards, Condition::HoldsBackwards];
                    (0..3).for_each(|i| list[i] = Some(Watched::Condition(k, limits[i])));
                }
                Mode::Slip(..) => {
                    list[0] = Some(Watched::Condition(k, Condition::Presses));
                    list[3] = self.rough[k].then_some(Watched::Sliding(k));
                }
            }
            list
        };
        let (contacts, all): (_, &[_]) = match self.rests {
            true => (0, &[Watched::Rest]),
            false => (K, &[Watched::Determinant, Watched::Uniqueness]),
        };
        (0..contacts).flat_map(of_contact).flatten().chain(all.iter().copied())
    }

    /// What a signal is measured by; none of one that only has a sign.
    pub fn size(&self, watched: Watched) -> Option<f64> {
        match watched {
            Watched::Condition(..) => Some(self.load),
            Watched::Sliding(_) => Some(self.speed),
            Watched::Gap(_) => Some(1.0),
            Watched::Determinant | Watched::Uniqueness | Watched::Rest => None,
        }
    }

    /// 1 while rest is the only motion, -1 where it is not.
    fn rest(&self, at: &State<f64, N>) -> Option<Signal> {
        let dry = Dry::of(self.system, at, self.system.force(at)).ok()?;
        let rests = match verdict(&dry, &self.touches(self.open())) {
            Verdict::Unique(found) => is_rest(&dry, &found),
            _ => false,
        };
        Some(Signal { value: if rests { 1.0 } else { -1.0 }, rate: 0.0, ..Signal::default() })
    }

    /// What the signals are read off, along the motion; `None` where the constraints are dependent.
    pub fn moving<S: Over<f64>>(&self, at: &State<S, N>) -> Option<Moving<S, K>> {
        let (seen, cramer) = self.solve(at)?;
        let acceleration = seen.acceleration(&cramer.reactions());
        let moving = State {
            time: Tangent::variable(at.time),
            place: std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i])),
            velocity: std::array::from_fn(|i| Tangent::moving(at.velocity[i], acceleration[i])),
        };
        let (seen, cramer) = self.solve(&moving)?;
        let required = conditions(&seen.dry, &self.touches(self.open()), &self.regime);
        Some(Moving { cramer, required, contacts: motion_of_contacts(self.system, &moving), dry: seen.dry })
    }

    /// A signal and its rate; none of one that only has a sign.
    pub fn signal<S: Over<f64>>(&self, watched: Watched, moving: &Moving<S, K>) -> Option<Tangent<S>> {
        match watched {
            Watched::Condition(k, condition) => {
                let form = moving.required[k].iter().flatten().find(|(name, _)| *name == condition);
                form.map(|(_, form)| moving.cramer.value(form))
            }
            Watched::Sliding(k) => match self.regime[k] {
                Mode::Slip(direction, _) => Some(moving.contacts[k][1].slope * direction.sign()),
                Mode::Stick(_) | Mode::Apart => None,
            },
            Watched::Gap(k) => Some(moving.contacts[k][0].value),
            Watched::Determinant => Some(moving.cramer.determinant * Tangent::fixed(S::lift(self.orientation))),
            Watched::Uniqueness | Watched::Rest => None,
        }
    }

    /// Which contacts are apart.
    fn open(&self) -> [bool; K] {
        self.regime.map(|mode| mode == Mode::Apart)
    }

    /// The signals in the order of their list, with rates.
    fn read(&self, at: &State<f64, N>, out: &mut [Signal]) -> Option<()> {
        if self.rests {
            out.fill(self.rest(at)?);
            return Some(());
        }
        let moving = self.moving(at)?;
        let noise = f64::EPSILON * 64.0;
        for (signal, watched) in out.iter_mut().zip(self.watched()) {
            let value = match watched {
                Watched::Uniqueness | Watched::Rest => {
                    let unique =
                        matches!(verdict(&at_rest(&moving.dry), &self.touches(self.open())), Verdict::Unique(_));
                    Tangent::fixed(if unique { 1.0 } else { -1.0 })
                }
                smooth => self.signal(smooth, &moving)?,
            };
            let size = self.size(watched).unwrap_or(0.0);
            *signal = Signal { value: value.value, rate: value.slope, noise: noise * size, ..Signal::default() };
        }
        Some(())
    }
}

/// The contacts of a regime along its motion: values with their rates.
pub struct Moving<S, const K: usize> {
    dry: Dry<Tangent<S>, K>,
    cramer: Cramer<Tangent<S>, K>,
    required: Conditions<Tangent<S>, K>,
    /// Gap and place along the curve of each, with rates of their own.
    contacts: [[Tangent<Tangent<S>>; 2]; K],
}

/// Whether no contact is accelerated.
pub fn is_rest<const K: usize>(dry: &Dry<f64, K>, found: &Found<f64, K>) -> bool {
    let size: f64 = dry.free.as_flattened().iter().map(|b| b.abs()).sum();
    found.motion.as_flattened().iter().all(|a| a.sign_among(size) == Ordering::Equal)
}

/// The contacts' view without its rates.
fn at_rest<const K: usize>(dry: &Dry<Tangent<f64>, K>) -> Dry<f64, K> {
    Dry {
        free: dry.free.map(|pair| pair.map(|x| x.value)),
        response: dry.response.map(|rows| rows.map(|row| row.map(|pair| pair.map(|x| x.value)))),
        friction: dry.friction.map(|f| f.value),
        sides: dry.sides,
    }
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Switches
    for Stretch<'_, Q, N, C, K>
{
    fn count(&self) -> usize {
        self.watched().count()
    }

    fn signals(&self, time: f64, y: &[f64], out: &mut [Signal]) {
        if self.read(&parts(time, y), out).is_none() {
            out.fill(Signal { value: -1.0, rate: 0.0, ..Signal::default() });
        }
    }
}

impl<Q, S, const N: usize, const C: usize, const K: usize> Ode<S> for Stretch<'_, Q, N, C, K>
where
    Q: Contacts<N, C, K, Given = f64>,
    S: Over<f64> + Analytic,
{
    fn dimension(&self) -> usize {
        2 * N + 2
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        if self.rests {
            dy.fill(S::zero());
            return;
        }
        let at = parts::<S, N>(t, y);
        let force: [S; N] = self.system.force(&at);
        let Some((seen, cramer)) = self.solve(&at) else {
            dy.fill(S::one() / S::zero());
            return;
        };
        let reactions = cramer.reactions();
        let acceleration = seen.acceleration(&reactions);
        dy[..N].copy_from_slice(&at.velocity);
        dy[N..2 * N].copy_from_slice(&acceleration);
        let slides = motion_of_contacts(self.system, &at);
        dy[2 * N] = (0..K).fold(S::zero(), |sum, k| sum + reactions[k][1] * slides[k][1].slope);
        dy[2 * N + 1] = (0..N).fold(S::zero(), |sum, i| sum + force[i] * at.velocity[i]);
    }
}

impl<Q, const N: usize, const C: usize, const K: usize> integrators::System for Stretch<'_, Q, N, C, K>
where
    Q: Contacts<N, C, K, Given = f64>,
    Self: Ode<f64> + Ode<Directions> + Ode<DoubleDouble>,
{
}
