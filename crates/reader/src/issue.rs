//! Errors in a scene file, shown with the lines of the file.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::fmt;
use std::ops::Range;

/// One error in a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Issue {
    /// The range of bytes in the file; `None` if the error concerns the whole file.
    pub span: Option<Range<usize>>,
    /// The error, in one line.
    pub title: String,
    /// The text beside the marks that underline the value.
    pub label: String,
    /// A sentence that states the accepted input.
    pub help: Option<String>,
}

/// All errors in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    /// The file as the user named it.
    pub path: String,
    /// The text of the file; empty where it could not be read.
    pub text: String,
    pub issues: Vec<Issue>,
}

/// The largest number of errors that are shown; later ones are only counted.
const MOST_SHOWN: usize = 30;

impl Issue {
    /// Creates an error at a range of bytes.
    pub fn at(span: Range<usize>, title: impl Into<String>, label: impl Into<String>) -> Self {
        Issue { span: Some(span), title: title.into(), label: label.into(), help: None }
    }

    /// Adds a sentence that states the accepted input.
    pub fn accepted(self, help: impl Into<String>) -> Self {
        Issue { help: Some(help.into()), ..self }
    }
}

impl SceneError {
    /// Creates an error that concerns the whole file.
    pub fn whole(path: &str, title: impl Into<String>, help: impl Into<String>) -> Self {
        let issue = Issue { span: None, title: title.into(), label: String::new(), help: Some(help.into()) };
        SceneError { path: path.to_owned(), text: String::new(), issues: vec![issue] }
    }

    /// Formats the first 30 errors, each with its line of the file and marks under the value, and the number of further errors.
    /// `colour` adds the escape sequences of a terminal.
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let first = self.issues.iter().take(MOST_SHOWN);
        let mut shown: Vec<String> = first.map(|issue| renderer.render(&[self.group(issue)])).collect();
        if let Some(more) = self.issues.len().checked_sub(MOST_SHOWN).filter(|more| *more > 0) {
            shown.push(format!("and {more} more errors in {}", self.path));
        }
        shown.join("\n\n")
    }

    fn group<'a>(&'a self, issue: &'a Issue) -> Group<'a> {
        let title = match issue.span {
            Some(_) => issue.title.clone(),
            None => format!("{}: {}", self.path, issue.title),
        };
        let mut group = Group::with_title(Level::ERROR.primary_title(title));
        if let Some(span) = &issue.span {
            let annotation = AnnotationKind::Primary.span(self.visible(span)).label(issue.label.as_str());
            group = group.element(Snippet::source(self.text.as_str()).path(self.path.as_str()).annotation(annotation));
        }
        match &issue.help {
            Some(help) => group.element(Level::HELP.message(help.as_str())),
            None => group,
        }
    }

    /// Returns the part of a span on its first line, within the text.
    fn visible(&self, span: &Range<usize>) -> Range<usize> {
        let start = self.boundary(span.start);
        let end = self.boundary(span.end).max(start);
        let line = self.text[start..end].find('\n').unwrap_or(end - start);
        start..start + line
    }

    fn boundary(&self, place: usize) -> usize {
        let mut place = place.min(self.text.len());
        while !self.text.is_char_boundary(place) {
            place -= 1;
        }
        place
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.render(false))
    }
}

impl std::error::Error for SceneError {}
