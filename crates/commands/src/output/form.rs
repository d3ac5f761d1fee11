//! The forms of output files, and the marks by which a command recognises its own files.
//!
//! Every file holds a hash of itself, a seal, so that what was changed by hand is never replaced: a table in its first comment, the table of
//! an ensemble in each of its rows, an archive and a functional mock-up unit in a file of their own, the others in their last line. A file
//! without its seal was edited, and is not replaced either. Only references were written without a seal before; they do not state the
//! version of the program, and are replaced. A picture begins with a comment that names the command, a page names the command as its generator, a reference says which
//! command made it. A table begins with comments, `# ...`, on its origin (`pandas.read_csv(..., comment="#")`); it is
//! recognised by the line after them, the names of its columns with their units.

use super::seal::last_line::Around;
use super::seal::{each_row, first_line, last_line};
use std::fs::{self, File};
use std::io::{self, BufReader, Read};
use std::path::Path;

/// The form of an output file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Form {
    /// A picture, SVG.
    Picture,
    /// A page, HTML.
    Page,
    /// A solution with its digits.
    Reference,
    /// A table, CSV, with this first line after its comments.
    Table(String),
    /// The table of an ensemble, CSV, with this first line, and a hash in each row.
    Rows(String),
    /// Arrays of NumPy.
    Archive,
    /// The certificates of a paper, JSON.
    Certificates,
    /// A functional mock-up unit.
    Unit,
    /// A program in a language.
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

/// The maker of a file that stands where another is to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The command wrote it; an empty file counts as such, since nothing can be lost.
    Own,
    /// The command wrote it, and it was changed since.
    Changed,
    /// It has the mark of the command, and lacks the seal with which it was written.
    Unsealed,
    Other,
}

impl Source {
    pub const C: Source = Source { ends: &["c"], comment: "//", seal: Around::SLASHES };
    pub const MODELICA: Source = Source { ends: &["mo"], comment: "//", seal: Around::SLASHES };
    pub const PYTHON: Source = Source { ends: &["py"], comment: "#", seal: Around::SHARP };
    pub const RUST: Source = Source { ends: &["rs"], comment: "//", seal: Around::SLASHES };
}

/// The command that writes; the report's has no name.
#[derive(Clone, Copy, Debug)]
pub struct Maker(pub &'static str);

/// The number of bytes at the beginning of a file within which its mark stands.
const HEAD: u64 = 4096;

impl Maker {
    /// The command as a user types it.
    pub fn name(self) -> String {
        format!("dalembert {}", self.0).trim_end().to_owned()
    }

    /// The name of the generator in pages and pictures.
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

    /// The form for the extension of a path, among some forms.
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

    /// The mark of the maker, which precedes the content.
    pub fn mark(&self, maker: Maker) -> String {
        match self {
            Form::Picture => format!("<!-- {} -->\n", maker.generator()),
            _ => String::new(),
        }
    }

    /// The text around the seal in the last line of a file of this form.
    pub fn last_line(&self) -> Option<Around> {
        match self {
            Form::Program(source) => Some(source.seal),
            Form::Picture | Form::Page => Some(Around::MARKUP),
            Form::Reference => Some(Around::SHARP),
            Form::Certificates => Some(Around::JSON),
            Form::Table(_) | Form::Rows(_) | Form::Archive | Form::Unit => None,
        }
    }

    /// Whether a file that begins like this was written with a seal: all but references that do not state the version of the program.
    fn was_sealed(&self, head: &str) -> bool {
        let has_version =
            |head: &str| head.lines().any(|line| line.starts_with("# Made by: ") && line.contains(", version "));
        !head.is_empty() && (*self != Form::Reference || has_version(head))
    }

    /// Whether this command wrote a file, by its mark and its seal.
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

    /// Whether the seal of a file is that of its content; `None` where it has none.
    fn seal_holds(&self, file: &Path) -> io::Result<Option<bool>> {
        Ok(match (self, self.last_line()) {
            (_, Some(around)) => last_line::holds(&fs::read(file)?, around),
            (Form::Unit, None) => exchange::fmu::seal_holds(&fs::read(file)?),
            (Form::Archive, None) => exchange::npz::seal_holds(&fs::read(file)?),
            (Form::Rows(_), None) => Some(each_row::holds(BufReader::new(File::open(file)?))?),
            (_, None) => first_line::holds(BufReader::new(File::open(file)?))?,
        })
    }

    /// The beginning of a file, in which its mark stands.
    fn head(&self, file: &Path) -> io::Result<String> {
        let mut head = Vec::new();
        let room = match self {
            Form::Table(heading) | Form::Rows(heading) => HEAD + heading.len() as u64 + 1,
            _ => HEAD,
        };
        File::open(file)?.take(room).read_to_end(&mut head)?;
        Ok(String::from_utf8_lossy(&head).into_owned())
    }

    /// Whether a file that begins like this is empty, or has the mark of this command in this form.
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
                // characters of a NumPy array of texts have four bytes each
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
