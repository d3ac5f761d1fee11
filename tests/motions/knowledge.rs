//! Scenes with known results (`known_as`): their ends, compared with closed forms and theory.

use dalembert_derivations::studies::governors::{self, SPEED, growth};
use integrators::{Failure, Method, Refusal};
use simulation::models::{self, Modelled};
use simulation::{Axes, Choice, RunNotes, Trajectory, methods};
use std::path::Path;
use std::sync::Arc;

pub fn open(name: &str) -> Arc<dyn Modelled> {
    scenes::register(|_| ());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    models::open(&path).unwrap_or_else(|error| panic!("{error}"))
}

pub fn by(scene: &dyn Modelled, choice: &Choice) -> (Trajectory, RunNotes) {
    let trajectory = scene.problem(Axes::First).simulate(choice, |_| ());
    let told = scene.told(choice, &trajectory);
    (trajectory, told)
}

/// The run of a scene with its own settings.
pub fn run(name: &str) -> (Trajectory, RunNotes) {
    let scene = open(name);
    by(&*scene, &scene.run().choice())
}

/// Each entry is (scene, beginning of its diagnosis if it ends early).
const SCENES: [(&str, Option<&str>); 5] = [
    ("governors/drum_programme", None),
    ("governors/blow_up", Some("blow-up in finite time: the wheel comes to the axis of the second disc")),
    ("governors/between_discs", None),
    ("governors/between_discs_blow_up", Some("blow-up in finite time: the wheel comes to the axis of the second disc")),
    ("failures/nodding_top", Some("p g2 = q g1")),
];

#[test]
fn every_scene_ends_as_it_should_and_is_diagnosed_by_name() {
    for (name, diagnosis) in SCENES {
        let (trajectory, told) = run(name);
        assert_eq!(trajectory.outcome.reached(), diagnosis.is_none(), "{name}: {:?}", trajectory.stopped());
        let found = told.diagnosis.as_deref();
        assert_eq!(found.is_some(), diagnosis.is_some(), "{name}: {found:?}");
        assert!(found.unwrap_or_default().starts_with(diagnosis.unwrap_or_default()), "{name}: {found:?}");
        assert!(trajectory.rows.iter().flatten().chain(&trajectory.last).all(|x| x.is_finite()), "{name}");
        assert!(trajectory.rows.iter().all(|row| row.len() == trajectory.names.len()), "{name}");
    }
}

#[test]
fn runs_agree_with_their_closed_forms() {
    for name in ["drum_programme", "blow_up", "between_discs", "between_discs_blow_up"] {
        let (_, told) = run(&format!("governors/{name}"));
        let (what, off) = told.closed_form.unwrap_or_else(|| panic!("{name} has a closed form"));
        assert!(off < 1e-10, "{name}: {what}: {off:.1e}");
    }
}

/// The constraint on the wheel's position contains the balance of torques; the speed follows from the equations of
/// motion only.
#[test]
fn the_second_shaft_keeps_its_speed() {
    for name in ["drum_programme", "between_discs"] {
        let (trajectory, _) = run(&format!("governors/{name}"));
        let place = trajectory.column("phi2'").expect("a speed");
        let off = trajectory.rows.iter().map(|row| (row[place] - 2.0).abs()).fold(0.0, f64::max);
        assert!(off < 1e-11, "{name}: {off:e}");
    }
}

/// No contact slips: R omega1 = rho omega2 for a drum, rho omega1 = (a - rho) omega2 between two discs.
#[test]
fn the_other_shaft_is_as_fast_as_the_wheel_rolls() {
    type Ratio = fn(f64) -> f64;
    let levers: [(&str, Ratio); 2] = [("drum_programme", |rho| rho / 0.5), ("between_discs", |rho| (0.8 - rho) / rho)];
    for (name, ratio) in levers {
        let (trajectory, _) = run(&format!("governors/{name}"));
        let [rho, first] = ["rho", "omega1"].map(|name| trajectory.last[trajectory.column(name).expect("it is shown")]);
        assert!((first - 2.0 * ratio(rho)).abs() < 1e-12, "{name}: {first}");
    }
}

#[test]
fn a_blow_up_is_where_the_closed_form_says() {
    for (name, time) in [("blow_up", 1.1025), ("between_discs_blow_up", 7.265608828656)] {
        let (trajectory, told) = run(&format!("governors/{name}"));
        assert!((trajectory.outcome.time - time).abs() < 1e-9, "{name}: {}", trajectory.outcome.time);
        let diagnosis = told.diagnosis.expect("it is named");
        assert!(diagnosis.contains(&format!("by the closed form at t = {time}")), "{diagnosis}");
    }
}

