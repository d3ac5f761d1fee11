//! Conditions of a law in the notation of the file: `abs`, `sign`, `max` and `min` replace polynomials in switches.

use crate::Trace;
use field::Scalar;
use symbolic::{Node, Sym, substitute_all};

/// Returns the condition of each switch, with these functions.
///
/// Let s be the switch that is 1 where v is positive, and 0 elsewhere. A trace contains sign(v) as 2 s - 1 and abs(v) as (2 s - 1) v.
/// For v = a - b it contains max(a, b) as s a + (1 - s) b and min(a, b) as s b + (1 - s) a.
pub fn conditions_by_name(trace: &Trace<'_>) -> Vec<Sym> {
    let conditions: Vec<Sym> = trace.model.switches.iter().map(|&own| trace.scalar(own)).collect();
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    // the condition of a switch contains only earlier switches
    for (&switch, &condition) in trace.switches.iter().zip(&conditions) {
        let named = |name: &str, of: &[Sym]| {
            let texts: Vec<String> = substitute_all(of, &known).iter().map(ToString::to_string).collect();
            Sym::symbol(&format!("{name}({})", texts.join(", ")))
        };
        let sign = Sym::int(2) * switch - Sym::ONE;
        let either = |a: Sym, b: Sym| switch * a + (Sym::ONE - switch) * b;
        let mut own = vec![(sign * condition, named("abs", &[condition])), (sign, named("sign", &[condition]))];
        let difference = match condition.node() {
            Node::Difference(a, b) => Some((a, b)),
            Node::Negation(b) => Some((Sym::ZERO, b)),
            _ => None,
        };
        for (a, b) in difference.into_iter().chain([(condition, Sym::ZERO)]) {
            own.push((either(a, b), named("max", &[a, b])));
            own.push((either(b, a), named("min", &[b, a])));
        }
        known.extend(own);
    }
    substitute_all(&conditions, &known)
}
