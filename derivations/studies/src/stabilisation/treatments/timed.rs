//! Computing times of the treatments.

use super::{Line, Run};
use integrators::interleaved;
use std::time::Duration;

/// The median times of the lines that reached the end, s, measured in turns on an otherwise idle machine.
pub fn times(lines: &[Line], allowed: Duration) -> Vec<Option<f64>> {
    let reached = |line: &&Line| matches!(line.measured, Some(Ok(_)));
    let runs: Vec<Option<Run>> = lines
        .iter()
        .map(|line| Some(line).filter(reached).and_then(|line| Run::new(line.scheme, line.steps, line.treatment)))
        .collect();
    let times = interleaved(runs.len(), allowed, |index| runs[index].is_some_and(|run| run.go(&mut ()).reached()));
    times.into_iter().map(|time| time.map(|median| median.seconds)).collect()
}
