//! What differs from member to member, and how: the table `[ensemble]` of a scene.

use super::draw::Draw;
use super::known::{Data, Known, Place};
use crate::scene::Scene;
use crate::scene::issue::Issue;
use crate::scene::read::{At, Table};
use std::borrow::Cow;
use std::slice::from_mut;

/// More members than anyone has waited for.
const MOST: usize = 100_000_000;

/// A datum that varies.
#[derive(Clone, Debug)]
pub struct Varied {
    /// As the file names it, with its table.
    pub name: String,
    pub place: Place,
    unit: Cow<'static, str>,
    law: Law,
}

/// How a datum varies, component by component.
#[derive(Clone, Debug, PartialEq)]
enum Law {
    Even {
        from: Vec<f64>,
        to: Vec<f64>,
    },
    Normal {
        mean: Vec<f64>,
        deviation: Vec<f64>,
    },
    /// For each member its own.
    Listed {
        all: Vec<f64>,
        components: usize,
    },
}

/// The head of the table, and what varies.
#[derive(Clone, Debug)]
pub struct Variation {
    pub members: u64,
    pub seed: u64,
    pub varied: Vec<Varied>,
}

/// Reads the table `[ensemble]`.
pub fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>, scene: Option<&Scene>) -> Option<Variation> {
    let mut table = top.table("ensemble", "members, seed, and in [ensemble.vary] what varies");
    let members = table.count("members", "number of members", 1, MOST);
    let seed = table.optional_count("seed", "seed of the random numbers", 0, u32::MAX as usize);
    let mut vary = table.table("vary", "what varies, such as machine.b0 = { from = \"0.1 N m\", to = \"0.2 N m\" }");
    let mut varied = Vec::new();
    match scene {
        // what may vary depends on the scene
        None => vary.known_all(),
        Some(scene) => {
            for (name, known) in Known::of(scene) {
                if name.is_empty() {
                    varied
                        .extend(known.iter().filter_map(|known| datum(&mut vary, issues, name, known, members.value)));
                } else if let Some(mut inner) = vary.optional_table(name) {
                    varied
                        .extend(known.iter().filter_map(|known| datum(&mut inner, issues, name, known, members.value)));
                    issues.extend(inner.finish());
                }
            }
            if varied.is_empty() && vary.exists() && issues.is_empty() && !vary.has_issues() {
                let issue = Issue::at(vary.span(), "nothing varies", "no datum is named here");
                vary.report(
                    issue
                        .accepted("rotor.axial = { from = \"1 g cm^2\", to = \"2 g cm^2\" } is accepted, and the like"),
                );
            }
        }
    }
    let sound = table.exists() && vary.exists() && !vary.has_issues() && !table.has_issues();
    issues.extend(vary.finish());
    issues.extend(table.finish());
    sound.then(|| Variation { members: members.value as u64, seed: seed.map_or(1, |seed| seed.value as u64), varied })
}

/// `{ from, to }`, `{ mean, deviation }` or `{ values }`.
fn datum(table: &mut Table<'_>, issues: &mut Vec<Issue>, group: &str, known: &Known, members: usize) -> Option<Varied> {
    let Known { key, meaning, unit, components, place } = known;
    let (components, place) = (*components, *place);
    let mut law = table.optional_table(key)?;
    let row = |law: &mut Table<'_>, which| law.optional_row(which, meaning, components, unit);
    let [from, to, mean, deviation] = ["from", "to", "mean", "deviation"].map(|which| row(&mut law, which));
    let listed = match components {
        1 => law.optional_rows("values", meaning, 1, members, unit),
        _ => law.optional_rows("values", meaning, members, components, unit),
    };
    let read = match (from, to, mean, deviation, listed) {
        (Some(from), Some(to), None, None, None) => ordered(&mut law, from, to),
        (None, None, Some(mean), Some(deviation), None) => {
            if deviation.value.iter().any(|deviation| *deviation < 0.0) {
                let issue = Issue::at(deviation.span, "a deviation is negative", "below zero");
                law.report(issue.accepted("zero or a positive number is accepted"));
            }
            Some(Law::Normal { mean: mean.value, deviation: deviation.value })
        }
        (None, None, None, None, Some(At { value: all, .. })) => Some(Law::Listed { all, components }),
        _ => {
            if !law.has_issues() {
                let issue = Issue::at(law.span(), format!("how `{key}` varies is not said"), "in this table");
                law.report(issue.accepted(
                    "one of these is accepted: { from, to } for even numbers, { mean, deviation } for normal ones, \
                     { values } for one of each member",
                ));
            }
            None
        }
    };
    issues.extend(law.finish());
    let name = if group.is_empty() { key.to_string() } else { format!("{group}.{key}") };
    Some(Varied { name, place, unit: unit.clone(), law: read? })
}

