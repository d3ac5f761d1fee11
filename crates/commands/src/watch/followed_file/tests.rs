//! Tests of the detection of changes for several ways of saving a file.

use super::*;

/// The change that is reported within as many checks as a missing file needs.
fn after_looks(file: &mut FollowedFile) -> Option<Content> {
    (0..=LOOKS).find_map(|_| file.change())
}

#[test]
fn a_file_is_told_once_for_each_of_its_contents_however_it_was_saved() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let [path, other] = ["a.toml", "b.toml"].map(|name| folder.path().join(name));
    std::fs::write(&path, "one").expect("it can be written");
    let mut file = FollowedFile::new(&path);
    assert_eq!(after_looks(&mut file), Some(Ok("one".to_owned())));
    assert_eq!(after_looks(&mut file), None);
    // the new text has the length of the old one and is written immediately afterwards
    std::fs::write(&path, "two").expect("it can be written");
    assert_eq!(after_looks(&mut file), Some(Ok("two".to_owned())));
    std::fs::write(&other, "six").expect("it can be written");
    std::fs::rename(&other, &path).expect("it can be moved");
    assert_eq!(after_looks(&mut file), Some(Ok("six".to_owned())));
    std::fs::remove_file(&path).expect("it is there");
    assert!(after_looks(&mut file).is_some_and(|content| content.is_err()));
}

#[test]
fn a_file_that_is_away_for_a_moment_is_not_told() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let path = folder.path().join("a.toml");
    std::fs::write(&path, "one").expect("it can be written");
    let mut file = FollowedFile::new(&path);
    file.change();
    std::fs::write(&path, "").expect("it can be written");
    assert_eq!(file.change(), None);
    std::fs::write(&path, "one").expect("it can be written");
    assert_eq!(after_looks(&mut file), None);
}

#[test]
fn a_file_beside_it_is_followed_too() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let [path, model] = ["paper.toml", "model.toml"].map(|name| folder.path().join(name));
    std::fs::write(&path, "paper").expect("it can be written");
    std::fs::write(&model, "one").expect("it can be written");
    let mut file = FollowedFile::new(&path);
    file.change();
    file.follow(vec![model.clone()]);
    assert_eq!(after_looks(&mut file), None);
    std::fs::write(&model, "two").expect("it can be written");
    assert_eq!(after_looks(&mut file), Some(Ok("paper".to_owned())));
    file.follow(Vec::new());
    std::fs::write(&model, "six").expect("it can be written");
    assert_eq!(after_looks(&mut file), None);
}
