//! The structural index of the equations of motion for a coordinate without inertia whose law does not contain it.
//!
//! The law 0 = f(q, u, t) is differentiated until the coordinate appears: the derivative of a coordinate is a speed, and that of a speed contains
//! all letters of the equations of motion that the mass matrix couples with it. After r differentiations the equations are a DAE of index
//! r + 1.

use model::equations::Equations;
use model::{Model, Trace};
use std::collections::HashSet;
use symbolic::{Sym, apart};

/// The number r of differentiations of its law after which the coordinate with index `place`, or its speed, appears; `None` if the
/// undifferentiated law contains one of them, or no derivative does.
pub(crate) fn differentiations(model: &Model, place: usize) -> Option<usize> {
    if model.positions() != model.speeds() || place >= model.coordinates.len() {
        return None;
    }
    apart(|| {
        let trace = Trace::of(model);
        let Equations { mass, bias, .. } = Equations::of(&trace);
        let n = bias.len();
        let letters: HashSet<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let held = |expression: Sym| -> HashSet<Sym> {
            expression.symbols_of().into_iter().filter(|symbol| letters.contains(symbol)).collect()
        };
        let own = [trace.coordinates[place], trace.speeds[place]];
        // groups of speeds whose accelerations are coupled by the mass matrix
        let mut group: Vec<usize> = (0..n).collect();
        for i in 0..n {
            for j in 0..i {
                if mass[i][j] != Sym::ZERO {
                    let (from, to) = (group[i], group[j]);
                    group.iter_mut().filter(|one| **one == from).for_each(|one| *one = to);
                }
            }
        }
        let mut reached = held(bias[place]);
        if own.iter().any(|letter| reached.contains(letter)) {
            return None;
        }
        for count in 1..=2 * n {
            let mut next = reached.clone();
            for i in 0..n {
                if reached.contains(&trace.coordinates[i]) {
                    next.insert(trace.speeds[i]);
                }
                if reached.contains(&trace.speeds[i]) {
                    (0..n).filter(|&j| group[j] == group[i]).for_each(|j| next.extend(held(bias[j])));
                }
            }
            if own.iter().any(|letter| next.contains(letter)) {
                return Some(count);
            }
            if next.len() == reached.len() {
                return None;
            }
            reached = next;
        }
        None
    })
}
