//! `reference` keeps existing references unless the new one is better.

use crate::{root, run, temporary};

#[test]
fn a_reference_gives_way_to_a_better_one_only() {
    let path = temporary("again.reference");
    let asked = ["reference", "scenes/closed_forms/lagrange_top.toml", "--out", &path.to_string_lossy()];
    let read = || std::fs::read_to_string(&path).expect("it was written");
    assert!(run(&asked).status.success());
    let made = read();
    let (unsealed, seal) = made.trim_end().rsplit_once('\n').expect("it has lines");
    assert!(seal.starts_with("# sha256 of the lines above: "), "{seal}");
    // a reference of an earlier version: without the version number and the hash, and with a comment that a new one would not have
    let version = format!(", version {}", env!("CARGO_PKG_VERSION"));
    let marked = format!("{}\n# kept\n", unsealed.replace(&version, ""));
    std::fs::write(&path, &marked).expect("it can be written");
    let output = run(&asked);
    assert!(
        output.status.success() && String::from_utf8_lossy(&output.stdout).contains("is kept: its methods agree to")
    );
    assert_eq!(read(), marked);
    let digits = made.lines().find(|line| line.starts_with("digits = ")).expect("it tells its digits");
    std::fs::write(&path, marked.replace(digits, "digits = 20.5")).expect("it can be written");
    assert!(run(&asked).status.success());
    let again = read();
    let edited = made.replace(digits, "digits = 20.5");
    std::fs::write(&path, &edited).expect("it can be written");
    let refused = run(&asked);
    assert!(refused.status.code() == Some(2) && read() == edited, "an edited reference is the user's");
    // a reference of this version without its hash counts as edited
    let stripped = format!("{unsealed}\n").replace(digits, "digits = 20.5");
    std::fs::write(&path, &stripped).expect("it can be written");
    let refused = run(&asked);
    assert!(refused.status.code() == Some(2) && read() == stripped, "a reference without its hash was edited");
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(again, made);
}

#[test]
fn no_stored_reference_is_changed_by_its_command() {
    for scene in ["scenes/closed_forms/unloaded_motor", "scenes/failures/stopping_rod"] {
        let (folder, name) = scene.rsplit_once('/').expect("it is in a folder");
        let stored = root().join(format!("{folder}/references/{name}.reference"));
        let before = std::fs::read(&stored).expect("it is there");
        let output = run(&["reference", &format!("{scene}.toml")]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(std::fs::read(&stored).expect("it is there") == before, "{scene}");
    }
}
