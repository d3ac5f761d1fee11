//! The work of loads along a run, compared with closed forms and with the energies of stored scenes.

use super::{going_on, open};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Axes, Choice, IvpScene, Trajectory};

const METHODS: [Method; 3] = [Method::DormandPrince8, Method::Taylor, Method::RadauIIA { stages: 5 }];

fn metered(scene: &ModelScene, method: Method) -> Trajectory {
    let choice = Choice { method, tolerance: 1e-11, samples: 4, ..scene.run.choice() };
    scene.metered(Axes::First).simulate(&choice, |_| ())
}

fn last(run: &Trajectory, name: &str) -> f64 {
    run.last[run.column(name).unwrap_or_else(|| panic!("{name} is shown"))]
}

fn particle(keys: &str, start: &str) -> ModelScene {
    let text = format!(
        "title = \"A particle\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
         [bodies.b]\ncentre = \"P\"\nmass = \"(2 kg)\"\n{keys}\n[start]\n{start}\n[run]\nspan = \"3 s\"\n"
    );
    ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// A constant force does the work F x; a damper dissipates the kinetic energy.
#[test]
fn the_work_of_a_force_and_of_a_damper_is_that_of_their_closed_forms() {
    let pushed = particle("[[force]]\non = \"b\"\nis = \"(3 N)*N.x\"", "\"y'\" = \"1 m/s\"");
    let damped = particle("[energies]\ndissipation = \"(1 N s/m)/2*(x'^2 + y'^2)\"", "\"x'\" = \"2 m/s\"");
    for method in METHODS {
        let run = metered(&pushed, method);
        assert!((last(&run, "work") - 3.0 * last(&run, "x")).abs() < 1e-9, "{method}");
        assert!((last(&run, "work") - 20.25).abs() < 1e-9, "{method}");
        let run = metered(&damped, method);
        assert!((last(&run, "work") - 4.0 * ((-3.0_f64).exp() - 1.0)).abs() < 1e-9, "{method}");
    }
}

/// A rod that turns at a given rate w accelerates a bead outwards: r = r0 cosh(w t). The energy of the bead with the velocity (r', w r) grows by
/// the work of the rod's reaction, m w^2 (r^2 - r0^2).
#[test]
fn a_constraint_that_knows_the_time_does_work() {
    let keys = "[[constraint]]\nzero = \"y*cos((0.7 rad/s)*t) - x*sin((0.7 rad/s)*t)\"";
    let bead = particle(keys, "x = \"0.5 m\"\n\"x'\" = \"0 m/s\"");
    let (w, r0) = (0.7, 0.5);
    let grown = 2.0 * w * w * r0 * r0 * (3.0_f64 * w).sinh().powi(2);
    for method in METHODS {
        let run = metered(&bead, method);
        assert!((last(&run, "work") - grown).abs() < 1e-8 * grown, "{method}: {} {grown}", last(&run, "work"));
    }
}

#[test]
fn the_energy_of_every_system_that_is_shown_is_the_work_on_it() {
    let mut count = 0;
    for path in going_on() {
        let scene = open(&path);
        let problem = scene.metered(Axes::First);
        if !problem.columns.iter().any(|name| name == "work") {
            continue;
        }
        count += 1;
        assert_eq!(problem.state.len(), scene.start.len() + 1);
        let run = metered(&scene, Method::Taylor);
        let [deviation] = &run.outcome.deviations[..] else { panic!("{}: one balance", path.display()) };
        let size = run.rows.iter().flatten().fold(1.0, |size: f64, part| size.max(part.abs()));
        assert!(run.outcome.reached() && deviation.largest < 1e-7 * size, "{}: {deviation:?}", path.display());
    }
    assert!(count >= 8, "{count}");
}
