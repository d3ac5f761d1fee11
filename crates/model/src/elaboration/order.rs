//! The order of definitions by dependence. A file may list them in any order without cycles.

use crate::expression::{Expression, Form, read};
use crate::{Fault, Source, Text};
use rustc_hash::{FxHashMap, FxHashSet};

/// A named definition, by its index in the table of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Definition {
    Value(usize),
    Frame(usize),
    Point(usize),
    Body(usize),
    Input(usize),
    Speed(usize),
}

/// Returns all definitions in an order in which each follows those it depends on. Definitions in a cycle are reported and omitted.
pub(super) fn ordered(source: &Source, faults: &mut Vec<Fault>, broken: &mut FxHashSet<String>) -> Vec<Definition> {
    let mut all: Vec<(Definition, &Text, Vec<&Text>)> = Vec::new();
    let entries = |entries: &'_ [crate::Entry]| entries.len();
    for (count, kind) in [
        (entries(&source.definitions), Definition::Value as fn(usize) -> Definition),
        (entries(&source.frames), Definition::Frame),
        (entries(&source.points), Definition::Point),
        (entries(&source.speeds), Definition::Speed),
    ] {
        for at in 0..count {
            let definition = kind(at);
            let entry = match definition {
                Definition::Value(at) => &source.definitions[at],
                Definition::Frame(at) => &source.frames[at],
                Definition::Speed(at) => &source.speeds[at],
                Definition::Point(at) | Definition::Body(at) | Definition::Input(at) => &source.points[at],
            };
            all.push((definition, &entry.name, vec![&entry.value]));
        }
    }
    for (at, body) in source.bodies.iter().enumerate() {
        let texts = [&body.turns, &body.frame, &body.centre].into_iter().flatten().collect();
        all.push((Definition::Body(at), &body.name, texts));
    }
    for (at, input) in source.inputs.iter().enumerate() {
        all.push((Definition::Input(at), &input.name, input.value.iter().collect()));
    }
    without_second(source, &mut all, faults, broken);
    // a definition of the file does not change the meaning of a reserved name
    let named = all.iter().enumerate().filter(|(_, (_, name, _))| !super::is_reserved(&name.text));
    let places: FxHashMap<&str, usize> = named.map(|(place, (_, name, _))| (name.text.as_str(), place)).collect();
    // x' is the rate of a coordinate; v' depends on the quasi-velocity v
    let place = |name: &String| {
        let base = name.trim_end_matches(['\'', '′', '″']);
        let is_rate = base.len() < name.len() && source.coordinates.iter().any(|entry| entry.name.text == base);
        places.get(base).filter(|_| !is_rate).copied()
    };
    let needs: Vec<Vec<usize>> = all
        .iter()
        .map(|(_, _, texts)| {
            let names = texts.iter().flat_map(|text| names_in(&text.text));
            let held = texts.iter().flat_map(|text| super::reactions::constraints_in(source, &text.text));
            let of_constraints = held.flat_map(|constraint| &constraint.zero).flat_map(|zero| names_in(&zero.text));
            let mut needs: Vec<usize> = names.chain(of_constraints).filter_map(|name| place(&name)).collect();
            needs.sort_unstable();
            needs.dedup();
            needs
        })
        .collect();
    let mut done = vec![false; all.len()];
    let mut order = Vec::new();
    let mut told: FxHashSet<usize> = FxHashSet::default();
    for first in 0..all.len() {
        // depth-first search without recursion: each definition on the path, with the index of its next dependence
        let mut path: Vec<(usize, usize)> = vec![(first, 0)];
        while let Some((at, next)) = path.last().copied() {
            if done[at] {
                path.pop();
            } else if let Some(&need) = needs[at].get(next) {
                if let Some(last) = path.last_mut() {
                    last.1 += 1;
                }
                match path.iter().position(|(on_path, _)| *on_path == need) {
                    Some(begin) => {
                        let circle: Vec<usize> = path[begin..].iter().map(|(at, _)| *at).collect();
                        broken.extend(circle.iter().map(|at| all[*at].1.text.clone()));
                        if circle.iter().all(|at| told.insert(*at)) {
                            faults.push(circular(&circle, |at| all[at].1));
                        }
                    }
                    None if !done[need] => path.push((need, 0)),
                    None => {}
                }
            } else {
                done[at] = true;
                if !told.contains(&at) {
                    order.push(all[at].0);
                }
                path.pop();
            }
        }
    }
    order
}

/// Removes and reports definitions whose name has another definition.
fn without_second<'s>(
    source: &'s Source,
    all: &mut Vec<(Definition, &'s Text, Vec<&'s Text>)>,
    faults: &mut Vec<Fault>,
    broken: &mut FxHashSet<String>,
) {
    let letters = source.parameters.iter().chain(&source.coordinates).map(|entry| entry.name.text.as_str());
    let mut known: FxHashSet<&str> = letters.collect();
    let mut in_file: Vec<&Text> = all.iter().map(|(_, name, _)| *name).collect();
    in_file.sort_by_key(|name| name.span().start);
    for name in in_file.into_iter().filter(|name| !known.insert(name.text.as_str())) {
        faults.push(super::defined_twice(source, name));
        broken.insert(name.text.clone());
    }
    all.retain(|(_, name, _)| !broken.contains(&name.text));
}

fn circular<'a>(circle: &[usize], name: impl Fn(usize) -> &'a Text) -> Fault {
    let names: Vec<&str> = circle.iter().chain(circle.first()).map(|at| name(*at).text.as_str()).collect();
    let first = name(circle[0]);
    let title = format!("`{}` is defined by itself", first.text);
    Fault::at(
        first.span(),
        title,
        names.join(" is defined by "),
        "definitions in any order, none of which contains itself",
    )
}

/// Returns every name in the text of a definition.
fn names_in(text: &str) -> Vec<String> {
    let words = || text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\'')).map(str::to_owned);
    match read(text) {
        Ok(expression) => names_of(&expression),
        // texts such as `N turned theta about z` are not expressions
        Err(_) => words().filter(|word| !word.is_empty()).collect(),
    }
}

fn names_of(expression: &Expression) -> Vec<String> {
    let mut names = Vec::new();
    for form in &expression.parts {
        match form {
            Form::Name(name) | Form::Member { of: name, .. } => names.push(name.clone()),
            Form::Call { arguments, .. } => {
                names.extend(
                    arguments.iter().filter_map(|argument| argument.place.as_ref().map(|(_, name, _)| name.clone())),
                );
            }
            _ => {}
        }
    }
    names
}
