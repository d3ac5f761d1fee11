//! Charts of one run on one sheet.

use super::drawing::Drawing;
use super::trajectory::Trajectory;

/// Charts of one run in columns side by side, each column from top to bottom.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    pub title: String,
    pub columns: Vec<Vec<Trajectory>>,
    /// The text below all columns.
    pub note: String,
}

impl Sheet {
    /// The sheet as an SVG file.
    pub fn svg(&self) -> String {
        let column = |charts: &Vec<Trajectory>| {
            let mut drawing = Drawing::default();
            charts.iter().for_each(|chart| drawing.below(&[chart.drawing()]));
            drawing
        };
        let columns: Vec<Drawing> = self.columns.iter().filter(|charts| !charts.is_empty()).map(column).collect();
        let mut drawing = Drawing::default();
        drawing.below(&columns);
        drawing.paragraph(&self.note, "small");
        drawing.standalone(&self.title)
    }
}

#[cfg(test)]
mod tests {
    use super::super::trajectory::{Panel, Track};
    use super::*;

    #[test]
    fn every_chart_of_every_column_is_drawn() {
        let chart = |name: &str| {
            let track = Track { name: name.into(), points: vec![(0.0, 0.0), (1.0, 1.0)], stopped: None };
            Trajectory { panels: vec![Panel { y: name.into(), series: vec![track] }], ..Default::default() }
        };
        let columns = vec![vec![chart("a"), chart("b")], Vec::new(), vec![chart("c")]];
        let svg = Sheet { title: "all".into(), columns, note: "below".into() }.svg();
        for shown in [">a</text>", ">b</text>", ">c</text>", ">below</text>", "all"] {
            assert!(svg.contains(shown), "{shown}: {svg}");
        }
        assert!(Sheet::default().svg().ends_with("</svg>"));
    }
}
