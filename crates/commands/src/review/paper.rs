//! Changes of a paper in its file: claims that were added or removed, or have another verdict, formula, correction or hypothesis.

use super::earlier_text::{self, other_file};
use super::system::{Changes, of_equations};
use crate::clock;
use crate::exit::Exit;
use claims::review::compare;
use manuscript::{Finding, PaperText};
use scenes::SystemText;
use std::path::Path;

/// All changes between two texts of a paper, each judged on the system of its time.
pub(super) fn changes(file: &Path, against: &str, [before, now]: [SystemText; 2]) -> Result<Changes, Exit> {
    let mut old = PaperText::parse(other_file(against).unwrap_or(file), before.text)?;
    let model = old.model_file().filter(|_| other_file(against).is_none()).map(Path::to_owned);
    if let Some(model) = model {
        old = old.with_model(earlier_text::of(&model, against)?.text);
    }
    let new = PaperText::parse(file, now.text)?;
    old.key.clone_from(&new.key);
    let mut all = of_equations(&[old.system().clone(), new.system().clone()])?;
    let judge = |paper: &PaperText| paper.judge_each(|_| {}, clock::has_time);
    let [old, new] = [judge(&old)?, judge(&new)?];
    for finding in &new {
        let id = &finding.judged.id;
        let told = match old.iter().find(|before| before.judged.id == *id) {
            None => vec![format!("new, {}", finding.judged.verdict.name())],
            Some(before) => changed(before, finding),
        };
        all.push((id.clone(), told));
    }
    let gone = old.iter().filter(|before| !new.iter().any(|finding| finding.judged.id == before.judged.id));
    all.extend(gone.map(|before| (before.judged.id.clone(), vec!["gone".to_owned()])));
    Ok(all)
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
