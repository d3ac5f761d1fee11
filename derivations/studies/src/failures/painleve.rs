//! Painleve's paradox: states with no consistent motion, or with several.

use super::bounds::first_positive;
use super::edge::edge;
use super::entry::data;
use super::slip::{Friction, Slip, parts};
use super::trials::{BUDGET, Fate, across_events, every_method};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::regimes::critical;
use field::{Analytic, Circle, Rational};
use integrators::{Method, Span, Tolerance, integrate};
use mechanics::constrained::State;
use mechanics::regimes::Direction;
use simulation::Axes;
use simulation::models::{Modelled, open};
use std::path::Path;
use symbolic::Sym;
use systems::slender_rod::SlenderRod;

pub const FAILING: Failing = Failing {
    name: "painleve",
    title: "Painlevé's region: a state without a motion",
    scene: "friction/jam.toml",
    why: r"The acceleration of the contact is affine in its reaction, with the coefficient $(1+\kappa\cos^2\theta-f\kappa\sin\theta\cos\theta)/m$ for an end that slides ahead of the centre. Where that is negative a push makes the contact approach: no acceleration agrees with Coulomb's law, or two do. No method can be right where the law has no motion.",
    advice: "Let the run stop there and read the margins of `dalembert regimes`; beyond the critical angle the contact needs compliance or an impact law, not a smaller step.",
    asked: "a stop at the critical angle, with this reason",
    measure,
};

/// The relative accuracy of the bisection for the angle.
const SHARP: f64 = 1e-13;

const ACCEPTED: &str = "a rod with the data m, l, kappa, g, f and the coordinates x, theta, as that of the scene jam";

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    let [mass, half_length, kappa, gravity, friction] = data(&*scene, path, ["m", "l", "kappa", "g", "f"], ACCEPTED)?;
    let [slide, _] = data(&*scene, path, ["x'", "theta"], ACCEPTED)?;
    let u = Sym::symbol("u");
    let room = critical::rod(Sym::constant(Rational::decimal(kappa)), Circle::from_half_tangent(u))
        - Sym::constant(Rational::decimal(friction));
    let half = first_positive(room, u);
    let Some(half) = half.filter(|half| half.to_f64() < 1.0) else {
        return Err(NotFound::unsuitable(path, "its friction is critical at no angle", "a friction above 4/3"));
    };
    let at = 2.0 * half.to_f64().atan();
    let exact = Exact::Formula(format!("2 arctan of {}", Exact::Root(half)), at);
    let threshold = |of: &'static str, measured, parts| Threshold {
        of: of.into(),
        formula: r"$f\kappa\sin\theta\cos\theta=1+\kappa\cos^2\theta$".into(),
        exact: exact.clone(),
        unit: "rad".into(),
        measured,
        within: Within::Share(parts),
    };
    let run = scene.run().choice();
    let trajectory = scene.problem(Axes::default()).simulate(&run, |_| ());
    let last = trajectory.column("theta").and_then(|theta| trajectory.last.get(theta).copied());
    let thresholds = vec![
        threshold(
            "angle from which on no regime is consistent",
            edge(0.9 * at, 1.1 * at, SHARP, |angle| has_one_motion(&*scene, angle)),
            1_000_000_000,
        ),
        threshold("angle at which a rod that turns towards it jams", last, 1_000_000_000),
    ];
    let problem = scene.problem(Axes::default());
    let one =
        |(by, method): (String, Method)| Some(Trial { by, fate: across_events(&problem, (method, 1e-9), |_| false)? });
    let mut trials: Vec<Trial> = every_method(1_000).filter_map(one).collect();
    let inertia = mass * half_length * half_length / kappa;
    let rod = SlenderRod { mass, inertia, half_length, gravity, friction };
    trials.push(Trial { by: "sliding assumed beyond it".to_owned(), fate: granted(rod, 1.2 * at, slide) });
    Ok(Found { thresholds, diagnosis: trajectory.stopped().unwrap_or_default(), trials })
}

/// Whether the motion from the start of a scene with another angle is unique.
fn has_one_motion(scene: &dyn Modelled, angle: f64) -> bool {
    let turned = scene.with_values(&[("theta", angle)]);
    turned.is_ok_and(|turned| {
        let problem = turned.problem(Axes::default());
        let mut state = problem.state.clone();
        problem.switching.is_some_and(|switching| switching.begin(0.0, &mut state).is_ok())
    })
}

/// The result of a run over 0.01 s that assumes backward slip without a check of the regime, from an angle with angular
/// velocity zero.
fn granted(rod: SlenderRod<f64>, angle: f64, slide: f64) -> Fate {
    let (l, Circle { cos, sin }) = (rod.half_length, angle.circle());
    let start = State { time: 0.0, place: [l * cos, l * sin, cos, sin], velocity: [slide, 0.0, 0.0, 0.0] };
    let slip: Slip<_, 4, 1> = Slip { system: rod, friction: Friction::Granted(Direction::Backwards) };
    let y = [start.place, start.velocity].concat();
    let span = Span::new(0.0, 0.01, &y).with_evaluations(BUDGET);
    let outcome = integrate(&slip, Method::DormandPrince8, &Tolerance::both(1e-9), &span, &mut ());
    let motion = slip.motion(&parts::<f64, 4>(outcome.time, &outcome.state));
    let pulls = motion.is_some_and(|(_, [normal, _])| normal < 0.0);
    match outcome.failure() {
        Some(failure) => Fate::Stops(failure.name().to_owned()),
        None if pulls => Fate::Wrong,
        None => Fate::Holds,
    }
}
