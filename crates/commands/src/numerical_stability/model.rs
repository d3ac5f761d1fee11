//! Numerical stability of methods at the steady motions of a system that is defined in its file.

use super::{Args, method};
use crate::arguments::Format;
use crate::exit::{Exit, print, warn};
use crate::stationary::combinations::{Combination, Combinations};
use crate::stationary::steady_box::Found;
use crate::stationary::verdict::singular;
use ::scenes::linearisation::{Standing, VariedEquations, law_at_rest};
use ::scenes::steady_motions::{SteadyMotion, SteadyStability, keeps_energy_near_rest};
use mechanics::one_step_stability::Mode;
use model::Model;
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::fmt::Write;
use studies::numerical_stability::chart::{Row, rows};
use studies::numerical_stability::modes::modes;

/// A steady motion with its linear equations.
struct Judged<'a> {
    motion: &'a SteadyMotion,
    /// The linear equations, or the reason for which there are none.
    near: Result<Near, String>,
}

/// The linear equations about a steady motion.
struct Near {
    /// Real and imaginary parts of the eigenvalues, 1/s.
    eigenvalues: Vec<[f64; 2]>,
    /// The number of zero eigenvalues, which are not in `eigenvalues`.
    zeros: usize,
    modes: Vec<Mode>,
    rows: Vec<Row>,
}

/// Prints the verdicts of all methods at all steady motions.
pub(super) fn show(asked: &Args) -> Result<Exit, Exit> {
    let given = [("--omega0", asked.omega0.is_some()), ("--model", asked.model.is_some())];
    if let Some((option, _)) = given.iter().find(|(_, is_given)| *is_given) {
        return Err(Exit::refused(format!(
            "{option} is about the built-in machines; of a system that is written in its file --range NAME=FROM..TO says where motions are sought"
        )));
    }
    let system = asked.steady.system_in(&asked.scene)?;
    let Some(parts) = Combinations::of(&asked.steady, &asked.scene, &system)? else {
        let found = asked.steady.find(&asked.scene, system)?;
        let all = judged(asked, &found, (&found.model, false));
        print(&match asked.format {
            Format::Text => format!("{}\n{}", found.title, text(&found, &all)),
            Format::Json => {
                let mut own = json!({ "scene": found.title });
                own.as_object_mut().into_iter().for_each(|own| own.extend(object(&found, &all)));
                format!("{own:#}\n")
            }
        })?;
        return Ok(asked.steady.ended(&asked.scene, &found.motions));
    };
    let Combinations { title, count, kind, filled } = parts;
    let (mut out, mut objects, mut last) = (format!("{title}\n"), Vec::new(), Exit::Done);
    for Combination { held, is_at_condition, found, law } in filled {
        let all = judged(asked, &found, (&law, is_at_condition));
        // writing to a String cannot fail
        let heading = if held.is_empty() { String::new() } else { format!("where {}\n", held.join(", ")) };
        let _ = write!(out, "\n{heading}{}", text(&found, &all));
        let mut own = object(&found, &all);
        own.insert("where".to_owned(), json!(held));
        objects.push(own);
        if let Exit::Stopped = asked.steady.ended(&asked.scene, &found.motions) {
            last = Exit::Stopped;
        }
    }
    if objects.is_empty() {
        let all = if count == 1 { kind.one().to_owned() } else { format!("any of {count} {}", kind.many()) };
        let _ = writeln!(out, "\nno steady motion in {all}");
    }
    print(&match asked.format {
        Format::Text => out,
        Format::Json => format!("{:#}\n", json!({ "scene": title, "combinations": count, "cases": objects })),
    })?;
    Ok(last)
}

/// The steady motions of a search with their linear equations.
fn judged<'a>(asked: &Args, found: &'a Found, (law, is_at_condition): (&Model, bool)) -> Vec<Judged<'a>> {
    if !found.motions.families.is_empty() {
        warn(&format!(
            "warning: {}: families of connected steady motions are left out: {}; `stationary` lists them, and a value for one of their \
             unknowns (--range NAME=VALUE) selects a motion",
            asked.scene.display(),
            found.motions.families.len()
        ));
    }
    let equations = VariedEquations::of(law, &[]).map_err(|why| why.to_string());
    // at a condition of the law there are linear equations only if the first derivatives of the law are continuous
    let is_kink = |motion: &SteadyMotion| {
        (is_at_condition || matches!(motion.stability, SteadyStability::AtCondition(_)))
            && !matches!(
                motion.stability,
                SteadyStability::Linear(_)
                    | SteadyStability::InTouch(_)
                    | SteadyStability::MinimumWithLoss
                    | SteadyStability::Minimum
                    | SteadyStability::Falls(_)
                    | SteadyStability::FallsOdd(_)
            )
    };
    let keeps_energy = found.motions.have_potential || ::scenes::keeps_energy(law);
    let near_motion = |motion: &SteadyMotion| match law_at_rest(law, &motion.state) {
        // terms without derivatives at rest, which fall faster than the speeds
        Cow::Owned(law) => {
            let equations = VariedEquations::of(&law, &[]).map_err(|why| why.to_string())?;
            near(&equations, motion, || keeps_energy || keeps_energy_near_rest(&law))
        }
        Cow::Borrowed(law) => {
            let rests = motion.state[law.positions()..].iter().all(|speed| *speed == 0.0);
            let is_kept = || keeps_energy || rests && keeps_energy_near_rest(law);
            near(equations.as_ref().map_err(Clone::clone)?, motion, is_kept)
        }
    };
    let judged = |motion: &'a SteadyMotion| Judged {
        motion,
        near: match &motion.stability {
            SteadyStability::Singular(names) => Err(singular(names)),
            _ if is_kink(motion) => {
                Err("a condition of the law is zero there, and the law is different on each side".to_owned())
            }
            _ => near_motion(motion),
        },
    };
    found.motions.motions.iter().map(judged).collect()
}

