//! The signals of a mode, which are positive while its law is valid, and those of the events of the model.

use super::Current;
use super::contacts::{PARTS, friction, number, slides};
use super::glides::FASTER;
use super::mode::{Case, Mode, Phase};
use super::motion::ModeMotion;
use super::multiples::mirrored;
use crate::compiled_system::{NotCompiled, values};
use crate::program::recorded;
use field::{Analytic, Over, Scalar};
use integrators::{Signal, Switches};
use model::equations::vanishes;
use model::{Assignment, Model, Trace};
use simulation::events::Cause;
use simulation::{Program, Running};
use symbolic::{Sym, apart, substitute_all};

/// The meaning of a signal that becomes negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fall {
    /// A condition changes to its other case.
    Passes {
        switch: usize,
    },
    /// The switch of a held condition reaches a bound: the condition gets the case `to`.
    Leaves {
        switch: usize,
        to: Case,
    },
    /// A switch at its bound would return into the interval between 0 and 1.
    Frees {
        switch: usize,
    },
    /// A contact closes.
    Closes {
        contact: usize,
    },
    /// The face of a contact stops pressing.
    Lifts {
        contact: usize,
    },
    /// Friction no longer holds a contact: its margin with the index `margin`, 1 or 2, becomes negative.
    Slides {
        contact: usize,
        margin: usize,
    },
    /// The coefficient of friction of a closed contact becomes negative.
    Smooths {
        contact: usize,
    },
    /// The equations for the reactions of contacts that slide become singular.
    Jams,
    /// A contact that slides comes to rest.
    Stops {
        contact: usize,
    },
    /// A contact that slides in space has slowed down, become much faster, or turned by a right angle, since the start of its observation.
    Slows {
        contact: usize,
    },
    Hastens {
        contact: usize,
    },
    Turns {
        contact: usize,
    },
    /// The expression of an event of the model crosses zero; the run may be on either side.
    Event {
        event: usize,
    },
}

impl Fall {
    /// True for a signal of the observation of a contact that slides in space.
    pub fn is_of_a_glide(self) -> bool {
        matches!(self, Fall::Slows { .. } | Fall::Hastens { .. } | Fall::Turns { .. })
    }

    /// The kind of event that the signal announces.
    pub fn cause(self) -> Cause {
        match self {
            Fall::Passes { .. } | Fall::Leaves { .. } | Fall::Frees { .. } => Cause::Condition,
            Fall::Event { .. } => Cause::Own,
            _ => Cause::Contact,
        }
    }
}

/// The compiled signals with their rates, and the states that events set.
#[derive(Debug)]
pub(crate) struct Signals {
    /// The meaning of each signal.
    pub(super) falls: Vec<Fall>,
    program: Program,
    events: usize,
    /// Indices of the contacts that may slide in space.
    pub(super) in_space: Vec<usize>,
}

impl Signals {
    /// Compiles the signals of a mode.
    ///
    /// # Errors
    /// The mode has no motion, or a signal has no value.
    pub fn of(model: &Model, mode: &Mode) -> Result<Self, NotCompiled> {
        let (mut falls, mut wrong) = (Vec::new(), None);
        let states = model.positions() + model.speeds();
        let in_space = in_space(model);
        let program = recorded(states + GLIDE * in_space.len(), |time, all| {
            let (state, glides) = all.split_at(states);
            let (found, all) = written(model, mode, time, (state, glides)).unwrap_or_else(|reason| {
                wrong = Some(reason);
                (Vec::new(), Vec::new())
            });
            falls = found;
            all
        });
        match wrong {
            Some(reason) => Err(reason),
            None => Ok(Signals { program: program?, falls, events: model.events.len(), in_space }),
        }
    }

    /// The values of all expressions: signals with their rates, then the states that events set. `glides` are the constants of contacts
    /// that slide in space.
    fn all<S: Running + Over<f64>>(&self, time: S, state: &[S], glides: &[f64]) -> Vec<S> {
        let mut values = vec![S::lift(f64::NAN); 2 * self.falls.len() + self.events * state.len()];
        if glides.is_empty() {
            self.program.run(time, state, &mut values);
        } else {
            let inputs: Vec<S> = state.iter().copied().chain(glides.iter().map(|part| S::lift(*part))).collect();
            self.program.run(time, &inputs, &mut values);
        }
        values
    }

    /// The value and the rate of the signal with this index.
    pub(super) fn of_one<S: Running + Over<f64>>(&self, signal: usize, time: S, state: &[S], glides: &[f64]) -> [S; 2] {
        let all = self.all(time, state, glides);
        [all[2 * signal], all[2 * signal + 1]]
    }

    /// The rate of the expression of the event with this index.
    pub(super) fn event_rate(&self, event: usize, time: f64, state: &[f64], glides: &[f64]) -> f64 {
        self.of_one(self.falls.len() - self.events + event, time, state, glides)[1]
    }

