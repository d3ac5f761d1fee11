//! The report: one page with the ledger of every paper and the runs and charts of every scene.

mod parts;
mod scene;

use crate::ending::{Ending, can_save, save};
use crate::progress::Progress;
use crate::rough;
use crate::speed::{advice::advice, pictures, tables};
use charts::{Report, SceneSection, WorkPrecision};
use clap::Args;
use derivations::failures;
use derivations::friction::RoughScene;
use derivations::scene::{AnyScene, Atlas, Family, Smooth, Stored};
use parts::Parts;
use scene::{Read, ReadRough, described};
use std::path::{Path, PathBuf};

/// The main job, where no command is given.
#[derive(Args, Debug)]
pub struct Asked {
    /// Where the scene files are
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// The page
    #[arg(long, value_name = "FILE.html", default_value = "report/index.html")]
    pub out: PathBuf,
}

/// Judges the ledger, runs and charts the scenes, and writes the page.
pub fn write(path: &Path, folder: &Path, files: &[PathBuf]) -> Result<Ending, Ending> {
    can_save(path)?;
    // all are read before the first is run: what is wrong is told at once
    let (mut scenes, mut rough) = (Vec::new(), Vec::new());
    // those that are made to fail are told by the catalogue
    for file in files.iter().filter(|file| !failures::is_own(file)) {
        match AnyScene::open(file)? {
            AnyScene::Rough(scene) => rough.push(ReadRough { id: id(file), scene: *scene, kept: Stored::beside(file) }),
            scene => scenes.push(Read { id: id(file), scene, kept: Stored::beside(file) }),
        }
    }
    let mut parts = Parts::of(&scenes, &rough, folder);
    let mut progress = Progress::new("ledger, runs, references, maps");
    parts.compute(&scenes, &rough, folder, |done| progress.set(done));
    drop(progress);
    let mut progress = Progress::new("methods timed");
    parts.take_times(|done| progress.set(done));
    drop(progress);
    let whole = parts.sound() && parts.reached();
    let report = parts.report(folder);
    save(path, &charts::page::render(&report).html)?;
    Ok(if whole { Ending::Done } else { Ending::Stopped })
}

/// A page with nothing but a scene and its atlas.
pub fn of_scene(scene: &dyn Smooth, atlas: &Atlas, work: Vec<WorkPrecision>) -> String {
    let choice = scene.run().choice();
    let run = scene.problem(choice.axes).simulate(&choice, |_| ());
    let mut section = SceneSection { work, ..described("scene", scene, &run) };
    explained(&mut section, atlas);
    section.tables.push(tables::models(atlas));
    let report = Report { scenes: vec![section], ..titled(scene.title(), scene.description()) };
    charts::page::render(&report).html
}

/// The same of a scene with rough contacts.
pub fn of_rough(scene: &RoughScene, atlas: &Atlas, work: Vec<WorkPrecision>) -> String {
    let mut section = SceneSection { work, ..rough::section("scene", scene) };
    explained(&mut section, atlas);
    let report = Report { rough: vec![section], ..titled(&scene.title, &scene.description) };
    charts::page::render(&report).html
}

/// What is said and listed below the pictures of an atlas.
fn explained(section: &mut SceneSection, atlas: &Atlas) {
    section.facts.extend([1e-3, 1e-6, 1e-9].map(|error| ("advice".to_owned(), advice(atlas, error))));
    section.note = pictures::measured_by(atlas);
    section.tables.splice(0..0, tables::fronts(atlas));
}

/// A report without content yet.
pub fn titled(title: &str, summary: &str) -> Report {
    let generated_by = concat!("dalembert ", env!("CARGO_PKG_VERSION")).to_owned();
    Report { title: title.to_owned(), summary: summary.to_owned(), generated_by, ..Default::default() }
}

/// A file's name without its ending, as it may stand in a link.
fn id(file: &Path) -> String {
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' }).collect()
}
