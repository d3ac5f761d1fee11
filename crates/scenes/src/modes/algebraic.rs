//! Algebraic speeds: those of coordinates without inertia whose laws change at conditions or with diodes.
//!
//!   r_k - sum mu_c J_ck = 0 ,    f_c = 0 ,    i = 0 of a diode that blocks ,    g = 0 of a condition that is held
//!
//! are linear in these speeds, in the multipliers mu of the constraints f that hold them, in the voltages across such diodes and in such
//! switches. A mode may leave a combination of these equations without unknowns, as the one that ties a capacitor to a source behind an
//! ideal diode. It is a hidden constraint of positions or of speeds with inertia, and its rate takes its place.

use super::contacts::letters as reactions;
use super::mode::{Mode, Phase};
use super::multiples::{letters as letters_of, mirrored};
use crate::compiled_system::NotCompiled;
use model::equations::{Equation, Equations, Singular, solved, vanishes};
use model::{Model, Trace};
use symbolic::{Derivation, Sym, substitute_all};

/// Equations of motion in which algebraic speeds are letters.
pub(crate) struct Parted {
    /// One for each speed; zero for those that are algebraic.
    pub accelerations: Vec<Sym>,
    /// One for each constraint; its letter where it holds algebraic speeds.
    pub multipliers: Vec<Sym>,
    /// Algebraic speeds, then the multipliers of constraints that hold them.
    pub letters: Vec<Sym>,
    /// Sums that these keep at zero: the law of each, then each constraint.
    pub zeros: Vec<Sym>,
    /// For each condition, and for each contact, whether it holds an algebraic speed: its value follows at once from the mode.
    pub is_direct: Direct,
}

/// Conditions and contacts whose values follow at once from the mode.
#[derive(Clone, Debug, Default)]
pub(crate) struct Direct {
    pub conditions: Vec<bool>,
    pub contacts: Vec<bool>,
}

impl Direct {
    fn of(trace: &Trace<'_>) -> Self {
        let model = trace.model;
        let speeds: Vec<Sym> = model.algebraic_speeds.iter().map(|&place| trace.speeds[place]).collect();
        let holds = |id| trace.scalar(id).symbols_of().iter().any(|letter| speeds.contains(letter));
        Direct {
            conditions: model.switches.iter().map(|&condition| holds(condition)).collect(),
            contacts: model.contacts.iter().map(|contact| contact.one_way.is_some() && holds(contact.gap)).collect(),
        }
    }
}

impl Parted {
    pub fn of(trace: &Trace<'_>) -> Result<Self, NotCompiled> {
        let model = trace.model;
        if model.algebraic_speeds.is_empty() {
            return Parted::without_algebraic_speeds(trace);
        }
        let Equations { mass, bias, constraints } = Equations::of(trace);
        let algebraic = &model.algebraic_speeds;
        let inertial: Vec<usize> = (0..bias.len()).filter(|place| !algebraic.contains(place)).collect();
        let holds = |one: &Equation| algebraic.iter().any(|&place| one.row[place] != Sym::ZERO);
        let (open, kept): (Vec<usize>, Vec<usize>) = (0..constraints.len()).partition(|&k| holds(&constraints[k]));
        let acting = |place: usize| {
            open.iter().fold(bias[place], |rest, &k| rest - constraints[k].multiplier * constraints[k].row[place])
        };
        let of_inertial = |row: &Vec<Sym>| inertial.iter().map(|&place| row[place]).collect::<Vec<Sym>>();
        let alone = Equations {
            mass: inertial.iter().map(|&place| of_inertial(&mass[place])).collect(),
            bias: inertial.iter().map(|&place| acting(place)).collect(),
            constraints: kept
                .iter()
                .map(|&k| Equation { row: of_inertial(&constraints[k].row), ..constraints[k].clone() })
                .collect(),
        };
        let (found, lambda) = alone.solved().map_err(|singular| match singular {
            Singular::Massless { coordinate } => massless(model, inertial[coordinate]),
            Singular::Redundant { constraint } => NotCompiled::Redundant { constraint: kept[constraint] },
        })?;
        let mut accelerations = vec![Sym::ZERO; bias.len()];
        inertial.iter().zip(found).for_each(|(&place, value)| accelerations[place] = value);
        let mut multipliers: Vec<Sym> = constraints.iter().map(|one| one.multiplier).collect();
        kept.iter().zip(lambda).for_each(|(&k, value)| multipliers[k] = value);
        let speeds = algebraic.iter().map(|&place| trace.speeds[place]);
        let letters = speeds.chain(open.iter().map(|&k| constraints[k].multiplier)).collect();
        let laws = algebraic.iter().map(|&place| acting(place));
        let zeros = laws.chain(open.iter().map(|&k| constraints[k].rate)).collect();
        Ok(Parted { accelerations, multipliers, letters, zeros, is_direct: Direct::of(trace) })
    }

