//! Stored references of motions across sticking, sliding and separation with 25 digits, compared with closed forms and with their scenes.

use super::closed_forms::climbed;
use super::stored;
use dalembert_scenes::ModelScene;
use field::{Analytic, DoubleDouble, Over};
use integrators::{Attempt, End, Failure, Method, Record, Span, Tolerance};
use simulation::references::Unknown;
use simulation::work_precision::{Hybrid, Treated, judged_across_events};
use simulation::{Choice, IvpScene, Stored, Trials, references};
use std::path::Path;
use std::time::Duration;
use studies::regimes::critical;

const DIGITS: f64 = 25.0;
const PATIENCE: Duration = Duration::from_secs(600);

/// All scenes with contacts in the folders `friction` and `failures`, except for one without motion.
const SCENES: [&str; 6] = [
    "friction/climbed_ladder",
    "friction/jam",
    "friction/pushed_ladder",
    "friction/steered_rod",
    "failures/stopping_rod",
    "failures/straightening_rod",
];

fn open(name: &str) -> ModelScene {
    ModelScene::parse(name, &stored(name)).unwrap_or_else(|error| panic!("{error}"))
}

fn kept(name: &str) -> Stored {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name).with_extension("toml");
    let text = std::fs::read_to_string(references::place(&path)).unwrap_or_else(|error| panic!("{name}: {error}"));
    Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"))
}

/// The value of a parameter, or of a component of the start.
fn value(scene: &ModelScene, name: &str) -> f64 {
    use simulation::models::Modelled;
    scene.value(name).unwrap_or_else(|| panic!("{name}"))
}

fn exactly(scene: &ModelScene, name: &str) -> DoubleDouble {
    DoubleDouble::lift(value(scene, name))
}

/// Requires that two numbers agree to the digits that a reference claims.
fn close(name: &str, a: DoubleDouble, b: DoubleDouble, digits: f64) {
    let off = ((a - b).hi() / b.hi()).abs();
    assert!(off < 10f64.powf(-digits), "{name}: {a:?} and {b:?} are {off:.1e} apart");
}

#[test]
fn every_motion_has_a_reference_of_25_digits_that_is_its_own() {
    for name in SCENES {
        let (scene, kept) = (open(name), kept(name));
        assert!(kept.reference.digits >= DIGITS, "{name}: {} digits", kept.reference.digits);
        assert!(kept.belongs_to(&*scene.owner()), "{name} has changed: `dalembert reference` makes it anew");
        let text = kept.write(name);
        let again = Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        assert_eq!((&again.reference.states, &again.events), (&kept.reference.states, &kept.events), "{name}");
        assert_eq!(again.write(name), text, "{name}");
    }
}

#[test]
fn a_start_without_a_motion_has_no_reference() {
    let unknown = open("friction/painleve").exact(PATIENCE).map(|exact| exact.reference.digits);
    assert!(
        matches!(unknown, Err(Unknown::Ends(why)) if why.contains("no combination of cases of conditions and contacts is consistent"))
    );
}

#[test]
fn a_reference_made_again_is_the_one_that_is_kept() {
    for name in ["friction/pushed_ladder", "friction/climbed_ladder", "failures/stopping_rod", "friction/jam"] {
        let (again, kept) = (open(name).exact(PATIENCE).unwrap_or_else(|why| panic!("{name}: {why}")), kept(name));
        let claimed = 10f64.powf(-kept.reference.digits) + 10f64.powf(-again.reference.digits);
        assert!((again.reference.digits - kept.reference.digits).abs() < 1.0, "{name}: {}", again.reference.digits);
        assert_eq!(again.events.len(), kept.events.len(), "{name}");
        for (a, b) in again.events.iter().zip(&kept.events) {
            close(name, a.time, b.time, -claimed.log10());
            assert_eq!((&a.what, &a.regime), (&b.what, &b.regime), "{name}");
        }
        let rows = again.reference.states.iter().zip(&kept.reference.states);
        for ((a, b), size) in rows.flat_map(|(a, b)| a.iter().zip(b)).zip(kept.reference.sizes.iter().cycle()) {
            assert!((*a - *b).hi().abs() <= claimed * size, "{name}");
        }
    }
}

#[test]
fn runs_in_f64_have_the_events_of_the_reference() {
    for name in SCENES {
        let (scene, kept) = (open(name), kept(name));
        let choice = scene.run().choice();
        let trajectory = scene.problem(choice.axes).simulate(&choice, |_| ());
        let times: Vec<f64> = trajectory.passages.iter().skip(1).map(|passage| passage.time).collect();
        assert_eq!(times.len(), kept.events.len(), "{name}: {:?}", trajectory.passages);
        for (time, event) in times.iter().zip(&kept.events) {
            assert!((time - event.time.hi()).abs() < 1e-8 * time, "{name}: {time}, {}", event.time.hi());
        }
    }
}

/// m1 = 3 kg, m2 = 1 kg, f = 0.2, X = 1 N, 2 m/s: the rod presses on the guide with the weight of m1 - m2.
#[test]
fn a_rod_that_is_retarded_evenly_stops_when_it_should() {
    let (kept, scene) = (kept("failures/stopping_rod"), open("failures/stopping_rod"));
    let [guided, free, friction, drive, gravity, speed] =
        ["m1", "m2", "f", "X", "g", "x'"].map(|name| exactly(&scene, name));
    let retardation = (friction * gravity * (guided - free) - drive) / (guided + free);
    close("the stop", kept.events[0].time, speed / retardation, kept.reference.digits);
}

