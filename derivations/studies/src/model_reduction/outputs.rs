//! The outputs of interest of a run, and the sizes relative to which their errors are measured.

use super::Hierarchy;
use super::plan::is_stiff_at;
use super::sampled_run::{COARSE, followed_while, looks};
use integrators::{Failure, Tolerance};

/// The outputs of interest, with their sizes.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    pub names: Vec<String>,
    /// The indices of the outputs in the rows of the scene's own problem.
    pub columns: Vec<usize>,
    pub sizes: Vec<f64>,
    /// The sizes of the states of the law from which models are derived.
    pub states: Vec<f64>,
    /// Whether that law is stiff; its error equations then are too.
    pub stiff: bool,
    /// The reason why the run of the scene's own model left its law, if it did.
    pub left: Option<&'static str>,
    /// An output that is undefined at a time of the run, with that time, s.
    pub without_value: Option<(String, f64)>,
}

/// Outputs below this count as zero, and have the size one.
const ROUNDING: f64 = 1e-12;

/// The largest absolute value; 1 where all vanish within rounding.
pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    let size = values.map(f64::abs).fold(0.0, f64::max);
    if size > ROUNDING { size } else { 1.0 }
}

impl Hierarchy {
    /// The outputs with these names, with sizes from a coarse run; and the number of its evaluations.
    ///
    /// # Errors
    /// [`Failure`] of the run.
    pub fn watched(&self, names: &[String]) -> Result<(Watched, u64), Failure> {
        if self.own.switching.is_some() {
            return self.watched_across_events(names);
        }
        let (law, start) = (&self.law, &self.start);
        let outputs: Vec<f64> = looks(self.own.span).collect();
        let mut stiff = is_stiff_at(&**law, start, self.own.span);
        let coarse = Tolerance::both(COARSE);
        let mut seen = vec![(0.0, start.clone())];
        let mut left = None;
        let mut keep = |time: f64, state: &[f64]| {
            // the implicit method starts again from the beginning
            if seen.last().is_some_and(|(last, _)| time < *last) {
                seen.truncate(1);
            }
            seen.push((time, state.to_vec()));
            left = self.left(time, state);
            left.is_none()
        };
        let (_, evaluations) = followed_while(&**law, &coarse, 0.0, &outputs, start, &mut stiff, &mut keep)?;
        let rows: Vec<Vec<f64>> = seen.iter().map(|(time, state)| self.row(*time, state)).collect();
        let sizes = (0..start.len()).map(|i| largest(seen.iter().map(|(_, state)| state[i]))).collect();
        Ok((Watched { stiff, left, ..Watched::of(&self.own.columns, names, &rows, sizes) }, evaluations))
    }
}

impl Watched {
    /// The outputs with these names, with sizes from these rows; components of a vector have the size of the vector.
    pub fn of(columns: &[String], names: &[String], rows: &[Vec<f64>], states: Vec<f64>) -> Self {
        let size = |column: usize| rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        let place = |name: &String| columns.iter().position(|known| known == name);
        let known: Vec<(String, usize)> = names.iter().filter_map(|name| Some((name.clone(), place(name)?))).collect();
        let vector = |name: &str| -> Option<f64> {
            let first = name.strip_suffix(['1', '2', '3']).filter(|first| ["w", "v"].contains(first))?;
            let parts = (1..=3).filter_map(|k| place(&format!("{first}{k}")));
            Some(parts.map(|column| size(column).powi(2)).sum::<f64>().sqrt())
        };
        let sizes = known.iter().map(|(name, column)| vector(name).unwrap_or_else(|| size(*column)));
        let sizes = sizes.map(|size| if size > ROUNDING { size } else { 1.0 }).collect();
        let (names, columns) = known.into_iter().unzip();
        Watched { names, columns, sizes, states, stiff: false, left: None, without_value: None }
    }

    /// The largest difference of two rows, relative to the sizes.
    pub fn off(&self, one: &[f64], other: &[f64]) -> f64 {
        let each = self.columns.iter().zip(&self.sizes).map(|(&at, size)| (one[at] - other[at]).abs() / size);
        // NaN counts as an infinite difference
        each.map(|off| if off.is_nan() { f64::INFINITY } else { off }).fold(0.0, f64::max)
    }
}
