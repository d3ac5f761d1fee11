//! Errors in long integrations of a top whose motion is known in closed form. After given numbers of revolutions the
//! errors of energy (the present one and the largest so far), v.v, x.v and phase are printed, with the exponents of
//! their growth. Run it by `cargo bench --bench long_runs [-- REVOLUTIONS]`; the default is a million revolutions,
//! which takes ten minutes and writes long_runs.json, from which the report draws its figures.

use dalembert_derivations::studies::long_runs::{LongRun, MethodRun, PACES, Sample};
use serde_json::{Value, json};
use simulation::methods::written;
use std::time::Instant;

const MILLION: u32 = 1_000_000;
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/long_runs.json");

const QUANTITIES: [fn(&Sample) -> Option<f64>; 5] =
    [|s| Some(s.energy), |s| Some(s.swing), |s| Some(s.length), |s| Some(s.momentum), |s| s.phase];

fn main() {
    let given = std::env::args().filter_map(|word| word.parse().ok()).next();
    let revolutions = given.unwrap_or(MILLION);
    let Some(run) = LongRun::new() else { return };
    println!(
        "{:<44} {:>9} {:>8}  error [growth] of energy, its largest, v.v, x.v, phase",
        "method", "work/rev", "seconds"
    );
    let mut runs = Vec::new();
    for pace in PACES {
        let start = Instant::now();
        let course = run.course(pace, revolutions);
        let seconds = start.elapsed().as_secs_f64();
        let each = (course.work.rates + 7 * course.work.jacobians) as f64 / f64::from(revolutions);
        print!("{:<44} {each:>9.0} {seconds:>8.1} ", course.method.to_string());
        match (course.failure, course.samples.last()) {
            (None, Some(last)) => {
                for of in QUANTITIES {
                    let error = of(last).map_or_else(|| "lost".into(), |error| format!("{:.1e}", error.abs()));
                    let growth = course.growth(of).map_or_else(String::new, |growth| format!("[{growth:.2}]"));
                    print!(" {error:>7} {growth:<7}");
                }
                println!();
            }
            (failure, _) => println!(" {failure:?}"),
        }
        runs.push(kept(&course));
    }
    if revolutions == MILLION {
        let lines: Vec<String> = runs.iter().map(Value::to_string).collect();
        match std::fs::write(FILE, format!("[\n{}\n]\n", lines.join(",\n"))) {
            Ok(()) => println!("written: {FILE}"),
            Err(error) => println!("{FILE}: {error}"),
        }
    }
}

/// The data of a run that the report uses.
fn kept(course: &MethodRun) -> Value {
    let sample = |s: &Sample| json!([s.revolutions, s.energy, s.swing, s.length, s.momentum, s.phase]);
    json!({
        "method": written(course.method),
        "tolerance": course.tolerance,
        "steps": course.work.steps,
        "samples": course.samples.iter().map(sample).collect::<Vec<_>>(),
    })
}
