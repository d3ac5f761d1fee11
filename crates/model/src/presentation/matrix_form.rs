//! A system in matrix form: M q'' + h = Q + J^T lambda, with all constraints.

use super::axes::axes;
use super::contacts::open_letters;
use super::cosines::{Cosine, cosines};
use super::quasi_velocities::{InQuasiVelocities, collected, written_operations};
use super::reading::Reading;
use super::simplified_as_defined;
use super::turns::{FreeTurn, short_form};
use crate::equations::{Equation, Equations, Level};
use crate::principles::{NotApplicable, Principle};
use crate::{Energies, Model, Trace};
use rustc_hash::FxHashSet;
use std::ops::Range;
use symbolic::{Node, Sym, substitute_all};

/// A system with n speeds and m scalar constraints in matrix form, over the symbols of a trace.
///
/// h contains the inertia terms without accelerations, Q the applied forces, J the derivatives of the constraints' rates with respect to the speeds. For a positive
/// multiplier the reaction acts along its row of J, the gradient of the constraint.
#[derive(Clone, Debug)]
pub struct MatrixForm {
    /// The symbol of the time t.
    pub time: Sym,
    /// The symbols of the parameters, in the order of the model.
    pub parameters: Vec<Sym>,
    /// All coordinates q; the quaternions of free frames come last.
    pub positions: Vec<Sym>,
    /// The rates q' as functions of the speeds.
    pub position_rates: Vec<Sym>,
    /// For each speed, the coordinate whose rate it is; for other speeds the speed itself.
    pub coordinates: Vec<Sym>,
    /// Rates of coordinates, then angular velocities of free frames; or quasi-velocities.
    pub speeds: Vec<Sym>,
    /// The rates of the speeds, of length n.
    pub accelerations: Vec<Sym>,
    /// The mass matrix M, n x n by rows; symmetric.
    pub mass: Vec<Vec<Sym>>,
    /// The vector h, of length n.
    pub inertia: Vec<Sym>,
    /// The vector Q, of length n.
    pub forces: Vec<Sym>,
    /// The m scalar constraints.
    pub constraints: Vec<HeldEquation>,
    /// The multipliers lambda, one for each constraint.
    pub multipliers: Vec<Sym>,
    /// Inputs without a value, and reactions of contacts.
    pub inputs: Vec<Sym>,
    /// Pairs (symbol, condition): the symbol is 1 where the condition is positive, otherwise 0.
    pub switches: Vec<(Sym, Sym)>,
    /// Whether each condition holds where it is zero.
    pub(super) hold_at_zero: Vec<bool>,
    /// Direction cosines of free frames; in a form for reading only those that occur.
    pub cosines: Vec<Cosine>,
    /// Quaternions and direction cosines of free frames.
    pub(super) turns: Vec<FreeTurn>,
    /// The lines of conditions and events in the file.
    pub lines: Lines,
    /// The meaning of the speeds if they are quasi-velocities.
    pub quasi: Option<InQuasiVelocities>,
    /// For each parameter, whether its value is positive.
    pub(super) positive: Vec<bool>,
}

/// Line numbers in a file, counted from one; empty if the file is not known.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// The line of each condition.
    pub conditions: Vec<usize>,
    /// The line of each event.
    pub events: Vec<usize>,
}

/// A scalar constraint f = 0.
#[derive(Clone, Debug)]
pub struct HeldEquation {
    /// The name in the model; empty if there is none.
    pub name: String,
    /// The axis of a vector's component, such as `F3.x`; `None` for a scalar.
    pub axis: Option<String>,
    pub level: Level,
    /// The expression f.
    pub zero: Sym,
    /// The row of J, of length n.
    pub row: Vec<Sym>,
    /// The entry c of J u' + c = 0.
    pub bias: Sym,
}

