//! Enclosed eigenvalues of the linear equations at a steady motion: zero eigenvalues with known reasons are separated, and each other one lies
//! in a disc.
//!
//! Krawczyk's operator encloses the motion to thirty digits. The linear equations without cyclic coordinates and their characteristic
//! polynomial follow with similar precision. As many of its last coefficients are zero as zero eigenvalues have known reasons.

mod along;
mod crossings;
mod discs;
mod exact;
mod motion;
mod nearby;
mod nearest_motion;
mod quotient;
mod reduction;
mod zeros;

pub use along::{Boundary, ExactAlong};
pub use crossings::{Crossings, Judged};
pub use discs::{EigenvalueDisc, Side};
pub use exact::Routh;
pub use zeros::ZeroReason;

use super::equations::SteadyEquations;
use crate::linearisation::{Spectrum, Stability, VariedEquations};
use algebra::real::{Ball, Ordered};
use exact::routh;
use field::Interval;
use integrators::eigenvalues;
use mechanics::linear_stability::characteristic;
use model::Model;
use nalgebra::{Complex, DMatrix};
use reduction::{Layout, Reduced};
use std::fmt;
use zeros::{Kept, reasons};

/// Largest number of states; for more, the characteristic polynomial is not precise enough.
const MOST_STATES: usize = 24;

/// Number of digits of the decimals that are tried as exact values of the motion.
const DIGITS: usize = 10;

/// A disc with a radius above this multiple of a bound of all eigenvalues is replaced by an unbounded one.
const BEYOND: f64 = 1e3;

/// Unknowns below this size are tried as zero.
const NOTHING: f64 = 1e-12;

/// Enclosures of all eigenvalues at a steady motion.
#[derive(Clone, Debug, PartialEq)]
pub struct EnclosedSpectrum {
    /// The reasons of the zero eigenvalues, one for each.
    pub zeros: Vec<ZeroReason>,
    /// Discs of all others, with decreasing real parts.
    pub discs: Vec<EigenvalueDisc>,
    /// The exact counts by Routh's criterion, if the data and the motion are decimals with rational derivatives.
    pub exact: Option<Routh>,
}

/// The reason for which eigenvalues could not be enclosed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotEnclosed {
    /// The system has more states than are supported.
    Large { states: usize, most: usize },
    /// Accelerations or dependent speeds are not determined within the enclosure of the motion, or an expression is unbounded.
    Undetermined,
    /// The linear equations cannot be evaluated.
    NoEquations,
    /// The search for steady motions does not support the model, for the given reason.
    NotSought(&'static str),
    /// No steady motion is proved at the point.
    NoMotion,
    /// A condition of the law is zero at the motion, and derivatives jump there.
    AtCondition,
    /// Inputs depend on the state, which the linear equations ignore.
    Feedback,
    /// The motion changes with the parameter, or a number is irrational.
    NotExact,
    /// For all values of the parameter, the negative of every eigenvalue is an eigenvalue, too.
    Opposite,
}

impl fmt::Display for NotEnclosed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Large { states, most } => write!(f, "{states} states, and up to {most} are enclosed"),
            Self::Undetermined => write!(f, "the linear equations have no bounds there"),
            Self::NoEquations => write!(f, "there are no linear equations with numbers"),
            Self::NotSought(why) => write!(f, "{why}"),
            Self::AtCondition => write!(f, "a condition of the law is zero there, and its derivatives jump"),
            Self::Feedback => write!(f, "inputs that depend on the state are held at their values"),
            Self::NotExact => write!(
                f,
                "exact boundaries need a steady motion at the same decimal numbers for every value of the parameter, with rational derivatives there"
            ),
            Self::Opposite => write!(
                f,
                "at every value some eigenvalues are opposite to others, as they are without damping: Hurwitz' determinant gives no boundary"
            ),
            Self::NoMotion => write!(f, "no steady motion is shown to be at the point"),
        }
    }
}

/// The conclusion on stability from enclosed eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnclosedVerdict {
    /// All eigenvalues except zeros with known reasons are left of the imaginary axis.
    Asymptotic,
    /// At least this number of eigenvalues has positive real parts.
    Unstable(usize),
    /// No eigenvalue is proved right of the axis: `on_axis` are proved on it, `touching` are in discs that touch it.
    Undecided { on_axis: usize, touching: usize },
}

