//! Commands obey a time limit and Ctrl-C, and print the results found until then.

use crate::{program, root, run, table_at, temporary};
use std::process::Output;
use std::time::{Duration, Instant};

/// Far longer than the limit of one second, for a busy machine, and far shorter than each of these commands takes without a limit.
const SOON: Duration = Duration::from_secs(15);

/// A scene whose search takes minutes and decides no speed.
const CONE: &str = "crates/cli/tests/program/cone_without_answer.toml";

fn soon(asked: impl FnOnce() -> Output) -> (Option<i32>, String, String) {
    let begun = Instant::now();
    let Output { status, stdout, stderr } = asked();
    let told = [stdout, stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(begun.elapsed() < SOON, "after {:?}: {told:?}", begun.elapsed());
    let [out, error] = told;
    (status.code(), out, error)
}

#[test]
fn a_search_that_asks_no_clock_is_ended_by_it() {
    let (code, out, error) = soon(|| run(&["stationary", CONE, "--cone", "--seconds", "1"]));
    assert_eq!(code, Some(1), "{out}{error}");
    assert!(error.contains("out of time: `stationary`") && error.contains("after 1 s"), "{error}");
    // the pull-out is printed before the search starts
    assert!(out.contains("pull-out: two speeds merge at"), "{out}");
}

#[test]
fn a_run_is_kept_where_its_transition_matrix_takes_too_long() {
    let [table, matrix] = ["kept.csv", "transition.csv"].map(temporary);
    let asked = ["run", "scenes/stiff_damper.toml", "--seconds", "4"];
    let (code, out, error) =
        soon(|| program(&asked).arg("--out").arg(&table).arg("--transition").arg(&matrix).output().expect("it starts"));
    let rows = table_at(&table);
    std::fs::remove_file(&table).expect("it is there");
    assert_eq!(code, Some(1), "{out}{error}");
    assert!(error.contains("out of time: `run` (the transition matrix)"), "{error}");
    assert!(out.contains("method") && rows.lines().count() > 1 && !matrix.exists(), "{out}");
}

#[test]
fn an_ensemble_says_where_it_goes_on_when_the_time_is_over() {
    let [scene, path] = ["many_members.toml", "timed_ensemble.csv"].map(temporary);
    let text = std::fs::read_to_string(root().join("scenes/ensembles/spread.toml")).expect("it is there");
    let members = text.lines().find(|line| line.starts_with("members")).expect("it says how many");
    std::fs::write(&scene, text.replace(members, "members = 100_000_000")).expect("it can be written");
    let asked = ["ensemble", &scene.to_string_lossy(), "--threads", "1", "--seconds", "1", "--out"];
    let (code, out, error) = soon(|| program(&asked).arg(&path).output().expect("it starts"));
    let table = std::fs::read_to_string(&path).expect("it was written");
    [&scene, &path].into_iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
    assert_eq!(code, Some(1), "{out}{error}");
    assert!(out.contains("the same command continues with member ") && table.ends_with('\n'), "{out}");
    assert!(error.contains("out of time: `ensemble`"), "{error}");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_a_search_that_keeps_nothing() {
    let (code, out, error) = soon(|| crate::killed::interrupt(&mut program(&["stationary", CONE, "--cone"])));
    assert_eq!(code, Some(130), "{out}{error}");
    assert!(error.contains("interrupted: `stationary`"), "{error}");
}
