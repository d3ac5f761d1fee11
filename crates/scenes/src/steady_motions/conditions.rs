//! Steady motions of laws that change at conditions: each condition holds, fails, or is zero. At zero, the factor of its part of the law may take any
//! value between those of both cases, as for sticking dry friction.
//!
//! A condition that is zero whenever the system rests, such as the sign of a speed, is set to zero. For other conditions all three cases are
//! tried. If the law is continuous at the zero of the condition, as for `abs`, the zero belongs to both sides.

use super::condition_zeros::vanish_there;
use super::rows::{Rows, Touching};
use super::{NoSteadyMotions, Range, Unknown};
use model::equations::vanishes;
use model::{Model, Trace, conditions_by_name};
use symbolic::{Sym, substitute_all};

/// The case of a condition in a steady motion, or the state of a contact; a contact is open if its gap `Holds` (is positive).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    Holds,
    Fails,
    /// The condition is zero, and its factor in the law lies between 0 and 1; a contact is closed and sticks.
    Between,
    /// A contact is closed and slides along its tangent; `Backward` is the opposite direction.
    Forward,
    Backward,
    /// The condition is zero, and the searches on both sides found the same motion.
    Meeting,
    /// The law does not depend on the condition, given the cases of the others.
    Either,
}

/// Largest number of combinations of cases.
const MOST: usize = 243;

/// Range of the factor of a condition that is zero: 0 where it fails, 1 where it holds.
const BETWEEN: Range = Range { from: 0.0, to: 1.0 };

/// All combinations of cases that are searched.
pub(super) fn combinations(rows: &Rows, at_rest: &[(Sym, Sym)]) -> Result<Vec<Vec<Case>>, NoSteadyMotions> {
    let values = substitute_all(&rows.conditions, at_rest);
    let mut all: Vec<Vec<Case>> = vec![Vec::new()];
    let letters = rows.condition_letters.iter().map(Some).chain(rows.contacts.iter().map(|_| None));
    let contacts = rows.condition_letters.iter().map(|_| None).chain(rows.contacts.iter().map(Some));
    for ((value, letter), contact) in values.iter().zip(letters).zip(contacts) {
        let cases: &[Case] = match (contact, value.as_constant()) {
            (Some(contact), _) => contact.cases(at_rest),
            _ if vanishes(*value) => &[Case::Between],
            (None, Some(number)) if number.to_f64() > 0.0 => &[Case::Holds],
            (None, Some(_)) => &[Case::Fails],
            (None, None) if letter.is_some_and(|letter| is_continuous(rows, &values, (*letter, *value))) => {
                &[Case::Holds, Case::Fails]
            }
            (None, None) => &[Case::Holds, Case::Fails, Case::Between],
        };
        all = all.iter().flat_map(|own| cases.iter().map(move |case| [&own[..], &[*case]].concat())).collect();
        if all.len() > MOST {
            return Err(NoSteadyMotions::ManyConditions { conditions: rows.conditions.len(), most: MOST });
        }
    }
    let own = &values[..rows.condition_letters.len()];
    let pairs: Vec<(usize, usize)> = (0..own.len()).flat_map(|at| (0..at).map(move |other| (at, other))).collect();
    for (at, other) in pairs {
        if vanishes(own[at] - own[other]) {
            all.retain(|cases| cases[at] == cases[other]);
        } else if vanishes(own[at] + own[other]) {
            all.retain(|cases| cases[at] == cases[other].opposite());
        }
    }
    Ok(all)
}

impl Case {
    /// The case of a condition with the opposite sign.
    fn opposite(self) -> Self {
        match self {
            Self::Holds => Self::Fails,
            Self::Fails => Self::Holds,
            other => other,
        }
    }
}

/// The conditions of a law, then the gaps of its contacts, as texts for messages.
pub fn conditions_of(model: &Model) -> Vec<String> {
    let own = |trace: Trace<'_>| -> Vec<String> {
        let conditions = conditions_by_name(&trace).into_iter().map(|own| own.to_string());
        let gaps = model.contacts.iter().enumerate().map(|(place, one)| format!("the gap of {}", one.title(place)));
        conditions.chain(gaps).collect()
    };
    symbolic::apart(|| own(Trace::of(model)))
}

impl Touching {
    /// Whether a closed contact slides in a steady motion, since a cyclic coordinate moves along its tangent.
    pub fn may_slide(&self, at_rest: &[(Sym, Sym)]) -> bool {
        self.friction.is_some() && !substitute_all(&self.slides, at_rest).iter().all(|slide| vanishes(*slide))
    }

    fn cases(&self, at_rest: &[(Sym, Sym)]) -> &'static [Case] {
        match (self.is_one_sided, self.may_slide(at_rest)) {
            (false, _) => &[Case::Between],
            (true, false) => &[Case::Holds, Case::Between],
            (true, true) => &[Case::Holds, Case::Between, Case::Forward, Case::Backward],
        }
    }
}

/// The additions of a combination of cases to the equations of steady motion.
#[derive(Default)]
pub(super) struct Laws {
    /// Letters with fixed values.
    pub known: Vec<(Sym, Sym)>,
    /// Additional unknowns: factors of conditions that are zero, and fractions of friction that act.
    pub unknowns: Vec<(Sym, Unknown)>,
    /// The normal reactions of closed contacts; they are multipliers.
    pub touching: Vec<Sym>,
    /// Tangential reactions in terms of the normal reactions.
    pub forces: Vec<(Sym, Sym)>,
    /// Expressions that must be positive (true) or negative, each with the index of its case.
    pub sides: Vec<(Sym, bool, usize)>,
    /// Expressions that must be zero.
    pub at_zero: Vec<Sym>,
}

