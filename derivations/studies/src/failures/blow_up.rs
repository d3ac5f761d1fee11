//! Governors that blow up in finite time.

use super::trials::Tried;
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::mechanisms::governors::{Drum, Programme};
use crate::mechanisms::{Mechanism, MechanismScene};
use field::Rational;
use num_traits::Zero;
use reader::Family;
use simulation::Smooth;
use std::path::Path;
use systems::governor::{Gearing, Governor, Moment};

pub const FAILING: Failing = Failing {
    name: "blow-up",
    title: "a governor that blows up in finite time",
    scene: "governors/blow_up.toml",
    why: r"To keep the speed of a braked shaft whose partner is free the wheel must move by $\rho\dot\rho=\varepsilon k_1$: $\rho^2$ falls evenly, and at $t_*=-\rho_0^2/(2\varepsilon k_1)$ the wheel is at the axis with infinite speed. After that there is no motion; a constant step lands behind the axis, where the law has values and means nothing.",
    advice: "Look at the closed form before the run: it says whether and when the wheel comes to the axis; end the programme before, no method goes on.",
    asked: "to stop at the blow-up and to say so",
    measure,
};

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = MechanismScene::open(path)?;
    let datum = |name: &str| {
        let found = scene.data.iter().find(|(quantity, _)| quantity.name == name);
        found.map_or(Rational::zero(), |(_, value)| Rational::decimal(*value))
    };
    let loaded = ["m1", "m1_growth", "m2_growth"].into_iter().any(|name| !datum(name).is_zero());
    if scene.name != <Programme<Drum> as Mechanism>::NAME || loaded {
        let accepted = "system = \"drum_programme\" with a constant moment on its second shaft alone";
        return Err(NotFound::unsuitable(path, "its end is no fraction of its data", accepted));
    }
    let governor = Governor {
        inertia: ["j1", "j2", "j"].map(datum),
        mass: datum("mass"),
        radius: datum("wheel"),
        gearing: Gearing::Drum { radius: datum("drum") },
        moments: ["m1", "m2"].map(|name| Moment::constant(datum(name))),
        push: Rational::zero(),
        lateral: datum("lateral"),
    };
    let rho = Rational::decimal(scene.start.first().copied().unwrap_or(0.0));
    let law = governor.small_parameter(datum("speed"));
    let falls = law.map_or(Rational::UNDEFINED, |law| law.epsilon * law.of_second[0]);
    let choice = scene.run.choice();
    let run = scene.simulate(&choice, |_| ());
    let end = Threshold {
        of: "instant after which there is no motion",
        formula: r"$-\rho_0^2/(2\varepsilon k_1)$",
        exact: Exact::Number(-rho * rho / (falls + falls)),
        unit: "s",
        measured: run.stopped().map(|_| run.outcome.time),
        within: Within::Share(1_000_000),
    };
    let problem = scene.problem();
    let tried = Tried { steps: 1_000, ..Tried::of(&problem, 1e-9) };
    let diagnosis = scene.told(&choice, &run).diagnosis.unwrap_or_default();
    Ok(Found { thresholds: vec![end], diagnosis, trials: tried.all(|_| false) })
}
