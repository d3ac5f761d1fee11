//! Elaboration of a system: one pass, or two if its loads contain reactions.

use super::one_sided_loads::{Load, one_sided};
use super::reactions::{ReactionLetter, with_laws};
use super::{
    Elaborator, axial, conditions_of_law, contact_checks, inertialess, names, order, oversights, released,
    turning_inertias, unheld_axes,
};
use crate::{Fault, Model, Source};
use std::ops::Range;

/// Elaborates a system, including the checks of contacts and the released guides.
pub(crate) fn elaborate(source: &Source) -> Result<Model, Vec<Fault>> {
    let mut model = elaborated(source)?;
    if !model.contacts.is_empty() {
        contact_checks::checked(&model)?;
        released::release(source, &mut model)?;
    }
    Ok(model)
}

/// Elaborates a system without releasing guides. If loads or events contain reactions, a second pass represents these
/// as rates of coordinates.
pub(super) fn elaborated(source: &Source) -> Result<Model, Vec<Fault>> {
    let first = Elaborator::new(source, Vec::new()).resolved()?;
    if first.reaction_letters.is_empty() {
        return settled(source, first);
    }
    let letters = first.reaction_letters.clone();
    let open = settled(source, first)?;
    let mut second = Elaborator::new(source, letters.clone()).resolved()?;
    with_laws(&mut second.model, &open, &letters)?;
    settled(source, second)
}

/// Completes an elaborated model: simplifications, laws of coordinates without inertia, checks and warnings.
fn settled(source: &Source, Resolved { mut model, loads, .. }: Resolved) -> Result<Model, Vec<Fault>> {
    model.hold(&source.rigid)?;
    model.leave_out(&source.absent);
    conditions_of_law::keep_those_of_law(&mut model);
    conditions_of_law::share_equal(&mut model);
    let mut faults = axial::tilted(&model);
    faults.extend(turning_inertias::turning(&model));
    if faults.is_empty() {
        faults = inertialess::settle(&mut model);
    }
    oversights::name_bare_parameters(source, &mut faults);
    if !faults.is_empty() {
        return Err(faults);
    }
    model.warnings.extend(one_sided(&model, &loads));
    model.warnings.extend(unheld_axes::unheld_axes(source, &model));
    model.warnings.extend(oversights::unused(source));
    model.warnings.sort_by_key(|warning| warning.span.start);
    Ok(model)
}

/// A system whose names are resolved.
struct Resolved {
    model: Model,
    loads: Vec<(Load, Range<usize>)>,
    reaction_letters: Vec<ReactionLetter>,
}

impl Elaborator<'_> {
    fn resolved(mut self) -> Result<Resolved, Vec<Fault>> {
        let reads_again = self.reaction_letters.is_empty();
        self.letters();
        self.charges();
        self.impulses();
        for kind in order::ordered(self.source, &mut self.faults, &mut self.broken) {
            self.define(kind);
        }
        self.bodies();
        self.loads();
        self.rates();
        self.events();
        self.quasi_velocities();
        // the impulses of reactions, which may have start values, exist only in the second pass
        if !reads_again || self.reaction_letters.is_empty() {
            self.start();
        }
        self.regulator();
        self.confine_reactions();
        self.model.equilibrium.clone_from(&self.source.equilibrium);
        let Elaborator { source, mut model, mut faults, headless, loads, reaction_letters, .. } = self;
        model.warnings.sort_by_key(|warning| warning.span.start);
        // keys below a wrong heading are missing elsewhere, hence these faults may cause the others
        if !headless.is_empty() {
            faults = headless.into_iter().map(|(_, fault)| fault).collect();
        }
        faults.sort_by_key(|fault| fault.span.start);
        names::once_for_each_name(&mut faults);
        if faults.is_empty() {
            return Ok(Resolved { model, loads, reaction_letters });
        }
        oversights::name_bare_parameters(source, &mut faults);
        Err(faults)
    }
}
