//! Files that are whole under their names, whenever the program is killed.
//!
//! What is written goes to a file beside its place, is brought to the disk, and then takes the place: under the name there
//! is what was there before, or all of the new. A kill while it is written leaves `.NAME.*.part` behind.

use crate::ending::Ending;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// Whether a file can be written there: asked before the work, so that a wrong name does not cost it.
pub fn check(path: &Path) -> Result<(), Ending> {
    let probe = |place: Place| match place {
        Place::File(path) => beside(&path).map(drop),
        Place::Device => OpenOptions::new().write(true).open(path).map(drop),
    };
    place(path).and_then(probe).map_err(|error| Ending::unwritable(path, &error))
}

/// Writes a file, all of it or nothing.
pub fn write(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Ending> {
    let written = |place: Place| match place {
        Place::File(path) => {
            let mut out = BufWriter::new(beside(&path)?);
            content(&mut out)?;
            settle(out.into_inner()?, &path)
        }
        Place::Device => {
            let mut out = BufWriter::new(OpenOptions::new().write(true).open(path)?);
            content(&mut out).and_then(|()| out.flush())
        }
    };
    place(path).and_then(written).map_err(|error| Ending::unwritable(path, &error))
}

/// What a name stands for.
enum Place {
    /// A file, there or not yet; links are followed.
    File(PathBuf),
    /// A terminal, a pipe, nothing: written to as it stands.
    Device,
}

fn place(path: &Path) -> io::Result<Place> {
    match fs::metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Place::File(path.to_owned())),
        Err(error) => Err(error),
        Ok(found) if found.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if found.is_file() && found.permissions().readonly() => Err(io::ErrorKind::PermissionDenied.into()),
        Ok(found) if found.is_file() => fs::canonicalize(path).map(Place::File),
        Ok(_) => Ok(Place::Device),
    }
}

/// The folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A file beside the place, which goes with what writes to it; as readable as others that a program makes.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let name = path.file_name().ok_or(io::ErrorKind::IsADirectory)?.to_string_lossy();
    let prefix = format!(".{name}.");
    let mut builder = Builder::new();
    builder.prefix(&prefix).suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path))
}

/// Brings it to the disk and to its place.
fn settle(file: NamedTempFile, path: &Path) -> io::Result<()> {
    if let Ok(before) = fs::metadata(path) {
        file.as_file().set_permissions(before.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(path)?;
    // the new name, where the system can bring a folder to the disk
    let _ = File::open(folder(path)).and_then(|folder| folder.sync_all());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_breaks_off_leaves_what_was_there_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let path = folder.path().join("table.csv");
        write(&path, |out| out.write_all(b"old")).expect("it can be written");
        let broken = write(&path, |out| {
            out.write_all(&[b'x'; 1 << 16])?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert!(broken.is_err());
        assert_eq!(fs::read(&path).expect("it is there"), b"old");
        assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 1);
        write(&path, |out| out.write_all(b"new")).expect("it can be written");
        assert_eq!(fs::read(&path).expect("it is there"), b"new");
    }

    #[test]
    fn a_check_makes_no_file_and_refuses_what_cannot_be_one() {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let path = folder.path().join("table.csv");
        assert!(check(&path).is_ok() && !path.exists());
        assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 0);
        for wrong in [folder.path().to_owned(), folder.path().join("missing/table.csv")] {
            assert!(check(&wrong).is_err() && write(&wrong, |_| Ok(())).is_err(), "{}", wrong.display());
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_permissions_stay() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("a folder can be made");
        let (path, link) = (folder.path().join("table.csv"), folder.path().join("link.csv"));
        write(&path, |out| out.write_all(b"old")).expect("it can be written");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("it is there");
        symlink(&path, &link).expect("links can be made");
        write(&link, |out| out.write_all(b"new")).expect("it can be written");
        assert!(fs::symlink_metadata(&link).expect("it is there").is_symlink());
        assert_eq!(fs::read(&path).expect("it is there"), b"new");
        assert_eq!(fs::metadata(&path).expect("it is there").permissions().mode() & 0o777, 0o640);
        assert!(write(Path::new("/dev/null"), |out| out.write_all(b"nothing")).is_ok());
        assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
    }
}
