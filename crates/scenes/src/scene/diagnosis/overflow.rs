//! Exponentials that are larger than every number: a law that divides by one has the value zero there, and no derivatives.

use super::domain::{has_lost_numbers, margin};
use super::samples::Samples;
use model::DomainEnd;
use simulation::{FailureKind, RunFailure};

/// The first exponential of the law that is too large where a run has stopped.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    if !has_lost_numbers(run) {
        return None;
    }
    let (at, state) = run.last();
    let exponentials = run.model().domains.iter().zip(run.scene.domain_texts());
    let mut large = exponentials.filter(|(domain, _)| domain.end == DomainEnd::Large).filter_map(|(domain, own)| {
        let exponent = margin(run.model(), domain)?(at, state);
        (exponent > f64::MAX.ln()).then_some((exponent, own))
    });
    let (exponent, (text, line)) = large.next()?;
    Some(RunFailure {
        kind: FailureKind::Overflow,
        at,
        evidence: format!(
            "`{text}` in line {line} holds the exponential of {exponent:.4e} there, beyond every number; where the law divides by it, it has a \
             value, and its derivatives have none, which this method takes"
        ),
        remedy:
            "a form of the law without large exponents: 1/cosh(u) is 2*exp(-abs(u))/(1 + exp(-2*abs(u))); or `--method \
                 dormand_prince_8`, which takes no derivatives"
                .to_owned(),
    })
}
