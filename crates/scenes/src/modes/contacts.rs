//! Symbolic equations for the normal reaction N and the friction T of closed contacts:
//!
//!   gap'' = 0 for N (u' = 0 of a diode),    v' = 0 for T of a contact that sticks,    T = -mu |N| v/|v| of one that slides .

use super::distribution::{ROUNDS, balancing};
use super::mode::{Mode, Phase};
use crate::compiled_system::NotCompiled;
use field::Analytic;
use model::equations::{balances, constraints_of};
use model::{Contact, Trace};
use symbolic::{Derivation, Sym, substitute_all};

/// The number of reaction symbols of a contact: N, and T along each of two tangents. In the plane the last is zero.
pub(crate) const PARTS: usize = 3;

/// The normal and tangential equations of each contact, as expressions equal to zero; for a guide that the coordinates satisfy, the
/// balance of forces across it. They contain accelerations and multipliers.
pub(super) fn kept_at_zero(trace: &Trace<'_>) -> Vec<[Sym; PARTS]> {
    let of = |(contact, balance): (&Contact, Option<Sym>)| {
        let normal = balance.unwrap_or_else(|| trace.rate_of(trace.gap_rate(contact)));
        let [along, aside] = slides(trace, contact).map(|slide| trace.rate_of(slide));
        [normal, along, aside]
    };
    trace.model.contacts.iter().zip(balances(trace)).map(of).collect()
}

/// Substitutions of accelerations and multipliers by expressions.
pub(super) fn motion(trace: &Trace<'_>, accelerations: &[Sym], multipliers: &[Sym]) -> Vec<(Sym, Sym)> {
    let of_constraints = constraints_of(trace).into_iter().map(|one| one.multiplier);
    let letters = trace.accelerations.iter().copied().chain(of_constraints);
    letters.zip(accelerations.iter().chain(multipliers).copied()).collect()
}

/// The sliding velocity along each tangent, m/s; in the plane the last is zero.
pub(super) fn slides(trace: &Trace<'_>, contact: &Contact) -> [Sym; 2] {
    [0, 1].map(|tangent| contact.slides.get(tangent).map_or(Sym::ZERO, |&slide| trace.scalar(slide)))
}

/// The indices of the unknown reactions of a contact in a phase: 0 for N, 1 and 2 for T.
pub(super) fn unknown_parts(phase: Phase, is_in_space: bool) -> &'static [usize] {
    match phase {
        Phase::Apart | Phase::Carried => &[],
        Phase::Sticks(_) if is_in_space => &[0, 1, 2],
        Phase::Sticks(_) | Phase::Leans { held: [true, false], .. } => &[0, 1],
        Phase::Leans { held: [true, true], .. } => &[0, 1, 2],
        Phase::Leans { held: [false, true], .. } => &[0, 2],
        Phase::Leans { held: [false, false], .. }
        | Phase::Slips { .. }
        | Phase::Glides { .. }
        | Phase::Rests { .. } => &[0],
    }
}

/// The unknown reactions of a mode, as pairs of contact and component.
pub(super) fn unknown(mode: &Mode, is_in_space: impl Fn(usize) -> bool) -> Vec<[usize; 2]> {
    let of = |(contact, phase): (usize, &Phase)| {
        unknown_parts(*phase, is_in_space(contact)).iter().map(move |&component| [contact, component])
    };
    mode.phases.iter().enumerate().flat_map(of).collect()
}

/// The symbols of all reactions, contact by contact.
pub(crate) fn letters(trace: &Trace<'_>) -> Vec<Sym> {
    let contacts = 0..trace.model.contacts.len();
    contacts.flat_map(|contact| (0..PARTS).map(move |part| trace.reaction(contact, part))).collect()
}

/// The ratio T/N along each tangent for a sliding contact; `None` for other phases.
fn over_normal(trace: &Trace<'_>, contact: usize, phase: Phase) -> Option<[Sym; 2]> {
    let face = number(phase.face()?.sign());
    let most = friction(trace, contact) * face;
    match phase {
        Phase::Glides { .. } => {
            let slides = slides(trace, &trace.model.contacts[contact]);
            let speed = (slides[0] * slides[0] + slides[1] * slides[1]).sqrt();
            Some(slides.map(|slide| -most * slide / speed))
        }
        _ => Some([-number(phase.way()?) * most, Sym::ZERO]),
    }
}

