//! Equations of motion without accelerations, one for each speed, over letters of the model.
//!
//! Constraints of speeds determine some speeds by the others, u_D = B(q) u_I + b(q). In a steady motion the independent speeds u_I are
//! constant. With u_I' = 0 and u_D' = du_D/dq q', the equations along the displacements that these constraints allow,
//!
//!   r_I + B^T r_D = 0 ,
//!
//! contain no reactions (Maggi). A determined speed must be zero if its coordinate occurs in the equations; otherwise it may change: a disc that
//! rolls in a circle moves steadily.

use super::NoSteadyMotions;
use super::determinacy::{Solution, Wanted, solutions};
use super::potential::{EnergyIntegral, energy_integral, momenta_kept};
use super::values::has_value;
use crate::letters::Letters;
use crate::modes::NEGATIVE;
use model::equations::{Equation, Level, Residuals, constraints_of, implied_constraints, vanishes};
use model::{Contact, Model, Sides, Trace};
use symbolic::{Sym, substitute_all};

/// The equations with the data of the file.
pub(super) struct Rows {
    /// One for each speed; zero if it is satisfied identically.
    pub residuals: Vec<Sym>,
    /// Constraints of positions, and their functions.
    pub constraints: Vec<Equation>,
    pub zeros: Vec<Sym>,
    /// Constraints that were left out, since they follow from others near the start.
    pub implied: Vec<Sym>,
    /// Conditions at which the law changes, then the gaps of contacts; and the letters that are 1 where the first are positive and 0 where
    /// they are negative.
    pub conditions: Vec<Sym>,
    pub condition_letters: Vec<Sym>,
    /// Contacts with the letters of their reactions.
    pub contacts: Vec<Touching>,
    /// Speeds that constraints of speeds determine, by the others.
    pub determined: Vec<(usize, Sym)>,
    /// Coordinates on which nothing depends.
    pub is_cyclic: Vec<bool>,
    /// Those on which nothing depends at any values of the parameters, if there are no constraints of speeds.
    pub is_always_cyclic: Vec<bool>,
    /// The energy that is kept where the loads have a potential energy, no constraint holds speeds, and no contact rubs.
    pub energy_integral: Option<EnergyIntegral>,
    /// Coordinates with conserved momenta, if there are no constraints of speeds.
    pub kept_momenta: Vec<usize>,
    /// Whether the constraints determine these speeds at the state of the request.
    pub is_regular: bool,
    /// The largest number of cyclic coordinates for any choice of independent speeds.
    pub most_cyclic: usize,
}

/// A contact that may be in touch.
#[derive(Clone, Debug)]
pub(super) struct Touching {
    /// Letters of N, then of T along each tangent.
    pub reactions: Vec<Sym>,
    /// The coefficient of friction; none for a smooth contact, also where the coefficient is zero.
    pub friction: Option<Sym>,
    /// Whether the contact may open.
    pub is_one_sided: bool,
    /// Whether an impact may leave a velocity along the normal.
    pub bounces: bool,
    /// The sliding velocity along each tangent.
    pub slides: Vec<Sym>,
}

/// The reason for which an equation has no value anywhere.
const WITHOUT_VALUE: &str = "one has none at any point that was tried, as where a number is divided by zero, or the root of a negative one is taken";

/// In systems with more coordinates a coordinate counts as cyclic only if it does not occur in the expressions.
const MOST_DECIDED: usize = 12;

