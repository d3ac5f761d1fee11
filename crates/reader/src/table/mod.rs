//! Tables of a scene file: every value is checked, and every key must be known. The module `words` reads texts and counts, the module
//! `quantities` numbers with units.

mod allowances;
mod quantities;
mod words;

pub use allowances::{NO_MUTUAL_INDUCTANCE, in_unit};

use crate::Allowed;
use crate::issue::Issue;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use units::nearest;

/// A table with the keys that were read so far and the errors found. A wrong value is replaced by a valid one: reading continues, and
/// all errors are reported together. A file with errors gives no scene.
pub struct Table<'a> {
    /// The name in brackets; empty for the top of the file.
    name: String,
    /// The range of bytes of the heading.
    span: Range<usize>,
    /// The text of the file.
    source: &'a str,
    /// `None` if the file lacks the table. The missing table is then reported once, and its keys are not.
    entries: Option<&'a DeTable<'a>>,
    asked: Vec<String>,
    /// Whether a key that was never read is an error.
    judged: bool,
    /// The allowances at the top of the file.
    allowed: Allowed,
    /// Required keys that are absent, each with its error. The error is dropped if an unknown key is probably a misspelling of the absent one.
    missing: Vec<(String, Issue)>,
    issues: Vec<Issue>,
}

/// A value with its range of bytes in the file.
pub struct At<T> {
    pub value: T,
    pub span: Range<usize>,
}

impl<'a> Table<'a> {
    /// Returns the top-level table of a file with the text `source`.
    pub fn top(source: &'a str, entries: &'a Spanned<DeTable<'a>>) -> Self {
        let (asked, missing, issues) = (Vec::new(), Vec::new(), Vec::new());
        Table {
            name: String::new(),
            span: 0..0,
            source,
            entries: Some(entries.get_ref()),
            asked,
            judged: true,
            allowed: Allowed::default(),
            missing,
            issues,
        }
    }

    fn inside(&self, name: &str, span: Range<usize>, entries: Option<&'a DeTable<'a>>) -> Self {
        let (asked, missing, issues) = (Vec::new(), Vec::new(), Vec::new());
        let name = name.to_owned();
        let (source, allowed) = (self.source, self.allowed);
        Table { name, span, source, entries, asked, judged: true, allowed, missing, issues }
    }

