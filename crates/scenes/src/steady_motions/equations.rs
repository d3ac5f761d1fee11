//! The equations of steady motion of a model: the residuals of its equations of motion with zero accelerations, and its constraints. All speeds
//! are zero, except those of cyclic coordinates, w:
//!
//!   J^T lambda - h(q, w) = 0 ,    f(q) = 0 .

use super::admission::{at_rest, checked, checked_but_for_cases};
use super::angle_sums::AngleSums;
use super::circles::is_periodic;
use super::conditions::{Case, Laws};
use super::determinacy::Wanted;
use super::energy_row::implied;
use super::families::Identity;
use super::friction::{AtRest, FrictionLaw};
use super::momenta::momenta;
use super::orientations::steep;
use super::potential::EnergyIntegral;
use super::quasi_velocities::{is_integral, state_names};
use super::rows::{Rows, without_idle};
use super::surplus::Selection;
use super::tapes::{self, Expressions, Tapes};
use super::{NoSteadyMotions, Range, SteadySearch};
use field::{Interval, Rational};
use model::equations::vanishes;
use model::{Model, Trace};
use std::f64::consts::PI;
use symbolic::{Dimension, Sym, Tape, substitute_all};

/// An unknown of the search: a coordinate, the constant speed of a cyclic one, or a factor of a condition or friction.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// The name: that of the coordinate or speed in the state, such as `theta` or `phi'`.
    pub name: String,
    /// The index in the state; a factor has an index behind the state.
    pub place: usize,
    /// Whether it is an angle that is searched over a whole turn.
    pub is_circle: bool,
    /// The searched range in SI units.
    pub range: Range,
}

/// The equations of steady motion, compiled for the search.
#[derive(Debug)]
pub(super) struct SteadyEquations {
    pub unknowns: Vec<Unknown>,
    /// Names and values of the fixed components of the state: coordinates with given values, and speeds of cyclic coordinates.
    pub given: Vec<(String, f64)>,
    /// The names of the cyclic coordinates, which occur in no equation.
    pub cyclic: Vec<String>,
    /// The names of coordinates that are cyclic only for the given values of the parameters.
    pub cyclic_by_values: Vec<String>,
    /// The indices of the cyclic coordinates.
    pub cyclic_places: Vec<usize>,
    /// Index and name of each cyclic coordinate whose momentum is conserved.
    pub kept_momenta: Vec<(usize, String)>,
    /// The state with the given values; unknowns are not filled in.
    pub state: Vec<f64>,
    /// The number of reactions (multipliers), which the equations determine together with the unknowns.
    pub reactions: usize,
    /// The conserved energy, if all loads have a potential.
    pub energy_integral: Option<EnergyIntegral>,
    /// Whether dampers dissipate energy and all other loads have a potential.
    pub decays: bool,
    /// Whether an equation without unknowns does not hold, so that there is no steady motion.
    pub is_unbalanced: bool,
    /// The number of unknowns that are coordinates.
    pub coordinates: usize,
    /// The number of equations that are solved.
    pub rows: usize,
    /// For each expression with a required sign, whether it must be positive; otherwise negative.
    pub holds: Vec<bool>,
    /// For each of these expressions, the index of its case in the combination, or [`NO_CASE`].
    pub side_places: Vec<usize>,
    /// The combination of cases of conditions and contacts.
    pub cases: Vec<Case>,
    /// Whether the combination contains a condition that is zero.
    pub is_at_condition: bool,
    /// The indices, in the combination, of closed contacts with friction.
    pub rubbing: Vec<usize>,
    /// The law of dry friction if the system is at rest in all its steady motions.
    pub friction: Option<FrictionLaw>,
    /// For each condition of the law 1 if it holds, otherwise 0.
    pub switches: Vec<f64>,
    /// Linear identities between the equations, if they contain no reactions.
    pub identities: Vec<Identity>,
    /// The names of given speeds that occur in no equation; for any other value of such a speed there are steady motions, too.
    pub free_speeds: Vec<String>,
    /// The derivatives of the momenta of cyclic coordinates by the unknowns, row by row, then by their speeds. `None` if they contain other
    /// quantities or there are constraints of speeds.
    pub momenta: Option<Tape>,
    /// The mass matrix as a function of the unknowns, row by row; `None` if it contains other quantities.
    pub masses: Option<Tape>,
    /// The compiled equations for the search.
    pub tapes: Tapes,
    /// For a single equation with one unknown: the equation and its derivatives.
    pub derivatives: Option<Tape>,
    /// The equations with sums of angles as unknowns, if these are simpler.
    pub by_sums: Option<(AngleSums, Tapes)>,
    /// The indices in the state of speeds that constraints of speeds determine, and these speeds as functions of the unknowns.
    pub determined: (Vec<usize>, Tape),
}

