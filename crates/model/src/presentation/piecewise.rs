//! Conditions of a law as they are written: `abs`, `sign`, `max` and `min` in the place of polynomials in switches.

use crate::Trace;
use field::Scalar;
use symbolic::{Node, Sym, substitute_all};

/// The condition of each switch, with these functions by their names.
///
/// With the switch s, which is 1 where v is positive and 0 elsewhere, they stand in a trace as sign(v) = 2 s - 1, abs(v) = (2 s - 1) v, and
/// for v = a - b as max(a, b) = s a + (1 - s) b and min(a, b) = s b + (1 - s) a.
pub fn conditions_by_name(trace: &Trace<'_>) -> Vec<Sym> {
    let conditions: Vec<Sym> = trace.model.switches.iter().map(|&own| trace.scalar(own)).collect();
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    // the condition of a switch holds switches before it alone
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