    fn without_algebraic_speeds(trace: &Trace<'_>) -> Result<Self, NotCompiled> {
        let (accelerations, multipliers) = solved(trace).map_err(|singular| match singular {
            Singular::Massless { coordinate } => massless(trace.model, coordinate),
            Singular::Redundant { constraint } => NotCompiled::Redundant { constraint },
        })?;
        let is_direct = Direct::of(trace);
        Ok(Parted { accelerations, multipliers, letters: Vec::new(), zeros: Vec::new(), is_direct })
    }

    /// Letters by what stands for them in a mode: algebraic speeds, multipliers, voltages of diodes and switches that follow at once, and
    /// switches that the mode fixes. None of a system without such speeds. Reactions and switches that hang on accelerations stay letters.
    pub(super) fn settled(&self, trace: &Trace<'_>, mode: &Mode) -> Result<Vec<(Sym, Sym)>, NotCompiled> {
        if self.letters.is_empty() {
            return Ok(Vec::new());
        }
        let model = trace.model;
        let mirrored = mirrored(trace);
        let others = letters_of(trace, &mirrored);
        let own = (0..mode.cases.len()).filter(|&switch| mirrored[switch].is_none());
        let (resting, fixed): (Vec<usize>, Vec<usize>) = own.partition(|&switch| mode.cases[switch].rests());
        let held: Vec<usize> = resting.into_iter().filter(|&switch| self.is_direct.conditions[switch]).collect();
        let diodes = (0..model.contacts.len()).filter(|&contact| self.is_direct.contacts[contact]);
        let conducts = |contact: &usize| matches!(mode.phases[*contact], Phase::Apart | Phase::Carried);
        let (conducting, blocking): (Vec<usize>, Vec<usize>) = diodes.partition(conducts);
        let is_on = |switch: usize| if mode.cases[switch].fixed() == Some(true) { Sym::ONE } else { Sym::ZERO };
        let fixed = fixed.into_iter().map(|switch| (trace.switches[switch], is_on(switch)));
        let without = conducting.iter().map(|&contact| (trace.reaction(contact, 0), Sym::ZERO));
        let given: Vec<(Sym, Sym)> = fixed.chain(without).collect();
        let in_mode = |all: &[Sym]| substitute_all(&substitute_all(all, &others), &given);
        let voltages = blocking.iter().map(|&contact| trace.reaction(contact, 0));
        let switches = held.iter().map(|&switch| trace.switches[switch]);
        let unknowns: Vec<Sym> = self.letters.iter().copied().chain(voltages).chain(switches).collect();
        let gaps = blocking.iter().map(|&contact| trace.scalar(model.contacts[contact].gap));
        let conditions = held.iter().map(|&switch| trace.scalar(model.switches[switch]));
        let zeros: Vec<Sym> = self.zeros.iter().copied().chain(gaps).chain(conditions).collect();
        let not_solved = || match held.first() {
            Some(&switch) => NotCompiled::NotHeld { switch },
            None => massless(model, model.algebraic_speeds[0]),
        };
        let rate = |hidden: Sym| {
            let own = trace.accelerations.iter().copied().zip(self.accelerations.iter().copied());
            in_mode(&[trace.rate_of(hidden).substitute(&own.collect::<Vec<_>>())])[0]
        };
        let moving: Vec<Sym> = trace.switches.iter().copied().chain(reactions(trace)).collect();
        let stays = |hidden: Sym| !hidden.symbols_of().iter().any(|letter| moving.contains(letter));
        let rate = |hidden: Sym| stays(hidden).then(|| rate(hidden));
        let found = Elimination::of(&unknowns).solved(&in_mode(&zeros), rate).ok_or_else(not_solved)?;
        Ok(given.into_iter().chain(unknowns.into_iter().zip(found)).collect())
    }
}

fn massless(model: &Model, speed: usize) -> NotCompiled {
    NotCompiled::Massless { coordinate: crate::compiled_system::speed_name(model, speed) }
}

