//! Values of expressions at sample points in general position.

use crate::Trace;
use crate::real_points::drawn;
use field::DoubleDouble;
use symbolic::Sym;

/// The number of sample points.
pub(super) const POINTS: u64 = 3;

/// Returns the value at a sample point. Coordinates, speeds and the time differ between points, parameters do not.
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

/// Returns the values of several expressions at each sample point.
pub(super) fn values(trace: &Trace<'_>, of: &[Sym]) -> Option<Vec<Vec<f64>>> {
    (0..POINTS).map(|point| of.iter().map(|each| value(trace, *each, point)).collect()).collect()
}

/// Returns whether an expression depends only on the state, the time, parameters and conditions.
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
