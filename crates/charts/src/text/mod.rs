//! Prose and formulas as HTML. Texts are escaped; LaTeX is typeset as MathML or, where this fails, shown as source text and reported.

mod mathml;

use math_core::{LatexToMathML, MathDisplay};
use maud::{Markup, PreEscaped, html};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// LaTeX that the page shows as source, because it could not be typeset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unset {
    /// The claim, scene or heading that contains the LaTeX.
    pub place: String,
    pub latex: String,
    pub reason: String,
}

/// The width in em above which a displayed formula may break into several lines.
const BREAK_ABOVE: f64 = 20.0;
/// The width in em above which a formula in prose may break; a formula within a sentence must fit on a small screen.
const BREAK_IN_PROSE: f64 = 16.0;
/// The width of a printed line in em; wider pieces are printed in a smaller size.
const PAPER: f64 = 44.0;

/// Converts text and LaTeX into HTML and collects LaTeX that it cannot typeset.
#[derive(Debug, Default)]
pub(crate) struct Typesetter {
    converter: LatexToMathML,
    place: String,
    unset: Vec<Unset>,
}

impl Typesetter {
    /// Sets the name of the place that reports of failures give for the texts that follow.
    pub fn at(&mut self, place: &str) {
        place.clone_into(&mut self.place);
    }

    pub fn into_unset(self) -> Vec<Unset> {
        self.unset
    }

    /// HTML of prose with LaTeX between dollar signs. `\$`, or a dollar sign without a partner, is a dollar sign of the prose.
    pub fn text(&mut self, text: &str) -> Markup {
        let mut out = String::new();
        let mut rest = text;
        while let Some((prose, tail)) = split_at_dollar(rest) {
            let Some((latex, after)) = split_at_dollar(tail) else { break };
            out += &html!((unescape(prose))).0;
            out += &self.inline(latex).0;
            rest = after;
        }
        out += &html!((unescape(rest))).0;
        PreEscaped(out)
    }

    /// HTML of a formula within prose. A long formula is cut into pieces; a piece that is still too wide has its own scroll bar.
    fn inline(&mut self, latex: &str) -> Markup {
        let mathml = match self.convert(latex, MathDisplay::Inline) {
            Ok(mathml) => mathml,
            Err(reason) => return self.source(latex, reason),
        };
        let pieces = mathml::pieces(&mathml, BREAK_IN_PROSE);
        if pieces.iter().all(|piece| piece.width <= BREAK_IN_PROSE) && pieces.len() == 1 {
            return PreEscaped(mathml);
        }
        html! { @for (position, piece) in pieces.iter().enumerate() {
            @if position > 0 { wbr; }
            @let math = html! { math { (PreEscaped(&piece.mathml)) } };
            @if piece.width > BREAK_IN_PROSE { span.wide { (math) } } @else { (math) }
        } }
    }

    /// The estimated width of a text on one line, in em.
    pub fn width(&self, text: &str) -> f64 {
        let (mut width, mut rest, mut formula) = (0.0, text, false);
        while let Some((part, tail)) = split_at_dollar(rest) {
            width += if formula { self.formula_width(part) } else { prose_width(part) };
            (rest, formula) = (tail, !formula);
        }
        width + prose_width(rest)
    }

    fn formula_width(&self, latex: &str) -> f64 {
        let converted = self.convert(latex, MathDisplay::Inline);
        converted.map_or(prose_width(latex), |math| mathml::pieces(&math, f64::INFINITY).iter().map(|p| p.width).sum())
    }

    /// HTML of a displayed formula. A long formula is cut into pieces, between which a line may break.
    pub fn formula(&mut self, latex: &str) -> Markup {
        let mathml = match self.convert(latex, MathDisplay::Block) {
            Ok(mathml) => mathml,
            Err(reason) => return html! { div.formula { (self.source(latex, reason)) } },
        };
        let pieces = mathml::pieces(&mathml, BREAK_ABOVE);
        let widest = pieces.iter().map(|piece| piece.width).fold(0.0, f64::max);
        let wide = widest > PAPER;
        let shrink = wide.then(|| format!("--fit: {:.2}", (PAPER / widest).max(0.3)));
        html! {
            div.formula tabindex=[wide.then_some("0")] role=[wide.then_some("group")]
                aria-label=[wide.then_some("wide formula, scrolls sideways")] style=[shrink] {
                @for (position, piece) in pieces.iter().enumerate() {
                    @if position > 0 { wbr; }
                    math { (PreEscaped(&piece.mathml)) }
                }
            }
        }
    }

