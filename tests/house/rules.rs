//! The rules of the repository: layers of crates, reasons for dependencies, independence of the machinery from the
//! content, and others.

use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The layers from the lowest to the highest; a crate may use crates of lower layers only.
const LAYERS: &[(&str, i32)] = &[
    ("dalembert-features", -1),
    ("dalembert-field", 0),
    ("dalembert-algebra", 1),
    ("dalembert-symbolic", 2),
    ("dalembert-series", 3),
    ("dalembert-native", 3),
    ("dalembert-units", 3),
    ("dalembert-mechanics", 3),
    ("dalembert-latex", 4),
    ("dalembert-integrators", 3),
    ("dalembert-reader", 4),
    ("dalembert-simulation", 5),
    ("dalembert-model", 4),
    ("dalembert-claims", 4),
    ("dalembert-exchange", 4),
    ("dalembert-charts", 5),
    ("dalembert-motor", 6),
    ("dalembert-systems", 7),
    ("dalembert-machines", 7),
    ("dalembert-scenes", 7),
    ("dalembert-papers", 8),
    ("dalembert-manuscript", 8),
    ("dalembert-studies", 8),
    ("dalembert-theorems", 9),
    ("dalembert-commands", 9),
    ("dalembert-derivations", 10),
    ("dalembert-cli", 10),
    ("dalembert", 10),
];

/// The layer of a package.
pub fn layer(name: &str) -> Option<i32> {
    LAYERS.iter().find(|(known, _)| *known == name).map(|(_, layer)| *layer)
}

#[test]
fn every_crate_uses_lower_layers_only() {
    let layers: HashMap<&str, i32> = LAYERS.iter().copied().collect();
    let packages = packages();
    assert_eq!(packages.len(), LAYERS.len(), "a crate without a layer: write it into tests/house/rules.rs");
    for package in &packages {
        let name = package["name"].as_str().expect("a package has a name");
        let layer = layers.get(name).unwrap_or_else(|| panic!("{name} has no layer"));
        for dependency in package["dependencies"].as_array().expect("dependencies are a list") {
            let used = dependency["name"].as_str().expect("a dependency has a name");
            if let Some(below) = layers.get(used).filter(|_| dependency["kind"].is_null()) {
                assert!(below < layer, "{name} (layer {layer}) uses {used} (layer {below})");
            }
        }
    }
}

#[test]
fn every_dependency_has_its_reason() {
    let manifest = read(&root().join("Cargo.toml"));
    let list = manifest.split("[workspace.dependencies]").nth(1).expect("the workspace lists its dependencies");
    let list = list.split("\n[").next().expect("a list ends").lines().skip(1);
    let mut reason = false;
    for line in list.map(str::trim).filter(|line| !line.is_empty()) {
        let ours = line.contains("path =");
        assert!(reason || ours || line.starts_with('#'), "no reason stands before `{line}`");
        // several crates of one family may share a reason
        reason = line.starts_with('#') || (reason && line.split(['-', '_', ' ']).next() == Some("dashu"));
        reason |= line.starts_with("serde ");
    }
}

#[test]
fn the_machinery_names_no_system() {
    let machinery = [
        "field",
        "algebra",
        "symbolic",
        "series",
        "units",
        "reader",
        "native",
        "mechanics",
        "model",
        "integrators",
        "claims",
        "latex",
        "manuscript",
        "charts",
    ];
    for folder in machinery {
        for file in rust_files(&root().join("crates").join(folder).join("src")) {
            let text = read(&file).to_lowercase();
            for system in ["gyrostat", "konosevich", "damper"] {
                assert!(!text.contains(system), "{} speaks of a {system}", file.display());
            }
        }
    }
}

#[test]
fn laws_do_not_branch_on_values() {
    for folder in ["derivations/systems/src", "crates/mechanics/src"] {
        for file in rust_files(&root().join(folder)) {
            let text = read(&file);
            let generic = text.contains("S: Over<P>") || text.contains("S: Scalar");
            assert!(!generic || !text.contains("PartialOrd"), "{} compares scalars", file.display());
        }
    }
}

#[test]
fn unsafe_code_stands_in_one_place() {
    let own = root().join("crates/native/src/lib.rs");
    for folder in ["crates", "derivations"] {
        let tested = |file: &Path| file.iter().any(|part| part == "tests");
        for file in rust_files(&root().join(folder)).filter(|file| *file != own && !tested(file)) {
            assert!(!read(&file).contains("unsafe {"), "{} has unsafe code", file.display());
        }
    }
}

#[test]
fn the_program_writes_files_whole() {
    let folder = root().join("crates/commands/src");
    // the first file writes whole files, the second opens pipes and devices, the third appends whole rows to a table
    let own = ["atomic_write.rs", "output/place.rs", "ensemble/table.rs"].map(|name| folder.join(name));
    let tested = |file: &Path| file.ends_with("tests.rs");
    for file in rust_files(&folder).filter(|file| !own.contains(file) && !tested(file)) {
        for way in ["fs::write", "File::create", "OpenOptions"] {
            assert!(!read(&file).contains(way), "{} writes by {way}, not by `output`", file.display());
        }
    }
}

#[test]
fn the_architecture_names_places_that_exist() {
    let text = read(&root().join("ARCHITECTURE.md"));
    let roots = ["crates/", "derivations/", "tests/", "scenes/", "snapshots/", "book/", "benches/"];
    let named = text.split('`').skip(1).step_by(2).filter(|place| roots.iter().any(|root| place.starts_with(root)));
    // capitals stand for any name, asterisks for several names
    let of_one =
        named.filter(|place| !place.contains(['*', ' ']) && !place.contains("NAME") && !place.contains("PAPER"));
    let missing: Vec<String> = of_one.flat_map(spelt_out).filter(|place| !root().join(place).exists()).collect();
    assert!(missing.is_empty(), "ARCHITECTURE.md names {missing:?}, which do not exist");
}

/// The paths that `a/{b,c}.rs` abbreviates.
fn spelt_out(place: &str) -> Vec<String> {
    let parts = place.split_once('{').and_then(|(before, rest)| Some((before, rest.split_once('}')?)));
    let Some((before, (choices, after))) = parts else { return vec![place.to_owned()] };
    choices.split(',').flat_map(|choice| spelt_out(&format!("{before}{choice}{after}"))).collect()
}

#[test]
fn every_snapshot_is_small_enough_to_be_read() {
    for file in files(&root().join("snapshots")) {
        let bytes = std::fs::metadata(&file).expect("a listed file exists").len();
        assert!(bytes <= 20 * 1024, "{} has {bytes} bytes", file.display());
    }
}

pub fn packages() -> Vec<Value> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--format-version", "1", "--offline"])
        .current_dir(root())
        .output()
        .expect("cargo runs, since it runs this test");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo prints JSON");
    metadata["packages"].as_array().expect("packages are a list").clone()
}

pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

pub fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

pub fn rust_files(folder: &Path) -> impl Iterator<Item = PathBuf> {
    files(folder).into_iter().filter(|file| file.extension().is_some_and(|end| end == "rs"))
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries
        .map(|entry| entry.expect("a folder can be read").path())
        .flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] })
        .collect()
}
