//! Series on the plot: the Pareto front behind, series that reach it in colour, the others in grey.

use super::super::{
    axis::Axis,
    drawing::Drawing,
    legend::{self, Entry},
    marker::Look,
    number::significant,
    path,
};
use super::{Method, Point, Work, positive};

/// The appearance of each series, and the meanings of shapes and dashes.
pub(super) struct Looks<'a> {
    pub series: Vec<Look>,
    /// The meanings of the shapes of markers, and of the dashes of lines.
    kinds: [Vec<&'a str>; 2],
}

impl<'a> Looks<'a> {
    /// The appearances of all series; a series without kinds has a shape and dashes of its own.
    pub fn of(all: &'a [Method]) -> Self {
        let mut kinds: [Vec<&str>; 2] = Default::default();
        for (kinds, which) in kinds.iter_mut().zip([0, 1]) {
            for kind in all.iter().map(|method| method.kinds[which].as_str()).filter(|kind| !kind.is_empty()) {
                if !kinds.contains(&kind) {
                    kinds.push(kind);
                }
            }
        }
        let mut loud = 0..;
        let look = |method: &Method| {
            let own = if method.quiet { Look::quiet() } else { Look::of(loud.next().unwrap_or(0)) };
            let place = |which: usize| kinds[which].iter().position(|kind| *kind == method.kinds[which]);
            own.of_kind(place(0), place(1))
        };
        let series = all.iter().map(look).collect();
        Looks { series, kinds }
    }

    /// Draws the legend: the names of the coloured series, then the meanings of shapes and dashes.
    pub fn legend(&self, drawing: &mut Drawing, all: &[Method], with_front: bool) {
        if with_front {
            drawing
                .paragraph("Broad line: nothing is cheaper and as exact. Coloured: the series that reach it.", "small");
        }
        let loud = all.iter().zip(&self.series).filter(|(method, _)| !method.quiet);
        let entries: Vec<_> = loud.map(|(method, look)| Entry { look: *look, name: &method.name }).collect();
        legend::draw(drawing, &entries, true);
        let [shapes, dashes] = &self.kinds;
        let shapes = shapes.iter().enumerate().map(|(at, name)| (Look::quiet().of_kind(Some(at), None), name));
        let dashes = dashes.iter().enumerate().map(|(at, name)| (Look::quiet().of_kind(None, Some(at)), name));
        for (what, kinds) in [("Markers:", shapes.collect::<Vec<_>>()), ("Lines:", dashes.collect())] {
            if kinds.len() > 1 {
                drawing.paragraph(what, "small");
                let entries: Vec<_> = kinds.iter().map(|(look, name)| Entry { look: *look, name }).collect();
                legend::draw(drawing, &entries, what == "Markers:");
            }
        }
    }
}

/// Half the width of a grey marker in pixels.
pub(super) const SMALL: f64 = 2.2;

/// Draws the line and the markers of a series. The markers of a grey series are one path, whose tooltip is the name of its method.
pub(super) fn draw(
    drawing: &mut Drawing,
    method: &Method,
    points: &[&Point],
    look: Look,
    work: Work,
    place: impl Fn(&Point) -> (f64, f64),
) {
    let places: Vec<_> = points.iter().map(|point| place(point)).collect();
    drawing.open(&look.class());
    let line = path::polyline(&places);
    // the tooltip of the line names the series once for all its points
    match method.quiet || line.is_empty() {
        true => drawing.path(&line, "line"),
        false => drawing.path_with_tooltip(&line, "line", &method.name),
    }
    if method.quiet {
        look.markers(drawing, &places, SMALL, method.family());
    } else {
        for (point, place) in points.iter().zip(places) {
            let error = significant(point.error, 2);
            look.marker(
                drawing,
                place,
                4.4,
                &format!("{}: {}, error {error}", method.family(), work.amount(point.work)),
            );
        }
    }
    drawing.close();
}

/// Draws the Pareto front as a staircase: the cost of an error is the work of the cheapest run with at most this error.
pub(super) fn front(drawing: &mut Drawing, points: &[Point], x: &Axis, y: &Axis) {
    let drawn = points.iter().filter(|point| positive(point.work) && positive(point.error));
    let mut stairs: Vec<(f64, f64)> = Vec::new();
    for (work, error) in drawn.map(|point| (x.place(point.work), y.place(point.error))) {
        stairs.extend(stairs.last().map(|(_, before)| (work, *before)));
        stairs.push((work, error));
    }
    drawing.path(&path::polyline(&stairs), "front");
}
