//! Errors of energy (now, and the largest so far), v.v, x.v and phase after so many revolutions of a top in closed form, with
//! the exponents of their growth: `cargo bench --bench long_runs [-- REVOLUTIONS]`, a million by default.

use derivations::long_runs::{LongRun, PACES, Sample};
use std::time::Instant;

const QUANTITIES: [fn(&Sample) -> Option<f64>; 5] =
    [|s| Some(s.energy), |s| Some(s.swing), |s| Some(s.length), |s| Some(s.momentum), |s| s.phase];

fn main() {
    let given = std::env::args().filter_map(|word| word.parse().ok()).next();
    let revolutions = given.unwrap_or(1_000_000);
    let Some(run) = LongRun::new() else { return };
    println!(
        "{:<44} {:>9} {:>8}  error [growth] of energy, its largest, v.v, x.v, phase",
        "method", "work/rev", "seconds"
    );
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
    }
}
