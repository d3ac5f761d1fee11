//! Sliding reversals and chatter.

use super::edge::edge;
use super::slopes::ByTangents;
use super::trials::{BUDGET, Fate, Tried, every_method, fate_of};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::friction::stretch::{motion_of_contacts, parts};
use crate::friction::{Course, Rough, RoughScene};
use field::{Analytic, Over, Rational, Scalar};
use integrators::{Method, Observer, Ode, Slopes, Tolerance, integrate};
use mechanics::constrained::{State, System};
use mechanics::regimes::cramer::Cramer;
use mechanics::regimes::{Direction, Face, Mode, Seen};
use num_traits::Zero;
use reader::Family;
use simulation::events::Margins;
use std::path::Path;
use systems::steered_rod::SteeredRod;

pub const FAILING: Failing = Failing {
    name: "reversal",
    title: "sliding that stops or turns: chatter",
    scene: "failures/stopping_rod.toml",
    why: r"Friction as $-fNv/|v|$ jumps at $v=0$ and is undefined there. Where the push is less than friction holds, both sides drive back to rest, which is no solution: a step of Euler crosses it for ever, with a speed of up to $h(fN+X)/m$; an adaptive step collapses or walks the surface. Smoothed, $v/\sqrt{v^2+\varepsilon^2}$, it creeps for ever.",
    advice: "Let the run end its stretch at the event v = 0 and decide the regime anew; neither a smaller step nor a smoother sign makes rest.",
    asked: "rest at the end of the span",
    measure,
};

/// Steps over the scene's span.
const STEPS: u32 = 5_000;
/// Evaluations that a method may spend on a law that jumps.
const FEW: u64 = 21_000;
/// A speed that is none, m/s.
const REST: f64 = 1e-9;
/// Within which a sign is smoothed, m/s.
const SMOOTH: f64 = 1e-3;

type Rod<P> = SteeredRod<P>;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = RoughScene::open(path)?;
    let Rough::SteeredRod(rod) = &scene.system else {
        let accepted = "system = \"steered_rod\"";
        return Err(NotFound::unsuitable(path, format!("this is a {}", scene.system.name()), accepted));
    };
    if scene.angle != 0.0 || scene.slide <= 0.0 {
        return Err(NotFound::unsuitable(
            path,
            "it does not slide along its guide",
            "angle = \"0 deg\" and a positive sliding",
        ));
    }
    let exact = decimals(rod);
    let speed = Rational::decimal(scene.slide);
    let stop = -speed / sliding(&exact, speed, Direction::Forwards);
    let course = scene.follow(&scene.plan, &mut |_| ());
    let stops = Threshold {
        of: "instant of rest, by events",
        formula: r"$mv_0/(fN-X)$",
        exact: Exact::Number(stop),
        unit: "s",
        measured: course.log.get(1).map(|line| line.time),
        within: Within::Share(1_000_000_000),
    };
    // from rest backwards, by a push that is linear in the acceleration
    let backwards = |drive: Rational| sliding(&Rod { drive, ..exact }, Rational::zero(), Direction::Backwards);
    let (none, unit) = (backwards(Rational::zero()), backwards(Rational::int(1)));
    let turns = -none / (unit - none);
    let at = turns.to_f64();
    let reverses = Threshold {
        of: "push that makes it turn instead of stay, by events",
        formula: r"$-fN$",
        exact: Exact::Number(turns),
        unit: "N",
        measured: edge(0.9 * at, 1.1 * at, 1e-12, |drive| rests(&scene, rod, drive)),
        within: Within::Share(1_000_000_000),
    };
    let law = Sign { rod: *rod, smooth: 0.0 };
    let start = law.start(scene.slide);
    let span = scene.plan.end;
    let chatter = Threshold {
        of: "greatest speed of Euler's chatter with friction as a sign",
        formula: r"$h(fN+X)/m$",
        exact: Exact::Number(backwards(exact.drive) * Rational::decimal(span) / Rational::int(STEPS.into())),
        unit: "m/s",
        measured: chatter(&law, &start, span, stop.to_f64()),
        within: Within::Share(100),
    };
    let mut trials: Vec<Trial> =
        every_method(STEPS).filter_map(|(by, method)| by_events(&scene, &by, method)).collect();
    let free: &Margins = &|_, _, _| Vec::new();
    let tried =
        Tried { law: &law, state: &start, span, tolerance: 1e-9, steps: STEPS, outputs: 1, budget: FEW, margins: free };
    let resting = |y: &[f64]| y.get(4).is_some_and(|speed| speed.abs() < REST);
    let signed = tried.all(|record| record.states.last().is_some_and(|y| resting(y)));
    trials.extend(signed.into_iter().map(|trial| Trial { by: format!("as a sign, {}", trial.by), ..trial }));
    let smooth = Sign { smooth: SMOOTH, ..law };
    let (outcome, ..) = Tried { law: &smooth, ..tried }.run(Method::Radau5);
    let fate = if resting(&outcome.state) { Fate::Holds } else { Fate::Wrong };
    trials.push(Trial { by: "as a smooth sign, radau_5".to_owned(), fate });
    let (outcome, ..) = Tried { law: &law, ..tried }.run(Method::DormandPrince5);
    let diagnosis = outcome.failure().map_or_else(String::new, |failure| failure.to_string());
    Ok(Found { thresholds: vec![stops, reverses, chatter], diagnosis, trials })
}

