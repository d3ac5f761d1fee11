//! The instructions of CONTRIBUTING.md for a new motor are carried out in a copy of the project, and the tests of all
//! machines are then run there. The command `new motor` is tested in the copy too.
//!
//! A copy that cargo builds is needed, not an `include!` of the example, because the instructions promise a complete
//! result: one file, two lines, no other change. The copy preserves the modification times of the files and shares the
//! folder of build products. Only the crate of the motors, with another version, and the crates that use it are
//! rebuilt, which takes seconds.

use claims::finding::PropertyVerdict;
use dalembert_derivations::studies::conformance::conform;
use dalembert_derivations::studies::scene::Scene;
use reader::Family;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A block of code in a language, with the last file name before it.
struct Block {
    language: String,
    path: String,
    code: String,
}

fn blocks(section: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut path = String::new();
    let mut lines = section.lines();
    while let Some(line) = lines.next() {
        if let Some(language) = line.strip_prefix("```") {
            let language = language.to_owned();
            let code = lines.by_ref().take_while(|line| *line != "```").map(|line| format!("{line}\n")).collect();
            blocks.push(Block { language, path: path.clone(), code });
        } else if let Some(named) = line.split('`').skip(1).step_by(2).filter(|word| word.ends_with(".rs")).last() {
            path = named.to_owned();
        }
    }
    blocks
}

/// A folder outside the project that is deleted when the test ends. Its path is always the same for one project, so
/// that cargo recompiles only the differences.
struct Copy(PathBuf);

impl Copy {
    fn of(project: &Path) -> Self {
        let mut hasher = DefaultHasher::new();
        project.hash(&mut hasher);
        let folder = std::env::temp_dir().join(format!("dalembert-contributing-{:x}", hasher.finish()));
        fs::create_dir_all(&folder).expect("a folder can be made");
        Copy(folder)
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Copies files with their modification times, so that cargo does not rebuild them.
fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).expect("a folder can be made");
        for entry in fs::read_dir(from).expect("a folder can be listed") {
            let entry = entry.expect("an entry can be read");
            copy(&entry.path(), &to.join(entry.file_name()));
        }
    } else {
        fs::copy(from, to).expect("a file can be copied");
        let time = fs::metadata(from).and_then(|data| data.modified()).expect("a file has a time");
        fs::File::options().write(true).open(to).and_then(|file| file.set_modified(time)).expect("it can be set");
    }
}

/// The text with a line added at the end of the modules, or of the list of motors.
fn listed(text: &str, line: &str) -> String {
    let end = if line.starts_with("pub mod ") { "\n\nmotor::submit! {" } else { "\n        ]," };
    let (before, after) = text.split_once(end).expect("the list ends");
    format!("{before}\n{}{end}{after}", line.trim_end())
}

/// The manifest with another version, which separates the copy's build products from those of the project; other crates
/// accept it.
fn with_own_version(manifest: &str) -> String {
    manifest.replacen("version.workspace = true", concat!("version = \"", env!("CARGO_PKG_VERSION"), "+copy\""), 1)
}

fn change(path: &Path, by: impl Fn(&str) -> String) {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let changed = by(&text);
    assert_ne!(changed, text, "nothing changed in {}", path.display());
    fs::write(path, changed).expect("a file can be written");
}

/// The code blocks of the section on motors in CONTRIBUTING.md.
fn motors() -> Vec<Block> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("CONTRIBUTING.md")).expect("there is a CONTRIBUTING.md");
    blocks(text.split("\n## ").find(|section| section.starts_with("Add a motor")).expect("it adds a motor"))
}

/// Runs `dalembert new motor` with a folder that contains a project.
fn begin(root: &Path, name: &str, project: &Path) {
    let output = Command::new(env!("CARGO"))
        .current_dir(root)
        // no package is selected, so that the program is that of the workspace, which other tests have built
        .args(["run", "--offline", "--quiet", "--bin", "dalembert", "--", "new", "motor", name, "--project"])
        .arg(project)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn the_motor_of_the_documentation_and_a_new_one_can_be_added_as_it_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let blocks: Vec<Block> = motors().into_iter().filter(|block| block.language == "rust").collect();
    assert_eq!(blocks.len(), 4, "a file, two lines and a test");

    let scratch = Copy::of(root);
    for part in ["Cargo.toml", "Cargo.lock", "crates", "derivations", "scenes", "tests", "benches"] {
        copy(&root.join(part), &scratch.0.join(part));
    }
    change(&scratch.0.join("derivations/machines/Cargo.toml"), with_own_version);
    for Block { path, code, .. } in &blocks {
        let place = scratch.0.join(path);
        if place.exists() {
            change(&place, |text| listed(text, code));
        } else {
            fs::write(place, code).expect("a file can be written");
        }
    }
    begin(root, "begun_here", &scratch.0);
    let name = Path::new(&blocks[0].path).file_stem().and_then(|name| name.to_str()).expect("the motor has a name");
    let products = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("it lies in the folder of products");
    // these crates are built once and run for seconds: without optimisation; the others stay optimised
    let plain = ["machines", "papers", "theorems", "derivations"]
        .map(|name| ["--config".to_owned(), format!("profile.dev.package.dalembert-{name}.opt-level=0")]);
    let output = Command::new(env!("CARGO"))
        .current_dir(&scratch.0)
        .env("CARGO_TARGET_DIR", products)
        .args(["test", "--offline", "--workspace"])
        .args(plain.iter().flatten())
        .args(["--test", name, "--test", "begun_here", "--test", "gyrostats", "--", name])
        .args(["power::", "the_torque", "it_does_what", "torque_and_current"])
        .output()
        .expect("cargo runs");
    let (said, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{log}\n{said}");
    assert_eq!(said.matches("test result: ok. 0 passed").count(), 0, "some test ran nothing:\n{said}");
    assert_eq!(said.matches("test result: ok. 2 passed").count(), 1, "a new motor has two tests:\n{said}");
}

#[test]
fn the_motors_that_the_documentation_writes_as_text_conform() {
    let texts: Vec<Block> = motors().into_iter().filter(|block| block.language == "toml").collect();
    assert_eq!(texts.len(), 2, "with salient poles, and for direct current");
    let rest = "title = \"t\"\nsystem = \"bench\"\n[rotor]\naxial = \"1e-3 kg m^2\"\n[start]\n\
                rotor_speed = \"30 rad/s\"\n[run]\nspan = \"1 s\"\n";
    for Block { code, .. } in texts {
        let scene =
            Scene::parse("CONTRIBUTING", &format!("{rest}{code}")).unwrap_or_else(|error| panic!("{error}\n{code}"));
        let findings = conform(&scene.machine);
        let failed = findings.iter().find(|finding| matches!(finding.verdict, PropertyVerdict::Fails(_)));
        assert_eq!(failed, None, "{code}");
    }
}
