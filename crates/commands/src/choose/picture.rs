//! The chart of error over cost of all models.

use charts::{Method, Point, Work, WorkPrecision};
use std::time::Duration;
use studies::model_reduction::{Models, Receipt, Wish, choose};

/// A chart of the error of every model over its evaluations, with the cheapest method for each of several tolerances. The error is that against the
/// reference where there is one, otherwise the estimate.
pub fn of(title: &str, models: &dyn Models, wish: &Wish, first: Receipt) -> WorkPrecision {
    let mut receipts = vec![first];
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8] {
        let allowed = Duration::ZERO;
        receipts.extend(choose(models, &Wish { tolerance, allowed, outputs: wish.outputs.clone() }).ok());
    }
    let mut series: Vec<Method> = Vec::new();
    for receipt in &receipts {
        for line in &receipt.lines {
            let Some(choice) = &line.choice else { continue };
            let point =
                Point { work: choice.work.evaluations as f64, error: choice.measured.unwrap_or(choice.promised) };
            let name = line.name.clone();
            match series.iter_mut().find(|known| known.name == name) {
                Some(known) => known.points.push(point),
                None => series.push(Method {
                    name: name.clone(),
                    family: name,
                    kinds: [format!("{} states", line.states), String::new()],
                    quiet: false,
                    points: vec![point],
                    failures: Vec::new(),
                }),
            }
        }
    }
    for one in &mut series {
        one.points.sort_by(|a, b| a.work.total_cmp(&b.work));
    }
    let all: Vec<Point> = series.iter().flat_map(|one| one.points.iter().copied()).collect();
    let places: Vec<(f64, f64)> = all.iter().map(|point| (point.work, point.error)).collect();
    WorkPrecision {
        title: format!("{title}: error against the cost of models"),
        x: Work::Evaluations,
        error: "error in the outputs".to_owned(),
        front: integrators::front(&places).into_iter().map(|at| all[at]).collect(),
        series,
        note: String::new(),
    }
}
