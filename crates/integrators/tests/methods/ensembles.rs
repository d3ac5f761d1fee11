//! Members in lanes, without knowledge of a system: what stops one of them, and nobody else.

use field::Lanes;
use integrators::{Ensemble, Failure, LaneSeries, Members, taylor_order};

const TOLERANCE: f64 = 1e-12;

/// y' = p y: c_k = y p^k / k!.
struct Growing {
    rates: [f64; 2],
    coefficients: Vec<[Lanes<2>; 1]>,
}

impl LaneSeries<2> for Growing {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.rates[lane] = parameters[0];
    }

    fn expand(&mut self, _: Lanes<2>, states: &[Lanes<2>]) {
        let mut term = states[0];
        for (k, coefficients) in self.coefficients.iter_mut().enumerate() {
            *coefficients = [term];
            for (term, rate) in term.0.iter_mut().zip(self.rates) {
                *term *= rate / (k + 1) as f64;
            }
        }
    }

    fn coefficients(&self, k: usize) -> &[Lanes<2>] {
        &self.coefficients[k]
    }

    fn sum(&self, h: Lanes<2>, out: &mut [Lanes<2>]) {
        out[0] = Lanes::all(0.0);
        for [coefficient] in self.coefficients.iter().rev() {
            for lane in 0..2 {
                out[0].0[lane] = out[0].0[lane] * h.0[lane] + coefficient.0[lane];
            }
        }
    }
}

/// (p, y) of each, and how each ended.
struct Crowd {
    waiting: Vec<(f64, f64)>,
    ended: Vec<(u64, u64, f64, Option<Failure>)>,
}

impl Members for Crowd {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        (parameters[0], state[0]) = self.waiting.pop()?;
        Some(self.waiting.len() as u64)
    }

    fn ended(&mut self, number: u64, state: &[f64], steps: u64, _: f64, failure: Option<Failure>) {
        self.ended.push((number, steps, state[0], failure));
    }
}

#[test]
fn a_member_that_takes_too_many_steps_or_leaves_the_numbers_stops_by_name() {
    let order = taylor_order(TOLERANCE);
    let series = Growing { rates: [0.0; 2], coefficients: vec![[Lanes::all(0.0)]; order + 1] };
    let mut crowd = Crowd { waiting: vec![(1.0, 1e308), (100.0, 1e-3), (-0.5, 2.0)], ended: Vec::new() };
    Ensemble::new(series, TOLERANCE, 1.0, 1, 1).with_most_steps(5).run(&mut crowd);
    crowd.ended.sort_by_key(|(number, ..)| *number);
    let [lost, slow, sound] = crowd.ended.as_slice() else { panic!("three members: {:?}", crowd.ended) };
    assert_eq!((lost.2, lost.3), (1e308, Some(Failure::LeftTheNumbers { at: 0.0 })));
    assert!(slow.1 == 5 && matches!(slow.3, Some(Failure::TooManyEvaluations { .. })), "{slow:?}");
    assert!(sound.3.is_none() && (sound.2 - 2.0 * (-0.5_f64).exp()).abs() < 1e-12, "{sound:?}");
}
