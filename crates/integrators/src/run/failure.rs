//! The reasons why a run can fail.

use std::fmt;

/// The reason why a run failed. Times in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The data were rejected before the first step.
    Refused(Refusal),
    /// The step size required by the tolerance is below rounding.
    StepCollapsed { at: f64, step: f64 },
    /// The budget of evaluations was exhausted.
    TooManyEvaluations { at: f64, allowed: u64 },
    /// The deadline passed.
    OutOfTime { at: f64 },
    /// The user requested the end.
    Interrupted { at: f64 },
    /// Newton's iteration did not converge for any step size above rounding.
    NewtonFailed { at: f64, step: f64 },
    /// The rates or the state become infinite or undefined after this time.
    LeftTheNumbers { at: f64 },
    /// The problem is stiff for this explicit method: stability, not accuracy, limits its step size.
    Stiff { at: f64 },
    /// A negative sub-step of the relative length `back` would amplify a component with the decay rate `rate` (1/s) too
    /// much; `most` is the largest usable step size.
    GoesBack { at: f64, step: f64, back: f64, rate: f64, most: f64 },
    /// The matrix of an implicit step is singular for every step size tried.
    Singular { at: f64 },
    /// The motion ended at an event before the motion it is compared with.
    OtherCourse { at: f64 },
}

impl Failure {
    /// Whether the run was stopped by a clock or the user: it might have continued.
    pub fn is_broken_off(&self) -> bool {
        matches!(self, Failure::OutOfTime { .. } | Failure::Interrupted { .. })
    }

    /// The failure of a run in the time s, with its times converted by t = start + pace s.
    pub fn in_time(self, start: f64, pace: f64) -> Self {
        let time = |s: f64| start + pace * s;
        match self {
            Failure::Refused(_) => self,
            Failure::StepCollapsed { at, step } => Failure::StepCollapsed { at: time(at), step: pace * step },
            Failure::TooManyEvaluations { at, allowed } => Failure::TooManyEvaluations { at: time(at), allowed },
            Failure::OutOfTime { at } => Failure::OutOfTime { at: time(at) },
            Failure::Interrupted { at } => Failure::Interrupted { at: time(at) },
            Failure::NewtonFailed { at, step } => Failure::NewtonFailed { at: time(at), step: pace * step },
            Failure::LeftTheNumbers { at } => Failure::LeftTheNumbers { at: time(at) },
            Failure::Stiff { at } => Failure::Stiff { at: time(at) },
            Failure::GoesBack { at, step, back, rate, most } => {
                Failure::GoesBack { at: time(at), step: pace * step, back, rate: rate / pace, most: pace * most }
            }
            Failure::Singular { at } => Failure::Singular { at: time(at) },
            Failure::OtherCourse { at } => Failure::OtherCourse { at: time(at) },
        }
    }

    /// The name of the failure without its numbers; failures are counted by it.
    pub fn name(&self) -> &'static str {
        match self {
            Failure::Refused(_) => "refused",
            Failure::StepCollapsed { .. } => "step collapsed",
            Failure::TooManyEvaluations { .. } => "too many evaluations",
            Failure::OutOfTime { .. } => "out of time",
            Failure::Interrupted { .. } => "interrupted",
            Failure::NewtonFailed { .. } => "Newton did not converge",
            Failure::LeftTheNumbers { .. } => "overflow or NaN",
            Failure::Stiff { .. } => "stiff",
            Failure::GoesBack { .. } => "backward sub-steps amplify decaying parts",
            Failure::Singular { .. } => "singular matrix",
            Failure::OtherCourse { .. } => "another sequence of events",
        }
    }
}

/// The reason why data were rejected, with the accepted range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    SpanEmpty { start: f64, end: f64 },
    SpanNotFinite { start: f64, end: f64 },
    Dimension { expected: usize, found: usize },
    StateNotFinite { component: usize },
    RatesNotFinite { component: usize },
    Relative { given: f64, least: f64 },
    Absolute { given: f64 },
    AbsoluteCount { expected: usize, found: usize },
    Output { index: usize, time: f64, start: f64, end: f64 },
    NoBudget,
    Steps { given: u32 },
    Stages { given: usize, least: usize, most: usize },
    NoSeries,
    NoPieces,
    TooLarge { dimension: usize, most: usize },
    Field,
    FollowsTolerance,
}

/// A time for display: six digits, with a power of ten where plain digits would be zeros.
pub(crate) struct Instant(pub f64);

