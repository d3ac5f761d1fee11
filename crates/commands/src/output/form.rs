//! The forms of output files, and the marks by which a command recognises its own files.
//!
//! A program in another language and a picture end with a hash of their lines, a functional mock-up unit holds one of its files, so that
//! what was changed by hand is never replaced. A picture begins with a comment that names the command, a page names the command as its generator, a reference says which
//! command made it. A table begins with comments, `# ...`, on its origin (`pandas.read_csv(..., comment="#")`); it is
//! recognised by the line after them, the names of its columns with their units.

use super::seal::{Comment, is_whole};
use std::fs::File;
use std::io::{self, Read};
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
}

/// The maker of a file that stands where another is to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The command wrote it; an empty file counts as such, since nothing can be lost.
    Own,
    /// The command wrote it, and it was changed since.
    Changed,
    Other,
}

impl Source {
    pub const C: Source = Source { ends: &["c"], comment: "//" };
    pub const MODELICA: Source = Source { ends: &["mo"], comment: "//" };
    pub const PYTHON: Source = Source { ends: &["py"], comment: "#" };
    pub const RUST: Source = Source { ends: &["rs"], comment: "//" };
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
            Form::Table(_) => &["csv"],
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
            Form::Table(_) => "table",
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

    /// The signs about the seal at the end of a file of this form.
    pub fn seal(&self) -> Option<Comment> {
        match self {
            Form::Program(source) => Some(Comment { opens: source.comment, closes: "" }),
            Form::Picture => Some(Comment { opens: "<!--", closes: " -->" }),
            _ => None,
        }
    }

    /// Whether this command wrote a file, by its mark and its seal.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn origin(&self, maker: Maker, file: &Path) -> io::Result<Origin> {
        if !self.is_marked(maker, file)? {
            return Ok(Origin::Other);
        }
        let is_whole = match (self, self.seal()) {
            (Form::Unit, _) => exchange::fmu::is_whole(&std::fs::read(file)?),
            (_, Some(comment)) => is_whole(&std::fs::read(file)?, comment),
            (_, None) => true,
        };
        let is_empty = std::fs::metadata(file)?.len() == 0;
        Ok(if is_whole || is_empty { Origin::Own } else { Origin::Changed })
    }

    /// Whether a file is empty, or has the mark of this command in this form.
    fn is_marked(&self, maker: Maker, file: &Path) -> io::Result<bool> {
        let mut head = Vec::new();
        let room = match self {
            Form::Table(heading) => HEAD + heading.len() as u64 + 1,
            _ => HEAD,
        };
        File::open(file)?.take(room).read_to_end(&mut head)?;
        let text = String::from_utf8_lossy(&head);
        let name = maker.name();
        Ok(text.is_empty()
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
            })
    }
}
