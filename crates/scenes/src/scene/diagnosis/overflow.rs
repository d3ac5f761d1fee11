//! Diagnosis of overflow: an exponential, or its square in a derivative, exceeds the range of double precision.

use super::domain::{has_lost_numbers, margin, rates};
use super::samples::Samples;
use model::DomainEnd;
use simulation::{FailureKind, RunFailure};

/// Fraction of ln(f64::MAX) from which an exponent counts as large: derivatives of quotients contain squares, and a run ends a step before.
const LARGE: f64 = 0.48;

/// The failure of a run that stopped at an overflow, with the largest exponential of the law at its last state.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    if !has_lost_numbers(run) {
        return None;
    }
    let (at, state) = run.last();
    let exponentials = run.model().domains.iter().zip(run.scene.domain_texts());
    let large = exponentials.filter(|(domain, _)| domain.end == DomainEnd::Large).filter_map(|(domain, own)| {
        let exponent = margin(run.model(), domain)?(at, state);
        (exponent > LARGE * f64::MAX.ln()).then_some((exponent, own))
    });
    let (exponent, (text, line)) = large.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let has_rates = exponent > f64::MAX.ln() && rates(run, at, state).iter().all(|rate| rate.is_finite());
    let what = match exponent > f64::MAX.ln() {
        true => "beyond every number",
        false => "so large that its square, or the next step, is beyond every number",
    };
    let why = match has_rates {
        true => "; the law divides by it and has a value, but no derivatives, which this method takes",
        false => "",
    };
    let other = if has_rates { "; or `--method dormand_prince_8`, which takes no derivatives" } else { "" };
    Some(RunFailure {
        kind: FailureKind::Overflow,
        at,
        evidence: format!("`{text}` in line {line} holds the exponential of {exponent:.4e} there, {what}{why}"),
        remedy: format!(
            "a form of the law without large exponents: 1/cosh(u) is 2*exp(-abs(u))/(1 + exp(-2*abs(u))), sinh(u)/cosh(u) is tanh(u), \
             ln(1 + exp(u)) is max(u, 0) + ln(1 + exp(-abs(u))){other}"
        ),
    })
}
