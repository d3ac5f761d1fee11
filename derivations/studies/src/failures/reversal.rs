//! Sliding reversals and chatter.

use super::edge::edge;
use super::entry::data;
use super::slip::{Friction, Slip};
use super::trials::{Fate, Running, Tried, across_events, every_method};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use field::{Rational, Scalar};
use integrators::{Method, Observer, Record, Span, Tolerance, integrate};
use mechanics::constrained::contacts::Sides;
use mechanics::constrained::{PointSystem, State};
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Face, Mode, Seen};
use num_traits::Zero;
use simulation::models::{Modelled, open};
use simulation::{Axes, Trajectory};
use std::path::Path;
use systems::steered_rod::SteeredRod;

pub const FAILING: Failing = Failing {
    name: "reversal",
    title: "sliding that stops or reverses: chatter",
    scene: "failures/stopping_rod.toml",
    why: r"Friction as $-fNv/|v|$ jumps at $v=0$ and is undefined there. Where friction can hold the push, the law drives the speed back to zero from both sides, but rest is no solution of it: the steps of Euler cross zero for ever, with a speed of up to $h(fN+X)/m$; adaptive steps collapse or chatter. With the smooth sign $v/\sqrt{v^2+\varepsilon^2}$ the body creeps for ever.",
    advice: "End the interval at the event v = 0 and determine the regime anew; neither a smaller step nor a smoother sign gives rest.",
    asked: "rest at the end of the span",
    measure,
};

/// The number of steps over the scene's span.
const STEPS: u32 = 5_000;
/// The budget of evaluations for a discontinuous law.
const FEW: u64 = 21_000;
/// A smaller speed counts as rest, m/s; the bisection uses the limit `STILL`, which only rounding errors stay below.
const REST: f64 = 1e-9;
const STILL: f64 = 1e-13;
/// The sliding speed below which the sign in the friction law is smoothed, m/s.
const SMOOTH: f64 = 1e-3;

type Rod<P> = SteeredRod<P>;
/// The rod with friction by the sign of the speed, without events.
type Sign = Slip<Rod<f64>, 4, 2>;

const ACCEPTED: &str =
    "a rod with the data m1, m2, l, g, f, X and the coordinates x, theta, as that of the scene stopping_rod";

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    let names = ["m1", "m2", "l", "g", "f", "X"];
    let [guided, free, length, gravity, friction, drive] = data(&*scene, path, names, ACCEPTED)?;
    let [angle, slide] = data(&*scene, path, ["theta", "x'"], ACCEPTED)?;
    let rod = Rod { guided, free, length, gravity, drive, friction, sides: Sides::Two };
    if angle != 0.0 || slide <= 0.0 {
        let accepted = "theta = \"0 deg\" and a positive speed x'";
        return Err(NotFound::unsuitable(path, "it does not slide along its guide", accepted));
    }
    let exact = decimals(&rod);
    let speed = Rational::decimal(slide);
    let stop = -speed / sliding(&exact, speed, Direction::Forwards);
    let stops = Threshold {
        of: "instant of rest, by events".into(),
        formula: r"$mv_0/(fN-X)$".into(),
        exact: Exact::Number(stop),
        unit: "s".into(),
        measured: run(&*scene).passages.get(1).map(|event| event.time),
        within: Within::Share(1_000_000_000),
    };
    // the backward acceleration from rest is linear in the applied force
    let backwards = |drive: Rational| sliding(&Rod { drive, ..exact }, Rational::zero(), Direction::Backwards);
    let (none, unit) = (backwards(Rational::zero()), backwards(Rational::int(1)));
    let turns = -none / (unit - none);
    let at = turns.to_f64();
    let reverses = Threshold {
        of: "push at which the body reverses instead of staying at rest, by events".into(),
        formula: r"$-fN$".into(),
        exact: Exact::Number(turns),
        unit: "N".into(),
        measured: edge(0.9 * at, 1.1 * at, 1e-12, |drive| stays(&*scene, drive)),
        within: Within::Share(1_000_000_000),
    };
    let law = Sign { system: rod, friction: Friction::Sign { smooth: 0.0 } };
    let at_start = along(length, slide);
    let (start, span) = ([at_start.place, at_start.velocity].concat(), scene.run().span);
    let chatter = Threshold {
        of: "greatest speed of Euler's chatter with friction as a sign function".into(),
        formula: r"$h(fN+X)/m$".into(),
        exact: Exact::Number(backwards(exact.drive) * Rational::decimal(span) / Rational::int(STEPS.into())),
        unit: "m/s".into(),
        measured: chatter(&law, &start, span, stop.to_f64()),
        within: Within::Share(100),
    };
    let by_events = |(by, method)| by_events(&*scene, by, method);
    let mut trials: Vec<Trial> = every_method(STEPS).filter_map(by_events).collect();
    let law_alone = Running::Alone(&law);
    let tried = Tried { law: law_alone, state: &start, span, tolerance: 1e-9, steps: STEPS, outputs: 1, budget: FEW };
    let resting = |y: &[f64]| y.get(4).is_some_and(|speed| speed.abs() < REST);
    let signed = tried.all(|record| record.states.last().is_some_and(|y| resting(y)));
    trials.extend(signed.into_iter().map(|trial| Trial { by: format!("as a sign, {}", trial.by), ..trial }));
    let smooth = Sign { friction: Friction::Sign { smooth: SMOOTH }, ..law };
    let (outcome, ..) = Tried { law: Running::Alone(&smooth), ..tried }.run(Method::Radau5);
    let fate = if resting(&outcome.state) { Fate::Holds } else { Fate::Wrong };
    trials.push(Trial { by: "as a smooth sign, radau_5".to_owned(), fate });
    let (outcome, ..) = tried.run(Method::DormandPrince5);
    let diagnosis = outcome.failure().map_or_else(String::new, |failure| failure.to_string());
    Ok(Found { thresholds: vec![stops, reverses, chatter], diagnosis, trials })
}

