//! `dalembert scenes`: a list of the scenes in a folder.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use reader::Family;
use serde_json::{Value, json};
use std::io;
use std::path::{Path, PathBuf};
use studies::AnyScene;

/// Arguments of `scenes`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The folder of the scene files
    #[arg(default_value = "scenes")]
    pub folder: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints each scene of a folder with the model of its motor or `model`, and its title. A file that cannot be read is listed with the
/// number of its faults.
pub fn list(asked: &Args) -> Result<Exit, Exit> {
    let files = files(&asked.folder)?;
    let listed = files.iter().map(|path| (path.display().to_string(), listed(path)));
    print(&match asked.format {
        Format::Text => listed.map(|(path, scene)| line(&path, scene)).collect(),
        Format::Json => format!("{:#}\n", Value::from_iter(listed.map(|(path, scene)| object(path, scene)))),
    })?;
    Ok(Exit::Done)
}

/// The model of the motor or system of a scene, and its title; or the number of faults of the file.
fn listed(path: &Path) -> Result<(String, String), usize> {
    match AnyScene::open(path) {
        Ok(AnyScene::Driven(scene)) => Ok((scene.machine.name().to_owned(), scene.title)),
        Ok(AnyScene::Model(scene)) => Ok((scene.model().to_owned(), scene.title().to_owned())),
        Err(error) => Err(error.issues.len()),
    }
}

fn line(path: &str, scene: Result<(String, String), usize>) -> String {
    match scene {
        Ok((system, title)) => format!("{path:<46} {system:<22} {title}\n"),
        Err(1) => format!("{path:<46} {:<22} 1 fault; `dalembert run` prints it\n", ""),
        Err(faults) => format!("{path:<46} {:<22} {faults} faults; `dalembert run` prints them\n", ""),
    }
}

fn object(path: String, scene: Result<(String, String), usize>) -> Value {
    match scene {
        Ok((system, title)) => json!({ "path": path, "system": system, "title": title }),
        Err(faults) => json!({ "path": path, "faults": faults }),
    }
}

/// The paths of the TOML files in a folder and its subfolders: the files of each folder first, sorted by name.
///
/// # Errors
/// A folder cannot be read, or there is no scene.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>, Exit> {
    let unreadable = |error: io::Error| {
        let accepted = "a folder with scene files is accepted; the project's own is `scenes`";
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "there is no such folder".to_owned(),
            io::ErrorKind::NotADirectory => "this is no folder".to_owned(),
            _ => error.to_string(),
        };
        Exit::refused(format!("{}: {reason}; {accepted}", folder.display()))
    };
    let (mut files, mut open) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(next) = open.pop() {
        let (mut own, mut folders) = (Vec::new(), Vec::new());
        for entry in std::fs::read_dir(next).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            let path = entry.path();
            // links to folders are not followed, since they may lead to a parent folder
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                own.push(path);
            }
        }
        own.sort();
        files.extend(own);
        folders.sort();
        open.extend(folders.into_iter().rev());
    }
    match files.is_empty() {
        true => Err(Exit::refused(format!("{} holds no scene: no file ends in .toml", folder.display()))),
        false => Ok(files),
    }
}
