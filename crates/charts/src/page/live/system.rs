//! The parts of the live page about a system: equations, vectors and verdicts.

use super::super::cards::chip;
use crate::{Verdict, text::Typesetter};
use maud::html;

/// HTML of groups of equations, each equation a left and a right side in LaTeX. The line `from` above them names their source.
pub fn equations(from: &str, groups: &[Vec<(String, String)>]) -> String {
    let mut set = Typesetter::default();
    let set = &mut set;
    html! {
        @if !from.is_empty() { p.note { (from) } }
        @for group in groups {
            div.group { @for (left, right) in group { (set.formula(&format!("{left} = {right}"))) } }
        }
    }
    .into_string()
}

/// A derived vector with its name, or a line of text about one.
#[derive(Clone, Debug, Default)]
pub struct LiveVector {
    pub name: String,
    /// The vector in LaTeX; `None` for a line of text.
    pub latex: Option<String>,
}

/// HTML of the vectors, each next to its name, and of the lines of text.
pub fn vectors(all: &[LiveVector]) -> String {
    let mut set = Typesetter::default();
    let set = &mut set;
    html! { dl.vectors { @for LiveVector { name, latex } in all {
        @match latex {
            Some(latex) => { dt { code { (name) } } dd { (set.formula(latex)) } }
            None => { dd.whole { (name) } }
        }
    } } }
    .into_string()
}

/// A statement about the equations of a system.
#[derive(Clone, Debug, Default)]
pub struct LiveVerdict {
    pub title: String,
    /// The name of the verdict, or another word where the statement has no verdict.
    pub degree: String,
    /// The verdict in a sentence.
    pub said: String,
    /// Grounds of the verdict, one per line.
    pub behind: Vec<String>,
}

/// HTML of statements with their verdicts.
pub fn verdicts(rows: &[LiveVerdict]) -> String {
    let known = |degree: &str| Verdict::ALL.into_iter().find(|verdict| verdict.name() == degree);
    html! {
        @for LiveVerdict { title, degree, said, behind } in rows {
            article.verdict {
                @match known(degree) { Some(verdict) => (chip(verdict)), None => span.chip.open { (degree) } }
                div {
                    p { b { (title) } }
                    p.note { (said) }
                    @for line in behind { p.note { (line) } }
                }
            }
        }
    }
    .into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_typeset_and_vectors_are_escaped() {
        let shown = equations("by <lagrange>", &[vec![("M".into(), r"m l^2".into())]]);
        assert!(shown.contains("by &lt;lagrange&gt;") && shown.contains("<math"), "{shown}");
        let line = LiveVector { name: "a <constraint>".into(), latex: None };
        let shown = vectors(&[LiveVector { name: "P - O".into(), latex: Some(r"l\,\mathbf{A}_y".into()) }, line]);
        assert!(shown.contains("<math") && shown.contains("<dd class=\"whole\">a &lt;constraint&gt;</dd>"), "{shown}");
    }

    #[test]
    fn a_statement_that_does_not_apply_has_no_sign_of_a_verdict() {
        let row = LiveVerdict { title: "a = b".into(), degree: "does not apply".into(), ..LiveVerdict::default() };
        let shown = verdicts(&[row, LiveVerdict { degree: "proved".into(), ..LiveVerdict::default() }]);
        assert!(shown.contains("chip open\">does not apply") && shown.contains("chip proved"), "{shown}");
    }
}
