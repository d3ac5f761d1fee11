//! Reading a table of a scene file: every value checked, every key accounted for.

use super::issue::{Issue, nearest};
use super::quantity::{self, NoQuantity};
use super::units::Dimension;
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A table, the keys that were asked for, and what was found wrong. A value that is wrong is replaced by a harmless one,
/// so that reading goes on and all that is wrong is told at once; a file with issues gives no scene.
pub struct Table<'a> {
    /// As it stands in brackets; empty for the top of the file.
    name: String,
    /// Where its heading is.
    span: Range<usize>,
    /// The text of the file.
    source: &'a str,
    /// `None` where the file lacks it: every key is then missing, which is told once, for the table.
    entries: Option<&'a DeTable<'a>>,
    asked: Vec<String>,
    /// Whether a key that nobody asked for is wrong.
    judged: bool,
    /// Keys that should be here, each with what is told if no misspelt key explains its absence.
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
            missing,
            issues,
        }
    }

    fn inside(&self, name: &str, span: Range<usize>, entries: Option<&'a DeTable<'a>>) -> Self {
        let (asked, missing, issues) = (Vec::new(), Vec::new(), Vec::new());
        let name = name.to_owned();
        Table { name, span, source: self.source, entries, asked, judged: true, missing, issues }
    }

    /// A table inside this one.
    pub fn table(&mut self, name: &str, holds: &str) -> Table<'a> {
        let found = self.find(name);
        let (span, entries) = match found.map(|value| (value.span(), value.get_ref())) {
            Some((span, DeValue::Table(entries))) => (span, Some(entries)),
            Some((span, other)) => {
                self.wrong_kind(span.clone(), name, other, &format!("a table is accepted: [{name}]"));
                (span, None)
            }
            None => {
                let issue = Issue::at(self.span.clone(), format!("the table [{name}] is missing"), "in this file");
                self.missing.push((name.to_owned(), issue.accepted(format!("[{name}] gives {holds}"))));
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

    /// Where a part of a text stands in the file; all of the text where it is written with escapes.
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

    /// Where the heading of the table is.
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

    /// Whether anything was found wrong so far.
    pub fn has_issues(&self) -> bool {
        !(self.issues.is_empty() && self.missing.is_empty())
    }

    /// Whether the value at a place was already found wrong, and replaced.
    pub fn has_issue_at(&self, span: &Range<usize>) -> bool {
        self.issues.iter().any(|issue| issue.span.as_ref() == Some(span))
    }

    /// Keys that are known but cannot be judged, because of what is wrong elsewhere.
    pub fn known(&mut self, keys: &[&str]) {
        self.asked.extend(keys.iter().map(|&key| key.to_owned()));
    }

    /// Leaves all keys of the table unjudged.
    pub fn known_all(&mut self) {
        self.judged = false;
    }

    /// Something that is wrong here.
    pub fn report(&mut self, issue: Issue) {
        self.issues.push(issue);
    }

    /// A text.
    pub fn text(&mut self, key: &str, needed: &str) -> At<String> {
        self.optional_text(key, needed).unwrap_or_else(|| {
            self.missing(key, needed);
            At { value: String::new(), span: self.span() }
        })
    }

    /// A text that may be left out.
    pub fn optional_text(&mut self, key: &str, needed: &str) -> Option<At<String>> {
        let found = self.find(key)?;
        let value = match found.get_ref() {
            DeValue::String(text) => {
                if text.trim().is_empty() {
                    let empty = Issue::at(found.span(), format!("`{key}` is empty"), "nothing stands here");
                    self.report(empty.accepted(format!("`{key}` is the {needed}")));
                }
                text.trim().to_owned()
            }
            other => {
                self.wrong_kind(found.span(), key, other, &format!("{needed}, in quotes, is accepted"));
                String::new()
            }
        };
        Some(At { value, span: found.span() })
    }

    /// A list of texts; empty where it is left out.
    pub fn texts(&mut self, key: &str, needed: &str) -> Vec<At<String>> {
        let Some(found) = self.find(key) else { return Vec::new() };
        let help = format!("a list is accepted, such as {needed}");
        let DeValue::Array(items) = found.get_ref() else {
            self.wrong_kind(found.span(), key, found.get_ref(), &help);
            return Vec::new();
        };
        let mut texts = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) => texts.push(At { value: text.to_string(), span: item.span() }),
                other => self.wrong_kind(item.span(), key, other, &help),
            }
        }
        texts
    }

    /// A whole number of at least `least`.
    pub fn count(&mut self, key: &str, meaning: &str, least: usize, most: usize) -> At<usize> {
        self.optional_count(key, meaning, least, most).unwrap_or_else(|| {
            self.missing(key, meaning);
            At { value: least, span: self.span() }
        })
    }

    /// A whole number that may be left out.
    pub fn optional_count(&mut self, key: &str, meaning: &str, least: usize, most: usize) -> Option<At<usize>> {
        let found = self.find(key)?;
        let span = found.span();
        let accepted = format!("`{key}` is the {meaning}: a whole number from {least} to {most} is accepted");
        let value = match found.get_ref() {
            DeValue::Integer(number) => {
                match usize::from_str_radix(&number.as_str().replace('_', ""), number.radix()) {
                    Ok(value) if (least..=most).contains(&value) => value,
                    _ => {
                        let title = format!("`{key}` is out of range");
                        self.report(Issue::at(span.clone(), title, "not in the range").accepted(accepted));
                        least
                    }
                }
            }
            other => {
                self.wrong_kind(span.clone(), key, other, &accepted);
                least
            }
        };
        Some(At { value, span })
    }

    /// One quantity, in SI units.
    pub fn scalar(&mut self, key: &str, meaning: &str, unit: &str) -> At<f64> {
        let found = self.numbers(key, meaning, 1, 1, Dimension::of(unit));
        At { value: found.value[0], span: found.span }
    }

    /// One quantity of whatever dimension, in SI units; none where it cannot be read.
    pub fn of_any_unit(&mut self, key: &str) -> Option<At<(f64, Dimension)>> {
        let found = self.find(key)?;
        let span = found.span();
        let read = match found.get_ref() {
            DeValue::String(text) => quantity::parse_any(text),
            DeValue::Float(number) => quantity::parse_any(number.as_str()),
            DeValue::Integer(number) if number.radix() == 10 => quantity::parse_any(number.as_str()),
            other => {
                self.wrong_kind(span, key, other, &format!("a parameter is written so: {key} = \"0.15 N m\""));
                return None;
            }
        };
        match read {
            Ok(value) => Some(At { value, span }),
            Err(wrong) => {
                let title = format!("the parameter `{key}` cannot be read");
                self.report(Issue::at(span, title, wrong.to_string()).accepted("a number and its unit: \"0.15 N m\""));
                None
            }
        }
    }

    /// One quantity that may be left out.
    pub fn optional_scalar(&mut self, key: &str, meaning: &str, unit: &str) -> Option<At<f64>> {
        self.find(key).is_some().then(|| self.scalar(key, meaning, unit))
    }

    /// Three components.
    pub fn vector(&mut self, key: &str, meaning: &str, unit: &str) -> At<Vector3<f64>> {
        let found = self.numbers(key, meaning, 1, 3, Dimension::of(unit));
        At { value: Vector3::from_row_slice(&found.value), span: found.span }
    }

    /// Three rows of three components.
    pub fn matrix(&mut self, key: &str, meaning: &str, unit: &str) -> At<Matrix3<f64>> {
        let found = self.numbers(key, meaning, 3, 3, Dimension::of(unit));
        At { value: Matrix3::from_row_slice(&found.value), span: found.span }
    }

    /// `columns` numbers that may be left out.
    pub fn optional_row(&mut self, key: &str, meaning: &str, columns: usize, unit: &str) -> Option<At<Vec<f64>>> {
        self.optional_rows(key, meaning, 1, columns, unit)
    }

    /// `rows` rows of `columns` numbers that may be left out.
    pub fn optional_rows(
        &mut self,
        key: &str,
        meaning: &str,
        rows: usize,
        columns: usize,
        unit: &str,
    ) -> Option<At<Vec<f64>>> {
        self.find(key).is_some().then(|| self.numbers(key, meaning, rows, columns, Dimension::of(unit)))
    }

    fn numbers(&mut self, key: &str, meaning: &str, rows: usize, columns: usize, needed: Dimension) -> At<Vec<f64>> {
        let harmless = vec![1.0; rows * columns];
        let Some(found) = self.find(key) else {
            self.missing(key, &format!("{meaning}, such as {key} = {}", quantity::example(rows, columns, needed)));
            return At { value: harmless, span: self.span() };
        };
        let span = found.span();
        let read = match found.get_ref() {
            DeValue::String(text) => quantity::parse(text, rows, columns, needed),
            DeValue::Float(number) => quantity::parse(number.as_str(), rows, columns, needed),
            DeValue::Integer(number) if number.radix() == 10 => quantity::parse(number.as_str(), rows, columns, needed),
            other => {
                let example = quantity::example(rows, columns, needed);
                self.wrong_kind(span.clone(), key, other, &format!("the {meaning} is written so: {example}"));
                return At { value: harmless, span };
            }
        };
        let value = read.unwrap_or_else(|wrong| {
            self.report(of_quantity(key, meaning, span.clone(), &wrong, &wrong.accepted(rows, columns, needed)));
            harmless
        });
        At { value, span }
    }

    fn find(&mut self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        if !self.asked.iter().any(|asked| asked == key) {
            self.asked.push(key.to_owned());
        }
        self.entries?.get(key)
    }

    fn missing(&mut self, key: &str, needed: &str) {
        if self.exists() {
            let place = if self.name.is_empty() { "in this file".to_owned() } else { format!("in [{}]", self.name) };
            let issue = Issue::at(self.span(), format!("`{key}` is missing"), place);
            self.missing.push((key.to_owned(), issue.accepted(format!("`{key}` is the {needed}"))));
        }
    }

    fn wrong_kind(&mut self, span: Range<usize>, key: &str, found: &DeValue<'_>, accepted: &str) {
        let title = format!("`{key}` has the wrong type");
        self.report(Issue::at(span, title, format!("this is a TOML {}", found.type_str())).accepted(accepted));
    }

    /// All that is wrong in the table, keys included that nobody asked for.
    pub fn finish(mut self) -> Vec<Issue> {
        for key in self.entries.into_iter().flat_map(DeTable::keys) {
            let name = key.get_ref().as_ref();
            if !self.judged || self.asked.iter().any(|asked| asked == name) {
                continue;
            }
            let known = || self.asked.iter().map(String::as_str);
            let absent = nearest(name, self.missing.iter().map(|(key, _)| key.as_str())).map(str::to_owned);
            let accepted = match absent.as_deref().or_else(|| nearest(name, known())) {
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

fn of_quantity(key: &str, meaning: &str, span: Range<usize>, wrong: &NoQuantity, accepted: &str) -> Issue {
    let title = format!("`{key}`, the {meaning}, cannot be read");
    Issue::at(span, title, wrong.to_string()).accepted(accepted)
}
