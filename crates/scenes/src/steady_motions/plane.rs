//! Steady motions over two parameters, or speeds of cyclic coordinates: all motions in the middle of each cell, and brackets of changes
//! between neighbours.

use super::along::{found_at, kinds};
use super::{Asked, NoSteadyMotions, Range, SteadyMotions};
use model::Model;

/// A parameter, or the speed of a cyclic coordinate, with its range in SI units.
pub type Direction<'a> = (&'a str, Range);

/// The motions in the middle of a cell.
#[derive(Clone, Debug)]
pub struct PlaneCell {
    pub values: [f64; 2],
    pub found: SteadyMotions,
}

/// Halvings of the way between the middles of two cells that differ.
const HALVINGS: usize = 5;

/// The middles of so many equal parts of a range.
pub fn middles(range: Range, count: usize) -> Vec<f64> {
    let part = |k: usize| range.from + (range.to - range.from) * (2 * k + 1) as f64 / (2 * count) as f64;
    (0..count).map(part).collect()
}

impl PlaneCell {
    /// All motions at two values.
    ///
    /// # Errors
    /// Why steady motions are not sought.
    pub fn at(
        model: &Model,
        asked: &Asked,
        names: [&str; 2],
        values: [f64; 2],
        goes_on: impl FnMut() -> bool,
    ) -> Result<Self, NoSteadyMotions> {
        let found = found_at(model, asked, &[(names[0], values[0]), (names[1], values[1])], goes_on)?;
        Ok(PlaneCell { values, found })
    }

    /// The column of cells at a value of the first parameter.
    ///
    /// # Errors
    /// Why steady motions are not sought, at the first cell where they are not.
    pub fn column(
        model: &Model,
        asked: &Asked,
        [first, second]: [Direction<'_>; 2],
        (value, rows): (f64, usize),
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<Vec<Self>, NoSteadyMotions> {
        let names = [first.0, second.0];
        let at = |other: f64| PlaneCell::at(model, asked, names, [value, other], &mut goes_on);
        middles(second.1, rows).into_iter().map(at).collect()
    }

    /// Whether two cells have as many motions with as many unstable directions each; cells that are not decided have neither.
    pub fn is_like(&self, other: &Self) -> bool {
        let decided = self.found.is_complete() && other.found.is_complete();
        !decided || kinds(&self.found) == kinds(&other.found)
    }

    /// Two values a small part of the way apart between which the motions change, from one cell to another that differs.
    ///
    /// # Errors
    /// Why steady motions are not sought on the way.
    pub fn border(
        &self,
        other: &Self,
        model: &Model,
        asked: &Asked,
        names: [&str; 2],
        mut goes_on: impl FnMut() -> bool,
    ) -> Result<[[f64; 2]; 2], NoSteadyMotions> {
        let [mut near, mut far] = [self.values, other.values];
        for _ in 0..HALVINGS {
            if !goes_on() {
                break;
            }
            let middle = [0.5 * (near[0] + far[0]), 0.5 * (near[1] + far[1])];
            let found = PlaneCell::at(model, asked, names, middle, &mut goes_on)?;
            if !found.found.is_complete() {
                break;
            }
            if self.is_like(&found) { near = middle } else { far = middle }
        }
        Ok([near, far])
    }
}
