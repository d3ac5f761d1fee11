//! Steady motions by parts: each combination of the cases of a law's conditions, and each set of angles of freely turning frames.

use super::steady_box::{Found, SoughtSystem, SteadyBox, reason, unsought};
use crate::clock::has_time;
use crate::exit::Exit;
use crate::progress::Progress;
use ::scenes::steady_motions::{Asked, Case, Orientation, SteadyMotions, conditions_of};
use model::Model;
use reader::Issue;
use std::path::Path;

/// Steady motions by parts.
pub struct Combinations {
    pub title: String,
    /// The number of parts that were searched.
    pub count: usize,
    /// The kind of part in words: a combination of conditions, or a set of angles.
    pub kind: &'static str,
    /// The parts with steady motions or undecided regions.
    pub filled: Vec<Combination>,
}

/// A part of the search, with the motions found.
pub struct Combination {
    /// The conditions and angles of the part, as texts.
    pub held: Vec<String>,
    /// Whether a condition is zero: then the law has no linearisation.
    pub is_at_condition: bool,
    pub found: Found,
}

impl Combinations {
    /// The parts for the system that was read from a file; `None` where its law has no conditions and no frame turns freely.
    pub fn of(steady: &SteadyBox, path: &Path, system: &SoughtSystem) -> Result<Option<Self>, Exit> {
        steady.checked()?;
        let _progress = Progress::new("steady motions");
        Combinations::of_system(system, &steady.wanted(), has_time).map_err(|issue| unsought(path, issue))
    }

    /// The parts for a system that was read already.
    ///
    /// # Errors
    /// The reason for which steady motions are not searched for.
    pub fn of_system(
        (title, model, source): &SoughtSystem,
        asked: &Asked,
        has_time: impl Fn() -> bool + Copy + Sync,
    ) -> Result<Option<Self>, Issue> {
        let changes = !model.switches.is_empty() || !model.contacts.is_empty();
        if !changes && model.free.is_empty() {
            return Ok(None);
        }
        let kind = if changes { "combinations of its conditions" } else { "sets of angles" };
        let mut all = Combinations { title: title.clone(), count: 0, kind, filled: Vec::new() };
        if model.free.is_empty() {
            let cases = SteadyMotions::of_cases(model, asked, has_time).map_err(|why| reason(model, why))?;
            all.add(model, &[], cases);
            return Ok(Some(all));
        }
        let orientations = Orientation::all(source, model, asked).map_err(|why| reason(model, why))?;
        let found = SteadyMotions::of_orientations(orientations, has_time).map_err(|why| reason(model, why))?;
        for (orientation, cases) in found {
            let angles = orientation.in_words();
            all.add(&orientation.model, &angles, cases);
        }
        Ok(Some(all))
    }

    fn add(&mut self, model: &Model, angles: &[String], cases: Vec<(Vec<Case>, SteadyMotions)>) {
        self.count += cases.len();
        let conditions = conditions_of(model);
        // sets of angles are always printed, with their ranges
        let is_told = |found: &SteadyMotions| conditions.is_empty() || !found.is_empty();
        let filled = cases.into_iter().filter(|(_, found)| is_told(found));
        self.filled.extend(filled.map(|(own, motions)| Combination {
            held: angles.iter().cloned().chain(own.iter().zip(&conditions).filter_map(told)).collect(),
            is_at_condition: own.iter().any(|case| !matches!(case, Case::Holds | Case::Fails | Case::Either)),
            found: Found { title: self.title.clone(), model: model.clone(), motions },
        }));
    }
}

fn told((case, text): (&Case, &String)) -> Option<String> {
    Some(match case {
        Case::Holds => format!("{text} > 0"),
        Case::Fails => format!("{text} < 0"),
        Case::Between | Case::Meeting => format!("{text} = 0"),
        Case::Forward => format!("{text} = 0, sliding along its tangent"),
        Case::Backward => format!("{text} = 0, sliding against its tangent"),
        Case::Either => return None,
    })
}
