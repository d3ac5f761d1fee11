//! Atomic writing of output files: a kill of the program never leaves an incomplete file under the requested name.
//!
//! The content is written to a temporary file in the same folder and synced to the disk. The temporary file is then renamed to the requested name,
//! under which there is at any time either the old content or all of the new. A kill during the writing leaves the file `.NAME.*.part`; Ctrl-C does not.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tempfile::{Builder, NamedTempFile};

/// A complete temporary file in the folder of its destination. Dropping the value removes the file.
pub struct Beside {
    file: NamedTempFile,
    path: PathBuf,
    part: Part,
}

/// The paths of all temporary files; an early end of the program removes them.
static PARTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The path of a temporary file. It is listed in `PARTS` until the value is dropped.
struct Part(PathBuf);

impl Part {
    fn of(file: &NamedTempFile) -> Self {
        let path = file.path().to_owned();
        parts(|parts| parts.push(path.clone()));
        Part(path)
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        parts(|parts| parts.retain(|other| *other != self.0));
    }
}

fn parts<T>(change: impl FnOnce(&mut Vec<PathBuf>) -> T) -> T {
    change(&mut PARTS.lock().unwrap_or_else(PoisonError::into_inner))
}

/// Removes all temporary files, before an early end of the program.
pub fn remove_parts() {
    for part in parts(std::mem::take) {
        // a failure has no remedy, since the program ends
        let _ = fs::remove_file(part);
    }
}

/// The reason for which a temporary file was not renamed to its destination.
pub enum Untaken {
    /// The destination exists; the value contains the temporary file.
    Occupied(Beside),
    Failed(io::Error),
}

impl Beside {
    /// Writes a temporary file in the folder of its destination, which must exist, and syncs it to the disk.
    ///
    /// # Errors
    /// Errors of the file system or of `content`; the temporary file is then removed.
    pub fn write(
        path: &Path,
        content: impl FnOnce(&mut BufWriter<NamedTempFile>) -> io::Result<()>,
    ) -> io::Result<Self> {
        let file = part(path)?;
        let part = Part::of(&file);
        let mut out = BufWriter::new(file);
        content(&mut out)?;
        let file = out.into_inner()?;
        file.as_file().sync_all()?;
        Ok(Beside { file, path: path.to_owned(), part })
    }

    /// Renames the temporary file to its destination, and gives it the permissions of the file that it replaces.
    ///
    /// # Errors
    /// Errors of the file system; the file at the destination is then unchanged.
    pub fn replace(self) -> io::Result<()> {
        if let Ok(before) = fs::metadata(&self.path) {
            self.file.as_file().set_permissions(before.permissions())?;
        }
        self.file.persist(&self.path)?;
        settle(&self.path);
        Ok(())
    }

    /// Renames the temporary file to its destination if nothing exists there.
    ///
    /// # Errors
    /// [`Untaken`], where the destination exists or the file system fails.
    pub fn take(self) -> Result<(), Untaken> {
        let Beside { file, path, part } = self;
        match file.persist_noclobber(&path) {
            Ok(_) => {
                settle(&path);
                Ok(())
            }
            Err(refused) if fs::symlink_metadata(&path).is_ok() => {
                Err(Untaken::Occupied(Beside { file: refused.file, path, part }))
            }
            // some file systems have no renaming that fails if the destination exists
            Err(refused) => {
                refused.file.persist(&path).map(|_| settle(&path)).map_err(|error| Untaken::Failed(error.error))
            }
        }
    }

    /// Keeps the file under its temporary name, and returns this name.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn keep(self) -> io::Result<PathBuf> {
        Ok(self.file.keep()?.1)
    }
}

/// Replaces the content of a file atomically.
///
/// # Errors
/// Errors of the file system; the file is then unchanged.
pub fn replace(path: &Path, content: &str) -> io::Result<()> {
    Beside::write(path, |out| out.write_all(content.as_bytes()))?.replace()
}

