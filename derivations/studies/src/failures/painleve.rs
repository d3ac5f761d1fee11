//! Painleve's region: a state with no motion, or with several.

use super::bounds::first_positive;
use super::edge::edge;
use super::trials::{BUDGET, Fate, every_method, fate_of};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::friction::log::Names;
use crate::friction::stretch::{Stretch, parts};
use crate::friction::{ForRough, Rough, RoughScene};
use crate::regimes::critical;
use field::{Circle, Rational};
use integrators::{Method, Span, Tolerance, integrate};
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Direction, Face, Mode, Verdict, posed, verdict};
use reader::Family;
use std::path::Path;
use symbolic::Sym;

pub const FAILING: Failing = Failing {
    name: "painleve",
    title: "Painlevé's region: a state without a motion",
    scene: "friction/jam.toml",
    why: r"The acceleration of the contact is affine in its reaction, with the coefficient $(1+\kappa\cos^2\theta-f\kappa\sin\theta\cos\theta)/m$ for an end that slides ahead of the centre. Where that is negative a push makes the contact approach: no acceleration agrees with Coulomb's law, or two do. No method can be right where the law has no motion.",
    advice: "Let the run stop there and look at the margins by `dalembert regimes`; beyond the critical angle the contact needs compliance or an impact law, not a smaller step.",
    asked: "to stop at the critical angle and to say so",
    measure,
};

/// As close as an angle can be told.
const SHARP: f64 = 1e-13;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = RoughScene::open(path)?;
    let Rough::SlenderRod(rod) = &scene.system else {
        let accepted = "system = \"slender_rod\"";
        return Err(NotFound::unsuitable(path, format!("this is a {}", scene.system.name()), accepted));
    };
    let kappa = Rational::decimal(rod.mass * rod.half_length * rod.half_length / rod.inertia);
    let u = Sym::symbol("u");
    let room = critical::rod(Sym::constant(kappa), Circle::from_half_tangent(u))
        - Sym::constant(Rational::decimal(rod.friction));
    let half = first_positive(room, u);
    let Some(half) = half.filter(|half| half.to_f64() < 1.0) else {
        return Err(NotFound::unsuitable(path, "its friction is critical at no angle", "a friction above 4/3"));
    };
    let at = 2.0 * half.to_f64().atan();
    let exact = Exact::Formula(format!("2 arctan of {}", Exact::Root(half)), at);
    let threshold = |of, measured, parts| Threshold {
        of,
        formula: r"$f\kappa\sin\theta\cos\theta=1+\kappa\cos^2\theta$",
        exact: exact.clone(),
        unit: "rad",
        measured,
        within: Within::Share(parts),
    };
    let determined = |angle: f64| RoughScene { angle, ..scene.clone() }.apply(Determined);
    let course = scene.follow(&scene.plan, &mut |_| ());
    let last = course.column("angle").and_then(|angle| course.last().get(angle).copied());
    let thresholds = vec![
        threshold(
            "angle from which on no regime is consistent",
            edge(0.9 * at, 1.1 * at, SHARP, determined),
            1_000_000_000,
        ),
        threshold("angle at which a rod that turns towards it jams", last, 1_000_000_000),
    ];
    let one = |(by, method): (String, Method)| {
        let mut plan = scene.plan.clone();
        (plan.method, plan.tolerance, plan.evaluations) = (method, Tolerance::both(1e-9), Some(BUDGET));
        let fate = fate_of(&scene.follow(&plan, &mut |_| ()), |_| false)?;
        Some(Trial { by, fate })
    };
    let mut trials: Vec<Trial> = every_method(1_000).filter_map(one).collect();
    let beyond = RoughScene { angle: 1.2 * at, spin: 0.0, ..scene.clone() };
    trials.push(Trial { by: "slip taken for granted beyond it".to_owned(), fate: beyond.apply(Granted) });
    Ok(Found { thresholds, diagnosis: course.ending, trials })
}

/// Whether a state has one motion.
struct Determined;

impl ForRough for Determined {
    type Output = bool;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        _names: Names<K>,
    ) -> bool
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        posed(system, &start).is_ok_and(|(dry, touch)| matches!(verdict(&dry, &touch), Verdict::Unique(_)))
    }
}

/// A run that takes the slip backwards for granted and asks no regime: a hundredth of a second.
struct Granted;

impl ForRough for Granted {
    type Output = Fate;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        _names: Names<K>,
    ) -> Fate
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        let regime = [Mode::Slip(Direction::Backwards, Face::Front); K];
        let slip = Stretch { system, regime, rough: [true; K], rests: false, orientation: 1.0, speed: 1.0, load: 1.0 };
        let y = [&start.place[..], &start.velocity[..], &[0.0, 0.0]].concat();
        let span = Span::new(0.0, 0.01, &y).with_evaluations(BUDGET);
        let outcome = integrate(&slip, Method::DormandPrince8, &Tolerance::both(1e-9), &span, &mut ());
        let reactions = slip.solve(&parts::<f64, N>(outcome.time, &outcome.state)).map(|(_, it)| it.reactions());
        let pulls = reactions.is_some_and(|all| all.iter().any(|[normal, _]| *normal < 0.0));
        match outcome.failure() {
            Some(failure) => Fate::Stops(failure.name().to_owned()),
            None if pulls => Fate::Wrong,
            None => Fate::Holds,
        }
    }
}
