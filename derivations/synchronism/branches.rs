//! What a motor can do for ever under a load: stand in step, or slip turn after turn.

use super::loaded::Loaded;
use integrators::{Branch, Equilibria, Failure, Last, Place, Repeating, Walk, follow, spectrum};
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
const LONGER_STEP: f64 = 0.6;
/// Of the integration of a turn.
const TOLERANCE: f64 = 1e-13;
/// The longest turn, in units of 1/frequency: of a motion that rests near the balance, exp(22) times nearer at its end.
const LONGEST: f64 = 22.0;
/// The least number of swings' speeds with which the slipping begins.
const FAST: f64 = 6.0;
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
        let walk = Walk { sizes, parameter: last, step: STEP, most: 400, within: &within };
        let mut rest = Equilibria::new(&*self.law);
        let mut towards = vec![0.0; sizes.len()];
        towards[0] = 1.0;
        let mut side = |sign: f64| -> Vec<Place> {
            towards[0] = sign;
            follow(&mut rest, &start, &towards, &walk).map_or_else(Vec::new, |branch| branch.places)
        };
        let (down, up) = (side(-1.0), side(1.0));
        let places = down.into_iter().skip(1).rev().chain(up);
        let standing = |Place { x, fold }: Place| {
            let (n, matrix) = rest.linearised(&x);
            let growth = spectrum(n, &matrix).and_then(|all| Some(all.first()?.re));
            Some(Standing { angle: x[0], load: x[last], growth: growth?, fold })
        };
        places.filter_map(standing).collect()
    }

    /// Every slipping motion from one as fast as the field on a rotor at rest, or faster, down to turns so long that they
    /// nearly rest.
    ///
    /// # Errors
    /// [`Failure`] where the first of them is not found, or one of them cannot be followed for a turn.
    pub fn out_of_step(&self) -> Result<OutOfStep, Failure> {
        let facts = &self.facts;
        let count = facts.sizes.len();
        let fast = facts.field_speed.abs().max(FAST * facts.frequency);
        let mut sizes = facts.sizes.clone();
        // the period has the angle's place
        sizes[0] = 1.0 / facts.frequency;
        let (shortest, longest) = (TAU / fast, LONGEST / facts.frequency);
        let mut start = vec![0.0; count];
        (start[0], start[1], start[count - 1]) = (shortest, -fast, self.own.moment(facts.bottom, -fast));
        let mut shift = vec![0.0; count - 1];
        shift[0] = -TAU;
        let mut turns = Repeating::new(&*self.law, TOLERANCE, &shift, (0, facts.bottom));
        let within = |x: &[f64]| {
            let load = x[count - 1];
            (0.999 * shortest..longest).contains(&x[0]) && load.abs() < MOST_LOAD * facts.hold
        };
        let walk = Walk { sizes: &sizes, parameter: count - 1, step: LONGER_STEP, most: 400, within: &within };
        let mut towards = vec![0.0; count];
        towards[0] = 1.0;
        let lost = Failure::NewtonFailed { at: shortest, step: shortest };
        let Branch { places, last } = follow(&mut turns, &start, &towards, &walk).ok_or(lost)?;
        let slipping = |Place { x, fold }: Place| -> Result<Slipping, Failure> {
            let (n, matrix) = turns.monodromy(&x)?;
            let (mut state, period) = turns.motion(&x);
            state.pop();
            let multiplier = largest_but_one(n, &matrix).ok_or(Failure::LeftTheNumbers { at: period })?;
            Ok(Slipping { period, load: x[count - 1], multiplier, fold, state })
        };
        let motions = places.into_iter().map(slipping).collect::<Result<Vec<_>, _>>()?;
        let limit = if last == Last::Outside { self.limit(&motions) } else { None };
        Ok(OutOfStep { motions, limit })
    }

    /// The load of ever longer turns: as the rotor rests near the balance it leaves it as exp(r t), r the eigenvalue there,
    /// so that what is left of the load falls as exp(-r T).
    fn limit(&self, motions: &[Slipping]) -> Option<f64> {
        let [.., before, last] = motions else { return None };
        let growth = self.in_step().into_iter().filter(|standing| standing.growth > 0.0);
        let nearest = growth.min_by(|a, b| (a.load - last.load).abs().total_cmp(&(b.load - last.load).abs()))?;
        if (nearest.load - last.load).abs() > 0.2 * self.facts.hold {
            // beyond every balance: there is nothing near which it could rest
            return None;
        }
        let left = (-nearest.growth * (last.period - before.period)).exp();
        Some((last.load - left * before.load) / (1.0 - left))
    }
}

/// The largest size of an eigenvalue of the matrix of a turn; the one nearest to 1 is the motion's own.
fn largest_but_one(n: usize, matrix: &[f64]) -> Option<f64> {
    let mut all = spectrum(n, matrix)?;
    let off = |z: &nalgebra::Complex<f64>| (z.re - 1.0).hypot(z.im);
    let own = (0..all.len()).min_by(|&a, &b| off(&all[a]).total_cmp(&off(&all[b])))?;
    all.swap_remove(own);
    Some(all.iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max))
}

impl OutOfStep {
    /// The least load under which a rotor can slip for ever, N m: below it every motion is pulled in. `None` where it
    /// slips under no load.
    pub fn least(&self) -> Option<f64> {
        let stable = self.motions.iter().filter(|one| one.stable() || one.fold).map(|one| one.load);
        let ends = self.limit.filter(|_| self.motions.last().is_some_and(Slipping::stable));
        stable.chain(ends).min_by(f64::total_cmp)
    }
}
