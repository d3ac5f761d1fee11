//! The end of the program: exit codes, messages, and output into a pipe that may be closed.

use crate::{clock, progress};
use ::scenes::with_ways_to_a_system;
use charts::visible;
use reader::{Issue, SceneError, read_text};
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// The escape character, with which control sequences of terminals begin.
const ESCAPE: &str = "\u{1b}";

/// Whether only results and errors are printed; set once, at the start of the program.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Restricts all output to results and errors.
pub fn be_quiet() {
    QUIET.store(true, Relaxed);
}

/// Whether only results and errors are printed.
pub fn is_quiet() -> bool {
    QUIET.load(Relaxed)
}

/// The outcome of a command, from which the exit code follows. As the error of a function it is a refusal, or the early end of the command.
#[derive(Debug)]
pub enum Exit {
    /// Success.
    Done,
    /// The command ran, but its result is incomplete or negative; the reason has been printed.
    Stopped,
    /// The input is not acceptable. The message contains no control sequences of terminals except the program's own colours.
    Refused(String),
    /// The command line is not acceptable; the reason has been printed.
    Wrong,
}

impl Exit {
    /// A refusal with the message `error: ...`.
    pub fn refused(error: impl Display) -> Self {
        Exit::Refused(visible(&format!("error: {error}")).into_owned())
    }

    /// The refusal of a command whose file cannot be written, with the reason and a remedy.
    pub fn unwritable(path: &Path, error: &io::Error) -> Self {
        const A_FILE: &str = "the name of a file is accepted";
        const ROOM: &str = "free some, or name a file on another disk";
        let (reason, remedy) = match error.kind() {
            io::ErrorKind::NotFound => ("there is no such folder".to_owned(), A_FILE),
            io::ErrorKind::IsADirectory => ("this is a folder".to_owned(), A_FILE),
            io::ErrorKind::NotADirectory => ("a part of its path is not a folder".to_owned(), A_FILE),
            io::ErrorKind::InvalidFilename => ("this cannot name a file".to_owned(), A_FILE),
            io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
                ("this may not be written".to_owned(), "a file that may be written is accepted")
            }
            io::ErrorKind::StorageFull => ("no space is left there".to_owned(), ROOM),
            io::ErrorKind::QuotaExceeded => ("the quota of disk space is used up".to_owned(), ROOM),
            io::ErrorKind::FileTooLarge => (
                "the file would be larger than is allowed there".to_owned(),
                "another place or a shorter table is accepted",
            ),
            _ => (error.to_string(), ""),
        };
        let remedy = if remedy.is_empty() { String::new() } else { format!("; {remedy}") };
        Exit::refused(format!("{} cannot be written: {reason}{remedy}", path.display()))
    }

    /// Prints the message, if there is one, and returns the exit code.
    pub fn tell(self) -> ExitCode {
        if matches!(self, Exit::Done | Exit::Stopped)
            && let Some(code) = clock::broke_off()
        {
            return ExitCode::from(code);
        }
        match self {
            Exit::Done => ExitCode::SUCCESS,
            Exit::Stopped => ExitCode::from(1),
            Exit::Refused(message) => {
                told(&message);
                ExitCode::from(2)
            }
            Exit::Wrong => ExitCode::from(2),
        }
    }
}

/// The refusal of a file with a fault, shown at its place in the file.
pub fn placed(path: &Path, issue: Issue) -> Exit {
    match read_text(path) {
        Ok(text) => SceneError { path: path.display().to_string(), text, issues: vec![issue] }.into(),
        Err(error) => error.into(),
    }
}

impl From<SceneError> for Exit {
    fn from(error: SceneError) -> Self {
        Exit::Refused(rendered(&with_ways_to_a_system(error)))
    }
}

/// All faults of a scene as text for standard error, without control sequences of terminals that come from the scene.
fn rendered(error: &SceneError) -> String {
    let mut error = error.clone();
    let seen = |text: &mut String| *text = visible(text).into_owned();
    seen(&mut error.path);
    for issue in &mut error.issues {
        seen(&mut issue.title);
        seen(&mut issue.label);
        issue.help.iter_mut().for_each(seen);
    }
    let colours = io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    // the renderer has replaced escape characters of the file, so that those that remain begin its own colours
    error.render(colours).split(ESCAPE).map(visible).collect::<Vec<_>>().join(ESCAPE)
}

/// Prints to standard output, with control characters made visible. A closed pipe is not an error.
///
/// # Errors
/// Standard output cannot be written, for example because the disk is full.
pub fn print(text: &str) -> Result<(), Exit> {
    let _held = clock::held();
    // the final text contains the interim results, which must not be printed a second time
    clock::publish(String::new());
    progress::clear();
    let mut out = io::stdout().lock();
    match out.write_all(visible(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Exit::refused(format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints a message of clap: help and version to standard output, where a failure is an error; faults of the command line to
/// standard error.
pub fn print_instead(said: &clap::Error) -> Exit {
    let hostile = std::env::args_os().any(|argument| {
        let argument = argument.to_string_lossy();
        visible(&argument) != argument
    });
    if said.use_stderr() && hostile {
        // clap repeats arguments without making control characters visible
        warn(said.to_string().trim_end());
        return Exit::Wrong;
    }
    let printed = said.print().and_then(|()| io::stdout().flush());
    match printed {
        _ if said.use_stderr() => Exit::Wrong,
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Exit::refused(format!("standard output cannot be written: {error}"))
        }
        _ => Exit::Done,
    }
}

/// Prints a warning to standard error; a failure to do so is ignored.
pub fn warn(text: &str) {
    told(&visible(text));
}

/// Prints the faults of a scene to standard error.
pub fn warn_of(error: &SceneError) {
    told(&rendered(error));
}

fn told(text: &str) {
    let _held = clock::held();
    progress::clear();
    let _ = writeln!(io::stderr(), "{text}");
}

#[cfg(test)]
mod tests {
    use super::Exit;
    use reader::{Issue, SceneError};

    #[test]
    fn a_message_about_a_scene_keeps_our_colours_and_nothing_of_others() {
        let text = "title = \"A\u{1b}[31m\u{9b}2J\u{202e}B\u{7}\" x";
        let error = |path: &str| SceneError {
            path: path.to_owned(),
            text: text.to_owned(),
            issues: vec![Issue::at(0..text.len(), path, path).accepted(path)],
        };
        let Exit::Refused(message) = Exit::from(error("\u{1b}]0;T\u{7}\u{9b}5m\u{202e}")) else {
            unreachable!("a scene with issues is refused")
        };
        assert!(!message.contains(['\u{7}', '\u{9b}', '\u{202e}']), "{message:?}");
        assert!(message.contains("\\u001b]0;T") && message.contains("\u{241b}[31m"), "{message:?}");
    }
}
