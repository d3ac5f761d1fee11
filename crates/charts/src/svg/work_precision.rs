//! Error against work, method by method; a method that fails stays on the chart.

use super::{
    axis::{Axis, FLOOR, Tick},
    drawing::{Anchor, Drawing, WIDTH, left_out},
    legend::{self, Entry},
    marker::Look,
    number::{counted, significant, tolerance},
    path,
};

/// What the work is counted in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Work {
    /// Evaluations of the right side: an integer, the same on every machine.
    #[default]
    Evaluations,
    /// Time as a ratio, measured in one run.
    TimeRatio,
}

impl Work {
    /// How the axis is named.
    pub fn label(self) -> &'static str {
        match self {
            Work::Evaluations => "evaluations of the right-hand side",
            Work::TimeRatio => "time, as a ratio to the fastest run",
        }
    }

    /// An amount of it in words.
    pub fn amount(self, work: f64) -> String {
        match self {
            Work::Evaluations => format!("{} evaluations", counted(work)),
            Work::TimeRatio => format!("{} times the fastest", significant(work, 3)),
        }
    }
}

/// Error (vertical) against work (horizontal), both logarithmic.
#[derive(Clone, Debug, Default)]
pub struct WorkPrecision {
    pub title: String,
    pub x: Work,
    /// What the error is, plain text with its unit: the vertical axis. Empty means `error`.
    pub error: String,
    pub series: Vec<Method>,
    /// Text below the chart.
    pub note: String,
}

/// One method on all its tolerances.
#[derive(Clone, Debug, Default)]
pub struct Method {
    pub name: String,
    /// In the order of the tolerances: a line joins them.
    pub points: Vec<Point>,
    pub failures: Vec<Failure>,
}

/// One run that ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    pub work: f64,
    pub error: f64,
}

/// One run that did not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Failure {
    /// Spent until it gave up; not finite where unknown.
    pub work: f64,
    /// Not a number for a method of constant step.
    pub tolerance: f64,
    pub reason: String,
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
        let failing: Vec<_> =
            self.series.iter().enumerate().filter(|(_, method)| !method.failures.is_empty()).collect();
        let works = self.series.iter().flat_map(|method| method.failures.iter().map(|failure| failure.work));
        let works = points().map(|point| point.work).chain(works.filter(|work| positive(*work)));

        let band = if failing.is_empty() { 0.0 } else { ROW * failing.len() as f64 + 6.0 };
        let (top, bottom) = (8.0 + band, 8.0 + band + PLOT);
        let x = Axis::log(works, LEFT, RIGHT, 52.0);
        let y = Axis::log(points().map(|point| point.error), bottom, top, 26.0);

        let mut drawing = Drawing::default();
        frame(&mut drawing, &x, &y, (top - band, top, bottom));
        for (row, (position, method)) in failing.into_iter().enumerate() {
            let height = top - band + ROW * (row as f64 + 0.5) + 3.0;
            self.failures(&mut drawing, method, Look::of(position), &x, height);
        }
        for (position, method) in self.series.iter().enumerate() {
            self.method(&mut drawing, method, Look::of(position), &x, &y);
        }
        drawing.text((0.5 * (LEFT + RIGHT), bottom + 42.0), Anchor::Middle, "", self.x.label());
        let error = if self.error.is_empty() { "error" } else { &self.error };
        drawing.upward((15.0, 0.5 * (top + bottom)), error);
        drawing.height = bottom + 54.0;
        let entries: Vec<_> = self
            .series
            .iter()
            .enumerate()
            .map(|(at, method)| Entry { look: Look::of(at), name: &method.name })
            .collect();
        legend::draw(&mut drawing, &entries, true);
        for sentence in self.omissions() {
            drawing.paragraph(&sentence, "small");
        }
        drawing
    }

    fn method(&self, drawing: &mut Drawing, method: &Method, look: Look, x: &Axis, y: &Axis) {
        let drawn: Vec<_> =
            method.points.iter().filter(|point| positive(point.work) && positive(point.error)).collect();
        let places: Vec<_> = drawn.iter().map(|point| (x.place(point.work), y.place(point.error))).collect();
        drawing.open(&look.class());
        drawing.path(&path::polyline(&places), "line");
        for (point, place) in drawn.into_iter().zip(places) {
            let error = significant(point.error, 2);
            look.marker(drawing, place, 4.4, &format!("{}: {}, error {error}", method.name, self.x.amount(point.work)));
        }
        drawing.close();
    }

    /// The markers of a method's failures, those of unknown work at the left, and beside them whose they are.
    fn failures(&self, drawing: &mut Drawing, method: &Method, look: Look, x: &Axis, height: f64) {
        let (mut taken, mut unknown) = (vec![LEFT, RIGHT], 0);
        drawing.open(&look.class());
        for failure in &method.failures {
            let known = positive(failure.work);
            let at = if known { x.place(failure.work) } else { LEFT + 10.0 + 12.0 * f64::from(unknown) };
            unknown += i32::from(!known);
            taken.push(at);
            let spent =
                if known { format!("after {}", self.x.amount(failure.work)) } else { "work unknown".to_owned() };
            let (name, given) = (&method.name, tolerance(failure.tolerance));
            let tooltip = format!("{name} fails at tolerance {given}, {spent}: {}", failure.reason);
            look.marker(drawing, (at, height), 4.0, &tooltip);
        }
        drawing.close();
        let (failed, all) = (method.failures.len(), method.failures.len() + method.points.len());
        let label = format!("{}: {failed} of {all}", method.name);
        let (anchor, start) = free(taken, 6.9 * label.chars().count() as f64 + 14.0);
        drawing.text((start, height + 4.5), anchor, "small said", &label);
    }

    /// What is not drawn where it belongs, and why.
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

