//! Equations of motion without accelerations, one for each speed, symbolically.
//!
//! Constraints of speeds determine the dependent speeds u_D = B(q) u_I + b(q). In a steady motion the independent speeds u_I are constant. With
//! u_I' = 0 and u_D' = du_D/dq q', the equations along the displacements that these constraints allow are (Maggi)
//!
//!   r_I + B^T r_D = 0 ;
//!
//! they contain no reactions. A dependent speed must be zero if its coordinate occurs in the equations. Otherwise it may vary: a disc that rolls
//! in a circle moves steadily.

use super::NoSteadyMotions;
use super::determinacy::{Solution, Wanted, solutions};
use super::potential::{EnergyIntegral, energy_integral, momenta_kept};
use super::values::has_value;
use crate::letters::Letters;
use crate::modes::NEGATIVE;
use model::equations::{Equation, Level, Residuals, constraints_of, implied_constraints, vanishes};
use model::{Contact, Model, Sides, Trace};
use symbolic::{Sym, substitute_all};

/// The equations of steady motion with the numbers of the file.
pub(super) struct Rows {
    /// One residual for each speed; zero if the equation holds identically.
    pub residuals: Vec<Sym>,
    /// The constraints of positions; `zeros` are their residuals.
    pub constraints: Vec<Equation>,
    pub zeros: Vec<Sym>,
    /// The residuals of constraints that were removed, since they follow from others near the start.
    pub implied: Vec<Sym>,
    /// The conditions at which the law changes, then the gaps of contacts. `condition_letters` are the letters of the conditions: 1 where a condition is
    /// positive, 0 where it is negative.
    pub conditions: Vec<Sym>,
    pub condition_letters: Vec<Sym>,
    /// The contacts of the model.
    pub contacts: Vec<Touching>,
    /// The dependent speeds: index, and expression in the independent speeds.
    pub determined: Vec<(usize, Sym)>,
    /// For each coordinate, whether it occurs in no expression.
    pub is_cyclic: Vec<bool>,
    /// For each coordinate, whether this holds for all values of the parameters; meaningful only without constraints of speeds.
    pub is_always_cyclic: Vec<bool>,
    /// The energy integral, if the loads have a potential energy and there are no constraints of speeds.
    pub energy_integral: Option<EnergyIntegral>,
    /// The indices of coordinates with conserved momenta, if there are no constraints of speeds.
    pub kept_momenta: Vec<usize>,
    /// Whether the constraints determine the dependent speeds at the state of [`Wanted`].
    pub is_regular: bool,
    /// The largest number of cyclic coordinates that any choice of independent speeds could give.
    pub most_cyclic: usize,
}

/// A contact, with the expressions for the case that it is closed.
#[derive(Clone, Debug)]
pub(super) struct Touching {
    /// The letters of the normal reaction, then of the tangential ones.
    pub reactions: Vec<Sym>,
    /// The coefficient of friction; `None` for a smooth contact.
    pub friction: Option<Sym>,
    /// Whether the contact can open.
    pub is_one_sided: bool,
    /// Whether its coefficient of restitution is not zero.
    pub bounces: bool,
    /// The sliding velocity along each tangent.
    pub slides: Vec<Sym>,
}

/// The reason for refusal if an equation is undefined at all points that were tried.
const WITHOUT_VALUE: &str = "one has none at any point that was tried, as where a number is divided by zero, or the root of a negative one is taken";

/// In systems with more coordinates, a coordinate counts as cyclic only if it does not occur formally.
const MOST_DECIDED: usize = 12;

impl Rows {
    /// The equations of a model. Wanted speeds stay independent if possible; among several choices, that with most cyclic coordinates is taken.
    pub fn of(model: &Model, trace: &Trace<'_>, wanted: &Wanted<'_>) -> Result<Self, NoSteadyMotions> {
        let is_kept = |one: &Equation| one.gains.is_none() && one.law.is_none();
        let (constraints, of_speeds): (Vec<Equation>, Vec<Equation>) =
            constraints_of(trace).into_iter().partition(|one| one.level == Level::Position);
        if let Some(one) = constraints.iter().chain(&of_speeds).find(|one| !is_kept(one)) {
            return Err(NoSteadyMotions::OfSpeeds { at: one.at.clone() });
        }
        let equations = Residuals::of(trace).into_iter().next().ok_or(NoSteadyMotions::Singular)?;
        let state = [&trace.coordinates[..], &trace.speeds].concat();
        // coordinates and speeds stay letters, parameters become numbers
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
        // a coordinate in the potential or in a position constraint cannot be cyclic
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

    /// The number of cyclic coordinates.
    pub fn cyclic_count(&self) -> usize {
        self.is_cyclic.iter().filter(|cyclic| **cyclic).count()
    }

    /// Finds the cyclic coordinates. If the coordinate of a dependent speed is not cyclic, this speed must be zero, which is a further equation.
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
        // the values of cyclic coordinates do not matter
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

/// For each coordinate, whether it is cyclic for all values of the parameters.
fn always_cyclic(trace: &Trace<'_>, is_cyclic: &[bool], rows: &[Sym]) -> Vec<bool> {
    let free = |symbol: Sym| {
        rows.iter().filter(|row| row.symbols_of().contains(&symbol)).all(|row| vanishes(row.diff(symbol)))
    };
    is_cyclic.iter().zip(&trace.coordinates).map(|(is_cyclic, symbol)| *is_cyclic && free(*symbol)).collect()
}

/// The expression without letters on which its value does not depend, such as x in x cos a sin a - x sin a cos a with a slope a; otherwise
/// the enclosure over a range of x would be as wide as each term.
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

/// A value for all letters, at which an expression is likely to be defined.
const ANYWHERE: f64 = 0.377;

/// Expressions with the dependent speeds in terms of the independent ones.
fn moving(trace: &Trace<'_>, all: &[Sym], determined: &[(usize, Sym)]) -> Vec<Sym> {
    substitute_all(all, &determined.iter().map(|&(k, rate)| (trace.speeds[k], rate)).collect::<Vec<_>>())
}

/// Rows with the accelerations `but` as given and all others zero.
fn at_rest(trace: &Trace<'_>, rows: Vec<Sym>, but: &[(Sym, Sym)]) -> Vec<Sym> {
    let rests = trace.accelerations.iter().map(|symbol| (*symbol, Sym::ZERO));
    substitute_all(&rows, &but.iter().copied().chain(rests).collect::<Vec<_>>())
}

/// The equations along displacements that the constraints of speeds allow (Maggi). `residuals` has one equation for each speed; `of_speeds` are the
/// constraints of speeds, whose reactions are set to zero. A pair (k, rate) of `determined` says that a constraint determines speed k as the expression
/// `rate` of the independent speeds. The result has one row for each speed, which is zero for a determined one.
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
