//! The sketch of a system along its run.

use crate::sketch::sketch;
use ::scenes::ModelScene;
use ::scenes::geometry::{Figure, Geometry};
use simulation::Trajectory;

/// Instants of the sketch: the page is told it anew for each place of a slider.
const MOST_INSTANTS: usize = 120;

/// The sketch as SVG, moving as the run does; empty where nothing has a place.
pub(super) fn along(scene: &ModelScene, run: &Trajectory) -> String {
    let Ok(geometry) = Geometry::of(&scene.model, &scene.start) else { return String::new() };
    if !geometry.is_seen() {
        return String::new();
    }
    let states = scene.model.positions() + scene.model.speeds();
    let every = run.rows.len().div_ceil(MOST_INSTANTS).max(1);
    let rows = run.times.iter().zip(&run.rows).step_by(every);
    let figures = rows.map(|(time, row)| geometry.figure(*time, &row[..states]));
    let figures: Vec<Figure> = figures.take_while(Figure::has_values).collect();
    match figures.is_empty() {
        true => String::new(),
        false => sketch(&scene.title, &geometry, &figures, None).embedded(),
    }
}
