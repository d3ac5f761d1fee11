//! Conditions that are multiples of others: for example the two friction forces of a pair, each written with its own condition, have one
//! switch.

use crate::compiled_system::values;
use field::DoubleDouble;
use model::Trace;
use symbolic::{Sym, Tape, substitute_all};

/// The original condition of which a mirrored condition is a multiple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mirrored {
    /// The index of the original condition.
    pub of: usize,
    /// True for a positive factor.
    pub same_side: bool,
}

/// The number of points at which conditions are compared in double-double arithmetic.
const POINTS: usize = 5;

/// Ratios with a smaller relative difference are equal.
const EQUAL: f64 = 1e-24;

/// For each condition, the first condition before it of which it is a multiple, if any.
pub(super) fn mirrored(trace: &Trace<'_>) -> Vec<Option<Mirrored>> {
    let conditions: Vec<Sym> = trace.model.switches.iter().map(|condition| trace.scalar(*condition)).collect();
    let alone = vec![None; conditions.len()];
    if conditions.len() < 2 {
        return alone;
    }
    let names = |letter: &str, count: usize| -> Vec<Sym> {
        (0..count).map(|place| Sym::symbol(&format!("{letter}{place}"))).collect()
    };
    let model = trace.model;
    let (state, time) = (names("y", model.positions() + model.speeds()), Sym::symbol("t"));
    let letters = names("s", conditions.len());
    let known: Vec<(Sym, Sym)> = values(trace, time, &state)
        .into_iter()
        .chain(trace.switches.iter().copied().zip(letters.iter().copied()))
        .collect();
    let written = substitute_all(&conditions, &known);
    let inputs = [&state[..], &[time], &letters].concat();
    let Ok(tape) = Tape::record(&inputs, &written) else { return alone };
    let constants = tape.constants::<DoubleDouble>();
    let points: Vec<Vec<DoubleDouble>> = (0..POINTS)
        .map(|point| {
            let mut found = vec![DoubleDouble::from(f64::NAN); conditions.len()];
            let place =
                |input: usize| ((input + 1) as f64 * 0.754_877_666 + (point + 1) as f64 * 0.569_840_291).fract();
            let inputs = (0..inputs.len()).map(|input| DoubleDouble::from(0.2 + place(input)));
            tape.evaluate_long(&constants, inputs, &mut found);
            found
        })
        .collect();
    let ratio = |own: usize, other: usize| -> Option<f64> {
        let ratios: Vec<DoubleDouble> = points.iter().map(|point| point[own] / point[other]).collect();
        let first = ratios[0];
        let agrees = |ratio: &DoubleDouble| (*ratio / first - DoubleDouble::from(1.0)).hi().abs() < EQUAL;
        (first.hi() != 0.0 && ratios.iter().all(agrees)).then(|| first.hi())
    };
    let of = |own: usize| {
        (0..own).find_map(|other| ratio(own, other).map(|ratio| Mirrored { of: other, same_side: ratio > 0.0 }))
    };
    (0..conditions.len()).map(of).collect()
}

/// The symbols of mirrored switches with their expressions.
pub(super) fn letters(trace: &Trace<'_>, mirrored: &[Option<Mirrored>]) -> Vec<(Sym, Sym)> {
    let replaced = |(own, mirrored): (usize, &Option<Mirrored>)| {
        let Mirrored { of, same_side } = (*mirrored)?;
        let (own, of) = (trace.switches[own], trace.switches[of]);
        (own != of).then_some((own, if same_side { of } else { Sym::ONE - of }))
    };
    mirrored.iter().enumerate().filter_map(replaced).collect()
}