/// The coefficient of friction of a contact; zero for a smooth contact.
pub(super) fn friction(trace: &Trace<'_>, contact: usize) -> Sym {
    trace.model.contacts[contact].friction.map_or(Sym::ZERO, |friction| trace.scalar(friction))
}

/// The equations for the unknown reactions of a mode.
pub(super) struct ReactionEquations {
    /// Reactions that are zero, or proportional to a normal reaction.
    pub given: Vec<(Sym, Sym)>,
    /// The contact and the component of each unknown reaction.
    pub unknown: Vec<[usize; 2]>,
    /// The matrix of the linear equations, by rows.
    pub rows: Vec<Vec<Sym>>,
    /// Their right side.
    pub right: Vec<Sym>,
    /// The equations as expressions equal to zero.
    zeros: Vec<Sym>,
}

impl ReactionEquations {
    /// The equations of a mode. Accelerations and multipliers contain the symbols of reactions. `settled` has symbols with known
    /// expressions, `is_direct` is true for contacts that the mode determines directly.
    pub fn of(
        trace: &Trace<'_>,
        mode: &Mode,
        (settled, is_direct): (&[(Sym, Sym)], &[bool]),
        (accelerations, multipliers): (&[Sym], &[Sym]),
    ) -> Self {
        let letter = |[contact, component]: [usize; 2]| trace.reaction(contact, component);
        let mut given: Vec<(Sym, Sym)> = Vec::new();
        let leant = leant(mode);
        for (contact, phase) in mode.phases.iter().enumerate().filter(|(contact, _)| !is_direct[*contact]) {
            let is_in_space = trace.model.contacts[contact].is_in_space();
            match over_normal(trace, contact, *phase) {
                Some(factors) => given
                    .extend((1..PARTS).map(|part| (letter([contact, part]), factors[part - 1] * letter([contact, 0])))),
                None => {
                    let unknown = unknown_parts(*phase, is_in_space);
                    let none = (0..PARTS).filter(|part| !unknown.contains(part) && !leant.contains(&[contact, *part]));
                    given.extend(none.map(|part| (letter([contact, part]), Sym::ZERO)));
                }
            }
        }
        let mut unknown = unknown(mode, |contact| trace.model.contacts[contact].is_in_space());
        unknown.retain(|[contact, _]| !is_direct[*contact]);
        let kept = kept_at_zero(trace);
        let zeros: Vec<Sym> = unknown.iter().map(|&[contact, component]| kept[contact][component]).collect();
        let zeros = substitute_all(&zeros, &motion(trace, accelerations, multipliers));
        let zeros = substitute_all(&substitute_all(&zeros, settled), &given);
        let none: Vec<(Sym, Sym)> = unknown.iter().chain(&leant).map(|&of| (letter(of), Sym::ZERO)).collect();
        let row = |&zero: &Sym| unknown.iter().map(|&of| slope(trace, zero, of)).collect();
        let rows = zeros.iter().map(row).collect();
        let right = substitute_all(&zeros, &none).into_iter().map(|zero| -zero).collect();
        ReactionEquations { given, unknown, rows, right, zeros }
    }

    /// The solution for a right side, and the determinant.
    ///
    /// # Errors
    /// [`NotCompiled::NotHeldContact`] with the contact whose equation has no pivot.
    pub fn solved(&self, right: Vec<Sym>) -> Result<(Vec<Sym>, Sym), NotCompiled> {
        super::held::eliminated(self.rows.clone(), right)
            .map_err(|row| NotCompiled::NotHeldContact { contact: self.unknown[row][0] })
    }
}

/// The derivative of an expression by a reaction.
fn slope(trace: &Trace<'_>, expression: Sym, [contact, component]: [usize; 2]) -> Sym {
    Derivation::new([(trace.reaction(contact, component), Sym::ONE)]).of(expression)
}

