//! The steady states of a synchronous motor over its load, by continuation: synchronous equilibria, and periodic
//! slipping motions.

use super::loaded::Loaded;
use integrators::{
    Branch, BranchEnd, ContinuationSettings, CurvePoint, Equilibria, Failure, PeriodicMotions, continue_branch,
    spectrum,
};
use nalgebra::{Matrix3, RowVector3, Vector3};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};

/// A synchronous steady state: an equilibrium of the rotor's angle relative to the field.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// The angle, rad.
    pub angle: f64,
    /// The load, N m.
    pub load: f64,
    /// The largest real part of an eigenvalue, 1/s; negative if the state is stable.
    pub growth: f64,
    /// Whether the load has an extremum here (fold): two equilibria merge in a saddle-node bifurcation.
    pub fold: bool,
}

/// A periodic slipping motion: in every period the rotor falls behind the field by one turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Slipping {
    /// The period: the time, s, in which the rotor falls behind the field by one turn.
    pub period: f64,
    /// The load, N m.
    pub load: f64,
    /// The largest modulus of a Floquet multiplier other than the trivial one; less than one if the motion is stable.
    pub multiplier: f64,
    /// Whether the load has an extremum here (fold): two slipping motions merge.
    pub fold: bool,
    /// Angle, slip and currents at one instant of the motion.
    pub state: Vec<f64>,
}

impl Slipping {
    /// The mean slip, rad/s.
    pub fn slip(&self) -> f64 {
        -TAU / self.period
    }

    /// Whether the motion is stable.
    pub fn stable(&self) -> bool {
        self.multiplier < 1.0
    }
}

/// All periodic slipping motions on one branch, from the fastest to the slowest.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfStep {
    pub motions: Vec<Slipping>,
    /// The limit of the load, N m, as the period tends to infinity. There a homoclinic motion leaves the unstable
    /// equilibrium and returns to it one turn later. `None` if the continuation did not reach it.
    pub limit: Option<f64>,
}

/// The step of the continuation along equilibria and slipping motions, in scaled variables.
const STEP: f64 = 0.15;
const LONGER_STEP: f64 = 1.5;
/// The greatest number of points of a continuation.
const MOST: usize = 400;
/// The tolerance of the integration over one period.
const TOLERANCE: f64 = 1e-13;
/// The longest period that is computed, in units of 1/frequency.
const LONGEST: f64 = 120.0;
/// The load counts as near its limit if it changes by less than this fraction of the pull-out torque b while the period
/// increases by 1/frequency. Closer to the limit shooting fails, because the sensitivity of the motion's end grows as
/// fast as the load converges.
const SETTLED: f64 = 1e-8;
/// The shortest period that counts as near the limit, and the difference of the periods used for extrapolation, in
/// units of 1/frequency.
const LONG: f64 = 8.0;
const APART: f64 = 1.5;
/// The slip at which the continuation begins is at least this multiple of the frequency.
const FAST: f64 = 6.0;
/// The greatest number of doublings of that slip, if friction is small.
const MOST_DOUBLINGS: u32 = 8;
/// The greatest load that is computed, in units of the pull-out torque b.
const MOST_LOAD: f64 = 50.0;

impl Loaded {
    /// All synchronous steady states within half a turn on either side of the angle of least energy, with their loads,
    /// in the order of the angle.
    pub fn in_step(&self) -> Vec<Standing> {
        let sizes = &self.facts.sizes;
        let bottom = self.facts.bottom;
        let last = sizes.len() - 1;
        let mut start = vec![0.0; sizes.len()];
        (start[0], start[last]) = (bottom, self.own.torque(bottom, 0.0));
        let within = |x: &[f64]| (x[0] - bottom).abs() <= PI + STEP;
        let walk = ContinuationSettings { sizes, parameter: last, step: STEP, most: MOST, within: &within };
        let mut rest = Equilibria::new(&*self.law);
        let mut towards = vec![0.0; sizes.len()];
        towards[0] = 1.0;
        let mut side = |sign: f64| -> Vec<CurvePoint> {
            towards[0] = sign;
            continue_branch(&mut rest, &start, &towards, &walk).map_or_else(Vec::new, |branch| branch.places)
        };
        let (down, up) = (side(-1.0), side(1.0));
        let places = down.into_iter().skip(1).rev().chain(up);
        let standing = |CurvePoint { x, fold }: CurvePoint| {
            let (n, matrix) = rest.linearised(&x);
            let growth = spectrum(n, &matrix).and_then(|all| Some(all.first()?.re));
            Some(Standing { angle: x[0], load: x[last], growth: growth?, fold })
        };
        places.filter_map(standing).collect()
    }

