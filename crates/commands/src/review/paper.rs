//! Changes of a paper in its file: claims that were added or removed, and claims with another verdict, formula, correction or hypothesis.

use super::earlier_text::{self, other_file};
use super::system::{Changes, of_equations};
use crate::clock;
use crate::exit::Exit;
use claims::review::compare;
use manuscript::{Finding, PaperFindings, PaperText, UnjudgedClaim};
use reader::SceneError;
use scenes::SystemText;
use std::path::Path;

/// The changes between two texts of a paper, and the faults of claims of the new text that cannot be read.
pub(super) struct PaperChanges {
    pub changes: Changes,
    pub faults: Option<SceneError>,
}

/// All changes between two texts of a paper. The claims of each text are judged on the system that the paper had then.
pub(super) fn changes(file: &Path, against: &str, [before, now]: [SystemText; 2]) -> Result<PaperChanges, Exit> {
    let mut old = PaperText::parse(other_file(against).unwrap_or(file), before.text)?;
    let model = old.model_file().filter(|_| other_file(against).is_none()).map(Path::to_owned);
    if let Some(model) = model {
        old = old.with_model(earlier_text::of(&model, against)?.text);
    }
    let new = PaperText::parse(file, now.text)?;
    old.key.clone_from(&new.key);
    let mut all = of_equations(&[old.system().clone(), new.system().clone()])?;
    let judge = |paper: &PaperText| paper.findings(false, |_| {}, clock::has_time);
    let [old, new] = [judge(&old)?, judge(&new)?];
    for finding in &new.findings {
        let id = &finding.judged.id;
        let now = finding.judged.verdict.name();
        let told = match (finding_of(&old, id), fault_of(&old, id)) {
            (Some(before), _) => changed(before, finding),
            (None, Some(_)) => vec![format!("not read before, {now} now: {}", finding.judged.evidence)],
            (None, None) => vec![format!("new, {now}")],
        };
        all.push((id.clone(), told));
    }
    for UnjudgedClaim { id, fault, .. } in &new.unjudged {
        // of two claims with one name, the second has no verdict of its own
        let told = match (finding_of(&old, id).filter(|_| finding_of(&new, id).is_none()), fault_of(&old, id)) {
            (Some(before), _) => vec![format!("{} before, not read now: {fault}", before.judged.verdict.name())],
            (None, Some(before)) if before == fault => Vec::new(),
            (None, Some(before)) => vec![format!("not read before: {before}; not read now: {fault}")],
            (None, None) => vec![format!("new, not read: {fault}")],
        };
        all.push((id.clone(), told));
    }
    let known = |id: &String| finding_of(&new, id).is_some() || fault_of(&new, id).is_some();
    let before =
        old.findings.iter().map(|finding| &finding.judged.id).chain(old.unjudged.iter().map(|claim| &claim.id));
    all.extend(before.filter(|id| !known(id)).map(|id| (id.clone(), vec!["gone".to_owned()])));
    Ok(PaperChanges { changes: all, faults: new.error })
}

fn finding_of<'a>(paper: &'a PaperFindings, id: &str) -> Option<&'a Finding> {
    paper.findings.iter().find(|finding| finding.judged.id == id)
}

/// The fault of a claim that could not be read; `None` where the claim was read.
fn fault_of<'a>(paper: &'a PaperFindings, id: &str) -> Option<&'a String> {
    paper.unjudged.iter().find(|claim| claim.id == id).map(|claim| &claim.fault)
}

fn changed(before: &Finding, now: &Finding) -> Vec<String> {
    let mut told = Vec::new();
    let [old, new] = [&before.judged, &now.judged];
    if old.verdict != new.verdict {
        told.push(format!("{} before, {} now: {}", old.verdict.name(), new.verdict.name(), new.evidence));
    }
    for (from, to) in old.text.iter().zip(&new.text).filter(|(from, to)| from != to) {
        match compare(from, to, &|_| None) {
            Some(terms) => {
                told.extend(terms.iter().map(|term| format!("{:?}: {}", term.edit, term.term).to_lowercase()))
            }
            None => told.push(format!("{from} before, {to} now")),
        }
    }
    if old.text.len() != new.text.len() {
        told.push(format!("{} equations before, {} now", old.text.len(), new.text.len()));
    }
    let requires = |of: &Finding| -> Vec<String> {
        of.judged.requires.iter().chain(&of.judged.signs).map(|(text, _)| text.clone()).collect()
    };
    let [lost, gained] = [(before, now), (now, before)].map(|(of, other)| {
        let other = requires(other);
        requires(of).into_iter().filter(|one| !other.contains(one)).collect::<Vec<_>>()
    });
    told.extend(gained.iter().map(|each| format!("needs now: {each}")));
    told.extend(lost.iter().map(|each| format!("no longer needs: {each}")));
    let corrections = |of: &Finding| of.corrections.iter().map(|one| one.says()).collect::<Vec<_>>();
    let [old, new] = [corrections(before), corrections(now)];
    if old != new {
        let none = |all: Vec<String>| if all.is_empty() { "none".to_owned() } else { all.join("; ") };
        told.push(format!("correction: {} before, {} now", none(old), none(new)));
    }
    told
}
