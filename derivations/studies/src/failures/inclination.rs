//! The singularity of Mukharlyamov's control torques (19) at p g2 = q g1.

use super::trials::{Fate, Tried};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::knowledge::prescribed_top::{NAME, NODDING};
use field::{Rational, Scalar};
use nalgebra::Vector3;
use num_traits::Zero;
use simulation::Axes;
use simulation::models::open;
use std::path::Path;
use systems::variable_top::{Attitude, Top, prescribing};

pub const FAILING: Failing = Failing {
    name: "inclination",
    title: "the moments (19) where p g2 = q g1",
    scene: "failures/nodding_top.toml",
    why: r"Three moments control three integrals by equations with the determinant $p\gamma_2-q\gamma_1=-\dot\gamma_3$. Where the axis does not nod (at both ends of every nutation, and always on a permanent rotation) a moment across the plane of axis and vertical changes neither energy nor momentum, and wrong integrals cannot be corrected: $\frac{d}{dt}(p\gamma_2-q\gamma_1)^2$ stays away from zero, and the moments grow as $(t_*-t)^{-1/2}$.",
    advice: "Control the integrals only away from the ends of the nutation, or use the moments of the force function, which exist everywhere; judge p g2 = q g1 by exact arithmetic.",
    asked: "a stop where the axis does not nod, with this reason",
    measure,
};

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    if scene.known_as() != Some(NAME) {
        return Err(NotFound::unsuitable(path, "this is no prescribed top", "known_as = \"prescribed_top\""));
    }
    let (choice, problem) = (scene.run().choice(), scene.problem(Axes::First));
    let run = problem.simulate(&choice, |_| ());
    let nodding = run.column(NODDING).zip(run.rows.first());
    let left = nodding.filter(|_| run.stopped().is_some()).map(|(place, first)| run.last[place] / first[place]);
    let threshold = Threshold {
        of: "determinant at the end of the run, relative to its initial value".into(),
        formula: r"$p\gamma_2-q\gamma_1$".into(),
        exact: Exact::Number(Rational::zero()),
        unit: "".into(),
        measured: left,
        within: Within::Share(100),
    };
    let mut trials = Tried { steps: 1_000, ..Tried::of(&problem, 1e-9) }.all(|_| false);
    let seen = |fate: bool| if fate { Fate::Holds } else { Fate::Wrong };
    trials.push(Trial {
        by: "81 stationary inclinations refused, by decimals".into(),
        fate: seen(all_refused(Rational::decimal)),
    });
    trials.push(Trial { by: "81 stationary inclinations refused, in doubles".into(), fate: seen(all_refused(|x| x)) });
    let diagnosis = scene.told(&choice, &run).diagnosis.unwrap_or_default();
    Ok(Found { thresholds: vec![threshold], diagnosis, trials })
}

/// Whether every state (p, q) = (i, j)/10, (g1, g2) = 3 (i, j)/100 is rejected.
fn all_refused<S: Scalar>(number: impl Fn(f64) -> S) -> bool {
    let top = Top { equatorial: 2.0, axial: 1.0, static_moment: 1.0, gyroscope: 0.5, gravity: 9.81, tide: 0.0 };
    let top = top.map(&number).fixed();
    let pairs = (1..10).flat_map(|i| (1..10).map(move |j| (f64::from(i), f64::from(j))));
    pairs.into_iter().all(|(i, j)| {
        let spin = [i / 10.0, j / 10.0, 1.0].map(&number);
        let vertical = [3.0 * i / 100.0, 3.0 * j / 100.0, 0.5].map(&number);
        let at = Attitude { spin: Vector3::from(spin), vertical: Vector3::from(vertical) };
        prescribing(&top, &at, S::one(), [S::one(); 3]).is_err()
    })
}
