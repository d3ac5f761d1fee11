//! A package built alone has the same features as in the workspace, so that `cargo test -p` does not rebuild its
//! dependencies.

use crate::rules::{packages, root};
use std::collections::BTreeSet;
use std::process::Command;

/// Each crate with its version and features, as resolved by cargo for a selection of packages.
fn resolved(selection: &[&str]) -> BTreeSet<String> {
    let output = Command::new(env!("CARGO"))
        .current_dir(root())
        // if cargo unifies features over the workspace by itself, the test would pass trivially
        .env_remove("CARGO_RESOLVER_FEATURE_UNIFICATION")
        .args(["tree", "--offline", "--edges", "normal,build,dev", "--prefix", "none", "--no-dedupe"])
        .args(["--format", "{p} [{f}]"])
        .args(selection)
        .output()
        .expect("cargo runs, since it runs this test");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let ours = root().display().to_string();
    let lines = String::from_utf8_lossy(&output.stdout).into_owned();
    let marks = [" (proc-macro)", " (*)"];
    let bare = |line: &str| marks.iter().fold(line.to_owned(), |line, mark| line.replace(mark, ""));
    lines.lines().filter(|line| !line.contains(&ours)).map(bare).collect()
}

#[test]
fn a_package_alone_has_the_features_of_the_workspace() {
    let workspace = resolved(&["--workspace"]);
    for package in packages() {
        let name = package["name"].as_str().expect("a package has a name");
        // it has no dependencies in this project
        if name == "dalembert-features" {
            continue;
        }
        let alone = resolved(&["--package", name]);
        let other: Vec<&String> = alone.difference(&workspace).collect();
        assert!(
            other.is_empty(),
            "{name} alone has other features, write them into crates/features/Cargo.toml: {other:#?}"
        );
    }
}
