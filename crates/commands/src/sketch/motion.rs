//! The motion of a scene as pictures: its run, or the part of it that some hundred pictures follow.

use super::pictures::chosen;
use crate::clock;
use ::scenes::ModelScene;
use ::scenes::geometry::{Figure, Geometry};
use charts::{Sketch, SketchPart};
use simulation::run::most_samples;
use simulation::{Choice, IvpScene, Trajectory};
use std::ops::ControlFlow;

/// Instants of a run from which pictures are chosen.
const INSTANTS: f64 = 3000.0;
/// The largest number of pictures.
const PICTURES: usize = 300;
/// Fewer pictures than these are followed more closely, where they do not show the whole run.
const ENOUGH: usize = 100;
/// The part of a run that is followed first, by this divisor.
const PART: f64 = 4096.0;
/// Shorter runs are tried so often, and each is at least so much shorter.
const TRIALS: usize = 12;
const SHORTER: f64 = 64.0;
/// The approximate largest size of a moving picture, in bytes, and the size of one part in one picture.
const LARGEST: usize = 1_500_000;
const BYTES: usize = 40;
/// The least number of pictures of a system with many parts.
const FEWEST: usize = 60;
/// A turn by more than this between two instants, in rad, would look like another turn.
const SEEN_TURN: f64 = 0.5;

/// The pictures of a motion.
pub struct Motion {
    pub figures: Vec<Figure>,
    /// The part of the run that is shown, s; none where that is all that was asked for.
    pub part: Option<[f64; 2]>,
    /// The run that was drawn.
    pub run: Trajectory,
}

/// The interval of a run that is asked for, s.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    pub from: f64,
    pub to: f64,
}

/// The largest number of pictures of a sketch.
pub fn most_pictures(sketch: &Sketch) -> usize {
    let weight = |part: &SketchPart| match part {
        SketchPart::TorsionSpring { .. } => 12,
        SketchPart::RotaryDashpot { .. } | SketchPart::Torque { .. } | SketchPart::Ring { .. } => 6,
        _ => 1,
    };
    let parts: usize = sketch.parts.iter().map(weight).sum();
    (LARGEST / (BYTES * parts.max(1))).clamp(FEWEST, PICTURES)
}

/// Follows a scene over an interval, or from its begin as far as the pictures go; none where nothing moves there.
pub fn followed(
    scene: &ModelScene,
    geometry: &Geometry,
    (interval, most): (Interval, usize),
    mut progress: impl FnMut(f64) -> ControlFlow<()>,
) -> Option<Motion> {
    let Interval { from, to } = interval;
    // the first part tells at little cost whether pictures can follow the whole
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
            // farther than pictures have followed it, with closer instants
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
    /// The time of the last picture; below all times where there is none.
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

/// The pictures of a run of some span, whose rows end with the values that its mode determines or not.
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
