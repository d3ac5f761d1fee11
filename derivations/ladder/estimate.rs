//! How far a lower model is off, without the richer one's run: the carried error at the instants at which errors are taken.

use super::carried::carried;
use super::{Ladder, Rung};
use integrators::{Absolute, Failure, Method, Record, Span, System, Tolerance, integrate};

/// Instants beside the start: those of the references.
pub const INSTANTS: usize = 8;
/// Evaluations after which an explicit method has met stiffness, or a motion that is not worth following.
const PATIENCE: u64 = 100_000;
/// Relative, of a run that is to show sizes or pilot a choice.
pub const COARSE: f64 = 1e-5;
/// The error need not be known better than to this share of what is allowed.
const OF_ALLOWED: f64 = 1e-2;

/// What of a run matters, with the sizes by which errors are measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    pub names: Vec<String>,
    /// Of the rows that the scene's own problem shows.
    pub columns: Vec<usize>,
    pub sizes: Vec<f64>,
}

/// What a model loses, estimated: relative to the sizes, the largest over the instants, for each output.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    pub each: Vec<f64>,
    /// The largest of them.
    pub first: f64,
    /// The largest term of the second order: where it is not small beside the first, the estimate is no estimate.
    pub second: f64,
    /// Of the law that carries the error.
    pub evaluations: u64,
    /// The rows of the lower run at the instants, with the first order added: better by an order, and of unknown error.
    pub corrected: Vec<Vec<f64>>,
}

impl Estimate {
    /// Of a step that loses nothing.
    pub fn nothing(outputs: usize) -> Self {
        Estimate { each: vec![0.0; outputs], first: 0.0, second: 0.0, evaluations: 0, corrected: Vec::new() }
    }

    /// What is promised: both orders.
    pub fn promised(&self) -> f64 {
        self.first + self.second
    }
}

/// A run at the instants, by an explicit method, or where that meets stiffness by an implicit one.
///
/// # Errors
/// Where neither reaches the end.
pub fn followed(
    law: &dyn System,
    tolerance: &Tolerance,
    span: f64,
    start: &[f64],
) -> Result<(Record<f64>, u64), Failure> {
    let run = |method: Method| {
        let mut record = Record::new();
        let times = Span::new(0.0, span, start).with_even_outputs(INSTANTS).with_evaluations(PATIENCE);
        let outcome = integrate(law, method, tolerance, &times, &mut record);
        let evaluations = outcome.work.rates + outcome.work.jacobians * start.len() as u64;
        (outcome.failure().map_or(Ok(record), Err), evaluations)
    };
    let (explicit, spent) = run(Method::DormandPrince8);
    if let Ok(record) = explicit {
        return Ok((record, spent));
    }
    let (implicit, more) = run(Method::RadauIIA { stages: 3 });
    implicit.map(|record| (record, spent + more))
}

impl Ladder {
    /// The outputs of these names, by a coarse run: the components of a vector by the size of the vector. With the
    /// evaluations that it took.
    ///
    /// # Errors
    /// Where the run does not reach its end.
    pub fn watched(&self, names: &[String]) -> Result<(Watched, u64), Failure> {
        let (law, start) = (&self.law, &self.start);
        let (record, evaluations) = followed(&**law, &Tolerance::both(COARSE), self.own.span, start)?;
        let mut rows = vec![self.row(0.0, &self.start)];
        rows.extend(record.times.iter().zip(&record.states).map(|(time, state)| self.row(*time, state)));
        Ok((self.sized(names, &rows), evaluations))
    }

    /// The outputs of these names, with sizes by these rows.
    pub fn sized(&self, names: &[String], rows: &[Vec<f64>]) -> Watched {
        let size = |column: usize| rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        let place = |name: &String| self.own.columns.iter().position(|known| known == name);
        let known: Vec<(String, usize)> = names.iter().filter_map(|name| Some((name.clone(), place(name)?))).collect();
        let vector = |name: &str| -> Option<f64> {
            let first = name.strip_suffix(['1', '2', '3']).filter(|first| ["w", "v"].contains(first))?;
            let parts = (1..=3).filter_map(|k| place(&format!("{first}{k}")));
            Some(parts.map(|column| size(column).powi(2)).sum::<f64>().sqrt())
        };
        let sizes = known.iter().map(|(name, column)| vector(name).unwrap_or_else(|| size(*column)));
        let sizes = sizes.map(|size| if size > 0.0 { size } else { 1.0 }).collect();
        let (names, columns) = known.into_iter().unzip();
        Watched { names, columns, sizes }
    }

