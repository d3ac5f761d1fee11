//! Distributions of the numbers that vary between members: the table `[ensemble]` of a scene.

use super::draw::Draw;
use super::parametric_system::{Drawn, Shape, Variable};
use reader::{At, Issue, Table};
use std::borrow::Cow;
use std::ops::Range;

/// The largest number of members.
const MOST: usize = 100_000_000;

/// A variable with its distribution.
#[derive(Clone, Debug)]
pub struct Varied {
    /// The name in the file, with its table.
    pub name: String,
    /// The index among all variables.
    variable: usize,
    unit: Cow<'static, str>,
    shape: Shape,
    law: Law,
}

/// The distribution of a datum, by component.
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
    /// Listed values, one for each member.
    Listed {
        all: Vec<f64>,
        components: usize,
    },
}

/// The content of the table `[ensemble]`: number of members, seed, and distributions.
#[derive(Clone, Debug)]
pub struct Variation {
    pub members: u64,
    pub seed: u64,
    pub varied: Vec<Varied>,
}

/// Reads the table `[ensemble]` of a scene. `variables` is `None` where the scene is faulty and its variables are
/// unknown. `example` shows the accepted form in messages. Faults are added to `issues`.
pub fn read(
    top: &mut Table<'_>,
    issues: &mut Vec<Issue>,
    variables: Option<&[Variable]>,
    example: &str,
) -> Option<Variation> {
    let mut table = top.table("ensemble", "members, seed, and in [ensemble.vary] the values that vary");
    if !table.exists() {
        issues.extend(table.finish());
        return None;
    }
    let members = table.count("members", "number of members", 1, MOST);
    let seed = table.optional_count("seed", "seed of the random numbers", 0, u32::MAX as usize);
    let mut vary = table.table("vary", &format!("what varies, such as {example}"));
    let mut varied = Vec::new();
    match variables {
        None => vary.known_all(),
        Some(variables) => {
            let numbered: Vec<(usize, &Variable)> = variables.iter().enumerate().collect();
            for group in numbered.chunk_by(|(_, one), (_, other)| one.table == other.table) {
                let name = group[0].1.table;
                let mut read = |table: &mut Table<'_>, issues: &mut Vec<Issue>| {
                    varied.extend(group.iter().filter_map(|known| datum(table, issues, *known, members.value)));
                };
                if name.is_empty() {
                    read(&mut vary, issues);
                } else if let Some(mut inner) = vary.optional_table(name) {
                    read(&mut inner, issues);
                    issues.extend(inner.finish());
                }
            }
            if varied.is_empty() && vary.exists() && issues.is_empty() && !vary.has_issues() {
                let issue = Issue::at(vary.span(), "nothing varies", "no datum is named here");
                vary.report(issue.accepted(format!("an entry such as {example} is accepted")));
            }
        }
    }
    let sound = table.exists() && vary.exists() && !vary.has_issues() && !table.has_issues();
    issues.extend(vary.finish());
    issues.extend(table.finish());
    sound.then(|| Variation { members: members.value as u64, seed: seed.map_or(1, |seed| seed.value as u64), varied })
}

/// The keys of a distribution.
const KEYS: [&str; 5] = ["from", "to", "mean", "deviation", "values"];

/// Reads `{ from, to }`, `{ mean, deviation }` or `{ values }`.
fn datum(
    table: &mut Table<'_>,
    issues: &mut Vec<Issue>,
    (place, variable): (usize, &Variable),
    members: usize,
) -> Option<Varied> {
    let Variable { key, meaning, unit, shape, .. } = variable;
    let components = shape.components();
    let not_said = |span: Range<usize>| {
        Issue::at(span, format!("how `{key}` varies is not said"), "here").accepted(
            "one of these is accepted: { from, to } for even numbers, { mean, deviation } for normal ones, { values } for one of each \
             member",
        )
    };
    if let (Some(place), false) = (table.place_of(key), table.is_table(key)) {
        table.known(&[key]);
        table.report(not_said(place));
        return None;
    }
    let mut law = table.optional_table(key)?;
    let meaning = &format!("a value for the {meaning}");
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
            // an unknown key explains a missing one
            if !law.has_issues() && law.keys().iter().all(|found| KEYS.contains(&found.value.as_str())) {
                law.report(not_said(law.span()));
            }
            None
        }
    };
    issues.extend(law.finish());
    Some(Varied { name: variable.name(), variable: place, unit: unit.clone(), shape: *shape, law: read? })
}

fn ordered(law: &mut Table<'_>, from: At<Vec<f64>>, to: At<Vec<f64>>) -> Option<Law> {
    if !law.has_issues() && from.value.iter().zip(&to.value).any(|(from, to)| from > to) {
        let issue = Issue::at(to.span, "`to` is less than `from`", "less than `from`");
        law.report(issue.accepted("a number that is not less is accepted, for each component"));
    }
    Some(Law::Even { from: from.value, to: to.value })
}

impl Varied {
    /// The names of the components.
    pub fn columns(&self) -> Vec<String> {
        let tensor = ["11", "12", "13", "22", "23", "33"];
        match self.shape {
            Shape::Numbers(1) => vec![self.name.clone()],
            Shape::SymmetricTensor => tensor.iter().map(|ij| format!("{}.{ij}", self.name)).collect(),
            other => (1..=other.components()).map(|i| format!("{}.{i}", self.name)).collect(),
        }
    }

    /// The unit of each component.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// The name and the distribution as text, for the fingerprint. Listed values are omitted, since an ensemble may be
    /// extended.
    pub fn distribution(&self) -> String {
        match &self.law {
            Law::Listed { components, .. } => format!("{} listed {components}", self.name),
            law => format!("{} {law:?}", self.name),
        }
    }

    /// The drawn values of a member; members are counted from one.
    pub fn drawn(&self, seed: u64, member: u64) -> Drawn {
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
        if self.shape == Shape::Direction {
            let length = drawn.iter().map(|x| x * x).sum::<f64>().sqrt();
            drawn.iter_mut().for_each(|x| *x /= length);
        }
        Drawn { variable: self.variable, numbers: drawn }
    }
}