/// The reactions of a mode.
pub(super) struct Closed {
    /// Symbols with their expressions: reactions that follow from others, then the solution.
    pub found: Vec<Vec<(Sym, Sym)>>,
    /// The determinant of the equations: where it is zero, reactions are not determined or unbounded.
    pub determinant: Sym,
}

/// The reactions of a mode, and accelerations, then multipliers, with these reactions inserted. `settled` has symbols with known
/// expressions, `is_direct` is true for contacts that the mode determines directly.
pub(super) fn closed(
    trace: &Trace<'_>,
    mode: &Mode,
    (settled, is_direct): (&[(Sym, Sym)], &[bool]),
    accelerations: &[Sym],
    multipliers: &[Sym],
) -> Result<(Closed, Vec<Sym>), NotCompiled> {
    let letter = |[contact, component]: [usize; 2]| trace.reaction(contact, component);
    let leant = leant(mode);
    let equations = ReactionEquations::of(trace, mode, (settled, is_direct), (accelerations, multipliers));
    let (values, determinant) = equations.solved(equations.right.clone())?;
    let ReactionEquations { given, unknown, zeros, .. } = &equations;
    let found: Vec<(Sym, Sym)> = unknown.iter().map(|&of| letter(of)).zip(values.iter().copied()).collect();
    let one_choice: Vec<(Sym, Sym)> =
        found.iter().copied().chain(leant.iter().map(|&of| (letter(of), Sym::ZERO))).collect();
    let all = |expressions: &[Sym], found: &[(Sym, Sym)]| substitute_all(&substitute_all(expressions, given), found);
    let mut shown = one_choice.clone();
    if !leant.is_empty() {
        let mut columns: Vec<Vec<Sym>> = Vec::new();
        for &of in &leant {
            let right = zeros.iter().map(|&zero| -slope(trace, zero, of)).collect();
            columns.push(equations.solved(right)?.0);
        }
        let held = |contact: usize| mode.phases[contact].sticking().is_some();
        let friction_of = |&place: &usize| unknown[place][1] > 0 && held(unknown[place][0]);
        let following: Vec<usize> = (0..unknown.len()).filter(friction_of).collect();
        let at = |all: &[Sym]| -> Vec<Sym> { following.iter().map(|&place| all[place]).collect() };
        let of_friction: Vec<Vec<Sym>> = columns.iter().map(|column| at(column)).collect();
        for _ in 0..ROUNDS {
            let bound = |[contact, _]: [usize; 2]| friction(trace, contact) * letter([contact, 0]).substitute(&shown);
            let bounds: Vec<Sym> = following.iter().map(|&place| bound(unknown[place])).collect();
            let bounds_leaning: Vec<Sym> = leant.iter().map(|&of| bound(of)).collect();
            let solved = |rows, right| super::held::eliminated(rows, right).ok().map(|(values, _)| values);
            let shares = balancing(&at(&values), &of_friction, [&bounds, &bounds_leaning], solved).unwrap_or_default();
            let following = values.iter().enumerate().map(|(place, &value)| {
                let parts = columns.iter().zip(&shares).map(|(column, &share)| column[place] * share);
                parts.fold(value, |sum, part| sum + part)
            });
            let all = following.chain(shares.iter().copied());
            shown = unknown.iter().chain(&leant).map(|&of| letter(of)).zip(all).collect();
        }
    }
    let moved = [all(accelerations, &one_choice), all(multipliers, &shown)].concat();
    Ok((Closed { found: vec![given.clone(), shown], determinant }, moved))
}

/// The undetermined friction of leaning contacts: contact and component, along the tangents in which other contacts hold them.
pub(super) fn leant(mode: &Mode) -> Vec<[usize; 2]> {
    let of = |(contact, phase): (usize, &Phase)| {
        let held = if let Phase::Leans { held, .. } = phase { *held } else { [true; 2] };
        (0..2).filter(move |&tangent| !held[tangent]).map(move |tangent| [contact, tangent + 1])
    };
    mode.phases.iter().enumerate().flat_map(of).collect()
}

/// -1 for a negative number, else 1.
pub(super) fn number(sign: f64) -> Sym {
    if sign < 0.0 { -Sym::ONE } else { Sym::ONE }
}
