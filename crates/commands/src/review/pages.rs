//! Changes of the reviewed pages, in terms of mechanics.

use super::earlier_text::git;
use crate::arguments::Format;
use crate::exit::{Exit, print};
use claims::catalogue::papers;
use claims::review::review as changes;
use serde_json::json;
use std::collections::BTreeSet;
use std::path::Path;

const FOLDER: &str = "snapshots";
/// The largest number of changed lines that are shown for a page without claims.
const SHOWN: usize = 12;

/// A page with the descriptions of its changes.
struct Changed {
    page: String,
    told: Vec<String>,
}

/// Prints all changes of all pages.
pub(super) fn show(against: &str, format: Format) -> Result<Exit, Exit> {
    if !Path::new(FOLDER).is_dir() {
        return Err(Exit::refused("there is no folder `snapshots` here: the project's own folder is accepted"));
    }
    let changed: Vec<Changed> = pages(against)?.into_iter().filter(|page| !page.told.is_empty()).collect();
    print(&match format {
        Format::Text if changed.is_empty() => format!("no page differs from {}\n", against),
        Format::Text => changed.iter().map(text).collect(),
        Format::Json => {
            let pages = changed.iter().map(|Changed { page, told }| json!({ "page": page, "changes": told }));
            format!("{:#}\n", pages.collect::<serde_json::Value>())
        }
    })?;
    Ok(Exit::Done)
}

fn text(Changed { page, told }: &Changed) -> String {
    told.iter().fold(format!("{page}\n"), |text, change| format!("{text}  {}\n", change.replace('\n', "\n  "))) + "\n"
}

/// All pages that differ from the commit, ordered by name.
fn pages(commit: &str) -> Result<Vec<Changed>, Exit> {
    let listed = |arguments: &[&str]| git(arguments).map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>());
    let mut names = BTreeSet::from_iter(listed(&["diff", "--name-only", "--relative", commit, "--", FOLDER])?);
    names.extend(listed(&["ls-files", "--others", "--", FOLDER])?);
    let now = |name: &str| std::fs::read_to_string(name).unwrap_or_default();
    // a page that the commit does not contain is compared with an empty one
    let before = |name: &str| git(&["show", &format!("{commit}:./{name}")]).unwrap_or_default();
    let compared = names.iter().map(|name| match name.strip_suffix(".new") {
        Some(standing) => Changed { page: name.clone(), told: told(standing, &now(standing), &now(name)) },
        None => Changed { page: name.clone(), told: told(name, &before(name), &now(name)) },
    });
    Ok(compared.collect())
}

/// The changes of a page: by claims for a page of claims, otherwise by lines.
fn told(name: &str, old: &str, new: &str) -> Vec<String> {
    let paper = papers().into_iter().find(|paper| Path::new(name).starts_with(Path::new(FOLDER).join(paper.key)));
    match paper {
        Some(paper) => {
            let page = (paper.page)();
            changes(old, new, &|letter| page.dimension(letter)).iter().map(ToString::to_string).collect()
        }
        None => lines(old, new),
    }
}

/// Removed and added lines. Two lines that differ only in numbers are listed once, with the changes of the numbers.
fn lines(old: &str, new: &str) -> Vec<String> {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let gone: Vec<&str> = old.iter().filter(|line| !new.contains(line)).copied().collect();
    let mut come: Vec<&str> = new.iter().filter(|line| !old.contains(line)).copied().collect();
    let mut told = Vec::new();
    for line in gone {
        match come.iter().position(|other| words(other) == words(line)) {
            Some(place) => told.push(moved(line, come.remove(place))),
            None => told.push(format!("- {line}")),
        }
    }
    told.extend(come.into_iter().map(|line| format!("+ {line}")));
    let more = told.len().saturating_sub(SHOWN);
    told.truncate(SHOWN);
    told.extend((more > 0).then(|| format!("and {more} more")));
    told
}

/// The words of a line that are not numbers.
fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().filter(|word| word.parse::<f64>().is_err()).collect()
}

/// The changes of the numbers between two lines with equal words.
fn moved(old: &str, new: &str) -> String {
    let numbers = |line: &str| line.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).collect::<Vec<_>>();
    let (before, now) = (numbers(old), numbers(new));
    let pairs = before.iter().zip(&now).filter(|(before, now)| before != now);
    let steps = pairs.map(|(before, now)| match *before {
        0.0 => format!("{before} to {now}"),
        _ => format!("{before} to {now} ({:+.1} %)", (now / before - 1.0) * 100.0),
    });
    format!("{}: {}", words(new).join(" "), steps.collect::<Vec<_>>().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use papers as _;

    #[test]
    fn rows_of_the_same_words_are_told_by_how_much_they_moved() {
        let told = lines("a row\nTaylor bench 641 1172\ngone 1\n", "a row\nTaylor bench 650 1172\n");
        assert_eq!(told, ["Taylor bench: 641 to 650 (+1.4 %)", "- gone 1"]);
    }

    #[test]
    fn a_lost_term_of_a_page_of_claims_is_told_by_name() {
        let page = "proved     konosevich2022/eq4.1/x  x\n           | A1*ω̇1 = A2*ω2*ω3 - A3*ω2*ω3\n";
        let told = told("snapshots/konosevich2022/a.snap", page, &page.replace(" - A3*ω2*ω3", ""));
        assert!(told.len() == 1 && told[0].contains("lost: A3*ω2*ω3") && told[0].contains("Coriolis"), "{told:?}");
    }
}
