//! The system with its guides released. The coordinates satisfy a guide identically, so that its reaction is not determined by a multiplier. It is computed as the
//! force along an additional coordinate that stays at zero (an auxiliary speed, Kane).
//!
//! The point of a body from which its other points are defined, S = O + s N.x, becomes S = (O + s N.x) + guide N.y. All points that depend on S move with it.

use super::guides::Guide;
use super::resolution::elaborated;
use crate::equations::constraints_of;
use crate::{Entry, Fault, Model, PointId, Source, Trace};
use symbolic::{Sym, apart};

/// Adds the released system to a model with a guide that its coordinates satisfy identically.
pub(super) fn release(source: &Source, model: &mut Model) -> Result<(), Vec<Fault>> {
    let guides: Vec<usize> = apart(|| {
        let trace = Trace::of(model);
        let is_kept = |&place: &usize| {
            if model.contacts[place].one_way.is_some() {
                return false;
            }
            let rate = trace.rate_of(trace.scalar(model.contacts[place].gap));
            (0..trace.speeds.len()).all(|speed| is_zero(trace.by_speed(rate, speed)))
        };
        (0..model.contacts.len()).filter(is_kept).collect()
    });
    if guides.is_empty() {
        return Ok(());
    }
    let mut released = source.clone();
    for (number, &place) in guides.iter().enumerate() {
        let at = model.contacts[place].at.clone();
        let fault = |title: &str, label: &str, accepted: &str| Err(vec![Fault::at(at.clone(), title, label, accepted)]);
        let name = free_name(source, number);
        let contact = &source.contacts[place];
        let Some(normal) = normal_of(contact) else {
            return fault("a guide has a normal", "none is known", "between = \"slider, N along x\"");
        };
        let Some(point) = base_of(model, model.contacts[place].point, model.contacts[place].with.is_none()) else {
            let accepted = "a centre that is a named point: S = \"O + s*N.x\" under [points], centre = \"S\"";
            return fault("the reaction of this guide is not known", "its body has no named point", accepted);
        };
        let Some(entry) = released.points.iter_mut().find(|entry| entry.name.text == point) else {
            return fault("the reaction of this guide is not known", "its body has no named point", "a named point");
        };
        entry.value.text = format!("({}) + {name}*({normal})", entry.value.text);
        released.coordinates.push(Entry { name: name.as_str().into(), value: "m".into() });
        // the charges of drives follow the coordinates of the file
        model.contacts[place].guide = Some(source.coordinates.len() + number);
    }
    let released = elaborated(&released).map_err(|_| {
        let at = model.contacts[guides[0]].at.clone();
        let accepted = "a guide whose axis does not depend on the body in it";
        vec![Fault::at(at, "the reaction of this guide is not known", "its normal depends on its body", accepted)]
    })?;
    let count = |model: &Model| apart(|| constraints_of(&Trace::of(model)).len());
    if count(&released) != count(model) {
        let at = model.contacts[guides[0]].at.clone();
        let accepted = "constraints that leave the direction across the guide to it";
        let title = "the reaction of this guide is not determined";
        return Err(vec![Fault::at(at, title, "a constraint holds the body across it too", accepted)]);
    }
    model.released = Some(Box::new(released));
    Ok(())
}

fn is_zero(slope: Sym) -> bool {
    slope == Sym::ZERO || crate::equations::vanishes(slope)
}

/// Returns an unused name for the coordinate of a guide.
fn free_name(source: &Source, number: usize) -> String {
    let taken = |name: &String| {
        let Source { parameters, coordinates, definitions, frames, points, speeds, .. } = source;
        let tables = [parameters, coordinates, definitions, frames, points, speeds].into_iter().flatten();
        let names = tables.map(|entry| &entry.name.text).chain(source.bodies.iter().map(|body| &body.name.text));
        let mut names = names.chain(source.inputs.iter().map(|input| &input.name.text));
        names.any(|taken| taken == name)
    };
    let mut name = format!("guide_{}", number + 1);
    while taken(&name) {
        name.push('_');
    }
    name
}

/// Returns the normal of a contact as text.
fn normal_of(contact: &crate::ContactSource) -> Option<String> {
    match (&contact.normal, &contact.between) {
        (Some(normal), _) => Some(format!("unit({})", normal.text)),
        (None, Some(between)) => Guide::of(between).ok().map(|guide| guide.normal()),
        (None, None) => None,
    }
}

/// Returns the name of the point that must be displaced: the last named point between `point` and the ground, or for a contact with another body the first one.
fn base_of(model: &Model, point: PointId, on_ground: bool) -> Option<String> {
    let (mut at, mut found) = (point, None);
    loop {
        let point = &model.points[at.0];
        let Some((base, _)) = point.base else { return found };
        if !point.name.is_empty() {
            found = Some(point.name.clone());
            if !on_ground {
                return found;
            }
        }
        at = base;
    }
}
