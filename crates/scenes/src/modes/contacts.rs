//! The reactions of contacts in touch, over symbols:
//!
//!   gap'' = 0 for N (u' = 0 of a diode),    v' = 0 for T of a contact that sticks,    T = -mu |N| sign(v) of one that slides .

use super::mode::{Mode, Phase};
use crate::compiled_system::NotCompiled;
use model::equations::{balances, constraints_of};
use model::{Contact, Trace};
use symbolic::{Derivation, Sym, substitute_all};

/// The sums that reactions keep at zero, normal and tangential, of each contact; of a guide that the coordinates satisfy the balance of
/// forces across it. They hold accelerations and multipliers.
pub(super) fn kept_at_zero(trace: &Trace<'_>) -> Vec<[Sym; 2]> {
    let of = |(contact, balance): (&Contact, Option<Sym>)| {
        let normal = balance.unwrap_or_else(|| trace.rate_of(trace.gap_rate(contact)));
        [normal, trace.rate_of(trace.scalar(contact.slide))]
    };
    trace.model.contacts.iter().zip(balances(trace)).map(of).collect()
}

/// Accelerations and multipliers by expressions.
pub(super) fn motion(trace: &Trace<'_>, accelerations: &[Sym], multipliers: &[Sym]) -> Vec<(Sym, Sym)> {
    let of_constraints = constraints_of(trace).into_iter().map(|one| one.multiplier);
    let letters = trace.accelerations.iter().copied().chain(of_constraints);
    letters.zip(accelerations.iter().chain(multipliers).copied()).collect()
}

/// Unknown reactions of a mode: contact and component.
pub(super) fn unknown(mode: &Mode) -> Vec<[usize; 2]> {
    let of = |(contact, phase): (usize, &Phase)| match phase {
        Phase::Apart | Phase::Carried => Vec::new(),
        Phase::Sticks(_) => vec![[contact, 0], [contact, 1]],
        Phase::Slips { .. } | Phase::Rests { .. } => vec![[contact, 0]],
    };
    mode.phases.iter().enumerate().flat_map(of).collect()
}

/// The coefficient of friction of a contact; zero of a smooth one.
pub(super) fn friction(trace: &Trace<'_>, contact: usize) -> Sym {
    trace.model.contacts[contact].friction.map_or(Sym::ZERO, |friction| trace.scalar(friction))
}

/// The contacts of a mode.
pub(super) struct Closed {
    /// Normal and tangential.
    pub reactions: Vec<[Sym; 2]>,
    /// Of the equations for them: where it vanishes they are not determined, or grow beyond every bound.
    pub determinant: Sym,
}

/// The reactions of a mode, from accelerations and multipliers that hold their letters; then both with the reactions in their place.
pub(super) fn closed(
    trace: &Trace<'_>,
    mode: &Mode,
    accelerations: &[Sym],
    multipliers: &[Sym],
) -> Result<(Closed, Vec<Sym>), NotCompiled> {
    let letter = |[contact, component]: [usize; 2]| trace.reaction(contact, component);
    let mut given: Vec<(Sym, Sym)> = Vec::new();
    for (contact, phase) in mode.phases.iter().enumerate() {
        match (phase, phase.face(), phase.way()) {
            (Phase::Apart | Phase::Carried, ..) => {
                given.extend([0, 1].map(|component| (letter([contact, component]), Sym::ZERO)))
            }
            (_, Some(face), Some(way)) => {
                let factor = friction(trace, contact) * number(-way * face.sign());
                given.push((letter([contact, 1]), factor * letter([contact, 0])));
            }
            _ => {}
        }
    }
    let unknown = unknown(mode);
    let kept = kept_at_zero(trace);
    let zeros: Vec<Sym> = unknown.iter().map(|&[contact, component]| kept[contact][component]).collect();
    let zeros = substitute_all(&substitute_all(&zeros, &motion(trace, accelerations, multipliers)), &given);
    let none: Vec<(Sym, Sym)> = unknown.iter().map(|&of| (letter(of), Sym::ZERO)).collect();
    let mut rows: Vec<Vec<Sym>> = Vec::new();
    for zero in &zeros {
        rows.push(unknown.iter().map(|&of| Derivation::new([(letter(of), Sym::ONE)]).of(*zero)).collect());
    }
    let right = substitute_all(&zeros, &none).into_iter().map(|zero| -zero).collect();
    let (values, determinant) =
        super::held::eliminated(rows, right).map_err(|row| NotCompiled::NotHeldContact { contact: unknown[row][0] })?;
    let found: Vec<(Sym, Sym)> = unknown.iter().map(|&of| letter(of)).zip(values).collect();
    let all = |expressions: &[Sym]| substitute_all(&substitute_all(expressions, &given), &found);
    let letters: Vec<Sym> =
        (0..mode.phases.len()).flat_map(|contact| [0, 1].map(|component| letter([contact, component]))).collect();
    let reactions = all(&letters).as_chunks::<2>().0.to_vec();
    Ok((Closed { reactions, determinant }, all(&[accelerations, multipliers].concat())))
}

/// 1 or -1.
pub(super) fn number(sign: f64) -> Sym {
    if sign < 0.0 { -Sym::ONE } else { Sym::ONE }
}
