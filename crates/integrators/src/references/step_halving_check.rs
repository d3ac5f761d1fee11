//! A check by step halving: whether a run with a constant step approximates a motion of its law.
//!
//! A method with a constant step has no error estimate. It may step over a pole of the law and continue beyond it,
//! where the rates are finite again. Runs with shorter steps, which differ there, detect this. With y_n the run with n
//! times as many steps,
//!
//!   d_1 = |y_1 - y_2| ,   d_2 = |y_2 - y_4| ,   d_2/d_1 -> 2^-p <= 1/2   with the order p, where there is a motion to converge to.
//!
//! A run departs from its law if d_1 of some state exceeds the size of this state, or if d_1 is visible and d_2 is not
//! smaller. A difference is visible if it is at least a given fraction of the state's size over the whole run: the
//! beginning of a motion from rest is thereby ignored. All numbers are the largest up to a time: a single instant where
//! a difference happens to vanish is thereby ignored. Slow convergence is no departure: its error is d_1/(1 - 2^-p),
//! and is reported. The reported time is that at which the departure becomes visible; its cause lies earlier.

use crate::run::failure::Instant;
use crate::{Failure, Method, Outcome, Record, Work};
use std::fmt;

/// The result of the comparison of a run with runs of shorter steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepHalvingVerdict {
    /// The runs converge. With half the step, states differ by at most the fraction `apart` of their size.
    Converges { apart: f64 },
    /// The runs with shorter steps differ visibly from the time `from` (s) on.
    Departs { from: f64 },
    /// The runs with shorter steps end at the time `at` (s), for the reason `why`.
    Stops { at: f64, why: &'static str },
    /// The budget of work or time was too small for a decision.
    Undecided,
}

/// The result of the check, and its work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepHalvingCheck {
    pub verdict: StepHalvingVerdict,
    pub work: Work,
}