fn near(
    equations: &VariedEquations,
    motion: &SteadyMotion,
    keeps_energy: impl FnOnce() -> bool,
) -> Result<Near, String> {
    let linear = equations.about(0.0, &motion.state).map_err(|why| why.to_string())?;
    let eigenvalues = match linear.standing {
        Standing::Moving => without_cyclic(motion)?,
        _ => linear.eigenvalues,
    };
    let (modes, zeros) = modes(&eigenvalues, keeps_energy())?;
    if modes.is_empty() {
        return Err("every eigenvalue of the linear equations is zero: they decide nothing".to_owned());
    }
    Ok(Near { rows: rows(&modes), zeros, modes, eigenvalues })
}

/// The eigenvalues of the linear equations without cyclic coordinates, as centres of enclosing discs. Along a motion in which cyclic coordinates
/// change, only these equations are constant.
fn without_cyclic(motion: &SteadyMotion) -> Result<Vec<[f64; 2]>, String> {
    let (SteadyStability::Linear(found) | SteadyStability::InTouch(found)) = &motion.stability else {
        return Err("the linear equations change along the motion".to_owned());
    };
    let enclosed = found.enclosed.as_ref().map_err(|why| format!("eigenvalues are not enclosed, since {why}"))?;
    let others = enclosed.discs.iter().flat_map(|disc| std::iter::repeat_n(disc.centre, disc.count));
    Ok(std::iter::repeat_n([0.0; 2], enclosed.zeros.len()).chain(others).collect())
}

/// A sentence on the signs of the real parts of the eigenvalues.
fn does(Near { modes, zeros, .. }: &Near) -> String {
    let count =
        |sign: i32| -> usize { modes.iter().filter(|mode| mode.place.sign() == sign).map(|mode| mode.count).sum() };
    let verdict = match (count(1), count(0)) {
        (0, 0) => "every eigenvalue has a negative real part".to_owned(),
        (0, staying) => format!("no eigenvalue has a positive real part, {staying} are imaginary"),
        (1, _) => "one eigenvalue has a positive real part".to_owned(),
        (growing, _) => format!("{growing} eigenvalues have positive real parts"),
    };
    match zeros {
        0 => verdict,
        zeros => format!("{verdict}; {zeros} more are zero, and left out"),
    }
}

fn text(found: &Found, all: &[Judged<'_>]) -> String {
    let mut out = String::new();
    // writing to a String cannot fail
    let _ = match (all.len(), found.motions.families.len()) {
        (0, 0) => writeln!(out, "\nno steady motion"),
        (_, 0) => Ok(()),
        (_, 1) => {
            writeln!(out, "\none family of connected steady motions, left out: methods are judged on isolated ones")
        }
        (_, families) => {
            writeln!(
                out,
                "\n{families} families of connected steady motions, left out: methods are judged on isolated ones"
            )
        }
    };
    for (place, Judged { motion, near }) in all.iter().enumerate() {
        // writing to a String cannot fail
        let _ = writeln!(out, "\n{}  {}", place + 1, found.values(&motion.enclosure));
        match near {
            Err(why) if matches!(motion.stability, SteadyStability::Singular(_)) => drop(writeln!(out, "   {why}")),
            Err(why) => drop(writeln!(out, "   not known: {why}")),
            Ok(near) => {
                let _ = writeln!(out, "   {}", does(near));
                let each = near.modes.iter().map(|mode| match mode.place.point() {
                    [re, 0.0] => format!("{re:.10}"),
                    [0.0, im] => format!("±{im:.10}i"),
                    [re, im] => format!("{re:.10} ± {im:.10}i"),
                });
                let _ = writeln!(out, "   eigenvalues, 1/s: {}", each.collect::<Vec<_>>().join(", "));
                for row in &near.rows {
                    let _ = writeln!(out, "   {:<20} {}", row.method.to_string(), row.told());
                }
            }
        }
    }
    out
}

fn object(found: &Found, all: &[Judged<'_>]) -> Map<String, Value> {
    let each = all.iter().map(|Judged { motion, near }| {
        let values = found.motions.unknowns.iter().zip(&motion.enclosure);
        let near = near.as_ref();
        json!({
            "motion": values.map(|(unknown, at)| (unknown.name.clone(), json!(at))).collect::<Map<_, _>>(),
            "does": near.map(does).unwrap_or_else(|why| format!("not known: {why}")),
            "eigenvalues": near.ok().map(|near| &near.eigenvalues),
            "methods": near.map(|near| near.rows.iter().map(method).collect::<Vec<_>>()).unwrap_or_default(),
        })
    });
    let complete = ("complete".to_owned(), json!(found.motions.is_complete()));
    [complete, ("motions".to_owned(), json!(each.collect::<Vec<_>>()))].into_iter().collect()
}
