//! `dalembert scenes`: what there is to run.

use crate::ending::{Ending, print};
use derivations::scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// Prints each scene of a folder with its machine and title; one that is not acceptable with the number of its faults.
pub fn list(folder: &Path) -> Result<Ending, Ending> {
    let mut text = String::new();
    for path in files(folder)? {
        let said = match Scene::open(&path) {
            Ok(scene) => format!("{:<22} {}", scene.machine.name(), scene.title),
            Err(error) => format!("{:<22} {} faults; `dalembert run` tells them", "", error.issues.len()),
        };
        text += &format!("{:<34} {said}\n", path.display().to_string());
    }
    print(&text)?;
    Ok(Ending::Done)
}

/// The TOML files of a folder, by name.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>, Ending> {
    let unreadable = |error: io::Error| {
        let accepted = "a folder with scene files is accepted; the project's own is `scenes`";
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "there is no such folder".to_owned(),
            io::ErrorKind::NotADirectory => "this is no folder".to_owned(),
            _ => error.to_string(),
        };
        Ending::refused(format!("{}: {reason}; {accepted}", folder.display()))
    };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            files.push(path);
        }
    }
    files.sort();
    match files.is_empty() {
        true => Err(Ending::refused(format!("{} holds no scene: no file ends in .toml", folder.display()))),
        false => Ok(files),
    }
}