impl MatrixForm {
    /// Derives the form by a principle, without simplification.
    ///
    /// # Errors
    /// The principle does not apply to the model.
    pub fn of(trace: &Trace<'_>, principle: Principle) -> Result<Self, NotApplicable> {
        let Equations { mass, bias, constraints } = Equations::by(principle, trace)?;
        // the inertia terms are those of the system without loads
        let free = without_forces(trace.model);
        let inertia = Equations::by(principle, &Trace::of(&free))?.bias;
        let forces = inertia.iter().zip(&bias).map(|(&inertia, &bias)| inertia - bias).collect();
        let constraints =
            constraints.into_iter().zip(axes(trace)).map(|(each, axis)| HeldEquation::of(each, axis)).collect();
        let dynamics = Dynamics { mass, inertia, forces, constraints };
        let shown = (0..trace.speeds.len()).map(|speed| displaced(trace, speed)).collect();
        let (speeds, accelerations) = (trace.speeds.clone(), trace.accelerations.clone());
        Ok(MatrixForm::with(trace, dynamics, shown, speeds, accelerations, trace.position_rates.clone()))
    }

    pub(super) fn with(
        trace: &Trace<'_>,
        Dynamics { mass, inertia, forces, constraints }: Dynamics,
        coordinates: Vec<Sym>,
        speeds: Vec<Sym>,
        accelerations: Vec<Sym>,
        position_rates: Vec<Sym>,
    ) -> Self {
        let letters = [&trace.parameters, &trace.coordinates, &speeds];
        let taken: Vec<Sym> = letters.into_iter().flatten().copied().collect();
        let multiplier = |k: usize| {
            let named = |gap: usize| Sym::symbol(&format!("lambda{}{k}", "_".repeat(gap)));
            (0..=taken.len()).map(named).find(|letter| !taken.contains(letter)).unwrap_or(Sym::ZERO)
        };
        MatrixForm {
            time: trace.time,
            parameters: trace.parameters.clone(),
            positions: trace.coordinates.clone(),
            position_rates,
            coordinates,
            speeds,
            accelerations,
            mass,
            inertia,
            forces,
            multipliers: (1..=constraints.len()).map(multiplier).collect(),
            constraints,
            quasi: None,
            switches: trace
                .switches
                .iter()
                .zip(&trace.model.switches)
                .map(|(&letter, &condition)| (letter, trace.scalar(condition)))
                .collect(),
            hold_at_zero: (0..trace.switches.len())
                .map(|switch| trace.model.value_at_zero(switch) == Some(true))
                .collect(),
            inputs: open_letters(trace).into_iter().map(|(letter, _)| letter).collect(),
            cosines: cosines(trace),
            turns: trace.turns().collect(),
            lines: Lines::default(),
            positive: trace.model.parameters.iter().map(|each| each.value.is_some_and(|value| value > 0.0)).collect(),
        }
    }

