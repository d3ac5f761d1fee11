//! The pictures of a motion: as few as show it smoothly, chosen from many instants by how far places move between them.

use ::scenes::geometry::{Figure, Geometry};
use nalgebra::Vector3;

/// The way of a place from one picture to the next, as a part of the size of the whole picture.
const WAY: f64 = 0.03;
/// The turn of a body from one picture to the next, in rad.
const TURN: f64 = 0.3;

/// Chosen instants, by their numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chosen {
    pub numbers: Vec<usize>,
    /// Whether they come to the last instant.
    pub is_whole: bool,
}

/// Chooses at most so many pictures, from the first on, until the last instant or until the instants are too far apart.
pub fn chosen(geometry: &Geometry, figures: &[Figure], most: usize) -> Chosen {
    let first = within(geometry, figures, most, size(figures));
    // a part of the motion may be much smaller than the whole
    match first.numbers.last() {
        Some(last) if !first.is_whole => {
            let part = &figures[..=*last];
            Chosen { is_whole: false, ..within(geometry, part, most, size(part)) }
        }
        _ => first,
    }
}

fn within(geometry: &Geometry, figures: &[Figure], most: usize, size: f64) -> Chosen {
    let mut numbers: Vec<usize> = (0..figures.len().min(1)).collect();
    while let Some(&last) = numbers.last().filter(|_| numbers.len() < most) {
        let next =
            (last + 1..figures.len()).take_while(|next| is_near(geometry, [&figures[last], &figures[*next]], size));
        let Some(next) = next.last() else { break };
        numbers.push(next);
    }
    let is_whole = numbers.last().is_none_or(|last| last + 1 == figures.len());
    Chosen { numbers, is_whole }
}

/// Whether the motion between two figures is small enough to be seen as one.
fn is_near(geometry: &Geometry, [one, other]: [&Figure; 2], size: f64) -> bool {
    let moved = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (b - a).norm() <= WAY * size;
    let turned = |frame: usize| (0..3).all(|axis| (other.frames[frame][axis] - one.frames[frame][axis]).norm() <= TURN);
    let mut frames = geometry.model.bodies.iter().filter_map(|body| body.frame);
    one.places.iter().zip(&other.places).all(moved) && frames.all(|frame| turned(frame.0))
}

/// The diagonal of the box of all places over all figures.
fn size(figures: &[Figure]) -> f64 {
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    for place in figures.iter().flat_map(|figure| &figure.places) {
        (low, high) = (low.inf(place), high.sup(place));
    }
    (high - low).norm()
}
