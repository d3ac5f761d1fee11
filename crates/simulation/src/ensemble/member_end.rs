//! The end of the validity of a member's law within a step, from its margins.
//!
//! The motion within a step is a polynomial. Intervals are halved while the bound of the rate of a distance allows a
//! zero within.

use crate::Margin;
use crate::events::{Margins, outside};
use integrators::{BatchStep, Pace};

/// If the change of a distance over an interval is at most this, the interval is not halved.
const LITTLE: f64 = 2e-4;

/// The time difference for difference quotients, as a fraction of the step.
const APART: f64 = 1e-6;

/// A step, with the margins of the law.
pub(super) struct LaneEnd<'a> {
    margins: &'a Margins,
    step: &'a BatchStep<'a>,
    state: Vec<f64>,
    rates: Vec<f64>,
}

impl<'a> LaneEnd<'a> {
    pub fn new(margins: &'a Margins, step: &'a BatchStep<'a>, states: usize) -> Self {
        LaneEnd { margins, step, state: vec![0.0; states], rates: vec![0.0; states] }
    }

    /// The margins at a time within the step, except its beginning.
    pub fn look(&mut self, time: f64) -> Vec<Margin> {
        let apart = APART * (self.step.begin - self.step.end);
        (self.step.state_at)(time, &mut self.state);
        (self.step.state_at)(time + apart, &mut self.rates);
        self.rates.iter_mut().zip(&self.state).for_each(|(rate, part)| *rate = (*rate - part) / apart);
        (self.margins)(time, &self.state, &self.rates)
    }

    /// The last time at which the law is valid, and the reason; `None` if it is valid in the whole interval. Each end of the
    /// interval is given by its time (s) and the margins then.
    pub fn first(&mut self, [begin, end]: [(f64, &Vec<Margin>); 2]) -> Option<(f64, &'static str)> {
        let ends = begin.1.iter().zip(end.1);
        if ends.into_iter().any(|(before, after)| is_open(before, after, end.0 - begin.0)) {
            let time = begin.0 + 0.5 * (end.0 - begin.0);
            if time > begin.0 && time < end.0 {
                let middle = self.look(time);
                return self.first([begin, (time, &middle)]).or_else(|| self.first([(time, &middle), end]));
            }
        }
        outside(end.1).map(|what| (begin.0, what))
    }
}

/// Whether the bound of its rate allows a distance to vanish within an interval.
fn is_open(before: &Margin, after: &Margin, length: f64) -> bool {
    let distance = |margin: &Margin| margin.value.max(0.0).sqrt();
    Pace::change([before.pace, after.pace], length) > LITTLE.max(distance(before) + distance(after))
}