/// Creates a file atomically.
///
/// # Errors
/// The file exists, or the file system fails.
pub fn create(path: &Path, content: &str) -> io::Result<()> {
    let written = Beside::write(path, |out| out.write_all(content.as_bytes()))?;
    written.take().map_err(|untaken| match untaken {
        Untaken::Occupied(_) => io::ErrorKind::AlreadyExists.into(),
        Untaken::Failed(error) => error,
    })
}

/// Checks that a file can be written at a path whose folders need not exist; creates nothing.
///
/// # Errors
/// The reason for which the file system could not write the file.
pub fn probe(path: &Path) -> io::Result<()> {
    let name = path.file_name().ok_or(io::ErrorKind::IsADirectory)?;
    // the nearest existing folder, in which the missing ones would be created
    let there = folder(path).ancestors().find(|folder| folder.as_os_str().is_empty() || folder.exists());
    let there = there.filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !there.is_dir() {
        return Err(io::ErrorKind::NotADirectory.into());
    }
    part(&there.join(name)).map(drop)
}

/// The folder of a file; `.` for a name without a folder.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// An empty temporary file in the folder of its destination, with the usual permissions of a new file.
fn part(path: &Path) -> io::Result<NamedTempFile> {
    // a long name is cut, since the temporary name with its prefix and suffix must be valid too
    let name: String =
        path.file_name().ok_or(io::ErrorKind::IsADirectory)?.to_string_lossy().chars().take(50).collect();
    let prefix = format!(".{name}.");
    let mut builder = Builder::new();
    builder.prefix(&prefix).suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path))
}

/// Syncs the folder of a renamed file to the disk; systems that cannot sync folders are ignored.
fn settle(path: &Path) {
    let _ = File::open(folder(path)).and_then(|folder| folder.sync_all());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> usize {
        fs::read_dir(folder).expect("it is there").count()
    }

    #[test]
    fn what_breaks_off_leaves_what_was_there_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let path = folder.path().join("table.csv");
        replace(&path, "old").expect("it can be written");
        let broken = Beside::write(&path, |out| {
            out.write_all(&[b'x'; 1 << 16])?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(broken.is_err());
        assert_eq!(fs::read(&path).expect("it is there"), b"old");
        assert_eq!(names(folder.path()), 1);
        replace(&path, "new").expect("it can be written");
        assert_eq!(fs::read(&path).expect("it is there"), b"new");
    }

    #[test]
    fn a_place_that_was_taken_meanwhile_is_left_alone_and_the_work_is_kept() {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let path = folder.path().join("table.csv");
        let written = Beside::write(&path, |out| out.write_all(b"mine")).expect("it can be written");
        fs::write(&path, "another's").expect("it can be written");
        let Err(Untaken::Occupied(written)) = written.take() else { panic!("the place is taken") };
        let kept = written.keep().expect("it can be kept");
        assert_eq!(fs::read(&path).expect("it is there"), b"another's");
        assert_eq!(fs::read(kept).expect("it is there"), b"mine");
        assert!(create(&path, "mine").is_err());
        assert_eq!(fs::read(&path).expect("it is there"), b"another's");
    }

    #[test]
    fn a_probe_makes_no_file_and_refuses_what_cannot_be_one() {
        let folder = tempfile::tempdir().expect("a folder can be made");
        fs::write(folder.path().join("file"), "").expect("it can be written");
        for right in ["table.csv", "no/such/folder/table.csv"] {
            assert!(probe(&folder.path().join(right)).is_ok(), "{right}");
        }
        for wrong in ["file/table.csv", "file/no/table.csv", "no/.."] {
            assert!(probe(&folder.path().join(wrong)).is_err(), "{wrong}");
        }
        assert_eq!(names(folder.path()), 1);
    }

    #[cfg(unix)]
    #[test]
    fn permissions_stay() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder can be made");
        let path = folder.path().join("table.csv");
        replace(&path, "old").expect("it can be written");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("it is there");
        replace(&path, "new").expect("it can be written");
        assert_eq!(fs::metadata(&path).expect("it is there").permissions().mode() & 0o777, 0o640);
    }
}
