//! Values of expressions of a model at pseudo-random states. The sequence of states is fixed.

use crate::letters::Letters;
use crate::readiness::start_of;
use model::Trace;
use simulation::ensemble::draw::Draw;
use std::cell::RefCell;
use symbolic::{Sym, Tape, substitute_all};

/// Compiled expressions of time and state, in which each condition selects its case by its sign.
pub(super) struct Expressions {
    tape: Tape,
    conditions: usize,
    values: RefCell<Vec<f64>>,
}

impl Expressions {
    /// Compiles expressions; `None` if one has no value.
    pub fn of(trace: &Trace<'_>, expressions: &[Sym]) -> Option<Self> {
        let model = trace.model;
        let named =
            |letter: &str, count: usize| (0..count).map(|i| Sym::symbol(&format!("{letter}{i}"))).collect::<Vec<_>>();
        let (state, time) = (named("y", model.positions() + model.speeds()), Sym::symbol("t"));
        let cases = named("s", model.switches.len());
        let conditions: Vec<Sym> = model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
        let all = Letters::with_data(time, &state).put_into(trace, &[&conditions[..], expressions].concat());
        let known: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(cases.iter().copied()).collect();
        let all = substitute_all(&all, &known);
        let tape = Tape::record(&[&state[..], &[time], &cases].concat(), &all).ok()?;
        Some(Expressions { tape, conditions: cases.len(), values: RefCell::new(vec![0.0; all.len()]) })
    }

    /// The values at a time and a state. Conditions may depend on earlier conditions, hence the repeated evaluation; a condition at zero
    /// gives the middle of its cases.
    pub fn at(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = self.values.borrow_mut();
        let mut numbers = [state, &[time], &vec![0.5; self.conditions]].concat();
        for _ in 0..=self.conditions {
            self.tape.over::<f64>().evaluate(&numbers, &mut values);
            for (case, condition) in numbers[state.len() + 1..].iter_mut().zip(values.iter()) {
                *case = if *condition == 0.0 { 0.5 } else { f64::from(u8::from(*condition > 0.0)) };
            }
        }
        values[self.conditions..].to_vec()
    }
}

/// A generator of pseudo-random states around the start of a model.
pub(super) struct States {
    start: Vec<f64>,
    positions: usize,
    /// Indices of reactions and of their impulses; they keep the values of the start, since the state does not determine them.
    resting: Vec<usize>,
    drawn: Draw,
    count: usize,
}

impl States {
    /// The generator for a model, around its completed start.
    pub fn about_start(trace: &Trace<'_>) -> Self {
        let model = trace.model;
        let start = start_of(model).unwrap_or_else(|_| model.start_state());
        let positions = model.positions();
        let resting = model.impulses.iter().flat_map(|&impulse| [impulse, positions + impulse]).collect();
        States { start, positions, resting, drawn: Draw::new(1, 1, "states"), count: 0 }
    }

    /// The next number, uniform in (-1, 1).
    fn number(&mut self) -> f64 {
        self.count += 1;
        2.0 * self.drawn.even(self.count) - 1.0
    }

    /// The next time and state. Time is uniform in (0, 1) s. Positions deviate from the start by up to `part` (1 + |value|); speeds have
    /// a common random scale between 1e-3 and 1e3 (SI).
    pub fn next(&mut self, part: f64) -> (f64, Vec<f64>) {
        let size = 10_f64.powf(3.0 * self.number());
        let mut state = self.start.clone();
        for (place, value) in state.iter_mut().enumerate() {
            let number = self.number();
            *value = if place < self.positions { *value + part * (1.0 + value.abs()) * number } else { size * number };
        }
        self.resting.iter().for_each(|&place| state[place] = self.start[place]);
        (self.number().abs(), state)
    }
}
