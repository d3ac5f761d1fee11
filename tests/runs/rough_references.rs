//! Motions across events to 25 digits: kept for every scene that has one, their own, and beside what is known in closed form.

use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::studies::friction::closed::climbed;
use dalembert_derivations::studies::friction::exact::Regimes;
use dalembert_derivations::studies::friction::{Rough, RoughScene};
use dalembert_derivations::studies::regimes::critical;
use field::{Circle, DoubleDouble, Over, Scalar};
use integrators::{Attempt, End, Failure, Method, Record, Span, Tolerance};
use reader::Family;
use simulation::references::Unknown;
use simulation::work_precision::Treated;
use simulation::work_precision::judged_across_events;
use simulation::{Stored, Trials, references};
use std::path::{Path, PathBuf};
use std::time::Duration;

const DIGITS: f64 = 25.0;
const PATIENCE: Duration = Duration::from_secs(600);

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml")
}

fn open(name: &str) -> RoughScene {
    RoughScene::open(&path(name)).unwrap_or_else(|error| panic!("{error}"))
}

fn kept(name: &str) -> Stored {
    let text =
        std::fs::read_to_string(references::place(&path(name))).unwrap_or_else(|error| panic!("{name}: {error}"));
    Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"))
}

/// Every scene with rough contacts but one, in which nothing moves.
fn scenes() -> Vec<String> {
    let mut names = Vec::new();
    for folder in ["friction", "failures"] {
        let files = std::fs::read_dir(path(folder).with_extension("")).expect("the folder is there");
        for file in files.map(|file| file.expect("it can be listed").path()) {
            let is_scene = file.extension().is_some_and(|end| end == "toml");
            if is_scene && let Ok(AnyScene::Rough(_)) = AnyScene::open(&file) {
                let stem = file.file_stem().expect("it has a name").to_string_lossy();
                names.push(format!("{folder}/{stem}"));
            }
        }
    }
    names.sort();
    assert!(names.len() >= 7, "{names:?}");
    names.retain(|name| name != "friction/painleve");
    names
}

fn exactly(number: f64) -> DoubleDouble {
    DoubleDouble::lift(number)
}

/// Whether two numbers differ by less than what a reference claims.
fn close(name: &str, a: DoubleDouble, b: DoubleDouble, digits: f64) {
    let off = ((a - b).hi() / b.hi()).abs();
    assert!(off < 10f64.powf(-digits), "{name}: {a:?} and {b:?} are {off:.1e} apart");
}

#[test]
fn every_motion_with_rough_contacts_has_a_reference_of_25_digits_that_is_its_own() {
    for name in scenes() {
        let (scene, kept) = (open(&name), kept(&name));
        assert!(kept.reference.digits >= DIGITS, "{name}: {} digits", kept.reference.digits);
        assert!(kept.belongs_to(&Regimes::of(&scene)), "{name} has changed: `dalembert reference` makes it anew");
        let text = kept.write(&name);
        let again = Stored::read(&text).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        assert_eq!((&again.reference.states, &again.events), (&kept.reference.states, &kept.events), "{name}");
        assert_eq!(again.write(&name), text, "{name}");
    }
}

#[test]
fn what_has_no_motion_has_no_reference() {
    let unknown = open("friction/painleve").exact(PATIENCE).map(|exact| exact.reference.digits);
    assert!(matches!(unknown, Err(Unknown::Ends(why)) if why.contains("no regime is consistent")));
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
    for name in scenes() {
        let (scene, kept) = (open(&name), kept(&name));
        let course = scene.follow(&scene.plan, &mut |_| ());
        let mut times: Vec<f64> = course.log.iter().skip(1).map(|line| line.time).collect();
        if !course.reached {
            times.push(*course.times.last().expect("there are instants"));
        }
        assert_eq!(times.len(), kept.events.len(), "{name}");
        for (time, event) in times.iter().zip(&kept.events) {
            assert!((time - event.time.hi()).abs() < 1e-8 * time, "{name}: {time}, {}", event.time.hi());
        }
    }
}

