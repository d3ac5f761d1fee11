//! Points in double precision at which residuals are evaluated. They exclude edits and prove nothing.

use std::collections::HashMap;
use symbolic::{Hypotheses, Node, Sym};

/// The number of points for one formula.
pub(super) const POINTS: usize = 3;

/// The largest number of attempts to find points that satisfy the hypotheses.
const DRAWS: u64 = 40;

/// Points that satisfy hypotheses: for each point a seed, and the values that the hypotheses determine. The values of other letters follow from their
/// names and the seed.
pub(super) struct Samples(Vec<(u64, HashMap<String, f64>)>);

impl Samples {
    /// Points for these hypotheses; `None` if too few were found.
    pub fn of(hypotheses: &Hypotheses) -> Option<Self> {
        let points: Vec<_> =
            (0..DRAWS).filter_map(|seed| Some((seed, given(hypotheses, seed)?))).take(POINTS).collect();
        (points.len() == POINTS).then_some(Samples(points))
    }

    /// The values of expressions, for each expression at all points; `None` if one of them has no value.
    pub fn values(&self, expressions: &[Sym]) -> Option<Vec<f64>> {
        let mut all = Vec::with_capacity(expressions.len() * POINTS);
        for expression in expressions {
            for (seed, known) in &self.0 {
                all.push(at(*expression, *seed, known)?);
            }
        }
        Some(all)
    }
}

/// The value of an expression at a point; `None` if it is not finite.
fn at(expression: Sym, seed: u64, known: &HashMap<String, f64>) -> Option<f64> {
    let value = |name: &str| Some(known.get(name).copied().unwrap_or_else(|| drawn(name, seed)));
    expression.evaluate_analytic(&value).ok().filter(|value| value.is_finite())
}

/// The pseudo-random value of a letter, between 0.2 and 1.7; with an odd seed between 0.1 and 0.55, for components of vectors of length one.
fn drawn(name: &str, seed: u64) -> f64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in name.bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    hash ^= hash >> 29;
    // the shift leaves 53 bits, which double precision represents exactly
    let part = (hash.wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 11) as f64 / (1_u64 << 53) as f64;
    if seed.is_multiple_of(2) { 0.2 + 1.5 * part } else { 0.1 + 0.45 * part }
}

/// The values that hypotheses determine at a point; `None` if they do not hold there.
fn given(hypotheses: &Hypotheses, seed: u64) -> Option<HashMap<String, f64>> {
    let mut known = HashMap::new();
    // repeated, since a value may depend on one that a later statement determines
    for _ in 0..3 {
        for &(left, right) in hypotheses.statements() {
            let value = at(right, seed, &known)?;
            match left.node() {
                Node::Symbol(_) => {
                    known.insert(left.to_string(), value);
                }
                Node::Power(of, power) if of.symbol_name().is_some() => {
                    known.insert(of.to_string(), value.powf(1.0 / f64::from(power)));
                }
                // a sum of squares, of which all letters are scaled
                _ => {
                    let factor = (value / at(left, seed, &known)?).sqrt();
                    for symbol in left.symbols_of() {
                        let scaled = factor * at(symbol, seed, &known)?;
                        known.insert(symbol.to_string(), scaled);
                    }
                }
            }
        }
    }
    let holds = |&(left, right): &(Sym, Sym)| {
        let values = at(left, seed, &known).zip(at(right, seed, &known));
        values.is_some_and(|(left, right)| (left - right).abs() <= 1e-9 * (1.0 + right.abs()))
    };
    hypotheses.statements().iter().all(holds).then_some(known)
}
