//! The text of a paper's file: title, letters, claims, and system.

use crate::claim_text::{ClaimText, claims};
use crate::passage::Passage;
use latex::declared_name;
use reader::{Issue, SceneError, Table, read_text, tables};
use scenes::SystemText;
use std::ops::Range;
use std::path::Path;

/// A letter as the file declares it.
#[derive(Clone, Debug)]
pub(crate) struct LetterText {
    /// The letter in LaTeX, without changes.
    pub latex: String,
    /// The name of the letter in a uniform spelling.
    pub name: String,
    /// The meaning as an expression of the model; for a vector one expression for each component.
    pub meaning: Vec<Passage>,
    pub is_vector: bool,
}

/// Whether a text is that of a paper, which contains `[[claim]]`.
pub fn is_paper(text: &str) -> bool {
    text.lines().any(|line| line.trim_start().starts_with("[[claim]]"))
}

/// A paper in a file.
#[derive(Clone, Debug)]
pub struct PaperText {
    /// The name of the file in messages.
    pub path: String,
    pub text: String,
    /// The first part of the ids of its claims: the name of the file without its extension.
    pub key: String,
    pub title: String,
    pub citation: String,
    pub summary: String,
    pub(crate) letters: Vec<LetterText>,
    pub claims: Vec<ClaimText>,
    /// The text of the system, in this file or in the file that it names.
    pub(crate) system: SystemText,
}

impl PaperText {
    /// The line of the file at which a range begins, from 1.
    pub fn line_of(&self, at: &Range<usize>) -> usize {
        1 + self.text.bytes().take(at.start).filter(|byte| *byte == b'\n').count()
    }

    /// The id of a claim: the key of the paper, `/`, and the key of the claim.
    pub fn id_of(&self, claim: &ClaimText) -> String {
        format!("{}/{}", self.key, claim.key())
    }

    /// Reads a file, and the file of its system if it names one.
    ///
    /// # Errors
    /// All faults of both files, with their places. Formulas and meanings of letters are read only when they are judged.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        Self::parse(path, read_text(path).map_err(of_paper)?)
    }

    /// Reads a text as the content of a file. The path is used in messages; the file of the system is searched for in its folder.
    ///
    /// # Errors
    /// Those of [`PaperText::read`].
    pub fn parse(path: &Path, text: String) -> Result<Self, SceneError> {
        let name = path.display().to_string();
        let key = path.file_stem().map_or_else(|| "paper".to_owned(), |stem| stem.to_string_lossy().into_owned());
        let mut named = None;
        let mut paper = tables(&name, &text, |top, _| {
            let model = top.optional_text("model", "file with the system of the paper");
            match &model {
                // the reader of systems checks all other tables
                None => top.known_all(),
                Some(model) => named = Some(Passage::of(top, &text, model)),
            }
            Some(paper(top, &name, &text, &key))
        })
        .map_err(of_paper)?;
        if let Some(Passage { text: model, span, .. }) = named {
            let beside = path.parent().unwrap_or(Path::new("")).join(model);
            paper.system = SystemText::read(&beside).map_err(|error| {
                let why = error.issues.first().map_or_else(String::new, |issue| issue.title.clone());
                let title = format!("the system of this paper, {}, cannot be read: {why}", beside.display());
                let issue = Issue::at(span, title, "this file")
                    .accepted("the file of a system, by its way from this file's folder");
                SceneError { path: name, text, issues: vec![issue] }
            })?;
        }
        Ok(paper)
    }

    /// The text of the system.
    pub fn system(&self) -> &SystemText {
        &self.system
    }

    /// The path of the system's file; `None` if the system is in this file.
    pub fn model_file(&self) -> Option<&Path> {
        (self.system.name != self.path).then(|| Path::new(&self.system.name))
    }

    /// The paper with another text of its system, under the name of the present one.
    #[must_use]
    pub fn with_model(mut self, text: String) -> Self {
        self.system.text = text;
        self
    }

    /// An error with these faults of this file.
    pub(crate) fn error(&self, mut issues: Vec<Issue>) -> SceneError {
        issues.sort_by_key(|issue| issue.span.as_ref().map_or(0, |span| span.start));
        SceneError { path: self.path.clone(), text: self.text.clone(), issues }
    }

    /// Whether the system is in this file.
    pub(crate) fn has_own_system(&self) -> bool {
        self.system.name == self.path
    }
}

/// The error with a remark on accepted files, for faults of whole files.
fn of_paper(mut error: SceneError) -> SceneError {
    for issue in error.issues.iter_mut().filter(|issue| issue.span.is_none()) {
        issue.help =
            Some("a TOML file with [letters] and [[claim]] is accepted; the folder `papers` holds examples".to_owned());
    }
    error
}

fn paper(top: &mut Table<'_>, name: &str, text: &str, key: &str) -> PaperText {
    let title = top.text("title", "title of the paper").value;
    top.optional_text("description", "what the system does");
    let mut said = |key: &str, needed: &str| {
        let found = top.optional_text(key, needed).map(|text| text.value).unwrap_or_default();
        found.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let (citation, summary) =
        (said("citation", "authors, title, journal, year"), said("summary", "subject of the paper"));
    let is_scene = ["coordinates", "system"].iter().any(|key| top.has(key)) && !top.has("claim") && !top.has("letters");
    let letters = if is_scene { Vec::new() } else { letters(top, text) };
    let claims = claims(top, text);
    if is_scene {
        let issue = Issue::at(0..0, "this file states no claim: it is a scene, not a paper", "nothing to judge");
        top.report(issue.accepted("`run` and most other commands take a scene; a paper has [letters] and [[claim]]"));
    } else if !top.has("claim") {
        let issue = Issue::at(0..0, "this file states no claim", "nothing to judge");
        top.report(issue.accepted("[[claim]] with equation, kind and formula, once for each formula of the paper"));
    }
    let system = SystemText { name: name.to_owned(), text: text.to_owned(), values: Vec::new() };
    PaperText {
        path: name.to_owned(),
        text: text.to_owned(),
        key: key.to_owned(),
        title,
        citation,
        summary,
        letters,
        claims,
        system,
    }
}

/// Reads the table of letters: `'\theta' = "theta"`, `'\mathbf{r}' = ["x", "y", "0"]`.
fn letters(top: &mut Table<'_>, source: &str) -> Vec<LetterText> {
    let mut table = top.table("letters", "each letter of the formulas its meaning in the model: '\\theta' = \"theta\"");
    let mut all: Vec<LetterText> = Vec::new();
    for key in table.keys() {
        let needed = format!(
            "meaning of `{}`: a parameter, a coordinate, a rate, an energy, a reaction, or an expression of these",
            key.value
        );
        let found = table.text_or_texts(&key.value, &needed);
        let is_vector =
            table.place_of(&key.value).is_some_and(|place| found.first().is_some_and(|first| first.span != place));
        let meaning: Vec<Passage> = found.iter().map(|value| Passage::of(&table, source, value)).collect();
        let name = match declared_name(&key.value) {
            Ok(name) => name,
            Err(fault) => {
                let issue = Issue::at(key.span, format!("`{}` is no letter: {}", key.value, fault.title), fault.label);
                table.report(issue.accepted(fault.accepted));
                continue;
            }
        };
        if let Some(other) = all.iter().find(|other| other.name == name) {
            let title = format!("`{}` and `{}` are one letter", other.latex, key.value);
            table.report(Issue::at(key.span, title, "declared before").accepted("one meaning for each letter"));
            continue;
        }
        all.push(LetterText { latex: key.value, name, meaning, is_vector });
    }
    top.absorb(table);
    all
}
