//! Work-precision diagrams: the error over the work for each method. Failed runs are shown too.

mod failures;
mod series;

use super::{
    axis::{Axis, FLOOR, Tick},
    drawing::{Anchor, Drawing, WIDTH, left_out},
    number::{counted, significant},
};

/// The measure of work on the horizontal axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Work {
    /// The number of evaluations of the right-hand side, which does not depend on the machine.
    #[default]
    Evaluations,
    /// The measured time of one run, as a ratio to the fastest.
    TimeRatio,
}

impl Work {
    /// The label of the axis.
    pub fn label(self) -> &'static str {
        match self {
            Work::Evaluations => "evaluations of the right-hand side",
            Work::TimeRatio => "time, as a ratio to the fastest run",
        }
    }

    /// An amount of work as text.
    pub fn amount(self, work: f64) -> String {
        match self {
            Work::Evaluations => format!("{} evaluations", counted(work)),
            Work::TimeRatio => format!("{} times the fastest", significant(work, 3)),
        }
    }
}

/// A diagram of error (vertical) over work (horizontal), both axes logarithmic.
#[derive(Clone, Debug, Default)]
pub struct WorkPrecision {
    pub title: String,
    pub x: Work,
    /// The label of the vertical axis, plain text with its unit. Empty means `error`.
    pub error: String,
    pub series: Vec<Method>,
    /// The Pareto front by increasing work: no run has both less work and a smaller error. It is drawn as a staircase behind the series.
    pub front: Vec<Point>,
    /// The text below the chart.
    pub note: String,
}

/// The results of one method at all its tolerances.
#[derive(Clone, Debug, Default)]
pub struct Method {
    pub name: String,
    /// The name of the family, under which failures are reported; empty where it is `name`.
    pub family: String,
    /// The meanings of the shape of the markers and of the dashes of the line; empty where shape and dashes identify the series.
    pub kinds: [String; 2],
    /// Whether the series is drawn in grey and left out of the legend.
    pub quiet: bool,
    /// The completed runs, ordered by tolerance and joined by a line.
    pub points: Vec<Point>,
    pub failures: Vec<Failure>,
}

/// A completed run: its work and its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// The work in the unit of [`Work`].
    pub work: f64,
    /// The error against a reference, as the label of the axis defines it.
    pub error: f64,
}

/// A failed run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Failure {
    /// The work until the failure; not finite where it is unknown.
    pub work: f64,
    /// The tolerance; NaN for a method with constant step size.
    pub tolerance: f64,
    pub reason: String,
}

impl Method {
    /// The name under which failures are reported: that of the method without its formulation and model.
    pub(crate) fn family(&self) -> &str {
        if self.family.is_empty() { &self.name } else { &self.family }
    }
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = WIDTH - 12.0;
const PLOT: f64 = 300.0;
const ROW: f64 = 17.0;

impl WorkPrecision {
    /// The chart as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let drawn = |point: &&Point| positive(point.work) && positive(point.error);
        let points = || self.series.iter().flat_map(|method| method.points.iter().filter(drawn));
        let failing = failures::families(&self.series);
        let omissions = self.omissions();
        let mut drawing = Drawing::default();
        if failing.is_empty() && points().next().is_none() && !omissions.is_empty() {
            // without a point on these axes, sentences replace the diagram
            omissions.iter().for_each(|sentence| drawing.paragraph(sentence, "small"));
            return drawing;
        }
        let works = self.series.iter().flat_map(|method| method.failures.iter().map(|failure| failure.work));
        let works = points().map(|point| point.work).chain(works.filter(|work| positive(*work)));

        let band = if failing.is_empty() { 0.0 } else { ROW * failing.len() as f64 + 6.0 };
        let (top, bottom) = (8.0 + band, 8.0 + band + PLOT);
        let x = Axis::log(works, LEFT, RIGHT, 52.0);
        let y = Axis::log(points().map(|point| point.error), bottom, top, 26.0);
        let looks = series::Looks::of(&self.series);

        frame(&mut drawing, &x, &y, (top - band, top, bottom));
        for (row, failing) in failing.iter().enumerate() {
            let height = top - band + ROW * (row as f64 + 0.5) + 3.0;
            failures::draw(&mut drawing, failing, &looks, self.x, &x, height);
        }
        series::front(&mut drawing, &self.front, &x, &y);
        let place = |point: &Point| (x.place(point.work), y.place(point.error));
        for quiet in [true, false] {
            for (at, method) in self.series.iter().enumerate().filter(|(_, method)| method.quiet == quiet) {
                let points: Vec<&Point> = method.points.iter().filter(drawn).collect();
                series::draw(&mut drawing, method, &points, looks.series[at], self.x, place);
            }
        }
        drawing.text((0.5 * (LEFT + RIGHT), bottom + 42.0), Anchor::Middle, "", self.x.label());
        let error = if self.error.is_empty() { "error" } else { &self.error };
        drawing.upward((15.0, 0.5 * (top + bottom)), error);
        drawing.height = bottom + 54.0;
        looks.legend(&mut drawing, &self.series, !self.front.is_empty());
        omissions.iter().for_each(|sentence| drawing.paragraph(sentence, "small"));
        drawing
    }

