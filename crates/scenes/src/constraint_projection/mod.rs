//! Projection onto the constraints f = 0 of a model, and onto their rates. With the residuals r of position constraints the coordinates are
//! displaced by d, then with those of all rates the speeds are changed by d,
//!
//!   d = -W J^T (J W J^T)^-1 r ,
//!
//! where W is the diagonal matrix of the inverse diagonal entries of the mass matrix M. Runs have the errors that M^-1 in place of W gives,
//! which takes twice as long. One factorisation at a state serves all its corrections. Stabilised constraints are not projected;
//! redundant ones hold with those that imply them.
//!
//! The corrections of few independent constraints are one compiled function of the state. Where these are many, redundant, or the state is
//! singular, the equations are factorised at the state.
//!
//! A residual is rounding where it is below a few roundings of its size: the root of the sum of squares of its derivatives times
//! coordinates, speeds and time.

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

/// The residual, in roundings of its size, up to which a state is not corrected.
const LEFT: f64 = 8.0;

/// The residual, in roundings of its size, at which the correction ends.
const MET: f64 = 4.0;

/// The largest number of corrections of positions and speeds: the first one leaves the square of a step's error, the second rounding.
const ROUNDS: usize = 4;

/// The mobility of a speed without inertia relative to the largest other one: such speeds take most of the correction.
const WITHOUT_INERTIA: f64 = 1e4;

/// The projection onto the constraints of a model.
#[derive(Debug)]
pub(crate) struct ConstraintProjection {
    layout: Layout,
    /// The number of components of a state, plus that of the parameters where these are inputs.
    inputs: usize,
    /// The places of constraints of positions among those of all rates, and the number of the latter.
    positions: Vec<usize>,
    rates: usize,
    /// Independent constraints, not too many.
    corrections: Option<Corrections>,
    /// Residuals of positions, then of all rates.
    residuals: Program,
    /// The residuals, the square of the size of each, the entries of J, the diagonal of the mass matrix.
    all: Program,
    /// Row and column of each entry of J.
    entries: Vec<(usize, usize)>,
    /// The sparsity pattern of J W J^T.
    pattern: Pattern,
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
    /// Whether steps of a model are projected: not without constraints that hold, nor with algebraic speeds.
    pub fn is_of(model: &Model) -> bool {
        model.algebraic_speeds.is_empty() && model.constraints.iter().any(|one| one.gains.is_none())
    }

    /// The projection for the values of the parameters; `None` where it is not used, or an expression has no value.
    pub fn of(model: &Model) -> Option<Self> {
        let states = model.positions() + model.speeds();
        ConstraintProjection::over(model, states, |time, state| Letters::with_data(time, state))
    }

    /// Whether a model has position constraints; residuals of other constraints do not grow by themselves.
    pub fn keeps_positions(model: &Model) -> bool {
        ConstraintProjection::is_of(model) && symbolic::apart(|| Kept::of(&Trace::of(model)).hold_positions())
    }

    /// The projection of a state with the parameters behind it.
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
        // where corrections are written down, a factorisation at a state is rare
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
            // any inertia measures a way: that of one of the cases of a condition
            let on: Vec<(Sym, Sym)> = trace.switches.iter().map(|&switch| (switch, Sym::ONE)).collect();
            letters(time, inputs).put_into(&trace, &substitute_all(&all, &on))
        });
        let (residuals, all) = (residuals?, all?);
        let touches = |row: usize, column: usize| entries.binary_search(&(row, column)).is_ok();
        let meet = |(row, other): &(usize, usize)| (0..speeds).any(|k| touches(*row, k) && touches(*other, k));
        let places = (0..rates).flat_map(|row| (0..rates).map(move |other| (row, other))).filter(meet).collect();
        // rows that follow from others have no share of their own
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

    /// A law of the motion, its state perhaps with more behind it, whose steps end on the constraints where there are some.
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

    /// The largest residuals of positions and of rates, each in roundings of its size.
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

    /// Corrects the coordinates (order 0) or the speeds (order 1) by the present residuals.
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

    /// Projects a state, and returns whether it was moved. A state whose residual cannot be reduced is unchanged.
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

    /// As [`Self::bring`], by a factorisation at the state.
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
            // false for NaN too: such a correction is undone
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