/// m1 = 3 kg, m2 = 1 kg, f = 0.2, X = 1 N, 2 m/s: along the guide the rod weighs m1 - m2 on it.
#[test]
fn a_rod_that_is_retarded_evenly_stops_when_it_should() {
    let (kept, scene) = (kept("failures/stopping_rod"), open("failures/stopping_rod"));
    let Rough::SteeredRod(rod) = scene.system else { panic!("it is a steered rod") };
    let [guided, free, friction, drive] = [rod.guided, rod.free, rod.friction, rod.drive].map(exactly);
    // weights are data: products in `f64`
    let [pressing, lifting] = [rod.guided * rod.gravity, rod.free * rod.gravity].map(exactly);
    let retardation = (friction * (pressing - lifting) - drive) / (guided + free);
    close("the stop", kept.events[0].time, exactly(scene.slide) / retardation, kept.reference.digits);
}

/// When both reactions are on their cones, at the angle that the reference has.
#[test]
fn a_climbed_ladder_slips_when_statics_says() {
    let (kept, scene) = (kept("friction/climbed_ladder"), open("friction/climbed_ladder"));
    let Rough::ClimbedLadder(it) = scene.system else { panic!("it is a climbed ladder") };
    let slip = &kept.events[1];
    let point = Circle { cos: slip.state[2], sin: slip.state[3] };
    let data = [it.ladder.friction[0], it.weight, it.ladder.half_length, it.speed].map(exactly);
    let own = exactly(it.ladder.mass * it.ladder.gravity);
    let [friction, load, half_length, speed] = data;
    let time = climbed(friction, [own, load], half_length, speed, point);
    close("the slip", slip.time, time, kept.reference.digits - 1.0);
}

/// At the end the friction is the critical one.
#[test]
fn a_rod_jams_at_its_critical_angle() {
    let (kept, scene) = (kept("friction/jam"), open("friction/jam"));
    let Rough::SlenderRod(rod) = scene.system else { panic!("it is a slender rod") };
    let end = &kept.events[0];
    assert_eq!(end.state.len(), 4, "velocities have no bound");
    // the start is of unit length to the rounding of `f64`, and what it has is kept
    let length = (end.state[2].squared() + end.state[3].squared()).sqrt();
    let point = Circle { cos: end.state[2] / length, sin: end.state[3] / length };
    let kappa = exactly(rod.mass) * exactly(rod.half_length).squared() / exactly(rod.inertia);
    close("the friction", critical::rod(kappa, point), exactly(rod.friction), kept.reference.digits - 1.0);
}

/// On every scene the eighth-order pair comes to its tolerance's error, and a method that fails says why.
#[test]
fn every_method_is_measured_by_the_reference() {
    let methods = vec![Method::DormandPrince8, Method::GraggBulirschStoer, Method::Radau5];
    let trials = Trials { methods, tolerances: vec![1e-5, 1e-9], allowed: PATIENCE, ..Trials::default() };
    for name in scenes() {
        let atlas = judged_across_events(&open(&name), &trials, Some(&kept(&name)), PATIENCE)
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

/// Past its end a motion is not followed, and what there is of it is kept.
#[test]
fn a_run_across_events_ends_with_what_it_shows_last() {
    let (scene, kept) = (open("friction/climbed_ladder"), kept("friction/climbed_ladder"));
    let trials = Trials { methods: Vec::new(), ..Trials::default() };
    let atlas = judged_across_events(&scene, &trials, Some(&kept), PATIENCE).unwrap_or_else(|why| panic!("{why}"));
    let way = &atlas.explored[0].way;
    let Treated::Across(motion) = &way.law else { panic!("it has events") };
    let run = |span: f64| {
        let (span, mut seen) = (Span::new(0.0, span, &way.state).with_even_outputs(4), Record::new());
        let attempt = Attempt::Across(&**motion, Method::DormandPrince8);
        let outcome = attempt.run(&Tolerance::both(1e-10), &span, &mut seen);
        (outcome, seen)
    };
    let (outcome, seen) = run(5.2);
    assert_eq!(outcome.end, End::Reached);
    assert_eq!((Some(&outcome.time), Some(&outcome.state)), (seen.times.last(), seen.states.last()));
    let end = kept.events.last().expect("it touches down").time.hi();
    let (outcome, _) = run(scene.plan.end);
    assert!((outcome.time - end).abs() < 1e-6 * end);
    assert_eq!(outcome.end, End::Stopped(Failure::OtherCourse { at: outcome.time }));
}
