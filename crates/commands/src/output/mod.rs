//! Output files: the rules by which all commands write and replace them.
//!
//! * The extension of a name determines the form; a command refuses extensions of forms that it does not write.
//! * Missing folders are created when the file is written.
//! * An existing file is replaced only if this command wrote it and nobody has changed it since, which its mark and seal show (see [`Form`]),
//!   or with `--force`. A file that the command reads is never replaced, whatever the path to it.
//! * These rules are checked before the work, and again when the file is written. If another program has created the file meanwhile, that file
//!   remains, and the results are kept next to it under another name.
//! * Output to a pipe or a device is written directly, whatever its name; a pipe without a reader is refused.

mod form;
mod place;
mod provenance;
mod seal;

pub use form::{Form, Maker, Source};

use form::Origin;
pub use provenance::Provenance;
pub use seal::each_row;

use crate::atomic_write::{self, Beside, Untaken};
use crate::clock;
use crate::exit::{Exit, is_quiet, print};
use clap::ValueEnum;
use place::Target;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The format in which results are printed.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Format {
    /// Text for readers
    #[default]
    Text,
    /// JSON for programs
    Json,
}

/// The files that a command may write and replace.
pub struct Writes<'a> {
    /// The name of the command, which is part of the mark of its files.
    pub command: &'static str,
    /// Whether a file that this command did not write may be replaced.
    pub force: bool,
    /// The files that the command reads.
    pub reads: Vec<&'a Path>,
}

/// The checked destination of an output: the path of a file to be written, or an open device.
pub struct Output {
    path: PathBuf,
    form: Form,
    place: Target,
    rights: Rights,
}

/// An owned copy of [`Writes`], used when the file is written.
struct Rights {
    maker: Maker,
    force: bool,
    reads: Vec<PathBuf>,
}

impl Writes<'_> {
    /// The destination at a path, in the form among `forms` that its extension determines. It is checked before the work, so that an unacceptable
    /// name does not waste the work; nothing is created yet.
    ///
    /// # Errors
    /// The extension is that of none of the `forms`, the file is one that the command reads or did not write, or the file system refuses it.
    pub fn output(&self, path: &Path, forms: &[Form]) -> Result<Output, Exit> {
        let place = Target::of(path).map_err(|error| Exit::unwritable(path, &error))?;
        let form = match (Form::named(path, forms), &place) {
            (Some(form), _) => form,
            (None, Target::Device(_)) if !forms.is_empty() => forms[0].clone(),
            (None, _) => {
                let ends: Vec<&str> = forms.iter().flat_map(Form::ends).copied().collect();
                let ends = ends.join(" or .");
                return Err(Exit::refused(format!(
                    "{} cannot be written: `{}` writes .{ends} files only",
                    path.display(),
                    self.maker().name()
                )));
            }
        };
        let reads = self.reads.iter().map(|path| path.to_path_buf()).collect();
        let rights = Rights { maker: self.maker(), force: self.force, reads };
        if let Target::File(file) = &place {
            rights.admit(path, file, &form)?;
            atomic_write::probe(file).map_err(|error| Exit::unwritable(path, &error))?;
        }
        Ok(Output { path: path.to_owned(), form, place, rights })
    }

    /// The destination at a path; `None` without a path.
    ///
    /// # Errors
    /// Those of [`Writes::output`].
    pub fn optional(&self, path: Option<&Path>, forms: &[Form]) -> Result<Option<Output>, Exit> {
        path.map(|path| self.output(path, forms)).transpose()
    }

    /// The path of a table that is read before it is continued: an existing file or a free name. Its rows show whether the command wrote it.
    ///
    /// # Errors
    /// Those of [`Writes::output`], or the path leads to a pipe or a device.
    pub fn continued(&self, path: &Path) -> Result<PathBuf, Exit> {
        let output = Writes { force: true, reads: self.reads.clone(), ..*self };
        match output.output(path, &[Form::Table(String::new())])?.place {
            Target::File(file) => Ok(file),
            Target::Device(_) => Err(Exit::refused(format!(
                "{} cannot be written: this is a pipe or a device, and a table that is continued is read first; a file is accepted",
                path.display()
            ))),
        }
    }

    /// The name of the command for marks.
    pub fn maker(&self) -> Maker {
        Maker(self.command)
    }
}

