//! The end of the validity of a law: the event at which the first of its margins falls to zero.
//!
//! A margin is positive where the law is valid. Its zero is located from bounds of the margin over each step,
//! independent of the steps of the method, and the run ends there.

use super::poles::{PoleWatch, up_to};
use integrators::{
    Event, Method, Observer, Ode, Outcome, Pace, Signal, Span, Switches, System, Tolerance, integrate,
    integrate_to_event,
};
use std::cell::RefCell;

/// A function of the state that is positive where the law is valid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margin {
    /// Positive where the law holds.
    pub value: f64,
    /// The derivative of the margin along the motion, 1/s.
    pub rate: f64,
    /// Bounds for a margin that is the square of a distance, see [`Signal::pace`].
    pub pace: Pace,
    /// The reason why the law is invalid beyond the zero.
    pub what: &'static str,
    /// Whether the motion may continue beyond the zero on a smooth branch, although the law does not determine it
    /// there.
    pub goes_on: bool,
}

/// The margins of a state y with the rates dy at a time (s); their number is constant.
pub type Margins = dyn Fn(f64, &[f64], &[f64]) -> Vec<Margin> + Send + Sync;

/// A law with its margins.
#[derive(Clone, Copy)]
pub struct Ending<'a> {
    pub law: &'a dyn System,
    pub margins: &'a Margins,
}

impl Ending<'_> {
    /// Integrates over a span, or to the end of the validity of the law: the outcome is then the last valid state, with
    /// the reason. The reason is `None` if the law stays valid.
    pub fn integrate(
        &self,
        (method, tolerance): (Method, &Tolerance),
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> (Outcome<f64>, Option<&'static str>) {
        let mut watch = PoleWatch::new((self.law, tolerance), (span.start, &span.state), observer);
        let (outcome, left) = self.up_to_a_pole((method, tolerance), span, &mut watch);
        match watch.end(&outcome) {
            Some((time, state, why)) => (up_to(outcome, (time, state)), Some(why)),
            None => (outcome, left),
        }
    }

    fn up_to_a_pole(
        &self,
        (method, tolerance): (Method, &Tolerance),
        span: &Span<'_, f64>,
        observer: &mut dyn Observer<f64>,
    ) -> (Outcome<f64>, Option<&'static str>) {
        let Some(ends) = Ends::of(*self, span.start, &span.state, 0) else {
            return (integrate(self.law, method, tolerance, span, observer), None);
        };
        let mut good = Good { observer, time: span.start, state: span.state.clone() };
        let (mut outcome, event) = integrate_to_event(self.law, method, tolerance, span, &ends, &mut good);
        let Some(Event { signal, .. }) = event else { return (outcome, None) };
        let margins = ends.at(outcome.time, &outcome.state);
        if outside(&margins).is_some() {
            // the motion could not be integrated up to there
            (outcome.time, outcome.state) = (good.time, good.state);
        }
        (outcome, margins.get(signal).map(|margin| margin.what))
    }
}

/// The reason of the first margin that is not positive or is NaN; `None` if all margins are positive.
pub fn outside(margins: &[Margin]) -> Option<&'static str> {
    margins.iter().find(|margin| margin.value.is_nan() || margin.value <= 0.0).map(|margin| margin.what)
}

/// The margins for a state that is followed by further components; `own` is the length of the state.
pub fn of_leading(margins: Box<Margins>, own: usize) -> Box<Margins> {
    Box::new(move |time, y: &[f64], dy: &[f64]| margins(time, &y[..own], &dy[..own]))
}

/// The margins as signals, for a state that may be followed by further components.
pub(super) struct Ends<'a> {
    of: Ending<'a>,
    count: usize,
    /// The number of components of the state itself.
    own: usize,
    rates: RefCell<Vec<f64>>,
}

impl<'a> Ends<'a> {
    /// The margins as signals; `None` where the law has none. The state is followed by `behind` further components.
    pub fn of(of: Ending<'a>, time: f64, state: &[f64], behind: usize) -> Option<Self> {
        let own = state.len();
        let count = (of.margins)(time, state, &vec![0.0; own]).len();
        (count > 0).then(|| Ends { of, count, own, rates: RefCell::new(vec![0.0; own + behind]) })
    }