    /// Sentences on points that are left out or drawn at the lower edge, with the reasons.
    fn omissions(&self) -> Vec<String> {
        let points = || self.series.iter().flat_map(|method| &method.points);
        let exact = points().filter(|point| positive(point.work) && point.error == 0.0).count();
        let bad = points().filter(|point| !(positive(point.work) && positive(point.error))).count() - exact;
        let tiny = points().filter(|point| positive(point.error) && point.error < FLOOR).count();
        let sentences = [
            left_out(exact, "the error is exactly 0"),
            left_out(bad, "not a positive number"),
            if tiny > 0 { format!("Errors below 10⁻³² are drawn there ({tiny}).") } else { String::new() },
        ];
        sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect()
    }
}

fn positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// Draws the frame with grid and ticks, and the empty band of failures above it.
fn frame(drawing: &mut Drawing, x: &Axis, y: &Axis, (roof, top, bottom): (f64, f64, f64)) {
    drawing.open("frame");
    if roof < top {
        drawing.rect((LEFT, roof), RIGHT - LEFT, top - roof, "band");
        drawing.text((LEFT - 8.0, 0.5 * (roof + top) + 5.0), Anchor::End, "", "failed");
    }
    for (class, named) in [("fine", false), ("grid", true)] {
        let places = |axis: &Axis| -> Vec<f64> {
            let ticks = axis.ticks.iter().filter(|tick| tick.label.is_some() == named);
            ticks.map(|tick| axis.place_tick(tick.at)).collect()
        };
        drawing.grid(places(x).into_iter(), places(y).into_iter(), [LEFT, RIGHT, top, bottom], class);
    }
    for Tick { at, label } in &x.ticks {
        let x = x.place_tick(*at);
        if let Some(label) = label {
            drawing.text((x, bottom + 19.0), Anchor::Middle, "", label);
        }
    }
    for Tick { at, label } in &y.ticks {
        let y = y.place_tick(*at);
        if let Some(label) = label {
            drawing.text((LEFT - 8.0, y + 5.0), Anchor::End, "", label);
        }
    }
    drawing.rect((LEFT, top), RIGHT - LEFT, bottom - top, "box");
    drawing.close();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<Point>, failures: Vec<Failure>) -> WorkPrecision {
        WorkPrecision {
            series: vec![Method { name: "M".into(), points, failures, ..Default::default() }],
            ..Default::default()
        }
    }

    #[test]
    fn a_failure_stays_on_the_chart() {
        let reason = "step below 1e-14 at t = 3.2".to_owned();
        let svg = chart(vec![], vec![Failure { work: f64::NAN, tolerance: 1e-6, reason }]).svg();
        assert!(svg.contains("class=\"band\"") && svg.contains(">M: 1 of 1</text>"));
        assert!(svg.contains("M fails at tolerance 10⁻⁶, work unknown: step below 1e-14 at t = 3.2"), "{svg}");
    }

    #[test]
    fn what_cannot_be_drawn_is_said() {
        let point = |work, error| Point { work, error };
        let points = vec![point(1.0, f64::NAN), point(10.0, 0.0), point(f64::INFINITY, 1.0), point(10.0, 1e-40)];
        let svg = chart(points, vec![]).svg();
        assert!(svg.contains("1 point left out: the error is exactly 0."));
        assert!(svg.contains("2 points left out: not a positive number."));
        assert!(svg.contains("drawn there (1)"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn where_all_is_exact_a_sentence_stands_for_axes() {
        let exact = vec![Point { work: 3.0, error: 0.0 }; 2];
        let svg = chart(exact, vec![]).svg();
        assert!(svg.contains("2 points left out: the error is exactly 0.") && !svg.contains("frame"), "{svg}");
    }

    #[test]
    fn what_others_beat_is_grey_and_the_front_is_drawn() {
        let method = |name: &str, form: &str, quiet| Method {
            name: name.into(),
            kinds: [form.into(), "model".into()],
            quiet,
            points: vec![Point { work: 1.0, error: 1e-3 }, Point { work: 2.0, error: 1e-6 }],
            ..Default::default()
        };
        let series = vec![method("A", "first", false), method("B", "second", true)];
        let front = series[0].points.clone();
        let svg = WorkPrecision { series, front, ..Default::default() }.svg();
        assert!(svg.contains("<g class=\"s0 d0\">") && svg.contains("<g class=\"quiet d0\">"), "{svg}");
        assert!(svg.contains("class=\"front\"") && svg.contains(">A</text>") && !svg.contains(">B</text>"), "{svg}");
        assert!(svg.contains("<title>B</title>") && svg.contains(">second</text>"), "{svg}");
    }

    #[test]
    fn an_empty_chart_is_a_chart() {
        assert!(WorkPrecision::default().svg().ends_with("</svg>"));
    }
}
