//! The conformance checks for every motor of the catalogue and of the scenes, as a page for review.

use dalembert_derivations::studies::conformance::{conform, page, sample};
use dalembert_derivations::studies::scene::Scene;
use motor::catalogue;
use reader::Family;
use std::path::Path;

fn compare(name: &str, page: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../snapshots/conformance");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, page));
}

/// Motors that are written in scene files, by the names of the files.
fn written() -> Vec<(String, Scene)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/machines");
    let mut files: Vec<_> = std::fs::read_dir(&folder)
        .expect("there are motors")
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    let name = |path: &Path| path.file_stem().map(|name| name.to_string_lossy().into_owned()).expect("it has a name");
    let scenes = files.iter().map(|path| (name(path), Scene::open(path).unwrap_or_else(|error| panic!("{error}"))));
    scenes.filter(|(_, scene)| scene.machine.name() == "text").collect()
}

#[test]
fn every_motor_conforms_or_says_why_not() {
    let mut pages = Vec::new();
    for entry in catalogue::entries() {
        let machine = sample(entry.name).expect("it is in the catalogue");
        pages.push(page(&format!("{}: {}", entry.name, entry.summary), &conform(&machine)));
    }
    for (name, scene) in written() {
        pages.push(page(&format!("{name}: {}", scene.title), &conform(&scene.machine)));
    }
    compare("motors", &pages.join("\n"));
}
