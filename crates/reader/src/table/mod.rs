//! Reading a table of a scene file: every value checked, every key accounted for. Texts and counts are read in `words`,
//! numbers with their units in `quantities`.

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

/// A table, the keys that were asked for, and the errors found. A wrong value is replaced by a harmless one: reading
/// goes on, and all errors are reported together; a file with errors gives no scene.
pub struct Table<'a> {
    /// The name in brackets; empty for the top of the file.
    name: String,
    /// The place of the heading.
    span: Range<usize>,
    /// The text of the file.
    source: &'a str,
    /// `None` where the file lacks it: every key is then missing, which is reported once, for the table.
    entries: Option<&'a DeTable<'a>>,
    asked: Vec<String>,
    /// Whether a key that nobody asked for is wrong.
    judged: bool,
    /// The allowances at the top of the file.
    allowed: Allowed,
    /// Keys that should be here, each with the error for the case that no misspelt key explains its absence.
    missing: Vec<(String, Issue)>,
    issues: Vec<Issue>,
}

/// A value with its place.
pub struct At<T> {
    pub value: T,
    pub span: Range<usize>,
}

impl<'a> Table<'a> {
    /// The top of a file.
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

    /// A table inside this one.
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
        self.inside(name, span, entries)
    }

    /// Tables of one name, `[[name]]` each; none where they are left out.
    pub fn tables(&mut self, name: &str, needed: &str) -> Vec<Table<'a>> {
        let Some(found) = self.find(name) else { return Vec::new() };
        let DeValue::Array(items) = found.get_ref() else {
            self.wrong_kind(found.span(), name, found.get_ref(), needed);
            return Vec::new();
        };
        let mut tables = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::Table(entries) => tables.push(self.inside(name, item.span(), Some(entries))),
                other => self.wrong_kind(item.span(), name, other, needed),
            }
        }
        tables
    }

    /// The keys of the table in the order of the file.
    pub fn keys(&self) -> Vec<At<String>> {
        let keys = self.entries.into_iter().flat_map(DeTable::keys);
        let mut keys: Vec<At<String>> =
            keys.map(|key| At { value: key.get_ref().to_string(), span: key.span() }).collect();
        keys.sort_by_key(|key| key.span.start);
        keys
    }

    /// The span in the file of a part of a text; of the whole text if it is written with escapes.
    pub fn part(&self, text: &At<String>, part: &Range<usize>) -> Range<usize> {
        let written = self.source.get(text.span.clone()).and_then(|written| written.find(&text.value));
        written.map_or(text.span.clone(), |begin| {
            let start = text.span.start + begin;
            start + part.start..start + part.end
        })
    }

    /// A table that may be left out.
    pub fn optional_table(&mut self, name: &str) -> Option<Table<'a>> {
        self.find(name).is_some().then(|| self.table(name, ""))
    }

    /// The span of the table's heading.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Whether the file has the table.
    pub fn exists(&self) -> bool {
        self.entries.is_some()
    }

    /// Whether a key stands here.
    pub fn has(&self, key: &str) -> bool {
        self.entries.is_some_and(|entries| entries.contains_key(key))
    }

    /// Whether any error was found so far.
    pub fn has_issues(&self) -> bool {
        !(self.issues.is_empty() && self.missing.is_empty())
    }

    /// Whether the value at a place was already found wrong, and replaced.
    pub fn has_issue_at(&self, span: &Range<usize>) -> bool {
        self.issues.iter().any(|issue| issue.span.as_ref() == Some(span))
    }

    /// Marks keys that are known but cannot be judged, because of errors elsewhere.
    pub fn known(&mut self, keys: &[&str]) {
        self.asked.extend(keys.iter().map(|&key| key.to_owned()));
    }

    /// Leaves all keys of the table unjudged.
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

    /// Takes over all errors of a table inside this one.
    pub fn absorb(&mut self, inner: Table<'_>) {
        self.issues.extend(inner.finish());
    }

    /// The span of the value of a key.
    pub fn place_of(&self, key: &str) -> Option<Range<usize>> {
        self.entries?.get(key).map(Spanned::span)
    }

    /// Whether a key is one that its reader has asked for.
    pub fn is_known(&self, key: &str) -> bool {
        self.asked.iter().any(|asked| asked == key)
    }

    /// Whether a key holds a table.
    pub fn is_table(&self, key: &str) -> bool {
        matches!(self.entries.and_then(|entries| entries.get(key)).map(Spanned::get_ref), Some(DeValue::Table(_)))
    }

    /// All errors of the table, including keys that nobody asked for.
    pub fn finish(mut self) -> Vec<Issue> {
        let keys = self.entries.into_iter().flat_map(DeTable::keys).filter(|_| self.judged);
        let unknown: Vec<_> = keys.filter(|key| !self.asked.iter().any(|asked| asked == key.get_ref())).collect();
        // one unknown key in place of one that is missing is that key, in any spelling
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
            self.issues
                .push(Issue::at(key.span(), format!("unknown key `{name}`"), "not known here").accepted(accepted));
        }
        self.issues.extend(self.missing.into_iter().map(|(_, issue)| issue));
        self.issues
    }
}
