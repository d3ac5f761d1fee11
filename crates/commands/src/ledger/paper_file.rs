//! `dalembert judge`: verdicts on the claims of a paper in a file.

use super::certificates::CertificateFolder;
use crate::arguments::Format;
use crate::claim_row::{row, unread_row};
use crate::clock;
use crate::exit::{Exit, print, warn};
use crate::output::{Form, Maker, Writes};
use crate::progress::Progress;
use charts::{ClaimRow, PaperSection, Report};
use claims::Verdict;
use clap::ArgGroup;
use manuscript::{Change, Correction, Finding, PaperFindings, PaperText, Search, UnjudgedClaim};
use reader::SceneError;
use serde_json::json;
use std::path::PathBuf;
use std::time::Duration;

/// The time before the deadline at which the search for corrections ends.
const KEPT: Duration = Duration::from_millis(500);

/// Arguments of `judge`.
#[derive(clap::Args, Debug)]
#[command(group(ArgGroup::new("written").args(["page", "certificates"]).multiple(true)))]
pub struct Args {
    /// The paper: a file with [letters] and [[claim]], and with the tables of its system or `model`, the name of the system's file
    #[arg(value_name = "PAPER.toml")]
    pub paper: PathBuf,
    /// Only claims whose id contains this, such as cart_pole/eq2
    #[arg(long, default_value = "")]
    pub filter: String,
    /// One object for each claim: id, kind, verdict, printed formula, reading, hypotheses, counterexample, missing terms, corrections
    #[arg(long)]
    pub json: bool,
    /// Writes a page with every claim, for a browser
    #[arg(long, value_name = "FILE.html")]
    pub page: Option<PathBuf>,
    /// Writes PAPER.json into this folder, from which a checker can repeat the proof of every verdict, see verify/README.md
    #[arg(long, value_name = "DIR")]
    pub certificates: Option<PathBuf>,
    /// Replaces the file of --page or --certificates even if `judge` did not write it
    #[arg(long, requires = "written")]
    pub force: bool,
    /// Prints only how many verdicts are equal to `expect`; each other verdict is an error, and the exit code is then 1
    #[arg(long)]
    pub test: bool,
}

/// The last part of the long help: an example of a paper's file.
pub const HELP: &str = r#"A paper's file:

  title = "A pendulum"
  model = "pendulum.toml"        # or the tables of the system in this file

  [letters]                      # LaTeX = its meaning, an expression of the model
  'm' = "m"
  'l' = "l"
  'g' = "g"
  '\theta' = "theta"

  [[claim]]
  equation = "1"                 # the number in the paper
  kind = "equation of motion"    # linearised equation, formula, identity, inequality,
                                 # equivalence, integral of motion, steady motion,
                                 # stability, number
  formula = 'm l^2 \ddot{\theta} + m g l \sin\theta = 0'
  given = ['m > 0']              # hypotheses; may be left out
  expect = "proved"              # for --test; may be left out

Rates of declared letters are known: \dot{\theta}, \ddot{\theta}. Each line of a display on several lines is one claim.
A formula that can be read in two ways is refused; the message lists unambiguous spellings.

Where a claim is refuted, the smallest edits of its formula that make it true are printed, each one proved.

Exit codes:

    0  every claim was judged, each verdict is the one that the file expects (`expect`; without
       it any verdict counts as expected), and there is no warning such as mixed dimensions
    1  a verdict is not the expected one, or there is an objection, such as mixed dimensions; or
       the time limit was reached before every claim had its verdict
    2  the file cannot be read, or the formula or the hypotheses of a claim cannot: its other
       claims are judged and printed all the same
  130  interrupted by Ctrl-C; the claims that were judged until then are printed"#;

