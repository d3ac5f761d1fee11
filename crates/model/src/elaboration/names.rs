//! Faults of names: unknown names and names defined twice. Each name is reported once.

use crate::{Fault, Source, Text};
use rustc_hash::FxHashSet;
use std::ops::Range;
use symbolic::Dimension;

/// Returns the fault of a name that has two definitions, with the kind of the other one.
pub(super) fn defined_twice(source: &Source, name: &Text) -> Fault {
    let Source { parameters, coordinates, definitions, frames, points, speeds, bodies, inputs, .. } = source;
    let tables = [
        ("a parameter", parameters),
        ("a coordinate", coordinates),
        ("a definition", definitions),
        ("a frame", frames),
        ("a point", points),
        ("a quasi-velocity", speeds),
    ];
    let entries = tables.into_iter().flat_map(|(kind, table)| table.iter().map(move |entry| (kind, &entry.name)));
    let bodies = bodies.iter().map(|body| ("a body", &body.name));
    let inputs = inputs.iter().map(|input| ("an input", &input.name));
    let is_other = |(_, other): &(&str, &Text)| other.text == name.text && !std::ptr::eq(*other, name);
    let other = entries.chain(bodies).chain(inputs).find(is_other);
    let label = other.map_or_else(|| "again".to_owned(), |(kind, _)| format!("it is the name of {kind} already"));
    Fault::at(name.span(), format!("`{}` is defined twice", name.text), label, "each name stands for one thing")
}

/// Leaves of several faults about one name that is not known the first.
pub(super) fn once_for_each_name(faults: &mut Vec<Fault>) {
    let mut told: FxHashSet<String> = FxHashSet::default();
    faults.retain(|fault| match fault.title.split_once(" is called ") {
        Some((_, name)) => told.insert(name.to_owned()),
        None => true,
    });
}

/// Returns the label of a number of the dimension `found`, which is not the needed one.
pub(super) fn wrong_dimension(number: &str, found: Dimension) -> String {
    match number.trim().parse::<f64>() {
        Ok(_) => format!("`{}` has no unit", number.trim()),
        Err(_) => format!("this has the dimension {found}"),
    }
}

/// Returns the fault of an unknown name, with the most similar known name. If the definition of the name is wrong, this is only a consequence.
pub(super) fn unknown<'a>(
    broken: &FxHashSet<String>,
    span: Range<usize>,
    name: &str,
    kind: &str,
    known: impl Iterator<Item = &'a str>,
) -> Fault {
    if broken.contains(name.trim()) {
        return Fault::consequence(span);
    }
    let mut known: Vec<&str> = known.collect();
    known.sort_unstable();
    known.dedup();
    let accepted = match rate_in_letters(name, &known)
        .or_else(|| units::nearest(name, known.iter().copied()).map(str::to_owned))
    {
        Some(nearest) => format!("is `{nearest}` meant?"),
        None if known.is_empty() => format!("the system has no {kind}"),
        None => format!("known here: {}", known.join(", ")),
    };
    Fault::at(span, format!("no {kind} is called `{name}`"), "not known", accepted)
}

/// Recognises `thdot`, `th_dot` and `thddot`, and returns the notation of this program: th' and th''.
fn rate_in_letters(name: &str, known: &[&str]) -> Option<String> {
    let of = |ends: [&str; 2], primes: &str| {
        let base = ends.into_iter().find_map(|end| name.strip_suffix(end))?;
        known.contains(&base).then(|| format!("{base}{primes}"))
    };
    of(["_ddot", "ddot"], "''").or_else(|| of(["_dot", "dot"], "'"))
}
