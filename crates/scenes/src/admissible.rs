//! Whether bodies with these masses and moments of inertia can exist.

use crate::compiled_system::values;
use derivations::scene::Issue;
use model::{Body, Inertia, Model, ScalarId, Trace};
use symbolic::{apart, substitute_all};

/// The share by which a moment may exceed the sum of the two others, for data with few digits.
const ROUNDING: f64 = 1e-9;

/// All bodies that cannot exist, where numbers tell so: a mass that is not positive, a moment of inertia that is negative, or that is
/// larger than the two others together.
pub fn impossible(model: &Model) -> Vec<Issue> {
    let wanted: Vec<ScalarId> =
        model.bodies.iter().flat_map(|body| body.mass.into_iter().chain(moments(body))).collect();
    let numbers: Vec<Option<f64>> = apart(|| {
        let trace = Trace::of(model);
        let scalars: Vec<_> = wanted.iter().map(|id| trace.scalar(*id)).collect();
        let state: Vec<_> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let numbers = substitute_all(&scalars, &values(&trace, trace.time, &state));
        numbers.iter().map(|number| number.as_constant().map(|value| value.to_f64())).collect()
    });
    let mut numbers = numbers.into_iter();
    let mut issues = Vec::new();
    for body in &model.bodies {
        let mass = body.mass.and_then(|_| numbers.next().flatten());
        let inertia: Vec<Option<f64>> = moments(body).iter().map(|_| numbers.next().flatten()).collect();
        let mut report = |title: String, label: String, accepted: &str| {
            issues.push(Issue::at(body.at.clone(), title, label).accepted(accepted));
        };
        if let Some(mass) = mass.filter(|mass| *mass <= 0.0) {
            report(
                format!("the mass of `{}` must be positive", body.name),
                format!("it is {mass} kg"),
                "a positive mass",
            );
        }
        if let Some(moment) = inertia.iter().flatten().find(|moment| **moment < 0.0) {
            let title = format!("a moment of inertia of `{}` is negative", body.name);
            report(title, format!("it is {moment} kg m^2"), "moments of inertia that are zero or positive");
        }
        if let [Some(a), Some(b), Some(c)] = inertia[..]
            && is_diagonal(body)
            && [[a, b, c], [b, c, a], [c, a, b]]
                .iter()
                .any(|[one, other, last]| *last > (one + other) * (1.0 + ROUNDING))
        {
            let title = format!("no body has the moments of inertia of `{}`", body.name);
            report(title, format!("they are {a}, {b} and {c} kg m^2"), "none is larger than the two others together");
        }
    }
    issues
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
