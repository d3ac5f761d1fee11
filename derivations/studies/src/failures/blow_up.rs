//! Governors that blow up in finite time.

use super::trials::Tried;
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::knowledge::governor_programme::governor;
use field::Rational;
use num_traits::Zero;
use simulation::Axes;
use simulation::models::open;
use std::path::Path;
use systems::governor::{Gearing, Governor, Torque};

pub const FAILING: Failing = Failing {
    name: "blow-up",
    title: "a governor that blows up in finite time",
    scene: "governors/blow_up.toml",
    why: r"To keep the speed of a braked shaft whose partner is free the wheel must move by $\rho\dot\rho=\varepsilon k_1$: $\rho^2$ decreases linearly, and at $t_*=-\rho_0^2/(2\varepsilon k_1)$ the wheel is at the axis with infinite speed. After that there is no motion; a constant step lands behind the axis, where the law has values without a meaning.",
    advice: "Evaluate the closed form before the run: it gives the instant at which the wheel comes to the axis, if it does; end the programme earlier, since no motion follows.",
    asked: "a stop at the blow-up, with this reason",
    measure,
};

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    let accepted = "known_as = \"governor_programme\" of a drum, with a moment on its second shaft alone";
    let unsuitable = |what: &str| NotFound::unsuitable(path, what, accepted);
    let Governor {
        inertia,
        mass,
        radius,
        gearing: Gearing::Drum { radius: drum },
        moments: [first, second],
        lateral,
        ..
    } = governor(&*scene).map_err(|datum| NotFound::without(path, datum, accepted))?
    else {
        return Err(unsuitable("its wheel rolls between two discs"));
    };
    if first.start != 0.0 {
        return Err(unsuitable("its end is no fraction of its data"));
    }
    let governor = Governor {
        inertia: inertia.map(Rational::decimal),
        mass: Rational::decimal(mass),
        radius: Rational::decimal(radius),
        gearing: Gearing::Drum { radius: Rational::decimal(drum) },
        moments: [first, second].map(|moment| Torque::constant(Rational::decimal(moment.start))),
        push: Rational::zero(),
        lateral: Rational::decimal(lateral),
    };
    let [rho, speed] = ["rho", "speed"].map(|name| Rational::decimal(scene.value(name).unwrap_or(0.0)));
    let law = governor.small_parameter(speed);
    let falls = law.map_or(Rational::UNDEFINED, |law| law.epsilon * law.of_second[0]);
    let (choice, problem) = (scene.run().choice(), scene.problem(Axes::First));
    let run = problem.simulate(&choice, |_| ());
    let end = Threshold {
        of: "instant after which there is no motion".into(),
        formula: r"$-\rho_0^2/(2\varepsilon k_1)$".into(),
        exact: Exact::Number(-rho * rho / (falls + falls)),
        unit: "s".into(),
        measured: run.stopped().map(|_| run.outcome.time),
        within: Within::Share(1_000_000),
    };
    let tried = Tried { steps: 1_000, ..Tried::of(&problem, 1e-9) };
    let diagnosis = scene.told(&choice, &run).diagnosis.unwrap_or_default();
    Ok(Found { thresholds: vec![end], diagnosis, trials: tried.all(|_| false) })
}