/// A run with shorter steps: its outcome, its record at the times of the checked run, and the reason if the law ended.
pub type ShorterRun = (Outcome<f64>, Record<f64>, Option<&'static str>);

/// A difference is visible from this fraction of a state's size on.
const SEEN: f64 = 0.01;
/// The largest ratio d_2/d_1 that counts as convergence; a method of order 1 has 0.5.
const SLOWEST: f64 = 0.75;
/// The fraction of a state's size above which the run is unusable: for order 1, the error is twice the difference to
/// half the step.
const WHOLE: f64 = 0.5;
/// A state smaller than this fraction of the largest state is rounding.
const ROUNDING: f64 = 1e-9;

/// Checks a run that reached its end by runs with half its step and, if necessary, a quarter. `record` holds the outputs of this run; `run` repeats
/// it by a given method, with outputs at the same times. Returns `None` for methods with step size control.
pub fn check_by_step_halving(
    method: Method,
    record: &Record<f64>,
    mut run: impl FnMut(Method) -> ShorterRun,
) -> Option<StepHalvingCheck> {
    let (half, quarter) = (method.refined(2)?, method.refined(4)?);
    let mut work = Work::default();
    let mut shorter = |method: Method| {
        let (outcome, seen, left) = run(method);
        work = work + outcome.work;
        match (left, outcome.failure()) {
            (Some(why), _) => Err(StepHalvingVerdict::Stops { at: outcome.time, why }),
            (None, None) if seen.times == record.times => Ok(seen),
            (None, None | Some(Failure::TooManyEvaluations { .. })) => Err(StepHalvingVerdict::Undecided),
            (None, Some(failure)) if failure.is_broken_off() => Err(StepHalvingVerdict::Undecided),
            (None, Some(failure)) => Err(StepHalvingVerdict::Stops { at: outcome.time, why: failure.name() }),
        }
    };
    let mut judge = || -> Result<StepHalvingVerdict, StepHalvingVerdict> {
        let once = shorter(half)?;
        let first = Differences::along([record, &once, &once]);
        let whole = sizes(&first);
        if first.iter().all(|seen| !seen.visible(&whole)) {
            return Ok(StepHalvingVerdict::Converges { apart: first.last().map_or(0.0, Differences::apart) });
        }
        let twice = shorter(quarter)?;
        let all = Differences::along([record, &once, &twice]);
        let whole = sizes(&all);
        let parts = all.iter().position(|seen| seen.far(&whole) || seen.stays(&whole));
        Ok(match parts.and_then(|place| record.times.get(place)) {
            Some(from) => StepHalvingVerdict::Departs { from: *from },
            None => StepHalvingVerdict::Converges { apart: all.last().map_or(0.0, Differences::apart) },
        })
    };
    let verdict = judge().unwrap_or_else(|ended| ended);
    Some(StepHalvingCheck { verdict, work })
}

/// The size of each state over the whole run.
fn sizes(all: &[Differences]) -> Vec<f64> {
    all.last().map_or_else(Vec::new, |last| last.0.iter().map(|[size, ..]| *size).collect())
}

/// For each state, the largest values up to a time: its size, d_1, d_2.
#[derive(Clone)]
struct Differences(Vec<[f64; 3]>);

impl Differences {
    /// The differences of three runs at each time of their records.
    fn along([coarse, once, twice]: [&Record<f64>; 3]) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::with_capacity(coarse.states.len());
        for ((a, b), c) in coarse.states.iter().zip(&once.states).zip(&twice.states) {
            let before = all.last().map_or_else(|| vec![[0.0; 3]; a.len()], |last| last.0.clone());
            let now = a.iter().zip(b).zip(c).zip(before).map(|(((a, b), c), [size, first, second])| {
                [size.max(b.abs()), first.max((a - b).abs()), second.max((b - c).abs())]
            });
            all.push(Differences(now.collect()));
        }
        all
    }

    /// Whether the predicate holds for some state with a visible difference; `whole` has the sizes over the whole run.
    fn any(&self, whole: &[f64], is: impl Fn(&[f64; 3]) -> bool) -> bool {
        let nothing = ROUNDING * self.0.iter().map(|state| state[0]).fold(0.0, f64::max);
        let seen = |(state, whole): &(&[f64; 3], &f64)| state[1] > nothing && state[1] > SEEN * *whole;
        self.0.iter().zip(whole).filter(seen).any(|(state, _)| is(state))
    }

    fn far(&self, whole: &[f64]) -> bool {
        self.any(whole, |[size, first, _]| first > size)
    }

    fn visible(&self, whole: &[f64]) -> bool {
        self.any(whole, |_| true)
    }

    fn stays(&self, whole: &[f64]) -> bool {
        self.any(whole, |[_, first, second]| *second > SLOWEST * first)
    }

    fn apart(&self) -> f64 {
        let nothing = ROUNDING * self.0.iter().map(|state| state[0]).fold(0.0, f64::max);
        self.0.iter().map(|[size, first, _]| first / size.max(nothing).max(f64::MIN_POSITIVE)).fold(0.0, f64::max)
    }
}

impl StepHalvingVerdict {
    /// Whether the run departs from its law.
    pub fn departs(&self) -> bool {
        matches!(self, StepHalvingVerdict::Departs { .. } | StepHalvingVerdict::Stops { .. })
    }

    /// Whether the run is usable: it does not depart from its law, and its estimated error is below the size of each
    /// state.
    pub fn serves(&self) -> bool {
        match self {
            StepHalvingVerdict::Converges { apart } => *apart < WHOLE,
            StepHalvingVerdict::Departs { .. } | StepHalvingVerdict::Stops { .. } => false,
            StepHalvingVerdict::Undecided => true,
        }
    }