impl Rows {
    /// The equations; wanted speeds remain independent, and the determined speeds are such as constraints determine at the state.
    pub fn of(model: &Model, trace: &Trace<'_>, wanted: &Wanted<'_>) -> Result<Self, NoSteadyMotions> {
        let is_kept = |one: &Equation| one.gains.is_none() && one.law.is_none();
        let (constraints, of_speeds): (Vec<Equation>, Vec<Equation>) =
            constraints_of(trace).into_iter().partition(|one| one.level == Level::Position);
        if let Some(one) = constraints.iter().chain(&of_speeds).find(|one| !is_kept(one)) {
            return Err(NoSteadyMotions::OfSpeeds { at: one.at.clone() });
        }
        let equations = Residuals::of(trace).into_iter().next().ok_or(NoSteadyMotions::Singular)?;
        let state = [&trace.coordinates[..], &trace.speeds].concat();
        // letters for everything that moves
        let letters = Letters::with_decimals(trace.time, &state);
        let put = |all: &[Sym]| letters.put_into(trace, all);
        let residuals = put(&equations.residuals[..model.speeds()]);
        let start = state.iter().zip(model.start_state()).map(|(letter, value)| (letter.to_string(), value));
        let start: Vec<(String, f64)> = start.collect();
        if !residuals.iter().all(|row| has_value(*row, &start)) {
            return Err(NoSteadyMotions::Undefined { why: WITHOUT_VALUE.to_owned() });
        }
        let zeros = put(&constraints.iter().map(|one| one.zero).collect::<Vec<_>>());
        let implied = put(&implied_constraints(trace));
        let energy = put(&[trace.kinetic_energy()])[0];
        let plain = |row: Sym| if vanishes(row) { Sym::ZERO } else { row };
        let gaps = model.contacts.iter().map(|contact| contact.gap);
        let conditions: Vec<Sym> = model.switches.iter().copied().chain(gaps).map(|own| trace.scalar(own)).collect();
        let conditions = put(&conditions);
        let touching = |(place, contact): (usize, &Contact)| Touching {
            reactions: (0..contact.reactions.len()).map(|component| trace.reaction(place, component)).collect(),
            friction: contact.friction.map(|friction| put(&[trace.scalar(friction)])[0]).filter(|own| !vanishes(*own)),
            is_one_sided: contact.sides == Sides::One,
            bounces: contact.restitution.is_some_and(|restitution| !vanishes(put(&[trace.scalar(restitution)])[0])),
            slides: put(&contact.slides.iter().map(|&slide| trace.scalar(slide)).collect::<Vec<_>>()),
        };
        let contacts: Vec<Touching> = model.contacts.iter().enumerate().map(touching).collect();
        let smooth = contacts.iter().filter(|contact| contact.friction.is_none());
        let smooth: Vec<(Sym, Sym)> =
            smooth.flat_map(|own| own.reactions.iter().skip(1).map(|own| (*own, Sym::ZERO))).collect();
        let residuals = substitute_all(&residuals, &smooth);
        let is_negative = |own: &Touching| {
            own.friction.is_some_and(|own| own.as_constant().and_then(|value| value.sign()) == Some(-1))
        };
        if contacts.iter().any(is_negative) {
            return Err(NoSteadyMotions::Undefined { why: NEGATIVE.to_owned() });
        }
        // no potential depends on it
        let potential = put(&[trace.potential_energy()])[0];
        let is_held = |own: &Sym| {
            zeros.iter().chain([&potential]).any(|zero| zero.symbols_of().contains(own) && !vanishes(zero.diff(*own)))
        };
        let most_cyclic = trace.coordinates.iter().filter(|own| !is_held(own)).count();
        let with = |residuals: Vec<Sym>, determined: Vec<(usize, Sym)>, is_regular: bool| {
            let mut rows = Rows {
                residuals: residuals.into_iter().map(plain).collect(),
                constraints: constraints.clone(),
                zeros: zeros.clone(),
                implied: moving(trace, &implied, &determined),
                conditions: moving(trace, &conditions, &determined),
                condition_letters: trace.switches.clone(),
                contacts: contacts
                    .iter()
                    .map(|own| Touching { slides: moving(trace, &own.slides, &determined), ..own.clone() })
                    .collect(),
                determined,
                is_cyclic: vec![true; model.speeds()],
                is_always_cyclic: vec![true; model.speeds()],
                energy_integral: None,
                kept_momenta: Vec::new(),
                is_regular,
                most_cyclic,
            };
            rows.find_cyclic(trace);
            rows
        };
        if of_speeds.is_empty() {
            let resting = at_rest(trace, residuals, &[]);
            let energy_integral = energy_integral(trace, &resting, energy, &constraints);
            let kept_momenta = momenta_kept(trace, &resting, energy);
            let rows = with(resting, Vec::new(), true);
            let all =
                [&equations.residuals[..model.speeds()], &constraints.iter().map(|one| one.zero).collect::<Vec<_>>()];
            let is_always_cyclic = always_cyclic(trace, &rows.is_cyclic, &all.concat());
            return Ok(Rows { energy_integral, kept_momenta, is_always_cyclic, ..rows });
        }
        let solved = solutions(trace, (&of_speeds, &residuals, &zeros), wanted, put)
            .ok_or_else(|| NoSteadyMotions::OfSpeeds { at: of_speeds[0].at.clone() })?;
        let all = solved.into_iter().map(|Solution { determined, is_regular }| {
            let rows = projected(trace, &residuals, &of_speeds, &determined);
            with(rows, determined, is_regular)
        });
        // the first choice with the largest number of cyclic coordinates
        let mut best: Option<Rows> = None;
        for next in all {
            let reached = next.cyclic_count() >= most_cyclic;
            best = Some(match best {
                Some(best) if best.cyclic_count() >= next.cyclic_count() => best,
                _ => next,
            });
            if reached {
                break;
            }
        }
        best.ok_or_else(|| NoSteadyMotions::OfSpeeds { at: of_speeds[0].at.clone() })
    }

