//! The files that commands write, and the files that commands never overwrite.

use crate::{program, root, run};
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

/// A folder with a scene, deleted with this value.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Folder(tempfile::tempdir().expect("a folder can be made"));
        let bench = root().join("scenes/closed_forms/unloaded_motor.toml");
        std::fs::copy(bench, folder.at("scene.toml")).expect("it can be copied");
        folder
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.at(name)).expect("it is there")
    }

    /// Runs a command in the folder.
    fn run(&self, arguments: &[&str]) -> Output {
        program(arguments).current_dir(self.0.path()).output().expect("the program starts")
    }

    fn refused(&self, arguments: &[&str], why: &str) {
        let output = self.run(arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && said.contains(why), "{arguments:?}: {said}");
    }
}

/// Every command with an output file: its arguments before the name of the file, and a name that the command accepts.
const COMMANDS: [(&[&str], &str); 10] = [
    (&["run", "scene.toml", "--out"], "out.csv"),
    (&["run", "scene.toml", "--out"], "out.npz"),
    (&["run", "scene.toml", "--transition"], "out.csv"),
    (&["export", "scene.toml", "--fmu"], "out.fmu"),
    (&["export", "scene.toml", "--python"], "out.py"),
    (&["chart", "scene.toml", "--seconds", "1", "--out"], "out.svg"),
    (&["chart", "scene.toml", "--seconds", "1", "--out"], "out.html"),
    (&["choose", "scene.toml", "--seconds", "1", "--out"], "out.svg"),
    (&["reference", "scene.toml", "--out"], "out.reference"),
    (&["draw", "scene.toml", "--out"], "out.svg"),
];

#[test]
fn every_command_replaces_its_own_file_and_no_other() {
    let folder = Folder::new();
    let scene = folder.read("scene.toml");
    for (command, name) in COMMANDS {
        let _ = std::fs::remove_file(folder.at(name));
        for _ in 0..2 {
            let output = folder.run(&[command, &[name]].concat());
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(0), "{command:?}: {said}");
            // a stored reference that is as good as the new one is kept, with a message
            assert!(String::from_utf8_lossy(&output.stdout).contains(name), "{command:?}");
        }
        let mut edited = std::fs::read(folder.at(name)).expect("it is there");
        edited.extend(b"\n");
        std::fs::write(folder.at(name), &edited).expect("it can be written");
        folder.refused(&[command, &[name]].concat(), "exists and is no unchanged ");
        assert!(std::fs::read(folder.at(name)).expect("it is there") == edited, "{command:?}");
        std::fs::write(folder.at(name), "precious").expect("it can be written");
        folder.refused(&[command, &[name]].concat(), "exists and is no ");
        assert_eq!(folder.read(name), "precious");
        // a scene is never replaced, under any name and with any flag
        std::fs::remove_file(folder.at(name)).expect("it is there");
        std::fs::hard_link(folder.at("scene.toml"), folder.at(name)).expect("links can be made");
        folder.refused(&[command, &[name]].concat(), "reads this file");
        folder.refused(&[command, &[name, "--force"]].concat(), "reads this file");
        assert_eq!(folder.read("scene.toml"), scene);
    }
    folder.refused(&["run", "scene.toml", "--out", "scene.toml"], "`dalembert run` writes .csv or .npz files only");
}