/// An equation, slopes times unknowns = right, after those before it have been taken from it.
struct Row {
    slopes: Vec<Sym>,
    right: Sym,
    /// Whether it is the rate of a hidden constraint.
    is_rate: bool,
}

/// Gauss's elimination over expressions: entries that are numbers are pivots first, since other entries may vanish.
struct Elimination<'a> {
    unknowns: &'a [Sym],
    /// Row and column of each pivot, in their order.
    pivots: Vec<(usize, usize)>,
    rows: Vec<Row>,
}

impl<'a> Elimination<'a> {
    fn of(unknowns: &'a [Sym]) -> Self {
        Elimination { unknowns, pivots: Vec::new(), rows: Vec::new() }
    }

    /// The unknowns that take sums to zero; `rate` gives the rate of a hidden constraint. None where they are not determined, or the sums
    /// are not linear in them.
    fn solved(mut self, zeros: &[Sym], rate: impl Fn(Sym) -> Option<Sym>) -> Option<Vec<Sym>> {
        for zero in zeros {
            let row = self.row(*zero, false)?;
            self.rows.push(row);
        }
        while self.pivots.len() < self.unknowns.len() {
            if let Some((row, column)) = self.pivot() {
                self.pivots.push((row, column));
                for below in self.open() {
                    self.reduce(below, (row, column));
                }
                continue;
            }
            let hidden = self.open();
            if hidden.iter().any(|&row| self.rows[row].is_rate) {
                return None;
            }
            for place in hidden {
                self.rows[place] = self.row(rate(-self.rows[place].right)?, true)?;
                for pivot in self.pivots.clone() {
                    self.reduce(place, pivot);
                }
            }
        }
        let mut values = vec![Sym::ZERO; self.unknowns.len()];
        for &(row, column) in self.pivots.iter().rev() {
            let Row { slopes, right, .. } = &self.rows[row];
            let others = slopes.iter().zip(&values).enumerate().filter(|(place, _)| *place != column);
            let rest = others.fold(*right, |rest, (_, (slope, value))| rest - *slope * *value);
            values[column] = rest / slopes[column];
        }
        Some(values)
    }

    /// A sum as an equation; none where it is not linear.
    fn row(&self, zero: Sym, is_rate: bool) -> Option<Row> {
        let slopes: Vec<Sym> =
            self.unknowns.iter().map(|&letter| Derivation::new([(letter, Sym::ONE)]).of(zero)).collect();
        let bends = |slope: &Sym| slope.symbols_of().iter().any(|letter| self.unknowns.contains(letter));
        if slopes.iter().any(bends) {
            return None;
        }
        let none: Vec<(Sym, Sym)> = self.unknowns.iter().map(|&letter| (letter, Sym::ZERO)).collect();
        Some(Row { slopes, right: -zero.substitute(&none), is_rate })
    }

    /// Rows without a pivot.
    fn open(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|row| self.pivots.iter().all(|(own, _)| own != row)).collect()
    }

    /// The entry that becomes the next pivot: in the shortest row that has one.
    fn pivot(&self) -> Option<(usize, usize)> {
        let length = |row: usize| self.rows[row].slopes.iter().filter(|slope| **slope != Sym::ZERO).count();
        let mut open = self.open();
        open.sort_by_key(|&row| length(row));
        let is_free = |column: usize| self.pivots.iter().all(|(_, own)| *own != column);
        let entries: Vec<(usize, usize)> = open
            .into_iter()
            .flat_map(|row| (0..self.unknowns.len()).map(move |column| (row, column)))
            .filter(|&(row, column)| is_free(column) && self.rows[row].slopes[column] != Sym::ZERO)
            .collect();
        let slope = |(row, column): (usize, usize)| self.rows[row].slopes[column];
        let number = entries.iter().copied().find(|&entry| slope(entry).as_constant().is_some());
        number.or_else(|| entries.iter().copied().find(|&entry| !vanishes(slope(entry))))
    }

    /// Takes a pivot's row from another one.
    fn reduce(&mut self, place: usize, (pivot, column): (usize, usize)) {
        let factor = self.rows[place].slopes[column] / self.rows[pivot].slopes[column];
        if factor == Sym::ZERO {
            return;
        }
        let slopes = self.rows[pivot].slopes.clone();
        let right = self.rows[pivot].right;
        let own = &mut self.rows[place];
        own.slopes.iter_mut().zip(slopes).for_each(|(entry, above)| *entry -= factor * above);
        own.slopes[column] = Sym::ZERO;
        own.right -= factor * right;
    }
}
