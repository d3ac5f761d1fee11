//! Charts as SVG. Coordinates have fixed decimals, so that equal data give equal bytes.

pub(crate) mod areas;
pub(crate) mod branches;
pub(crate) mod number;
pub(crate) mod sheet;
pub(crate) mod sketch;
pub(crate) mod sphere;
pub(crate) mod timings;
pub(crate) mod trajectory;
pub(crate) mod work_precision;

mod axis;
mod decimate;
mod drawing;
mod legend;
mod marker;
mod path;

/// The style sheet of charts; a page adds its own colours for dark screens.
pub(crate) const STYLE: &str = include_str!("chart.css");
