//! Ways to keep a constraint, compared on one mechanism: how far it drifts, how far the motion is off, what it costs.

use super::law::{Stabilised, state};
use super::regions::MECHANISM;
use super::schemes::Scheme;
use crate::systems::crank_slider::CrankSlider;
use field::DoubleDouble;
use integrators::{Failure, Reference, Span, Tolerance, integrate, reference};
use mechanics::constrained::State;
use mechanics::constrained::energies::{Energies, Instant, Kinematics, Reduced};
use mechanics::definite::{NotDefinite, solve};

/// What is done about the constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Treatment {
    /// Lagrange's multipliers, f'' = 0, and nothing else.
    IndexReduction,
    /// f'' = -b f' - k f with the gains of the fastest decay for the method at its step.
    Fastest,
    /// The same, critically damped with gains of its own time, [`MODERATE`], whatever the step.
    Moderate,
    /// Lagrange's multipliers; after each step the place is moved onto f = 0, then the velocity onto f' = 0, both by the
    /// least change in the metric of the mass.
    Projected,
    /// Gear, Gupta and Leimkuhler: q' = v + M^-1 J^T mu with a second multiplier, f = 0 and f' = 0 imposed at every
    /// stage (half-explicit Runge-Kutta methods after Hairer, Lubich and Roche).
    GearGuptaLeimkuhler,
    /// A coordinate that keeps the constraint.
    Minimal,
}

impl Treatment {
    /// All of them.
    pub const ALL: [Treatment; 6] = [
        Treatment::IndexReduction,
        Treatment::Fastest,
        Treatment::Moderate,
        Treatment::Projected,
        Treatment::GearGuptaLeimkuhler,
        Treatment::Minimal,
    ];

    /// For a table.
    pub fn name(self) -> &'static str {
        match self {
            Treatment::IndexReduction => "index reduction",
            Treatment::Fastest => "stabilised, fastest decay",
            Treatment::Moderate => "stabilised, b = 20/s, k = 100/s²",
            Treatment::Projected => "projection, place and velocity",
            Treatment::GearGuptaLeimkuhler => "Gear-Gupta-Leimkuhler",
            Treatment::Minimal => "minimal coordinates",
        }
    }
}

/// What came of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The largest |f| after a step, m^2.
    pub drift: f64,
    /// The largest |f'|, m^2/s.
    pub rate_drift: f64,
    /// The largest error of (q, q') at the outputs, each relative to its size.
    pub error: f64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Evaluations of the constraint alone, by which places and velocities are corrected.
    pub corrections: u64,
}

/// A line of the comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub scheme: Scheme,
    pub steps: u32,
    pub treatment: Treatment,
    /// None where the combination does not exist; a failure where the run broke off.
    pub measured: Option<Result<Measured, Failure>>,
}

/// The rate at which moderate gains bring a violation back, 1/s.
pub const MODERATE: f64 = 10.0;

/// The span, s: the crank turns from 0.7 with 6 rad/s, about nine times.
pub const SPAN: f64 = 10.0;
const OUTPUTS: u32 = 100;
const START: [f64; 2] = [0.7, 6.0];

type Law<'a> = Stabilised<'a, CrankSlider<f64>, 2, 1>;

/// The motion in its one coordinate, to all digits.
fn exact() -> Result<Reference, Failure> {
    let reduced = Reduced(&MECHANISM);
    let law = Stabilised::<_, 1, 0> { system: &reduced, damping: 0.0, stiffness: 0.0 };
    reference(&law, &Span::new(0.0, SPAN, &START).with_even_outputs(OUTPUTS as usize))
}

/// (q, q') of the one coordinate.
fn whole(s: &[f64]) -> [f64; 4] {
    let (q, dq) = Reduced(&MECHANISM).motion(0.0, [s[0]], [s[1]]);
    [q[0], q[1], dq[0], dq[1]]
}

/// Every treatment with three methods, each with a step of its own, and with half of it.
///
/// # Errors
/// Where the reference broke off.
pub fn compare() -> Result<Vec<Line>, Failure> {
    let goal = Goal::new()?;
    let runs = [
        (Scheme::Euler, 20_000),
        (Scheme::Euler, 40_000),
        (Scheme::RungeKutta4, 1_000),
        (Scheme::RungeKutta4, 2_000),
        (Scheme::ImplicitMidpoint, 2_000),
        (Scheme::ImplicitMidpoint, 4_000),
    ];
    Ok(runs
        .into_iter()
        .flat_map(|(scheme, steps)| Treatment::ALL.map(|treatment| (scheme, steps, treatment)))
        .map(|(scheme, steps, treatment)| Line {
            scheme,
            steps,
            treatment,
            measured: measure(scheme, steps, treatment, &goal),
        })
        .collect())
}

/// Drift and error by the rate of critically damped gains, b = 2 w, k = w^2, at a constant step.
#[derive(Clone, Debug)]
pub struct Scan {
    pub scheme: Scheme,
    pub steps: u32,
    /// (h w, largest |f|, error).
    pub points: Vec<(f64, f64, f64)>,
}

