//! `dalembert review`: the changes of reviewed pages, of a system or of a paper, in terms of mechanics.

mod earlier_text;
mod pages;
mod paper;
mod renamed_coordinates;
mod run;
mod steady_motions;
mod system;
mod tables;

use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::stationary::steady_box::named_range;
use ::scenes::SystemText;
use ::scenes::steady_motions::Range;
use manuscript::is_paper;
use paper::PaperChanges;
use serde_json::json;
use std::path::PathBuf;

/// Arguments of `review`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The file of a system, of which equations, steady motions and the run are compared, or of a paper, of which claims are compared. Without
    /// a file the project's snapshots are compared: stored outputs with which tests compare the program
    #[arg(value_name = "SCENE.toml|PAPER.toml")]
    pub file: Option<PathBuf>,
    /// The commit of git to compare with, or a file; without a scene or paper, new snapshots (`.snap.new`) are compared with the accepted
    /// ones
    #[arg(long, value_name = "COMMIT|FILE", default_value = "HEAD")]
    pub against: String,
    /// The range of a coordinate in which steady motions of a system are compared, in SI units; angles need none
    #[arg(long, value_name = "NAME=FROM..TO", value_parser = named_range, num_args = 1)]
    pub range: Vec<(String, Range)>,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Changes under a title.
struct Part {
    title: String,
    told: Vec<String>,
}

/// Prints all changes.
pub fn review(asked: &Args) -> Result<Exit, Exit> {
    let Some(file) = &asked.file else {
        if let Some((name, _)) = asked.range.first() {
            return Err(Exit::refused(format!(
                "--range {name} is about a system in its file; name the file, or leave it out"
            )));
        }
        return pages::show(&asked.against, asked.format);
    };
    let now = SystemText::read(file)?;
    let before = earlier_text::of(file, &asked.against)?;
    let kinds = [is_paper(&before.text), is_paper(&now.text)];
    if kinds[0] != kinds[1] {
        let kind = |is_paper: bool| if is_paper { "a paper" } else { "a system" };
        return Err(Exit::refused(format!(
            "{} is {}, and {} {}; two systems, or two papers, are accepted",
            before.name,
            kind(kinds[0]),
            now.name,
            kind(kinds[1])
        )));
    }
    let mut parts = vec![("text".to_owned(), tables::changes([&before.text, &now.text]))];
    let (changes, faults) = match kinds[1] {
        true => {
            let PaperChanges { changes, faults } = paper::changes(file, &asked.against, [before, now])?;
            (changes, faults)
        }
        false => (system::changes([before, now], &asked.range)?, None),
    };
    parts.extend(changes);
    let parts: Vec<Part> = parts.into_iter().map(|(title, told)| Part { title, told }).collect();
    let changed = || parts.iter().filter(|part| !part.told.is_empty());
    print(&match asked.format {
        Format::Text if changed().next().is_none() => {
            format!("{}: no equation, run or other entry differs from {}\n", file.display(), asked.against)
        }
        Format::Text => changed().map(|part| format!("{}\n  {}\n", part.title, part.told.join("\n  "))).collect(),
        Format::Json => {
            let parts = changed().map(|Part { title, told }| json!({ "part": title, "changes": told }));
            format!("{:#}\n", parts.collect::<serde_json::Value>())
        }
    })?;
    faults.map_or(Ok(Exit::Done), |faults| Err(faults.into()))
}