    /// The state that the event with this index sets.
    pub(super) fn set_by<S: Running + Over<f64>>(&self, event: usize, time: S, state: &[S], glides: &[f64]) -> Vec<S> {
        let first = 2 * self.falls.len() + event * state.len();
        self.all(time, state, glides)[first..][..state.len()].to_vec()
    }
}

/// The number of constants for the observation of a contact that slides in space.
pub(super) const GLIDE: usize = 3;

/// Indices of the contacts that may slide in space.
fn in_space(model: &Model) -> Vec<usize> {
    (0..model.contacts.len()).filter(|&contact| model.contacts[contact].is_in_space()).collect()
}

/// The signals of a mode and, as expressions, all results of [`Signals::all`].
pub(super) fn written(
    model: &Model,
    mode: &Mode,
    time: Sym,
    (state, glides): (&[Sym], &[Sym]),
) -> Result<(Vec<Fall>, Vec<Sym>), NotCompiled> {
    if mode.is_only_one() && model.events.is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let trace = Trace::of(model);
    let mirrored = mirrored(&trace);
    let ModeMotion { accelerations, switches, parts, reactions, determinant, speeds, .. } =
        ModeMotion::of(&trace, mode)?;
    let cases: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(switches.iter().copied()).collect();
    let motion: Vec<(Sym, Sym)> = trace.accelerations.iter().copied().zip(accelerations).collect();
    let with_rate = |value: Sym| -> [Sym; 2] {
        let value = value.substitute(&cases).substitute(&speeds);
        [value, trace.rate_of(value).substitute(&motion).substitute(&speeds)]
    };
    let at_rest = mode.cases.iter().filter(|case| case.rests()).count();
    let may_depend = at_rest + mode.phases.iter().filter(|phase| **phase != Phase::Apart).count() > 1;
    let rests = |rate: Sym| rate == Sym::ZERO || may_depend && vanishes(rate);
    let (mut falls, mut all): (Vec<Fall>, Vec<Sym>) = (Vec::new(), Vec::new());
    for (switch, case) in mode.cases.iter().enumerate().filter(|(switch, _)| mirrored[*switch].is_none()) {
        let condition = trace.scalar(model.switches[switch]);
        let watched = match case {
            Case::On => vec![(Fall::Passes { switch }, condition)],
            Case::Off => vec![(Fall::Passes { switch }, -condition)],
            Case::Spent { on: true } => vec![(Fall::Frees { switch }, parts[switch] - Sym::ONE)],
            Case::Spent { on: false } => vec![(Fall::Frees { switch }, -parts[switch])],
            Case::Held | Case::Shared => vec![
                (Fall::Leaves { switch, to: Case::Off }, switches[switch]),
                (Fall::Leaves { switch, to: Case::On }, Sym::ONE - switches[switch]),
            ],
        };
        for (fall, signal) in watched {
            let [value, rate] = with_rate(signal);
            // a constant signal never becomes negative, such as a condition that depends on held ones
            if !rests(rate) {
                falls.push(fall);
                all.extend([value, rate]);
            }
        }
    }
    let in_space = in_space(model);
    for (contact, (phase, reactions)) in mode.phases.iter().zip(reactions).enumerate() {
        let place = in_space.iter().position(|own| *own == contact);
        let glide = place.and_then(|place| glides.get(GLIDE * place..GLIDE * (place + 1))).unwrap_or_default();
        for (fall, signal) in of_contact(&trace, contact, *phase, (reactions, glide)) {
            let [value, rate] = with_rate(signal);
            if !rests(rate) {
                falls.push(fall);
                all.extend([value, rate]);
            }
        }
    }
    // without friction the matrix of the equations is definite
    if mode.phases.iter().any(|phase| phase.has_friction()) {
        let [value, rate] = with_rate(determinant);
        if !rests(rate) {
            falls.push(Fall::Jams);
            all.extend([value, rate]);
        }
    }
    for (event, expression) in model.events.iter().enumerate() {
        falls.push(Fall::Event { event });
        all.extend(with_rate(trace.scalar(expression.when)));
    }
    let kept: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
    for event in &model.events {
        let mut after = kept.clone();
        for assignment in &event.set {
            let place = assignment.order * trace.coordinates.len() + assignment.coordinate;
            after[place] = trace.scalar(assignment.is).substitute(&cases).substitute(&speeds);
        }
        all.extend(after);
    }
    Ok((falls, substitute_all(&all, &values(&trace, time, state))))
}

