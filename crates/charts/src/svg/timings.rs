//! Bar charts of the ratios of other programs' times to those of dalembert.

use super::{
    axis::{Axis, Tick},
    drawing::{Anchor, Drawing, LINE, WIDTH, shorten},
    marker::Look,
    number::significant,
};

/// The times of tasks in dalembert and in other programs.
#[derive(Clone, Debug, Default)]
pub struct Timings {
    pub title: String,
    /// The name of this program, the denominator of all ratios.
    pub ours: String,
    pub rows: Vec<TimingRow>,
    /// The text below the chart: machine, versions, method of measurement.
    pub note: String,
}

/// The times of one task.
#[derive(Clone, Debug, Default)]
pub struct TimingRow {
    pub task: String,
    /// The time of this program in seconds.
    pub ours: f64,
    pub others: Vec<Contender>,
}

/// The result of another program for a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Contender {
    pub name: String,
    /// The time in seconds, or the reason for which the program gives no answer.
    pub outcome: Result<f64, String>,
}

const LEFT: f64 = 8.0;
const RIGHT: f64 = WIDTH - 150.0;
const BAR: f64 = 13.0;

impl TimingRow {
    /// The time of a contender divided by that of this program; `None` where either is unknown.
    pub(crate) fn ratio(&self, contender: &Contender) -> Option<f64> {
        let ratio = contender.outcome.as_ref().ok()? / self.ours;
        (ratio.is_finite() && ratio > 0.0).then_some(ratio)
    }
}

impl Timings {
    /// The chart as an SVG file.
    pub fn svg(&self) -> String {
        self.drawing().standalone(&self.title)
    }

    /// The names of all contenders, each once, in the order of their first occurrence.
    pub(crate) fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for contender in self.rows.iter().flat_map(|row| &row.others) {
            if !names.contains(&contender.name.as_str()) {
                names.push(&contender.name);
            }
        }
        names
    }

    pub(crate) fn drawing(&self) -> Drawing {
        let names = self.names();
        let ratios = self.rows.iter().flat_map(|row| row.others.iter().filter_map(|contender| row.ratio(contender)));
        let x = Axis::log(ratios.chain([1.0]), LEFT, RIGHT, 56.0);
        let height = |row: &TimingRow| LINE + 2.0 + (BAR + 3.0) * row.others.len() as f64 + 6.0;
        let bottom = 4.0 + self.rows.iter().map(height).sum::<f64>();

        let mut drawing = Drawing::default();
        for Tick { at, label } in &x.ticks {
            let label = label.as_deref().unwrap_or("");
            drawing.text((x.place_tick(*at), bottom + 17.0), Anchor::Middle, "", label);
        }
        drawing.height = 4.0;
        for row in &self.rows {
            drawing.text((LEFT, drawing.height + LINE - 3.0), Anchor::Start, "heading", &shorten(&row.task, 68));
            drawing.height += LINE + 2.0;
            let end = drawing.height + (BAR + 3.0) * row.others.len() as f64;
            for Tick { at, label } in &x.ticks {
                let class = if *at == 0.0 { "unit" } else { "grid" };
                if label.is_some() {
                    drawing.line((x.place_tick(*at), drawing.height - 2.0), (x.place_tick(*at), end), class);
                }
            }
            for contender in &row.others {
                let look = Look::of(names.iter().position(|name| *name == contender.name).unwrap_or(0));
                bar(&mut drawing, row, contender, look, &x);
                drawing.height += BAR + 3.0;
            }
            drawing.height += 6.0;
        }
        let caption = format!("time as a ratio to {}: to the right of 1, {} is faster", self.ours, self.ours);
        drawing.text((0.5 * WIDTH, bottom + 38.0), Anchor::Middle, "", &caption);
        drawing.height = bottom + 50.0;
        drawing
    }
}

fn bar(drawing: &mut Drawing, row: &TimingRow, contender: &Contender, look: Look, x: &Axis) {
    let unit = x.place(1.0);
    let baseline = drawing.height + BAR - 2.0;
    match row.ratio(contender) {
        Some(ratio) => {
            let end = x.place(ratio);
            drawing.open(&look.class());
            let width = (end - unit).abs().max(1.5);
            drawing.rect((unit.min(end), drawing.height), width, BAR, "bar");
            drawing.close();
            let text = format!("{} × {}", contender.name, significant(ratio, 3));
            drawing.text((unit.max(end) + 6.0, baseline), Anchor::Start, "small said", &text);
        }
        None => {
            let reason = contender.outcome.as_ref().err().map_or("not a positive time", String::as_str);
            let text = format!("{}: no answer, {reason}", contender.name);
            drawing.text((unit + 6.0, baseline), Anchor::Start, "small said", &shorten(&text, 60));
        }
    }
}

/// A time in seconds as text with a suitable unit.
pub(crate) fn seconds(time: f64) -> String {
    let (value, unit) = match time.abs() {
        t if t < 1e-6 => (time * 1e9, "ns"),
        t if t < 1e-3 => (time * 1e6, "µs"),
        t if t < 1.0 => (time * 1e3, "ms"),
        _ => (time, "s"),
    };
    format!("{}\u{a0}{unit}", significant(value, 3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contender_without_an_answer_keeps_its_row() {
        let others = vec![Contender { name: "other".into(), outcome: Err("out of memory".into()) }];
        let timings = Timings { rows: vec![TimingRow { task: "det".into(), ours: 0.0, others }], ..Default::default() };
        assert!(timings.svg().contains("other: no answer, out of memory"));
    }

    #[test]
    fn times_have_their_natural_unit() {
        let shown: Vec<_> = [3.1e-8, 6.2e-5, 0.04, 12.0].map(seconds).into();
        assert_eq!(shown, ["31\u{a0}ns", "62\u{a0}µs", "40\u{a0}ms", "12\u{a0}s"]);
    }
}
