//! The report: one page with the ledgers of all papers, and the runs and charts of all scenes.

mod parts;
mod scene;
mod unread;

use crate::arguments::Format;
use crate::exit::{Exit, warn, warn_of};
use crate::output::{Form, Maker, Writes};
use crate::progress::Progress;
use crate::speed::{advice::advice, pictures, tables};
use charts::{Report, SceneSection, WorkPrecision};
use manuscript::{PaperText, is_paper};
use parts::Parts;
use reader::Family;
use scene::{Read, described};
use simulation::{Atlas, IvpScene, Stored};
use std::path::{Path, PathBuf};
use studies::AnyScene;
use studies::failures;

/// Arguments of the report, which the program makes without a command.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The folder of the scene files
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// The folder of the papers; it may be missing
    #[arg(long, value_name = "FOLDER", default_value = "papers")]
    pub papers: PathBuf,
    /// The file of the page
    #[arg(long, value_name = "FILE.html", default_value = "report/index.html")]
    pub out: PathBuf,
    /// Replaces the page even if the report did not write it
    #[arg(long)]
    pub force: bool,
}

/// Judges the claims of all papers, runs and charts the scenes, and writes the page. A scene that cannot be read is reported immediately and on the
/// page; the others are computed nevertheless.
pub fn write(asked: &Args, files: &[PathBuf]) -> Result<Exit, Exit> {
    let folder = &asked.scenes;
    let reads = files.iter().map(PathBuf::as_path).collect();
    let output = Writes { command: REPORT, force: asked.force, reads }.output(&asked.out, &[Form::Page])?;
    // all scenes are read before the first run, so that faults are reported immediately
    let (mut scenes, mut unread) = (Vec::new(), Vec::new());
    // scenes with the table [failure] belong to the catalogue of failures
    for file in files.iter().filter(|file| !failures::is_own(file)) {
        match AnyScene::open(file) {
            // left out to keep the page small; `chart` makes a page for such a scene
            Ok(AnyScene::Model(_)) if is_example(file, folder) => {}
            Ok(scene) => scenes.push(Read { id: id(file), scene, kept: Stored::beside(file) }),
            Err(error) => {
                warn_of(&error);
                unread.push(error);
            }
        }
    }
    let mut papers = Vec::new();
    for file in paper_files(&asked.papers) {
        match PaperText::read(&file) {
            Ok(paper) => papers.push(paper),
            Err(error) => {
                warn_of(&error);
                unread.push(error);
            }
        }
    }
    let mut parts = Parts::of(&scenes, &papers, folder);
    let mut progress = Progress::new("ledger, runs, references, maps");
    parts.compute(&scenes, &papers, folder, |done| progress.set(done));
    drop(progress);
    let mut progress = Progress::new("methods timed");
    parts.take_times(|done| progress.set(done));
    drop(progress);
    let faults = parts.faults();
    faults.iter().for_each(|fault| warn(fault));
    let whole = faults.is_empty() && unread.is_empty();
    let mut report = parts.report(folder);
    report.studies.splice(0..0, unread::study(&unread));
    output.write_text(&charts::page::render(&report).html)?.tell(Format::Text)?;
    Ok(if whole { Exit::Done } else { Exit::Stopped })
}

/// The sorted paths of the files of papers in a folder; files of systems are skipped.
fn paper_files(folder: &Path) -> Vec<PathBuf> {
    let entries = folder.read_dir().into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    let is_paper = |path: &Path| std::fs::read_to_string(path).map_or(true, |text| is_paper(&text));
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml") && is_paper(path));
    files.sort();
    files
}

/// The folders of scenes that are left out of the report: examples of the language, and problems of public collections.
const EXAMPLES: [&str; 2] = ["models", crate::studies::FOLDER];

fn is_example(file: &Path, scenes: &Path) -> bool {
    file.strip_prefix(scenes).is_ok_and(|inner| EXAMPLES.iter().any(|folder| inner.starts_with(folder)))
}

/// The names of the commands that write pages, for the mark of the page; that of the report is empty.
const REPORT: &str = "";
const CHART: &str = "chart";

/// A page about one scene, with the errors and costs of all methods.
pub fn of_scene(scene: &dyn IvpScene, atlas: &Atlas, work: Vec<WorkPrecision>) -> String {
    let choice = scene.run().choice();
    let run = scene.problem(choice.axes).simulate(&choice, |_| ());
    let mut section = SceneSection { work, ..described("scene", scene, &run) };
    explained(&mut section, atlas);
    section.tables.push(tables::models(atlas));
    let report = Report { scenes: vec![section], ..titled(CHART, scene.title(), scene.description()) };
    charts::page::render(&report).html
}

/// Adds advice, the note on the measurements and the Pareto fronts to the section of a scene.
fn explained(section: &mut SceneSection, atlas: &Atlas) {
    section.facts.extend([1e-3, 1e-6, 1e-9].map(|error| ("advice".to_owned(), advice(atlas, error))));
    section.note = pictures::measured_by(atlas);
    section.tables.splice(0..0, tables::fronts(atlas));
}

/// An empty report of a command.
fn titled(command: &'static str, title: &str, summary: &str) -> Report {
    let generated_by = Maker(command).generator();
    Report { title: title.to_owned(), summary: summary.to_owned(), generated_by, ..Default::default() }
}

/// The name of a file without its extension, as an identifier for links.
fn id(file: &Path) -> String {
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' }).collect()
}
