//! A printed equation of motion as a linear combination of the equations of the model.

use crate::certificate::Record;
use crate::conditions::Hypothesis;
use crate::display::Told;
use crate::motion::{Motion, equations_of_motion};
use claims::Condition;
use claims::certificate::{Combined, PartProof};
use model::Trace;
use model::equations::Equations;
use symbolic::linear::solve;
use symbolic::{Decision, Hypotheses, Sym, decide, normal};

/// The largest number of equations of a model for which the combination is printed.
const MOST_SPEEDS: usize = 4;

/// The largest length of a factor in characters.
const READABLE: usize = 120;

/// Equations of the model with factors, in which the reactions of constraints are letters.
pub(crate) struct Combination {
    /// The factor of the equation of each speed.
    factors: Vec<Sym>,
    /// Divisors of the factors.
    pub requires: Vec<Sym>,
}

impl Combination {
    /// The combination that equals an expression for all values of all letters, for models with constraints. It needs no solution of the equations
    /// for accelerations and reactions, which is long for linkages.
    pub fn of(zero: Sym, motion: &Motion<'_, '_>) -> Option<Self> {
        let trace = motion.trace;
        if Equations::of(trace).constraints.is_empty() {
            return None;
        }
        let plain = |factor: Sym| normal(factor, &Hypotheses::none()).map_or(factor, |form| form.to_sym());
        let factors: Vec<Sym> = factors(zero, trace)?.into_iter().map(plain).collect();
        if factors.iter().all(|factor| *factor == Sym::ZERO) {
            return None;
        }
        let sum = factors.iter().zip(equations_of_motion(trace)).map(|(&factor, equation)| factor * equation);
        let rest = sum.fold(zero, |rest, one| rest - one);
        match decide(rest, &motion.with_free_frames(Hypotheses::none())) {
            Decision::Zero(proof) => Some(Combination { factors, requires: proof.requires }),
            _ => None,
        }
    }

    /// Records the combination as the proof of an equality.
    pub fn recorded(&self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], then: Condition, record: &mut Record) {
        let mut by_equations = Motion::without_anything(motion.trace);
        by_equations.held = equations_of_motion(motion.trace).into_iter().take(self.factors.len()).collect();
        record.part(&by_equations, assumed, &[then], |relations| {
            let places = self.factors.iter().map(|&factor| relations.recorder.place(factor));
            let one = Combined { multiplier: Vec::new(), cofactors: places.enumerate().collect(), factor: None };
            PartProof::Combination { combinations: vec![one] }
        });
    }

    /// The combination in a sentence: `1/(m*l^2) times the equation of theta`; none if it is too long to read.
    pub fn told(&self, motion: &Motion<'_, '_>, told: Told<'_, '_, '_>) -> Option<String> {
        told_factors(&self.factors, motion, told)
    }
}

/// A sentence with the linear combination of the model's equations that equals a printed equation: `1/(m*l^2) times the equation of theta`. `None`
/// if the equations contain reactions of constraints, or the sentence is too long.
pub(crate) fn told_combination(printed: Sym, motion: &Motion<'_, '_>, told: Told<'_, '_, '_>) -> Option<String> {
    if !Equations::of(motion.trace).constraints.is_empty() {
        return None;
    }
    let factors = factors(printed, motion.trace)?;
    let reduced: Vec<Sym> = factors.into_iter().map(|factor| motion.reduced(factor)).collect();
    told_factors(&reduced, motion, told)
}

/// The factors with which the equations of the model have the accelerations of an expression.
fn factors(zero: Sym, trace: &Trace<'_>) -> Option<Vec<Sym>> {
    let Equations { mass, .. } = Equations::of(trace);
    if mass.len() > MOST_SPEEDS {
        return None;
    }
    let slopes: Vec<Sym> = (0..mass.len()).map(|j| trace.by_acceleration(zero, j)).collect();
    Some(solve(&mass, &slopes, &Hypotheses::none()).ok()?.values())
}

fn told_factors(factors: &[Sym], motion: &Motion<'_, '_>, told: Told<'_, '_, '_>) -> Option<String> {
    let mut parts = Vec::new();
    for (k, &factor) in factors.iter().enumerate() {
        let form = normal(factor, &Hypotheses::none()).ok()?;
        if form.is_zero() {
            continue;
        }
        let own = told.0.told(form.to_sym()).to_string();
        if own.chars().count() > READABLE {
            return None;
        }
        parts.push(match own.as_str() {
            "1" => format!("the equation of {}", motion.trace.direction(k)),
            _ => format!("{own} times the equation of {}", motion.trace.direction(k)),
        });
    }
    (!parts.is_empty()).then(|| parts.join(" plus "))
}
