//! A sentence of advice on the fastest method for an error.

use super::{Counted, Series, series};
use charts::{significant, tolerance};
use integrators::cost;
use simulation::Atlas;

/// A sentence on the fastest method that reaches an error, and on the fastest method of another family.
pub fn advice(atlas: &Atlas, error: f64) -> String {
    let series = series(atlas);
    let reaching = |one: &&Series<'_>| cost(&one.trials(Counted::Time), error).is_some();
    let mut costs: Vec<(f64, &Series)> = series
        .iter()
        .filter(reaching)
        .filter_map(|one| Some((cost(&one.trials(Counted::Time), error)?, one)))
        .collect();
    costs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let to = tolerance(error);
    let Some((least, best)) = costs.first() else {
        // the times of methods that reach the error are unknown if the time for measurements was spent
        let counted = |one: &Series<'_>| cost(&one.trials(Counted::Evaluations), error);
        let fewest = series.iter().filter_map(|one| Some((counted(one)?, one))).min_by(|a, b| a.0.total_cmp(&b.0));
        return fewest.map_or_else(
            || format!("To {to}: no method reaches it."),
            |(_, one)| format!("To {to}: not timed in the time allowed; {} with the fewest evaluations.", one.said()),
        );
    };
    match costs.iter().find(|(_, other)| other.family != best.family) {
        Some((next, other)) => {
            let longer = match significant(next / least, 2) {
                times if times == "1" => "as long".to_owned(),
                times => format!("{times} times as long"),
            };
            format!("To {to}: {}; {} takes {longer}.", best.said(), other.said())
        }
        None => format!("To {to}: {}, and no other method.", best.said()),
    }
}
