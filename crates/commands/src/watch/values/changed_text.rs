//! The text of a file with other numbers, and the lines in which it differs.

use super::{Datum, Place};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A text with other numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChangedText {
    pub text: String,
    /// The lines that differ, with their numbers from 1; `None` for a line that is added.
    pub lines: Vec<(Option<usize>, String)>,
}

/// The text in which these numbers are replaced by the values of their sliders.
pub fn changed(text: &str, values: &[(&Datum, f64)]) -> ChangedText {
    let mut edits: Vec<_> = values.iter().filter_map(|(datum, value)| edit(text, datum, *value)).collect();
    edits.sort_by_key(|(place, _)| std::cmp::Reverse(place.start));
    let mut changed = text.to_owned();
    for (place, written) in &edits {
        changed.replace_range(place.clone(), written);
    }
    // each replaced value stands on one line, so that line numbers do not change
    let pairs = text.lines().zip(changed.lines()).enumerate().filter(|(_, (old, new))| old != new);
    let mut lines: Vec<_> = pairs.map(|(place, (_, new))| (Some(place + 1), new.to_owned())).collect();
    let added: Vec<String> = values.iter().filter_map(|(datum, value)| added(datum, *value)).collect();
    let (text, new) = with_start(changed, &added);
    lines.extend(new);
    ChangedText { text, lines }
}

/// A value in the notation of the file, in quotes.
fn quantity(datum: &Datum, value: f64) -> String {
    let Datum { before, unit, .. } = datum;
    format!("\"{before}{}\"", format!("{} {unit}", datum.written(value)).trim_end())
}

fn edit(text: &str, datum: &Datum, value: f64) -> Option<(std::ops::Range<usize>, String)> {
    let Place::Written(place) = &datum.place else { return None };
    let is_line = text.get(place.clone()).is_some_and(|written| !written.contains('\n'));
    is_line.then(|| (place.clone(), quantity(datum, value)))
}

/// The line to be added for a coordinate or speed without an entry in the table `start`.
fn added(datum: &Datum, value: f64) -> Option<String> {
    match &datum.place {
        Place::LeftOut { key } => Some(format!("{key} = {}", quantity(datum, value))),
        Place::Written(_) => None,
    }
}

/// The text with these lines added to its table `start`, and the lines that differ.
fn with_start(text: String, added: &[String]) -> (String, Vec<(Option<usize>, String)>) {
    if added.is_empty() {
        return (text, Vec::new());
    }
    let place = match DeTable::parse(&text).ok().as_ref().map(|top| start_of(top.get_ref())) {
        Some(Some(place)) => Some(place),
        Some(None) => None,
        None => return (text, Vec::new()),
    };
    let new = |lines: &[String]| lines.iter().map(|line| (None, line.clone())).collect::<Vec<_>>();
    match place {
        // a new table may follow at the end of the file
        None => {
            let lines = [&["[start]".to_owned()], added].concat();
            let gap = if text.ends_with('\n') { "" } else { "\n" };
            (format!("{text}{gap}{}\n", lines.join("\n")), new(&lines))
        }
        Some(at) if text[at..].starts_with('{') => {
            let is_empty = text[at + 1..].trim_start().starts_with('}');
            let entries = added.join(", ") + if is_empty { " " } else { "," };
            let line = 1 + text[..at].matches('\n').count();
            let mut text = text;
            text.insert_str(at + 1, &format!(" {entries}"));
            let whole = text.lines().nth(line - 1).unwrap_or_default().to_owned();
            (text, vec![(Some(line), whole)])
        }
        Some(at) => {
            let end = text[at..].find('\n').map_or(text.len(), |end| at + end + 1);
            let gap = if text[..end].ends_with('\n') { "" } else { "\n" };
            (format!("{}{gap}{}\n{}", &text[..end], added.join("\n"), &text[end..]), new(added))
        }
    }
}

/// The position of the table `start` in the text: of its brace or of its heading.
fn start_of(top: &DeTable<'_>) -> Option<usize> {
    let value: &Spanned<DeValue<'_>> = top.get("start")?;
    Some(value.span().start)
}

#[cfg(test)]
mod tests {
    use super::super::data;
    use super::*;

    /// The text in which the numbers with these ids have other values.
    fn with(text: &str, values: &[(&str, f64)]) -> ChangedText {
        let data = data(text);
        let chosen = values.iter().map(|(id, value)| {
            let datum = data.iter().find(|datum| datum.id == *id).unwrap_or_else(|| panic!("{id}: {data:?}"));
            (datum, *value)
        });
        changed(text, &chosen.collect::<Vec<_>>())
    }

    const HEAD: &str = "coordinates = { a = \"rad\" }\n";

    #[test]
    fn a_number_is_replaced_where_it_stands_and_keeps_its_unit() {
        let text = format!("{HEAD}parameters = {{ m = \"2 kg\", k = 3.5 }} # two\nstart = {{ a = 'guess 1 rad' }}\n");
        let found = with(&text, &[("parameters.k", 4.0), ("parameters.m", 1.5), ("start.a", 0.5)]);
        let lines = [
            (Some(2), "parameters = { m = \"1.50 kg\", k = \"4.00\" } # two".to_owned()),
            (Some(3), "start = { a = \"guess 0.50 rad\" }".to_owned()),
        ];
        assert_eq!(found.lines, lines);
        assert_eq!(found.text.lines().count(), 3);
    }

    #[test]
    fn a_start_that_is_left_out_is_added_to_its_table() {
        let added = "a = \"0.50 rad\"";
        for (before, after) in [
            (HEAD.to_owned(), format!("{HEAD}[start]\n{added}\n")),
            (
                format!("{HEAD}[start]\n\"a'\" = \"1 rad/s\"\n"),
                format!("{HEAD}[start]\n{added}\n\"a'\" = \"1 rad/s\"\n"),
            ),
            (format!("{HEAD}[start]"), format!("{HEAD}[start]\n{added}\n")),
            (format!("{HEAD}start = {{}}\n"), format!("{HEAD}start = {{ {added} }}\n")),
            (
                format!("{HEAD}start = {{ \"a'\" = \"1 rad/s\" }}\n"),
                format!("{HEAD}start = {{ {added}, \"a'\" = \"1 rad/s\" }}\n"),
            ),
        ] {
            let found = with(&before, &[("start.a", 0.5)]);
            assert_eq!(found.text, after, "{before}");
            assert!(DeTable::parse(&found.text).is_ok() && found.lines.iter().any(|(_, line)| line.contains(added)));
        }
    }

    #[test]
    fn no_value_changes_nothing() {
        assert_eq!(changed("a = 1", &[]), ChangedText { text: "a = 1".into(), lines: Vec::new() });
    }
}