impl Laws {
    /// The additions for a combination of cases; unknowns are numbered from `state` on.
    pub fn of(rows: &Rows, cases: &[Case], at_rest: &[(Sym, Sym)], state: usize) -> Self {
        let held = substitute_all(&rows.conditions, at_rest);
        let mut laws = Laws::default();
        for (place, case) in cases.iter().enumerate() {
            let is_open = match place.checked_sub(rows.condition_letters.len()) {
                None => laws.add_condition(rows, (place, *case), at_rest, state + place),
                Some(own) => laws.add_contact(&rows.contacts[own], (place, *case), at_rest, state + place),
            };
            match is_open {
                true => laws.sides.push((held[place], *case == Case::Holds, place)),
                false if vanishes(held[place]) => {}
                false => laws.at_zero.push(held[place]),
            }
        }
        laws
    }

    /// Adds a condition; returns whether its value must have a sign.
    fn add_condition(&mut self, rows: &Rows, (own, case): (usize, Case), at_rest: &[(Sym, Sym)], place: usize) -> bool {
        let letter = rows.condition_letters[own];
        let all = || rows.residuals.iter().chain(&rows.zeros);
        match case {
            Case::Holds => self.known.push((letter, Sym::ONE)),
            Case::Fails => self.known.push((letter, Sym::ZERO)),
            // the factor multiplies a quantity that is zero at rest, such as a coefficient of damping: it occurs in no equation
            _ if all().all(|row| vanishes(row.diff(letter).substitute(at_rest))) => {
                self.known.push((letter, Sym::ZERO))
            }
            _ => self.unknowns.push((letter, sought(letter, place, BETWEEN))),
        }
        matches!(case, Case::Holds | Case::Fails)
    }

    /// Adds a contact; returns whether it is open.
    fn add_contact(
        &mut self,
        contact: &Touching,
        (own, case): (usize, Case),
        at_rest: &[(Sym, Sym)],
        place: usize,
    ) -> bool {
        let Some((&normal, tangential)) = contact.reactions.split_first() else { return false };
        if case == Case::Holds {
            self.known.extend(contact.reactions.iter().map(|letter| (*letter, Sym::ZERO)));
            return true;
        }
        self.touching.push(normal);
        if contact.is_one_sided {
            self.sides.push((normal, true, own));
        }
        let Some(friction) = contact.friction else {
            self.known.extend(tangential.iter().map(|letter| (*letter, Sym::ZERO)));
            return false;
        };
        let slides = substitute_all(&contact.slides, at_rest);
        if case == Case::Between {
            let mut rest = Sym::ONE;
            for &letter in tangential {
                let share = Sym::symbol(&format!("{letter}/({normal} mu)"));
                self.forces.push((letter, friction * share * normal));
                self.unknowns.push((share, sought(share, place, SHARE)));
                rest -= share * share;
            }
            if tangential.len() > 1 {
                self.sides.push((rest, true, own));
            }
            self.at_zero.extend(slides.into_iter().filter(|slide| !vanishes(*slide)));
            return false;
        }
        let against = if case == Case::Forward { -friction } else { friction };
        self.forces.extend(tangential.iter().map(|letter| (*letter, against * normal)));
        self.sides.extend(slides.first().map(|slide| (*slide, case == Case::Forward, own)));
        false
    }
}

fn sought(letter: Sym, place: usize, range: Range) -> Unknown {
    Unknown { name: letter.to_string(), place, is_circle: false, range }
}

/// Range of the fraction of the largest friction along one tangent.
const SHARE: Range = Range { from: -1.0, to: 1.0 };

/// The value of an expression that does not depend on any of its letters; `None` for others.
pub(super) fn constant(expression: Sym) -> Option<f64> {
    let is_constant = expression.symbols_of().into_iter().all(|own| vanishes(expression.diff(own)));
    expression.evaluate(&|_| Some(ANYWHERE)).ok().filter(|_| is_constant)
}

/// Value for letters on which the result does not depend.
const ANYWHERE: f64 = 0.377;

/// Constants below this size may be zero.
const ROUNDING: f64 = 1e-12;

/// Whether an expression is linear in a letter, with a factor that is not zero.
pub(super) fn is_linear(expression: Sym, letter: Sym) -> bool {
    let slope = expression.diff(letter);
    !(slope.symbols_of().contains(&letter) || vanishes(slope))
}

/// Whether the law is continuous where a condition is zero: proved if the condition is linear in a letter, otherwise identified. A jump multiplied
/// by another condition's letter is zero if that condition fails there, as in the middle of a backlash.
fn is_continuous(rows: &Rows, values: &[Sym], (letter, value): (Sym, Sym)) -> bool {
    let jumps: Vec<Sym> = rows.residuals.iter().map(|row| row.diff(letter)).filter(|jump| !vanishes(*jump)).collect();
    let others = || rows.condition_letters.iter().zip(values).filter(|(other, _)| **other != letter);
    let linear: Vec<Sym> = value.symbols_of().into_iter().filter(|own| is_linear(value, *own)).collect();
    if linear.is_empty() {
        let others: Vec<(Sym, Sym)> = others().map(|(own, value)| (*own, *value)).collect();
        return vanish_there(&jumps, value, &others, false);
    }
    linear.into_iter().any(|own| {
        let slope = value.diff(own);
        let there = [(own, own - value / slope)];
        let mut cases: Vec<(Sym, Sym)> = Vec::new();
        for (&other, of_other) in others() {
            match constant(of_other.substitute(&there)) {
                Some(number) if number > ROUNDING => cases.push((other, Sym::ONE)),
                Some(number) if number < -ROUNDING => cases.push((other, Sym::ZERO)),
                _ => {}
            }
        }
        jumps.iter().all(|jump| vanishes(jump.substitute(&there).substitute(&cases)))
    })
}
