//! Projection onto the constraints f = 0 of a model, and onto their rates. Newton's correction for a residual r is
//!
//!   d = -W J^T (J W J^T)^-1 r ,
//!
//! where J is the Jacobian of the constraints, and W is the diagonal matrix of the inverse diagonal entries of the mass matrix M. The
//! residuals of position constraints give a displacement of the coordinates, then the residuals of all rates a change of the speeds. Runs
//! with M^-1 in place of W have equal errors and take twice as long. One factorisation at a state serves all its corrections. Stabilised
//! constraints are not projected; redundant constraints hold with those that imply them.
//!
//! Up to 24 independent constraints are projected by one compiled function of the state. If there are more, if they are redundant, or if
//! the state is singular, the equations are factorised at the state.
//!
//! The scale of a residual is the root of the sum of squares of its derivatives times coordinates, speeds and time. A residual below a
//! few machine epsilons of its scale is rounding error.

mod corrections;
mod member;
mod residuals;

pub(crate) use member::OfMember;

use crate::layout::Layout;
use crate::letters::Letters;
use algebra::linear::{Factors, Pattern};
use corrections::Corrections;
use integrators::Projection;
use model::{Model, Trace};
use residuals::Kept;
use simulation::{Law, Program, ProjectedLaw};
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};
use symbolic::{Sym, substitute_all};

/// A state whose residuals are at most this many machine epsilons of their scales is not corrected.
const LEFT: f64 = 8.0;

/// The iteration ends at residuals of at most this many machine epsilons of their scales.
const MET: f64 = 4.0;

/// The largest number of corrections. The first leaves a residual of the order of the squared error of the step, the second only
/// rounding.
const ROUNDS: usize = 4;

/// The entry of W for a speed without inertia, relative to the largest other entry: such speeds take most of the correction.
const WITHOUT_INERTIA: f64 = 1e4;

/// The projection onto the constraints of a model.
#[derive(Debug)]
pub(crate) struct ConstraintProjection {
    layout: Layout,
    /// The number of inputs: the components of a state, and for ensembles the parameters.
    inputs: usize,
    /// Indices of the position constraints among all constraints, and the number of all constraints.
    positions: Vec<usize>,
    rates: usize,
    /// The projection as one compiled function; `None` if constraints are dependent or too many.
    corrections: Option<Corrections>,
    /// Outputs: residuals of position constraints, then of all rates.
    residuals: Program,
    /// Outputs: the residuals, the squares of their scales, the entries of J, the diagonal of the mass matrix.
    all: Program,
    /// Row and column of each entry of J.
    entries: Vec<(usize, usize)>,
    /// The sparsity pattern of J W J^T.
    pattern: Pattern,
    /// Work spaces that no call uses at present.
    rooms: Mutex<Vec<Room>>,
}

/// Work space for one state.
#[derive(Debug)]
struct Room {
    corrections: Vec<f64>,
    all: Vec<f64>,
    mobilities: Vec<f64>,
    /// J, row by row.
    rows: Vec<f64>,
    matrix: Vec<f64>,
    factors: Factors<f64>,
    right: Vec<f64>,
    kept: Vec<f64>,
}

impl ConstraintProjection {
    /// True if steps of the model are projected: it has a constraint without stabilisation, and no algebraic speeds.
    pub fn is_of(model: &Model) -> bool {
        model.algebraic_speeds.is_empty() && model.constraints.iter().any(|one| one.gains.is_none())
    }

    /// The projection for the model's values of the parameters; `None` if the model is not projected, or an expression has no value.
    pub fn of(model: &Model) -> Option<Self> {
        let states = model.positions() + model.speeds();
        ConstraintProjection::over(model, states, |time, state| Letters::with_data(time, state))
    }

    /// True if a projected model has position constraints. Only their residuals accumulate errors.
    pub fn keeps_positions(model: &Model) -> bool {
        ConstraintProjection::is_of(model) && symbolic::apart(|| Kept::of(&Trace::of(model)).hold_positions())
    }

    /// The projection for ensembles: inputs are the state, then the parameters.
    pub fn of_members(model: &Model) -> Option<Self> {
        let states = model.positions() + model.speeds();
        ConstraintProjection::over(model, states + model.parameters.len(), |time, inputs| {
            let (state, parameters) = inputs.split_at(states);
            Letters::with_parameters(time, state, parameters)
        })
    }

