//! Stretch after stretch.

use super::choose::{choose, departure, determinant, touches_after};
use super::log::{Cause, Ending, Entry};
use super::settle::{Held, settle};
use super::stretch::{Stretch, Watched, motion_of_contacts, parts};
use integrators::{End, Event, Method, Observer, Signal, Span, Switches, Tolerance, Work, integrate_to_event};
use mechanics::constrained::contacts::Contacts;
use mechanics::constrained::{State, kinetic_energy};
use mechanics::regimes::{Mode, Ordered, Sizes, Touch, touches};
use std::cmp::Ordering;
use std::time::{Duration, Instant};

/// A run with its log.
#[derive(Clone, Debug, PartialEq)]
pub struct Run<const N: usize, const K: usize> {
    pub entries: Vec<Entry<K>>,
    pub ending: Ending<K>,
    /// The last state.
    pub state: State<f64, N>,
    /// The work of friction, J: never positive.
    pub friction_work: f64,
    /// The work of the given forces, J.
    pub force_work: f64,
    /// T - T0 - work of friction - work of the given forces, J: what integration and events left of the balance.
    pub imbalance: f64,
    /// The largest change that an event's state needed to satisfy its constraints, m.
    pub settled: f64,
    pub work: Work,
}

/// How a run is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub method: Method,
    pub tolerance: Tolerance,
    pub end: f64,
    pub outputs: Vec<f64>,
    pub most_events: usize,
    /// After so long the run is stopped, and what there is is kept.
    pub allowed: Option<Duration>,
    /// So many evaluations of each stretch.
    pub evaluations: Option<u64>,
}

impl Plan {
    /// Dormand and Prince's 8(5,3) at a tolerance close to rounding.
    pub fn until(end: f64) -> Self {
        Plan {
            method: Method::DormandPrince8,
            tolerance: Tolerance::both(1e-14),
            end,
            outputs: Vec::new(),
            most_events: 1000,
            allowed: None,
            evaluations: None,
        }
    }

    /// With the state shown at the start and at so many instants more, evenly.
    pub fn with_samples(mut self, samples: usize) -> Self {
        self.outputs = (0..=samples).map(|k| self.end * k as f64 / samples as f64).collect();
        self
    }
}

/// Runs a system from a state across its events. The observer sees (x, x', work of friction, work of the forces).
pub fn run<Q, const N: usize, const C: usize, const K: usize>(
    system: &Q,
    start: &State<f64, N>,
    plan: &Plan,
    observer: &mut dyn Observer<f64>,
) -> Run<N, K>
where
    Q: Contacts<N, C, K, Given = f64>,
{
    let mut course = Course {
        system,
        plan,
        deadline: plan.allowed.map(|allowed| Instant::now() + allowed),
        at: *start,
        works: [0.0; 2],
        energy: kinetic_energy(system.masses(), start.velocity),
        speed: 0.0,
        load: 0.0,
        run: Run {
            entries: Vec::new(),
            ending: Ending::Undefined,
            state: *start,
            friction_work: 0.0,
            force_work: 0.0,
            imbalance: 0.0,
            settled: 0.0,
            work: Work::default(),
        },
    };
    course.run.ending = course.follow(observer);
    let energy = kinetic_energy(system.masses(), course.at.velocity);
    [course.run.friction_work, course.run.force_work] = course.works;
    course.run.imbalance = energy - course.energy - course.works[0] - course.works[1];
    let all = course.energy + course.works[0].abs() + course.works[1].abs();
    let open = course.run.imbalance.abs();
    if course.run.ending == Ending::Reached && (!open.is_finite() || all > 0.0 && open > all) {
        course.run.ending = Ending::Unbalanced;
    }
    course.run.state = course.at;
    course.run
}

/// An event located by a tie is at most so far off, in units of the run.
const SHARP: f64 = 1e-6;

/// A run in the making.
struct Course<'a, Q, const N: usize, const C: usize, const K: usize> {
    system: &'a Q,
    plan: &'a Plan,
    deadline: Option<Instant>,
    at: State<f64, N>,
    works: [f64; 2],
    energy: f64,
    speed: f64,
    load: f64,
    run: Run<N, K>,
}