fn decimals(rod: &Rod<f64>) -> Rod<Rational> {
    let Rod { guided, free, length, gravity, drive, friction, sides } = *rod;
    let [guided, free, length, gravity, drive, friction] =
        [guided, free, length, gravity, drive, friction].map(Rational::decimal);
    Rod { guided, free, length, gravity, drive, friction, sides }
}

/// The state of the rod along the guide with a given speed.
fn along<S: Scalar>(length: S, speed: S) -> State<S, 4> {
    let zero = S::zero();
    State { time: zero, place: [zero, zero, length, zero], velocity: [speed, zero, speed, zero] }
}

/// The acceleration x1'' of the rod along its guide in sliding, by Cramer's rule.
fn sliding(rod: &Rod<Rational>, speed: Rational, direction: Direction) -> Rational {
    let at = along(rod.length, speed);
    let seen = Seen::<Rational, 4, 1>::of::<_, 2>(rod, &at, rod.force(&at));
    seen.map_or(Rational::UNDEFINED, |seen| {
        let reactions = Cramer::of(&seen.dry, &[Mode::Slip(direction, Face::Front)]).reactions();
        seen.acceleration(&reactions)[0]
    })
}

/// The run of a scene with its own method.
fn run(scene: &dyn Modelled) -> Trajectory {
    scene.problem(Axes::default()).simulate(&scene.run().choice(), |_| ())
}

/// Whether the rod stays at rest after it stopped, under an applied force: its final speed is then a rounding error.
fn stays(scene: &dyn Modelled, drive: f64) -> bool {
    let pushed = scene.with_values(&[("X", drive)]).map(|pushed| run(&*pushed));
    pushed.is_ok_and(|pushed| {
        let speed = pushed.column("x'").map(|speed| pushed.last[speed].abs());
        pushed.outcome.reached() && speed.is_some_and(|speed| speed < STILL)
    })
}

/// The trial of a method with event location.
fn by_events(scene: &dyn Modelled, by: String, method: Method) -> Option<Trial> {
    let problem = scene.problem(Axes::default());
    let speed = problem.columns.iter().position(|name| name == "x'")?;
    let rests = |record: &Record<f64>| record.states.last().is_some_and(|y| y[speed].abs() < REST);
    let fate = across_events(&problem, (method, scene.run().tolerance), rests)?;
    Some(Trial { by: format!("by events, {by}"), fate })
}

/// The largest speed after the time at which the rod should be at rest.
fn chatter(law: &Sign, start: &[f64], end: f64, rest: f64) -> Option<f64> {
    struct Greatest(f64, f64);
    impl Observer<f64> for Greatest {
        fn step(&mut self, time: f64, y: &[f64]) {
            if time > self.0 {
                self.1 = self.1.max(y[4].abs());
            }
        }
    }
    // a few steps later, when the speed has changed its sign
    let mut greatest = Greatest(rest + 10.0 * end / f64::from(STEPS), 0.0);
    let span = Span::new(0.0, end, start);
    let euler = Method::Euler { steps: STEPS };
    integrate(law, euler, &Tolerance::both(1e-9), &span, &mut greatest).reached().then_some(greatest.1)
}