    /// The name of the result, without numbers.
    pub fn name(&self) -> &'static str {
        match self {
            StepHalvingVerdict::Converges { .. } => "shorter steps come nearer",
            StepHalvingVerdict::Departs { .. } => "shorter steps lead elsewhere",
            StepHalvingVerdict::Stops { .. } => "shorter steps are stopped",
            StepHalvingVerdict::Undecided => "shorter steps take too long",
        }
    }
}

impl fmt::Display for StepHalvingCheck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.verdict {
            StepHalvingVerdict::Converges { apart } => {
                write!(f, "half of each changes a state by {apart:.1e} of its size at most")?;
                if !self.verdict.serves() {
                    write!(f, ": the error is as large as the state")?;
                }
            }
            StepHalvingVerdict::Departs { from } => {
                write!(f, "they do not follow the law: from t = {} s on shorter ones lead elsewhere", Instant(from))?;
            }
            StepHalvingVerdict::Stops { at, why } => {
                write!(f, "they do not follow the law: shorter ones are stopped at t = {} s, {why}", Instant(at))?;
            }
            StepHalvingVerdict::Undecided => write!(f, "not judged, since shorter ones take longer than is allowed")?,
        }
        write!(f, " ({} evaluations more)", self.work.rates)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ode, Span, System, Tolerance, integrate};
    use field::Scalar;

    /// y' = -1/y: y^2 decreases at a constant rate; from y = 1 the motion ends at t = 1/2.
    struct Falling;
    impl<S: Scalar> Ode<S> for Falling {
        fn dimension(&self) -> usize {
            1
        }
        fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
            dy[0] = -S::one() / y[0];
        }
    }
    impl System for Falling {}

    /// The oscillator y'' = -y.
    struct Swinging;
    impl<S: Scalar> Ode<S> for Swinging {
        fn dimension(&self) -> usize {
            2
        }
        fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
            (dy[0], dy[1]) = (y[1], -y[0]);
        }
    }
    impl System for Swinging {}

    fn judged(system: &dyn System, start: &[f64], end: f64, method: Method) -> StepHalvingVerdict {
        let run = |method: Method| {
            let mut record = Record::new();
            let span = Span::new(0.0, end, start).with_even_outputs(20);
            let outcome = integrate(system, method, &Tolerance::both(1e-9), &span, &mut record);
            (outcome, record, None)
        };
        let (outcome, record, _) = run(method);
        assert!(outcome.reached(), "{outcome:?}");
        check_by_step_halving(method, &record, run).expect("its steps are constant").verdict
    }

    #[test]
    fn steps_over_a_pole_part_behind_it() {
        for steps in [60, 100, 1000, 10_000] {
            for method in [Method::Euler { steps }, Method::RungeKutta4 { steps }] {
                let found = judged(&Falling, &[1.0], 1.0, method);
                assert!(found.departs(), "{method}: {found:?}");
                if let StepHalvingVerdict::Departs { from } = found {
                    assert!((0.5..0.9).contains(&from), "{method}: {from}");
                }
                let before = judged(&Falling, &[1.0], 0.45, method);
                assert!(!before.departs(), "{method}: {before:?}");
            }
        }
    }

    /// Euler's oscillations grow by exp(t h/2). Growth by tenths is still convergence; growth by more than the size is
    /// a departure.
    #[test]
    fn what_converges_is_not_named_and_its_error_is_told() {
        let euler = |steps, end| judged(&Swinging, &[1.0, 0.0], end, Method::Euler { steps });
        let StepHalvingVerdict::Converges { apart } = euler(100, 4.0) else { panic!("{:?}", euler(100, 4.0)) };
        // half of exp(0.08) - 1
        assert!((0.03..0.06).contains(&apart), "{apart}");
        assert!(euler(40, 40.0).departs(), "{:?}", euler(40, 40.0));
        let StepHalvingVerdict::Converges { apart } =
            judged(&Swinging, &[1.0, 0.0], 40.0, Method::RungeKutta4 { steps: 2000 })
        else {
            panic!("it converges")
        };
        assert!(apart < 1e-7, "{apart}");
    }
}