impl EnclosedSpectrum {
    /// The eigenvalues at an enclosed motion; `state` is a state in the enclosure.
    ///
    /// # Errors
    /// If there are too many states, or the linear equations are not determined in the enclosure.
    pub(super) fn of(
        model: &Model,
        equations: &SteadyEquations,
        varied: &VariedEquations,
        (enclosure, state): (&[Interval], &[f64]),
        keeps_energy: bool,
    ) -> Result<Self, NotEnclosed> {
        let layout = layout(equations, varied);
        let [n, m, ..] = varied.counts();
        let states = 2 * n - m - layout.positions;
        if states > MOST_STATES {
            return Err(NotEnclosed::Large { states, most: MOST_STATES });
        }
        let (at, speeds) = motion::slopes_at(equations, varied, enclosure, state).ok_or(NotEnclosed::Undetermined)?;
        let reduced = Reduced::of(&at, &layout, &Ball::constant(1.0)).ok_or(NotEnclosed::Undetermined)?;
        let kept =
            Kept { momenta: equations.kept_momenta.clone(), energy: keeps_energy, free: equations.free_speeds.len() };
        let mut zeros: Vec<ZeroReason> = equations.cyclic.iter().cloned().map(ZeroReason::Cyclic).collect();
        let own = reasons(&at, &speeds, &reduced, &kept);
        // cyclic coordinates do not count: the reduced matrix does not contain them
        let forced = own.len();
        zeros.extend(own);
        let is_even = keeps_energy && m == layout.positions;
        let found = Self::of_matrix(&reduced.matrix, zeros, forced, is_even).ok_or(NotEnclosed::Undetermined)?;
        let exact = decimals(equations, enclosure, state)
            .and_then(|state| routh(model, varied, &layout, (&state, &equations.switches), forced));
        Ok(EnclosedSpectrum { exact, ..found })
    }

    /// Encloses the eigenvalues of a matrix, `forced` of which are zero; `None` if no discs are found.
    fn of_matrix(matrix: &[Vec<Ball>], zeros: Vec<ZeroReason>, forced: usize, is_even: bool) -> Option<Self> {
        let size = matrix.len();
        let mut coefficients = characteristic(matrix, &Ball::constant(1.0));
        let is_none = |c: &Ball| !matches!(c.sign(), Some(1 | -1));
        if forced > size || !coefficients.split_off(size + 1 - forced).iter().all(is_none) {
            return None;
        }
        let middle = DMatrix::from_fn(size, size, |i, j| matrix[i][j].at(0.0));
        if !middle.iter().all(|value| value.is_finite()) {
            return None;
        }
        let mut begin: Vec<[f64; 2]> = match size {
            0 => Vec::new(),
            _ => eigenvalues(&middle)?.iter().map(|value| [value.re, value.im]).collect(),
        };
        begin.sort_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
        if is_even {
            // odd coefficients vanish, since the negative of every eigenvalue is an eigenvalue
            if !coefficients.iter().skip(1).step_by(2).all(is_none) {
                return None;
            }
            coefficients.iter_mut().skip(1).step_by(2).for_each(|c| *c = Ball::constant(0.0));
        }
        let mut discs = discs::discs(&coefficients, &begin[forced..], is_even)?;
        // by Gershgorin no eigenvalue exceeds the largest row sum
        let sums = matrix.iter().map(|row| row.iter().map(|entry| entry.size()).sum::<f64>());
        let beyond = BEYOND * (1.0 + sums.fold(0.0, f64::max));
        discs.iter_mut().filter(|disc| disc.radius > beyond).for_each(|disc| disc.radius = f64::INFINITY);
        Some(EnclosedSpectrum { zeros, discs, exact: None })
    }

    /// The conclusion on stability; exact counts take precedence.
    pub fn verdict(&self) -> EnclosedVerdict {
        let count = |side: Side| self.discs.iter().filter(|disc| disc.side == side).map(|disc| disc.count).sum();
        let counts = match self.exact {
            Some(Routh { right, axis, unexplained, .. }) => (right, axis, unexplained),
            None => (count(Side::Right), count(Side::Axis), count(Side::Undecided)),
        };
        match counts {
            (0, 0, 0) if !self.discs.is_empty() => EnclosedVerdict::Asymptotic,
            (0, on_axis, touching) => EnclosedVerdict::Undecided { on_axis, touching },
            (unstable, ..) => EnclosedVerdict::Unstable(unstable),
        }
    }

    /// The stability by the centres of the discs, without the zeros that have reasons and that rounding would move; `None` if a disc is unbounded.
    pub fn by_centres(&self) -> Option<Stability> {
        let centres = || self.discs.iter().flat_map(|disc| std::iter::repeat_n(disc.centre, disc.count));
        let values = centres().map(|[re, im]| Complex::new(re, im)).collect();
        let are_bounded = self.discs.iter().all(|disc| disc.radius.is_finite());
        are_bounded.then(|| Stability::of(&Spectrum { values, idle: 0 }, true))
    }
}

/// The state with the unknowns rounded to short decimals, as far as these lie in the enclosure.
fn decimals(equations: &SteadyEquations, enclosure: &[Interval], state: &[f64]) -> Option<Vec<f64>> {
    let mut state = state.to_vec();
    for (unknown, within) in equations.unknowns.iter().zip(enclosure) {
        let value = state[unknown.place];
        let short = format!("{value:.DIGITS$e}").parse().ok().filter(|_| value.abs() > NOTHING).unwrap_or(0.0);
        state[unknown.place] = [value, short].into_iter().rev().find(|value| within.contains(*value))?;
    }
    Some(state)
}

/// The numbers of position constraints, the dependent speeds and the cyclic coordinates, for the reduction of the equations.
fn layout(equations: &SteadyEquations, varied: &VariedEquations) -> Layout {
    let [n, ..] = varied.counts();
    let determined = equations.determined.0.iter().map(|place| place - n).collect();
    Layout { positions: varied.positions(), determined, cyclic: equations.cyclic_places.clone() }
}
