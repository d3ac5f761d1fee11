//! The governor with an elastic rim as a text model: stability of its steady motion, and reduced models of the rim.
//!
//! With the rolled distance s, s' = R omega1, the rim relaxes according to
//!
//!   lambda_s = x_s - psi ,    psi_s = alpha lambda - beta psi .

use crate::governors::{growth, has_positive_minors};
use crate::model_reduction::models::Reductions;
use crate::model_reduction::reduced_model::Fill;
use crate::model_reduction::{Loss, Lower, ReducedModel};
use field::{Analytic, Over};
use simulation::Axes;
use simulation::knowledge::{Knowledge, submit};
use simulation::models::Modelled;
use std::convert::Infallible;
use systems::elastic_governor::ElasticGovernor;

const NAME: &str = "elastic_governor";

/// The coordinates, then the speeds, as named in the scenes.
const STATE: [&str; 12] =
    ["phi1", "phi2", "phi", "x", "lambda", "psi", "phi1'", "phi2'", "phi'", "x'", "lambda'", "psi'"];

submit! { Knowledge {
    name: NAME,
    summary: "a governor with centrifugal balls and a wheel with an elastic rim, after Keldysh",
    parameters: &[
        "drum_inertia", "disc_inertia", "wheel_inertia", "drum", "wheel", "offset", "sleeve", "ball", "link", "m1", "m2", "c1", "c2",
        "delta1", "delta2", "rest", "across", "twist", "drill", "alpha", "beta",
    ],
    columns: &STATE,
    equations: &[include_str!("../../../../scenes/governors/elastic_stable.toml")],
    theory: |scene, _| theory(&data(scene)),
    ..Knowledge::EMPTY
} }

submit! { Reductions { name: NAME, models } }

/// The data by name; the rim of the text model has no mass.
fn data(scene: &dyn Modelled) -> ElasticGovernor<f64> {
    let Ok(data) = ElasticGovernor::read(|quantity| Ok::<_, Infallible>(scene.value(&quantity.name).unwrap_or(0.0)));
    data
}

/// The largest imbalance, relative to the terms, for which the data count as having a steady motion.
const BALANCED: f64 = 1e-9;

/// The speed omega1 of the steady motion at x = x0, if it exists, rad/s.
fn stationary(data: &ElasticGovernor<f64>) -> Option<f64> {
    let pull = data.c2 * data.delta2 - data.c1 * data.delta1;
    let speed = (pull / (0.5 * data.ball * data.rest)).sqrt();
    let balanced = data.stationary_at(speed);
    let close = |a: f64, b: f64| (a - b).abs() <= BALANCED * a.abs().max(b.abs());
    (speed > 0.0 && close(balanced.m1, data.m1)).then_some(speed)
}

fn theory(data: &ElasticGovernor<f64>) -> Vec<String> {
    let Some(speed) = stationary(data) else {
        return vec!["the moments or the springs do not balance at x0: there is no stationary motion".to_owned()];
    };
    let verdict = match has_positive_minors(data, speed) {
        true => "stable, by Hurwitz' minors, which are all positive",
        false => "unstable, by Hurwitz' minors, which are not all positive",
    };
    let growth = growth(data, speed).filter(|rate| rate.is_finite()).map_or_else(String::new, |rate| {
        format!("; a disturbance changes by e^({rate:.3e} t) in the long run, by the eigenvalues")
    });
    vec![format!("the stationary motion at omega1 = {speed:.9} rad/s, x = {} m is {verdict}{growth}", data.rest)]
}

/// Reduced models of the elastic rim.
fn models(scene: &dyn Modelled) -> Vec<ReducedModel> {
    let (written, data, start) = (scene.symbolic_law(), data(scene), scene.problem(Axes::First).state);
    let reduced = |name, dropped: &str, parameter, rim: Rim, kept: Vec<usize>| {
        let z0 = kept.iter().map(|&place| start[place]).collect();
        let whole = Whole { rim, data };
        ReducedModel::new(name, dropped, Loss::Small { parameter }, Lower::keeping(&written, kept, whole), z0)
    };
    let sleeve = || vec![0, 1, 2, 3, 6, 9];
    let quasi_steady = (data.alpha != 0.0).then(|| {
        reduced(
            "rim relaxed",
            "the rim's relaxation: psi = x'/(R omega1), lambda = beta psi/alpha",
            "rate of the sleeve over that of the rim, R omega1 beta/2",
            Rim::Relaxed,
            sleeve(),
        )
    });
    let sliding = reduced(
        "rigid wheel that slides",
        "the rim: the wheel slides across without resistance",
        "force of the rim over that of the springs",
        Rim::Absent,
        sleeve(),
    );
    let rolling = reduced(
        "rigid rim",
        "the rim and with it the sleeve's motion: a rigid wheel rolls on in its own plane",
        "way of the sleeve over its place",
        Rim::Rigid { place: start[3] },
        vec![0, 1, 2, 6],
    );
    quasi_steady.flatten().into_iter().chain(sliding).chain(rolling).collect()
}

/// A rim without states.
#[derive(Clone, Copy)]
enum Rim {
    Relaxed,
    Absent,
    Rigid { place: f64 },
}

/// The map from a reduced model's state to the whole state.
struct Whole {
    rim: Rim,
    data: ElasticGovernor<f64>,
}

impl Fill for Whole {
    fn fill<S: Over<f64> + Analytic>(&self, y: &mut [S]) {
        let (zero, data) = (S::zero(), self.data.map(S::lift));
        if let Rim::Rigid { place } = self.rim {
            (y[3], y[9]) = (S::lift(place), zero);
        }
        let rolled = data.drum * y[6];
        (y[4], y[5]) = match self.rim {
            Rim::Relaxed => {
                let angle = y[9] / rolled;
                (data.beta / data.alpha * angle, angle)
            }
            Rim::Absent | Rim::Rigid { .. } => (zero, zero),
        };
        (y[7], y[8]) = (rolled / (y[3] - data.offset), rolled / data.wheel);
        (y[10], y[11]) = (y[9] - rolled * y[5], rolled * (data.alpha * y[4] - data.beta * y[5]));
    }
}
