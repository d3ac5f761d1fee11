//! Changes of a system in its file: terms of equations, with the principles that show them, steady motions, and columns of its run.

use super::renamed_coordinates::{Renamed, candidates, with_new_names};
use crate::clock;
use crate::exit::{Exit, warn};
use crate::stationary::refusals::refused;
use crate::stationary::steady_box::Found;
use crate::stationary::verdict::verdict;
use ::scenes::derivation::{NamedPrinciple, derived};
use ::scenes::steady_motions::{Range, SteadyMotions, SteadySearch};
use ::scenes::{ModelScene, SystemText, Task};
use claims::review::compare;
use model::{MatrixForm, Model};
use simulation::{Axes, Choice, IvpScene, Trajectory};
use std::collections::BTreeMap;
use std::path::Path;
use symbolic::{Dimension, Sym};

/// Changes, grouped under titles.
pub(super) type Changes = Vec<(String, Vec<String>)>;

/// Differences of a run below this part of a column's size are rounding.
const ROUNDING: f64 = 1e-9;

/// All changes between two texts.
pub(super) fn changes(texts: [SystemText; 2], ranges: &[(String, Range)]) -> Result<Changes, Exit> {
    let renamed = renamed(&texts)?;
    let mut all = of_equations(&texts)?;
    let [old, new] = [texts[0].model(Task::Vary)?, texts[1].model(Task::Vary)?];
    let asked = SteadySearch { ranges: ranges.to_vec(), boxes: MOST_BOXES, ..SteadySearch::default() };
    all.push(("steady motions".to_owned(), steady_motions(&texts[1].name, [old, new], &asked, &renamed)));
    let [old, new] =
        [ModelScene::parse(&texts[0].name, &texts[0].text)?, ModelScene::parse(&texts[1].name, &texts[1].text)?];
    all.push(("run".to_owned(), run([&old, &new], &renamed)));
    Ok(all)
}

/// Parameters and equations that differ.
pub(super) fn of_equations(texts: &[SystemText; 2]) -> Result<Changes, Exit> {
    let [old, new] = [texts[0].for_equations()?, texts[1].for_equations()?];
    let renamed = renamed(texts)?;
    let told = renamed.iter().map(|(old, new)| format!("{old}: {new} now, and the same in its equation"));
    let mut all: Changes =
        vec![("coordinates".to_owned(), told.collect()), ("parameters".to_owned(), parameters([&old, &new]))];
    all.extend(equations(texts, [&old, &new], &renamed));
    Ok(all)
}

/// Coordinates with another name and the same equations.
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

/// The largest number of boxes in a search for steady motions.
const MOST_BOXES: usize = 50_000;

/// Parameters with another value.
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

/// Changes of each equation, with the principles that show the same ones.
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

/// Equations by the names of their coordinates and constraints; `None` where the principle does not apply or they are too long to be read.
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

/// A row of M q'' + h - Q - J^T lambda = 0.
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

/// Steady motions that were added or removed, moved, or have another stability.
fn steady_motions(name: &str, models: [Model; 2], asked: &SteadySearch, renamed: &Renamed) -> Vec<String> {
    let found = models.map(|mut model| {
        model.close_inputs();
        match SteadyMotions::of(&model, asked, clock::has_time) {
            Ok(motions) => Ok(Found { title: String::new(), model, motions }),
            Err(why) => Err(refused(Path::new(name), (&model, None), why)),
        }
    });
    let [Ok(old), Ok(new)] = &found else {
        if let Some(Exit::Refused(why)) = found.into_iter().find_map(Result::err) {
            warn(&format!("warning: steady motions are not compared: {why}"));
        }
        return Vec::new();
    };
    let open = [old, new].into_iter().filter(|found| !found.motions.is_complete());
    let mut warnings: Vec<String> = open
        .map(|found| {
            let count = found.motions.undecided.len();
            format!("warning: {name}: the search for steady motions leaves {count} boxes undecided")
        })
        .collect();
    // both texts may give the same warning
    warnings.dedup();
    warnings.iter().for_each(|warning| warn(warning));
    let told = |found: &Found| -> Vec<String> {
        let each = found.motions.motions.iter();
        each.map(|motion| format!("{}: {}", found.values(&motion.enclosure), verdict(motion, &found.motions.cyclic).0))
            .collect()
    };
    let old: Vec<String> = told(old).iter().map(|one| with_new_names(one, renamed)).collect();
    let new = told(new);
    let without = |these: &[String], those: &[String]| -> Vec<String> {
        these.iter().filter(|one| !those.contains(one)).cloned().collect()
    };
    let (gone, come) = (without(&old, &new), without(&new, &old));
    match gone.len() == come.len() {
        true => gone.iter().zip(&come).map(|(old, new)| format!("{old} before; {new} now")).collect(),
        false => {
            let gone = gone.iter().map(|old| format!("gone: {old}"));
            gone.chain(come.iter().map(|new| format!("new: {new}"))).collect()
        }
    }
}

/// Columns of the run whose values differ.
fn run(scenes: [&ModelScene; 2], renamed: &Renamed) -> Vec<String> {
    let [old, new] = scenes.map(|scene| {
        let own = scene.run().choice();
        let choice = Choice { allowed: clock::left(), ..own };
        scene.problem(Axes::default()).simulate_while(&choice, |_| clock::goes_on())
    });
    let mut told = Vec::new();
    let outcomes =
        [&old, &new].map(|one| one.outcome.failure().map_or("reaches its end".to_owned(), |why| why.to_string()));
    if outcomes[0] != outcomes[1] {
        told.push(format!("{} before; {} now", outcomes[0], outcomes[1]));
    }
    let is_alike = old.times == new.times;
    let names: Vec<String> = old.names.iter().map(|name| with_new_names(name, renamed)).collect();
    for (column, name) in new.names.iter().enumerate() {
        let unit = scenes[1].unit(name);
        let Some(before) = names.iter().position(|own| own == name) else {
            told.push(format!("{name}: a new column, {} {unit} at the end", last(&new, column)));
            continue;
        };
        let [first, second] = [last(&old, before), last(&new, column)];
        let size = [&old.rows, &new.rows]
            .into_iter()
            .flatten()
            .fold(0.0, |most: f64, row| most.max(row.get(column).map_or(0.0, |value| value.abs())));
        let pairs = old.rows.iter().zip(&new.rows).zip(&new.times);
        let largest = pairs
            .filter(|_| is_alike)
            .map(|((old, new), time)| ((new[column] - old[before]).abs(), *time))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        let most = largest.map_or((first - second).abs(), |(most, _)| most);
        if most <= ROUNDING * size {
            continue;
        }
        let where_most =
            largest.map_or_else(String::new, |(most, time)| format!("; {most:.3e} {unit} apart at t = {time} s"));
        told.push(format!(
            "{name}: {} {unit} before, {} {unit} now at the end{where_most}",
            short(first),
            short(second)
        ));
    }
    let gone = names.iter().filter(|name| !new.names.contains(name));
    told.extend(gone.map(|name| format!("{name}: no longer a column")));
    told
}

/// A number with nine digits.
fn short(value: f64) -> String {
    if value != 0.0 && !(1e-4..1e9).contains(&value.abs()) { format!("{value:.8e}") } else { format!("{value:.9}") }
}

fn last(trajectory: &Trajectory, column: usize) -> f64 {
    trajectory.last.get(column).copied().unwrap_or(f64::NAN)
}
