//! The catalogue of numerical failures: measured thresholds agree with theory, and no run returns NaN.

use dalembert_derivations::studies::failures::{self, Failing, Fate, Found};
use std::path::Path;
use std::sync::LazyLock;

/// Each entry with its results, measured on two threads.
static FOUND: LazyLock<Vec<(&Failing, Found)>> = LazyLock::new(|| {
    scenes::register(|_| ());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let one = |failing: &'static Failing| {
        (failing, failing.measure(&folder).unwrap_or_else(|error| panic!("{}: {error}", failing.name)))
    };
    std::thread::scope(|scope| {
        let running: Vec<_> = failures::ALL.iter().map(|failing| scope.spawn(move || one(failing))).collect();
        running.into_iter().map(|way| way.join().expect("a way is measured")).collect()
    })
});

#[test]
fn every_measured_threshold_is_the_exact_one() {
    let mut off = Vec::new();
    for (failing, found) in FOUND.iter() {
        assert!(!found.thresholds.is_empty(), "{}", failing.name);
        for it in found.thresholds.iter().filter(|it| !it.agrees()) {
            let (exact, value) = (&it.exact, it.exact.value());
            off.push(format!("{}, {}: {exact} = {value:e}, measured {:?}", failing.name, it.of, it.measured));
        }
    }
    assert!(off.is_empty(), "{off:#?}");
}

#[test]
fn nothing_that_is_tried_ends_in_a_number_that_is_none() {
    for (failing, found) in FOUND.iter() {
        for trial in &found.trials {
            assert_ne!(trial.fate, Fate::Undefined, "{}: {}", failing.name, trial.by);
        }
    }
}

/// Every entry needs a method that fails, and a method that does not.
#[test]
fn in_every_way_something_fails_and_something_holds() {
    for (failing, found) in FOUND.iter() {
        let count = |wanted: fn(&Fate) -> bool| found.trials.iter().filter(|trial| wanted(&trial.fate)).count();
        assert!(count(|fate| *fate != Fate::Holds) > 0, "{}: nothing fails", failing.name);
        assert!(!found.diagnosis.is_empty() && !failing.advice.is_empty(), "{}", failing.name);
    }
}

#[test]
fn the_catalogue_reads_as_reviewed() {
    for (failing, found) in FOUND.iter() {
        insta::with_settings!({
            snapshot_path => "../../snapshots/failures", prepend_module_to_snapshot => false, omit_expression => true,
        }, { insta::assert_snapshot!(failing.name, page(failing, found)) });
    }
}

/// The part of the results that does not depend on the computer, as text.
fn page(failing: &Failing, found: &Found) -> String {
    let Failing { title, scene, why, advice, .. } = failing;
    let mut text = format!("{title}\nscenes/{scene}\n\n{why}\n");
    for it in &found.thresholds {
        let judged = if it.agrees() { "measured, agrees" } else { "measured, DISAGREES" };
        let unit = if it.unit.is_empty() { String::new() } else { format!(" {}", it.unit) };
        text += &format!("\n{}: {} = {}{unit}; {judged} {}", it.of, it.formula, it.exact, it.within);
    }
    text += &format!("\n\nsays: {}\nasked: {}\n", without_numbers(&found.diagnosis), failing.asked);
    let mut fates: Vec<(u8, String)> = found.trials.iter().map(|it| (it.fate.rank(), it.fate.to_string())).collect();
    fates.sort();
    fates.dedup();
    for (_, fate) in fates {
        let by = found.trials.iter().filter(|trial| trial.fate.to_string() == fate).map(|trial| trial.by.as_str());
        text += &format!("\n{fate}: {}", by.collect::<Vec<_>>().join("; "));
    }
    text + &format!("\n\n{advice}\n")
}

/// The text with numbers removed, since times and magnitudes vary between computers.
fn without_numbers(text: &str) -> String {
    let mut out = String::new();
    for word in text.split(' ') {
        let bare = word.trim_end_matches([',', ';', ':', '.', ')']).trim_start_matches('(');
        let number = bare.parse::<f64>().is_ok();
        out += if out.is_empty() { "" } else { " " };
        out += &if number { word.replace(bare, "#") } else { word.to_owned() };
    }
    out
}
