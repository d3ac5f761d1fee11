//! The search for steady motions in parts: for each combination of cases of the conditions of a law, and each set of angles of free frames.

use super::refusals::{reason, unsought};
use super::steady_box::{Found, SoughtSystem, SteadyBox};
use crate::clock::has_time;
use crate::exit::Exit;
use crate::progress::Progress;
use ::scenes::steady_motions::{Case, Orientation, SteadyMotions, SteadySearch, conditions_of, with_kept_contacts};
use model::Model;
use reader::Issue;
use std::borrow::Cow;
use std::path::Path;

/// The steady motions of a system, searched for in parts.
pub struct Combinations {
    pub title: String,
    /// The number of parts searched.
    pub count: usize,
    pub kind: Kind,
    /// The parts that have steady motions or undecided regions.
    pub filled: Vec<Combination>,
}

/// The criterion by which the search is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Conditions,
    Angles,
}

impl Kind {
    pub fn one(self) -> &'static str {
        match self {
            Kind::Conditions => "the one combination of its conditions",
            Kind::Angles => "the one set of angles",
        }
    }

    pub fn many(self) -> &'static str {
        match self {
            Kind::Conditions => "combinations of its conditions",
            Kind::Angles => "sets of angles",
        }
    }
}

/// A part of the search, with the motions that were found.
pub struct Combination {
    /// The conditions and the ranges of angles of the part, as texts.
    pub held: Vec<String>,
    /// Whether a condition is at its boundary, where the law has no linearisation.
    pub is_at_condition: bool,
    pub found: Found,
    /// The law in this part; without the contacts if no contact with friction is closed.
    pub law: Model,
}

impl Combinations {
    /// The parts of a system that was read from a file; `None` where its law has no conditions and no free frame.
    ///
    /// # Errors
    /// A name has two ranges or values, or steady motions of the system are not searched for; the message states the reason.
    pub fn of(steady: &SteadyBox, path: &Path, system: &SoughtSystem) -> Result<Option<Self>, Exit> {
        steady.checked()?;
        let _progress = Progress::new("steady motions");
        Combinations::of_system(system, &steady.wanted(), has_time).map_err(|issue| unsought(path, issue))
    }

    /// The parts of a system.
    ///
    /// # Errors
    /// The reason for which steady motions of the system are not searched for.
    pub fn of_system(
        (title, model, source): &SoughtSystem,
        asked: &SteadySearch,
        has_time: impl Fn() -> bool + Copy + Sync,
    ) -> Result<Option<Self>, Issue> {
        let changes = !model.switches.is_empty() || !model.contacts.is_empty();
        if !changes && model.free.is_empty() {
            return Ok(None);
        }
        let kind = if changes { Kind::Conditions } else { Kind::Angles };
        let mut all = Combinations { title: title.clone(), count: 0, kind, filled: Vec::new() };
        if model.free.is_empty() {
            let cases =
                SteadyMotions::of_cases(model, asked, has_time).map_err(|why| reason(model, Some(source), why))?;
            all.add(model, &[], cases);
            return Ok(Some(all));
        }
        let orientations = Orientation::all(source, model, asked).map_err(|why| reason(model, Some(source), why))?;
        let found =
            SteadyMotions::of_orientations(orientations, has_time).map_err(|why| reason(model, Some(source), why))?;
        for (orientation, cases) in found {
            let angles = orientation.in_words();
            all.add(&orientation.model, &angles, cases);
        }
        Ok(Some(all))
    }

    fn add(&mut self, model: &Model, angles: &[String], cases: Vec<(Vec<Case>, SteadyMotions)>) {
        self.count += cases.len();
        let conditions = conditions_of(model);
        // sets of angles are printed even without motions, with their ranges
        let is_told = |found: &SteadyMotions| conditions.is_empty() || !found.is_empty();
        let filled = cases.into_iter().filter(|(_, found)| is_told(found));
        self.filled.extend(filled.map(|(own, motions)| {
            let mut held: Vec<String> = angles.to_vec();
            for text in own.iter().zip(&conditions).filter_map(told) {
                if !held.contains(&text) {
                    held.push(text);
                }
            }
            let kept = with_kept_contacts(model, &own);
            // a closed contact without friction is a constraint, not a condition
            let conditions = if kept.is_some() { &own[..model.switches.len().min(own.len())] } else { &own[..] };
            Combination {
                held,
                is_at_condition: conditions
                    .iter()
                    .any(|case| !matches!(case, Case::Holds | Case::Fails | Case::Either)),
                law: kept.unwrap_or(Cow::Borrowed(model)).into_owned(),
                found: Found { title: self.title.clone(), model: model.clone(), motions },
            }
        }));
    }
}

/// The case of a condition as text; a sum of negative terms is replaced by its opposite.
fn told((case, text): (&Case, &String)) -> Option<String> {
    let opposite = positive(text);
    let (text, above, below) = match &opposite {
        Some(text) => (text, '<', '>'),
        None => (text, '>', '<'),
    };
    Some(match case {
        Case::Holds => format!("{text} {above} 0"),
        Case::Fails => format!("{text} {below} 0"),
        Case::Between | Case::Meeting => format!("{text} = 0"),
        Case::Forward => format!("{text} = 0, sliding along its tangent"),
        Case::Backward => format!("{text} = 0, sliding against its tangent"),
        Case::Either => return None,
    })
}

/// The opposite of a sum whose terms are all negative, as text; `None` for any other sum.
fn positive(text: &str) -> Option<String> {
    let mut depth = 0;
    let (mut out, mut before) = (String::new(), ' ');
    let rest = text.strip_prefix('-')?;
    for (at, c) in rest.char_indices() {
        depth += i32::from(c == '(' || c == '[') - i32::from(c == ')' || c == ']');
        let is_between = depth == 0 && before == ' ' && rest[at + 1..].starts_with(' ');
        match c {
            '+' if is_between => return None,
            '-' if is_between => out.push('+'),
            _ => out.push(c),
        }
        before = c;
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::{positive, told};
    use ::scenes::steady_motions::Case;

    #[test]
    fn a_negative_condition_is_told_by_its_opposite() {
        assert_eq!(positive("-x").as_deref(), Some("x"));
        assert_eq!(positive("-e - x*(y + 1)").as_deref(), Some("e + x*(y + 1)"));
        assert_eq!(positive("-x + e"), None);
        assert_eq!(positive("x - e"), None);
        let case = |case| told((&case, &"-x".to_owned()));
        assert_eq!(case(Case::Holds).as_deref(), Some("x < 0"));
        assert_eq!(case(Case::Meeting).as_deref(), Some("x = 0"));
    }
}