    /// The pull-out: the synchronous steady state with the greatest load.
    pub fn pull_out(in_step: &[Standing]) -> Option<&Standing> {
        in_step.iter().filter(|standing| standing.fold).max_by(|a, b| a.load.total_cmp(&b.load))
    }

    /// The branch of slipping motions, from a fast slip at which friction balances the load, to the longest periods.
    ///
    /// # Errors
    /// [`Failure`] if the first motion is not found, or if a motion cannot be integrated over one period.
    pub fn out_of_step(&self) -> Result<OutOfStep, Failure> {
        let facts = &self.facts;
        let count = facts.sizes.len();
        // at this slip friction alone exceeds the pull-out torque, hence there is no fold at faster slips
        let asks = |slip: f64| self.own.torque(facts.bottom, -slip) + facts.friction;
        let slow = facts.field_speed.abs().max(FAST * facts.frequency);
        let faster = |doublings: u32| slow * f64::from(1u32 << doublings);
        let fast = (1..MOST_DOUBLINGS).map(faster).find(|slip| asks(*slip) > 2.0 * facts.hold);
        let fast = fast.unwrap_or(faster(MOST_DOUBLINGS));
        let (shortest, longest) = (TAU / fast, LONGEST / facts.frequency);
        let mut start = vec![0.0; count];
        (start[0], start[1], start[count - 1]) = (shortest, -fast, self.own.torque(facts.bottom, -fast));
        let before = Cell::new((0.0, f64::INFINITY));
        let within = |x: &[f64]| {
            let (period, load) = (x[0], x[count - 1]);
            let (earlier, other) = before.replace((period, load));
            let longer = (period - earlier).abs() * facts.frequency;
            let settled = period > LONG / facts.frequency && (load - other).abs() < SETTLED * facts.hold * longer;
            (0.999 * shortest..longest).contains(&period) && load.abs() < MOST_LOAD * facts.hold && !settled
        };
        let mut towards = vec![0.0; count];
        towards[0] = 1.0;
        let (motions, last) = self.turns(&start, &towards, MOST, &within)?;
        let limit = if last == BranchEnd::Outside { self.limit(&motions) } else { None };
        Ok(OutOfStep { motions, limit })
    }

    /// The limit of the load for period T to infinity. The rotor approaches the unstable equilibrium as exp(-a t) and
    /// leaves it as exp(r t), with a and r from the eigenvalues. Therefore the load differs from its limit by a linear
    /// combination of exp(-r T) and exp(-a T) (Shilnikov 1963), and three motions of long period determine the limit.
    /// `None` if there is no equilibrium.
    fn limit(&self, motions: &[Slipping]) -> Option<f64> {
        let c = motions.last()?;
        let earlier =
            |apart: f64| motions.iter().rev().find(|one| one.period <= c.period - apart / self.facts.frequency);
        let (a, b) = (earlier(2.0 * APART)?, earlier(APART)?);
        let rates = self.rates_at_balance(c.load)?;
        let fade = |rate: f64, one: &Slipping| (-rate * (one.period - c.period)).exp();
        let row = |one: &Slipping| [1.0, fade(rates[0], one), fade(rates[1], one)];
        let matrix = Matrix3::from_rows(&[row(a), row(b), row(c)].map(RowVector3::from));
        let found = matrix.lu().solve(&Vector3::new(a.load, b.load, c.load))?;
        Some(found.x).filter(|load| load.is_finite())
    }

