//! A singular coordinate: the integrable constraint of task 1 for sin(theta) -> 0.

use super::entry::data;
use super::trials::{BUDGET, Running, Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use field::{Analytic, Over};
use integrators::{Method, Observer, Ode, Record, Span, Tolerance, integrate};
use mechanics::constrained::contacts::Sides;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::{Charted, PointSystem, State, appell};
use simulation::models::open;
use std::f64::consts::{LN_2, PI};
use std::path::Path;
use systems::steered_rod::SteeredRod;

pub const FAILING: Failing = Failing {
    name: "straightening",
    title: "the integrable constraint of the steered rod where sin(theta) goes to zero",
    scene: "failures/straightening_rod.toml",
    why: r"$\dot\theta=2\dot x\sin\theta/l$ has the integral $x-\frac l2\ln\tan\frac\theta2$, so that the angle alone would be a coordinate, with $\dot x=l\dot\theta/(2\sin\theta)$. But $\tan\frac\theta2$ grows as $\exp(2x/l)$, and the last two floats below $\pi$ meet at $\delta=2^{-52}+\pi-\mathrm{fl}(\pi)$ from it: after $\frac l2\ln\frac2{\delta\tan\theta_0/2}$ an angle rounds to the last one, and no longer determines the position. At $\sin\theta=0$ the chart has no rates.",
    advice: "Use the position along the guide as the coordinate and its rate as the quasi-velocity: their equations have no singular angle.",
    asked: "the speed along the guide within 1/1000",
    measure,
};

/// The largest error of ln tan(theta/2) for which the angle still determines the position: a factor of two in
/// tan(theta/2).
const TOLD: f64 = LN_2;
/// The number of steps in which the angle's distance from pi decreases by the factor e.
const STEPS_TO_A_FOLD: f64 = 2.0;

const ACCEPTED: &str =
    "a rod with the data m1, m2, l, g, f and the coordinates x, theta, as that of the scene straightening_rod";

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    let [guided, free, length, gravity, friction] = data(&*scene, path, ["m1", "m2", "l", "g", "f"], ACCEPTED)?;
    let [theta, speed] = data(&*scene, path, ["theta", "x'"], ACCEPTED)?;
    if friction != 0.0 || speed <= 0.0 || theta.sin() <= 0.0 {
        let accepted = "f = \"0\", a positive speed x', theta between 0 and 180 degrees";
        return Err(NotFound::unsuitable(path, "this rod does not straighten", accepted));
    }
    let rod = SteeredRod { guided, free, length, gravity, drive: 0.0, friction, sides: Sides::Two };
    let span = scene.run().span;
    let first = (0.5 * theta).tan().ln();
    // pi - fl(pi) is the sine of the float
    let last = PI.sin() + 0.5 * f64::EPSILON;
    let value = 0.5 * rod.length * ((2.0 / last).ln() - first);
    let degrees = (theta.to_degrees() * 1e9).round() / 1e9;
    let formula = format!("{}/2 (ln(2/(2^-52 + pi - fl(pi))) - ln tan({degrees} deg/2))", rod.length);
    let by_place = ByPlace(rod);
    let start = [0.0, theta, speed];
    let far = Threshold {
        of: "distance after which the angle does not determine the position".into(),
        formula: r"$\frac l2\ln\frac2{\delta\tan\theta_0/2}$".into(),
        exact: Exact::Formula(formula, value),
        unit: "m".into(),
        measured: told_until(&by_place, &start, span),
        // rounding errors decay as the distance does: their sum is below 1/2 (1 + e^-1/2 + e^-1 + ..) = 1.3 spacings,
        // which doubles a distance of 2.5 instead of the theoretical 0.78: 0.9 m earlier; and the angle is checked
        // every 0.38 m
        within: Within::Share(20),
    };
    let tolerance = 1e-9;
    let place = Running::Alone(&by_place);
    let tried = Tried { law: place, state: &start, span, tolerance, steps: 2_000, outputs: 10, budget: BUDGET };
    let speeds = |record: &Record<f64>, of: &dyn Fn(&[f64]) -> f64| Record {
        times: record.times.clone(),
        states: record.states.iter().map(|y| vec![of(y)]).collect(),
    };
    let right = speeds(&tried.right(), &|y| y[2]);
    let by_angle = ByAngle(rod);
    let turning = [0.0, theta, 2.0 * speed * theta.sin() / rod.length];
    let in_angle = Tried { law: Running::Alone(&by_angle), state: &turning, ..tried };
    let of_angle = |y: &[f64]| rod.length * y[2] / (2.0 * y[1].sin());
    let named = |name: &str, trials: Vec<Trial>| -> Vec<Trial> {
        trials.into_iter().map(|trial| Trial { by: format!("{name}, {}", trial.by), ..trial }).collect()
    };
    let mut trials = named("place", tried.all(|record| near(&speeds(record, &|y| y[2]), &right, 1e-3)));
    trials.extend(named("angle", in_angle.all(|record| near(&speeds(record, &of_angle), &right, 1e-3))));
    let along = Span::new(0.0, 1.0, &[0.0, 0.0, 0.0]);
    let refused = integrate(&by_angle, Method::DormandPrince8, &Tolerance::both(1e-9), &along, &mut ()).failure();
    let diagnosis = refused.map_or_else(String::new, |failure| failure.to_string());
    Ok(Found { thresholds: vec![far], diagnosis, trials })
}