    /// The comparison with zero by which a condition holds.
    pub(super) fn relation(&self, condition: usize) -> &'static str {
        if self.hold_at_zero.get(condition) == Some(&true) { ">=" } else { ">" }
    }

    /// Returns the number of leading coordinates whose rates are the leading speeds.
    pub(super) fn plain(&self) -> usize {
        let pairs = self.position_rates.iter().zip(&self.speeds);
        pairs.take_while(|(rate, speed)| rate == speed && self.quasi.is_none()).count()
    }

    /// Returns whether any speed is not the rate of a coordinate.
    pub(super) fn has_own_speeds(&self) -> bool {
        self.plain() < self.speeds.len()
    }

    /// Adds the lines of conditions and events in the file of a model.
    #[must_use]
    pub fn in_file(mut self, model: &Model, file: &str) -> Self {
        let line = |at: &Range<usize>| 1 + file.get(..at.start).unwrap_or(file).matches('\n').count();
        self.lines = Lines {
            conditions: model.switch_places.iter().map(line).collect(),
            events: model.events.iter().map(|event| line(&event.at)).collect(),
        };
        self
    }

    /// Returns the first of `letters` for which no numbered symbol, 1 to `count`, is a symbol of the system; the last one if there is none.
    pub(super) fn free_letter<'a>(&self, letters: &[&'a str], count: usize) -> &'a str {
        let own = self.own_letters();
        let is_free = |letter: &&&str| (1..=count).all(|k| !own.contains(&format!("{letter}{k}")));
        letters.iter().find(is_free).or(letters.last()).copied().unwrap_or_default()
    }

    /// Returns the first of `names` that is not a symbol of the system; the last one if there is none.
    pub(super) fn free_name<'a>(&self, names: &[&'a str]) -> &'a str {
        let own = self.own_letters();
        names.iter().find(|name| !own.iter().any(|own| own == *name)).or(names.last()).copied().unwrap_or_default()
    }

    fn own_letters(&self) -> Vec<String> {
        let own = [&self.parameters, &self.coordinates, &self.speeds, &self.inputs].into_iter().flatten();
        own.map(Sym::to_string).collect()
    }

    /// Replaces symbols in all expressions.
    #[must_use]
    pub fn renamed(&self, letters: &[(Sym, Sym)]) -> Self {
        self.mapped(&mut |expressions| substitute_all(expressions, letters))
    }

    /// Returns the form for reading, with recombined angles and common factors outside of sums.
    #[must_use]
    pub fn for_reading(&self) -> Self {
        let parameters = self.parameters.iter().copied().zip(self.positive.iter().copied());
        let parameters = parameters.chain([(Sym::symbol("pi"), true)]);
        let rates = self.quasi.iter().flat_map(|quasi| &quasi.rates);
        let coefficients = self.quasi.iter().flat_map(|quasi| &quasi.coefficients);
        let coefficients = coefficients.flat_map(|each| [each.letter, each.rate]);
        let letters = [&self.positions, &self.speeds, &self.accelerations].into_iter().flatten().chain(rates).copied();
        let letters = letters.chain(coefficients);
        let named = self.cosines.iter().map(|cosine| (cosine.value, cosine.letter));
        let mut reading = Reading::new(parameters, letters.chain([self.time])).with_letters(named);
        let mut form = match self.quasi {
            Some(_) => {
                // quotients of the kinematic equations cancel in normal form
                let short_form = |each: Sym| short_form(each, &self.turns);
                let mut read = |each: &Sym| {
                    let size = Sym::operations_of(&[*each]);
                    let by_speeds =
                        (size <= MOST_COLLECTED).then(|| collected(*each, &self.speeds, short_form)).flatten();
                    let short = (size <= MOST_CANCELLED).then(|| [short_form(*each), simplified_as_defined(*each)]);
                    let forms = by_speeds.into_iter().chain(short.into_iter().flatten()).chain([*each]);
                    // a sum in a denominator is printed once
                    let forms = forms.flat_map(|form| match form.node() {
                        Node::Quotient(above, below) if below.as_constant().is_none() => {
                            let is_turned = matches!(reading.of(below).decimal_text().as_bytes(), [b'-', ..]);
                            let [above, below] = [above, below].map(|part| if is_turned { -part } else { part });
                            [reading.of(form), reading.of(above) / reading.of(below)]
                        }
                        _ => [reading.of(form); 2],
                    });
                    let length = |form: &Sym| written_operations(&[*form]);
                    forms.min_by(|one, other| length(one).total_cmp(&length(other))).unwrap_or(*each)
                };
                self.mapped(&mut |expressions| expressions.iter().map(&mut read).collect())
            }
            None => {
                let read = self.mapped(&mut |expressions| expressions.iter().map(|each| reading.of(*each)).collect());
                // the rates of quaternions stay in their usual form
                MatrixForm { position_rates: self.position_rates.clone(), ..read }
            }
        };
        let used: FxHashSet<Sym> = form.expressions().flat_map(|each| each.symbols_of()).collect();
        form.cosines = self.cosines.iter().filter(|cosine| used.contains(&cosine.letter)).cloned().collect();
        form
    }

    /// Returns every expression of the equations.
    pub(super) fn expressions(&self) -> impl Iterator<Item = Sym> {
        let held = self.constraints.iter().flat_map(|held| held.row.iter().chain([&held.zero, &held.bias]));
        let conditions = self.switches.iter().map(|(_, condition)| condition);
        let coefficients = self.quasi.iter().flat_map(|quasi| &quasi.coefficients);
        let coefficients = coefficients.flat_map(|each| [each.is, each.rate_is]);
        let vectors = [&self.inertia, &self.forces, &self.position_rates].into_iter().flatten();
        self.mass.iter().flatten().chain(vectors).chain(held).chain(conditions).copied().chain(coefficients)
    }

    fn mapped(&self, map: &mut dyn FnMut(&[Sym]) -> Vec<Sym>) -> Self {
        let single = |map: &mut dyn FnMut(&[Sym]) -> Vec<Sym>, expression: Sym| map(&[expression])[0];
        MatrixForm {
            time: single(map, self.time),
            parameters: map(&self.parameters),
            positions: map(&self.positions),
            position_rates: map(&self.position_rates),
            coordinates: map(&self.coordinates),
            speeds: map(&self.speeds),
            accelerations: map(&self.accelerations),
            mass: self.mass.iter().map(|row| map(row)).collect(),
            inertia: map(&self.inertia),
            forces: map(&self.forces),
            constraints: self.constraints.iter().map(|held| held.mapped(map)).collect(),
            quasi: self.quasi.as_ref().map(|quasi| quasi.mapped(map)),
            multipliers: map(&self.multipliers),
            switches: self
                .switches
                .iter()
                .map(|&(letter, condition)| (single(map, letter), single(map, condition)))
                .collect(),
            hold_at_zero: self.hold_at_zero.clone(),
            inputs: map(&self.inputs),
            cosines: self
                .cosines
                .iter()
                .map(|cosine| Cosine {
                    letter: single(map, cosine.letter),
                    value: single(map, cosine.value),
                    ..cosine.clone()
                })
                .collect(),
            turns: self.turns.clone(),
            lines: self.lines.clone(),
            positive: self.positive.clone(),
        }
    }
}