    fn over(model: &Model, inputs: usize, letters: impl Fn(Sym, &[Sym]) -> Letters<'_> + Send + Sync) -> Option<Self> {
        if !ConstraintProjection::is_of(model) {
            return None;
        }
        let speeds = model.speeds();
        let corrections = Corrections::over(model, inputs, &letters);
        // with compiled corrections, a factorisation at a state is rare
        let program = |function: &mut (dyn FnMut(Sym, &[Sym]) -> Vec<Sym> + Send)| match corrections {
            Some(_) => Program::for_few(inputs, function),
            None => Program::of(inputs, function),
        };
        let residuals = program(&mut |time, inputs| {
            let trace = Trace::of(model);
            letters(time, inputs).put_into(&trace, &Kept::of(&trace).residuals())
        });
        let (mut positions, mut rates, mut entries) = (Vec::new(), 0, Vec::new());
        let all = program(&mut |time, inputs| {
            let trace = Trace::of(model);
            let kept = Kept::of(&trace);
            (positions, rates) = (kept.places_of_positions(), kept.count());
            let energy = trace.kinetic_and_coenergy();
            let inertias = (0..speeds).map(|speed| trace.by_speed(trace.by_speed(energy, speed), speed));
            let slopes: Vec<Sym>;
            (entries, slopes) = kept.slopes();
            let all: Vec<Sym> =
                kept.residuals().into_iter().chain(kept.sizes(&trace)).chain(slopes).chain(inertias).collect();
            // the metric needs some inertia, not the exact one: every condition is set to its positive case
            let on: Vec<(Sym, Sym)> = trace.switches.iter().map(|&switch| (switch, Sym::ONE)).collect();
            letters(time, inputs).put_into(&trace, &substitute_all(&all, &on))
        });
        let (residuals, all) = (residuals?, all?);
        let touches = |row: usize, column: usize| entries.binary_search(&(row, column)).is_ok();
        let meet = |(row, other): &(usize, usize)| (0..speeds).any(|k| touches(*row, k) && touches(*other, k));
        let places = (0..rates).flat_map(|row| (0..rates).map(move |other| (row, other))).filter(meet).collect();
        // dependent rows get no multiplier
        let pattern = Pattern::new(rates, 0, places);
        let (layout, rooms) = (Layout::of(model), Mutex::default());
        Some(ConstraintProjection {
            layout,
            inputs,
            positions,
            rates,
            corrections,
            residuals,
            all,
            entries,
            pattern,
            rooms,
        })
    }

    /// `law` with accepted steps projected, or `law` itself without a projection. Its state may have further components behind those of
    /// the motion.
    pub fn onto(projection: Option<&Arc<Self>>, law: Arc<dyn Law>) -> Arc<dyn Law> {
        match projection {
            Some(projection) => Arc::new(ProjectedLaw::new(law, Arc::clone(projection) as _)),
            None => law,
        }
    }

    /// The number of residuals.
    fn count(&self) -> usize {
        self.positions.len() + self.rates
    }

    fn room(&self) -> Room {
        let speeds = self.layout.speeds();
        Room {
            corrections: vec![0.0; self.corrections.as_ref().map_or(0, Corrections::values)],
            all: vec![0.0; 2 * self.count() + self.entries.len() + speeds],
            mobilities: vec![0.0; speeds],
            rows: vec![0.0; self.rates * speeds],
            matrix: vec![0.0; self.pattern.places().len()],
            factors: Factors::new(&self.pattern),
            right: vec![0.0; self.rates],
            kept: vec![0.0; self.inputs],
        }
    }

    /// The largest residuals of positions and of rates, in machine epsilons of their scales; NaN if one is NaN.
    fn off(&self, room: &Room) -> [f64; 2] {
        let (residuals, squares) = room.all[..2 * self.count()].split_at(self.count());
        let roundings = |(residual, square): (&f64, &f64)| match *residual {
            0.0 => 0.0,
            residual => residual.abs() / (f64::EPSILON * square.sqrt()),
        };
        let largest = |of: Range<usize>| {
            let all = residuals[of.clone()].iter().zip(&squares[of]).map(roundings);
            all.fold(0.0, |largest: f64, one| if one.is_nan() { one } else { largest.max(one) })
        };
        [largest(0..self.positions.len()), largest(self.positions.len()..self.count())]
    }