impl<Q: Contacts<N, C, K, Given = f64>, const N: usize, const C: usize, const K: usize> Course<'_, Q, N, C, K> {
    /// To the end of the run.
    fn follow(&mut self, observer: &mut dyn Observer<f64>) -> Ending<K> {
        self.measure();
        let rough = self.system.contacts(self.at.time, self.at.place).map(|contact| contact.friction != 0.0);
        let mut touch = match touches(self.system, &self.at, Sizes::of(&self.at)) {
            Ok(touch) => touch,
            Err(unfit) => return Ending::Unfit(unfit),
        };
        let mut cause = Cause::Start;
        for _ in 0..=self.plan.most_events {
            let system = self.system;
            let (speed, load) = (self.speed, self.load);
            let stretch_of = |regime| Stretch { system, regime, rough, rests: false, orientation: 1.0, speed, load };
            let last = self.run.entries.last().map(|entry| entry.regime);
            let ceased =
                last.filter(|_| matches!(cause, Cause::Signal { watched: Watched::Uniqueness | Watched::Rest, .. }));
            let found = match choose(system, &self.at, &touch, ceased, stretch_of) {
                Ok(found) => found,
                Err(Ending::Tie) if ceased.is_some() => return Ending::Critical,
                // where the determinant goes to zero, which condition of the regime fails first is rounding
                Err(Ending::NoMotion) if self.is_critical(last) => return Ending::Critical,
                Err(problem) => return problem,
            };
            if ceased.is_some() && self.at.velocity == [0.0; N] {
                let since = departure(&stretch_of(found.regime), &self.at, &touch).map(|it| it.value / it.slope);
                self.at.time -= since.filter(|since| since.abs() < SHARP * self.plan.end.abs()).unwrap_or(0.0);
            }
            self.run.entries.push(Entry {
                time: self.at.time,
                place: self.at.place.to_vec(),
                velocity: self.at.velocity.to_vec(),
                cause,
                regime: found.regime,
                determined: found.determined,
                reactions: found.reactions,
                works: self.works,
            });
            let still = self.at.velocity.iter().all(|v| *v == 0.0);
            if !found.determined && !still {
                return Ending::Undetermined;
            }
            if self.at.time >= self.plan.end {
                return Ending::Reached;
            }
            let Some(determinant) = determinant(system, &self.at, &found.regime) else { return Ending::Undefined };
            let stretch =
                Stretch { orientation: determinant.signum(), rests: !found.determined, ..stretch_of(found.regime) };
            let event = match self.integrate(&stretch, observer) {
                Ok(Some(event)) => event,
                Ok(None) => return Ending::Reached,
                Err(ending) => return ending,
            };
            let Some(watched) = stretch.watched().nth(event.signal) else { return Ending::Undefined };
            let rate = self.rate_of(&stretch, event.signal);
            if !rate.is_finite() {
                return Ending::Undefined;
            }
            cause = Cause::Signal { watched, what: event.what, rate };
            match self.after(&stretch, watched) {
                Ok(next) => touch = next,
                Err(ending) => return ending,
            }
        }
        Ending::TooManyEvents
    }

    /// Takes the sizes by which rounding is measured.
    fn measure(&mut self) {
        let sizes = Sizes::of(&self.at);
        self.speed = self.speed.max(sizes.speed);
        let force: [f64; N] = self.system.force(&self.at);
        self.load = self.load.max(force.iter().map(|x| x.abs()).sum());
    }

    /// One stretch, to its event or to the end.
    fn integrate(
        &mut self,
        stretch: &Stretch<'_, Q, N, C, K>,
        observer: &mut dyn Observer<f64>,
    ) -> Result<Option<Event>, Ending<K>> {
        let mut y = [&self.at.place[..], &self.at.velocity[..], &self.works[..]].concat();
        let later = |time: &&f64| **time > self.at.time || self.run.entries.len() == 1 && **time == self.at.time;
        let outputs: Vec<f64> = self.plan.outputs.iter().filter(later).copied().collect();
        let mut span = Span::new(self.at.time, self.plan.end, &y).with_outputs(&outputs);
        if let Some(deadline) = self.deadline {
            span = span.with_deadline(deadline);
        }
        if let Some(evaluations) = self.plan.evaluations {
            span = span.with_evaluations(evaluations);
        }
        let (method, tolerance) = (self.plan.method, &self.plan.tolerance);
        let (outcome, event) = integrate_to_event(stretch, method, tolerance, &span, stretch, observer);
        self.run.work = self.run.work + outcome.work;
        y.copy_from_slice(&outcome.state);
        self.at = parts(outcome.time, &y);
        self.works = [y[2 * N], y[2 * N + 1]];
        self.measure();
        match (outcome.end, event) {
            (End::Stopped(failure), _) => Err(self.diagnose(stretch, failure)),
            (End::Halted, None) => Err(Ending::BrokenOff),
            (_, event) => Ok(event),
        }
    }

    /// What a failure of the integration means: where the determinant goes to zero, that.
    fn diagnose(&self, stretch: &Stretch<'_, Q, N, C, K>, failure: integrators::Failure) -> Ending<K> {
        match failure {
            integrators::Failure::Interrupted { .. } => Ending::BrokenOff,
            _ if !failure.is_broken_off() && self.is_critical(Some(stretch.regime)) => Ending::Critical,
            _ => Ending::Failed(failure),
        }
    }

    /// Whether the determinant of the last regime has gone to zero since that began.
    fn is_critical(&self, regime: Option<[Mode; K]>) -> bool {
        let start = self.run.entries.last().map(|entry| State {
            time: entry.time,
            place: std::array::from_fn(|i| entry.place[i]),
            velocity: std::array::from_fn(|i| entry.velocity[i]),
        });
        let determinant_at = |at: &State<f64, N>| determinant(self.system, at, &regime?);
        match (start.and_then(|at| determinant_at(&at)), determinant_at(&self.at)) {
            (Some(before), Some(now)) => now.abs() < 1e-6 * before.abs(),
            _ => false,
        }
    }

    fn rate_of(&self, stretch: &Stretch<'_, Q, N, C, K>, signal: usize) -> f64 {
        let y = [&self.at.place[..], &self.at.velocity[..], &self.works[..]].concat();
        let mut signals = vec![Signal::default(); stretch.count()];
        stretch.signals(self.at.time, &y, &mut signals);
        signals[signal].rate
    }

    /// The state of an event made exact, and what the contacts are from there.
    fn after(&mut self, stretch: &Stretch<'_, Q, N, C, K>, watched: Watched) -> Result<[Touch; K], Ending<K>> {
        let mut closed = stretch.regime.map(|mode| mode != Mode::Apart);
        let mut at_rest = stretch.regime.map(|mode| matches!(mode, Mode::Stick(_)));
        match watched {
            Watched::Sliding(k) => at_rest[k] = true,
            Watched::Determinant => return Err(Ending::Critical),
            Watched::Gap(k) => {
                let velocity = motion_of_contacts(self.system, &self.at)[k][0].slope;
                if velocity.abs() > 1e-9 * self.speed {
                    return Err(Ending::TouchDown { contact: k, speed: -velocity });
                }
                closed[k] = true;
            }
            Watched::Condition(..) | Watched::Uniqueness | Watched::Rest => {}
        }
        let held = std::array::from_fn(|k| Held { closed: closed[k], at_rest: at_rest[k] });
        let (settled, moved) = settle(self.system, &self.at, held);
        self.run.settled = self.run.settled.max(moved);
        self.at = settled;
        let sizes = self.at.velocity.map(|v| v.sign_among(self.speed));
        if sizes.iter().all(|size| *size == Ordering::Equal) {
            self.at.velocity = [0.0; N];
        }
        Ok(touches_after(self.system, &self.at, closed, at_rest, self.speed))
    }
}