fn ordered(law: &mut Table<'_>, from: At<Vec<f64>>, to: At<Vec<f64>>) -> Option<Law> {
    if from.value.iter().zip(&to.value).any(|(from, to)| from > to) {
        let issue = Issue::at(to.span, "`to` is less than `from`", "less than `from`");
        law.report(issue.accepted("a number that is not less is accepted, for each component"));
    }
    Some(Law::Even { from: from.value, to: to.value })
}

impl Varied {
    /// The names of its components.
    pub fn columns(&self) -> Vec<String> {
        let tensor = ["11", "12", "13", "22", "23", "33"];
        match self.components() {
            1 => vec![self.name.clone()],
            6 if self.name == "carrier.inertia" => tensor.iter().map(|ij| format!("{}.{ij}", self.name)).collect(),
            count => (1..=count).map(|i| format!("{}.{i}", self.name)).collect(),
        }
    }

    /// The unit of each component.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Its name and distribution, as a text; of listed values their number for each member alone, since an ensemble may grow.
    pub fn distribution(&self) -> String {
        match &self.law {
            Law::Listed { components, .. } => format!("{} listed {components}", self.name),
            law => format!("{} {law:?}", self.name),
        }
    }

    fn components(&self) -> usize {
        match &self.law {
            Law::Even { from, .. } => from.len(),
            Law::Normal { mean, .. } => mean.len(),
            Law::Listed { components, .. } => *components,
        }
    }

    /// The numbers of a member; members are counted from one.
    pub fn drawn(&self, seed: u64, member: u64) -> Vec<f64> {
        let draw = Draw::new(seed, member, &self.name);
        let mut drawn: Vec<f64> = match &self.law {
            Law::Even { from, to } => {
                from.iter().zip(to).enumerate().map(|(i, (from, to))| from + (to - from) * draw.even(i)).collect()
            }
            Law::Normal { mean, deviation } => {
                mean.iter().zip(deviation).enumerate().map(|(i, (mean, d))| mean + d * draw.normal(i)).collect()
            }
            Law::Listed { all, components } => {
                let rows = all.chunks(*components).skip(member.saturating_sub(1) as usize);
                rows.take(1).flatten().copied().collect()
            }
        };
        // a direction has length one, whatever was drawn
        if matches!(self.name.as_str(), "rotor.axis" | "start.vertical") {
            let length = drawn.iter().map(|x| x * x).sum::<f64>().sqrt();
            drawn.iter_mut().for_each(|x| *x /= length);
        }
        drawn
    }

    /// Puts its numbers where they belong.
    pub fn put(&self, drawn: &[f64], data: &mut Data) {
        let place = match self.place {
            Place::Bodies(of) => of(&mut data.system).unwrap_or_default(),
            Place::Machine(i) => data.machine.get_mut(i).map(from_mut).unwrap_or_default(),
            Place::Start(of) => of(&mut data.start),
        };
        match (drawn, place.len()) {
            (&[a, b, c, d, e, f], 9) => place.copy_from_slice(&[a, b, c, b, d, e, c, e, f]),
            _ => place.iter_mut().zip(drawn).for_each(|(place, drawn)| *place = *drawn),
        }
    }
}
