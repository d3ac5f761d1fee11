//! The error equation of a reduced model, with the full law along the lifted motion.
//!
//! With y = Y + a + b + ..., a of first and b of second order in the defect,
//!
//!   a' = F_y a - d ,    a(0) = y(0) - Y(0) ,
//!   b' = F_y b + 1/2 F_yy[a, a] ,    b(0) = 0 .
//!
//! The error estimate is a; it is not a bound, and is credible only if b is small compared with a. Both equations
//! follow from the full law by automatic differentiation: with e and h infinitesimal, F at Y + (e + h) a + 2 e h b has
//! the coefficients F_y a of e, and F_yy[a, a] + 2 F_y b of e h.

use super::reduced_model::{Lower, straight};
use field::{Over, Scalar, Tangent};
use simulation::{CompiledLaw, SymbolicLaw, TracedOde, traced};
use std::sync::Arc;
use symbolic::{Sym, Tape};

/// The law of (z, a, b); `None` where it cannot be recorded.
pub fn carried(written: &Arc<dyn SymbolicLaw>, lower: &Lower) -> Option<CompiledLaw> {
    let n = written.dimension();
    let tape = traced(&**written, |TracedOde { state, time, rates }| {
        Tape::record(&[&state[..], &[*time]].concat(), rates).ok()
    })?;
    let (written, lower) = (Arc::clone(written), lower.clone());
    let kept = lower.dimension;
    let rates = move |time: Sym, state: &[Sym]| {
        let (z, errors) = state.split_at(kept);
        let (a, b) = errors.split_at(n);
        let y = (lower.lift)(time, z);
        let moving = (0..n).map(|i| Tangent::moving(Tangent::moving(y[i], a[i]), Tangent::moving(a[i], b[i] + b[i])));
        let inputs: Vec<Tangent<Tangent<Sym>>> = moving.chain([Tangent::fixed(Tangent::fixed(time))]).collect();
        let mut moved = vec![Tangent::lift(0.0); n];
        tape.over().evaluate(&inputs, &mut moved);
        // the defect is differentiated with new symbols: the state here may be any expressions
        let defect = lower.defect(&*written, time, z);
        let first = moved.iter().zip(defect).map(|(rate, defect)| rate.value.slope - defect);
        let second = moved.iter().map(|rate| rate.slope.slope.half());
        (lower.rates)(time, z).into_iter().chain(first).chain(second).collect()
    };
    straight(kept + 2 * n, Arc::new(rates))
}