    /// Converts LaTeX to MathML. On some invalid LaTeX the converter panics (a debug assertion); the panic is returned as an error.
    fn convert(&self, latex: &str, display: MathDisplay) -> Result<String, String> {
        let converted = catch_unwind(AssertUnwindSafe(|| self.converter.convert_with_local_state(latex, display)));
        match converted {
            Ok(Ok(converted)) => Ok(shortened(&converted.mathml)),
            Ok(Err(error)) => Err(error.to_string()),
            Err(_) => Err("the converter gave up".to_owned()),
        }
    }

    fn source(&mut self, latex: &str, reason: String) -> Markup {
        let shown = html! { code.unset title=(reason) { (latex) } };
        self.unset.push(Unset { place: self.place.clone(), latex: latex.to_owned(), reason });
        shown
    }
}

/// MathML with shorter numbers in its spaces, since a page contains thousands of spaces.
fn shortened(mathml: &str) -> String {
    let shorter = [("0.16666667em", ".17em"), ("0.1667em", ".17em"), ("0.2222em", ".22em"), ("0.2777778em", ".28em")];
    let spaces = shorter.into_iter().fold(mathml.to_owned(), |all, (long, short)| all.replace(long, short));
    spaces.replace("></mspace>", "/>")
}

/// A displayed formula as MathML Core.
///
/// # Errors
/// The reason for which the LaTeX cannot be typeset, as text.
pub fn mathml(latex: &str) -> Result<String, String> {
    Typesetter::default().convert(latex, MathDisplay::Block)
}

/// The LaTeX of a text that consists of one formula and nothing else; `None` for other texts.
pub(crate) fn sole_formula(text: &str) -> Option<&str> {
    let (before, rest) = split_at_dollar(text.trim())?;
    let (latex, after) = split_at_dollar(rest)?;
    (before.is_empty() && after.is_empty()).then_some(latex)
}

fn prose_width(prose: &str) -> f64 {
    0.5 * prose.chars().count() as f64
}

/// The text without dollar signs, for places that take no markup.
pub(crate) fn plain(text: &str) -> String {
    unescape(text).replace('$', "")
}

/// The texts before and after the first dollar sign without a backslash before it; `None` without such a dollar sign.
fn split_at_dollar(text: &str) -> Option<(&str, &str)> {
    text.match_indices('$')
        .map(|(at, _)| at)
        .find(|&at| !text[..at].ends_with('\\'))
        .map(|at| (&text[..at], &text[at + 1..]))
}

fn unescape(prose: &str) -> String {
    prose.replace("\\$", "$")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prose_is_escaped_and_formulas_are_typeset() {
        let mut set = Typesetter::default();
        let shown = set.text("a <b> costs \\$3, $x < 1$").into_string();
        assert!(shown.starts_with("a &lt;b&gt; costs $3, <math>"), "{shown}");
        assert!(shown.contains("<mo>&lt;</mo>"), "{shown}");
        assert!(set.into_unset().is_empty());
    }

    #[test]
    fn a_dollar_sign_without_a_partner_is_a_dollar_sign() {
        assert_eq!(Typesetter::default().text("5 $ a day").into_string(), "5 $ a day");
    }

    #[test]
    fn a_long_formula_within_prose_may_break_and_a_short_one_stays_whole() {
        let terms = (1..20).map(|i| format!("A_{{{i}}} x_{{{i}}}")).collect::<Vec<_>>().join(" + ");
        let mut set = Typesetter::default();
        let (short, long) =
            (set.text("so $a + b = c$").into_string(), set.text(&format!("so ${terms}$")).into_string());
        assert_eq!((short.matches("<wbr>").count(), long.matches("<wbr>").count()), (0, 18));
        assert!(set.width("so $a + b = c$") < 10.0 && set.width(&format!("${terms}$")) > 40.0);
    }

    #[test]
    fn a_text_that_is_one_formula_is_known_as_such() {
        assert_eq!(sole_formula("$x = 1$"), Some("x = 1"));
        assert_eq!((sole_formula("$x$ or $y$"), sole_formula("where $x$"), sole_formula("x")), (None, None, None));
    }

    #[test]
    fn latex_that_does_not_parse_shows_its_source_and_is_reported() {
        let mut set = Typesetter::default();
        set.at("doe/eq1");
        let shown = set.formula(r"\frac{a}{<").into_string();
        assert!(shown.contains("<code") && shown.contains(r"\frac{a}{&lt;"), "{shown}");
        let unset = set.into_unset();
        assert_eq!((unset.len(), unset[0].place.as_str()), (1, "doe/eq1"));
    }

    #[test]
    fn a_long_sum_may_break_before_its_signs() {
        let terms = (1..40).map(|i| format!("A_{{{i}}} x_{{{i}}}")).collect::<Vec<_>>().join(" + ");
        let shown = Typesetter::default().formula(&format!("0 = {terms}")).into_string();
        assert_eq!(shown.matches("<wbr>").count(), 39);
        assert_eq!(shown.matches(r#"<mo form="infix">+</mo>"#).count(), 38);
    }
}
