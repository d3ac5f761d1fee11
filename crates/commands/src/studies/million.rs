//! Results of runs over a million revolutions, which take minutes, read from the file of a benchmark if it exists.

use integrators::Work;
use serde::Deserialize;
use simulation::methods::method;
use std::path::Path;
use studies::long_runs::{MethodRun, Sample};

/// The output file of the benchmark, relative to the parent of the folder of scenes.
const FILE: &str = "benches/long_runs.json";
pub const COMMAND: &str = "cargo bench --bench long_runs";

#[derive(Deserialize)]
struct Kept {
    method: String,
    tolerance: f64,
    steps: u64,
    /// For each sample: revolutions, energy, swing, length, momentum and phase, as in [`Sample`].
    samples: Vec<[Option<f64>; 6]>,
}

/// The runs over a million revolutions, read from a file next to the folder `scenes`.
///
/// # Errors
/// A sentence for the report, where the file is missing or belongs to another version.
pub fn courses(scenes: &Path) -> Result<Vec<MethodRun>, String> {
    let path = scenes.parent().unwrap_or(Path::new("")).join(FILE);
    let text = std::fs::read_to_string(path).map_err(|_| format!("A million revolutions: {COMMAND} writes {FILE}."))?;
    let anew = || format!("{FILE} is not what this program reads; {COMMAND} writes it anew.");
    let kept = serde_json::from_str::<Vec<Kept>>(&text).map_err(|_| anew())?;
    kept.iter().map(course).collect::<Option<_>>().ok_or_else(anew)
}

fn course(kept: &Kept) -> Option<MethodRun> {
    let sample = |[revolutions, energy, swing, length, momentum, phase]: &[Option<f64>; 6]| {
        let [revolutions, energy, swing, length, momentum] = [*revolutions, *energy, *swing, *length, *momentum];
        Some(Sample {
            revolutions: revolutions?,
            energy: energy?,
            swing: swing?,
            length: length?,
            momentum: momentum?,
            phase: *phase,
        })
    };
    Some(MethodRun {
        method: method(&kept.method).ok()?,
        tolerance: kept.tolerance,
        samples: kept.samples.iter().map(sample).collect::<Option<_>>()?,
        work: Work { steps: kept.steps, ..Work::default() },
        failure: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use studies::long_runs::{LongRun, PACES};

    #[test]
    fn what_is_kept_of_a_million_revolutions_begins_as_the_runs_of_today() {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
        let kept = courses(&scenes).expect("the bench has written them");
        assert_eq!(kept.len(), PACES.len());
        let run = LongRun::new().expect("it nutates");
        for (kept, pace) in kept.iter().zip(PACES) {
            let [today, then] = [&run.course(pace, 10), kept].map(|course| course.samples[2]);
            let off = |a: f64, b: f64| (a - b).abs() / a.abs().max(1e-9);
            assert!(off(today.swing, then.swing) < 0.1, "{}: {today:?} {then:?}", kept.method);
            assert!(kept.samples.last().is_some_and(|last| last.revolutions > 1e6), "{}", kept.method);
        }
    }
}
