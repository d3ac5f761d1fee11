//! The study of methods on all scenes: the cheapest choice for each scene, and the loss that a single choice for all scenes causes.
//!
//! A choice consists of a method, a formulation and a model. For a choice that applies to many scenes, the model is the scene's own, the
//! smallest one with the same motion, or a model with a given name.

use crate::speed::advice::advice;
use crate::speed::{Counted, Series, series};
use charts::{Study, Table, significant, tolerance};
use integrators::{Regrets, cost};
use simulation::Atlas;
use simulation::work_precision::{Configuration, Formulation, Standing};

/// The relative errors at which choices are compared.
const ERRORS: [f64; 3] = [1e-3, 1e-6, 1e-9];

type Scene<'a> = (&'a str, &'a Atlas);

/// The study: advice for each scene, the best single choices with their losses, and each method in its best configuration.
pub fn study(scenes: &[Scene<'_>]) -> Study {
    let has_motor = |scene: &&Scene<'_>| scene.1.explored.first().is_some_and(|one| !one.way.model.is_empty());
    let (driven, others): (Vec<Scene>, Vec<Scene>) = scenes.iter().partition(has_motor);
    let is_rough =
        |scene: &Scene| scene.1.explored.first().is_some_and(|one| one.way.formulation == Formulation::Contacts);
    let (rough, mechanisms): (Vec<Scene>, Vec<Scene>) = others.into_iter().partition(is_rough);
    let groups = [("scenes with a motor", driven), ("mechanisms", mechanisms), ("scenes with rough contacts", rough)]
        .map(|(name, scenes)| Group::of(name, scenes));
    let mut tables = vec![advised(scenes), single(&groups)];
    tables.extend(groups.iter().map(losses));
    tables.extend([ERRORS[1], ERRORS[2]].map(|error| methods(scenes, error)));
    Study {
        id: "atlas".into(),
        title: "The best method, formulation and model for each scene".into(),
        lead: "The cost of a choice at an error, read between its measured points, over the least cost of all choices: its \
               regret. A choice that was not seen to reach the error has none."
            .into(),
        tables,
        note: "Times are medians taken in turns within this run of the program; they belong to this machine, evaluations do \
               not. A run in time includes what a method sets up. Scenes without a reference are left out."
            .into(),
        ..Study::default()
    }
}

/// A choice: a method, a formulation, a model.
#[derive(Clone, Debug, PartialEq)]
struct Choice(String, Formulation, String);

impl Choice {
    fn name(&self) -> String {
        let Choice(method, formulation, model) = self;
        let with = if model.is_empty() { String::new() } else { format!(", {model}") };
        format!("{method}, {formulation}{with}")
    }
}

const OWN: &str = "the scene's own model";
const SMALLEST_EXACT: &str = "the smallest exact model";

/// The choices to which the runs of a configuration belong.
fn choices(method: &str, way: &Configuration, atlas: &Atlas) -> Vec<Choice> {
    // a motor alone has one form of its equations, which counts as both forms
    let formulations = match way.formulation {
        Formulation::Bench => vec![Formulation::First, Formulation::Second],
        other => vec![other],
    };
    let reduced = atlas.explored.iter().any(|one| one.way.standing == Standing::Exact);
    let models = match way.standing {
        _ if way.model.is_empty() => vec![String::new()],
        Standing::Own if reduced => vec![OWN.to_owned()],
        Standing::Own => vec![OWN.to_owned(), SMALLEST_EXACT.to_owned()],
        Standing::Exact => vec![SMALLEST_EXACT.to_owned()],
        Standing::Approximate => vec![way.model.replace('_', " ")],
    };
    let pairs = formulations.iter().flat_map(|form| models.iter().map(move |model| (*form, model.clone())));
    pairs.map(|(form, model)| Choice(method.to_owned(), form, model)).collect()
}

/// A group of scenes for which a single choice is made.
struct Group<'a> {
    name: &'static str,
    scenes: Vec<Scene<'a>>,
    choices: Vec<Choice>,
    /// For each scene, its series with the indices of their choices in `choices`.
    series: Vec<Vec<(Series<'a>, Vec<usize>)>>,
}

impl<'a> Group<'a> {
    fn of(name: &'static str, scenes: Vec<Scene<'a>>) -> Self {
        let mut all: Vec<Choice> = Vec::new();
        let mut place = |choice: Choice| {
            all.iter().position(|known| *known == choice).unwrap_or_else(|| {
                all.push(choice);
                all.len() - 1
            })
        };
        let mut of = |one: Series<'a>, atlas| {
            let places = choices(&one.family, one.way, atlas).into_iter().map(&mut place).collect();
            (one, places)
        };
        let of_scene = |(_, atlas): &Scene<'a>| series(atlas).into_iter().map(|one| of(one, atlas)).collect();
        let found = scenes.iter().map(of_scene).collect();
        Group { name, choices: all, series: found, scenes }
    }

    fn regrets(&self, counted: Counted, error: f64) -> Regrets {
        let of = |choice: usize, series: &[(Series<'_>, Vec<usize>)]| {
            let own = series.iter().find(|(_, places)| places.contains(&choice))?;
            cost(&own.0.trials(counted), error)
        };
        let row = |choice| self.series.iter().map(|series| of(choice, series)).collect();
        Regrets::of(&(0..self.choices.len()).map(row).collect::<Vec<_>>())
    }
}

fn shown(regret: Option<f64>) -> String {
    regret.map_or_else(|| "—".to_owned(), |regret| significant(regret, 2))
}

/// The table of advice, with one sentence for each scene.
fn advised(scenes: &[Scene<'_>]) -> Table {
    let row = |(title, atlas): &Scene<'_>| vec![(*title).to_owned(), advice(atlas, ERRORS[1])];
    Table {
        caption: "Advice".to_owned(),
        head: ["Scene", "The fastest, and the fastest by another method"].map(str::to_owned).to_vec(),
        rows: scenes.iter().map(row).collect(),
    }
}

/// The table of best single choices: those that work for most scenes, and among these the choice with the smallest maximal loss.
fn single(groups: &[Group<'_>]) -> Table {
    let mut rows = Vec::new();
    for group in groups {
        for error in ERRORS {
            for counted in Counted::ALL {
                let regrets = group.regrets(counted, error);
                let Some(best) = regrets.best_single_choice() else { continue };
                let served = format!("{} of {}", regrets.served(best), group.scenes.len());
                let choice = group.choices[best].name();
                let loss = shown(regrets.largest(best));
                rows.push(vec![
                    group.name.to_owned(),
                    tolerance(error),
                    counted.name().to_owned(),
                    choice,
                    served,
                    loss,
                ]);
            }
        }
    }
    let head = ["For all", "Error", "Counted in", "Choice", "Reaches it on", "Largest regret there"];
    Table { caption: "The best single choice".to_owned(), head: head.map(str::to_owned).to_vec(), rows }
}

/// The table of the losses of the best single choices on each scene.
fn losses(group: &Group<'_>) -> Table {
    let mut head = vec!["Scene".to_owned()];
    let mut rows: Vec<Vec<String>> = group.scenes.iter().map(|(title, _)| vec![(*title).to_owned()]).collect();
    for error in ERRORS {
        for counted in Counted::ALL {
            let regrets = group.regrets(counted, error);
            let Some(best) = regrets.best_single_choice() else { continue };
            head.push(format!("{}, {}", tolerance(error), counted.name()));
            rows.iter_mut().zip(&regrets.rows[best]).for_each(|(row, regret)| row.push(shown(*regret)));
        }
    }
    Table { caption: format!("Regret of the best single choice: {}", group.name), head, rows }
}

/// The table of methods, each in its best formulation with its best model: one row for each scene, one column for each method.
fn methods(scenes: &[Scene<'_>], error: f64) -> Table {
    let all: Vec<Vec<Series>> = scenes.iter().map(|(_, atlas)| series(atlas)).collect();
    let mut names: Vec<String> = Vec::new();
    for one in all.iter().flatten() {
        if !names.contains(&one.family) {
            names.push(one.family.clone());
        }
    }
    let least = |name: &String, series: &[Series<'_>]| {
        let own = series.iter().filter(|one| one.family == *name);
        own.filter_map(|one| cost(&one.trials(Counted::Time), error)).reduce(f64::min)
    };
    let costs = names.iter().map(|name| all.iter().map(|series| least(name, series)).collect());
    let regrets = Regrets::of(&costs.collect::<Vec<_>>());
    let row = |(column, (title, _)): (usize, &Scene<'_>)| -> Vec<String> {
        std::iter::once((*title).to_owned()).chain(regrets.rows.iter().map(|row| shown(row[column]))).collect()
    };
    let mut rows: Vec<Vec<String>> = scenes.iter().enumerate().map(row).collect();
    let largest = (0..names.len()).map(|method| shown(regrets.largest(method)));
    rows.push(std::iter::once("largest, where it reaches the error".to_owned()).chain(largest).collect());
    Table {
        caption: format!(
            "Regret in time at {}, each method in its best formulation with its best model",
            tolerance(error)
        ),
        head: std::iter::once("Scene".to_owned()).chain(names).collect(),
        rows,
    }
}
