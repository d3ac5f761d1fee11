//! Texts, integers and flags of a table.

use super::{At, Table};
use crate::issue::Issue;
use toml::de::DeValue;

impl Table<'_> {
    /// Reads a text without leading and trailing spaces; empty if it is wrong or absent, which is an error. `needed` describes the text in messages.
    pub fn text(&mut self, key: &str, needed: &str) -> At<String> {
        self.optional_text(key, needed).unwrap_or_else(|| {
            self.missing(key, needed);
            At { value: String::new(), span: self.span() }
        })
    }

    /// Reads an optional text.
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

    /// Reads an optional text, or a number in the spelling of the file.
    pub fn written(&mut self, key: &str, needed: &str) -> Option<At<String>> {
        let found = self.find(key)?;
        match found.get_ref() {
            DeValue::Float(number) => Some(At { value: number.as_str().to_owned(), span: found.span() }),
            DeValue::Integer(number) if number.radix() == 10 => {
                Some(At { value: number.as_str().to_owned(), span: found.span() })
            }
            _ => self.optional_text(key, needed).filter(|text| !text.value.is_empty()),
        }
    }

    /// Reads an optional flag; false if the key is absent.
    pub fn flag(&mut self, key: &str, meaning: &str) -> bool {
        let Some(found) = self.find(key) else { return false };
        match found.get_ref() {
            DeValue::Boolean(value) => *value,
            other => {
                self.wrong_kind(found.span(), key, other, &format!("true or false is accepted: {meaning}"));
                false
            }
        }
    }

    /// Reads a text or a nonempty list of texts; an absent key is an error.
    pub fn text_or_texts(&mut self, key: &str, needed: &str) -> Vec<At<String>> {
        match self.find(key).map(|found| found.get_ref()) {
            Some(DeValue::Array(items)) if !items.is_empty() => self.texts(key, &format!("[\"a\", \"b\"]: {needed}")),
            _ => vec![self.text(key, needed)].into_iter().filter(|text| !text.value.is_empty()).collect(),
        }
    }

    /// Reads a list of texts; empty if the key is absent.
    pub fn texts(&mut self, key: &str, needed: &str) -> Vec<At<String>> {
        let Some(found) = self.find(key) else { return Vec::new() };
        let help = format!("a list is accepted, such as {needed}");
        let DeValue::Array(items) = found.get_ref() else {
            self.wrong_kind(found.span(), key, found.get_ref(), &help);
            return Vec::new();
        };
        let mut texts = Vec::new();
        let mut sound = true;
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) => texts.push(At { value: text.to_string(), span: item.span() }),
                // only the first wrong element is reported
                other if sound => {
                    self.wrong_kind(item.span(), key, other, &help);
                    sound = false;
                }
                _ => {}
            }
        }
        texts
    }

    /// Reads an integer from `least` to `most`. A wrong or absent value is an error, and is replaced by `least`.
    pub fn count(&mut self, key: &str, meaning: &str, least: usize, most: usize) -> At<usize> {
        self.optional_count(key, meaning, least, most).unwrap_or_else(|| {
            self.missing(key, meaning);
            At { value: least, span: self.span() }
        })
    }

    /// Reads an optional integer from `least` to `most`. A wrong value is an error, and is replaced by `least`.
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
                        let label = format!("it is {}", number.as_str());
                        self.report(Issue::at(span.clone(), title, label).accepted(accepted));
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
}
