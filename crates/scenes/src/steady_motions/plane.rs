//! Steady motions as functions of two parameters or cyclic speeds: all motions at the midpoint of each cell, and brackets of changes between
//! neighbouring cells.

use super::along::{found_at, kinds};
use super::{NoSteadyMotions, Range, SteadyMotions, SteadySearch};
use model::Model;

/// The name of a parameter or of the speed of a cyclic coordinate, with its range in SI units.
pub type Direction<'a> = (&'a str, Range);

/// The motions at the midpoint of a cell.
#[derive(Clone, Debug)]
pub struct PlaneCell {
    /// The values of both parameters at the midpoint, in SI units.
    pub values: [f64; 2],
    /// The steady motions at the midpoint.
    pub found: SteadyMotions,
    /// The reason if no search is possible for the values of this cell.
    pub left_out: Option<NoSteadyMotions>,
}

/// Number of bisections between the midpoints of two different cells.
const HALVINGS: usize = 5;

/// The midpoints of `count` equal parts of a range.
pub fn middles(range: Range, count: usize) -> Vec<f64> {
    let part = |k: usize| range.from + (range.to - range.from) * (2 * k + 1) as f64 / (2 * count) as f64;
    (0..count).map(part).collect()
}

impl PlaneCell {
    /// All motions for two values, in SI units.
    ///
    /// # Errors
    /// If no search is possible for these values.
    pub fn at(
        model: &Model,
        asked: &SteadySearch,
        names: [&str; 2],
        values: [f64; 2],
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, NoSteadyMotions> {
        let found = found_at(model, asked, &[(names[0], values[0]), (names[1], values[1])], goes_on)?;
        Ok(PlaneCell { values, found, left_out: None })
    }

    /// The cells for one value of the first parameter and `rows` values of the second.
    pub fn column(
        model: &Model,
        asked: &SteadySearch,
        [first, second]: [Direction<'_>; 2],
        (value, rows): (f64, usize),
        mut goes_on: impl FnMut() -> bool,
    ) -> Vec<Self> {
        let names = [first.0, second.0];
        let at = |other: f64| {
            let values = [value, other];
            let left_out = |why| PlaneCell { values, found: SteadyMotions::default(), left_out: Some(why) };
            PlaneCell::at(model, asked, names, values, &mut goes_on).unwrap_or_else(left_out)
        };
        middles(second.1, rows).into_iter().map(at).collect()
    }

    /// Whether the search of the cell was complete.
    pub fn is_complete(&self) -> bool {
        self.left_out.is_none() && self.found.is_complete()
    }

    /// Whether two cells have equal numbers of motions with equal numbers of unstable directions; true, too, if a search was not complete.
    pub fn is_like(&self, other: &Self) -> bool {
        let decided = self.is_complete() && other.is_complete();
        !decided || kinds(&self.found) == kinds(&other.found)
    }

    /// Two points between two different cells that enclose the change of the motions; the bisection ends at an incomplete search.
    pub fn border(
        &self,
        other: &Self,
        model: &Model,
        asked: &SteadySearch,
        names: [&str; 2],
        mut goes_on: impl FnMut() -> bool,
    ) -> [[f64; 2]; 2] {
        let [mut near, mut far] = [self.values, other.values];
        for _ in 0..HALVINGS {
            if !goes_on() {
                break;
            }
            let middle = [0.5 * (near[0] + far[0]), 0.5 * (near[1] + far[1])];
            let found = PlaneCell::at(model, asked, names, middle, &mut goes_on).ok();
            let Some(found) = found.filter(PlaneCell::is_complete) else { break };
            if self.is_like(&found) { near = middle } else { far = middle }
        }
        [near, far]
    }
}