    /// The number of coordinates on which nothing depends.
    pub fn cyclic_count(&self) -> usize {
        self.is_cyclic.iter().filter(|cyclic| **cyclic).count()
    }

    /// Finds coordinates on which nothing depends. The rate of one that is determined, and on which something depends, is one more row.
    fn find_cyclic(&mut self, trace: &Trace<'_>) {
        loop {
            let held: Vec<(usize, Sym)> =
                self.determined.iter().copied().filter(|&(place, _)| !self.is_cyclic[place]).collect();
            let slides = self.contacts.iter().filter(|own| own.friction.is_some()).flat_map(|own| &own.slides);
            let own = self.residuals.iter().chain(&self.zeros).chain(&self.conditions).chain(slides).copied();
            let rows: Vec<Sym> = own.chain(held.iter().map(|(_, rate)| *rate)).collect();
            let depends = |symbol: Sym| {
                let decides = trace.coordinates.len() <= MOST_DECIDED;
                let holds = |row: &&Sym| row.symbols_of().contains(&symbol);
                rows.iter().filter(holds).any(|row| !decides || !vanishes(row.diff(symbol)))
            };
            let is_cyclic: Vec<bool> = trace.coordinates.iter().map(|&symbol| !depends(symbol)).collect();
            let is_settled = is_cyclic == self.is_cyclic;
            self.is_cyclic = is_cyclic;
            if is_settled {
                held.into_iter().for_each(|(place, rate)| self.residuals[place] = rate);
                break;
            }
        }
        // nothing depends on them: any value will do
        let cyclic = trace.coordinates.iter().zip(&self.is_cyclic).filter(|(_, cyclic)| **cyclic);
        let none: Vec<(Sym, Sym)> = cyclic.map(|(symbol, _)| (*symbol, Sym::ZERO)).collect();
        self.residuals = substitute_all(&self.residuals, &none);
        self.zeros = substitute_all(&self.zeros, &none);
        self.implied = substitute_all(&self.implied, &none);
        self.conditions = substitute_all(&self.conditions, &none);
        self.contacts.iter_mut().for_each(|contact| contact.slides = substitute_all(&contact.slides, &none));
        let rates: Vec<Sym> = self.determined.iter().map(|(_, rate)| *rate).collect();
        self.determined.iter_mut().zip(substitute_all(&rates, &none)).for_each(|(own, rate)| own.1 = rate);
    }
}

