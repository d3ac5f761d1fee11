//! The licences of all dependencies: each dependency can be used under a licence compatible with MIT and Apache-2.0.

use serde_json::Value;
use spdx::{Expression, Licensee, ParseMode};
use std::collections::BTreeSet;
use std::process::Command;

/// Licences that require only that their text accompanies a copy.
const ACCEPTED: [&str; 9] = [
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "ISC",
    "Unicode-3.0",
    "Zlib",
];

/// Name and licence of every package that the workspace is built from on this platform.
fn dependencies() -> Vec<(String, Option<String>)> {
    let root = env!("CARGO_MANIFEST_DIR");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let target = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let asked = ["metadata", "--offline", "--locked", "--format-version", "1", "--filter-platform", &target];
    let told = Command::new(cargo).args(asked).current_dir(root).output().expect("cargo is there");
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    let all: Value = serde_json::from_slice(&told.stdout).expect("it is JSON");
    let packages = all["packages"].as_array().expect("they are listed");
    let text = |one: &Value| one.as_str().map(str::to_owned);
    packages
        .iter()
        .filter(|one| !one["source"].is_null())
        .map(|one| (text(&one["name"]).expect("it has a name"), text(&one["license"])))
        .collect()
}

#[test]
#[cfg(target_os = "linux")]
fn every_dependency_has_a_licence_that_goes_with_ours() {
    let accepted = ACCEPTED.map(|one| Licensee::parse(one).expect("it is one of SPDX"));
    let refused: Vec<String> = dependencies()
        .into_iter()
        .filter(|(_, licence)| {
            let licence = licence.as_deref().unwrap_or_default();
            let read = Expression::parse_mode(licence, ParseMode::LAX);
            !read.is_ok_and(|own| own.evaluate(|asked| accepted.iter().any(|one| one.satisfies(asked))))
        })
        .map(|(name, licence)| format!("{name}: {licence:?}"))
        .collect();
    assert!(refused.is_empty(), "{refused:#?}");
}

#[test]
#[cfg(target_os = "linux")]
fn the_list_of_licences_is_that_of_the_dependencies() {
    let lines: BTreeSet<String> =
        dependencies().into_iter().map(|(name, licence)| format!("{name}: {}", licence.unwrap_or_default())).collect();
    let list = lines.into_iter().collect::<Vec<_>>().join("\n");
    insta::with_settings!({ snapshot_path => "../../snapshots/licences", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("dependencies", list);
    });
}
