//! The study of problems from public collections: each is run with the method of its file and compared with its reference.

use crate::job_pool::JobPool;
use charts::{Study, Table};
use reader::Family;
use simulation::{Axes, Stored};
use std::path::{Path, PathBuf};
use studies::AnyScene;

/// The folder of these problems within the folder of scenes.
pub const FOLDER: &str = "foreign";

/// The files of the problems, each with its row of the table once it is computed.
#[derive(Default)]
pub struct ForeignProblems(Vec<(PathBuf, Option<Vec<String>>)>);

impl ForeignProblems {
    /// The problems in a folder of scenes.
    pub fn of(scenes: &Path) -> Self {
        let entries = std::fs::read_dir(scenes.join(FOLDER)).into_iter().flatten().flatten();
        let is_scene = |path: &PathBuf| path.extension().is_some_and(|end| end == "toml");
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(is_scene).collect();
        paths.sort();
        ForeignProblems(paths.into_iter().map(|path| (path, None)).collect())
    }

    pub fn enlist<'a>(&'a mut self, crew: &mut JobPool<'a>) {
        for (path, row) in &mut self.0 {
            let path = &*path;
            crew.add(0.2, row, move || row_of(path));
        }
    }

    /// The study with its table; `None` without rows.
    pub fn study(self) -> Option<Study> {
        let rows: Vec<Vec<String>> =
            self.0.into_iter().filter_map(|(_, row)| row.filter(|row| !row.is_empty())).collect();
        let head =
            ["problem", "states", "method", "tolerance", "evaluations", "error at the end", "digits of the reference"];
        (!rows.is_empty()).then(|| Study {
            id: "foreign".into(),
            title: "Problems of public collections".into(),
            lead: "Problems of public collections and reports, each run by the method and the tolerance of its file, up to the end of its \
                   reference, which two methods confirm. The file names the source and its figures, which the tests compare; errors are \
                   relative to the size of each component."
                .into(),
            tables: vec![Table { caption: String::new(), head: head.map(str::to_owned).to_vec(), rows }],
            ..Study::default()
        })
    }
}

/// The row of a problem. It is empty for a file without a reference, and for one that cannot be read, which a test reports.
fn row_of(path: &Path) -> Vec<String> {
    let Some(kept) = Stored::beside(path) else { return Vec::new() };
    let Ok(opened) = AnyScene::open(path) else {
        return Vec::new();
    };
    let scene = opened.smooth();
    let choice = scene.run().choice();
    let mut problem = scene.problem(Axes::First);
    if let Some(until) = kept.reference.times.last() {
        problem.span = *until;
    }
    let run = problem.simulate(&choice, |_| ());
    let reached = run.stopped().is_none();
    let error = kept.reference.states.last().filter(|_| reached).map(|exact| {
        let exact = exact.iter().zip(&kept.reference.sizes);
        let off = run.outcome.state.iter().zip(exact).map(|(own, (exact, size))| (own - exact.hi()).abs() / size);
        format!("{:.1e}", off.fold(0.0, f64::max))
    });
    vec![
        scene.title().to_owned(),
        problem.state.len().to_string(),
        choice.method.to_string(),
        format!("{:.0e}", choice.tolerance),
        run.outcome.work.rates.to_string(),
        error.unwrap_or_else(|| "-".to_owned()),
        format!("{:.0}", kept.reference.digits.floor()),
    ]
}
