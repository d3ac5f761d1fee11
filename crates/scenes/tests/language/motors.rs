//! The motors that a drive may name, with the data that each needs.

use super::examples::CRANE;
use dalembert_scenes::ModelScene;
use motor::catalogue::{Entry, entries, sampled};
use reader::Bound;
use std::fmt::Write;

/// The motors of the catalogue without those that prescribe the speed of the rotor.
fn of_drives() -> impl Iterator<Item = &'static Entry> {
    let keeps_speed =
        |entry: &Entry| sampled(entry.name, |_| 1.0, 1).is_some_and(|motor| motor.prescribed_speed().is_some());
    entries().into_iter().filter(move |entry| !keeps_speed(entry))
}

fn accepted(bound: Bound) -> &'static str {
    match bound {
        Bound::Any => "every number",
        Bound::Positive | Bound::Resistance => "above zero",
        Bound::NotNegative | Bound::Friction => "zero or above",
        Bound::NotZero => "every number but zero",
    }
}

/// Writes the section on motors.
pub fn motors(page: &mut String) {
    // writing to a string cannot fail
    for entry in of_drives() {
        let _ = writeln!(page, "### `{}`\n\n{}.\n", entry.name, capital(entry.summary));
        if entry.data.is_empty() && entry.counts.is_empty() {
            page.push_str("It needs no data.\n\n");
            continue;
        }
        page.push_str("| key | meaning | unit | accepted | example |\n|---|---|---|---|---|\n");
        for datum in entry.data {
            let (name, meaning, unit) = (&datum.name, &datum.meaning, &datum.unit);
            let _ = writeln!(
                page,
                "| `{name}` | {meaning} | {unit} | {} | `{name} = {}` |",
                accepted(datum.bound),
                example(unit)
            );
        }
        for count in entry.counts {
            let _ = writeln!(
                page,
                "| `{0}` | {1} | 1 | whole numbers, at least 1 | `{0} = 1` |",
                count.name, count.meaning
            );
        }
        page.push('\n');
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.trim_end_matches('.').chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn example(unit: &str) -> String {
    if unit == "1" { "\"1\"".to_owned() } else { format!("\"1 {unit}\"") }
}

#[test]
fn every_motor_of_the_reference_is_read_in_a_drive() {
    for entry in of_drives() {
        let data = entry.data.iter().map(|datum| format!("{} = {}\n", datum.name, example(&datum.unit)));
        let counts = entry.counts.iter().map(|count| format!("{} = 1\n", count.name));
        let data: String = data.chain(counts).collect();
        let text = format!(
            "{CRANE}\n[[drive]]\nturns = \"(x/(0.05 m))\"\ninertia = \"(1 kg m^2)\"\n[drive.machine]\nmodel = \"{}\"\n{data}",
            entry.name
        );
        ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
    }
}