    /// The margins at a state, without their rates.
    pub fn at(&self, time: f64, state: &[f64]) -> Vec<Margin> {
        (self.of.margins)(time, &state[..self.own], &vec![0.0; self.own])
    }
}

impl Switches for Ends<'_> {
    fn count(&self) -> usize {
        self.count
    }

    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]) {
        let mut rates = self.rates.borrow_mut();
        Ode::<f64>::rates(self.of.law, time, state, &mut rates);
        for (signal, margin) in out.iter_mut().zip((self.of.margins)(time, &state[..self.own], &rates[..self.own])) {
            // beyond its end a law may be singular, with NaN rates
            let [value, rate] =
                [margin.value, margin.rate].map(|number| if number.is_finite() { number } else { -1.0 });
            *signal = Signal { value, rate, noise: 0.0, pace: margin.pace };
        }
    }

    fn ends_above(&self, _signal: usize) -> bool {
        true
    }
}

/// The switches of a law that changes at events, followed by its margins.
pub(super) struct SwitchesAndEnds<'a> {
    pub switches: &'a dyn Switches,
    pub ends: Option<Ends<'a>>,
}

impl SwitchesAndEnds<'_> {
    /// The margin at which the law ends; `None` if the event is the zero of a switch.
    pub fn end(&self, event: &Event, state: &[f64]) -> Option<Margin> {
        let margin = event.signal.checked_sub(self.switches.count())?;
        self.ends.as_ref()?.at(event.time, state).get(margin).copied()
    }

    /// The margin of a singular position that is not positive at a state, with its rate (1/s); `None` if there is none.
    pub fn beside(&self, time: f64, state: &[f64]) -> Option<(Margin, f64)> {
        let ends = self.ends.as_ref()?;
        let place = ends.at(time, state).iter().position(|margin| margin.goes_on && margin.value <= 0.0)?;
        let mut signals = vec![Signal::default(); ends.count()];
        ends.signals(time, state, &mut signals);
        Some((ends.at(time, state)[place], signals[place].rate))
    }

    /// Whether all margins are positive at a state.
    pub fn margins_hold(&self, time: f64, state: &[f64]) -> bool {
        self.ends.as_ref().is_none_or(|ends| outside(&ends.at(time, state)).is_none())
    }

    /// Whether all margins are positive at a state, and no switch that was positive at an event has fallen since. Each pair
    /// is a time (s) and the state then.
    pub fn hold(&self, event: (f64, &[f64]), (time, state): (f64, &[f64])) -> bool {
        let signals = |time: f64, state: &[f64]| {
            let mut signals = vec![Signal::default(); self.count()];
            self.signals(time, state, &mut signals);
            signals
        };
        let mut ends = signals(event.0, event.1).into_iter().zip(signals(time, state)).enumerate();
        let is_switch = |number: usize| number < self.switches.count();
        ends.all(|(number, (there, here))| here.value > 0.0 || is_switch(number) && there.value <= there.noise)
    }
}

impl Switches for SwitchesAndEnds<'_> {
    fn count(&self) -> usize {
        self.switches.count() + self.ends.as_ref().map_or(0, Ends::count)
    }

    fn signals(&self, time: f64, state: &[f64], out: &mut [Signal]) {
        let (own, margins) = out.split_at_mut(self.switches.count());
        self.switches.signals(time, state, own);
        if let Some(ends) = &self.ends {
            ends.signals(time, state, margins);
        }
    }

    fn ends_above(&self, signal: usize) -> bool {
        signal >= self.switches.count() || self.switches.ends_above(signal)
    }

    fn is_timed(&self, signal: usize) -> bool {
        signal < self.switches.count() && self.switches.is_timed(signal)
    }
}

/// Stores the last reported state.
struct Good<'a> {
    observer: &'a mut dyn Observer<f64>,
    time: f64,
    state: Vec<f64>,
}

impl Observer<f64> for Good<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.observer.sample(time, state);
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.state.copy_from_slice(state);
        self.observer.step(time, state);
    }

    fn progress(&mut self, fraction: f64) {
        self.observer.progress(fraction);
    }

    fn enough(&self) -> bool {
        self.observer.enough()
    }
}
