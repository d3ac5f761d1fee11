//! `dalembert ledger`: all claims with their verdicts.

mod certificates;
pub mod paper_file;

use crate::arguments::Format;
use crate::claim_row::row;
use crate::exit::{Exit, print, warn};
use crate::job_pool::JobPool;
use certificates::CertificateFolder;
use charts::PaperSection;
use claims::Paper;
use claims::catalogue::papers;
use claims::certificate::Certificate;
use claims::{Judged, Verdict, entries};
use std::path::PathBuf;

/// Arguments of `ledger`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Only claims whose id contains this, such as konosevich2022/eq5.3 or statement3; those whose id begins with it come first
    #[arg(default_value = "")]
    pub filter: String,
    /// Only claims with this verdict: refuted, undefined, undecided, proved, identified, enclosed, tested, definition, open
    #[arg(long)]
    pub verdict: Option<String>,
    /// Output format; JSON has one object for each claim: id, paper, equation, verdict, statement,
    /// formulas, requires, why, reading, note, counterexample, correction
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Writes a file PAPER.json for each paper, from which a checker can repeat the proof of every verdict, see verify/README.md
    #[arg(long, value_name = "DIR")]
    pub certificates: Option<PathBuf>,
    /// Replaces files of --certificates even if `ledger` did not write them
    #[arg(long, requires = "certificates")]
    pub force: bool,
}

/// Prints the claims whose id contains the filter and whose verdict is the requested one, if any.
pub fn list(asked: &Args) -> Result<Exit, Exit> {
    let verdict = asked.verdict.as_deref().map(verdict).transpose()?;
    let folder =
        asked.certificates.as_deref().map(|path| CertificateFolder::of(path, "ledger", asked.force)).transpose()?;
    let known = those_with(&asked.filter, folder.is_some());
    let nowhere = known.is_empty();
    let (chosen, certificates): (Vec<Judged>, Vec<Vec<Certificate>>) =
        known.into_iter().filter(|(claim, _)| verdict.is_none_or(|verdict| claim.verdict == verdict)).unzip();
    if nowhere {
        let keys: Vec<&str> = papers().iter().map(|paper| paper.key).collect();
        return Err(Exit::refused(format!(
            "no claim's id contains `{}`; ids begin with: {}",
            asked.filter,
            keys.join(", ")
        )));
    }
    let text = match asked.format {
        Format::Text => claims::render(&chosen),
        Format::Json => {
            let rows = serde_json::to_string_pretty(&entries(&chosen));
            rows.map_err(|error| Exit::refused(format!("the ledger cannot be written as JSON: {error}")))? + "\n"
        }
    };
    print(&text)?;
    if let Some(folder) = folder {
        let mut certificates: Vec<Certificate> = certificates.into_iter().flatten().collect();
        for paper in papers() {
            let (these, others) = certificates.into_iter().partition(|one| one.is_of(paper.key));
            certificates = others;
            folder.write([paper.key, paper.title, paper.citation], these, asked.format)?;
        }
    }
    let unsound: Vec<String> = chosen.iter().filter_map(|claim| claim.sound().err()).collect();
    for reason in &unsound {
        warn(reason);
    }
    Ok(if unsound.is_empty() { Exit::Done } else { Exit::Stopped })
}

fn verdict(name: &str) -> Result<Verdict, Exit> {
    Verdict::ALL.into_iter().find(|verdict| verdict.name() == name).ok_or_else(|| {
        let names = Verdict::ALL.map(Verdict::name).join(", ");
        Exit::refused(format!("there is no verdict `{name}`; there are: {names}"))
    })
}

/// A claim with its certificates.
type Certified = (Judged, Vec<Certificate>);

/// The judged claims whose id contains the filter, with their certificates if `certified`.
fn those_with(filter: &str, certified: bool) -> Vec<Certified> {
    let mut judged: Vec<Option<Vec<Certified>>> = papers().iter().map(|_| None).collect();
    let mut crew = JobPool::default();
    for (place, paper) in judged.iter_mut().zip(papers()) {
        crew.add(1.0, place, move || {
            let page = (paper.page)();
            let asked = |claim: &claims::Claim| claim.id.contains(filter);
            match certified {
                true => page.certified(asked).collect(),
                false => page.judged(asked).map(|judged| (judged, Vec::new())).collect(),
            }
        });
    }
    crew.work(|_| ());
    let mut all: Vec<Certified> = judged.into_iter().flatten().flatten().collect();
    // claims whose id begins with the filter come first, since the user probably means these
    all.sort_by_key(|(claim, _)| !claim.id.starts_with(filter));
    all
}

/// The section of a paper in the report, and whether every claim in it is sound.
pub fn judged(paper: &Paper) -> (PaperSection, bool) {
    let judged = (paper.page)().judge();
    let sound = judged.iter().all(|claim| claim.sound().is_ok());
    (section(paper, &judged), sound)
}

fn section(paper: &Paper, judged: &[Judged]) -> PaperSection {
    PaperSection {
        id: paper.key.into(),
        title: paper.title.into(),
        citation: paper.citation.into(),
        summary: paper.summary.into(),
        claims: judged.iter().map(row).collect(),
    }
}