/// Where a label of so much width stands beside marks in a row: behind the last, before the first, or in the widest gap.
fn free(mut marks: Vec<f64>, width: f64) -> (Anchor, f64) {
    marks.sort_by(f64::total_cmp);
    let gaps: Vec<(f64, f64)> = marks.windows(2).map(|pair| (pair[0], pair[1])).collect();
    let fits = |(from, to): &(f64, f64)| to - from > width;
    match (gaps.last(), gaps.first()) {
        (Some(last), _) if fits(last) => (Anchor::Start, last.0 + 11.0),
        (_, Some(first)) if fits(first) => (Anchor::End, first.1 - 11.0),
        _ => {
            let widest = gaps.iter().max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)));
            (Anchor::Middle, widest.map_or(0.5 * (LEFT + RIGHT), |gap| 0.5 * (gap.0 + gap.1)))
        }
    }
}

fn positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// The box, its grid and ticks, and above it the band of failures.
fn frame(drawing: &mut Drawing, x: &Axis, y: &Axis, (roof, top, bottom): (f64, f64, f64)) {
    drawing.open("frame");
    if roof < top {
        drawing.rect((LEFT, roof), RIGHT - LEFT, top - roof, "band");
        drawing.text((LEFT - 8.0, 0.5 * (roof + top) + 5.0), Anchor::End, "", "failed");
    }
    for Tick { at, label } in &x.ticks {
        let x = x.place_tick(*at);
        drawing.line((x, top), (x, bottom), if label.is_some() { "grid" } else { "fine" });
        if let Some(label) = label {
            drawing.text((x, bottom + 19.0), Anchor::Middle, "", label);
        }
    }
    for Tick { at, label } in &y.ticks {
        let y = y.place_tick(*at);
        drawing.line((LEFT, y), (RIGHT, y), if label.is_some() { "grid" } else { "fine" });
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
        WorkPrecision { series: vec![Method { name: "M".into(), points, failures }], ..Default::default() }
    }

    #[test]
    fn a_failure_stays_on_the_chart() {
        let reason = "step below 1e-14 at t = 3.2".to_owned();
        let svg = chart(vec![], vec![Failure { work: f64::NAN, tolerance: 1e-6, reason }]).svg();
        assert!(svg.contains("class=\"band\"") && svg.contains(">M: 1 of 1</text>"));
        assert!(svg.contains("M fails at tolerance 10⁻⁶, work unknown: step below 1e-14 at t = 3.2"), "{svg}");
    }

    #[test]
    fn the_name_of_a_failing_method_covers_none_of_its_marks() {
        assert!(matches!(free(vec![LEFT, RIGHT, 100.0], 120.0), (Anchor::Start, x) if x == 111.0));
        assert!(matches!(free(vec![LEFT, RIGHT, 400.0], 120.0), (Anchor::End, x) if x == 389.0));
        assert!(matches!(free(vec![LEFT, RIGHT, 100.0, 500.0], 120.0), (Anchor::Middle, x) if x == 300.0));
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
    fn an_empty_chart_is_a_chart() {
        assert!(WorkPrecision::default().svg().ends_with("</svg>"));
    }
}
