//! Values of expressions at points that follow no line.

use crate::Trace;
use crate::real_points::drawn;
use field::DoubleDouble;
use symbolic::Sym;

/// Points at which expressions are compared.
pub(super) const POINTS: u64 = 3;

/// The value of an expression at a point: coordinates, speeds and the time differ between points, parameters do not.
pub(super) fn value(trace: &Trace<'_>, of: Sym, point: u64) -> Option<f64> {
    if let Some(constant) = of.as_constant() {
        return Some(constant.to_f64());
    }
    let drawn = |name: &str| {
        let letter = Sym::symbol(name);
        let point = if trace.parameters.contains(&letter) { 0 } else { point };
        let pi = (letter == trace.pi).then(|| DoubleDouble::from(std::f64::consts::PI));
        Some(pi.unwrap_or_else(|| drawn(name, point)))
    };
    let found = of.evaluate_analytic(&drawn).ok();
    found.map(|value: DoubleDouble| value.hi()).filter(|value| value.is_finite())
}

/// Values of expressions at each point.
pub(super) fn values(trace: &Trace<'_>, of: &[Sym]) -> Option<Vec<Vec<f64>>> {
    (0..POINTS).map(|point| of.iter().map(|each| value(trace, *each, point)).collect()).collect()
}

/// Whether an expression holds nothing but the state, the time, parameters and conditions.
pub(super) fn is_of_state(trace: &Trace<'_>, of: Sym) -> bool {
    let is_known = |letter: &Sym| {
        *letter == trace.time
            || *letter == trace.pi
            || [&trace.coordinates, &trace.speeds, &trace.parameters, &trace.switches]
                .iter()
                .any(|known| known.contains(letter))
    };
    of.symbols_of().iter().all(is_known)
}