impl fmt::Display for Instant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.abs() {
            0.0 => write!(f, "0"),
            size if (1e-3..1e6).contains(&size) => {
                let decimals = (5 - size.log10().floor() as i32).max(0) as usize;
                let plain = format!("{:.decimals$}", self.0);
                let trimmed = if decimals > 0 { plain.trim_end_matches('0').trim_end_matches('.') } else { &plain };
                write!(f, "{trimmed}")
            }
            _ => write!(f, "{:.5e}", self.0),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Refused(refusal) => write!(f, "refused: {refusal}"),
            Failure::StepCollapsed { at, step } => {
                write!(
                    f,
                    "step collapsed at t = {}: the tolerance requires a step of {step:.1e}, which is below rounding",
                    Instant(*at)
                )
            }
            Failure::TooManyEvaluations { at, allowed } => {
                write!(f, "too many evaluations: the {allowed} allowed were spent at t = {}", Instant(*at))
            }
            Failure::OutOfTime { at } => write!(f, "out of time: the deadline passed at t = {}", Instant(*at)),
            Failure::Interrupted { at } => write!(f, "interrupted at t = {}", Instant(*at)),
            Failure::NewtonFailed { at, step } => {
                write!(f, "Newton did not converge at t = {}, with a step down to {step:.1e}", Instant(*at))
            }
            Failure::LeftTheNumbers { at } => {
                write!(f, "overflow or NaN: the rates or the state are not finite after t = {} s", Instant(*at))
            }
            Failure::Stiff { at } => {
                write!(
                    f,
                    "stiff at t = {}: an explicit method wastes its steps here, take an implicit one",
                    Instant(*at)
                )
            }
            Failure::GoesBack { at, step, back, rate, most } => {
                let growth = rate * step * back;
                write!(
                    f,
                    "backward sub-steps amplify decaying parts at t = {}: a sub-step goes back by {back:.3} of the step {step:.2e}, and a part that \
                     decays at a rate of {rate:.2e} would grow by exp({growth:.1}); a step of at most {most:.2e} is accepted, and any step with \
                     Strang's splitting",
                    Instant(*at)
                )
            }
            Failure::Singular { at } => {
                write!(f, "the matrix of the implicit step is singular at t = {}", Instant(*at))
            }
            Failure::OtherCourse { at } => {
                write!(f, "another sequence of events: the run ended at t = {}", Instant(*at))
            }
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::SpanEmpty { start, end } => {
                write!(f, "the span from {start} to {end} is empty; start and end must differ")
            }
            Refusal::SpanNotFinite { start, end } => {
                write!(f, "the span from {start} to {end} is not finite; both ends must be numbers")
            }
            Refusal::Dimension { expected, found } => {
                write!(f, "the state has {found} components; the system has {expected}, at least one is needed")
            }
            Refusal::StateNotFinite { component } => {
                write!(f, "component {component} of the initial state is not finite; every one must be a number")
            }
            Refusal::RatesNotFinite { component } => {
                write!(f, "the rate of component {component} is not finite at the initial state; start where it is")
            }
            Refusal::Relative { given, least } => {
                write!(f, "the relative tolerance is {given:e}; a number from {least:.1e} to below 1 is accepted")
            }
            Refusal::Absolute { given } => {
                write!(f, "an absolute tolerance is {given:e}; a positive number is accepted")
            }
            Refusal::AbsoluteCount { expected, found } => {
                write!(f, "{found} absolute tolerances are given; one, or {expected}, are accepted")
            }
            Refusal::Output { index, time, start, end } => {
                write!(f, "output {index} at t = {time}; outputs must follow each other from {start} to {end}")
            }
            Refusal::NoBudget => write!(f, "the budget is 0 evaluations; at least 1 is needed"),
            Refusal::Steps { given } => write!(f, "{given} steps are asked for; at least 1 is needed"),
            Refusal::Stages { given, least, most } => {
                write!(f, "{given} stages are asked for; from {least} to {most} are accepted")
            }
            Refusal::NoSeries => {
                write!(
                    f,
                    "the system has no Taylor series, or one of too many products; another method runs it, such as dormand_prince_8"
                )
            }
            Refusal::NoPieces => {
                write!(f, "the system is not known in pieces whose flows are known; another method runs it")
            }
            Refusal::TooLarge { dimension, most } => {
                write!(f, "the state has {dimension} components; this method takes at most {most}")
            }
            Refusal::FollowsTolerance => {
                write!(f, "this method follows a tolerance; here one with a constant step is accepted")
            }
            Refusal::Field => write!(f, "this method runs in f64 only; in double-double take an own method"),
        }
    }
}

impl std::error::Error for Failure {}
impl std::error::Error for Refusal {}

#[cfg(test)]
mod tests {
    use super::Failure;

    #[test]
    fn times_read_well_at_every_size() {
        let read = |at: f64| Failure::OutOfTime { at }.to_string().split("t = ").nth(1).unwrap_or_default().to_owned();
        assert_eq!(
            [0.0, 2.0, 0.123456789, 1234.5678, 3.2e-9].map(read),
            ["0", "2", "0.123457", "1234.57", "3.20000e-9"]
        );
    }

    #[test]
    fn a_failure_of_a_stretch_is_told_in_the_time_of_the_run() {
        let found = Failure::StepCollapsed { at: 0.5, step: 1e-9 }.in_time(2.0, 4.0);
        assert_eq!(found, Failure::StepCollapsed { at: 4.0, step: 4e-9 });
    }
}
