//! One law of a motor given by text: an expression with a physical dimension.

use super::names::Names;
use crate::text::{INDUCED, KnownMotion};
use reader::{At, Issue, NO_MUTUAL_INDUCTANCE, Table};
use symbolic::{NotExpression, Reason, Sym, parse_in};
use units::{Dimension, nearest};

/// The largest number of symbols of a law.
const LETTERS: usize = 2000;

/// The kind of a law, for messages.
#[derive(Clone, Copy)]
pub struct Kind {
    pub key: &'static str,
    pub meaning: &'static str,
    pub unit: &'static str,
    /// The variables of the motion that it may contain.
    pub motion: KnownMotion,
}

impl Kind {
    fn cannot_be_read(self) -> String {
        format!("`{}`, the {}, cannot be read", self.key, self.meaning)
    }
}

/// Reads the laws of a motor; a fault common to several laws is reported once.
pub struct Reader<'a> {
    pub names: &'a Names,
    /// The issue and the parameters of each law with inconsistent dimensions.
    mismatched: Vec<(Issue, Vec<String>)>,
}

impl<'a> Reader<'a> {
    /// A reader of laws in these names.
    pub fn new(names: &'a Names) -> Self {
        Reader { names, mismatched: Vec::new() }
    }

    /// Reads an expression with the dimension of a unit; `None` where it is faulty, which is reported.
    pub fn law(&mut self, table: &mut Table<'_>, kind: Kind) -> Option<At<Sym>> {
        let letters = self.names.letters(kind.motion);
        let text = table.text(kind.key, &format!("{}, an expression in {}", kind.meaning, letters.known()));
        if text.value.is_empty() {
            return None;
        }
        if text.value.len() > LETTERS {
            let issue = Issue::at(text.span.clone(), kind.cannot_be_read(), format!("{} letters", text.value.len()));
            table.report(issue.accepted(format!("at most {LETTERS} letters are accepted")));
            return None;
        }
        let needed = Dimension::of(kind.unit).of_expressions();
        let expression = match parse_in(&text.value, &letters) {
            Ok(expression) => expression,
            Err(wrong) => {
                self.tell(table, kind, &text, wrong);
                return None;
            }
        };
        let (label, accepted) = match letters.dimension(expression) {
            Ok(found) if found.is_none_or(|found| found == needed) => {
                return Some(At { value: expression, span: text.span });
            }
            Ok(found) => {
                let found = found.map_or_else(String::new, |found| found.to_string());
                (format!("this is {found}, but must be {needed}"), format!("an expression in {}", kind.unit))
            }
            Err(reason) => (reason.to_string(), letters.known()),
        };
        self.mismatch(Issue::at(text.span, kind.cannot_be_read(), label).accepted(accepted), expression.symbols_of());
        None
    }

    /// As [`Reader::law`], for an optional law.
    pub fn optional(&mut self, table: &mut Table<'_>, kind: Kind) -> Option<At<Sym>> {
        if table.has(kind.key) {
            return self.law(table, kind);
        }
        table.known(&[kind.key]);
        None
    }

    fn tell(&mut self, table: &mut Table<'_>, kind: Kind, text: &At<String>, wrong: NotExpression) {
        let NotExpression { span, reason } = wrong;
        let letters = self.names.letters(kind.motion);
        let meant = match &reason {
            Reason::Name(name) if !self.names.is_news(name) => return,
            Reason::Name(name) => {
                let names = letters.parameters.iter().map(|(name, _)| name.as_str());
                nearest(name, names).map(|nearest| format!("is `{nearest}` meant? "))
            }
            _ => None,
        };
        let known = match &reason {
            Reason::Refused(why) if why.ends_with(INDUCED) && ["flux", "motional"].contains(&kind.key) => {
                NO_MUTUAL_INDUCTANCE.to_owned()
            }
            _ => format!("{}known here: {}", meant.unwrap_or_default(), letters.known()),
        };
        let place = table.part(text, &span);
        table.report(Issue::at(place, kind.cannot_be_read(), reason.to_string()).accepted(known));
    }

    fn mismatch(&mut self, issue: Issue, symbols: Vec<Sym>) {
        let names = symbols.into_iter().filter_map(Sym::symbol_name).filter(|name| self.names.is_parameter(name));
        let names = names.map(|name| name.to_string()).collect();
        self.mismatched.push((issue, names));
    }

    /// The issues of inconsistent dimensions: laws that differ from their dimension by the same factor and have a
    /// common parameter are reported once.
    pub fn mismatches(self) -> Vec<Issue> {
        let mut told: Vec<(Issue, Vec<String>, usize)> = Vec::new();
        for (issue, names) in self.mismatched {
            let same = told.iter_mut().find(|(first, common, _)| {
                first.label == issue.label && common.iter().any(|name| names.contains(name))
            });
            match same {
                Some((_, common, more)) => {
                    common.retain(|name| names.contains(name));
                    *more += 1;
                }
                None => told.push((issue, names, 0)),
            }
        }
        let one = |(mut issue, common, more): (Issue, Vec<String>, usize)| {
            if more > 0 {
                let laws = if more == 1 { "law" } else { "laws" };
                issue.label += &format!("; likewise {more} more {laws} that hold `{}`", common.join("`, `"));
            }
            issue
        };
        told.into_iter().map(one).collect()
    }
}
