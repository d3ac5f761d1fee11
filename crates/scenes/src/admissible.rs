//! Checks that masses and moments of inertia are physically possible.

use crate::compiled_system::NotCompiled;
use crate::letters::{Inputs, Letters};
use model::{Body, Inertia, Model, ScalarId, Trace};
use nalgebra::Matrix3;
use reader::Issue;
use std::ops::Range;
use symbolic::{Sym, Tape, apart};

/// Tolerance of the triangle inequality between principal moments of inertia, as a part of their sum: printed data have few digits.
const ROUNDING: f64 = 1e-9;

/// Returns an issue for each body that is physically impossible: its mass is not positive, or a principal moment of inertia is negative
/// or larger than the sum of the two others. Masses and moments that are not constant numbers are skipped.
pub fn impossible(model: &Model) -> Vec<Issue> {
    let numbers: Vec<Option<f64>> = apart(|| {
        let trace = Trace::of(model);
        let state: Vec<_> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let numbers = Letters::with_data(trace.time, &state).put_into(&trace, &scalars(model, &trace));
        numbers.iter().map(|number| number.as_constant().map(|value| value.to_f64())).collect()
    });
    judged(model, &numbers)
}

/// Masses, moments and products of inertia as functions of the parameters.
#[derive(Debug)]
pub(crate) struct BodyNumbers {
    tape: Tape,
    /// For each output of the tape: true if the number depends on parameters alone. Other numbers are not checked.
    constant: Vec<bool>,
}

impl BodyNumbers {
    /// Compiles the functions of a model.
    ///
    /// # Errors
    /// An expression has no value.
    pub fn of(model: &Model) -> Result<Self, NotCompiled> {
        apart(|| {
            let trace = Trace::of(model);
            let inputs = Inputs::of(model);
            let mut numbers = inputs.letters().put_into(&trace, &scalars(model, &trace));
            let constant: Vec<bool> = numbers
                .iter()
                .map(|one| one.symbols_of().iter().all(|used| inputs.parameters.contains(used)))
                .collect();
            for (number, _) in numbers.iter_mut().zip(&constant).filter(|(_, constant)| !**constant) {
                *number = Sym::ZERO;
            }
            let tape = Tape::record(&inputs.parameters, &numbers);
            let tape = tape.map_err(|reason| NotCompiled::Undefined { reason: reason.to_string() })?;
            Ok(BodyNumbers { tape, constant })
        })
    }

    /// An issue for each body that is physically impossible with these values of the parameters, in SI units.
    pub fn impossible(&self, model: &Model, parameters: &[f64]) -> Vec<Issue> {
        let mut values = vec![f64::NAN; self.constant.len()];
        self.tape.over().evaluate(parameters, &mut values);
        let known = values.iter().zip(&self.constant);
        let numbers: Vec<Option<f64>> = known.map(|(value, constant)| constant.then_some(*value)).collect();
        judged(model, &numbers)
    }
}

/// Mass (kg), moments and products of inertia (kg m²) of each body, body by body; only those that the model gives.
fn scalars(model: &Model, trace: &Trace<'_>) -> Vec<Sym> {
    let wanted = model.bodies.iter().flat_map(|body| body.mass.into_iter().chain(entries(body).into_iter().flatten()));
    wanted.map(|id| trace.scalar(id)).collect()
}

/// An issue for each impossible body. `numbers` has the order of [`scalars`]; `None` is not checked.
fn judged(model: &Model, numbers: &[Option<f64>]) -> Vec<Issue> {
    let mut numbers = numbers.iter().copied();
    let mut issues = Vec::new();
    for body in &model.bodies {
        let mass = body.mass.and_then(|_| numbers.next().flatten());
        let inertia = entries(body).map(|entry| entry.map(|_| numbers.next().flatten()));
        let mut report = |at: &Range<usize>, title: String, label: String, accepted: &str| {
            issues.push(Issue::at(at.clone(), title, label).accepted(accepted));
        };
        if let Some(mass) = mass.filter(|mass| *mass <= 0.0) {
            report(
                &body.mass_at,
                format!("the mass of `{}` must be positive", body.name),
                format!("it is {} kg", shown(mass)),
                "a positive mass",
            );
        }
        let moments = inertia[..3].iter().flatten().flatten();
        if let Some(moment) = moments.copied().find(|moment| *moment < 0.0) {
            let title = format!("a moment of inertia of `{}` is negative", body.name);
            let label = format!("it is {} kg m^2", shown(moment));
            report(&body.inertia_at, title, label, "moments of inertia that are zero or positive");
        } else if let Some([a, b, c]) = principal(&inertia).filter(|moments| !is_possible(*moments)) {
            let title = format!("the moments of inertia of `{}` are impossible", body.name);
            let about = match inertia[3..].iter().any(Option::is_some) {
                true => "about its principal axes they are",
                false => "they are",
            };
            let label = format!("{about} {}, {} and {} kg m^2", shown(a), shown(b), shown(c));
            report(
                &body.inertia_at,
                title,
                label,
                "three moments of which none is larger than the sum of the two others",
            );
        }
    }
    issues
}

/// The principal moments of inertia, kg m². `inertia` is xx, yy, zz, xy, xz, yz. `None` if xx, yy or zz is not given, or an entry is not
/// a number. Without products of inertia the axes are principal, and xx, yy, zz are returned.
fn principal(inertia: &[Option<Option<f64>>; 6]) -> Option<[f64; 3]> {
    let [xx, yy, zz, ..] = *inertia;
    let [xx, yy, zz] = [xx??, yy??, zz??];
    if inertia[3..].iter().all(Option::is_none) {
        return Some([xx, yy, zz]);
    }
    let product = |entry: Option<Option<f64>>| entry.map_or(Some(0.0), |number| number);
    let [xy, xz, yz] = [product(inertia[3])?, product(inertia[4])?, product(inertia[5])?];
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    if !tensor.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let mut moments: [f64; 3] = tensor.symmetric_eigenvalues().into();
    moments.sort_by(f64::total_cmp);
    Some(moments)
}

/// The triangle inequality of principal moments of inertia: each is the sum of two of the three second moments of the mass distribution,
/// which are not negative.
fn is_possible([a, b, c]: [f64; 3]) -> bool {
    let rounding = ROUNDING * (a.abs() + b.abs() + c.abs());
    [[a, b, c], [b, c, a], [c, a, b]].iter().all(|[one, other, last]| *last <= one + other + rounding)
}

/// The number rounded to twelve significant digits, without the rounding errors of the eigenvalues.
pub(crate) fn shown(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// The entries xx, yy, zz, xy, xz, yz of a body's tensor of inertia, where they are given. A body with one moment has it in place of xx.
fn entries(body: &Body) -> [Option<ScalarId>; 6] {
    match &body.inertia {
        None => [None; 6],
        Some(Inertia::Axial(axial) | Inertia::OfShaft { moment: axial, .. }) => {
            [Some(*axial), None, None, None, None, None]
        }
        Some(Inertia::Tensor { entries, .. }) => *entries,
    }
}
