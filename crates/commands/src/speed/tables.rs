//! The Pareto fronts of a scene as tables, and the errors of its models.

use super::{Counted, family, model};
use charts::{Table, significant, tolerance};
use integrators::{Point, front};
use simulation::Atlas;
use simulation::work_precision::{Configuration, Standing};

/// Tables of the cheapest run that reaches each decade of the error: by evaluations, and by time.
pub fn fronts(atlas: &Atlas) -> Vec<Table> {
    Counted::ALL.into_iter().map(|counted| decades(atlas, counted)).filter(|table| !table.rows.is_empty()).collect()
}

fn decades(atlas: &Atlas, counted: Counted) -> Table {
    let all: Vec<(&Configuration, &Point, f64)> =
        atlas.points().filter_map(|(way, point)| Some((way, point, point.error.ok()?))).collect();
    let costs: Vec<(f64, f64)> = all.iter().map(|(_, point, error)| (counted.of(point), *error)).collect();
    let front = front(&costs);
    let fastest = front.first().map_or(1.0, |&at| costs[at].0);
    let mut taken: Vec<usize> = Vec::new();
    for decade in 1..16 {
        let reaches = front.iter().find(|&&at| costs[at].1 <= 10_f64.powi(-decade));
        taken.extend(reaches.filter(|at| !taken.contains(at)));
    }
    let row = |&at: &usize| {
        let (way, point, error) = all[at];
        let cost = match counted {
            Counted::Evaluations => point.evaluations.to_string(),
            Counted::Time => significant(costs[at].0 / fastest, 3),
        };
        let given = point
            .means
            .steps()
            .map_or_else(|| tolerance(point.tolerance.unwrap_or(f64::NAN)), |steps| format!("{steps} steps"));
        vec![significant(error, 2), cost, family(point.means), way.formulation.to_string(), model(way), given]
    };
    let (caption, cost) = match counted {
        Counted::Evaluations => ("The fewest evaluations, decade by decade", "Evaluations"),
        Counted::Time => ("The least time, decade by decade", "Time, as a ratio"),
    };
    Table {
        caption: caption.to_owned(),
        head: ["Error", cost, "Method", "Formulation", "Model", "Tolerance"].map(str::to_owned).to_vec(),
        rows: taken.iter().map(row).collect(),
    }
}

/// The models of a scene, each with its relation to the scene's own model and its least error.
pub fn floors(atlas: &Atlas) -> Vec<(&'static str, String)> {
    let mut known: Vec<(&str, String)> = Vec::new();
    for explored in &atlas.explored {
        let model = explored.way.model;
        if model.is_empty() || known.iter().any(|(name, _)| *name == model) {
            continue;
        }
        let said = match (explored.way.standing, explored.floor) {
            (Standing::Own, _) => "the scene's own".to_owned(),
            (Standing::Exact, _) => "exact: the same motion, which is proved".to_owned(),
            (Standing::Approximate, Some(floor)) => format!("off by {}", significant(floor, 2)),
            (Standing::Approximate, None) => "no accurate run of it reached the end".to_owned(),
        };
        known.push((model, said));
    }
    if known.len() > 1 { known } else { Vec::new() }
}

/// The table of the models of a scene with their least errors.
pub fn models(atlas: &Atlas) -> Table {
    let rows = floors(atlas).into_iter().map(|(model, said)| vec![model.replace('_', " "), said]);
    let head = ["Model", "Least error by the reference of the scene's own"].map(str::to_owned).to_vec();
    Table { caption: "Models that these data allow".to_owned(), head, rows: rows.collect() }
}