    /// What a rung loses of the outputs; the tolerance says how well that need be known.
    ///
    /// # Errors
    /// Where the carried error does not reach the end: the lower motion leaves what the richer law allows.
    pub fn estimate(&self, rung: &Rung, watched: &Watched, tolerance: f64) -> Result<Estimate, Failure> {
        let outputs = watched.columns.len();
        if rung.is_exact() {
            return Ok(Estimate::nothing(outputs));
        }
        let n = self.start.len();
        let law = carried(&self.written, &rung.lower).ok_or(Failure::Refused(integrators::Refusal::NoSeries))?;
        let (coarse, survey) = followed(&*rung.law, &Tolerance::both(COARSE), self.own.span, &rung.start)?;
        let lifted = |record: &Record<f64>, states: usize| -> Vec<Vec<f64>> {
            record.times.iter().zip(&record.states).map(|(time, z)| rung.lifted(*time, &z[..states], n)).collect()
        };
        let along = lifted(&coarse, rung.start.len());
        let y0 = rung.lifted(0.0, &rung.start, n);
        let largest = |values: &mut dyn Iterator<Item = f64>| {
            let size = values.map(f64::abs).fold(0.0, f64::max);
            if size > 0.0 { size } else { 1.0 }
        };
        let kept = (0..rung.start.len()).map(|i| {
            let values = coarse.states.iter().map(|state| state[i]).chain([rung.start[i]]);
            COARSE * largest(&mut values.into_iter())
        });
        let errors = (0..n).map(|i| {
            let values = along.iter().map(|state| state[i]).chain([self.start[i]]);
            OF_ALLOWED * tolerance * largest(&mut values.into_iter())
        });
        let errors: Vec<f64> = errors.collect();
        let absolute = kept.chain(errors.iter().copied()).chain(errors.iter().copied()).collect();
        let first = self.start.iter().zip(&y0).map(|(y, lifted)| y - lifted);
        let start: Vec<f64> = rung.start.iter().copied().chain(first).chain(vec![0.0; n]).collect();
        let allowed = Tolerance { relative: COARSE, absolute: Absolute::Each(absolute) };
        let (record, spent) = followed(&law, &allowed, self.own.span, &start)?;
        let mut found = Estimate { evaluations: spent + survey, ..Estimate::nothing(outputs) };
        for (time, state) in record.times.iter().zip(&record.states) {
            let (z, errors) = state.split_at(rung.start.len());
            let y = rung.lifted(*time, z, n);
            let row = self.row(*time, &y);
            let moved = |error: &[f64]| {
                let moved: Vec<f64> = y.iter().zip(error).map(|(y, e)| y + e).collect();
                self.row(*time, &moved)
            };
            let (first, second) = (moved(&errors[..n]), moved(&errors[n..]));
            for (each, (&at, size)) in found.each.iter_mut().zip(watched.columns.iter().zip(&watched.sizes)) {
                *each = each.max((first[at] - row[at]).abs() / size);
            }
            found.second = found.second.max(watched.off(&second, &row));
            found.corrected.push(first);
        }
        found.first = found.each.iter().copied().fold(0.0, f64::max);
        if found.promised().is_finite() { Ok(found) } else { Err(Failure::LeftTheNumbers { at: self.own.span }) }
    }

    /// The largest value of a rung's small parameter along its own run; none where it has none, or no run.
    pub fn small(&self, rung: &Rung) -> Option<f64> {
        let small = rung.small.as_ref()?;
        let (record, _) = followed(&*rung.law, &Tolerance::both(COARSE), self.own.span, &rung.start).ok()?;
        let mut rates = vec![0.0; rung.start.len()];
        let mut largest = None;
        for (time, z) in record.times.iter().zip(&record.states).chain([(&0.0, &rung.start)]) {
            rung.law.rates(*time, z, &mut rates);
            largest = small(z, &rates).map(|value| value.max(largest.unwrap_or(0.0)));
        }
        largest
    }

    /// The largest difference of two runs in the outputs, relative to the sizes: a rung's beside the law that it is derived
    /// from.
    pub fn difference(&self, rung: &Rung, low: &Record<f64>, rich: &Record<f64>, watched: &Watched) -> f64 {
        let at = |((time, z), y): ((&f64, &Vec<f64>), &Vec<f64>)| {
            let low = self.row(*time, &rung.lifted(*time, z, self.start.len()));
            watched.off(&low, &self.row(*time, y))
        };
        low.times.iter().zip(&low.states).zip(&rich.states).map(at).fold(0.0, f64::max)
    }
}

impl Watched {
    /// The largest difference of two rows, relative to the sizes.
    pub fn off(&self, one: &[f64], other: &[f64]) -> f64 {
        let each = self.columns.iter().zip(&self.sizes).map(|(&at, size)| (one[at] - other[at]).abs() / size);
        each.fold(0.0, f64::max)
    }
}
