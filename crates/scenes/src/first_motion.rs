//! The motion at the start: why its accelerations have no value there, where they have none.
//!
//!   [ M  J^T ] [   u'    ]   [ -h ]
//!   [ J   0  ] [ -lambda ] = [ -c ]
//!
//! A direction that this matrix takes to zero moves nothing with inertia and breaks no constraint: a coordinate that loses its meaning
//! there, as the azimuth of spherical angles does at the pole.

use crate::compiled_system::{CompiledSystem, NotCompiled};
use crate::implicit::linear_equations;
use crate::letters::Letters;
use crate::modes::Case;
use derivations::scene::Issue;
use derivations::taped::Program;
use integrators::Ode;
use model::{Model, Trace};
use nalgebra::DMatrix;
use symbolic::{Sym, substitute_all};

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-11;

/// Why the motion does not begin, where it does not.
pub fn missing(model: &Model, system: &CompiledSystem, start: &[f64]) -> Option<Issue> {
    let mut rates = vec![0.0; start.len()];
    Ode::<f64>::rates(system, 0.0, start, &mut rates);
    if rates.iter().all(|rate| rate.is_finite()) {
        return None;
    }
    let n = model.speeds();
    let terms = Terms::of(model, &system.mode, start)?;
    // a free frame stands for its three speeds
    let moved = |speed: usize| match model.coordinates.get(speed) {
        Some(coordinate) => (coordinate.name.clone(), coordinate.at.clone()),
        None => (model.state_names()[model.positions() + speed].0.clone(), 0..0),
    };
    let without_value = |row: &[f64]| row.iter().position(|entry| !entry.is_finite());
    if let Some(place) = without_value(&terms.matrix) {
        let (name, at) = moved((place % terms.size).min(n - 1));
        let title = format!("the inertia of `{name}` has no value at the start");
        return Some(Issue::at(at, title, "of this coordinate").accepted(NO_NUMBER));
    }
    if let Some(place) = without_value(&terms.right[..n]) {
        let (name, at) = moved(place);
        let title = format!("the forces on `{name}` have no value at the start");
        return Some(Issue::at(at, title, "its acceleration would be no number").accepted(NO_NUMBER));
    }
    let (name, at) = moved(terms.free(n)?);
    let elsewhere: Vec<f64> = start.iter().zip(1..).map(|(part, place)| part + 0.1 * f64::from(place)).collect();
    let there = Terms::of(model, &system.mode, &elsewhere).filter(|terms| without_value(&terms.matrix).is_none());
    if there.and_then(|terms| terms.free(n)).is_some() {
        let massless = NotCompiled::Massless { coordinate: name };
        let issue = Issue::at(at, format!("this system cannot run: {massless}"), "this coordinate");
        return Some(issue.accepted("a body that moves with it, or a constraint that determines it"));
    }
    let title = format!("the acceleration of `{name}` is not determined at the start");
    let issue = Issue::at(at, title, "in this position nothing with inertia moves with it");
    Some(issue.accepted(
        "another start, or other coordinates: spherical angles have no azimuth at the pole, three turns none where the first axis meets the third",
    ))
}

const NO_NUMBER: &str = "another start: a division by zero, `unit` of a zero vector, a force between points that coincide, \
                         `ln` or `sqrt` of a negative number have no value";

/// The matrix and the right side at a state.
struct Terms {
    size: usize,
    /// Row after row.
    matrix: Vec<f64>,
    right: Vec<f64>,
}

impl Terms {
    fn of(model: &Model, mode: &[Case], start: &[f64]) -> Option<Self> {
        let mut pattern = None;
        let program = Program::of_any_length(start.len(), |time, state| {
            let trace = Trace::of(model);
            let solve = linear_equations(&trace, Letters::with_data(time, state));
            let all = solve.expressions();
            pattern = Some(solve.pattern);
            let case = |case: &Case| if *case == Case::On { Sym::ONE } else { Sym::ZERO };
            let cases: Vec<(Sym, Sym)> = trace.switches.iter().copied().zip(mode.iter().map(case)).collect();
            substitute_all(&all, &cases)
        })?;
        let pattern = pattern?;
        let (places, size) = (pattern.places(), pattern.size());
        let mut found = vec![f64::NAN; places.len() + size];
        program.run(0.0, start, &mut found)?;
        let right = found.split_off(places.len());
        let mut matrix = vec![0.0; size * size];
        places.iter().zip(found).for_each(|(&(row, column), entry)| matrix[row * size + column] = entry);
        Some(Terms { size, matrix, right })
    }

    /// The one of the first n unknowns that is moved most by a direction that the matrix takes to zero.
    fn free(&self, n: usize) -> Option<usize> {
        let decomposed = DMatrix::from_row_slice(self.size, self.size, &self.matrix).svd(false, true);
        let (least, smallest) = decomposed.singular_values.argmin();
        if smallest > RANK * decomposed.singular_values.amax() {
            return None;
        }
        let direction = decomposed.v_t.as_ref()?.row(least).columns(0, n).transpose();
        Some(direction.abs().argmax().0)
    }
}
