//! Changes of the run of a system: its end, and the values of its columns.

use super::renamed_coordinates::{Renamed, with_new_names};
use crate::clock;
use crate::exit::warn;
use ::scenes::{ModelScene, SystemText};
use reader::SceneError;
use simulation::{Axes, Choice, IvpScene, Trajectory};

/// Differences below this fraction of the magnitude of a column are rounding errors.
const ROUNDING: f64 = 1e-9;

/// The columns of the run whose values differ, and the end of the run if it differs.
pub(super) fn changes(texts: &[SystemText; 2], renamed: &Renamed) -> Vec<String> {
    let read = |text: &SystemText| ModelScene::parse(&text.name, &text.text);
    let scenes = match [read(&texts[0]), read(&texts[1])] {
        [Ok(old), Ok(new)] => [old, new],
        // neither text has a run, as files for `derive` and `prove`
        [Err(old), Err(new)] if [&old, &new].iter().all(|why| is_without_run(why)) => return Vec::new(),
        [Err(why), _] | [_, Err(why)] => {
            warn(&format!("warning: runs are not compared: {why}"));
            return Vec::new();
        }
    };
    let [old, new] = [&scenes[0], &scenes[1]].map(|scene| {
        let own = scene.run().choice();
        let choice = Choice { allowed: clock::left(), ..own };
        scene.problem(Axes::default()).simulate_while(&choice, |_| clock::goes_on())
    });
    let mut told = Vec::new();
    let [before, now] = [&old, &new].map(end);
    if before != now {
        told.push(format!("the run {before} before; it {now} now"));
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
        let where_most = largest
            .map_or_else(String::new, |(most, time)| format!("; {most:.3e} {unit} apart at t = {} s", instant(time)));
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

/// Whether the only fault of a file is a missing table [run].
fn is_without_run(why: &SceneError) -> bool {
    why.issues.iter().all(|issue| issue.title == "the table [run] is missing")
}

/// The end of a run in words: its time, and the reason of an early stop.
fn end(run: &Trajectory) -> String {
    let time = instant(run.outcome.time);
    match run.stopped() {
        Some(why) => format!("stops at t = {time} s ({why})"),
        None => format!("reaches t = {time} s"),
    }
}

/// An instant in seconds rounded to 1e-9 s, without the rounding error of sums of steps.
fn instant(time: f64) -> f64 {
    (time * 1e9).round() / 1e9
}

/// A number with nine decimals, or in scientific notation with nine digits.
fn short(value: f64) -> String {
    if value != 0.0 && !(1e-4..1e9).contains(&value.abs()) { format!("{value:.8e}") } else { format!("{value:.9}") }
}

fn last(trajectory: &Trajectory, column: usize) -> f64 {
    trajectory.last.get(column).copied().unwrap_or(f64::NAN)
}