/// The rod with the state y = (x, theta, x').
struct ByPlace(SteeredRod<f64>);

/// The rod with the state y = (x, theta, theta').
struct ByAngle(SteeredRod<f64>);

impl PointSystem<4> for ByAngle {
    type Given = f64;

    fn masses<S: Over<f64>>(&self) -> [S; 4] {
        self.0.masses()
    }

    fn force<S: Over<f64>>(&self, at: &State<S, 4>) -> [S; 4] {
        self.0.force(at)
    }
}

/// The chart with x' = l theta'/(2 sin theta).
impl Charted<4, 2, 1> for ByAngle {
    fn place<S: Over<f64> + Analytic>(&self, time: S, q: [S; 2]) -> [S; 4] {
        self.0.place(time, q)
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, q: [S; 2], [turning]: [S; 1]) -> [S; 2] {
        // theta' for x' = 1
        let [_, turned] = Charted::rates(&self.0, time, q, [S::one()]);
        [turning / turned, turning]
    }
}

impl<S: Over<f64> + Analytic> Ode<S> for ByPlace {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        rates(&self.0, t, y, dy);
    }
}

impl<S: Over<f64> + Analytic> Ode<S> for ByAngle {
    fn dimension(&self) -> usize {
        3
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        rates(self, t, y, dy);
    }
}

/// (q', p') by Appell's equations; undefined where these do not determine p'.
fn rates<Q, S>(rod: &Q, time: S, y: &[S], dy: &mut [S])
where
    Q: Charted<4, 2, 1, Given = f64>,
    S: Over<f64> + Analytic,
{
    let (q, p) = ([y[0], y[1]], [y[2]]);
    let motion: Motion<S, 4, 1> = Motion::at(rod, time, q, p);
    let [turned] = appell::rates(rod, &motion, rod.force(&motion.state)).unwrap_or([S::zero() / S::zero()]);
    dy[..2].copy_from_slice(&rod.rates(time, q, p));
    dy[2] = turned;
}

impl integrators::System for ByPlace {}
impl integrators::System for ByAngle {}

/// The distance after which the angle no longer determines the position: the end of the first step at which the error
/// exceeds `TOLD`.
///
/// A tolerance would bound the error of the angle, not that of its distance from pi. The run therefore has constant
/// steps of Runge-Kutta 4, two while that distance decreases by the factor e; 3 % of the distance remain at the end.
fn told_until(law: &ByPlace, start: &[f64], end: f64) -> Option<f64> {
    struct First<F>(F, Option<f64>);
    impl<F: Fn(&[f64]) -> f64> Observer<f64> for First<F> {
        fn step(&mut self, _time: f64, y: &[f64]) {
            self.1 = self.1.or_else(|| ((self.0)(y) > TOLD).then_some(y[0]));
        }
    }
    let first = (0.5 * start[1]).tan().ln();
    let off = |y: &[f64]| ((0.5 * y[1]).tan().abs().ln() - first - 2.0 * y[0] / law.0.length).abs();
    let steps = (STEPS_TO_A_FOLD * 2.0 * start[2] * end / law.0.length).ceil() as u32;
    let mut lost = First(off, None);
    let (span, tolerance) = (Span::new(0.0, end, start), Tolerance::both(1e-13));
    integrate(law, Method::RungeKutta4 { steps }, &tolerance, &span, &mut lost).reached().then_some(())?;
    lost.1
}
