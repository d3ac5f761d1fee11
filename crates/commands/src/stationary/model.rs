//! Steady motions of a system that is defined in its file.

use super::combinations::Combinations;
use super::families::{count, ends, family_lines, family_object, is_one_place};
use super::refusals::reason;
use super::steady_box::{Found, number, sought};
use super::verdict::{stability, verdict};
use super::{Args, cases};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::spectrum;
use ::scenes::steady_motions::{Near, Region, SteadyMotion, SteadyMotions, SteadySearch, SteadyStability};
use ::scenes::{SystemText, unit_of};
use reader::{Issue, SceneError};
use serde_json::{Value, json};
use std::fmt::Write;

/// The largest number of undecided regions that are listed; the others are counted.
const MOST_LISTED: usize = 6;

/// Prints all steady motions.
pub(super) fn show(asked: &Args) -> Result<Exit, Exit> {
    let system = asked.steady.system_in(&asked.scene)?;
    if let Some(parts) = Combinations::of(&asked.steady, &asked.scene, &system)? {
        return cases::show(asked, &parts);
    }
    let found = asked.steady.find(&asked.scene, system)?;
    print(&match asked.format {
        Format::Text => text(&found),
        Format::Json => format!("{:#}\n", object(&found)),
    })?;
    Ok(asked.steady.ended(&asked.scene, &found.motions))
}

/// Steady motions as text and as JSON.
#[derive(Debug)]
pub struct SteadyMotionsResult {
    pub text: String,
    pub object: Value,
}

/// The steady motions of a system in a text, for all combinations of the cases of its law. The search ends once `has_time` returns false.
///
/// # Errors
/// The faults of the text, or the reason for which steady motions of this system are not searched for.
pub fn steady_motions(
    text: &SystemText,
    asked: &SteadySearch,
    has_time: impl Fn() -> bool + Copy + Sync,
) -> Result<SteadyMotionsResult, SceneError> {
    let system = sought(text)?;
    let name = &text.name;
    let fault = |issue: Issue| {
        let text = if issue.span.is_some() { text.text.clone() } else { String::new() };
        SceneError { path: name.clone(), text, issues: vec![issue] }
    };
    if let Some(parts) = Combinations::of_system(&system, asked, has_time).map_err(fault)? {
        let (text, object) = cases::told(&parts);
        return Ok(SteadyMotionsResult { text, object });
    }
    let (title, model, source) = &system;
    let motions = SteadyMotions::of(model, asked, has_time).map_err(|why| fault(reason(model, Some(source), why)))?;
    let found = Found { title: title.clone(), model: model.clone(), motions };
    Ok(SteadyMotionsResult { text: self::text(&found), object: object(&found) })
}

fn text(all: &Found) -> String {
    format!("{}\n{}", all.title, body(all))
}

/// The steady motions as text, without the title.
pub(super) fn body(all: &Found) -> String {
    let (found, mut out) = (&all.motions, String::new());
    let unit = |name: &str| all.unit(name);
    // writing to a String cannot fail
    for unknown in &found.unknowns {
        let range = unknown.range;
        let _ = match unknown.is_circle {
            true => writeln!(out, "sought: {}, the whole circle", unknown.name),
            false => {
                writeln!(
                    out,
                    "sought: {} from {} to {}{}",
                    unknown.name,
                    number(range.from),
                    number(range.to),
                    unit(&unknown.name)
                )
            }
        };
    }
    for (name, value) in &found.given {
        let _ = writeln!(out, "given: {name} = {}{}", number(*value), unit(name));
    }
    let (by_values, always): (Vec<String>, Vec<String>) =
        found.cyclic.iter().cloned().partition(|name| found.cyclic_by_values.contains(name));
    if !always.is_empty() {
        let _ = writeln!(out, "cyclic, nothing depends on them: {}", always.join(", "));
    }
    if !by_values.is_empty() {
        let _ = writeln!(
            out,
            "cyclic at these values of the parameters alone, nothing depends on them: {}",
            by_values.join(", ")
        );
    }
    let open = found.families.iter().filter(|(family, _)| is_one_place(found, family)).count();
    let is_singular = |motion: &&SteadyMotion| matches!(motion.stability, SteadyStability::Singular(_));
    let singular = found.motions.iter().filter(is_singular).count();
    let counts = [found.motions.len() - singular, singular, open, found.families.len() - open];
    let count = count(counts, found.is_complete());
    let boxes = if found.examined == 1 { "one box".to_owned() } else { format!("{} boxes", found.examined) };
    let branches: Vec<String> =
        all.model.implied.iter().filter(|one| one.branch.is_some()).map(|one| one.title.clone()).collect();
    let _ = match found.is_complete() {
        _ if found.elsewhere > 0 && found.is_complete() => writeln!(
            out,
            "\n{count}; the search over {boxes} left undecided boxes where a condition is zero, which are reported where that condition may have any \
             sign"
        ),
        true if !branches.is_empty() => writeln!(
            out,
            "\n{count}; for positions near the start {} from other constraints, and there is no other motion on this branch; other branches are not \
             searched",
            if branches.len() == 1 {
                format!("{} follows", branches[0])
            } else {
                format!("{} follow", branches.join(", "))
            }
        ),
        true if found.motions.is_empty() && found.families.is_empty() => {
            writeln!(out, "\n{count} (complete search over {boxes})")
        }
        true => writeln!(out, "\n{count}; there are no others (complete search over {boxes})"),
        false => writeln!(
            out,
            "\n{count}; the search over {boxes} left {} undecided ({} of the whole range), which may contain further motions",
            if found.undecided.len() == 1 { "one box".to_owned() } else { format!("{} boxes", found.undecided.len()) },
            part(found.undecided_part)
        ),
    };
    for (place, motion) in found.motions.iter().enumerate() {
        let values = all.values(&motion.enclosure);
        let values = if values.is_empty() { "as given".to_owned() } else { values };
        let _ = writeln!(out, "  {}  {values}", place + 1);
        let _ = writeln!(out, "     {}", stability(motion, found));
    }
    if !found.motions.is_empty() && !found.free_speeds.is_empty() {
        let _ = writeln!(
            out,
            "  each belongs to a family: there is such a motion for every value of {} near these",
            found.free_speeds.join(", ")
        );
    }
    for (place, (family, members)) in found.families.iter().enumerate() {
        out += &family_lines(all, found.motions.len() + place + 1, family, members);
    }
    for region in found.regions.iter().take(MOST_LISTED) {
        let ranges = found.unknowns.iter().zip(&region.hull).map(|(unknown, at)| {
            let [low, high] = ends(*at);
            format!("{} from {low} to {high}{}", unknown.name, unit(&unknown.name))
        });
        let _ = writeln!(out, "  ?  {}", ranges.collect::<Vec<_>>().join(", "));
        let shown = if region.holds_one { "by enclosures there is at least one steady motion; " } else { "" };
        // a dependence of constraints is shown by bounds; all else here comes from Newton's method, without a proof
        let guess = if region.near == Near::Dependent { "" } else { "numerical guess without proof: " };
        let _ = writeln!(out, "     undecided boxes: {}; {shown}{guess}{}", region.boxes, near(region));
    }
    if found.regions.len() > MOST_LISTED {
        let _ =
            writeln!(out, "  ?  and {} other regions (--format json lists them)", found.regions.len() - MOST_LISTED);
    }
    out
}

