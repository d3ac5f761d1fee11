//! `dalembert scenes`: what there is to run.

use crate::ending::{Ending, print};
use derivations::scene::{AnyScene, Family};
use std::io;
use std::path::{Path, PathBuf};

/// Prints each scene of a folder with its machine or its system, and its title; one that is not acceptable with the number
/// of its faults.
pub fn list(folder: &Path) -> Result<Ending, Ending> {
    let mut text = String::new();
    for path in files(folder)? {
        let said = match AnyScene::open(&path) {
            Ok(AnyScene::Driven(scene)) => format!("{:<22} {}", scene.machine.name(), scene.title),
            Ok(AnyScene::Rough(scene)) => format!("{:<22} {}", scene.system.name(), scene.title),
            Ok(AnyScene::Mechanism(scene)) => format!("{:<22} {}", scene.name, scene.title),
            Err(error) => format!("{:<22} {} faults; `dalembert run` tells them", "", error.issues.len()),
        };
        text += &format!("{:<46} {said}\n", path.display().to_string());
    }
    print(&text)?;
    Ok(Ending::Done)
}

/// The TOML files of a folder and of the folders in it, each folder's own first, by name.
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
    let (mut files, mut open) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(next) = open.pop() {
        let (mut own, mut folders) = (Vec::new(), Vec::new());
        for entry in std::fs::read_dir(next).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            let path = entry.path();
            // a link to a folder is not followed: it might lead back
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
        true => Err(Ending::refused(format!("{} holds no scene: no file ends in .toml", folder.display()))),
        false => Ok(files),
    }
}