/// Euler, Runge-Kutta and the midpoint rule over the rates that they bear.
///
/// # Errors
/// Where the reference broke off.
pub fn scans() -> Result<Vec<Scan>, Failure> {
    let goal = Goal::new()?;
    let over = |scheme, steps| {
        let rates = (0..40).map(|k| 10f64.powf(-3.0 + 0.1 * f64::from(k)));
        let measured = rates.filter_map(|rate| {
            let found = critically_damped(scheme, steps, rate, &goal).ok()?;
            (found.error < 10.0).then_some((rate, found.drift, found.error))
        });
        Scan { scheme, steps, points: measured.collect() }
    };
    Ok(vec![over(Scheme::Euler, 20_000), over(Scheme::RungeKutta4, 1_000), over(Scheme::ImplicitMidpoint, 2_000)])
}

fn critically_damped(scheme: Scheme, steps: u32, rate: f64, goal: &Goal) -> Result<Measured, Failure> {
    let h = SPAN / f64::from(steps);
    let law = Law { system: &MECHANISM, damping: 2.0 * rate / h, stiffness: (rate / h).powi(2) };
    follow(steps, &whole(&START), goal, |y| *y, |t, y, work| advance(&law, scheme, t, h, y, work))
}

/// The reference at the outputs.
struct Goal {
    states: Vec<[f64; 4]>,
    sizes: [f64; 4],
}

impl Goal {
    fn new() -> Result<Self, Failure> {
        let reference = exact()?;
        let states: Vec<[f64; 4]> = reference
            .states
            .iter()
            .map(|s| {
                let (q, dq) = Reduced(&MECHANISM).motion(DoubleDouble::from(0.0), [s[0]], [s[1]]);
                [q[0], q[1], dq[0], dq[1]].map(|value| value.hi())
            })
            .collect();
        let sizes = std::array::from_fn(|i| states.iter().map(|s| s[i].abs()).fold(0.0, f64::max));
        Ok(Goal { states, sizes })
    }
}

fn measure(scheme: Scheme, steps: u32, treatment: Treatment, goal: &Goal) -> Option<Result<Measured, Failure>> {
    let h = SPAN / f64::from(steps);
    let gains = |beta: f64, kappa: f64| Law { system: &MECHANISM, damping: beta / h, stiffness: kappa / (h * h) };
    let start = whole(&START);
    Some(match treatment {
        Treatment::IndexReduction => {
            let law = gains(0.0, 0.0);
            follow(steps, &start, goal, |y| *y, |t, y, work| advance(&law, scheme, t, h, y, work))
        }
        Treatment::Fastest | Treatment::Moderate => {
            let (beta, kappa) = match treatment {
                Treatment::Moderate => (2.0 * MODERATE * h, (MODERATE * h).powi(2)),
                _ => scheme.best()?,
            };
            let law = gains(beta, kappa);
            follow(steps, &start, goal, |y| *y, |t, y, work| advance(&law, scheme, t, h, y, work))
        }
        Treatment::Projected => {
            let law = gains(0.0, 0.0);
            follow(
                steps,
                &start,
                goal,
                |y| *y,
                |t, y, work| {
                    advance(&law, scheme, t, h, y, work)?;
                    project(y, work).map_err(|_| Failure::Singular { at: t + h })
                },
            )
        }
        Treatment::GearGuptaLeimkuhler => {
            let tableau: &[&[f64]] = match scheme {
                Scheme::Euler => &[&[1.0]],
                Scheme::RungeKutta4 => {
                    &[&[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0], &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0]]
                }
                Scheme::BackwardEuler | Scheme::ImplicitMidpoint => return None,
            };
            follow(
                steps,
                &start,
                goal,
                |y| *y,
                |t, y, work| half_explicit(tableau, h, y, work).map_err(|_| Failure::Singular { at: t }),
            )
        }
        Treatment::Minimal => {
            let reduced = Reduced(&MECHANISM);
            let law = Stabilised::<_, 1, 0> { system: &reduced, damping: 0.0, stiffness: 0.0 };
            follow(steps, &START, goal, |s| whole(s), |t, y, work| advance(&law, scheme, t, h, y, work))
        }
    })
}

/// Evaluations of the equations and of the constraint.
#[derive(Default)]
struct Cost {
    evaluations: u64,
    corrections: u64,
}