impl Rights {
    /// Checks that a file may be written at a path. True where it replaces an existing file, false where none exists.
    fn admit(&self, path: &Path, file: &Path, form: &Form) -> Result<bool, Exit> {
        if std::fs::symlink_metadata(file).is_err() {
            return Ok(false);
        }
        let read =
            self.reads.iter().find(|read| read.is_file() && same_file::is_same_file(read, file).unwrap_or(false));
        if let Some(read) = read {
            return Err(Exit::refused(format!(
                "{} cannot be written: the command reads this file, {}; another name is accepted",
                path.display(),
                read.display()
            )));
        }
        if self.force {
            return Ok(true);
        }
        let origin = form.origin(self.maker, file);
        let origin = origin.map_err(|error| Exit::refused(format!("{}: {error}", path.display())))?;
        let (form, maker) = (form.said(), self.maker.name());
        let is = match origin {
            Origin::Own => return Ok(true),
            Origin::Changed => format!("is no unchanged {form} of `{maker}`: it was edited since it was written"),
            Origin::Unsealed => {
                format!("is no unchanged {form} of `{maker}`: it was edited, or written by an earlier version")
            }
            Origin::Other => format!("is no {form} of `{maker}`"),
        };
        let accepted = "a name that is free is accepted, and --force, which replaces the file";
        Err(Exit::refused(format!("{} exists and {is}; {accepted}", path.display())))
    }
}

impl Output {
    /// The path as the user gave it.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The form of the content.
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// Writes the content atomically, with the mark of the command and the seal of the form.
    ///
    /// # Errors
    /// Writing fails, or another program has created or changed the file since the first check; the results are then in another file.
    pub fn write(self, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<Written, Exit> {
        let _held = clock::held();
        let Output { path, form, place, rights } = self;
        let unwritable = |error: io::Error| Exit::unwritable(&path, &error);
        let mark = form.mark(rights.maker);
        let marked = |out: &mut dyn Write| {
            out.write_all(mark.as_bytes())?;
            content(out)
        };
        let ended = |out: &mut dyn Write| match form.last_line() {
            Some(around) => seal::last_line::sealed(out, around, marked),
            None => marked(out),
        };
        match place {
            Target::Device(device) => to_device(device, ended).map_err(unwritable)?,
            Target::File(file) => {
                std::fs::create_dir_all(atomic_write::folder(&file)).map_err(unwritable)?;
                let written = Beside::write(&file, |out| match form {
                    Form::Table(_) => seal::first_line::sealed(out, ended),
                    _ => ended(out),
                });
                let written = written.map_err(unwritable)?;
                match rights.admit(&path, &file, &form) {
                    Ok(true) => written.replace().map_err(unwritable)?,
                    Ok(false) => match written.take() {
                        Ok(()) => {}
                        Err(Untaken::Failed(error)) => return Err(unwritable(error)),
                        Err(Untaken::Occupied(written)) => return Err(came_meanwhile(&path, written)),
                    },
                    Err(_) => return Err(came_meanwhile(&path, written)),
                }
            }
        }
        Ok(Written(path))
    }

    /// Writes a text.
    ///
    /// # Errors
    /// Those of [`Output::write`].
    pub fn write_text(self, text: &str) -> Result<Written, Exit> {
        self.write(|out| out.write_all(text.as_bytes()))
    }
}

/// A file that was written.
#[must_use]
pub struct Written(PathBuf);

impl Written {
    /// Prints the name of the file, unless the output is JSON.
    ///
    /// # Errors
    /// Standard output cannot be written.
    pub fn tell(self, format: Format) -> Result<(), Exit> {
        match format {
            Format::Text if !is_quiet() => print(&format!("{}\n", self.0.display())),
            _ => Ok(()),
        }
    }
}

/// Writes to a device or a pipe. A pipe that its reader has closed is not an error.
fn to_device(device: File, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(device);
    match content(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        ended => ended,
    }
}

/// The error for a destination at which a file has appeared since the first check; the results are kept under another name.
fn came_meanwhile(path: &Path, written: Beside) -> Exit {
    let kept = match written.keep() {
        Ok(kept) => format!("the results are kept in {}", kept.display()),
        Err(error) => format!("the results could not be kept: {error}"),
    };
    Exit::refused(format!("{} was created meanwhile by another program, and is not replaced; {kept}", path.display()))
}

/// Refuses two outputs of one command that lead to the same file.
pub fn apart(one: Option<&Output>, other: Option<&Output>) -> Result<(), Exit> {
    let (Some(one), Some(other)) = (one, other) else { return Ok(()) };
    match one.path == other.path || one.place.is(&other.place) {
        false => Ok(()),
        true => Err(Exit::refused(format!(
            "{} and {} are one file, and each would be lost in the other; two names are accepted",
            one.path.display(),
            other.path.display()
        ))),
    }
}

#[cfg(test)]
mod tests;
