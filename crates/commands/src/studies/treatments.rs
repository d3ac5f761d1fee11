//! Treatments of a constraint: pictures of error and drift over the gain, and the table of results.

use super::extent;
use charts::{AreaCurve, Areas, Table, significant};
use studies::stabilisation::treatments::{Line, Measure, SPAN, Scan};

/// The note below the table: definitions of errors and times, and the theoretical orders.
pub fn note() -> &'static str {
    r"Critically damped, $b=2w$, $k=w^2$. Error: the largest error of angle, position and their rates at 100 instants, relative to the size of each. A Jacobian counts as the evaluations of its columns. Time: medians of runs that take turns within one run of the program while nothing else runs; 1 is the fastest of the table. Gains that grow as $1/h$ and $1/h^2$ remove a violation fastest and make the equations stiff at every step: the classical Runge-Kutta method then has order 1. With constant gains the error is $h^pe(w)$ plus higher powers, with one function $e$ for all steps: the gain of the least error is therefore a time scale of the motion, not of the step, which the rows with twice the steps confirm where the error is small enough for its lowest power to dominate. This time scale is measured, not derived. Gear-Gupta-Leimkuhler is half-explicit for Euler (order 1) and for the classical coefficients (order 3), Radau IIA with one stage for backward Euler (order 1), and Gauss with one stage, projected at the end of each step, for the midpoint rule (order 2; without the projection the error of the constraint changes its sign at each step instead of decaying)."
}

/// A picture of scans over gains with logarithmic axes, with a mark at the smallest error of each.
pub fn scanned(scans: &[&Scan], title: &str, label: &str, value: impl Fn(&Measure) -> f64) -> Areas {
    let curve = |scan: &&Scan| AreaCurve {
        name: format!("{}, {} steps", scan.scheme.name(), scan.steps),
        points: scan.points.iter().map(|point| (point.rate.log10(), value(point).max(1e-16).log10())).collect(),
    };
    // every second scan, since the others have the same shape
    let curves: Vec<AreaCurve> = scans.iter().step_by(2).map(curve).collect();
    let mark = |best: Measure| {
        let name = format!("{}/s", significant(best.rate, 2));
        (best.rate.log10(), value(&best).max(1e-16).log10(), name)
    };
    Areas {
        title: title.into(),
        x: ("log₁₀ w (1/s), gains b = 2 w, k = w²".into(), extent(&curves, |point| point.0)),
        y: (format!("log₁₀ {label}"), extent(&curves, |point| point.1)),
        curves,
        dots: Vec::new(),
        marks: scans.iter().step_by(2).filter_map(|scan| scan.best()).map(mark).collect(),
        note: format!(
            "Critically damped, {SPAN} s of the crank and slider. The curve of an explicit method ends at its stability \
             limit, that of an implicit one at h w = 10. Marked: the rate with the least error."
        ),
        ..Areas::default()
    }
}

/// The table with one row for each treatment with each method.
pub fn table(lines: &[Line], times: &[Option<f64>]) -> Table {
    let head = [
        "Method",
        "Steps",
        "Constraint",
        "Largest |f|, m²",
        "Largest |f\u{307}|, m²/s",
        "Error",
        "Evaluations",
        "of the constraint alone",
        "Time",
    ];
    let fastest = times.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    let row = |(line, time): (&Line, &Option<f64>)| {
        let mut cells = vec![line.scheme.name().to_owned(), line.steps.to_string(), line.treatment.name()];
        match &line.measured {
            Some(Ok(found)) => {
                cells.extend([found.drift, found.rate_drift, found.error].map(|x| significant(x, 2)));
                cells.extend([found.evaluations, found.corrections].map(|count| count.to_string()));
                cells.push(time.map_or_else(|| "—".to_owned(), |time| significant(time / fastest, 2)));
            }
            Some(Err(failure)) => cells.push(failure.to_string()),
            None => cells.extend(["—"; 6].map(str::to_owned)),
        }
        cells
    };
    let caption = "A crank and slider over nine revolutions, by treatment of its constraint".into();
    let rows = lines.iter().zip(times).map(row).collect();
    Table { caption, head: head.map(String::from).into(), rows }
}
