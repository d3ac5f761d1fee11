//! Several printed conditions of one steady motion: each must follow from the equations of motion, and together they must imply these equations.

use crate::certificate::Record;
use crate::conditions::Hypothesis;
use crate::consequence::{is_apart, is_pole, require};
use crate::display::factors;
use crate::equation::{Outcome, vanishes};
use crate::exact_points::{Effort, search};
use crate::extent::is_met;
use crate::finding::Finding;
use crate::ideal_membership::combination;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::resting_equations::SteadyMotion;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use symbolic::{Sym, decide, normal};

/// The relation of the first of several conditions to the others.
pub(crate) enum Joint {
    /// The condition, together with these others, is equivalent to the equations of the motion; `divided` contains the divisors.
    Whole { others: Vec<String>, divided: Vec<Sym> },
    /// The condition holds on every such motion, but these others were not proved to hold.
    Part { failing: Vec<String> },
    /// The condition does not hold on every such motion.
    Other,
}

/// The relation of the first printed condition to the others; `None` if nothing is decided.
pub(crate) fn together(
    steady: &SteadyMotion<'_, '_>,
    names: &[&str],
    assumed: &[Hypothesis],
    record: &mut Record,
) -> Option<Joint> {
    let SteadyMotion { motion, equations, printed, conditions, .. } = steady;
    let is_open = |equation: &Sym| !decide(motion.reduced(*equation), &motion.hypotheses).is_zero();
    let equations: Vec<Sym> = equations.iter().map(|(equation, _)| *equation).filter(is_open).collect();
    let of_equations = Vanishing::of(motion, &equations, conditions);
    let holds = |&place: &usize| of_equations.shows(printed[place]).is_some();
    let (holding, failing): (Vec<usize>, Vec<usize>) = (0..printed.len()).partition(holds);
    let named = |places: &[usize]| -> Vec<String> {
        places.iter().filter(|place| **place > 0).map(|&place| names[place - 1].to_owned()).collect()
    };
    if holding.first() != Some(&0) {
        // if the equations could not be solved, an unproved condition may still hold
        return of_equations.solved.map(|_| Joint::Other);
    }
    let zeros: Vec<Sym> = holding.iter().map(|&place| printed[place]).collect();
    let of_print = Vanishing::of(motion, &zeros, conditions);
    let implied = equations.iter().map(|&equation| of_print.shows(equation)).collect::<Option<Vec<_>>>();
    match (of_equations.shows(printed[0]), implied) {
        (Some(first), Some(implied)) if holding.len() > 1 && of_print.is_somewhere() => {
            record.restart();
            let all = std::iter::once((&first, printed[0])).chain(implied.iter().zip(equations.iter().copied()));
            for (way, zero) in all {
                match way {
                    Way::Solved(there) => record.vanishes(&there.motion, assumed, &[Condition::Zero(zero)]),
                    Way::Combined(_) => record.leave_out(),
                }
            }
            let divided = std::iter::once(&first).chain(&implied).flat_map(Way::divided).collect();
            Some(Joint::Whole { others: named(&holding), divided })
        }
        _ if failing.is_empty() => None,
        _ => {
            record.restart();
            Some(Joint::Part { failing: named(&failing) })
        }
    }
}

/// Expressions that vanish, with the motion on which they do if they can be solved.
struct Vanishing<'a, 't, 'm> {
    motion: &'a Motion<'t, 'm>,
    conditions: &'a [Condition],
    zeros: Vec<Sym>,
    solved: Option<Solved<'t, 'm>>,
}

/// The proof that another expression vanishes there.
enum Way<'a, 't, 'm> {
    Solved(&'a Solved<'t, 'm>),
    /// The expression is a combination of the others, after multiplication by letters that never vanish.
    Combined(Vec<Sym>),
}

impl Way<'_, '_, '_> {
    fn divided(&self) -> Vec<Sym> {
        match self {
            Way::Solved(solved) => solved.divided.clone(),
            Way::Combined(letters) => letters.clone(),
        }
    }
}

impl<'a, 't, 'm> Vanishing<'a, 't, 'm> {
    fn of(motion: &'a Motion<'t, 'm>, zeros: &[Sym], conditions: &'a [Condition]) -> Self {
        Vanishing { motion, conditions, zeros: zeros.to_vec(), solved: Solved::of(motion, zeros, conditions) }
    }

    fn shows(&self, zero: Sym) -> Option<Way<'_, 't, 'm>> {
        let solved = self.solved.as_ref().filter(|solved| solved.vanishes(zero, self.conditions));
        let combined = || {
            let is_apart = |letter: Sym| is_apart(letter, self.motion, self.conditions);
            combination(zero, &self.zeros, &is_apart).map(Way::Combined)
        };
        solved.map(Way::Solved).or_else(combined)
    }

    /// Whether an exact point is found at which all expressions vanish, the conditions hold and no divisor vanishes.
    fn is_somewhere(&self) -> bool {
        match &self.solved {
            Some(solved) => solved.is_somewhere(self.conditions),
            None => self.vanish_where(&[]) || self.vanish_where(&self.motion.trace.coordinates),
        }
    }
}