/// A fraction of the search space as text, or a bound where it is below the range of double precision.
fn part(part: f64) -> String {
    if part < 1e-300 { "less than 1e-300".to_owned() } else { format!("{part:.1e}") }
}

fn near(region: &Region) -> String {
    let directions = |count: usize| if count == 1 { "one direction".to_owned() } else { format!("{count} directions") };
    match region.near {
        Near::Nothing => "no other steady motion is found in this region".to_owned(),
        Near::Undefined => {
            "the equations have no values somewhere in this region, for example where a distance is zero and a force has no direction".to_owned()
        }
        Near::Dependent => {
            "the constraints become dependent somewhere in this region, for example where bars lie in one line: reactions have no bounds, and more \
             boxes do not decide it"
                .to_owned()
        }
        Near::Regular => "there is at least one steady motion, which more boxes would show".to_owned(),
        Near::Merging(count) => format!(
            "a degenerate steady motion, or several that merge: the equations are singular in {}; more boxes do not decide it",
            directions(count)
        ),
        Near::Family(count) => format!("a family, which continues in {}", directions(count)),
    }
}

/// A steady motion as JSON.
pub(super) fn motion(found: &SteadyMotions, motion: &SteadyMotion) -> Value {
    let values = found.unknowns.iter().zip(&motion.enclosure).map(|(unknown, at)| (unknown.name.clone(), json!(at)));
    let (verdict, enclosed) = verdict(motion, &found.cyclic);
    let linear = match &motion.stability {
        SteadyStability::Linear(found) | SteadyStability::InTouch(found) => Some(found),
        _ => None,
    };
    let eigenvalues = linear.map(|found| &found.linear.eigenvalues);
    let discs = linear.and_then(|found| found.enclosed.as_ref().ok().map(spectrum::object));
    json!({
        "enclosure": values.collect::<serde_json::Map<_, _>>(),
        "state": motion.state,
        "quasi_velocities": motion.quasi_velocities.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<serde_json::Map<_, _>>(),
        "stability": verdict,
        "enclosed": enclosed,
        "reason": stability(motion, found),
        "eigenvalues": eigenvalues,
        "enclosed_eigenvalues": discs,
    })
}

pub(super) fn object(Found { title, model, motions: found }: &Found) -> Value {
    json!({
        "title": title,
        "sought": found.unknowns.iter().map(|unknown| json!({
            "name": unknown.name,
            "unit": unit_of(model, &unknown.name),
            "circle": unknown.is_circle,
            "range": [unknown.range.from, unknown.range.to],
        })).collect::<Vec<_>>(),
        "given": found.given.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<serde_json::Map<_, _>>(),
        "cyclic": found.cyclic,
        "cyclic_by_values": found.cyclic_by_values,
        "complete": found.is_complete() && found.elsewhere == 0 && model.implied.iter().all(|one| one.branch.is_none()),
        "boxes": found.examined,
        "undecided": found.undecided,
        "regions": found.regions.iter().map(|region| json!({
            "hull": region.hull,
            "boxes": region.boxes,
            "near": near(region),
            "holds_one": region.holds_one,
        })).collect::<Vec<_>>(),
        "undecided_part": found.undecided_part,
        "families": found.families.iter().map(|(family, members)| family_object(found, family, members)).collect::<Vec<_>>(),
        "free_speeds": found.free_speeds,
        "motions": found.motions.iter().map(|one| motion(found, one)).collect::<Vec<_>>(),
    })
}
