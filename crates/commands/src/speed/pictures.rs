//! Charts of error over work: series that reach the Pareto front in colour, the others in grey.

use super::{ANSWER, Counted, Series, model, series};
use charts::{Failure, Point, Work, WorkPrecision};
use integrators::front;
use simulation::Atlas;
use simulation::work_precision::Formulation;

/// Two charts of the error: over evaluations, and over time.
pub fn work_precision(atlas: &Atlas) -> [WorkPrecision; 2] {
    let series: Vec<Series> = series(atlas).into_iter().filter(|one| one.is_near()).collect();
    let seconds = series.iter().flat_map(|one| &one.points).map(|point| Counted::Time.of(point));
    let fastest = seconds.fold(f64::INFINITY, f64::min);
    Counted::ALL.map(|counted| {
        let unit = if counted == Counted::Time { fastest } else { 1.0 };
        let (x, title) = match counted {
            Counted::Evaluations => (Work::Evaluations, "Error against evaluations"),
            Counted::Time => (Work::TimeRatio, "Error against time"),
        };
        let places: Vec<(usize, Point)> = series
            .iter()
            .enumerate()
            .flat_map(|(at, one)| answers(one, counted, unit).map(move |it| (at, it)))
            .collect();
        let found = front(&places.iter().map(|(_, point)| (point.work, point.error)).collect::<Vec<_>>());
        let loud = |at: usize| found.iter().any(|&place| places[place].0 == at);
        WorkPrecision {
            title: title.to_owned(),
            x,
            error: "largest relative error".to_owned(),
            series: series.iter().enumerate().map(|(at, one)| drawn(one, counted, unit, !loud(at))).collect(),
            front: found.iter().map(|&place| places[place].1).collect(),
            note: String::new(),
        }
    })
}

/// The completed runs whose cost was measured; `unit` divides the cost.
fn ended<'a>(series: &'a Series<'_>, counted: Counted, unit: f64) -> impl Iterator<Item = Point> + 'a {
    let points = series.points.iter().filter_map(|point| Some((*point, point.error.ok()?)));
    points
        .map(move |(point, error)| Point { work: counted.of(point) / unit, error })
        .filter(|point| point.work.is_finite())
}

/// The runs among these with an error that is small enough for a useful result.
fn answers<'a>(series: &'a Series<'_>, counted: Counted, unit: f64) -> impl Iterator<Item = Point> + 'a {
    ended(series, counted, unit).filter(|point| point.error <= ANSWER)
}

fn drawn(series: &Series<'_>, counted: Counted, unit: f64, quiet: bool) -> charts::Method {
    let failed = series.points.iter().filter_map(|point| Some((point, point.error.err()?)));
    charts::Method {
        name: series.name(),
        family: series.family.clone(),
        kinds: [series.way.formulation.name().to_owned(), model(series.way)],
        quiet,
        points: ended(series, counted, unit).collect(),
        failures: failed
            .map(|(point, failure)| Failure {
                work: counted.of(point) / unit,
                tolerance: point.tolerance.unwrap_or(f64::NAN),
                reason: failure.name().to_owned(),
            })
            .collect(),
    }
}

/// The text below the charts of a scene, which defines errors, evaluations and times.
pub fn measured_by(atlas: &Atlas) -> String {
    let reference = &atlas.reference;
    let across = atlas.explored.iter().any(|one| one.way.formulation == Formulation::Contacts);
    let compared = match across {
        true => {
            "up to the end, or to shortly before an earlier one, of coordinates, velocities and works (each relative to its own \
             size, or to that of its kind where it is only rounding)"
        }
        false => {
            "of what all formulations and models have (velocities and directions relative to the size of their vector, all else \
             to its own)"
        }
    };
    let models = match across {
        true => "",
        false => {
            " The curve of an approximate model ends at the error of the model, and is not drawn if that is above 0.1; an exact \
             model has the same motion, which is proved."
        }
    };
    format!(
        "Error: the largest over eight instants {compared}, by the reference of the scene's own model: {} and {} in \
         double-double, which agree to {:.0} digits.{models} A Jacobian counts as the {} evaluations of its columns, a \
         correction onto constraints as one. Times are medians within one run of the program, in which all of them take turns.",
        reference.methods[0],
        reference.methods[1],
        reference.digits,
        reference.sizes.len()
    )
}
