//! The motion of a scene as a sequence of figures for an animation.

use super::pictures::chosen;
use crate::clock;
use ::scenes::ModelScene;
use ::scenes::geometry::{Figure, Geometry};
use charts::{Sketch, SketchPart};
use simulation::run::most_samples;
use simulation::{Choice, IvpScene, Trajectory};
use std::ops::ControlFlow;

/// The number of instants of a run from which figures are chosen.
const INSTANTS: f64 = 3000.0;
/// The largest number of figures.
const PICTURES: usize = 300;
/// If fewer figures than this show only a part of the run, that part is run again with closer instants.
const ENOUGH: usize = 100;
/// The first trial run is the whole run divided by this number.
const PART: f64 = 4096.0;
/// The largest number of trial runs; [`SHORTER`] bounds the ratio of the lengths of successive ones.
const TRIALS: usize = 12;
const SHORTER: f64 = 64.0;
/// The approximate largest size of an animated picture in bytes; [`BYTES`] is the size of one part at one instant.
const LARGEST: usize = 1_500_000;
const BYTES: usize = 40;
/// The least number of figures for a system with many parts.
const FEWEST: usize = 60;
/// The largest rotation in radians between two instants; a larger rotation could look like a rotation in the opposite sense.
const SEEN_TURN: f64 = 0.5;

/// The figures of a motion.
pub struct Motion {
    pub figures: Vec<Figure>,
    /// The interval of the run that the figures show, s; `None` where they show the whole requested interval.
    pub part: Option<[f64; 2]>,
    /// The run from which the figures were taken.
    pub run: Trajectory,
}

/// The requested interval of a run, s.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    pub from: f64,
    pub to: f64,
}

/// The largest number of figures for a sketch, so that its file stays small.
pub fn most_pictures(sketch: &Sketch) -> usize {
    let weight = |part: &SketchPart| match part {
        SketchPart::TorsionSpring { .. } => 12,
        SketchPart::RotaryDashpot { .. } | SketchPart::Torque { .. } | SketchPart::Ring { .. } => 6,
        _ => 1,
    };
    let parts: usize = sketch.parts.iter().map(weight).sum();
    (LARGEST / (BYTES * parts.max(1))).clamp(FEWEST, PICTURES)
}

/// Runs a scene over an interval, or over the first part of it that the figures can show; `None` where nothing moves.
pub fn followed(
    scene: &ModelScene,
    geometry: &Geometry,
    (interval, most): (Interval, usize),
    mut progress: impl FnMut(f64) -> ControlFlow<()>,
) -> Option<Motion> {
    let Interval { from, to } = interval;
    // a short first run shows at little cost whether the figures can show the whole interval
    let mut until = if from == 0.0 { to / PART } else { to };
    let mut too_long = f64::INFINITY;
    let mut best: Option<Motion> = None;
    for _ in 0..TRIALS {
        let run = run(scene, Interval { from, to: until }, &mut progress);
        let is_over = run.broken_off() || clock::left().is_zero();
        let motion = pictures(scene, geometry, (run, until), (interval, most));
        let (shown, count, is_part) = (motion.shown(), motion.figures.len(), motion.part.is_some());
        if best.as_ref().is_none_or(|best| (shown, count) > (best.shown(), best.figures.len())) {
            best = Some(motion);
        }
        let next = match shown >= until {
            true if count < ENOUGH.min(most) => to,
            true => from + (until - from) * most as f64 / count as f64,
            false if count >= ENOUGH.min(most) => break,
            // the next run extends beyond the part that the figures have shown, with closer instants than a run to the end
            false => {
                too_long = until;
                let ahead = (4.0 * (shown - from)).max((until - from) / SHORTER);
                from + ahead.min(0.5 * (until - from))
            }
        };
        if is_over || !is_part || next >= too_long || until >= to && next >= to {
            break;
        }
        until = next.min(to);
    }
    best.filter(|motion| !motion.figures.is_empty())
}

impl Motion {
    /// The time of the last figure, s; minus infinity without figures.
    fn shown(&self) -> f64 {
        self.figures.last().map_or(f64::NEG_INFINITY, |figure| figure.time)
    }
}

fn run(
    scene: &ModelScene,
    Interval { from, to }: Interval,
    progress: &mut impl FnMut(f64) -> ControlFlow<()>,
) -> Trajectory {
    let mut problem = scene.problem_with_mode_values();
    problem.span = to;
    let most = most_samples(problem.columns.len() + scene.mode_values());
    let samples = (INSTANTS * to / (to - from)).min(most as f64) as usize;
    problem.simulate_while(&Choice { samples, allowed: clock::left(), ..scene.run().choice() }, progress)
}

/// The figures of a run of this span. Its rows end with the values that depend on the contact mode.
pub fn pictures(
    scene: &ModelScene,
    geometry: &Geometry,
    (run, span): (Trajectory, f64),
    (interval, most): (Interval, usize),
) -> Motion {
    let states = scene.model.positions() + scene.model.speeds();
    let figure = |time: f64, row: &[f64]| {
        let of_mode = row.get(run.names.len()..).unwrap_or_default();
        geometry.figure_with(time, &row[..states.min(row.len())], of_mode)
    };
    let has_end = run.times.last().is_some_and(|last| run.outcome.time > *last);
    let end = has_end.then_some((run.outcome.time, &run.last));
    let all = run.times.iter().copied().zip(&run.rows).chain(end).filter(|(time, _)| *time >= interval.from);
    let mut figures: Vec<Figure> = Vec::new();
    let mut is_resolved = true;
    for (time, row) in all {
        let step = figures.last().map_or(0.0, |last: &Figure| time - last.time);
        is_resolved = fastest_turn(scene, row) * step <= SEEN_TURN;
        let next = figure(time, row);
        if !is_resolved || !next.has_values() {
            break;
        }
        figures.push(next);
    }
    let chosen = chosen(geometry, &figures, most);
    let mut number = 0..;
    figures.retain(|_| number.next().is_some_and(|number| chosen.numbers.contains(&number)));
    let ends = run.outcome.time < span * (1.0 - 1e-12);
    let reached = if ends { run.outcome.time } else { interval.to };
    let shown = figures.last().map_or(interval.from, |figure| figure.time);
    let is_part = !(chosen.is_whole && is_resolved) || shown < reached;
    Motion { figures, part: is_part.then_some([interval.from, shown]), run }
}

/// The largest rate of an angle in a row, in rad/s.
fn fastest_turn(scene: &ModelScene, row: &[f64]) -> f64 {
    let names = scene.model.state_names();
    let turns = names.iter().zip(row).skip(scene.model.positions()).filter(|((_, unit), _)| unit == "rad/s");
    turns.map(|(_, rate)| rate.abs()).fold(0.0, f64::max)
}
