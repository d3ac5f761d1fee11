//! Conditions across which the law is continuously differentiable, such as that of |w| in the torque k |w| w of a fan: linear equations and
//! energies have no kink at their zeros.
//!
//! Let J be the difference of an expression between the two sides of a condition c, and x a letter of c. If J = 0 and dJ/dx = 0 wherever c = 0,
//! the first derivatives of both sides agree there.

use super::condition_zeros::vanish_there;
use super::conditions::{Case, is_linear};
use crate::letters::Letters;
use model::equations::{Residuals, constraints_of, vanishes};
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// Whether the law and its first derivatives agree on both sides of the conditions with the given indices where these are zero; the other
/// conditions have their cases.
pub(super) fn joins_smoothly(model: &Model, cases: &[Case], places: &[usize]) -> bool {
    let are_conditions = places.iter().all(|&place| place < model.switches.len());
    are_conditions
        && symbolic::apart(|| {
            let Some(Sides { rows, letters, conditions }) = Sides::of(model, cases, places) else { return false };
            let joins = |(&letter, &condition): (&Sym, &Sym)| {
                let jumps = differences(&rows, letter);
                jumps.iter().all(|jump| vanishes(*jump)) || are_tangent(&jumps, condition)
            };
            letters.iter().zip(&conditions).all(joins)
        })
}

/// Whether only forces jump at a condition of positions, and along its gradient. The potential energies of both sides then agree where the
/// condition is zero.
pub(super) fn jumps_along_gradient(model: &Model, cases: &[Case], place: usize) -> bool {
    symbolic::apart(|| {
        let Some(Sides { rows, letters, conditions }) = Sides::of(model, cases, &[place]) else { return false };
        let coordinates = Trace::of(model).coordinates;
        let of_positions = |condition: &Sym| condition.symbols_of().iter().all(|own| coordinates.contains(own));
        let ([letter], [condition]) = (&letters[..], &conditions[..]) else { return false };
        let jumps = differences(&rows, *letter);
        let (forces, others) = jumps.split_at(coordinates.len().min(jumps.len()));
        let slopes: Vec<Sym> = coordinates.iter().map(|&by| condition.diff(by)).collect();
        let is_parallel =
            (0..forces.len()).all(|i| (0..i).all(|j| vanishes(forces[i] * slopes[j] - forces[j] * slopes[i])));
        of_positions(condition) && is_parallel && others.iter().all(|own| vanishes(*own))
    })
}

/// The differences of expressions between the two sides of a condition with this letter.
fn differences(rows: &[Sym], letter: Sym) -> Vec<Sym> {
    let on = |value: Sym, row: Sym| row.substitute(&[(letter, value)]);
    rows.iter().map(|&row| on(Sym::ONE, row) - on(Sym::ZERO, row)).collect()
}

/// Whether the differences and their first derivatives vanish where a condition is zero.
fn are_tangent(jumps: &[Sym], condition: Sym) -> bool {
    let linear: Vec<Sym> = condition.symbols_of().into_iter().filter(|own| is_linear(condition, *own)).collect();
    if linear.is_empty() {
        return vanish_there(jumps, condition, &[], true);
    }
    linear.into_iter().any(|letter| {
        let slope = condition.diff(letter);
        let there = [(letter, letter - condition / slope)];
        jumps.iter().all(|jump| [*jump, jump.diff(letter)].iter().all(|own| vanishes(own.substitute(&there))))
    })
}

/// The law with some conditions left as letters.
pub(super) struct Sides {
    /// Residuals, constraints, and the gaps, sliding velocities and friction coefficients of contacts.
    pub rows: Vec<Sym>,
    /// The letters of these conditions; `conditions` has their values.
    pub letters: Vec<Sym>,
    conditions: Vec<Sym>,
}

impl Sides {
    /// The law in the expression graph of the thread, with the conditions `places` left as letters; `None` if the system has no equations.
    pub fn of(model: &Model, cases: &[Case], places: &[usize]) -> Option<Self> {
        let trace = Trace::of(model);
        let equations = Residuals::of(&trace).into_iter().next()?;
        let held = constraints_of(&trace).into_iter().map(|one| one.zero);
        let reactions = model.contacts.iter().flat_map(|own| own.slides.iter().chain(&own.friction).chain([&own.gap]));
        let rows: Vec<Sym> = equations.residuals.iter().copied().chain(held).collect();
        let rows = rows.into_iter().chain(reactions.map(|&own| trace.scalar(own)));
        let conditions = places.iter().map(|&place| trace.scalar(model.switches[place]));
        let all: Vec<Sym> = rows.chain(conditions).collect();
        let state = [&trace.coordinates[..], &trace.speeds].concat();
        let all = Letters::with_decimals(trace.time, &state).put_into(&trace, &all);
        let known = trace.switches.iter().zip(cases).enumerate().filter(|(place, _)| !places.contains(place));
        let known: Vec<(Sym, Sym)> = known
            .filter_map(|(_, (&letter, case))| match case {
                Case::Holds => Some((letter, Sym::ONE)),
                Case::Fails => Some((letter, Sym::ZERO)),
                _ => None,
            })
            .collect();
        let mut rows = substitute_all(&all, &known);
        let conditions = rows.split_off(rows.len() - places.len());
        Some(Sides { rows, letters: places.iter().map(|&place| trace.switches[place]).collect(), conditions })
    }
}