/// Which cyclic coordinates are in no expression at any values of the parameters.
fn always_cyclic(trace: &Trace<'_>, is_cyclic: &[bool], rows: &[Sym]) -> Vec<bool> {
    let free = |symbol: Sym| {
        rows.iter().filter(|row| row.symbols_of().contains(&symbol)).all(|row| vanishes(row.diff(symbol)))
    };
    is_cyclic.iter().zip(&trace.coordinates).map(|(is_cyclic, symbol)| *is_cyclic && free(*symbol)).collect()
}

/// An expression without the letters on which its value does not depend, as x in x cos a sin a - x sin a cos a with the angle a of a slope:
/// over a range of x its enclosure is as wide as each term.
pub(super) fn without_idle(row: Sym, letters: &[Sym]) -> Sym {
    if letters.len() > MOST_DECIDED {
        return row;
    }
    let own = row.symbols_of();
    let idle: Vec<&Sym> =
        letters.iter().filter(|letter| own.contains(letter) && vanishes(row.diff(**letter))).collect();
    if idle.is_empty() {
        return row;
    }
    let rest = row.substitute(&idle.into_iter().map(|letter| (*letter, Sym::ZERO)).collect::<Vec<_>>());
    let has_value = rest.evaluate(&|_| Some(ANYWHERE)).is_ok_and(|value: f64| value.is_finite());
    if has_value { rest } else { row }
}

/// A value of letters at which an expression is likely to be defined.
const ANYWHERE: f64 = 0.377;

/// The expressions with the determined speeds replaced by the independent ones.
fn moving(trace: &Trace<'_>, all: &[Sym], determined: &[(usize, Sym)]) -> Vec<Sym> {
    substitute_all(all, &determined.iter().map(|&(k, rate)| (trace.speeds[k], rate)).collect::<Vec<_>>())
}

/// The rows with zero accelerations, except for some.
fn at_rest(trace: &Trace<'_>, rows: Vec<Sym>, but: &[(Sym, Sym)]) -> Vec<Sym> {
    let rests = trace.accelerations.iter().map(|symbol| (*symbol, Sym::ZERO));
    substitute_all(&rows, &but.iter().copied().chain(rests).collect::<Vec<_>>())
}

/// The equations along displacements that constraints of speeds allow.
fn projected(trace: &Trace<'_>, residuals: &[Sym], of_speeds: &[Equation], determined: &[(usize, Sym)]) -> Vec<Sym> {
    let n = trace.speeds.len();
    let known: Vec<(Sym, Sym)> = determined.iter().map(|&(k, rate)| (trace.speeds[k], rate)).collect();
    let rate_of = |k: usize| substitute_all(&[trace.speeds[k]], &known)[0];
    let moved: Vec<(Sym, Sym)> = determined
        .iter()
        .map(|&(k, rate)| {
            let along = (0..n).map(|j| rate.diff(trace.coordinates[j]) * rate_of(j));
            (trace.accelerations[k], along.fold(Sym::ZERO, |sum, each| sum + each))
        })
        .collect();
    let reactions = of_speeds.iter().map(|one| (one.multiplier, Sym::ZERO));
    let all = at_rest(trace, residuals.to_vec(), &moved.into_iter().chain(reactions).collect::<Vec<_>>());
    let all = substitute_all(&all, &known);
    let along = |i: usize| match determined.iter().any(|(k, _)| *k == i) {
        true => Sym::ZERO,
        false => {
            let by = determined.iter().map(|&(k, rate)| rate.diff(trace.speeds[i]) * all[k]);
            by.fold(all[i], |sum, each| sum + each)
        }
    };
    (0..n).map(along).collect()
}
