//! A page as text for reviews: verdict in the first column, exact content only, claims in the order of the paper.

use crate::{Judged, Verdict};
use std::fmt::Write;

/// The text of judged claims. Its first line states the number of claims with each verdict.
pub fn render(judged: &[Judged]) -> String {
    let counts: Vec<String> = Verdict::ALL
        .iter()
        .map(|verdict| (verdict, judged.iter().filter(|claim| claim.verdict == *verdict).count()))
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| match verdict {
            Verdict::Definition if count > 1 => format!("{count} definitions"),
            _ => format!("{count} {}", verdict.name()),
        })
        .collect();
    let noun = if judged.len() == 1 { "claim" } else { "claims" };
    let mut page = format!("{} {noun}: {}\n", judged.len(), counts.join(", "));
    for claim in judged {
        page.push('\n');
        write_claim(&mut page, claim, "");
    }
    page
}

fn write_claim(page: &mut String, claim: &Judged, indent: &str) {
    // writing to a String cannot fail
    let _ = writeln!(page, "{indent}{:<10} {}  {}", claim.verdict.name(), claim.id, claim.says);
    for equation in &claim.text {
        let _ = writeln!(page, "{indent}           | {equation}");
    }
    for (word, conditions) in [("requires", &claim.requires), ("signs", &claim.signs)] {
        if !conditions.is_empty() {
            let conditions: Vec<&str> = conditions.iter().map(|(text, _)| text.as_str()).collect();
            let _ = writeln!(page, "{indent}           {word} {}", conditions.join(", "));
        }
    }
    for (word, remark) in [("why:", &claim.why), ("reading:", &claim.reading), ("note:", &claim.note)] {
        if !remark.is_empty() {
            let _ = writeln!(page, "{indent}           {word} {remark}");
        }
    }
    if !claim.counterexample.is_empty() {
        let values: Vec<String> =
            claim.counterexample.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let _ = writeln!(page, "{indent}           at {}", values.join(", "));
    }
    if claim.verdict == Verdict::Refuted {
        let _ = writeln!(page, "{indent}           {}", claim.evidence);
    }
    if let Some((difference, _)) = &claim.difference {
        let _ = writeln!(page, "{indent}           excess {difference}");
    }
    if let Some(correction) = &claim.correction {
        let _ = writeln!(page, "{indent}           correct:");
        write_claim(page, correction, &format!("{indent}    "));
    }
}