/// Judges every claim and prints the findings.
pub fn judge(asked: &Args) -> Result<Exit, Exit> {
    let mut paper = PaperText::read(&asked.paper)?;
    let writes = Writes { command: "judge", force: asked.force, reads: vec![&asked.paper] };
    let output = writes.optional(asked.page.as_deref(), &[Form::Page])?;
    clock::due(asked.page.as_deref());
    let ids: Vec<String> = paper.claims.iter().map(|claim| paper.id_of(claim)).collect();
    let mut chosen = ids.iter().map(|id| id.contains(&asked.filter));
    paper.claims.retain(|_| chosen.next().unwrap_or_default());
    if paper.claims.is_empty() {
        return Err(Exit::refused(format!(
            "no claim's id contains `{}`; ids begin with {}/eq",
            asked.filter, paper.key
        )));
    }
    let mut progress = Progress::new("verdicts and corrections");
    let (all, is_open) = (paper.claims.len(), |one: &&Finding| one.search == Search::Cut);
    let so_far = |findings: &[Finding]| {
        let settled = findings.len() - findings.iter().filter(is_open).count();
        progress.set((findings.len() + settled) as f64 / (2 * all) as f64);
        // the exit code reports that the list is incomplete
        if asked.json {
            clock::publish(format!("{:#}\n", findings.iter().map(object).collect::<serde_json::Value>()));
        } else if !asked.test {
            clock::publish(findings.iter().map(Finding::text).collect());
        }
    };
    let folder =
        asked.certificates.as_deref().map(|path| CertificateFolder::of(path, "judge", asked.force)).transpose()?;
    // corrections are optional; the search for them ends early enough to print the verdicts
    let goes_on = || !asked.test && clock::left() > KEPT;
    let PaperFindings { findings, unjudged, error } = paper.findings(folder.is_some(), so_far, goes_on)?;
    drop(progress);
    let wrong: Vec<String> = findings.iter().filter_map(|finding| finding.as_expected().err()).collect();
    print(&match (asked.json, asked.test) {
        (true, _) => {
            let all = findings.iter().map(object).chain(unjudged.iter().map(unjudged_object));
            format!("{:#}\n", all.collect::<serde_json::Value>())
        }
        (false, true) => tested(&findings, unjudged.len()),
        (false, false) => {
            let told: String = findings.iter().map(Finding::text).collect();
            format!("{told}{}", counted(&findings, unjudged.len()))
        }
    })?;
    if let Some(output) = output {
        let html = charts::page::render(&report(&paper, &findings, &unjudged)).html;
        clock::due(None);
        output.write_text(&html)?.tell(if asked.json { Format::Json } else { Format::Text })?;
    }
    if let Some(folder) = folder {
        let certificates = findings.iter().flat_map(Finding::certificates).collect();
        let format = if asked.json { Format::Json } else { Format::Text };
        folder.write([&paper.key, &paper.title, &paper.citation], certificates, format)?;
    }
    for reason in &wrong {
        warn(reason);
    }
    if let Some(error) = error {
        return Err(error.into());
    }
    Ok(if wrong.is_empty() { Exit::Done } else { Exit::Stopped })
}

/// The number of claims with each verdict, and of those without one.
fn counted(findings: &[Finding], unjudged: usize) -> String {
    let mut counts: Vec<String> = Verdict::ALL
        .into_iter()
        .map(|verdict| (verdict, findings.iter().filter(|finding| finding.judged.verdict == verdict).count()))
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| format!("{count} {}", verdict.name()))
        .collect();
    counts.extend((unjudged > 0).then(|| format!("{unjudged} not read")));
    let count = findings.len() + unjudged;
    let noun = if count == 1 { "claim" } else { "claims" };
    format!("{count} {noun}: {}\n", counts.join(", "))
}

fn tested(findings: &[Finding], unjudged: usize) -> String {
    let expected: Vec<&Finding> = findings.iter().filter(|finding| finding.expected.is_some()).collect();
    let met = expected.iter().filter(|finding| finding.as_expected().is_ok()).count();
    let rest = match findings.len() - expected.len() {
        0 => String::new(),
        rest => format!("; {rest} without an expectation"),
    };
    let unread = if unjudged > 0 { format!("; {unjudged} not read") } else { String::new() };
    format!("{met} of {} verdicts as expected{rest}{unread}\n", expected.len())
}

/// A claim without a verdict as a JSON object.
pub fn unjudged_object(claim: &UnjudgedClaim) -> serde_json::Value {
    let UnjudgedClaim { id, equation, printed, line, fault, accepted } = claim;
    json!({
        "id": id,
        "equation": equation,
        "printed": printed,
        "verdict": null,
        "error": { "line": line, "says": fault, "accepted": accepted },
    })
}

