//! The finding on a claim whose hypotheses have several cases. The claim is proved if it holds in each case.

use crate::finding::Finding;
use claims::Verdict;

/// The joint finding of all cases, each with a description: that of the first refuted case, otherwise of the first open one, otherwise a proof.
pub(crate) fn joined(mut cases: Vec<(String, Finding)>) -> Option<Finding> {
    let rank = |verdict: Verdict| match verdict {
        Verdict::Refuted => 0,
        Verdict::Proved | Verdict::Enclosed => 2,
        // in a case in which the formula has no value, it states nothing
        Verdict::Undefined => 3,
        _ => 1,
    };
    cases.sort_by_key(|(_, finding)| rank(finding.judged.verdict));
    let mut each = cases.into_iter();
    let (words, mut found) = each.next()?;
    let rest: Vec<(String, Finding)> = each.collect();
    if rest.is_empty() {
        return Some(found);
    }
    found.judged.evidence = format!("where {words}: {}", found.judged.evidence);
    if rank(found.judged.verdict) == 2 {
        for (words, other) in rest {
            found.judged.evidence += &format!("; where {words}: {}", other.judged.evidence);
            found.has_inside = match other.judged.verdict {
                // in such a case nothing is stated
                Verdict::Undefined => false,
                _ => found.has_inside || other.has_inside,
            };
            for line in other.judged.requires.into_iter().filter(|_| other.judged.verdict != Verdict::Undefined) {
                if !found.judged.requires.contains(&line) {
                    found.judged.requires.push(line);
                }
            }
            for objection in other.judged.objections {
                if !found.judged.objections.contains(&objection) {
                    found.judged.objections.push(objection);
                }
            }
        }
    }
    Some(found)
}
