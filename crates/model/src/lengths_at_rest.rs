//! Magnitudes of velocities, which have no derivative at rest.

use crate::arena::{Function, Number, Part, Scalar, ScalarId};
use crate::equations::vanishes;
use crate::{Model, Trace};
use symbolic::Sym;

impl Model {
    /// Replaces by zero every norm and square root that depends on speeds and vanishes when all speeds vanish. Returns `None` if the model contains
    /// none.
    ///
    /// In the drag -c |v| v this omits a term of second order in the speeds, in -c |v| one of first order: the caller must decide
    /// whether the law keeps its derivatives at rest.
    pub fn without_lengths_at_rest(&self) -> Option<Self> {
        let is_length =
            |part: &Part| matches!(part, Part::Scalar(Scalar::Norm(_) | Scalar::Function(Function::Sqrt, _)));
        let candidates: Vec<usize> = (0..self.arena.parts.len()).filter(|&k| is_length(&self.arena.parts[k])).collect();
        if candidates.is_empty() {
            return None;
        }
        let lengths: Vec<usize> = symbolic::apart(|| {
            let trace = Trace::of(self);
            let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
            let is_of_speeds = |&place: &usize| {
                let own = trace.scalar(ScalarId(place));
                own.symbols_of().iter().any(|letter| trace.speeds.contains(letter))
                    && vanishes(own.substitute(&at_rest))
            };
            candidates.into_iter().filter(is_of_speeds).collect()
        });
        if lengths.is_empty() {
            return None;
        }
        let mut without = self.clone();
        for place in lengths {
            without.arena.parts[place] = Part::Scalar(Scalar::Number(Number { value: 0.0, times: 1.0, per: 1.0 }));
        }
        Some(without)
    }
}
