//! Whether bodies with these masses and moments of inertia can exist.

use crate::compiled_system::NotCompiled;
use crate::letters::{Inputs, Letters};
use derivations::scene::Issue;
use model::{Body, Inertia, Model, ScalarId, Trace};
use std::ops::Range;
use symbolic::{Sym, Tape, apart};

/// The share by which a moment may exceed the sum of the two others, for data with few digits.
const ROUNDING: f64 = 1e-9;

/// All bodies that cannot exist, where numbers tell so: a mass that is not positive, a moment of inertia that is negative, or that is
/// larger than the two others together.
pub fn impossible(model: &Model) -> Vec<Issue> {
    let numbers: Vec<Option<f64>> = apart(|| {
        let trace = Trace::of(model);
        let state: Vec<_> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let numbers = Letters::with_data(trace.time, &state).put_into(&trace, &scalars(model, &trace));
        numbers.iter().map(|number| number.as_constant().map(|value| value.to_f64())).collect()
    });
    judged(model, &numbers)
}

/// Masses and moments of inertia as functions of the parameters.
#[derive(Debug)]
pub(crate) struct BodyNumbers {
    tape: Tape,
    /// Which of them depend on nothing else: of the others no number tells whether they are possible.
    constant: Vec<bool>,
}

impl BodyNumbers {
    /// Writes them down.
    ///
    /// # Errors
    /// Where they have no values.
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

    /// All bodies that cannot exist with these values of the parameters.
    pub fn impossible(&self, model: &Model, parameters: &[f64]) -> Vec<Issue> {
        let mut values = vec![f64::NAN; self.constant.len()];
        self.tape.over().evaluate(parameters, &mut values);
        let known = values.iter().zip(&self.constant);
        let numbers: Vec<Option<f64>> = known.map(|(value, constant)| constant.then_some(*value)).collect();
        judged(model, &numbers)
    }
}

/// Mass and moments of inertia of each body, one body after the other.
fn scalars(model: &Model, trace: &Trace<'_>) -> Vec<Sym> {
    let wanted = model.bodies.iter().flat_map(|body| body.mass.into_iter().chain(moments(body)));
    wanted.map(|id| trace.scalar(id)).collect()
}

/// Bodies that cannot exist by the numbers of [`scalars`]; a number that is none is not judged.
fn judged(model: &Model, numbers: &[Option<f64>]) -> Vec<Issue> {
    let mut numbers = numbers.iter().copied();
    let mut issues = Vec::new();
    for body in &model.bodies {
        let mass = body.mass.and_then(|_| numbers.next().flatten());
        let inertia: Vec<Option<f64>> = moments(body).iter().map(|_| numbers.next().flatten()).collect();
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
        if let Some(moment) = inertia.iter().flatten().find(|moment| **moment < 0.0) {
            let title = format!("a moment of inertia of `{}` is negative", body.name);
            report(
                &body.inertia_at,
                title,
                format!("it is {} kg m^2", shown(*moment)),
                "moments of inertia that are zero or positive",
            );
        }
        if let [Some(a), Some(b), Some(c)] = inertia[..]
            && is_diagonal(body)
            && [[a, b, c], [b, c, a], [c, a, b]]
                .iter()
                .any(|[one, other, last]| *last > (one + other) * (1.0 + ROUNDING))
        {
            let title = format!("no body has the moments of inertia of `{}`", body.name);
            report(
                &body.inertia_at,
                title,
                format!("they are {}, {} and {} kg m^2", shown(a), shown(b), shown(c)),
                "none is larger than the two others together",
            );
        }
    }
    issues
}

/// A number without the rounding of its last digits.
fn shown(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// About axes, products of inertia left out.
fn moments(body: &Body) -> Vec<ScalarId> {
    match &body.inertia {
        None => Vec::new(),
        Some(Inertia::Axial(axial)) => vec![*axial],
        Some(Inertia::Tensor { entries, .. }) => entries[..3].iter().copied().flatten().collect(),
    }
}

fn is_diagonal(body: &Body) -> bool {
    matches!(&body.inertia, Some(Inertia::Tensor { entries, .. }) if entries[3..].iter().all(Option::is_none))
}