impl SteadyEquations {
    pub fn of(model: &Model, asked: &SteadySearch) -> Result<Self, NoSteadyMotions> {
        checked(model)?;
        symbolic::apart(|| Self::written(model, asked, (None, false), &[]))
    }

    /// The equations in one combination of cases of the conditions and contacts.
    pub fn in_cases(model: &Model, asked: &SteadySearch, cases: &[Case]) -> Result<Self, NoSteadyMotions> {
        symbolic::apart(|| Self::written(model, asked, (None, false), cases))
    }

    /// The equations for one motion: all coordinates fixed to `state` if the equations then hold identically except for reactions; otherwise in
    /// a neighbourhood of `state`. Speeds of cyclic coordinates are those of `state` unless an equation determines them.
    pub fn near(model: &Model, state: &[f64], cases: &[Case]) -> Result<Self, NoSteadyMotions> {
        checked_but_for_cases(model)?;
        let written = |is_pinned| Self::written(model, &SteadySearch::default(), (Some(state), is_pinned), cases);
        let is_square = |own: &Self| {
            own.is_unbalanced || own.rows == own.unknowns.len() + own.reactions && own.tapes.surplus.outputs() == 0
        };
        symbolic::apart(|| {
            let pinned = written(true).ok().filter(|own| !own.is_unbalanced && is_square(own));
            let own = pinned.map_or_else(|| written(false), Ok)?;
            let counts = [own.rows + own.tapes.surplus.outputs(), own.unknowns.len() + own.reactions];
            if is_square(&own) { Ok(own) } else { Err(NoSteadyMotions::Unequal { counts, idle: Vec::new() }) }
        })
    }

