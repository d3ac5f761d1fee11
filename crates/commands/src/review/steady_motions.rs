//! Changes of the steady motions of a system.

use super::renamed_coordinates::{Renamed, with_new_names};
use crate::clock;
use crate::exit::warn;
use crate::stationary::combinations::Combinations;
use crate::stationary::refusals::reason;
use crate::stationary::steady_box::{Found, SoughtSystem, sought};
use crate::stationary::verdict::verdict;
use ::scenes::SystemText;
use ::scenes::steady_motions::{Range, SteadyMotions, SteadySearch};

/// The largest number of boxes in a search for steady motions.
const MOST_BOXES: usize = 50_000;

/// Steady motions that were added or removed, that moved, or whose stability changed.
pub(super) fn changes(texts: &[SystemText; 2], ranges: &[(String, Range)], renamed: &Renamed) -> Vec<String> {
    let asked = SteadySearch { ranges: ranges.to_vec(), boxes: MOST_BOXES, ..SteadySearch::default() };
    let [old, new] = match [found(&texts[0], &asked), found(&texts[1], &asked)] {
        [Ok(old), Ok(new)] => [old, new],
        [Err(why), _] => return not_compared(&texts[0].name, &why),
        [_, Err(why)] => return not_compared(&texts[1].name, &why),
    };
    for (text, found) in texts.iter().zip([&old, &new]).filter(|(_, found)| found.undecided > 0) {
        let SearchedMotions { undecided, .. } = found;
        warn(&format!("warning: {}: the search for steady motions leaves {undecided} boxes undecided", text.name));
    }
    let old: Vec<String> = old.told.iter().map(|one| with_new_names(one, renamed)).collect();
    let new = new.told;
    let without = |these: &[String], those: &[String]| -> Vec<String> {
        these.iter().filter(|one| !those.contains(one)).cloned().collect()
    };
    let (gone, come) = (without(&old, &new), without(&new, &old));
    match gone.len() == come.len() {
        true => gone.iter().zip(&come).map(|(old, new)| format!("{old} before; {new} now")).collect(),
        false => {
            let gone = gone.iter().map(|old| format!("gone: {old}"));
            gone.chain(come.iter().map(|new| format!("new: {new}"))).collect()
        }
    }
}

fn not_compared(name: &str, why: &str) -> Vec<String> {
    warn(&format!("warning: steady motions are not compared: {name}: {why}"));
    Vec::new()
}

/// The steady motions that a search found, in words, and the number of undecided boxes.
struct SearchedMotions {
    told: Vec<String>,
    undecided: usize,
}

/// The steady motions of a text, for all combinations of the cases of its law.
fn found(text: &SystemText, asked: &SteadySearch) -> Result<SearchedMotions, String> {
    let system = sought(text).map_err(|error| error.to_string())?;
    let parts = Combinations::of_system(&system, asked, clock::has_time).map_err(|issue| issue.title)?;
    let (title, model, source): SoughtSystem = system;
    let Some(parts) = parts else {
        let motions = SteadyMotions::of(&model, asked, clock::has_time);
        let motions = motions.map_err(|why| reason(&model, Some(&source), why).title)?;
        let found = Found { title, model, motions };
        return Ok(SearchedMotions { told: told(&found, ""), undecided: found.motions.undecided.len() });
    };
    let each = parts.filled.iter().flat_map(|part| told(&part.found, &part.held.join(", ")));
    let undecided = parts.filled.iter().map(|part| part.found.motions.undecided.len()).sum();
    Ok(SearchedMotions { told: each.collect(), undecided })
}

/// A sentence for each motion with its verdict and, where the law has cases, the case in which it lies.
fn told(found: &Found, case: &str) -> Vec<String> {
    let case = if case.is_empty() { String::new() } else { format!(" ({case})") };
    let each = found.motions.motions.iter();
    each.map(|motion| {
        format!("{}{case}: {}", found.values(&motion.enclosure), verdict(motion, &found.motions.cyclic).0)
    })
    .collect()
}
