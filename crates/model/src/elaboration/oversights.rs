//! Warnings about parameters that are unused, and about parameters without a unit in expressions of inconsistent dimensions.

use crate::{
    ContactSource, DriveSource, Entry, Fault, InertiaSource, LoadSource, OneWaySource, RegulatorSource, Source, Text,
    WindingSource,
};
use rustc_hash::FxHashSet;

/// Returns a warning for each parameter that occurs in no expression.
pub(super) fn unused(source: &Source) -> Vec<Fault> {
    let used: FxHashSet<&str> = texts(source).into_iter().flat_map(|text| words(&text.text)).collect();
    let is_unused = |entry: &&Entry| !used.contains(entry.name.text.as_str());
    let warning = |entry: &Entry| {
        let title = format!("the parameter `{}` is not used", entry.name.text);
        Fault::at(entry.name.span(), title, "no expression of the file contains it", "use it or remove it")
    };
    source.parameters.iter().filter(is_unused).map(warning).collect()
}

/// Extends a fault of dimensions by the parameter without a unit that its expression contains.
pub(super) fn name_bare_parameters(source: &Source, faults: &mut [Fault]) {
    let texts = texts(source);
    for fault in faults.iter_mut().filter(|fault| fault.title.contains("dimension")) {
        let holds = |text: &&&Text| text.start <= fault.span.start && fault.span.end <= text.span().end;
        let Some(text) = texts.iter().find(holds) else { continue };
        let part = text.text.get(fault.span.start - text.start..fault.span.end - text.start).unwrap_or_default();
        let is_bare = |entry: &&Entry| units::quantity::finite(entry.value.text.trim()).is_ok();
        let named = |entry: &&Entry| words(part).any(|word| word == entry.name.text);
        let Some(Entry { name, value }) = source.parameters.iter().filter(is_bare).find(named) else { continue };
        let needed = fault.title.rsplit_once(" must have the dimension ").map(|(_, dimension)| dimension);
        let unit = needed.filter(|_| part.trim() == name.text).unwrap_or("kg");
        let (name, value) = (&name.text, value.text.trim());
        fault.accepted = format!(
            "`{name} = {value}` in [parameters] has no unit; with one it is written {name} = \"{value} {unit}\"; or {}",
            fault.accepted
        );
    }
}

/// Returns the words of a text: names, and units.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_'))
}

/// Returns every text that may contain parameters.
fn texts(source: &Source) -> Vec<&Text> {
    let Source { speeds, definitions, frames, points, energies, outputs, start, .. } = source;
    let entries = [speeds, definitions, frames, points, energies, outputs, start].into_iter().flatten();
    let set = source.events.iter().flat_map(|event| &event.set);
    let mut texts: Vec<&Text> = entries.chain(set).map(|entry| &entry.value).chain(&source.gravity).collect();
    for body in &source.bodies {
        texts.extend([&body.turns, &body.frame, &body.centre, &body.mass].into_iter().flatten());
        match &body.inertia {
            None => {}
            Some(InertiaSource::Axial(moment)) => texts.push(moment),
            Some(InertiaSource::Tensor { axes, entries }) => texts.extend(axes.iter().chain(entries.iter().flatten())),
        }
    }
    for LoadSource { on, along, between, is, .. } in source.forces.iter().chain(&source.torques) {
        texts.extend(on.iter().chain(along).chain(between.iter().flatten()).chain([is]));
    }
    for constraint in &source.constraints {
        texts.extend(constraint.zero.iter().chain(constraint.gains.iter().flatten()));
    }
    for ContactSource { of, with, between, through, normal, gap, friction, restitution, .. } in &source.contacts {
        texts.extend([of, with, between, through, normal, gap, friction, restitution].into_iter().flatten());
    }
    for OneWaySource { speed, drop, .. } in &source.one_ways {
        texts.extend(drop.iter().chain([speed]));
    }
    for DriveSource { turns, between, ratio, inertia, torque, windings, .. } in &source.drives {
        texts.extend([turns, ratio, inertia, torque].into_iter().flatten().chain(between.iter().flatten()));
        for WindingSource { inductance, resistance, supply, motional, .. } in windings {
            texts.extend([resistance, supply, motional].into_iter().flatten().chain([inductance]));
        }
    }
    texts.extend(source.inputs.iter().filter_map(|input| input.value.as_ref()));
    texts.extend(source.events.iter().map(|event| &event.when));
    if let Some(RegulatorSource { cost, last, horizon, displaced, .. }) = &source.regulator {
        texts.extend(last.iter().chain(horizon).chain(displaced.iter().map(|entry| &entry.value)).chain([cost]));
    }
    texts
}