fn decimals(rod: &Rod<f64>) -> Rod<Rational> {
    let Rod { guided, free, length, gravity, drive, friction, sides } = *rod;
    let [guided, free, length, gravity, drive, friction] =
        [guided, free, length, gravity, drive, friction].map(Rational::decimal);
    Rod { guided, free, length, gravity, drive, friction, sides }
}

/// The state along the guide.
fn along<S: Scalar>(length: S, speed: S) -> State<S, 4> {
    let zero = S::zero();
    State { time: zero, place: [zero, zero, length, zero], velocity: [speed, zero, speed, zero] }
}

/// x1'' of the rod along its guide while it slides, by Cramer's rule.
fn sliding(rod: &Rod<Rational>, speed: Rational, direction: Direction) -> Rational {
    let at = along(rod.length, speed);
    let seen = Seen::<Rational, 4, 1>::of::<_, 2>(rod, &at, rod.force(&at));
    seen.map_or(Rational::UNDEFINED, |seen| {
        let reactions = Cramer::of(&seen.dry, &[Mode::Slip(direction, Face::Front)]).reactions();
        seen.acceleration(&reactions)[0]
    })
}

/// Whether the rod stays where it stops, under a push.
fn rests(scene: &RoughScene, rod: &Rod<f64>, drive: f64) -> bool {
    let pushed = RoughScene { system: Rough::SteeredRod(Rod { drive, ..*rod }), ..scene.clone() };
    let course = pushed.follow(&pushed.plan, &mut |_| ());
    course.log.get(1).is_some_and(|line| line.slides == [0])
}

/// A method between events.
fn by_events(scene: &RoughScene, by: &str, method: Method) -> Option<Trial> {
    let mut plan = scene.plan.clone();
    (plan.method, plan.evaluations) = (method, Some(BUDGET));
    let course = scene.follow(&plan, &mut |_| ());
    let speed = |course: &Course| course.column("sliding_guide").and_then(|at| course.last().get(at).copied());
    let fate = fate_of(&course, |course| speed(course).is_some_and(|speed| speed.abs() < REST))?;
    Some(Trial { by: format!("by events, {by}"), fate })
}

/// The rod with friction as a sign, -f N v/sqrt(v^2 + e^2), with no events: y = (x, x').
#[derive(Clone, Copy)]
struct Sign {
    rod: Rod<f64>,
    smooth: f64,
}

impl Sign {
    fn start(&self, speed: f64) -> Vec<f64> {
        let at = along(self.rod.length, speed);
        [at.place, at.velocity].concat()
    }
}

impl<S: Over<f64> + Analytic> Ode<S> for Sign {
    fn dimension(&self) -> usize {
        8
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        let at = parts::<S, 4>(t, y);
        let Ok(mut seen) = Seen::<S, 4, 1>::of::<_, 2>(&self.rod, &at, self.rod.force(&at)) else {
            dy.fill(S::zero() / S::zero());
            return;
        };
        let [[_, along]] = motion_of_contacts::<_, S, 4, 2, 1>(&self.rod, &at);
        let size = (along.slope.squared() + S::lift(self.smooth).squared()).sqrt();
        seen.dry.friction[0] *= along.slope / size;
        let forwards = [Mode::Slip(Direction::Forwards, Face::Front)];
        let acceleration = seen.acceleration(&Cramer::of(&seen.dry, &forwards).reactions());
        dy[..4].copy_from_slice(&at.velocity);
        dy[4..].copy_from_slice(&acceleration);
    }
}

impl integrators::System for Sign {
    fn slopes(&self) -> Option<Box<dyn Slopes + '_>> {
        Some(Box::new(ByTangents::of(self)))
    }
}

/// The greatest speed after the instant at which the rod should rest.
fn chatter(law: &Sign, start: &[f64], end: f64, rest: f64) -> Option<f64> {
    struct Greatest(f64, f64);
    impl Observer<f64> for Greatest {
        fn step(&mut self, time: f64, y: &[f64]) {
            if time > self.0 {
                self.1 = self.1.max(y[4].abs());
            }
        }
    }
    // a few steps later, when it has crossed rest
    let mut greatest = Greatest(rest + 10.0 * end / f64::from(STEPS), 0.0);
    let span = integrators::Span::new(0.0, end, start);
    let euler = Method::Euler { steps: STEPS };
    integrate(law, euler, &Tolerance::both(1e-9), &span, &mut greatest).reached().then_some(greatest.1)
}
