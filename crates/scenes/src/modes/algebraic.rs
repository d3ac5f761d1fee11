//! Algebraic speeds: speeds of coordinates without inertia whose laws change at conditions or with diodes. In each mode their equations
//!
//!   r_k - sum mu_c J_ck = 0 ,    f_c = 0 ,    i = 0 of a diode that blocks ,    g = 0 of a condition that is held
//!
//! are linear in these speeds, in the multipliers mu of the constraints f on them, in the voltages across blocking diodes, and in the
//! switches of conditions held at zero. In some modes a combination of these equations has no unknowns, for example if an ideal diode
//! connects a source with a capacitor. This combination is a hidden constraint of positions or of speeds with inertia, and is replaced by
//! its rate.

use super::contacts::letters as reactions;
use super::held::is_linear;
use super::held_forces::{held_forces, multiplies};
use super::mode::{Mode, Phase};
use super::multiples::{letters as letters_of, mirrored};
use super::unknown_speeds::Elimination;
use crate::compiled_system::NotCompiled;
use model::equations::{Equation, Equations, Singular, solved};
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// The equations of motion, solved except for algebraic speeds and their multipliers, which remain symbols.
pub(crate) struct Parted {
    /// One expression for each speed; zero for algebraic speeds.
    pub accelerations: Vec<Sym>,
    /// One expression for each constraint; its own symbol if the constraint contains algebraic speeds.
    pub multipliers: Vec<Sym>,
    /// The unknown symbols: algebraic speeds, then multipliers of constraints that contain them.
    pub letters: Vec<Sym>,
    /// The equations for these symbols, as expressions equal to zero: the law of each algebraic speed, then each constraint.
    pub zeros: Vec<Sym>,
    /// The conditions and contacts that contain an algebraic speed: the mode determines their values.
    pub is_direct: Direct,
}

/// For each condition, and for each contact: true if it contains an algebraic speed, so that the mode determines its value.
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
    /// Solves the equations of motion of a trace as far as possible without a mode.
    ///
    /// # Errors
    /// A coordinate has no inertia and no algebraic law, or a constraint is redundant.
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

    /// Expressions, in a mode, of the symbols that it determines: algebraic speeds, their multipliers, voltages of diodes, and switches.
    /// Empty without algebraic speeds. Reactions and switches that depend on accelerations remain symbols.
    ///
    /// # Errors
    /// [`NotCompiled::NotHeld`] or [`NotCompiled::Massless`] if the equations have no solution.
    pub(super) fn settled(&self, trace: &Trace<'_>, mode: &Mode) -> Result<Settled, NotCompiled> {
        if self.letters.is_empty() {
            return Ok(Settled::default());
        }
        let model = trace.model;
        let mirrored = mirrored(trace);
        let others = letters_of(trace, &mirrored);
        let own = (0..mode.cases.len()).filter(|&switch| mirrored[switch].is_none());
        let (resting, fixed): (Vec<usize>, Vec<usize>) = own.partition(|&switch| mode.cases[switch].rests());
        let (held, moved): (Vec<usize>, Vec<usize>) =
            resting.into_iter().partition(|&switch| self.is_direct.conditions[switch]);
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
        let zeros = in_mode(&zeros);
        let not_solved = |held: &[usize]| match held.first() {
            Some(&switch) => NotCompiled::NotHeld { switch },
            None => massless(model, model.algebraic_speeds[0]),
        };
        let motion: Vec<(Sym, Sym)> =
            trace.accelerations.iter().copied().zip(self.accelerations.iter().copied()).collect();
        let rate = |hidden: Sym| in_mode(&[trace.rate_of(hidden).substitute(&motion)])[0];
        let moving: Vec<Sym> = trace.switches.iter().copied().chain(reactions(trace)).collect();
        let stays = |hidden: Sym| !hidden.symbols_of().iter().any(|letter| moving.contains(letter));
        let hidden_rate = |hidden: Sym| stays(hidden).then(|| rate(hidden));
        // a sticking friction whose amount is proportional to an unknown makes the equations bilinear
        let letters: Vec<(usize, Sym)> = moved.iter().map(|&switch| (switch, trace.switches[switch])).collect();
        let sticking: Vec<(usize, Sym)> =
            letters.into_iter().filter(|(_, letter)| multiplies(*letter, &zeros, &unknowns)).collect();
        if !sticking.is_empty() {
            let of =
                |&(switch, letter): &(usize, Sym)| (letter, rate(in_mode(&[trace.scalar(model.switches[switch])])[0]));
            let held: Vec<(Sym, Sym)> = sticking.iter().map(of).collect();
            let switches: Vec<usize> = sticking.iter().map(|(switch, _)| *switch).collect();
            let found = held_forces(&unknowns, &held, &zeros).ok_or_else(|| not_solved(&switches))?;
            let values = given.into_iter().chain(found).collect();
            return Ok(Settled { values, implicit: Vec::new(), switches });
        }
        match Elimination::of(&unknowns).solved(&zeros, hidden_rate) {
            Some(found) => {
                let values = given.into_iter().chain(unknowns.into_iter().zip(found)).collect();
                Ok(Settled { values, implicit: Vec::new(), switches: Vec::new() })
            }
            None if unknowns.iter().all(|letter| trace.speeds.contains(letter)) && !is_linear(&zeros, &unknowns) => {
                let implicit = unknowns.into_iter().zip(zeros).collect();
                Ok(Settled { values: given, implicit, switches: Vec::new() })
            }
            None => Err(not_solved(&held)),
        }
    }
}

/// The symbols that a mode determines.
#[derive(Default)]
pub(super) struct Settled {
    /// Symbols with their expressions.
    pub values: Vec<(Sym, Sym)>,
    /// Implicit algebraic speeds, each with an equation as an expression equal to zero; a run integrates their rates.
    pub implicit: Vec<(Sym, Sym)>,
    /// Indices of conditions held at zero whose switches are among `values`.
    pub switches: Vec<usize>,
}

fn massless(model: &Model, speed: usize) -> NotCompiled {
    NotCompiled::Massless { coordinate: crate::compiled_system::speed_name(model, speed) }
}
