//! Scalars that a run shows in addition to the state: the outputs of a model, and its energies.

use crate::implicit::unknown_letters;
use crate::letters::Letters;
use crate::modes::{Mode, ModeMotion, reactions_of};
use model::equations::constraints_of;
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// The number of energies behind the outputs: kinetic and potential energy, J.
pub const ENERGIES: usize = 2;

/// Symbols whose values follow from the motion and not from the state.
struct Unknowns {
    /// Accelerations, then multipliers.
    solved: Vec<Sym>,
    reactions: Vec<Sym>,
    /// Switches and algebraic speeds.
    others: Vec<Sym>,
}

impl Unknowns {
    fn of(trace: &Trace<'_>) -> Self {
        let multipliers = constraints_of(trace).into_iter().map(|one| one.multiplier);
        let algebraic = trace.model.algebraic_speeds.iter().map(|&place| trace.speeds[place]);
        Unknowns {
            solved: trace.accelerations.iter().copied().chain(multipliers).collect(),
            reactions: reactions_of(trace),
            others: trace.switches.iter().copied().chain(algebraic).collect(),
        }
    }

    /// True if the expression contains one of these symbols.
    fn stand_in(&self, expression: Sym) -> bool {
        let used = expression.symbols_of();
        let Unknowns { solved, reactions, others } = self;
        solved.iter().chain(reactions).chain(others).any(|letter| used.contains(letter))
    }
}

/// The outputs, then kinetic and potential energy, as expressions over `letters`.
pub(crate) fn outputs(model: &Model, mode: &Mode, letters: Letters<'_>) -> Vec<Sym> {
    let trace = Trace::of(model);
    let shown = model.outputs.iter().map(|output| trace.scalar(output.is));
    let all: Vec<Sym> = shown.chain([trace.kinetic_energy(), trace.potential_energy()]).collect();
    letters.put_into(&trace, &determined(&trace, mode, all))
}

/// Replaces accelerations, multipliers, reactions, switches and algebraic speeds in expressions by their values in a mode. Without a
/// motion in this mode they are unchanged.
pub(crate) fn determined(trace: &Trace<'_>, mode: &Mode, mut all: Vec<Sym>) -> Vec<Sym> {
    let unknowns = Unknowns::of(trace);
    if all.iter().any(|each| unknowns.stand_in(*each))
        && let Ok(ModeMotion { accelerations, multipliers, switches, reactions, speeds, .. }) =
            ModeMotion::of(trace, mode)
    {
        let reactions = unknowns.reactions.into_iter().zip(reactions.concat());
        let known: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(switches).chain(reactions).collect();
        all = substitute_all(&all, &known);
        let known: Vec<(Sym, Sym)> =
            unknowns.solved.into_iter().zip(accelerations.into_iter().chain(multipliers)).collect();
        all = substitute_all(&substitute_all(&all, &known), &speeds);
    }
    all
}

/// The outputs and energies with accelerations and multipliers as inputs `unknowns`, for laws that solve for them.
pub(crate) fn outputs_of_solved(model: &Model, letters: Letters<'_>, unknowns: &[Sym]) -> Vec<Sym> {
    let trace = Trace::of(model);
    let shown = model.outputs.iter().map(|output| trace.scalar(output.is));
    let all: Vec<Sym> = shown.chain([trace.kinetic_energy(), trace.potential_energy()]).collect();
    let all = substitute_all(&all, &unknown_letters(&trace, unknowns));
    letters.put_into(&trace, &all)
}

/// Indices of the outputs that depend on accelerations, multipliers, reactions, switches or algebraic speeds.
pub(crate) fn of_motion(model: &Model) -> Vec<usize> {
    let trace = Trace::of(model);
    let unknowns = Unknowns::of(&trace);
    let depends = |&place: &usize| unknowns.stand_in(trace.scalar(model.outputs[place].is));
    (0..model.outputs.len()).filter(depends).collect()
}