    /// Slipping motions by continuation from an initial guess. The angle is fixed as a phase condition; the period is
    /// the unknown in its place.
    fn turns(
        &self,
        start: &[f64],
        towards: &[f64],
        most: usize,
        within: &dyn Fn(&[f64]) -> bool,
    ) -> Result<(Vec<Slipping>, BranchEnd), Failure> {
        let (facts, count) = (&self.facts, start.len());
        let mut sizes = facts.sizes.clone();
        sizes[0] = 1.0 / facts.frequency;
        let mut shift = vec![0.0; count - 1];
        shift[0] = -TAU;
        let mut turns = PeriodicMotions::new(&*self.law, TOLERANCE, &shift, (0, facts.bottom));
        let walk = ContinuationSettings { sizes: &sizes, parameter: count - 1, step: LONGER_STEP, most, within };
        let lost = Failure::NewtonFailed { at: start[0], step: start[0] };
        let Branch { places, last } = continue_branch(&mut turns, start, towards, &walk).ok_or(lost)?;
        let slipping = |CurvePoint { x, fold }: CurvePoint| -> Result<Slipping, Failure> {
            let (n, matrix) = turns.returning(&x)?;
            let (mut state, period) = turns.motion(&x);
            state.pop();
            let multipliers = spectrum(n, &matrix).ok_or(Failure::LeftTheNumbers { at: period })?;
            let multiplier = multipliers.iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max);
            Ok(Slipping { period, load: x[count - 1], multiplier, fold, state })
        };
        Ok((places.into_iter().map(slipping).collect::<Result<_, _>>()?, last))
    }

    /// The slipping motions under one load, N m, from the fastest to the slowest.
    ///
    /// # Errors
    /// [`Failure`] if a motion cannot be integrated over one period.
    pub fn slipping_under(&self, load: f64, all: &OutOfStep) -> Result<Vec<Slipping>, Failure> {
        let mut found = Vec::new();
        for pair in all.motions.windows(2) {
            let (from, to) = (pair[0].load - load, pair[1].load - load);
            if from * to > 0.0 || to == 0.0 {
                continue;
            }
            let share = from / (from - to);
            let mut start = pair[0].state.clone();
            start.iter_mut().zip(&pair[1].state).for_each(|(a, b)| *a += share * (b - *a));
            start[0] = pair[0].period + share * (pair[1].period - pair[0].period);
            start.push(load);
            let mut towards = vec![0.0; start.len()];
            towards[start.len() - 1] = 1.0;
            // only the first point, at this load
            found.extend(self.turns(&start, &towards, 1, &|_| true)?.0);
        }
        Ok(found)
    }

    /// The rates, 1/s, at which the rotor leaves the unstable equilibrium under a load and approaches it; for complex
    /// eigenvalues the real part.
    fn rates_at_balance(&self, load: f64) -> Option<[f64; 2]> {
        let all = self.in_step();
        let between = |pair: &&[Standing]| {
            (pair[0].load - load) * (pair[1].load - load) <= 0.0 && pair.iter().all(|one| one.growth > 0.0)
        };
        let near = all.windows(2).find(between)?;
        let sizes = &self.facts.sizes;
        let mut start = vec![0.0; sizes.len()];
        let mut towards = start.clone();
        (start[0], start[sizes.len() - 1], towards[sizes.len() - 1]) = (near[0].angle, load, 1.0);
        let mut rest = Equilibria::new(&*self.law);
        // only the first point, on the branch at this load
        let walk = ContinuationSettings { sizes, parameter: sizes.len() - 1, step: STEP, most: 1, within: &|_| true };
        let at = continue_branch(&mut rest, &start, &towards, &walk)?;
        let (n, matrix) = rest.linearised(&at.places.first()?.x);
        match spectrum(n, &matrix)?[..] {
            [out, back, ..] if out.re > 0.0 && back.re < 0.0 => Some([out.re, -back.re]),
            _ => None,
        }
    }
}