/// A long step would end on the other side of the axis, where the law is defined again.
#[test]
fn no_method_steps_over_the_axis() {
    let scene = open("governors/blow_up");
    for (written, _) in methods::list() {
        let method = methods::method(&written.replace("STEPS", "70")).expect("it is in the list");
        let choice = Choice { method, ..scene.run().choice() };
        let (trajectory, told) = by(&*scene, &choice);
        if let Some(Failure::Refused(refusal)) = trajectory.outcome.failure() {
            assert_eq!(refusal, Refusal::NoPieces, "{method}");
            continue;
        }
        let rho = trajectory.column("rho").expect("a state");
        assert!(!trajectory.outcome.reached() && trajectory.last[rho] > 0.0, "{method}: {:?}", trajectory.last);
        let diagnosis = told.diagnosis.unwrap_or_default();
        assert!(diagnosis.starts_with("blow-up"), "{method}: {:?}, {diagnosis}", trajectory.stopped());
        assert!(told.theory[0].contains("t = 1.1025"), "{:?}", told.theory);
        assert!(trajectory.rows.iter().all(|row| row[rho] > 0.0), "{method}");
    }
}

/// The rate of growth or decay over forty seconds of the motion, compared with linear theory.
#[test]
fn the_elastic_governor_leaves_or_regains_its_stationary_motion_as_fast_as_theory_says() {
    for (name, load) in [("elastic_stable", 20.0), ("elastic_unstable", 23.0)] {
        let scene = open(&format!("governors/{name}"));
        let (trajectory, told) = by(&*scene, &scene.run().choice());
        let of_the_maps = governors::governor(50.0, load);
        for (name, value) in [("m1", of_the_maps.m1), ("delta2", of_the_maps.delta2), ("beta", of_the_maps.beta)] {
            let given = scene.value(name).expect("it is a parameter");
            assert!((given - value).abs() < 1e-14, "{name}: {given} and {value}");
        }
        let column = trajectory.column("x").expect("a state");
        let largest = |from: f64, to: f64| {
            let rows = trajectory.times.iter().zip(&trajectory.rows);
            let inside = rows.filter(|(time, _)| (from..to).contains(*time));
            inside.map(|(_, row)| (row[column] - of_the_maps.rest).abs()).fold(0.0, f64::max)
        };
        let rate = (largest(80.0, 100.0) / largest(40.0, 60.0)).ln() / 40.0;
        let foretold = growth(&of_the_maps, SPEED).expect("eigenvalues");
        assert_eq!(foretold > 0.0, name.contains("unstable"));
        assert!((rate - foretold).abs() < 0.1 * foretold.abs(), "{name}: {rate} and {foretold}");
        let word = if foretold > 0.0 { "is unstable" } else { "is stable" };
        assert!(told.theory.iter().any(|said| said.contains(word)), "{:?}", told.theory);
    }
}

/// Both laws depend on time: by torques that grow, and by an alternating voltage.
#[test]
fn taylors_method_follows_laws_with_the_time_in_them() {
    for name in ["governors/released", "drive/euler_bears"] {
        let scene = open(name);
        let end = |method| {
            let (trajectory, _) = by(&*scene, &Choice { method, tolerance: 1e-10, ..scene.run().choice() });
            assert!(trajectory.outcome.reached(), "{name}: {:?}", trajectory.stopped());
            trajectory.outcome.state
        };
        let (series, stages) = (end(Method::Taylor), end(Method::DormandPrince8));
        for (a, b) in series.iter().zip(&stages) {
            assert!((a - b).abs() < 1e-6 * a.abs().max(1.0), "{name}: {a} and {b}");
        }
    }
}

/// Closed forms and theory hold for these equations only: a file with other equations is rejected under a known name.
#[test]
fn a_file_with_other_equations_is_refused_under_a_known_name() {
    scenes::register(|_| ());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    for (name, from, to) in [
        ("governors/drum_programme", "zero = \"rho' - power/(gain*speed)\"", "zero = \"rho' - 2*power/(gain*speed)\""),
        ("governors/between_discs", "(J1*phi1'^2", "(2*J1*phi1'^2"),
        ("governors/elastic_stable", "alpha*lambda - beta*psi", "alpha*lambda + beta*psi"),
        ("failures/nodding_top", "nodding = \"p*g2 - q*g1\"", "nodding = \"p - q\""),
        ("drive/stiff_diode", "motor*q6*q5'", "-motor*q6*q5'"),
    ] {
        let text = std::fs::read_to_string(folder.join(name).with_extension("toml")).expect("it is there");
        assert!(text.contains(from), "{name}");
        let readers = models::readers().expect("they were registered");
        assert!((readers.scene)(name, &text).is_ok(), "{name}");
        let error = (readers.scene)(name, &text.replace(from, to)).expect_err(name);
        assert!(error.to_string().contains("the equations are not those of"), "{error}");
    }
}
