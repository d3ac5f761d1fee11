//! The choice of figures for an animation: as few as show the motion smoothly, chosen from many instants.

use ::scenes::geometry::{Figure, Geometry};
use nalgebra::Vector3;

/// The largest motion between successive figures: displacement of a point as a fraction of the size of the picture, rotation of a body in rad.
#[derive(Clone, Copy)]
struct Step {
    way: f64,
    turn: f64,
}

/// The preferred steps between figures; [`LARGER`] steps are accepted if only these show the whole motion.
const SMALL: Step = Step { way: 0.03, turn: 0.3 };
const LARGER: Step = Step { way: 0.05, turn: 0.5 };

/// The least number of figures for a whole motion, approximately.
const FEW: usize = 80;

/// The indices of the chosen instants.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chosen {
    pub numbers: Vec<usize>,
    /// Whether the last instant is among them.
    pub is_whole: bool,
}

/// Chooses at most `most` figures, from the first instant on, until the last instant or until adjacent instants are too far apart.
pub fn chosen(geometry: &Geometry, figures: &[Figure], most: usize) -> Chosen {
    let size_of_all = size(figures);
    let whole =
        |step: Step| Some(within(geometry, figures, most, (step, size_of_all))).filter(|chosen| chosen.is_whole);
    if let Some(few) = whole(SMALL).filter(|chosen| chosen.numbers.len() < FEW) {
        // small steps are also needed to show how the speed of a small motion changes
        let share = few.numbers.len() as f64 / FEW as f64;
        return whole(Step { way: share * SMALL.way, turn: share * SMALL.turn }).unwrap_or(few);
    }
    whole(SMALL).or_else(|| whole(LARGER)).unwrap_or_else(|| {
        let first = within(geometry, figures, most, (SMALL, size_of_all));
        // the shown part of the motion may be much smaller than the whole
        let part = &figures[..first.numbers.last().map_or(0, |last| last + 1)];
        Chosen { is_whole: false, ..within(geometry, part, most, (SMALL, size(part))) }
    })
}

fn within(geometry: &Geometry, figures: &[Figure], most: usize, (step, size): (Step, f64)) -> Chosen {
    let mut numbers: Vec<usize> = (0..figures.len().min(1)).collect();
    while let Some(&last) = numbers.last().filter(|_| numbers.len() < most) {
        let is_near = |next: &usize| is_near(geometry, [&figures[last], &figures[*next]], (step, size));
        let Some(next) = (last + 1..figures.len()).take_while(is_near).last() else { break };
        numbers.push(next);
    }
    let is_whole = numbers.last().is_none_or(|last| last + 1 == figures.len());
    Chosen { numbers, is_whole }
}

/// Whether the motion between two figures is within a step.
fn is_near(geometry: &Geometry, [one, other]: [&Figure; 2], (step, size): (Step, f64)) -> bool {
    let moved = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (b - a).norm() <= step.way * size;
    let turned =
        |frame: usize| (0..3).all(|axis| (other.frames[frame][axis] - one.frames[frame][axis]).norm() <= step.turn);
    let mut frames = geometry.model.bodies.iter().filter_map(|body| body.frame);
    one.places.iter().zip(&other.places).all(moved) && frames.all(|frame| turned(frame.0))
}

/// The diagonal of the bounding box of all points at all instants, in metres.
fn size(figures: &[Figure]) -> f64 {
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    for place in figures.iter().flat_map(|figure| &figure.places) {
        (low, high) = (low.inf(place), high.sup(place));
    }
    (high - low).norm()
}
