//! Earlier texts of a file: at a commit of git, or in another file.

use crate::exit::Exit;
use scenes::SystemText;
use std::path::Path;
use std::process::Command;

/// The path given by --against if it is a file; `None` where it names a commit.
pub(super) fn other_file(against: &str) -> Option<&Path> {
    Some(Path::new(against)).filter(|other| other.is_file())
}

/// The earlier text of a file, with its name for messages: from another file if `against` is one, otherwise from the commit `against`.
pub(super) fn of(file: &Path, against: &str) -> Result<SystemText, Exit> {
    if let Some(other) = other_file(against) {
        return Ok(SystemText::read(other)?);
    }
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let folder = folder.to_string_lossy();
    let text = git(&["-C", &folder, "show", &format!("{against}:./{name}")]).map_err(|why| match why {
        Exit::Refused(why) if why.contains("not a git repository") => {
            Exit::refused(format!("{}: the file is not in a git repository; give --against FILE", file.display()))
        }
        Exit::Refused(why) => Exit::refused(format!(
            "{}: --against {against}: {}; a commit that has this file, or another file, is accepted",
            file.display(),
            why.trim_start_matches("error: ")
        )),
        other => other,
    })?;
    Ok(SystemText { name: format!("{} at {against}", file.display()), text, values: Vec::new() })
}

/// The standard output of git with these arguments.
pub(super) fn git(arguments: &[&str]) -> Result<String, Exit> {
    let output = Command::new("git").args(arguments).output();
    let output = output.map_err(|error| Exit::refused(format!("git, which keeps earlier texts: {error}")))?;
    if !output.status.success() {
        let reason = String::from_utf8_lossy(&output.stderr);
        return Err(Exit::refused(format!("git {}: {}", arguments.join(" "), reason.trim())));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
