//! The forms of output files, and the marks and seals by which a command recognises files that it wrote.
//!
//! Every file contains a seal, a hash of its content, so that a command never replaces a file that was changed by hand. The seal is in the first
//! comment of a table, in each row of the table of an ensemble, in a separate member of an archive and of a functional mock-up unit, and in the last
//! line of all other files. A file without its seal counts as changed. The exception is references of earlier versions of the program, which have
//! no seal; they do not name the version, and are replaced. A file also contains the mark of its command: a picture in its first comment, a page in
//! the name of its generator, a reference in the line on its maker. A table is recognised by its first line after the comments `# ...` (its origin;
//! read it with `pandas.read_csv(..., comment="#")`), which contains the names of its columns with their units.

use super::seal::last_line::Around;
use super::seal::{each_row, first_line, last_line};
use std::fs::{self, File};
use std::io::{self, BufReader, Read};
use std::path::Path;

/// The form of an output file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// An SVG picture.
    Picture,
    /// An HTML page.
    Page,
    /// A reference solution.
    Reference,
    /// A CSV table; the text is the line with the names of its columns.
    Table(String),
    /// The CSV table of an ensemble, with a hash in each row; the text is the line with the names of its columns.
    Rows(String),
    /// An archive of NumPy arrays (.npz).
    Archive,
    /// The certificates of a paper, as JSON.
    Certificates,
    /// A functional mock-up unit (.fmu).
    Unit,
    /// A program in this language.
    Program(Source),
}

/// A programming language, by the extension of its files and the sign of its comments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    ends: &'static [&'static str],
    /// The sign before a comment.
    pub comment: &'static str,
    seal: Around,
}

/// The origin of an existing file at the destination of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// This command wrote the file. An empty file counts as such, since its replacement loses nothing.
    Own,
    /// This command wrote the file, and the file was changed afterwards.
    Changed,
    /// The file has the mark of this command, but lacks its seal.
    Unsealed,
    Other,
}

impl Source {
    pub const C: Source = Source { ends: &["c"], comment: "//", seal: Around::SLASHES };
    pub const MODELICA: Source = Source { ends: &["mo"], comment: "//", seal: Around::SLASHES };
    pub const PYTHON: Source = Source { ends: &["py"], comment: "#", seal: Around::SHARP };
    pub const RUST: Source = Source { ends: &["rs"], comment: "//", seal: Around::SLASHES };
}