/// Steps through the span, looks at the constraint after each and at the error at the outputs.
fn follow<const K: usize>(
    steps: u32,
    start: &[f64; K],
    goal: &Goal,
    whole: impl Fn(&[f64; K]) -> [f64; 4],
    mut step: impl FnMut(f64, &mut [f64; K], &mut Cost) -> Result<(), Failure>,
) -> Result<Measured, Failure> {
    let (mut y, mut cost) = (*start, Cost::default());
    let mut found = Measured { drift: 0.0, rate_drift: 0.0, error: 0.0, evaluations: 0, corrections: 0 };
    for k in 0..steps {
        step(SPAN * f64::from(k) / f64::from(steps), &mut y, &mut cost)?;
        let all = whole(&y);
        let constraint = Kinematics::of(&MECHANISM, &state::<f64, 2>(0.0, &all));
        found.drift = found.drift.max(constraint.value[0].abs());
        found.rate_drift = found.rate_drift.max(constraint.rate[0].abs());
        if (k + 1).is_multiple_of(steps / OUTPUTS)
            && let Some(right) = goal.states.get(((k + 1) / (steps / OUTPUTS)) as usize - 1)
        {
            let errors = (0..4).map(|i| (all[i] - right[i]).abs() / goal.sizes[i]);
            found.error = errors.fold(found.error, f64::max);
        }
    }
    Ok(Measured { evaluations: cost.evaluations, corrections: cost.corrections, ..found })
}

/// One step of an integrator.
fn advance<Q: Energies<N, C, Given = f64>, const N: usize, const C: usize, const K: usize>(
    law: &Stabilised<'_, Q, N, C>,
    scheme: Scheme,
    t: f64,
    h: f64,
    y: &mut [f64; K],
    cost: &mut Cost,
) -> Result<(), Failure> {
    let outcome = integrate(law, scheme.method(1), &Tolerance::both(1e-9), &Span::new(t, t + h, &*y), &mut ());
    cost.evaluations += outcome.work.rates + outcome.work.jacobians;
    match outcome.failure() {
        Some(failure) => Err(failure),
        None => {
            y.copy_from_slice(&outcome.state);
            Ok(())
        }
    }
}

/// Corrections of a place after which it is as near to f = 0 as rounding allows.
const MOST_CORRECTIONS: usize = 20;
const KEPT: f64 = 1e-15;

/// Onto f = 0, then onto f' = 0.
fn project(y: &mut [f64; 4], cost: &mut Cost) -> Result<(), NotDefinite> {
    for _ in 0..MOST_CORRECTIONS {
        let instant = Instant::of(&MECHANISM, &state::<f64, 2>(0.0, &*y));
        cost.corrections += 1;
        let change = instant.change(instant.kinematics.value.map(|f| -f))?;
        (y[0], y[1]) = (y[0] + change[0], y[1] + change[1]);
        if change.iter().all(|d| d.abs() < KEPT) {
            break;
        }
    }
    let instant = Instant::of(&MECHANISM, &state::<f64, 2>(0.0, &*y));
    cost.corrections += 1;
    let change = instant.change(instant.kinematics.rate.map(|f| -f))?;
    (y[2], y[3]) = (y[2] + change[0], y[3] + change[1]);
    Ok(())
}

/// One step of a half-explicit method: the multipliers of a stage are those with which the next one is on the
/// constraint, in place and in velocity. The tableau ends with the weights.
fn half_explicit(tableau: &[&[f64]], h: f64, y: &mut [f64; 4], cost: &mut Cost) -> Result<(), NotDefinite> {
    let start = state::<f64, 2>(0.0, &*y);
    let mut now = start;
    // q' and v' of the stages so far
    let mut slopes: Vec<([f64; 2], [f64; 2])> = Vec::with_capacity(tableau.len());
    for weights in tableau {
        let instant = Instant::of(&MECHANISM, &now);
        cost.evaluations += 1;
        let free = solve(instant.mass, instant.force)?;
        let [push] = [solve(instant.mass, instant.kinematics.rows[0])?];
        slopes.push((now.velocity, free));
        let sum = |start: [f64; 2], of: &dyn Fn(usize) -> [f64; 2]| -> [f64; 2] {
            std::array::from_fn(|i| (0..weights.len()).fold(start[i], |sum, j| sum + h * weights[j] * of(j)[i]))
        };
        let last = weights.len() - 1;
        let reach = h * weights[last];
        let mut place = sum(start.place, &|j| slopes[j].0);
        let trial = sum(start.velocity, &|j| slopes[j].1);
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        for _ in 0..MOST_CORRECTIONS {
            let found = Kinematics::of(&MECHANISM, &State { time: 0.0, place, velocity: trial });
            cost.corrections += 1;
            let mu = -found.value[0] / (reach * dot(found.rows[0], push));
            for i in 0..2 {
                slopes[last].0[i] += mu * push[i];
                place[i] += reach * mu * push[i];
            }
            if (0..2).all(|i| (reach * mu * push[i]).abs() < KEPT) {
                break;
            }
        }
        let found = Kinematics::of(&MECHANISM, &State { time: 0.0, place, velocity: trial });
        cost.corrections += 1;
        let lambda = -found.rate[0] / (reach * dot(found.rows[0], push));
        (0..2).for_each(|i| slopes[last].1[i] += lambda * push[i]);
        let velocity = std::array::from_fn(|i| trial[i] + reach * lambda * push[i]);
        now = State { time: 0.0, place, velocity };
    }
    *y = [now.place[0], now.place[1], now.velocity[0], now.velocity[1]];
    Ok(())
}
