//! Brackets of the parameter values at which the stability by enclosed eigenvalues changes.

use super::{EnclosedSpectrum, EnclosedVerdict, NotEnclosed};

/// Number of equal intervals of the range at whose ends the stability is compared.
const INTERVALS: usize = 8;

/// Largest number of steps that narrow a bracket.
const STEPS: usize = 48;

/// Fractions of a bracket that are tried if the eigenvalues are not enclosed at the first choice.
const PARTS: [f64; 5] = [0.5, 0.381_966, 0.618_034, 0.236, 0.764];

/// Least width of a bracket, in rounding errors of the value.
const ROUNDINGS: f64 = 4.0;

/// A value of the parameter with the stability verdict.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The value in SI units.
    pub value: f64,
    /// The conclusion on stability at this value.
    pub verdict: EnclosedVerdict,
    /// The number of zero eigenvalues with known reasons.
    pub zeros: usize,
    /// The eigenvalue with the largest real part: real and imaginary part in 1/s.
    pub foremost: [f64; 2],
}

impl Judged {
    /// Whether no disc of an eigenvalue touches the imaginary axis without being proved to be on it.
    fn is_certain(&self) -> bool {
        !matches!(self.verdict, EnclosedVerdict::Undecided { touching, .. } if touching > 0)
    }

    /// Whether the verdicts agree as far as they are known; two undecided ones agree unless both are certain.
    fn is_like(&self, other: &Self) -> bool {
        let are_undecided = [self, other].iter().all(|one| matches!(one.verdict, EnclosedVerdict::Undecided { .. }));
        self.verdict == other.verdict || are_undecided && !(self.is_certain() && other.is_certain())
    }
}

/// Real parts below this multiple of the imaginary part are rounding errors.
const ROUNDING: f64 = 1e-25;

/// The stability along a range of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossings {
    /// The compared values, without those at which eigenvalues are not enclosed.
    pub samples: Vec<Judged>,
    /// For each change of the verdict, a value on each side.
    pub changes: Vec<[Judged; 2]>,
    /// Values at which eigenvalues are not enclosed, with the reasons.
    pub open: Vec<(f64, NotEnclosed)>,
}

impl Crossings {
    /// The verdicts over a range, with the eigenvalues that `spectrum` gives at each value; ends early when `goes_on` returns false.
    pub fn of(
        [from, to]: [f64; 2],
        mut spectrum: impl FnMut(f64) -> Result<EnclosedSpectrum, NotEnclosed>,
        mut goes_on: impl FnMut() -> bool,
    ) -> Self {
        let mut judged = |value: f64| -> Result<Judged, NotEnclosed> {
            let found = spectrum(value)?;
            if found.exact.is_none() && found.discs.iter().any(|disc| !disc.radius.is_finite()) {
                return Err(NotEnclosed::Undetermined);
            }
            let none = [f64::NEG_INFINITY, 0.0];
            let foremost =
                found.discs.iter().map(|disc| disc.centre).fold(none, |a, b| if b[0] > a[0] { b } else { a });
            let is_on_axis = foremost[0].abs() <= ROUNDING * foremost[1].abs();
            let foremost = if is_on_axis { [0.0, foremost[1]] } else { foremost };
            Ok(Judged { value, verdict: found.verdict(), zeros: found.zeros.len(), foremost })
        };
        let (mut samples, mut open, mut changes) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..=INTERVALS {
            if !goes_on() {
                break;
            }
            let value = from + (to - from) * k as f64 / INTERVALS as f64;
            match judged(value) {
                Ok(found) => samples.push(found),
                Err(why) => open.push((value, why)),
            }
        }
        for pair in samples.windows(2) {
            if !pair[0].is_like(&pair[1]) {
                changes.push(narrowed([pair[0], pair[1]], &mut judged, &mut goes_on));
            }
        }
        Crossings { samples, changes, open }
    }
}

/// A narrower bracket, by a secant method for the largest real part. Each step goes twice the distance from the nearer end to the zero of the
/// secant, so that both ends approach the change.
fn narrowed(
    mut ends: [Judged; 2],
    judged: &mut impl FnMut(f64) -> Result<Judged, NotEnclosed>,
    goes_on: &mut impl FnMut() -> bool,
) -> [Judged; 2] {
    for _ in 0..STEPS {
        let [low, high] = ends;
        let way = high.value - low.value;
        let rounding = f64::EPSILON * low.value.abs().max(high.value.abs());
        if way.abs() <= ROUNDINGS * rounding || !goes_on() {
            break;
        }
        let slope = high.foremost[0] - low.foremost[0];
        let part = -low.foremost[0] / slope;
        let is_between = low.foremost[0] * high.foremost[0] < 0.0 && part.is_finite();
        let part = if is_between { part } else { 0.5 };
        let least = rounding / way.abs();
        let part = match part < 0.5 {
            true => (2.0 * part).max(least).min(0.5),
            false => 1.0 - (2.0 * (1.0 - part)).max(least).min(0.5),
        };
        // eigenvalues may not be enclosed at a round value, at which motions merge
        let Some(found) = [part].into_iter().chain(PARTS).find_map(|part| {
            judged(low.value + part * way)
                .ok()
                .filter(|found| found.is_certain() || found.is_like(&low) || found.is_like(&high))
        }) else {
            break;
        };
        if found.value == low.value || found.value == high.value {
            break;
        }
        ends[usize::from(!found.is_like(&low))] = found;
    }
    ends
}