    /// Reads the table `name` inside this one; an absent table is an error. `holds` describes the content of the table in messages.
    pub fn table(&mut self, name: &str, holds: &str) -> Table<'a> {
        let found = self.find(name);
        let heading = if self.name.is_empty() { name.to_owned() } else { format!("{}.{name}", self.name) };
        let (span, entries) = match found.map(|value| (value.span(), value.get_ref())) {
            Some((span, DeValue::Table(entries))) => (span, Some(entries)),
            Some((span, other)) => {
                self.wrong_kind(span.clone(), name, other, &format!("a table is accepted: [{heading}]"));
                (span, None)
            }
            None => {
                let issue = Issue::at(self.span.clone(), format!("the table [{heading}] is missing"), "in this file");
                self.missing.push((name.to_owned(), issue.accepted(format!("[{heading}] gives {holds}"))));
                (self.span.clone(), None)
            }
        };
        self.inside(&heading, span, entries)
    }

    /// Reads an array of tables, `[[name]]`; empty if the key is absent. `needed` describes the accepted input in messages.
    pub fn tables(&mut self, name: &str, needed: &str) -> Vec<Table<'a>> {
        let Some(found) = self.find(name) else { return Vec::new() };
        let DeValue::Array(items) = found.get_ref() else {
            self.wrong_kind(found.span(), name, found.get_ref(), needed);
            return Vec::new();
        };
        let heading = if self.name.is_empty() { name.to_owned() } else { format!("{}.{name}", self.name) };
        let mut tables = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::Table(entries) => tables.push(self.inside(&heading, item.span(), Some(entries))),
                other => self.wrong_kind(item.span(), name, other, needed),
            }
        }
        tables
    }

    /// Returns the keys of the table in the order of the file.
    pub fn keys(&self) -> Vec<At<String>> {
        let keys = self.entries.into_iter().flat_map(DeTable::keys);
        let mut keys: Vec<At<String>> =
            keys.map(|key| At { value: key.get_ref().to_string(), span: key.span() }).collect();
        keys.sort_by_key(|key| key.span.start);
        keys
    }

    /// Returns the range of bytes in the file of a part of a text value; the range of the whole value if it contains escape sequences.
    pub fn part(&self, text: &At<String>, part: &Range<usize>) -> Range<usize> {
        let written = self.source.get(text.span.clone()).and_then(|written| written.find(&text.value));
        written.map_or(text.span.clone(), |begin| {
            let start = text.span.start + begin;
            start + part.start..start + part.end
        })
    }

    /// Reads the table `name` inside this one; `None` if the table is absent.
    pub fn optional_table(&mut self, name: &str) -> Option<Table<'a>> {
        self.find(name).is_some().then(|| self.table(name, ""))
    }

    /// Returns the range of bytes of the table's heading.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Returns whether the file contains the table.
    pub fn exists(&self) -> bool {
        self.entries.is_some()
    }

    /// Returns whether the table contains a key.
    pub fn has(&self, key: &str) -> bool {
        self.entries.is_some_and(|entries| entries.contains_key(key))
    }

    /// Returns whether any error was found so far in the table.
    pub fn has_issues(&self) -> bool {
        !(self.issues.is_empty() && self.missing.is_empty())
    }

    /// Returns whether an error was reported for exactly this range, so that its value is a replacement.
    pub fn has_issue_at(&self, span: &Range<usize>) -> bool {
        self.issues.iter().any(|issue| issue.span.as_ref() == Some(span))
    }

    /// Marks keys as known, although they were not read because of other errors.
    pub fn known(&mut self, keys: &[&str]) {
        self.asked.extend(keys.iter().map(|&key| key.to_owned()));
    }

    /// Marks all keys of the table as known.
    pub fn known_all(&mut self) {
        self.judged = false;
    }

    /// Adds an error.
    pub fn report(&mut self, issue: Issue) {
        self.issues.push(issue);
    }

    fn find(&mut self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        if !self.asked.iter().any(|asked| asked == key) {
            self.asked.push(key.to_owned());
        }
        self.entries?.get(key)
    }

    fn missing(&mut self, key: &str, needed: &str) {
        self.missing_number(key, &format!("the {needed}"));
    }

    fn missing_number(&mut self, key: &str, needed: &str) {
        if self.exists() {
            let place = if self.name.is_empty() { "in this file".to_owned() } else { format!("in [{}]", self.name) };
            let issue = Issue::at(self.span(), format!("`{key}` is missing"), place);
            self.missing.push((key.to_owned(), issue.accepted(format!("`{key}` is {needed}"))));
        }
    }

    fn wrong_kind(&mut self, span: Range<usize>, key: &str, found: &DeValue<'_>, accepted: &str) {
        let title = format!("`{key}` has the wrong type");
        self.report(Issue::at(span, title, format!("this is a TOML {}", found.type_str())).accepted(accepted));
    }

    /// Appends all errors of a table inside this one.
    pub fn absorb(&mut self, inner: Table<'_>) {
        self.issues.extend(inner.finish());
    }

    /// Returns the range of bytes of the value of a key.
    pub fn place_of(&self, key: &str) -> Option<Range<usize>> {
        self.entries?.get(key).map(Spanned::span)
    }

    /// Returns whether the program has read the key or marked it as known.
    pub fn is_known(&self, key: &str) -> bool {
        self.asked.iter().any(|asked| asked == key)
    }

    /// Returns whether the value of a key is a table.
    pub fn is_table(&self, key: &str) -> bool {
        matches!(self.entries.and_then(|entries| entries.get(key)).map(Spanned::get_ref), Some(DeValue::Table(_)))
    }

    /// Returns all errors of the table, including unknown and missing keys.
    pub fn finish(mut self) -> Vec<Issue> {
        let keys = self.entries.into_iter().flat_map(DeTable::keys).filter(|_| self.judged);
        let unknown: Vec<_> = keys.filter(|key| !self.asked.iter().any(|asked| asked == key.get_ref())).collect();
        // if exactly one key is unknown and one is missing, the unknown key is a misspelling of the missing one
        let only = match (unknown.as_slice(), self.missing.as_slice()) {
            ([_], [(missing, _)]) => Some(missing.clone()),
            _ => None,
        };
        for key in unknown {
            let name = key.get_ref().as_ref();
            let known = || self.asked.iter().map(String::as_str);
            let absent = nearest(name, self.missing.iter().map(|(key, _)| key.as_str())).map(str::to_owned);
            let absent = absent.or_else(|| only.clone());
            let accepted = match absent.as_deref().or_else(|| nearest(name, known())) {
                _ if allowances::is_mutual_inductance(name) => allowances::NO_MUTUAL_INDUCTANCE.to_owned(),
                Some(nearest) => format!("is `{nearest}` meant?"),
                None => format!("known here: {}", known().collect::<Vec<_>>().join(", ")),
            };
            self.missing.retain(|(key, _)| Some(key) != absent.as_ref());
            let title = match self.name.ends_with("vary.parameters") {
                true => format!("no parameter is called `{name}`"),
                false => format!("unknown key `{name}`"),
            };
            self.issues.push(Issue::at(key.span(), title, "not known here").accepted(accepted));
        }
        self.issues.extend(self.missing.into_iter().map(|(_, issue)| issue));
        self.issues
    }
}
