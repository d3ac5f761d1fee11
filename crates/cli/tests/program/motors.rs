//! New motors and their checks at the command line.

use crate::{json, program_in, root, run, temporary};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with the project's lists of motors only.
struct Project(PathBuf);

const LIST: &str = "derivations/machines/src/lib.rs";

impl Project {
    fn new(name: &str) -> Self {
        let folder = temporary(name);
        fs::create_dir_all(folder.join("derivations/machines/src")).expect("a folder can be made");
        fs::copy(root().join(LIST), folder.join(LIST)).expect("a file can be copied");
        Project(folder)
    }

    /// Runs `new motor`: the exit code, and standard error.
    fn begin(&self, arguments: &[&str]) -> (Option<i32>, String) {
        let project = self.0.to_string_lossy();
        let output = run(&[&["new", "motor"], arguments, &["--project", &project]].concat());
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    }

    fn read(&self, place: &str) -> Option<String> {
        fs::read_to_string(self.0.join(place)).ok()
    }

    fn files(&self) -> usize {
        fn count(folder: &Path) -> usize {
            let entries = fs::read_dir(folder).expect("a folder can be listed");
            let paths = entries.map(|entry| entry.expect("an entry can be read").path());
            paths.map(|path| if path.is_dir() { count(&path) } else { 1 }).sum()
        }
        count(&self.0)
    }
}

impl Drop for Project {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_new_motor_is_a_file_two_lines_a_scene_and_a_test() {
    let project = Project::new("begun");
    assert_eq!(project.begin(&["salient_pole"]).0, Some(0));
    let list = project.read(LIST).expect("the list is there");
    assert!(list.contains("\npub mod salient_pole;\n\nmotor::submit! {"), "{list}");
    assert!(list.contains("\n            &salient_pole::ENTRY,\n        ],"), "{list}");
    let file = project.read("derivations/machines/src/salient_pole.rs").expect("it is written");
    assert!(file.contains("pub struct SalientPole {") && !file.contains("CamelName"), "{file}");
    assert!(project.read("scenes/machines/salient_pole.toml").is_some_and(|text| text.contains("\"salient_pole\"")));
    assert!(project.read("tests/salient_pole.rs").is_some_and(|text| text.contains("salient_pole::SalientPole")));
    let again = project.begin(&["salient_pole"]);
    assert!(again.0 == Some(2) && again.1.contains("exists"), "{again:?}");
    assert_eq!(project.read(LIST), Some(list));
}

#[test]
fn a_new_motor_as_text_is_a_scene_that_conforms_and_runs() {
    let project = Project::new("begun_text");
    assert_eq!(project.begin(&["salient_pole", "--text"]).0, Some(0));
    assert_eq!(project.files(), 2);
    let scene = project.0.join("scenes/machines/salient_pole.toml");
    let scene = scene.to_string_lossy();
    let found = json(&run(&["conform", &scene, "--format", "json"]));
    let checks = found["checks"].as_array().expect("there are checks");
    assert!(checks.len() > 8 && checks.iter().all(|check| check["verdict"] != "fails"), "{found:#}");
    let equations = String::from_utf8(run(&["derive", &scene]).stdout).expect("it is text");
    assert!(equations.starts_with("M = ") && equations.contains("l*dx/dt = "), "{equations}");
    assert_eq!(run(&["run", &scene]).status.code(), Some(0));
}

#[test]
fn a_new_motor_as_text_needs_no_project() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let begin = |name: &str| program_in(folder.path(), &["new", "motor", name, "--text"]).output().expect("it starts");
    assert_eq!(begin("mine").status.code(), Some(0));
    assert_eq!(program_in(folder.path(), &["run", "mine.toml"]).output().expect("it starts").status.code(), Some(0));
    assert_eq!(begin("mine").status.code(), Some(2));
    assert_eq!(begin("con").status.code(), Some(2));
    assert_eq!(std::fs::read_dir(folder.path()).expect("it is there").count(), 1);
}

#[test]
fn what_cannot_name_a_motor_is_refused_and_nothing_written() {
    let project = Project::new("begun_not");
    for name in ["Salient", "2poles", "salient-pole", "match", "text_motor", "", "../outside"] {
        let (code, said) = project.begin(&[name]);
        assert!(code == Some(2) && said.contains("accepted"), "{name}: {said}");
    }
    let taken = [
        "std",
        "core",
        "alloc",
        "test",
        "con",
        "nul",
        "aux",
        "prn",
        "com1",
        "lpt9",
        "option",
        "vec",
        "clone",
        "self_",
        "f64",
        "bool",
        "field",
        "machine",
        "circle",
        "over",
        "p",
        "s",
        "entry",
        "sym",
        "multi_current",
    ];
    for name in taken {
        let (code, said) = project.begin(&[name]);
        assert!(code == Some(2) && said.contains(&format!("`{name}` cannot name a motor: ")), "{name}: {said}");
    }
    assert_eq!(project.files(), 1);
    let elsewhere = temporary("no_project");
    let output = run(&["new", "motor", "salient_pole", "--project", &elsewhere.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("is not the project"));
}

#[test]
fn a_motor_that_fails_a_check_ends_with_one_and_says_which() {
    let project = Project::new("begun_wrong");
    assert_eq!(project.begin(&["wrong", "--text"]).0, Some(0));
    let place = project.0.join("scenes/machines/wrong.toml");
    let text = fs::read_to_string(&place).expect("it is written");
    let driving = text.replace("\"-f*phi'\"", "\"f*phi'\"");
    fs::write(&place, &driving).expect("a file can be written");
    // a value that is usually a mistake needs the key `allow`
    assert_eq!(run(&["conform", &place.to_string_lossy()]).status.code(), Some(2));
    fs::write(&place, format!("allow = [\"negative friction\"]\n{driving}")).expect("a file can be written");
    let output = run(&["conform", &place.to_string_lossy()]);
    let said = String::from_utf8(output.stdout).expect("it is text");
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("fails           passivity   the torque m gives"), "{said}");
}