/// Quotients of longer expressions are unchanged, since their normal forms may be much longer.
const MOST_CANCELLED: usize = 300;

/// Longer expressions are not split into coefficients.
const MOST_COLLECTED: usize = 2_000;

/// M, h, Q and the constraints with multipliers.
pub(super) struct Dynamics {
    pub mass: Vec<Vec<Sym>>,
    pub inertia: Vec<Sym>,
    pub forces: Vec<Sym>,
    pub constraints: Vec<HeldEquation>,
}

impl HeldEquation {
    pub(super) fn of(Equation { name, level, zero, row, bias, .. }: Equation, axis: Option<String>) -> Self {
        HeldEquation { name, axis, level, zero, row, bias }
    }

    pub(super) fn mapped(&self, map: &mut dyn FnMut(&[Sym]) -> Vec<Sym>) -> Self {
        let [zero, bias] = [self.zero, self.bias].map(|each| map(&[each])[0]);
        HeldEquation { zero, row: map(&self.row), bias, ..self.clone() }
    }
}

/// Returns the coordinate whose rate is the speed; for other speeds the speed itself.
fn displaced(trace: &Trace<'_>, speed: usize) -> Sym {
    if speed < trace.model.coordinates.len() { trace.coordinates[speed] } else { trace.speeds[speed] }
}

/// Returns the model without loads.
pub(super) fn without_forces(model: &Model) -> Model {
    let Energies { kinetic, coenergy, .. } = model.energies;
    let energies = Energies { kinetic, coenergy, ..Energies::default() };
    Model { gravity: None, forces: Vec::new(), torques: Vec::new(), generalised: Vec::new(), energies, ..model.clone() }
}