/// The name of the command that writes a file; empty for the report.
#[derive(Clone, Copy, Debug)]
pub struct Maker(pub &'static str);

/// The number of bytes at the beginning of a file that contain its mark.
const HEAD: u64 = 4096;

impl Maker {
    /// The command as a user types it.
    pub fn name(self) -> String {
        format!("dalembert {}", self.0).trim_end().to_owned()
    }

    /// The name of the command with the version of the program, for pages and pictures.
    pub fn generator(self) -> String {
        format!("{}, version {}", self.name(), env!("CARGO_PKG_VERSION"))
    }
}

impl Form {
    /// The extensions of files of this form.
    pub fn ends(&self) -> &'static [&'static str] {
        match self {
            Form::Picture => &["svg"],
            Form::Page => &["html", "htm"],
            Form::Reference => &["reference"],
            Form::Table(_) | Form::Rows(_) => &["csv"],
            Form::Archive => &["npz"],
            Form::Certificates => &["json"],
            Form::Unit => &["fmu"],
            Form::Program(source) => source.ends,
        }
    }

    /// The form, among `forms`, that the extension of a path determines; `None` for other extensions.
    pub fn named(path: &Path, forms: &[Form]) -> Option<Form> {
        let end = path.extension()?.to_str()?;
        forms.iter().find(|form| form.ends().iter().any(|known| known.eq_ignore_ascii_case(end))).cloned()
    }

    /// The name of the form in messages.
    pub fn said(&self) -> &'static str {
        match self {
            Form::Picture => "picture",
            Form::Page => "page",
            Form::Reference => "reference",
            Form::Table(_) | Form::Rows(_) => "table",
            Form::Archive => "archive",
            Form::Certificates => "file of certificates",
            Form::Unit => "unit",
            Form::Program(_) => "program",
        }
    }

    /// The mark of the command that is written before the content.
    pub fn mark(&self, maker: Maker) -> String {
        match self {
            Form::Picture => format!("<!-- {} -->\n", maker.generator()),
            _ => String::new(),
        }
    }

    /// The text around the seal, for forms with the seal in their last line.
    pub fn last_line(&self) -> Option<Around> {
        match self {
            Form::Program(source) => Some(source.seal),
            Form::Picture | Form::Page => Some(Around::MARKUP),
            Form::Reference => Some(Around::SHARP),
            Form::Certificates => Some(Around::JSON),
            Form::Table(_) | Form::Rows(_) | Form::Archive | Form::Unit => None,
        }
    }

    /// Whether a file with this beginning was written with a seal. All files are, except references that do not name the version of the program.
    fn was_sealed(&self, head: &str) -> bool {
        let has_version =
            |head: &str| head.lines().any(|line| line.starts_with("# Made by: ") && line.contains(", version "));
        !head.is_empty() && (*self != Form::Reference || has_version(head))
    }

    /// The origin of an existing file, by its mark and its seal.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn origin(&self, maker: Maker, file: &Path) -> io::Result<Origin> {
        let head = self.head(file)?;
        if !self.is_marked(maker, &head) {
            return Ok(Origin::Other);
        }
        Ok(match self.seal_holds(file)? {
            Some(false) => Origin::Changed,
            None if self.was_sealed(&head) => Origin::Unsealed,
            Some(true) | None => Origin::Own,
        })
    }

    /// Whether the seal of a file is the hash of its content; `None` where it has no seal.
    fn seal_holds(&self, file: &Path) -> io::Result<Option<bool>> {
        Ok(match (self, self.last_line()) {
            (_, Some(around)) => last_line::holds(&fs::read(file)?, around),
            (Form::Unit, None) => exchange::fmu::seal_holds(&fs::read(file)?),
            (Form::Archive, None) => exchange::npz::seal_holds(&fs::read(file)?),
            (Form::Rows(_), None) => Some(each_row::holds(BufReader::new(File::open(file)?))?),
            (_, None) => first_line::holds(BufReader::new(File::open(file)?))?,
        })
    }

    /// The beginning of a file, which contains its mark.
    fn head(&self, file: &Path) -> io::Result<String> {
        let mut head = Vec::new();
        let room = match self {
            Form::Table(heading) | Form::Rows(heading) => HEAD + heading.len() as u64 + 1,
            _ => HEAD,
        };
        File::open(file)?.take(room).read_to_end(&mut head)?;
        Ok(String::from_utf8_lossy(&head).into_owned())
    }

    /// Whether the beginning of a file is empty or contains the mark of this command in this form.
    fn is_marked(&self, maker: Maker, text: &str) -> bool {
        let name = maker.name();
        text.is_empty()
            || match self {
                Form::Picture => text.starts_with(&format!("<!-- {name}, version ")),
                Form::Page => text.contains(&format!("<meta name=\"generator\" content=\"{name}, version ")),
                Form::Reference => {
                    text.starts_with("# Reference of ") && text.contains(&format!("\n# Made by: {name} "))
                }
                Form::Unit => text.contains(&format!("generationTool=\"{name}, version ")),
                Form::Program(source) => text.starts_with(&format!("{} made by: {name}, version ", source.comment)),
                Form::Certificates => text.starts_with(&format!("{{\"made_by\":\"{name}, version ")),
                // a NumPy array of texts stores four bytes for each character
                Form::Archive => text.replace('\0', "").contains(&format!("made by: {name}, version ")),
                Form::Table(heading) => {
                    let comments: usize =
                        text.split_inclusive('\n').take_while(|line| line.starts_with("# ")).map(str::len).sum();
                    let table = text[comments..].strip_prefix(heading.as_str());
                    table.is_some_and(|rest| rest.starts_with('\n'))
                }
                Form::Rows(heading) => text.strip_prefix(heading.as_str()).is_some_and(|rest| rest.starts_with('\n')),
            }
    }
}
