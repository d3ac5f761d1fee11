//! The target of a path: a file that may exist, or a pipe or device, which is opened immediately.

use std::fs::{self, File, FileType, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// The target of a path.
pub enum Target {
    /// The path of a file that may exist, with links resolved.
    File(PathBuf),
    /// An open terminal, pipe or null device, to which output is written directly.
    Device(File),
}

impl Target {
    /// Finds the target of a path. A pipe is opened here and stays open, so that its reader waits for the output. If it has no reader, this
    /// function waits a few seconds for one.
    ///
    /// # Errors
    /// The path leads to a folder, a missing target of a link, a read-only file, or a pipe without a reader.
    pub fn of(path: &Path) -> io::Result<Self> {
        let found = match fs::metadata(path) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                if fs::symlink_metadata(path).is_ok() {
                    return Err(io::Error::other("this is a link to nothing"));
                }
                return match path.file_name() {
                    Some(_) => Ok(Target::File(path.to_owned())),
                    None => Err(io::ErrorKind::IsADirectory.into()),
                };
            }
            Err(error) => return Err(error),
        };
        match found.file_type() {
            kind if kind.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            kind if kind.is_file() && found.permissions().readonly() => Err(io::ErrorKind::PermissionDenied.into()),
            kind if kind.is_file() => fs::canonicalize(path).map(Target::File),
            kind if is_pipe(kind) => pipe(path).map(Target::Device),
            kind if is_characters(kind) => OpenOptions::new().write(true).open(path).map(Target::Device),
            _ => Err(io::Error::other("this is neither a file nor a pipe nor a device that takes characters")),
        }
    }

    /// Whether two targets are the same file.
    pub fn is(&self, other: &Target) -> bool {
        let whole = |path: &Path| {
            let folder = fs::canonicalize(crate::atomic_write::folder(path)).ok()?;
            Some(folder.join(path.file_name()?))
        };
        match (self, other) {
            (Target::File(one), Target::File(other)) => {
                one == other
                    || whole(one).is_some_and(|one| whole(other) == Some(one))
                    || same_file::is_same_file(one, other).unwrap_or(false)
            }
            _ => false,
        }
    }
}

#[cfg(unix)]
fn is_pipe(kind: FileType) -> bool {
    std::os::unix::fs::FileTypeExt::is_fifo(&kind)
}

#[cfg(unix)]
fn is_characters(kind: FileType) -> bool {
    std::os::unix::fs::FileTypeExt::is_char_device(&kind)
}

#[cfg(not(unix))]
fn is_pipe(_: FileType) -> bool {
    false
}

/// Always true: on systems other than Unix, everything that is neither a file nor a folder counts as a device.
#[cfg(not(unix))]
fn is_characters(_: FileType) -> bool {
    true
}

/// Opens a pipe for writing; waits up to five seconds for a reader.
#[cfg(unix)]
fn pipe(path: &Path) -> io::Result<File> {
    use rustix::fs::{Mode, OFlags, fcntl_setfl, open};
    use rustix::io::Errno;
    use std::time::{Duration, Instant};

    const PATIENCE: Duration = Duration::from_secs(5);
    let begin = Instant::now();
    loop {
        match open(path, OFlags::WRONLY | OFlags::NONBLOCK | OFlags::CLOEXEC, Mode::empty()) {
            Ok(pipe) => {
                // later writes block, so that a slow reader is waited for
                fcntl_setfl(&pipe, OFlags::empty())?;
                return Ok(pipe.into());
            }
            Err(Errno::NXIO) if begin.elapsed() < PATIENCE => std::thread::sleep(Duration::from_millis(20)),
            Err(Errno::NXIO) => {
                return Err(io::Error::other("nobody reads from this pipe; one that is read is accepted"));
            }
            Err(error) => return Err(error.into()),
        }
    }
}

#[cfg(not(unix))]
fn pipe(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}
