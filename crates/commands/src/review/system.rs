//! Changes of a system in its file: terms of equations with the principles that show them, steady motions, and the run.

use super::renamed_coordinates::{Renamed, candidates, with_new_names};
use super::{run, steady_motions};
use crate::exit::Exit;
use ::scenes::SystemText;
use ::scenes::derivation::{NamedPrinciple, derived};
use ::scenes::steady_motions::Range;
use claims::review::compare;
use model::{MatrixForm, Model};
use std::collections::BTreeMap;
use symbolic::{Dimension, Sym};

/// Changes grouped under titles.
pub(super) type Changes = Vec<(String, Vec<String>)>;

/// All changes between two texts of a system.
pub(super) fn changes(texts: [SystemText; 2], ranges: &[(String, Range)]) -> Result<Changes, Exit> {
    let renamed = renamed(&texts)?;
    let mut all = of_equations(&texts)?;
    all.push(("steady motions".to_owned(), steady_motions::changes(&texts, ranges, &renamed)));
    all.push(("run".to_owned(), run::changes(&texts, &renamed)));
    Ok(all)
}

/// The changes of coordinates, parameters and equations.
pub(super) fn of_equations(texts: &[SystemText; 2]) -> Result<Changes, Exit> {
    let [old, new] = [texts[0].for_equations()?, texts[1].for_equations()?];
    let renamed = renamed(texts)?;
    let told = renamed.iter().map(|(old, new)| format!("{old}: {new} now, and the same in its equation"));
    let mut all: Changes =
        vec![("coordinates".to_owned(), told.collect()), ("parameters".to_owned(), parameters([&old, &new]))];
    all.extend(equations(texts, [&old, &new], &renamed));
    Ok(all)
}

/// Coordinates that were renamed, with unchanged equations.
fn renamed(texts: &[SystemText; 2]) -> Result<Renamed, Exit> {
    let [old, new] = [texts[0].for_equations()?, texts[1].for_equations()?];
    let renamed = candidates([&old, &new]);
    if renamed.is_empty() {
        return Ok(renamed);
    }
    let dimensions = dimensions([&old, &new]);
    let dimension = |letter: &str| dimensions.get(letter).copied();
    let usual = NamedPrinciple::usual(&new);
    let rows = [0, 1].map(|at| rows(&texts[at], usual));
    let [Some(before), Some(now)] = rows else { return Ok(Vec::new()) };
    let is_same = |(old, new): &(String, String)| {
        let sides = before.get(old).map(|before| with_new_names(before, &renamed)).zip(now.get(new));
        sides.is_some_and(|(before, now)| {
            before == *now || compare(&before, now, &dimension).is_some_and(|terms| terms.is_empty())
        })
    };
    Ok(if renamed.iter().all(is_same) { renamed } else { Vec::new() })
}

/// The changes of parameters and of their values.
fn parameters(models: [&Model; 2]) -> Vec<String> {
    let [old, new] =
        models.map(|model| model.parameters.iter().map(|own| (&own.name, &own.written)).collect::<BTreeMap<_, _>>());
    let moved = new.iter().filter(|(name, written)| old.get(*name).is_none_or(|before| before != *written));
    let moved = moved.map(|(name, written)| match old.get(name) {
        Some(before) => format!("{name}: {before} before, {written} now"),
        None => format!("{name}: new, {written}"),
    });
    let gone = old.iter().filter(|(name, _)| !new.contains_key(*name));
    moved.chain(gone.map(|(name, written)| format!("{name}: gone, {written}"))).collect()
}

/// The changes of each equation, with the principles that show them.
fn equations(texts: &[SystemText; 2], models: [&Model; 2], renamed: &Renamed) -> Changes {
    let dimensions = dimensions(models);
    let dimension = |letter: &str| dimensions.get(letter).copied();
    let mut all: Vec<(Vec<String>, Vec<&'static str>)> = Vec::new();
    let usual = NamedPrinciple::usual(models[1]);
    let others = NamedPrinciple::all().into_iter().filter(|one| *one != usual);
    for principle in std::iter::once(usual).chain(others) {
        let [Some(old), Some(new)] = [0, 1].map(|at| rows(&texts[at], principle)) else { continue };
        let now = |text: &String| with_new_names(text, renamed);
        let old: BTreeMap<String, String> = old.iter().map(|(label, row)| (now(label), now(row))).collect();
        let mut told = Vec::new();
        for (label, equation) in &new {
            match old.get(label) {
                None => told.push(format!("equation of {label}: new, {equation}")),
                Some(before) if before == equation => {}
                Some(before) => match compare(before, equation, &dimension) {
                    Some(terms) if terms.is_empty() => {}
                    Some(terms) => {
                        told.extend(terms.iter().map(|term| format!("equation of {label}: {term}")));
                    }
                    None => told.push(format!("equation of {label}: {before} before, {equation} now")),
                },
            }
        }
        told.extend(
            old.keys().filter(|label| !new.contains_key(*label)).map(|label| format!("equation of {label}: gone")),
        );
        match all.iter_mut().find(|(known, _)| *known == told) {
            Some((_, principles)) => principles.push(principle.name()),
            None => all.push((told, vec![principle.name()])),
        }
    }
    all.into_iter().map(|(told, principles)| (format!("equations, by {}", principles.join(", ")), told)).collect()
}

/// The equations by the names of their coordinates and constraints; `None` where the principle does not apply or the equations are too long.
fn rows(text: &SystemText, principle: NamedPrinciple) -> Option<BTreeMap<String, String>> {
    let written = derived(text, Some(principle), false, |derived| {
        let form = derived.for_reading().ok()?;
        let own = (0..form.speeds.len())
            .map(|row| (form.speeds[row].to_string().trim_end_matches('\'').to_owned(), equation(&form, row)));
        let held = form.constraints.iter().enumerate().map(|(place, one)| {
            let name = if one.name.is_empty() {
                format!("constraint {}", place + 1)
            } else {
                format!("constraint `{}`", one.name)
            };
            (name, format!("{} = 0", one.zero))
        });
        Some(own.chain(held).collect())
    });
    written.ok().flatten()
}

/// A row of M q'' + h - Q - Jᵀλ = 0, as text.
fn equation(form: &MatrixForm, row: usize) -> String {
    let inertia = form.mass[row].iter().zip(&form.accelerations).fold(Sym::ZERO, |sum, (m, a)| sum + *m * *a);
    let held = form.constraints.iter().zip(&form.multipliers);
    let reactions = held.fold(Sym::ZERO, |sum, (one, multiplier)| sum + one.row[row] * *multiplier);
    format!("{} = 0", inertia + form.inertia[row] - form.forces[row] - reactions)
}

fn dimensions(models: [&Model; 2]) -> BTreeMap<String, Dimension> {
    let mut all = BTreeMap::new();
    for model in models {
        all.extend(model.parameters.iter().map(|own| (own.name.clone(), own.dimension)));
        for own in &model.coordinates {
            let [rate, second] =
                [own.dimension / Dimension::time(), own.dimension / Dimension::time() / Dimension::time()];
            all.insert(own.name.clone(), own.dimension);
            all.insert(format!("{}'", own.name), rate);
            all.insert(format!("{}''", own.name), second);
        }
    }
    all
}