/// A claim with its verdict as a JSON object.
pub fn object(finding: &Finding) -> serde_json::Value {
    let Finding { judged, printed, given, expected, allowed, sides, kind, corrections, search, .. } = finding;
    let told = |pairs: &[(String, String)]| pairs.iter().map(|(text, _)| text.clone()).collect::<Vec<_>>();
    json!({
        "id": judged.id,
        "equation": judged.equation,
        "section": judged.section,
        "kind": kind.name(),
        "says": judged.says,
        "verdict": judged.verdict.name(),
        "expected": expected.map(Verdict::name),
        "printed": printed,
        "read": judged.text,
        "read_latex": judged.latex,
        "given": given,
        "requires": told(&judged.requires),
        "signs": told(&judged.signs),
        "allowed": allowed,
        "evidence": judged.evidence,
        "counterexample": judged.counterexample.iter().cloned().collect::<std::collections::BTreeMap<_, _>>(),
        "left": sides.as_ref().map(|sides| &sides.left),
        "right": sides.as_ref().map(|sides| &sides.right),
        "missing": judged.difference.as_ref().map(|(text, _)| text),
        "missing_latex": judged.difference.as_ref().map(|(_, latex)| latex),
        // the reason for which there is no correction; corrections, if any, are all of the smallest size
        "search": search.told().filter(|_| corrections.is_empty()),
        "corrections": corrections.iter().map(corrected).collect::<serde_json::Value>(),
        "objections": judged.objections,
        "note": judged.note,
    })
}

fn corrected(correction: &Correction) -> serde_json::Value {
    let Correction { changes, formula, parts, judged, .. } = correction;
    let change = |change: &Change| json!({ "kind": change.kind.name(), "says": change.words, "before": change.before, "after": change.after });
    json!({
        "says": correction.says(),
        "changes": changes.iter().map(change).collect::<serde_json::Value>(),
        "formula": formula,
        // byte ranges of the formula that were changed
        "changed": parts.iter().map(|part| [part.start, part.end]).collect::<Vec<_>>(),
        "verdict": judged.verdict.name(),
        "evidence": judged.evidence,
        "requires": judged.requires.iter().chain(&judged.signs).map(|(text, _)| text.clone()).collect::<Vec<_>>(),
    })
}

fn report(paper: &PaperText, findings: &[Finding], unjudged: &[UnjudgedClaim]) -> Report {
    Report {
        title: paper.title.clone(),
        summary: counted(findings, unjudged.len()),
        generated_by: Maker("judge").generator(),
        papers: vec![section(paper, findings, unjudged)],
        ..Report::default()
    }
}

/// The section of the report with all claims in the order of the file, including those that could not be read.
fn section(paper: &PaperText, findings: &[Finding], unjudged: &[UnjudgedClaim]) -> PaperSection {
    let (mut judged, mut unread) = (findings.iter().peekable(), unjudged.iter().peekable());
    let claims = paper.claims.iter().filter_map(|claim| {
        let id = paper.id_of(claim);
        // of two claims with one name, the second was not judged
        let finding = judged.next_if(|finding| finding.judged.id == id && claim.faults.is_empty());
        finding.map(|finding| row(&finding.judged)).or_else(|| {
            unread.next_if(|one| one.id == id).map(|one| ClaimRow { section: claim.section.clone(), ..unread_row(one) })
        })
    });
    PaperSection {
        id: paper.key.clone(),
        title: paper.title.clone(),
        citation: paper.citation.clone(),
        summary: paper.summary.clone(),
        claims: claims.collect(),
    }
}

/// The section of a paper in the report, and whether every verdict is the one that its file expects.
///
/// # Errors
/// All faults of the file.
pub fn judged(paper: &PaperText) -> Result<(PaperSection, bool), SceneError> {
    let findings = paper.judge_each(|_| (), || clock::left() > KEPT)?;
    let mut section = section(paper, &findings, &[]);
    // to keep the report small, proved claims are shown as printed and not typeset again; `judge --page` typesets them
    for row in section.claims.iter_mut().filter(|row| row.verdict == Verdict::Proved && !row.reading.is_empty()) {
        row.latex.clear();
    }
    Ok((section, findings.iter().all(|finding| finding.as_expected().is_ok())))
}