/// The time at which both reactions are at their friction limits, at the angle of the reference.
#[test]
fn a_climbed_ladder_slips_when_statics_says() {
    let (kept, scene) = (kept("friction/climbed_ladder"), open("friction/climbed_ladder"));
    let slip = &kept.events[1];
    let [mass, gravity, friction, load, half_length, speed] =
        ["m", "g", "f_wall", "P", "l", "v"].map(|name| exactly(&scene, name));
    let time = climbed(friction, [mass * gravity, load], half_length, speed, slip.state[2].circle());
    close("the slip", slip.time, time, kept.reference.digits - 1.0);
}

/// At the end of the motion, the coefficient of friction has its critical value.
#[test]
fn a_rod_jams_at_its_critical_angle() {
    let (kept, scene) = (kept("friction/jam"), open("friction/jam"));
    let end = &kept.events[0];
    assert_eq!(end.state.len(), 3, "speeds have no bound");
    let [kappa, friction] = ["kappa", "f"].map(|name| exactly(&scene, name));
    close("the friction", critical::rod(kappa, end.state[2].circle()), friction, kept.reference.digits - 1.0);
}

/// On every scene, the method of order eight has an error near its tolerance, and a method that fails gives the reason.
#[test]
fn every_method_is_measured_by_the_reference() {
    let methods = vec![Method::DormandPrince8, Method::GraggBulirschStoer, Method::Radau5, Method::Taylor];
    let trials = Trials { methods, tolerances: vec![1e-5, 1e-9], allowed: PATIENCE, ..Trials::default() };
    for name in SCENES {
        let atlas = judged_across_events(&open(name), &trials, Some(&kept(name)), PATIENCE)
            .unwrap_or_else(|why| panic!("{name}: {why}"));
        for (_, point) in atlas.points() {
            let tolerance = point.tolerance.expect("all follow one");
            match point.error {
                Ok(error) => {
                    assert!(error < 1e4 * tolerance, "{name}, {}: {error:.1e} at {tolerance:.0e}", point.means)
                }
                Err(failure) => assert!(!matches!(failure, Failure::OutOfTime { .. }), "{name}: {failure}"),
            }
        }
        let fine = atlas.points().find(|(_, point)| point.tolerance == Some(1e-9)).expect("it was tried");
        assert!(fine.1.error.is_ok_and(|error| error < 1e-6), "{name}: {:?}", fine.1.error);
    }
}

/// A motion is not continued behind its end; its samples up to there are recorded.
#[test]
fn a_run_across_events_ends_with_what_it_shows_last() {
    let (scene, kept) = (open("friction/climbed_ladder"), kept("friction/climbed_ladder"));
    let trials = Trials { methods: Vec::new(), ..Trials::default() };
    let atlas = judged_across_events(&scene, &trials, Some(&kept), PATIENCE).unwrap_or_else(|why| panic!("{why}"));
    let way = &atlas.explored[0].way;
    let Treated::Hybrid(motion) = &way.law else { panic!("it has events") };
    let run = |span: f64| {
        let (span, mut seen) = (Span::new(0.0, span, &way.state).with_even_outputs(4), Record::new());
        let attempt = Attempt::Hybrid(&**motion, Method::DormandPrince8);
        let outcome = attempt.run(&Tolerance::both(1e-10), &span, &mut seen);
        (outcome, seen)
    };
    let (outcome, seen) = run(5.2);
    assert_eq!(outcome.end, End::Reached);
    assert_eq!((Some(&outcome.time), Some(&outcome.state)), (seen.times.last(), seen.states.last()));
    let end = kept.events.last().expect("its top meets the floor").time.hi();
    let (outcome, _) = run(scene.run().span);
    assert!((outcome.time - end).abs() < 1e-6 * end);
    assert_eq!(outcome.end, End::Stopped(Failure::OtherCourse { at: outcome.time }));
}

/// Where reactions become unbounded, rounding errors determine which condition fails first; all methods must name one reason.
#[test]
fn a_rod_that_jams_does_so_by_every_method() {
    let (scene, known) = (open("friction/jam"), kept("friction/jam").events[0].time.hi());
    for method in [
        Method::DormandPrince5,
        Method::DormandPrince8,
        Method::Verner6,
        Method::Verner9,
        Method::GraggBulirschStoer,
        Method::Radau5,
        Method::Taylor,
    ] {
        let choice = Choice { method, tolerance: 1e-6, ..scene.run().choice() };
        let trajectory = scene.problem(choice.axes).simulate(&choice, |_| ());
        let left = trajectory.left.unwrap_or_else(|| panic!("{method}: {:?}", trajectory.outcome.end));
        assert!(left.contains("become singular"), "{method}: {left}");
        let end = trajectory.passages.last().expect("it is told");
        assert_eq!((end.then.as_ref(), end.what.contains("become singular")), (None, true), "{method}");
        assert!((end.time - known).abs() < 1e-6 * known, "{method}: {}", end.time);
    }
}
