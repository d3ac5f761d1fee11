//! Terms in which an equation of another program differs from the model's equation along the same direction.

use super::finding::readable;
use crate::motion::Motion;
use model::Trace;
use model::equations::{Characteristics, Equations, generic_rank};
use symbolic::linear::solve;
use symbolic::{Decision, Hypotheses, Sym, decide};

/// A term that differs; each expression as text and LaTeX, `None` if it is too long.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TermDifference {
    /// The acceleration whose coefficient differs; `None` for the terms without accelerations.
    pub of: Option<String>,
    /// The expression of the other program.
    pub theirs: Option<(String, String)>,
    /// The expression of the model.
    pub ours: Option<(String, String)>,
    /// The expression of the other program minus that of the model.
    pub difference: Option<(String, String)>,
}

/// Projects the model's equations onto the directions of the other program's speeds.
pub(super) struct Projected<'a, 't, 'm> {
    pub trace: &'t Trace<'m>,
    /// The motion under the constraints, with arbitrary accelerations.
    pub held: &'a Motion<'t, 'm>,
    pub free: &'a Characteristics,
    /// The derivatives of the other program's speeds by the independent speeds of the model.
    pub slopes: &'a [Vec<Sym>],
}

impl Projected<'_, '_, '_> {
    /// An equation of the other program, and the model's equation along its speed with this index, all other speeds being zero: under the constraints,
    /// with arbitrary accelerations. `None` if this direction is not defined.
    pub fn sides(&self, row: Sym, place: usize) -> Option<[Sym; 2]> {
        let square = self.slopes.get(..self.free.independent.len())?;
        Some(self.beside(row, &self.free.along(&self.equations()), direction(square, place)?))
    }

    /// Both equations like [`Projected::sides`], but without reactions, if all speeds are independent in the other program. Equal equations give
    /// equal sides; the converse fails, so that these sides do not decide a verdict.
    pub fn sides_without_reactions(&self, row: Sym, place: usize, speeds: &[Sym]) -> Option<[Sym; 2]> {
        let Projected { trace, held, .. } = self;
        let by_speeds =
            |speed: &Sym| (0..trace.speeds.len()).map(|k| held.reduced(trace.by_speed(*speed, k))).collect();
        let square: Vec<Vec<Sym>> = speeds.iter().map(by_speeds).collect();
        Some(self.beside(row, &self.equations(), direction(&square, place)?))
    }

    fn beside(&self, row: Sym, equations: &[Sym], direction: Vec<Sym>) -> [Sym; 2] {
        let ours = equations.iter().zip(direction).fold(Sym::ZERO, |sum, (&row, part)| sum + part * row);
        [self.held.reduced(row), self.held.reduced(ours)]
    }

    /// The equations of motion of the model, without reactions.
    fn equations(&self) -> Vec<Sym> {
        let trace = self.trace;
        let Equations { mass, bias, .. } = Equations::of(trace);
        let inertia = |(row, &bias): (&Vec<Sym>, &Sym)| {
            row.iter().zip(&trace.accelerations).fold(bias, |sum, (&entry, &rate)| sum + entry * rate)
        };
        mass.iter().zip(&bias).map(inertia).collect()
    }

    /// The difference of both sides, if it contains no acceleration. Divisors that must not vanish are added to `requires`.
    pub fn without_accelerations(&self, [theirs, ours]: [Sym; 2], requires: &mut Vec<Sym>) -> Option<Sym> {
        let difference = theirs - ours;
        for &k in &self.free.independent {
            let slope = self.trace.by_acceleration(difference, k);
            match decide(slope, &self.held.hypotheses) {
                Decision::Zero(proof) => requires.extend(proof.requires),
                _ => return None,
            }
        }
        Some(at_rest(self.trace, difference))
    }

    /// The terms in which both sides differ.
    pub fn differences(&self, [theirs, ours]: [Sym; 2]) -> Vec<TermDifference> {
        let Projected { trace, free, .. } = self;
        let mut all = Vec::new();
        for &k in &free.independent {
            let [a, b] = [theirs, ours].map(|side| trace.by_acceleration(side, k));
            all.extend(self.difference(Some(trace.accelerations[k].to_string()), a, b));
        }
        let [a, b] = [theirs, ours].map(|side| at_rest(trace, side));
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

/// An expression with all accelerations set to zero.
fn at_rest(trace: &Trace<'_>, expression: Sym) -> Sym {
    let rest: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|&rate| (rate, Sym::ZERO)).collect();
    expression.substitute(&rest)
}

/// The speeds of the model for which the speed with this index is 1 and all other speeds of the other program are 0; `None` if they are not determined.
fn direction(square: &[Vec<Sym>], place: usize) -> Option<Vec<Sym>> {
    let size = square.len();
    let unit = |place: usize| (0..size).map(|r| if r == place { Sym::ONE } else { Sym::ZERO }).collect::<Vec<Sym>>();
    if place >= size || square.iter().any(|row| row.len() != size) || generic_rank(square) < size {
        return None;
    }
    match square.iter().enumerate().all(|(r, row)| *row == unit(r)) {
        true => Some(unit(place)),
        false => solve(square, &unit(place), &Hypotheses::none()).ok().map(|solution| solution.values()),
    }
}