/// The assignments of all events: the index in the state, and the expression as text.
pub(super) fn sets(model: &Model) -> Vec<(usize, String)> {
    apart(|| {
        let trace = Trace::of(model);
        let place = |set: &Assignment| set.order * trace.coordinates.len() + set.coordinate;
        let all = model.events.iter().flat_map(|event| &event.set);
        all.map(|set| (place(set), trace.scalar(set.is).to_string())).collect()
    })
}

/// The signals of a contact in a phase, with their meanings.
fn of_contact(
    trace: &Trace<'_>,
    contact: usize,
    phase: Phase,
    ([normal, tangent, aside], glide): ([Sym; PARTS], &[Sym]),
) -> Vec<(Fall, Sym)> {
    let scalar = &trace.model.contacts[contact];
    let mut watched = Vec::new();
    match phase {
        Phase::Apart => watched.push((Fall::Closes { contact }, trace.scalar(scalar.gap))),
        Phase::Carried => {}
        Phase::Sticks(face) | Phase::Leans { face, .. } => {
            let pressure = number(face.sign()) * normal;
            let most = friction(trace, contact) * pressure;
            watched.push((Fall::Lifts { contact }, pressure));
            if scalar.is_in_space() {
                let beyond = most * most - tangent * tangent - aside * aside;
                watched.push((Fall::Slides { contact, margin: 1 }, beyond));
            } else {
                watched.push((Fall::Slides { contact, margin: 1 }, most - tangent));
                watched.push((Fall::Slides { contact, margin: 2 }, most + tangent));
            }
        }
        Phase::Glides { face, .. } => {
            watched.push((Fall::Lifts { contact }, number(face.sign()) * normal));
            if let (&[cos, sin, slow], [along, aside]) = (glide, slides(trace, scalar)) {
                let speed = (along * along + aside * aside).sqrt();
                watched.push((Fall::Slows { contact }, speed - slow));
                watched.push((Fall::Hastens { contact }, Sym::int(FASTER) * slow - speed));
                watched.push((Fall::Turns { contact }, cos * along + sin * aside));
            }
        }
        Phase::Rests { face, .. } => watched.push((Fall::Lifts { contact }, number(face.sign()) * normal)),
        Phase::Slips { face, forwards } => {
            watched.push((Fall::Lifts { contact }, number(face.sign()) * normal));
            if scalar.friction.is_some() {
                let way = number(if forwards { 1.0 } else { -1.0 });
                watched.push((Fall::Stops { contact }, way * slides(trace, scalar)[0]));
            }
        }
    }
    if phase.face().is_some() && scalar.friction.is_some() {
        watched.push((Fall::Smooths { contact }, friction(trace, contact)));
    }
    watched
}

impl Current {
    /// True if a signal that began at zero, and has risen beyond its error bound, counts as crossing at zero instead of at minus the
    /// bound. Error bounds are wide if reactions are integrated by their rates.
    pub(super) fn passes_at_zero(&self, fall: Fall) -> bool {
        matches!(fall, Fall::Passes { .. }) && self.moded.system.has_implicit_speeds()
    }
}

impl Switches for Current {
    fn count(&self) -> usize {
        self.moded.signals.falls.len()
    }

    fn is_timed(&self, signal: usize) -> bool {
        matches!(self.moded.signals.falls[signal], Fall::Event { .. })
    }

    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]) {
        let signals = &self.moded.signals;
        let state = &state[..state.len() - self.moded.followed];
        let all = signals.all(time, state, &self.glide_letters());
        for ((signal, fall), &[value, rate]) in out.iter_mut().zip(&signals.falls).zip(all.as_chunks::<2>().0) {
            let (side, near) = match *fall {
                Fall::Passes { switch } => (1.0, self.near[switch]),
                Fall::Leaves { switch, to } => (1.0, self.near_bounds[switch][usize::from(to == Case::On)]),
                Fall::Frees { switch } => {
                    let is_on = self.moded.system.mode.cases[switch].fixed() == Some(true);
                    (1.0, self.near_bounds[switch][usize::from(is_on)])
                }
                Fall::Closes { contact } | Fall::Lifts { contact } => (1.0, self.near_contacts[contact][0]),
                Fall::Slides { contact, margin } => (1.0, self.near_contacts[contact][margin]),
                Fall::Stops { contact } => (1.0, self.near_contacts[contact][1]),
                Fall::Slows { .. } | Fall::Hastens { .. } | Fall::Turns { .. } | Fall::Smooths { .. } => (1.0, 0.0),
                Fall::Jams => (self.determinant.signum(), 0.0),
                Fall::Event { event } => (self.sides[event].sign, self.near_events[event]),
            };
            // a signal that must rise beyond its bound has risen at twice the noise
            let [shift, noise] = if self.passes_at_zero(*fall) { [0.0, 0.5 * near] } else { [near, 0.0] };
            *signal = Signal { value: side * value + shift, rate: side * rate, noise, ..Signal::default() };
        }
    }
}
