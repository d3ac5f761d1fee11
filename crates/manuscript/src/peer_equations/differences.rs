//! Terms by which an equation differs from that of the model along the same direction.

use super::finding::readable;
use crate::motion::Motion;
use model::Trace;
use model::equations::{Characteristics, Equations, generic_rank};
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, decide, substitute_all};

/// A term that differs, each side in text and LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TermDifference {
    /// The acceleration whose coefficient differs; none of the terms without accelerations.
    pub of: Option<String>,
    /// The other program's.
    pub theirs: Option<(String, String)>,
    /// The model's.
    pub ours: Option<(String, String)>,
    /// Theirs less the model's.
    pub difference: Option<(String, String)>,
}

/// The model's equations along the directions of the other program's speeds.
pub(super) struct Projected<'a, 't, 'm> {
    pub trace: &'t Trace<'m>,
    /// On the constraints, with free accelerations.
    pub held: &'a Motion<'t, 'm>,
    pub free: &'a Characteristics,
    /// The other program's speeds by the model's independent ones.
    pub slopes: &'a [Vec<Sym>],
}

impl Projected<'_, '_, '_> {
    /// The terms by which an equation at a place differs: it is the one along the speed at this place, all others at rest. Empty where
    /// this has no meaning.
    pub fn differences(&self, row: Sym, place: usize) -> Vec<TermDifference> {
        let Projected { trace, held, free, slopes } = self;
        let size = free.independent.len();
        let Some(square) = slopes.get(..size).filter(|square| place < size && generic_rank(square) == size) else {
            return Vec::new();
        };
        let unit: Vec<Sym> = (0..size).map(|r| if r == place { Sym::ONE } else { Sym::ZERO }).collect();
        let Ok(direction) = solve(square, &unit, &Hypotheses::none()) else { return Vec::new() };
        let Equations { mass, bias, .. } = Equations::of(trace);
        let inertia = |(row, &bias): (&Vec<Sym>, &Sym)| {
            row.iter().zip(&trace.accelerations).fold(bias, |sum, (&entry, &rate)| sum + entry * rate)
        };
        let rows: Vec<Sym> = mass.iter().zip(&bias).map(inertia).collect();
        let ours =
            free.along(&rows).into_iter().zip(direction.values()).fold(Sym::ZERO, |sum, (row, part)| sum + part * row);
        let [theirs, ours] = [row, ours].map(|side| held.reduced(side));
        let mut all = Vec::new();
        for &k in &free.independent {
            let [a, b] = [theirs, ours].map(|side| trace.by_acceleration(side, k));
            all.extend(self.difference(Some(trace.accelerations[k].to_string()), a, b));
        }
        let rest: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|&rate| (rate, Sym::ZERO)).collect();
        let [a, b] = [0, 1].map(|side| substitute_all(&[theirs, ours], &rest)[side]);
        all.extend(self.difference(None, a, b));
        all
    }

    fn difference(&self, of: Option<String>, theirs: Sym, ours: Sym) -> Option<TermDifference> {
        let difference = theirs - ours;
        if decide(difference, &self.held.hypotheses).is_zero() {
            return None;
        }
        let [theirs, ours, difference] = [theirs, ours, difference].map(|side| readable(side, self.held));
        Some(TermDifference { of, theirs, ours, difference })
    }
}