#[test]
fn folders_are_made_and_another_commands_file_is_left_alone() {
    let folder = Folder::new();
    let output = folder.run(&["run", "scene.toml", "--out", "a/b/table.csv", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice::<serde_json::Value>(&output.stdout).expect("one JSON object and no name of a file");
    let table = crate::table_at(folder.at("a/b/table.csv"));
    assert!(table.starts_with("time [s],angle [rad],slip [rad/s],"), "{table}");
    folder.refused(&["run", "scene.toml", "--transition", "a/b/table.csv"], "is no table of `dalembert run`");
    assert_eq!(folder.run(&["run", "scene.toml", "--transition", "a/b/table.csv", "--force"]).status.code(), Some(0));
    assert!(crate::table_at(folder.at("a/b/table.csv")).starts_with("end by start,angle [rad],slip [rad/s]"));
    folder.refused(&["run", "scene.toml", "--out", "a/t.csv", "--transition", "a/../a/t.csv"], "are one file");
    assert!(!folder.at("a/t.csv").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_named_and_what_was_computed_is_told() {
    let folder = Folder::new();
    let output = folder.run(&["run", "scene.toml", "--out", "/dev/full"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("/dev/full cannot be written: no space is left there; free some"), "{said}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("reached "), "{output:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn results_that_standard_output_does_not_take_are_an_error() {
    for arguments in [&["--help"][..], &["run", "--help"], &["--version"], &["completions", "bash"], &["scenes"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("the system has it");
        let output = program(arguments).stdout(Stdio::from(full)).output().expect("the program starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.code() == Some(2) && said.contains("standard output cannot be written"),
            "{arguments:?}: {said}"
        );
    }
    assert_eq!(run(&["--help"]).status.code(), Some(0));
    assert_eq!(run(&["--no-such-option"]).status.code(), Some(2));
}

#[cfg(unix)]
#[test]
fn a_pipe_takes_what_a_file_would_and_one_that_nobody_reads_is_refused() {
    let folder = Folder::new();
    let pipe = folder.at("pipe");
    if !std::process::Command::new("mkfifo").arg(&pipe).status().is_ok_and(|made| made.success()) {
        return eprintln!("skipped: there is no `mkfifo` on this machine");
    }
    folder.refused(&["run", "scene.toml", "--out", "pipe"], "nobody reads from this pipe");
    folder.refused(
        &["ensemble", &root().join("scenes/ensembles/spread.toml").to_string_lossy(), "--out", "pipe"],
        "pipe",
    );
    let reader = std::thread::spawn(move || std::fs::read_to_string(pipe));
    assert_eq!(folder.run(&["run", "scene.toml", "--samples", "5", "--out", "pipe"]).status.code(), Some(0));
    let table = reader.join().expect("it ends").expect("it can be read");
    assert_eq!(table.lines().filter(|line| !line.starts_with("# ")).count(), 7, "{table}");
}

#[test]
fn a_matrix_of_a_run_that_stopped_is_not_written_and_that_is_said() {
    let folder = Folder::new();
    let scene = root().join("scenes/governors/blow_up.toml");
    let output = folder.run(&["run", &scene.to_string_lossy(), "--transition", "matrix.csv"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("matrix.csv is not written"));
    assert!(!Path::exists(&folder.at("matrix.csv")));
}

#[test]
fn certificates_go_into_a_folder_and_over_no_file_of_others() {
    let folder = Folder::new();
    let paper = root().join("papers/cart_pole.toml").to_string_lossy().into_owned();
    let judge = ["judge", &paper, "--test", "--certificates", "made/here"];
    for _ in 0..2 {
        assert_eq!(folder.run(&judge).status.code(), Some(0));
    }
    let written = folder.read("made/here/cart_pole.json");
    assert!(written.starts_with(r#"{"made_by":"dalembert judge, "#), "{}", &written[..80]);
    assert!(written.contains(r#""id":"cart_pole/eq2/sign","#) && written.contains(r#""by":"counterexample""#));
    std::fs::write(folder.at("made/here/cart_pole.json"), "mine").expect("it can be written");
    folder.refused(&judge, "exists and is no file of certificates of `dalembert judge`");
    assert_eq!(folder.run(&[&judge[..], &["--force"]].concat()).status.code(), Some(0));
    folder.refused(&["ledger", "synchronism", "--certificates", "scene.toml"], "the name of a folder is accepted");
    folder.refused(&["judge", &paper, "--force"], "--page");
}

#[test]
fn a_page_of_a_paper_has_its_claims_that_cannot_be_read() {
    let folder = Folder::new();
    let paper = std::fs::read_to_string(root().join("papers/cart_pole.toml")).expect("it can be read");
    let head = paper.split("[[claim]]").next().expect("a beginning");
    let head = head.replace("../scenes", &root().join("scenes").to_string_lossy());
    let claim = |number: u32, formula: &str| {
        format!("[[claim]]\nequation = \"{number}\"\nkind = \"formula\"\nformula = '{formula}'\n")
    };
    std::fs::write(
        folder.at("paper.toml"),
        head + &claim(1, "m = m") + &claim(2, r"m = \frac{m}{") + &claim(3, "l = l"),
    )
    .expect("it can be written");
    let output = folder.run(&["judge", "paper.toml", "--page", "page.html"]);
    assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
    let page = folder.read("page.html");
    let places = ["paper/eq1", "paper/eq2", "paper/eq3"].map(|id| page.find(&format!("id=\"{id}\"")));
    assert!(places.is_sorted() && places.iter().all(Option::is_some), "{places:?}");
    assert!(page.contains("not read, line"), "the fault of the second claim");
    let nowhere = folder.run(&["judge", "nosuch.toml"]);
    assert!(String::from_utf8_lossy(&nowhere.stderr).contains("the folder `papers` holds examples"));
}
