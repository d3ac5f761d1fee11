//! How the program ends: exit codes, messages, and writing that survives a closed pipe.

use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use crate::whole;
use derivations::scene::SceneError;

/// Whether nothing but results and errors is wanted: said once, when the program begins.
static QUIET: AtomicBool = AtomicBool::new(false);

/// From here on nothing is told but results and errors.
pub fn be_quiet() {
    QUIET.store(true, Relaxed);
}

/// Whether nothing but results and errors is wanted.
pub fn is_quiet() -> bool {
    QUIET.load(Relaxed)
}

/// What the caller is told.
#[derive(Debug)]
pub enum Ending {
    /// All is well.
    Done,
    /// What was asked ran, and did not come out as it should; the reason has been printed.
    Stopped,
    /// The user asked for the end; what there was is kept and told.
    Interrupted,
    /// The input is not acceptable.
    Refused(String),
}

impl Ending {
    /// A command that cannot be carried out.
    pub fn refused(error: impl Display) -> Self {
        Ending::Refused(format!("error: {error}"))
    }

    /// A file that cannot be written.
    pub fn unwritable(path: &Path, error: &io::Error) -> Self {
        let reason = match error.kind() {
            io::ErrorKind::NotFound => "there is no such folder".to_owned(),
            io::ErrorKind::IsADirectory => "this is a folder".to_owned(),
            io::ErrorKind::NotADirectory => "what stands before its name is no folder".to_owned(),
            io::ErrorKind::PermissionDenied => "this may not be written".to_owned(),
            _ => error.to_string(),
        };
        Ending::refused(format!(
            "{} cannot be written: {reason}; a file in a folder that exists is accepted",
            path.display()
        ))
    }

    /// Prints the message, if there is one, and gives the exit code.
    pub fn tell(self) -> ExitCode {
        match self {
            Ending::Done => ExitCode::SUCCESS,
            Ending::Stopped => ExitCode::from(1),
            // as shells tell a program that SIGINT ended
            Ending::Interrupted => ExitCode::from(130),
            Ending::Refused(message) => {
                // where even this cannot be written, the exit code must do
                let _ = writeln!(io::stderr(), "{message}");
                ExitCode::from(2)
            }
        }
    }
}

impl From<SceneError> for Ending {
    fn from(error: SceneError) -> Self {
        let colours = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Ending::Refused(error.render(colours))
    }
}

/// Prints to standard output. A reader who has seen enough and closed the pipe is no error.
pub fn print(text: &str) -> Result<(), Ending> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Ending::refused(format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Whether [`save`] can write a file: asked before the work, so that a wrong name does not cost it. Nothing is made.
pub fn can_save(path: &Path) -> Result<(), Ending> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if folder.exists() && folder.is_dir() {
        return whole::check(path);
    }
    // the folders that are missing would stand in this one
    let there = folder.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("."));
    if !there.is_dir() {
        return Err(Ending::unwritable(path, &io::ErrorKind::NotADirectory.into()));
    }
    let probed = whole::check(&there.join("probe"));
    probed.map_err(|_| Ending::unwritable(path, &io::ErrorKind::PermissionDenied.into()))
}

/// Writes a file, and the folder it is in where that is missing; tells its name.
pub fn save(path: &Path, text: &str) -> Result<(), Ending> {
    let unwritable = |error: io::Error| Ending::unwritable(path, &error);
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        std::fs::create_dir_all(folder).map_err(unwritable)?;
    }
    whole::write(path, |out| out.write_all(text.as_bytes()))?;
    if is_quiet() { Ok(()) } else { print(&format!("{}\n", path.display())) }
}

#[cfg(test)]
mod tests {
    use super::can_save;
    use std::path::Path;

    #[test]
    fn a_file_can_be_saved_in_folders_that_are_not_there_yet() {
        for path in ["no_such_folder/page.html", "no/such/folder/page.html", "page.html", "./page.html"] {
            assert!(can_save(Path::new(path)).is_ok(), "{path}");
        }
        for path in ["src", "Cargo.toml/page.html", "/proc/no_such_folder/page.html", "/"] {
            assert!(can_save(Path::new(path)).is_err(), "{path}");
        }
    }
}