impl Vanishing<'_, '_, '_> {
    /// Whether an exact point is found at which the expressions vanish and the conditions hold, with these coordinates zero.
    fn vanish_where(&self, coordinates: &[Sym]) -> bool {
        let there: Vec<(Sym, Sym)> = coordinates.iter().map(|&coordinate| (coordinate, Sym::ZERO)).collect();
        let zeros: Vec<Sym> = self.zeros.iter().map(|zero| zero.substitute(&there)).collect();
        let conditions = self.conditions.iter().map(|condition| condition.mapped(|e| e.substitute(&there)));
        let all_vanish = |signs: &[i8]| signs.iter().all(|sign| *sign == 0);
        search(&zeros, &conditions.collect::<Vec<_>>(), self.motion, Effort::Part, all_vanish).is_some()
    }
}

/// A motion on which expressions vanish.
struct Solved<'t, 'm> {
    motion: Motion<'t, 'm>,
    /// The divisors of the solution, none of which vanishes.
    divided: Vec<Sym>,
}

impl<'t, 'm> Solved<'t, 'm> {
    /// Solves the equations; `None` if one cannot be solved, or only with a divisor that may vanish.
    fn of(motion: &Motion<'t, 'm>, zeros: &[Sym], conditions: &[Condition]) -> Option<Self> {
        let mut solved = Solved { motion: motion.clone(), divided: Vec::new() };
        let is_apart = |factor: Sym| is_apart(factor, motion, conditions) || is_pole(factor, motion);
        for &zero in zeros {
            let left = solved.motion.reduced(zero);
            if decide(left, &solved.motion.hypotheses).is_zero() {
                continue;
            }
            let numerator = normal(left, &solved.motion.hypotheses).ok()?.numerator();
            let (apart, open): (Vec<Sym>, Vec<Sym>) =
                factors(numerator).into_iter().partition(|factor| is_apart(*factor));
            if open.is_empty() {
                return None;
            }
            let known = solved.motion.divisors.len();
            let essential = open.into_iter().reduce(|product, factor| product * factor)?;
            solved.motion.assume(essential, None).ok()?;
            let new = solved.motion.divisors[known..].iter().copied();
            let new: Vec<Sym> = new
                .flat_map(|divisor| {
                    normal(divisor, &solved.motion.hypotheses).map_or(vec![divisor], |form| factors(form.numerator()))
                })
                .collect();
            if !new.iter().all(|divisor| is_apart(*divisor)) {
                return None;
            }
            solved.divided.extend(apart.into_iter().chain(new));
        }
        Some(solved)
    }

    /// Whether an exact point is found that satisfies the conditions on the motion, with nonzero divisors.
    fn is_somewhere(&self, conditions: &[Condition]) -> bool {
        let apart = self.divided.iter().map(|&divisor| Condition::NonZero(divisor));
        let all = conditions.iter().copied().chain(apart);
        is_met(&all.map(|condition| condition.mapped(|e| self.motion.reduced(e))).collect::<Vec<_>>())
    }

    fn vanishes(&self, zero: Sym, conditions: &[Condition]) -> bool {
        let there: Vec<Condition> =
            conditions.iter().map(|condition| condition.mapped(|e| self.motion.reduced(e))).collect();
        matches!(vanishes(&self.motion, zero, &there), Outcome::Zero(_))
    }
}

impl Joint {
    /// Writes the verdict into the finding.
    pub fn told(
        self,
        steady: &SteadyMotion<'_, '_>,
        written: &[Sym],
        letters: &Letters<'_, '_>,
        finding: &mut Finding,
    ) {
        match self {
            Joint::Other => return,
            Joint::Whole { others, divided } => {
                for &divisor in divided.iter().chain(&steady.motion.divisors).chain(written) {
                    require(divisor, &steady.conditions, letters, finding);
                }
                finding.judged.verdict = Verdict::Proved;
                finding.judged.evidence = format!(
                    "together with {} the printed condition is that of the motion: all of them follow from the equations of motion there, and these \
                     from them",
                    others.join(", ")
                );
            }
            Joint::Part { failing } => {
                let why = format!(
                    "the printed condition holds on every such motion; it is a part of the condition of the motion, of which {} as printed was not \
                     shown to hold",
                    failing.join(", ")
                );
                neither(Outcome::Undecided(why), letters, finding);
            }
        }
        finding.judged.counterexample.clear();
        finding.judged.difference = None;
    }
}
