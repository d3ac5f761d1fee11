//! Mistaken derivations, and the terms that they lose.
//!
//! * Constraints of speeds are substituted into the kinetic energy before Lagrange's equations are formed for the independent
//!   coordinates: terms with the momenta along Lie brackets of the constraints' vector fields are lost, unless the constraints are integrable.
//! * The energy of accelerations is formed from the kinetic energy with u' in place of u: all centrifugal and Coriolis terms are lost.

use crate::Trace;
use crate::agreement::{Agreement, decided};
use crate::equations::{Level, constraints_of, vanishes};
use crate::principles::hamilton::momenta;
use crate::principles::lagrange::inertia;
use crate::principles::{NotApplicable, linear, operator};
use symbolic::{Sym, substitute_all};

/// A mistaken derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// Constraints of speeds are substituted into T before Lagrange's derivatives are taken.
    ConstraintsInEnergy,
    /// The energy of accelerations is T with u' in place of u.
    AccelerationsInEnergy,
}

impl Mistake {
    pub const ALL: [Mistake; 2] = [Mistake::ConstraintsInEnergy, Mistake::AccelerationsInEnergy];

    /// Returns the name in commands.
    pub fn name(self) -> &'static str {
        match self {
            Mistake::ConstraintsInEnergy => "constraints-in-energy",
            Mistake::AccelerationsInEnergy => "accelerations-in-energy",
        }
    }

    /// Returns a description of the derivation.
    pub fn says(self) -> &'static str {
        match self {
            Mistake::ConstraintsInEnergy => "Lagrange's equations with the constraints put into T",
            Mistake::AccelerationsInEnergy => "Appell's equations with S made of T by writing u' for u",
        }
    }
}

/// The equations of a mistaken derivation, compared with the correct ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistaken {
    /// A description of the derivation; if no term is lost, also the reason.
    pub says: String,
    pub agreement: Agreement,
    /// For each equation that loses a term: its speed or coordinate, and the term that is missing on the inertia
    /// side.
    pub lost: Vec<(String, Sym)>,
}

/// Compares a mistaken derivation with the correct one.
///
/// # Errors
/// The mistake is impossible for this model.
pub fn mistaken(trace: &Trace<'_>, mistake: Mistake) -> Result<Mistaken, NotApplicable> {
    let (mut found, reason) = match mistake {
        Mistake::ConstraintsInEnergy => constraints_in_energy(trace)?,
        Mistake::AccelerationsInEnergy => {
            (accelerations_in_energy(trace), "its inertia has no part without accelerations")
        }
    };
    if !matches!(found.agreement, Agreement::Refuted { .. } | Agreement::Undecided { .. }) {
        found.says = format!("{} lose no term in this system, since {reason}", mistake.says());
    }
    Ok(found)
}

/// Returns the comparison, and the reason if the derivation loses nothing.
fn constraints_in_energy(trace: &Trace<'_>) -> Result<(Mistaken, &'static str), NotApplicable> {
    let constraints = constraints_of(trace);
    if constraints.iter().all(|constraint| constraint.level == Level::Position) {
        return Err(NotApplicable("the system has no constraint that contains speeds".to_owned()));
    }
    let characteristics = trace.characteristics();
    let motion = linear(&constraints, characteristics.motion(trace, &constraints))?;
    let inertia: Vec<Sym> = (0..trace.speeds.len()).map(|i| inertia(trace, i)).collect();
    let right = motion.on_constraints(&characteristics.along(&inertia));
    let naive = operator(trace, characteristics, &motion);
    let agreement = decided(
        trace,
        Mistake::ConstraintsInEnergy.name(),
        &naive.energy.iter().copied().zip(right).collect::<Vec<_>>(),
    );
    let is_integrable =
        trace.model.free.is_empty() && naive.brackets.iter().flatten().all(|&bracket| vanishes(bracket));
    let reason = if is_integrable { "its constraints of speeds are integrable" } else { "the lost terms cancel" };
    let sums = naive.lost.iter().map(|parts| parts.iter().fold(Sym::ZERO, |sum, &part| sum + part));
    let names = characteristics.independent.iter().map(|&i| trace.direction(i));
    // the correct inertia is the operator minus the lost term
    let lost: Vec<Sym> = trace.with_masses(&sums.map(|lost| -lost).collect::<Vec<_>>());
    let says = Mistake::ConstraintsInEnergy.says().to_owned();
    Ok((Mistaken { says, agreement, lost: named(names, lost.into_iter()) }, reason))
}

fn accelerations_in_energy(trace: &Trace<'_>) -> Mistaken {
    let primed: Vec<(Sym, Sym)> = trace.speeds.iter().copied().zip(trace.accelerations.iter().copied()).collect();
    let n = trace.speeds.len();
    let naive = substitute_all(&momenta(trace), &primed);
    let right: Vec<Sym> = (0..n).map(|i| inertia(trace, i)).collect();
    let agreement = decided(
        trace,
        Mistake::AccelerationsInEnergy.name(),
        &naive.iter().copied().zip(right.iter().copied()).collect::<Vec<_>>(),
    );
    let names = (0..n).map(|i| trace.direction(i));
    let lost: Vec<Sym> = right.into_iter().zip(naive).map(|(right, naive)| right - naive).collect();
    let says = Mistake::AccelerationsInEnergy.says().to_owned();
    Mistaken { says, agreement, lost: named(names, trace.with_masses(&lost).into_iter()) }
}

/// Returns the nonzero terms with their names.
fn named(names: impl Iterator<Item = String>, terms: impl Iterator<Item = Sym>) -> Vec<(String, Sym)> {
    names.zip(terms).filter(|(_, term)| !vanishes(*term)).collect()
}
