//! What a motor can do for ever under a load: stand in step, or slip turn after turn.

use super::loaded::Loaded;
use integrators::{Branch, CurvePoint, Equilibria, Failure, Last, Repeating, Walk, follow, spectrum};
use nalgebra::{Matrix3, RowVector3, Vector3};
use std::cell::Cell;
use std::f64::consts::{PI, TAU};

/// In step: an angle that the rotor keeps.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// rad
    pub angle: f64,
    /// N m
    pub load: f64,
    /// The largest real part of an eigenvalue, 1/s: below zero it is stable.
    pub growth: f64,
    /// Whether two angles merge here.
    pub fold: bool,
}

/// Out of step: the field's poles pass the rotor, each turn like the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Slipping {
    /// Of a turn of the rotor against the field, s.
    pub period: f64,
    /// N m
    pub load: f64,
    /// The largest size of a multiplier, that of the motion itself left out: below one it is stable.
    pub multiplier: f64,
    /// Whether two such motions merge here.
    pub fold: bool,
    /// Angle, slip and currents at one moment of it.
    pub state: Vec<f64>,
}

impl Slipping {
    /// The mean slip, rad/s.
    pub fn slip(&self) -> f64 {
        -TAU / self.period
    }

    /// Whether neighbours come to it.
    pub fn stable(&self) -> bool {
        self.multiplier < 1.0
    }
}

/// All that slips behind the field, from fast to slow.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfStep {
    pub motions: Vec<Slipping>,
    /// The load to which it tends as the turns become ever longer: there a motion leaves the angle that does not hold and
    /// comes back to it a turn later. `None` where it was not followed so far.
    pub limit: Option<f64>,
}

/// Steps of the walks, in units of the motor.
const STEP: f64 = 0.15;
const LONGER_STEP: f64 = 1.5;
/// Points of a walk.
const MOST: usize = 400;
/// Of the integration of a turn.
const TOLERANCE: f64 = 1e-13;
/// The longest turn, in units of 1/frequency.
const LONGEST: f64 = 120.0;
/// A load that changes by less, as a share of what the field holds, while turns become longer by 1/frequency, is near its
/// limit. Much nearer a turn cannot be shot: what it is at its end grows as fast as the load settles.
const SETTLED: f64 = 1e-8;
/// Turns that may be near it, and how far apart those are that tell it, in units of 1/frequency.
const LONG: f64 = 8.0;
const APART: f64 = 1.5;
/// The least number of swings' speeds with which the slipping begins.
const FAST: f64 = 6.0;
/// Of that speed, where friction is small.
const MOST_DOUBLINGS: u32 = 8;
/// The most that a load is looked at, in units of what the field holds.
const MOST_LOAD: f64 = 50.0;

impl Loaded {
    /// Every angle in step within half a turn on both sides of the lowest, over the load. In order of the angle.
    pub fn in_step(&self) -> Vec<Standing> {
        let sizes = &self.facts.sizes;
        let bottom = self.facts.bottom;
        let last = sizes.len() - 1;
        let mut start = vec![0.0; sizes.len()];
        (start[0], start[last]) = (bottom, self.own.moment(bottom, 0.0));
        let within = |x: &[f64]| (x[0] - bottom).abs() <= PI + STEP;
        let walk = Walk { sizes, parameter: last, step: STEP, most: MOST, within: &within };
        let mut rest = Equilibria::new(&*self.law);
        let mut towards = vec![0.0; sizes.len()];
        towards[0] = 1.0;
        let mut side = |sign: f64| -> Vec<CurvePoint> {
            towards[0] = sign;
            follow(&mut rest, &start, &towards, &walk).map_or_else(Vec::new, |branch| branch.places)
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

    /// The greatest load under which the rotor can stand in step, N m.
    pub fn pull_out(in_step: &[Standing]) -> Option<&Standing> {
        in_step.iter().filter(|standing| standing.fold).max_by(|a, b| a.load.total_cmp(&b.load))
    }

    /// Every slipping motion from one that the load drives backwards so fast that friction bears it, down to turns so long that
    /// they nearly rest.
    ///
    /// # Errors
    /// [`Failure`] where the first of them is not found, or one of them cannot be followed for a turn.
    pub fn out_of_step(&self) -> Result<OutOfStep, Failure> {
        let facts = &self.facts;
        let count = facts.sizes.len();
        // so fast that friction alone asks for more than the field could hold: beyond, nothing turns back
        let asks = |slip: f64| self.own.moment(facts.bottom, -slip) + facts.friction;
        let slow = facts.field_speed.abs().max(FAST * facts.frequency);
        let faster = |doublings: u32| slow * f64::from(1u32 << doublings);
        let fast = (1..MOST_DOUBLINGS).map(faster).find(|slip| asks(*slip) > 2.0 * facts.hold);
        let fast = fast.unwrap_or(faster(MOST_DOUBLINGS));
        let (shortest, longest) = (TAU / fast, LONGEST / facts.frequency);
        let mut start = vec![0.0; count];
        (start[0], start[1], start[count - 1]) = (shortest, -fast, self.own.moment(facts.bottom, -fast));
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
        let limit = if last == Last::Outside { self.limit(&motions) } else { None };
        Ok(OutOfStep { motions, limit })
    }

    /// The load of ever longer turns. The rotor comes to a balance as exp(-a t) and leaves it as exp(r t), with the eigenvalues
    /// there, so that what is left of the load is a sum of exp(-r T) and exp(-a T) (Shilnikov 1963), and three long motions tell
    /// the limit. Beyond every balance there is nothing near which it could rest.
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

    /// Turns along their curve, from near a start; the period has the angle's place among the unknowns.
    fn turns(
        &self,
        start: &[f64],
        towards: &[f64],
        most: usize,
        within: &dyn Fn(&[f64]) -> bool,
    ) -> Result<(Vec<Slipping>, Last), Failure> {
        let (facts, count) = (&self.facts, start.len());
        let mut sizes = facts.sizes.clone();
        sizes[0] = 1.0 / facts.frequency;
        let mut shift = vec![0.0; count - 1];
        shift[0] = -TAU;
        let mut turns = Repeating::new(&*self.law, TOLERANCE, &shift, (0, facts.bottom));
        let walk = Walk { sizes: &sizes, parameter: count - 1, step: LONGER_STEP, most, within };
        let lost = Failure::NewtonFailed { at: start[0], step: start[0] };
        let Branch { places, last } = follow(&mut turns, start, towards, &walk).ok_or(lost)?;
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

    /// The slipping motions under one load, from fast to slow.
    ///
    /// # Errors
    /// [`Failure`] where one of them cannot be followed for a turn.
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
            // the first point alone: under this load
            found.extend(self.turns(&start, &towards, 1, &|_| true)?.0);
        }
        Ok(found)
    }

    /// How fast the rotor leaves the balance under a load, and how fast it comes to it, 1/s; currents that swing count by
    /// how fast they fade.
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
        // the first point alone: on the branch, at this load
        let walk = Walk { sizes, parameter: sizes.len() - 1, step: STEP, most: 1, within: &|_| true };
        let at = follow(&mut rest, &start, &towards, &walk)?;
        let (n, matrix) = rest.linearised(&at.places.first()?.x);
        match spectrum(n, &matrix)?[..] {
            [out, back, ..] if out.re > 0.0 && back.re < 0.0 => Some([out.re, -back.re]),
            _ => None,
        }
    }
}
