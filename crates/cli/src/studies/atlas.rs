//! The atlas: which method is the cheapest on which scene, and how much a single choice for all of them loses.

use crate::pictures::{evaluations, family};
use charts::{Study, Table, significant, tolerance};
use derivations::scene::Measured;
use integrators::{Point, Regrets, Trial, cost};

/// Errors at which methods are compared.
const ERRORS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// A way to count what a run costs.
struct Counted<'a> {
    name: &'static str,
    of: &'a dyn Fn(&Point, &Measured) -> f64,
}

/// The table of regret at every error, in evaluations and in time, and a line of advice for each scene.
pub fn study(scenes: &[(&str, &Measured)]) -> Study {
    let count = |point: &Point, measured: &Measured| evaluations(point, measured.reference.sizes.len() as u64) as f64;
    let seconds = |point: &Point, _: &Measured| point.time.map_or(f64::NAN, |time| time.seconds);
    let (by_count, by_time) = (Counted { name: "evaluations", of: &count }, Counted { name: "time", of: &seconds });
    let methods = methods(scenes);
    let mut tables = vec![advice(scenes, &methods, &by_time), single(scenes, &methods, &[&by_count, &by_time])];
    tables.extend(ERRORS.map(|error| regret(scenes, &methods, &by_time, error)));
    tables.push(regret(scenes, &methods, &by_count, ERRORS[1]));
    Study {
        id: "atlas".into(),
        title: "Which method for which scene".into(),
        lead: "The cost of a method at an error, read between its measured points, over the least cost of all methods: its \
               regret. A method that was not seen to reach the error has none."
            .into(),
        tables,
        note: "Times are medians taken in turns within this run of the program; they belong to this machine, evaluations do \
               not. A run in time includes what a method sets up. Scenes whose reference ran out of its time are left out."
            .into(),
        ..Study::default()
    }
}

/// The methods of all scenes, each once.
fn methods(scenes: &[(&str, &Measured)]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for point in scenes.iter().flat_map(|(_, measured)| &measured.points) {
        let name = family(point.method);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn regrets(scenes: &[(&str, &Measured)], methods: &[String], counted: &Counted<'_>, error: f64) -> Regrets {
    let trials = |method: &String, measured: &Measured| -> Vec<Trial> {
        let own = measured.points.iter().filter(|point| family(point.method) == *method);
        own.map(|point| Trial { cost: (counted.of)(point, measured), error: point.error.ok() }).collect()
    };
    let costs: Vec<Vec<Option<f64>>> = methods
        .iter()
        .map(|method| scenes.iter().map(|(_, measured)| cost(&trials(method, measured), error)).collect())
        .collect();
    Regrets::of(&costs)
}

/// Scenes down, methods across.
fn regret(scenes: &[(&str, &Measured)], methods: &[String], counted: &Counted<'_>, error: f64) -> Table {
    let regrets = regrets(scenes, methods, counted, error);
    let cell = |regret: Option<f64>| regret.map_or_else(|| "—".to_owned(), |regret| significant(regret, 2));
    let row = |(column, (title, _)): (usize, &(&str, &Measured))| -> Vec<String> {
        std::iter::once((*title).to_owned()).chain(regrets.rows.iter().map(|row| cell(row[column]))).collect()
    };
    let mut rows: Vec<Vec<String>> = scenes.iter().enumerate().map(row).collect();
    let largest = (0..methods.len()).map(|method| cell(regrets.largest(method)));
    rows.push(std::iter::once("largest, where it reaches the error".to_owned()).chain(largest).collect());
    Table {
        caption: format!("Regret at an error of {}, in {}", tolerance(error), counted.name),
        head: std::iter::once("Scene".to_owned()).chain(methods.iter().cloned()).collect(),
        rows,
    }
}

/// What one method for all scenes loses at most.
fn single(scenes: &[(&str, &Measured)], methods: &[String], counted: &[&Counted<'_>]) -> Table {
    let mut rows = Vec::new();
    for error in ERRORS {
        for one in counted {
            let regrets = regrets(scenes, methods, one, error);
            let Some(best) = regrets.best_single_choice() else { continue };
            let served = format!("{} of {}", regrets.served(best), scenes.len());
            let loss = regrets.largest(best).map_or_else(|| "—".to_owned(), |loss| significant(loss, 2));
            rows.push(vec![tolerance(error), one.name.to_owned(), methods[best].clone(), served, loss]);
        }
    }
    Table {
        caption: "The best single choice for all scenes".to_owned(),
        head: ["Error", "Counted in", "Method", "Reaches it on", "Largest regret there"].map(str::to_owned).to_vec(),
        rows,
    }
}

/// For each scene the cheapest method at each error, and by how much the next is dearer.
fn advice(scenes: &[(&str, &Measured)], methods: &[String], counted: &Counted<'_>) -> Table {
    let by_error = ERRORS.map(|error| regrets(scenes, methods, counted, error));
    let said = |regrets: &Regrets, column: usize| -> String {
        let Some(best) = regrets.best[column] else { return "none reaches it".to_owned() };
        let others = (0..methods.len()).filter(|&method| method != best);
        let next = others.filter_map(|method| Some((method, regrets.rows[method][column]?)));
        match next.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((method, loss)) => {
                format!("{}; {} takes {} times as long", methods[best], methods[method], significant(loss, 2))
            }
            None => format!("{}, and no other", methods[best]),
        }
    };
    let row = |(column, (title, _)): (usize, &(&str, &Measured))| -> Vec<String> {
        std::iter::once((*title).to_owned()).chain(by_error.iter().map(|regrets| said(regrets, column))).collect()
    };
    Table {
        caption: "Advice: the fastest at each error, and the next".to_owned(),
        head: std::iter::once("Scene".to_owned())
            .chain(ERRORS.map(|error| format!("Error {}", tolerance(error))))
            .collect(),
        rows: scenes.iter().enumerate().map(row).collect(),
    }
}