    /// Factorises J W J^T; `None` where it is not finite.
    fn factor(&self, room: &mut Room) -> Option<()> {
        let Room { all, mobilities, rows, matrix, factors, .. } = room;
        let (slopes, inertias) = all[2 * self.count()..].split_at(self.entries.len());
        let speeds = inertias.len();
        for (&(row, column), slope) in self.entries.iter().zip(slopes) {
            rows[row * speeds + column] = *slope;
        }
        mobilities.iter_mut().zip(inertias).for_each(|(mobility, inertia)| *mobility = inertia.recip());
        let of_inertia = mobilities.iter().filter(|mobility| mobility.is_finite());
        let largest = of_inertia.fold(0.0_f64, |largest, mobility| largest.max(*mobility));
        let most = if largest > 0.0 { WITHOUT_INERTIA * largest } else { 1.0 };
        mobilities.iter_mut().filter(|one| !(**one > 0.0 && **one < most)).for_each(|one| *one = most);
        for (&(row, other), entry) in self.pattern.places().iter().zip(&mut *matrix) {
            let [row, other] = [row, other].map(|row| &rows[row * speeds..][..speeds]);
            let products = row.iter().zip(other).zip(&*mobilities);
            *entry = products.fold(0.0, |sum, ((a, b), mobility)| sum + a * b * mobility);
        }
        factors.factor(matrix).ok()
    }

    /// Corrects the coordinates (`order` 0) or the speeds (`order` 1) of `y` by the residuals in `room`.
    fn correct(&self, order: usize, y: &mut [f64], room: &mut Room) {
        let Room { all, mobilities, rows, factors, right, .. } = room;
        if order == 0 {
            right.fill(0.0);
            self.positions.iter().zip(&*all).for_each(|(&row, residual)| right[row] = -residual);
        } else {
            right.iter_mut().zip(&all[self.positions.len()..]).for_each(|(right, residual)| *right = -residual);
        }
        factors.solve(right);
        let speeds = mobilities.len();
        for (speed, mobility) in mobilities.iter().enumerate() {
            let along = right.iter().enumerate().map(|(row, share)| rows[row * speeds + speed] * share);
            let by = mobility * along.sum::<f64>();
            if by != 0.0 {
                self.layout.displace(y, (speed, order), by);
            }
        }
    }

    /// Projects the state `y` in place, and returns whether it was moved. A state whose residuals cannot be reduced is unchanged. `None`
    /// if an expression or the factorisation has no value.
    fn bring(&self, t: f64, y: &mut [f64], room: &mut Room) -> Option<bool> {
        if let Some(corrections) = &self.corrections {
            room.kept.copy_from_slice(y);
            if let Some(moved) = corrections.bring(self.layout, t, y, &mut room.corrections) {
                return Some(moved);
            }
            y.copy_from_slice(&room.kept);
        }
        self.bring_by_factors(t, y, room)
    }

    /// The projection of [`Self::bring`] by a factorisation at the state.
    #[cold]
    fn bring_by_factors(&self, t: f64, y: &mut [f64], room: &mut Room) -> Option<bool> {
        self.all.run(t, y, &mut room.all)?;
        let largest = |[positions, rates]: [f64; 2]| if rates.is_nan() { rates } else { positions.max(rates) };
        let mut off = self.off(room);
        let mut best = largest(off);
        if best.is_nan() || best <= LEFT {
            return Some(false);
        }
        self.factor(room)?;
        let mut moved = false;
        for _ in 0..ROUNDS {
            room.kept.copy_from_slice(y);
            for order in [0, 1] {
                if off[order] > MET {
                    self.correct(order, y, room);
                    self.residuals.run(t, y, &mut room.all[..self.count()])?;
                    off = self.off(room);
                }
            }
            let now = largest(off);
            // false for NaN too; the correction is then undone
            if now < best {
                (best, moved) = (now, true);
            } else {
                y.copy_from_slice(&room.kept);
                break;
            }
            if best <= MET {
                break;
            }
        }
        Some(moved)
    }
}

impl Projection<f64> for ConstraintProjection {
    fn project(&self, t: f64, y: &mut [f64]) -> bool {
        let taken = self.rooms.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut room = taken.unwrap_or_else(|| self.room());
        // a law may have further components behind the state
        let moved = self.bring(t, &mut y[..self.inputs], &mut room);
        self.rooms.lock().unwrap_or_else(PoisonError::into_inner).push(room);
        moved.unwrap_or(false)
    }
}