    /// The equations in the expression graph of the thread. Numbers are exact decimals as written, so that sums such as k1 + k2 - k3 are exact.
    fn written(
        model: &Model,
        asked: &SteadySearch,
        (near, is_pinned): (Option<&[f64]>, bool),
        cases: &[Case],
    ) -> Result<Self, NoSteadyMotions> {
        let trace = Trace::of(model);
        let n = trace.speeds.len();
        let names = state_names(model);
        let is_asked =
            |k: &usize| is_integral(model, *k) || asked.ranges.iter().any(|(name, _)| *name == names[n + *k]);
        let start = model.start_state();
        let free = (0..n).filter(is_asked).collect();
        let wanted = Wanted { free, state: near.unwrap_or(&start), is_near: near.is_some() };
        let mut rows = Rows::of(model, &trace, &wanted)?;
        // the residuals of a steadily rotated frame depend on time only formally
        let all = rows.residuals.iter_mut().chain(&mut rows.zeros).chain(&mut rows.conditions);
        all.for_each(|row| *row = without_idle(*row, &[trace.time]));
        let all = [&rows.residuals[..], &rows.zeros, &rows.conditions].concat();
        if all.iter().any(|row| row.symbols_of().contains(&trace.time)) {
            return Err(NoSteadyMotions::OfTime);
        }
        let is_cyclic = &rows.is_cyclic;
        let is_determined = |k: usize| rows.determined.iter().any(|(place, _)| *place == k);
        asked.checked(
            (0..n)
                .filter(|&k| !(is_cyclic[k] && is_determined(k)))
                .map(|k| names[if is_cyclic[k] { n + k } else { k }].as_str()),
        )?;
        let at_rest = at_rest(&trace, is_cyclic);
        let plain = |row: Sym| if vanishes(row) { Sym::ZERO } else { row };
        let mut residuals: Vec<Sym> = substitute_all(&rows.residuals, &at_rest).into_iter().map(plain).collect();
        let least = |range: Range| if range.from * range.to > 0.0 { range.from.abs().min(range.to.abs()) } else { 0.0 };
        let speed = |k: usize| near.map(|state| state[n + k]).or_else(|| asked.range(&names[n + k]).map(least));
        if let Some(k) = implied(model, &trace, &rows, speed) {
            residuals[k] = Sym::ZERO;
        }
        // the speed of a cyclic coordinate is an unknown if the equation of the coordinate depends on it; otherwise the user or the start gives it
        let mut state = near.map_or_else(|| model.start_state(), <[f64]>::to_vec);
        state[..n].iter_mut().zip(is_cyclic).filter(|(_, cyclic)| **cyclic).for_each(|(value, _)| *value = 0.0);
        let (mut unknowns, mut given, mut known) = (Vec::new(), Vec::new(), Vec::new());
        let (mut without_range, mut valued) = (Vec::new(), Vec::new());
        for k in (0..n).filter(|&k| !(is_cyclic[k] && is_determined(k))) {
            let (symbol, place, is_sought) = match is_cyclic[k] {
                false => (trace.coordinates[k], k, !is_pinned),
                true => {
                    // the equation depends on speeds, or on quantities that the other equations determine from this speed
                    let asks = residuals[k].symbols_of().iter().any(|symbol| trace.speeds.contains(symbol))
                        || residuals[k] != Sym::ZERO
                            && residuals.iter().any(|row| row.symbols_of().contains(&trace.speeds[k]));
                    (trace.speeds[k], n + k, asks && !is_pinned && asked.speed(&names[n + k]).is_none())
                }
            };
            let name = names[place].clone();
            if is_cyclic[k] {
                state[place] = asked.speed(&name).unwrap_or(state[place]);
            } else {
                state[n + k] = 0.0;
            }
            // the argument of a sine may be a length, whose range is not a turn
            let is_angle = model.coordinates.get(k).is_none_or(|own| own.dimension == Dimension::none());
            let is_circle =
                near.is_none() && is_angle && !is_cyclic[k] && all.iter().all(|row| is_periodic(*row, symbol));
            let beside = near.filter(|_| is_sought).map(|state| Range::about(state[place]));
            match asked.range(&name).or(beside) {
                Some(range) if range.is_point() => {
                    state[place] = range.from;
                    valued.push((symbol, name.clone(), range.from));
                    known.push((symbol, number(range.from)));
                    given.push((name, range.from));
                }
                // a range of more than a turn would contain positions twice
                Some(range) if is_circle && range.to - range.from >= 2.0 * PI => {
                    unknowns.push((symbol, Unknown { name, place, is_circle, range: Range::TURN }));
                }
                Some(range) => unknowns.push((symbol, Unknown { name, place, is_circle: false, range })),
                None if is_sought && is_circle => {
                    unknowns.push((symbol, Unknown { name, place, is_circle, range: Range::TURN }));
                }
                None if is_sought => without_range.push(name),
                _ => {
                    known.push((symbol, number(state[place])));
                    given.push((name, state[place]));
                }
            }
        }
        let Laws { known: of_cases, unknowns: shares, touching, forces, mut sides, at_zero } =
            Laws::of(&rows, cases, &at_rest, 2 * n);
        sides.extend(steep(&trace, &names, asked, is_cyclic).into_iter().map(|side| (side, true, NO_CASE)));
        known.extend(of_cases);
        unknowns.extend(shares);
        if !without_range.is_empty() {
            return Err(NoSteadyMotions::WithoutRange { names: without_range });
        }
        let (letters, unknowns): (Vec<Sym>, Vec<Unknown>) = unknowns.into_iter().unzip();
        let multipliers: Vec<Sym> =
            rows.constraints.iter().map(|one| one.multiplier).chain(touching.iter().copied()).collect();
        let inputs = [&letters[..], &multipliers].concat();
        let put = |rows: &[Sym]| -> Vec<Sym> {
            let rows = substitute_all(&substitute_all(rows, &forces), &known);
            match () {
                () if !cases.is_empty() => rows.into_iter().map(|row| without_idle(plain(row), &inputs)).collect(),
                () if is_pinned => rows.into_iter().map(plain).collect(),
                () => rows,
            }
        };
        let rests =
            state[n..].iter().all(|speed| *speed == 0.0) && unknowns.iter().all(|own| !(n..2 * n).contains(&own.place));
        let rest =
            AtRest { speeds: &trace.speeds, residuals: &residuals, letters: &letters, multipliers: &multipliers };
        let friction = FrictionLaw::of(&rows, cases, &rest, &put).filter(|_| rests);
        let asking_all = [&residuals[..], &rows.zeros].concat();
        let (residuals, zeros, at_zero) = (put(&residuals), put(&rows.zeros), put(&at_zero));
        // for a combination of cases a row may contain sines and cosines whose combination is constant
        let is_constant = |row: &Sym| match cases.is_empty() {
            true => row.as_constant().is_some(),
            false => row.symbols_of().into_iter().all(|own| vanishes(row.diff(own))),
        };
        let is_open = |row: &Sym| *row != Sym::ZERO && is_constant(row);
        let open = asking_all.iter().zip(residuals.iter().chain(&zeros)).filter(|(_, row)| is_open(row));
        let side_places = sides.iter().map(|(.., place)| *place).collect();
        let letters_of: Vec<Sym> = open.flat_map(|(row, _)| row.symbols_of()).collect();
        if let Some((_, name, value)) = valued.into_iter().find(|(symbol, ..)| letters_of.contains(symbol)) {
            return Err(NoSteadyMotions::Sought { name, value });
        }
        let asking: Vec<usize> = (0..n).filter(|&k| residuals[k] != Sym::ZERO).collect();
        let zeros_put = zeros.clone();
        let zeros: Vec<Sym> = zeros.into_iter().filter(|zero| *zero != Sym::ZERO).collect();
        // an equation with a constant that is not zero, such as an unbalanced load
        let is_unbalanced = residuals.iter().chain(&at_zero).any(is_open);
        let zeros: Vec<Sym> = zeros.into_iter().chain(at_zero.into_iter().filter(|zero| *zero != Sym::ZERO)).collect();
        let counts = [asking.len() + zeros.len(), unknowns.len() + multipliers.len()];
        let idle = |k: &usize| !is_cyclic[*k] && residuals[*k] == Sym::ZERO;
        let idle: Vec<String> = (0..n).filter(idle).map(|k| names[k].clone()).collect();
        if counts[0] > counts[1] && !idle.is_empty() && !is_unbalanced {
            return Err(NoSteadyMotions::Unequal { counts, idle });
        }
        // an equation that becomes trivial at the given values may fail at others
        let is_lost = |(before, after): (&Sym, &Sym)| *before != Sym::ZERO && *after == Sym::ZERO;
        let keeps_all = !asking_all.iter().zip(residuals.iter().chain(&zeros_put)).any(is_lost);
        let switches =
            |k: usize| rows.conditions.iter().any(|condition| condition.symbols_of().contains(&trace.speeds[k]));
        let is_free = |&k: &usize| {
            !switches(k)
                && is_cyclic[k]
                && !is_determined(k)
                && !unknowns.iter().any(|unknown: &Unknown| unknown.place == n + k)
        };
        let free_speeds =
            (0..n).filter(is_free).filter(|_| keeps_all && near.is_none()).map(|k| names[n + k].clone()).collect();
        let along: Vec<String> =
            asking.iter().map(|&k| if is_integral(model, k) { &names[n + k] } else { &names[k] }.clone()).collect();
        let residuals: Vec<Sym> = asking.into_iter().map(|k| residuals[k]).collect();
        let without: Vec<(Sym, Sym)> = multipliers.iter().map(|letter| (*letter, Sym::ZERO)).collect();
        let reactions = residuals.iter().flat_map(|row| multipliers.iter().map(|&by| row.diff(by)));
        let loads: Vec<Sym> = reactions.chain(substitute_all(&residuals, &without)).collect();
        let Selection { solved: values, surplus } = Selection::of([residuals, zeros].concat(), &inputs, &unknowns);
        let identities = match multipliers.is_empty() && near.is_none() && surplus.is_empty() {
            true => Identity::of(&values, (&letters, &unknowns), &along),
            false => Vec::new(),
        };
        let (sides, holds): (Vec<Sym>, Vec<bool>) = sides.into_iter().map(|(value, holds, _)| (value, holds)).unzip();
        let expressions = Expressions {
            loads,
            surplus,
            implied: put(&substitute_all(&rows.implied, &at_rest)),
            sides: put(&sides),
            values,
        };
        let tapes = expressions.recorded(&letters, &multipliers)?;
        let by_sums = match near {
            None => expressions.by_sums((&letters, &multipliers), &unknowns)?,
            Some(_) => None,
        };
        let [momenta, masses] = match rows.determined.is_empty() {
            true => {
                let [momenta, masses] = momenta(&trace, is_cyclic, (&letters, &known));
                let is_held =
                    |k: usize| rows.zeros.iter().any(|zero| zero.symbols_of().contains(&trace.coordinates[k]));
                let is_empty = |k: &usize| {
                    asking_all[*k] == Sym::ZERO
                        && !is_held(*k)
                        && masses[*k * n..][..n].iter().all(|own| vanishes(*own))
                };
                if let Some(k) = (0..n).find(is_empty) {
                    return Err(NoSteadyMotions::Empty { coordinate: names[k].clone() });
                }
                [momenta, masses].map(|all| Tape::record(&letters, &all).ok())
            }
            false => [None, None],
        };
        let rubbing: Vec<usize> = (model.switches.len()..cases.len())
            .zip(&rows.contacts)
            .filter(|(place, contact)| contact.friction.is_some() && cases[*place] != Case::Holds)
            .map(|(place, _)| place)
            .collect();
        let energy = rows.energy_integral.filter(|_| rubbing.is_empty());
        let (places, rates): (Vec<usize>, Vec<Sym>) = rows.determined.iter().copied().unzip();
        let rates = tapes::recorded(&letters, &substitute_all(&substitute_all(&rates, &at_rest), &known))?;
        let cyclic_places: Vec<usize> = (0..n).filter(|&k| is_cyclic[k]).collect();
        let cyclic = cyclic_places.iter().filter(|&&k| !is_integral(model, k)).map(|&k| names[k].clone()).collect();
        let by_values = cyclic_places.iter().filter(|&&k| !is_integral(model, k) && !rows.is_always_cyclic[k]);
        let cyclic_by_values = by_values.map(|&k| names[k].clone()).collect();
        let kept_momenta = rows.kept_momenta.iter().map(|&k| (k, names[k].clone())).collect();
        Ok(SteadyEquations {
            rows: expressions.values.len(),
            derivatives: tapes::derivatives(&letters, &expressions.values),
            holds,
            side_places,
            cases: cases.to_vec(),
            is_at_condition: cases.contains(&Case::Between),
            friction,
            switches: cases
                .iter()
                .take(model.switches.len())
                .map(|case| if *case == Case::Holds { 1.0 } else { 0.0 })
                .collect(),
            identities,
            free_speeds,
            coordinates: unknowns.iter().filter(|unknown| unknown.place < n).count(),
            unknowns,
            given,
            cyclic,
            cyclic_by_values,
            cyclic_places,
            kept_momenta,
            state,
            reactions: multipliers.len(),
            is_unbalanced,
            energy_integral: energy.filter(|energy| energy.is_kept),
            decays: energy.is_some_and(|energy| !energy.is_kept),
            rubbing,
            tapes,
            by_sums,
            momenta,
            masses,
            determined: (places.into_iter().map(|k| n + k).collect(), rates),
        })
    }
}

impl SteadyEquations {
    /// A box of the unknowns, extended by unbounded intervals for the reactions.
    pub fn with_reactions(&self, at: &[Interval]) -> Vec<Interval> {
        let mut all = at.to_vec();
        all.resize(self.unknowns.len() + self.reactions, Interval::EVERYTHING);
        all
    }

    /// The state for values of the unknowns.
    pub fn state_at(&self, values: impl Iterator<Item = f64>) -> Vec<f64> {
        let mut state = self.state.clone();
        let values: Vec<f64> = values.collect();
        // factors of conditions have indices behind the state
        for (unknown, value) in self.unknowns.iter().zip(&values) {
            state.iter_mut().skip(unknown.place).take(1).for_each(|own| *own = *value);
        }
        let (places, rates) = &self.determined;
        let mut speeds = vec![0.0; places.len()];
        rates.over::<f64>().evaluate(&values, &mut speeds);
        places.iter().zip(speeds).for_each(|(&place, speed)| state[place] = speed);
        state
    }
}

/// A number of the state as the exact decimal that was written.
fn number(value: f64) -> Sym {
    Sym::constant(Rational::decimal(value))
}

/// The index of an expression with a required sign that belongs to no case.
pub(super) const NO_CASE: usize = usize::MAX;
