//! Changes of a printed formula that make a refuted claim true.

use claims::Judged;
use claims::certificate::Certificate;
use std::ops::Range;

/// The largest number of edits that are described individually.
const FEW: usize = 3;

/// The kind of an edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EditKind {
    Sign,
    /// A strict relation replaced by one that includes equality.
    Strictness,
    Direction,
    Function,
    Exponent,
    Letter,
    Dot,
    Number,
    MissingFactor,
    ExtraFactor,
    LostTerm,
    ExtraTerm,
    Part,
    Hypothesis,
    Digits,
}

impl EditKind {
    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Strictness => "strictness",
            Self::Direction => "direction",
            Self::Function => "function",
            Self::Exponent => "exponent",
            Self::Letter => "letter",
            Self::Dot => "dot",
            Self::Number => "number",
            Self::MissingFactor => "missing factor",
            Self::ExtraFactor => "superfluous factor",
            Self::LostTerm => "lost term",
            Self::ExtraTerm => "superfluous term",
            Self::Part => "part",
            Self::Hypothesis => "missing hypothesis",
            Self::Digits => "digits",
        }
    }
}

/// The state of the search for corrections of a claim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Search {
    /// No search, since the claim is not refuted or no correction was requested.
    #[default]
    None,
    /// The search was complete.
    Whole,
    /// The search was stopped at the time limit.
    Cut,
}

impl Search {
    /// A sentence on a search without a result; `None` without a search.
    pub fn told(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Whole => Some("none of the edits that were tried makes the claim true"),
            Self::Cut => Some("the time was over before an edit was found that makes the claim true"),
        }
    }
}

/// A correction of a refuted claim: edits of the printed formula, or an added hypothesis, with which the claim is proved.
#[derive(Clone, Debug)]
pub struct Correction {
    pub changes: Vec<Change>,
    /// The corrected formula in LaTeX.
    pub formula: String,
    /// The ranges of the changes in the corrected formula, in bytes.
    pub parts: Vec<Range<usize>>,
    /// The corrected claim with its verdict.
    pub judged: Judged,
    /// The certificate of the corrected claim, if requested.
    pub certificate: Option<Certificate>,
}

/// One edit of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    pub kind: EditKind,
    /// The changed part in words: `the sign of the second term of the left side`.
    pub words: String,
    /// The changed part of the printed formula in LaTeX; empty for an addition.
    pub before: String,
    /// The replacement in LaTeX; empty for a removal.
    pub after: String,
}

impl Change {
    /// The change in words: a part that is replaced, inserted or removed, with its place.
    fn says(&self) -> String {
        let Change { words, before, after, .. } = self;
        if before.is_empty() {
            return match words.strip_suffix(&format!(" `{after}`")) {
                Some(what) => format!("insert {what} `{after}`"),
                None => format!("insert `{after}`: {words}"),
            };
        }
        if after.is_empty() {
            return format!("remove `{before}`: {words}");
        }
        match words.split_once(&format!("`{after}` for `{before}`")) {
            Some((what, place)) => format!("replace {what}`{before}` by `{after}`{place}"),
            None => format!("replace `{before}` by `{after}`: {words}"),
        }
    }
}

impl Correction {
    /// The changes in words: ``replace `m g` by `-m g`: the sign of the second term``.
    pub fn says(&self) -> String {
        let each = self.changes.iter().map(Change::says).collect::<Vec<_>>();
        let count = if each.len() > FEW { format!("{} places differ: ", each.len()) } else { String::new() };
        count + &each.join("; ")
    }

    /// The changes in words, with formulas between dollar signs.
    pub(crate) fn typeset(&self) -> String {
        let says = self.says();
        let mut parts = says.split('`');
        let mut text = parts.next().unwrap_or_default().to_owned();
        for (place, part) in parts.enumerate() {
            match (place % 2, part.starts_with('^')) {
                (0, true) => text += &format!("${{}}{part}$"),
                (0, false) => text += &format!("${part}$"),
                _ => text += part,
            }
        }
        text
    }

    /// The corrected formula in LaTeX with the changes underlined.
    pub(crate) fn marked(&self) -> String {
        let mut text = self.formula.clone();
        for part in whole_parts(&self.formula, &self.parts).into_iter().rev() {
            let changed = &self.formula[part.clone()];
            let held = changed.trim();
            let script = held.strip_prefix(['^', '_']).map(|script| (&held[..1], script));
            let marked = match script {
                _ if held.is_empty() => continue,
                Some((sign, script)) => format!(r"{sign}{{\underline{{{script}}}}}"),
                None => format!(r" {{\underline{{{held}}}}} "),
            };
            text.replace_range(part, &marked);
        }
        text
    }
}

/// The changed parts, extended and joined such that each is a complete piece of LaTeX, in which all braces and brackets are closed.
fn whole_parts(formula: &str, parts: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut ordered = parts.to_vec();
    ordered.sort_by_key(|part| (part.start, part.end));
    let mut whole: Vec<Range<usize>> = Vec::new();
    for part in ordered {
        // the part for the second argument of a fraction begins with the brace that closes the first argument
        let joined =
            whole.pop_if(|last| part.start < last.end).map_or(part.clone(), |last| last.start..part.end.max(last.end));
        let is_end = |end: &usize| formula.get(joined.start..*end).is_some_and(is_closed);
        whole.extend((joined.end..=formula.len()).find(is_end).map(|end| joined.start..end));
    }
    whole
}

/// Whether all braces and sized brackets (`\left`) that a piece of LaTeX opens are closed in it.
fn is_closed(piece: &str) -> bool {
    let ends: Option<usize> = piece.char_indices().try_fold(0_usize, |depth, (at, letter)| match letter {
        _ if piece[..at].ends_with('\\') => Some(depth),
        '{' => Some(depth + 1),
        '}' => depth.checked_sub(1),
        _ => Some(depth),
    });
    // the bracket must follow its command `\left` or `\right` within the piece
    let is_cut = [r"\left", r"\right", r"\"].iter().any(|end| piece.ends_with(end));
    ends == Some(0) && !is_cut && piece.matches(r"\left").count() == piece.matches(r"\right").count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marked(formula: &str, parts: &[[usize; 2]]) -> String {
        let (formula, parts) = (formula.to_owned(), parts.iter().map(|&[start, end]| start..end).collect());
        let judged = Judged::default();
        Correction { changes: Vec::new(), formula, parts, judged, certificate: None }.marked()
    }

    #[test]
    fn a_fraction_that_was_put_around_a_term_is_underlined_as_a_whole() {
        assert_eq!(marked(r"x = \frac{a b}{c} + d", &[[4, 10], [13, 17]]), r"x =  {\underline{\frac{a b}{c}}}  + d");
        assert_eq!(marked(r"x = a^2", &[[5, 7]]), r"x = a^{\underline{2}}");
        assert_eq!(marked(r"\left(a + b\right)", &[[0, 7]]), r" {\underline{\left(a + b\right)}} ");
    }

    #[test]
    fn a_part_that_nothing_closes_is_not_underlined() {
        assert_eq!(marked(r"\frac{a}{b}", &[[7, 8]]), r"\frac{a}{b}");
    }
}
