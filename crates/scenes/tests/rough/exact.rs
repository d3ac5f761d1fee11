//! References across events: their digits, comparison with closed forms, and with every method.

use super::{close, stored};
use dalembert_scenes::ModelScene;
use field::DoubleDouble;
use integrators::{Failure, Method, Record, Span, Tolerance};
use simulation::references::{Exact, Unknown};
use simulation::work_precision::{Hybrid, judged_across_events};
use simulation::{Axes, Choice, IvpScene, Stored, Trials};
use std::time::Duration;

const PATIENCE: Duration = Duration::from_secs(60);

fn scene_of(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn exact(text: &str) -> Exact {
    let scene = scene_of(text);
    scene.exact(PATIENCE).unwrap_or_else(|unknown| panic!("{unknown}"))
}

fn near(found: DoubleDouble, known: DoubleDouble) {
    assert!((found - known).hi().abs() < 1e-25, "{found:?} and {known:?}");
}

fn ball(e: &str, more: &str) -> String {
    format!(
        "title = \"ball\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\ng = \"8 m/s^2\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.ball]\ncentre = \"P\"\nmass = \"m\"\n\
         [[contact]]\nname = \"floor\"\nof = \"ball\"\nthrough = \"O\"\nnormal = \"N.y\"\nrestitution = \"{e}\"\n{more}\
         [start]\ny = \"1 m\"\n\"x'\" = \"3 m/s\"\n[run]\nspan = \"1.3 s\"\n"
    )
}

/// The ball hits the floor after 1/2 s at 4 m/s. The normal impulses per mass are 6, 3 and 3/2 m/s; friction reduces the speed by a quarter of each.
#[test]
fn impacts_are_known_to_all_digits() {
    for law in ["newton", "poisson"] {
        let found = exact(&ball("0.5", &format!("friction = \"0.25\"\nimpact = \"{law}\"\n")));
        assert!(found.reference.digits > 25.0, "{}", found.reference.digits);
        assert_eq!(found.events.len(), 3);
        for (event, (time, speeds)) in
            found.events.iter().zip([(0.5, [1.5, 2.0]), (1.0, [0.75, 1.0]), (1.25, [0.375, 0.5])])
        {
            near(event.time, DoubleDouble::from(time));
            (0..2).for_each(|k| near(event.state[2 + k], DoubleDouble::from(speeds[k])));
        }
    }
}

/// i = max(0, sin t): the charge is 2 C at t = pi; then the diode blocks the voltage of the source.
#[test]
fn a_current_without_inertia_is_known_to_all_digits() {
    let text = "title = \"rectifier\"\n[coordinates]\nq = \"C\"\n[energies]\ndissipation = \"(1 ohm)/2*q'^2\"\n[[force]]\nalong = \"q\"\n\
                is = \"(1 V)*sin((1 rad/s)*t)\"\n[[diode]]\nname = \"D\"\ncurrent = \"q'\"\n[run]\nspan = \"6 s\"\n";
    let found = exact(text);
    assert!(found.reference.digits > 25.0, "{}", found.reference.digits);
    assert_eq!(found.events.len(), 1);
    let half_turn =
        model::HALF_TURN.into_iter().fold(DoubleDouble::from(0.0), |sum, part| sum + DoubleDouble::from(part));
    near(found.events[0].time, half_turn);
    near(found.events[0].state[0], DoubleDouble::from(2.0));
    near(found.events[0].state[1], DoubleDouble::from(0.0));
}

#[test]
fn an_event_sets_the_state_to_all_digits() {
    let text = ball("0", "")
        .replace("1.3 s", "0.9 s")
        .replace("[start]", "[[event]]\nwhen = \"x - (0.6 m)\"\nset = { \"x'\" = \"x'/3\", \"y'\" = \"0\" }\n[start]");
    let found = exact(&text);
    near(found.events[0].time, DoubleDouble::from(1.0) / DoubleDouble::from(5.0));
    near(found.events[0].state[2], DoubleDouble::from(1.0));
    // 1 - 4/25 m remain, and the fall starts again from rest
    let landed = found.events[1].time - found.events[0].time;
    near(landed * landed, DoubleDouble::from(21.0) / DoubleDouble::from(100.0));
}

/// The ladder and the slider-crank, whose event times runs give to 11 digits.
#[test]
fn references_across_events_agree_with_runs_and_belong_to_their_scenes() {
    for (name, [datum, other]) in [
        ("leaning_ladder", ["f = \"0.3\"", "f = \"0.31\""]),
        ("rough_slider_crank", ["mu = \"0.2\"", "mu = \"0.21\""]),
        ("dry_friction", ["k = \"1 N/m\"", "k = \"1.1 N/m\""]),
        ("bouncing_ball", ["9.81", "9.8"]),
    ] {
        let scene = scene_of(&stored(&format!("models/{name}")));
        let found = scene.exact(PATIENCE).unwrap_or_else(|unknown| panic!("{name}: {unknown}"));
        assert!(found.reference.digits > 24.0, "{name}: {}", found.reference.digits);
        let run = Choice { tolerance: 1e-13, ..scene.run().choice() };
        let trajectory = scene.problem(run.axes).simulate(&run, |_| {});
        let events: Vec<f64> = trajectory.passages.iter().skip(1).map(|passage| passage.time).collect();
        assert_eq!(events.len(), found.events.len(), "{name}");
        events.iter().zip(&found.events).for_each(|(run, exact)| close(*run, exact.time.hi(), 1e-8));
        let kept = Stored::of(&*scene.owner(), found.reference, found.events);
        let read = Stored::read(&kept.write("scene.toml")).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        assert!(read.belongs_to(&*scene.owner()), "{name}");
        let other = scene_of(&stored(&format!("models/{name}")).replacen(datum, other, 1));
        assert!(!read.belongs_to(&*other.owner()), "{name}");
    }
}

#[test]
fn every_method_is_measured_across_events() {
    let scene = scene_of(&ball("0.5", "friction = \"0.25\"\n"));
    let trials = Trials::default();
    let atlas = judged_across_events(&scene, &trials, None, PATIENCE).unwrap_or_else(|unknown| panic!("{unknown}"));
    let points: Vec<_> = atlas.points().collect();
    assert!(points.len() > 40);
    for (_, point) in points {
        match &point.error {
            Ok(error) => assert!(*error < 1e-11, "{}: {error:e}", point.means),
            Err(failure) => {
                assert!(matches!(failure, Failure::TooManyEvaluations { .. }), "{}: {failure}", point.means)
            }
        }
    }
}

#[test]
fn bounces_without_end_have_no_reference() {
    let unknown = scene_of(&ball("0.2", "")).exact(PATIENCE).expect_err("infinitely many events");
    assert!(matches!(unknown, Unknown::LastBounce { .. }), "{unknown}");
    assert!(unknown.to_string().contains("infinitely many bounces end at t = 0.7"), "{unknown}");
}

/// Constant steps may end within a rounding error of an output.
#[test]
fn every_output_is_seen_once_by_constant_steps() {
    let scene = scene_of(&ball("0.5", "friction = \"0.25\"\n"));
    let problem = scene.problem(Axes::First);
    let switching = problem.switching.as_ref().expect("there are contacts");
    for steps in [250, 1000, 4000] {
        // the second impact coincides with an output
        let span = Span::new(0.0, 1.3, &problem.state).with_even_outputs(26);
        let mut record = Record::new();
        let method = (Method::RungeKutta4 { steps }, &Tolerance::both(1e-9));
        let outcome = problem.across(&**switching, method, &span, &mut record);
        assert!(outcome.reached());
        assert_eq!(record.times, span.outputs, "{steps} steps");
    }
}

/// The lowest point slides at 5 m/s and is decelerated by 7/2 mu g = 7 m/s^2; rolling begins with 5/7 of the velocity and 2/7 of r w (Euler 1758).
#[test]
fn a_ball_comes_to_roll_at_an_instant_that_is_known_to_all_digits() {
    let text = "title = \"ball\"\ngravity = \"-(8 m/s^2)*N.z\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nB = \"N free\"\n\
                [points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\nP = \"G - (0.5 m)*N.z\"\n\
                [bodies.ball]\nframe = \"B\"\ncentre = \"G\"\nmass = \"(1 kg)\"\n\
                inertia = { principal = [\"(0.1 kg m^2)\", \"(0.1 kg m^2)\", \"(0.1 kg m^2)\"] }\n\
                [[contact]]\nname = \"cloth\"\nof = \"ball at P\"\nthrough = \"O\"\nnormal = \"N.z\"\nfriction = \"0.25\"\ntouching = true\n\
                [start]\nz = \"0.5 m\"\n\"x'\" = \"3 m/s\"\n\"B.wx\" = \"-8 rad/s\"\n[run]\nspan = \"0.9 s\"\n";
    let found = exact(text);
    assert!(found.reference.digits > 25.0, "{}", found.reference.digits);
    let over_7 = |number: f64| DoubleDouble::from(number) / DoubleDouble::from(7.0);
    let [event] = found.events.as_slice() else { panic!("{:?}", found.events) };
    near(event.time, over_7(5.0));
    near(event.state[7], over_7(15.0));
    near(event.state[8], over_7(8.0));
    // by the mean velocity
    near(event.state[0], (DoubleDouble::from(3.0) + over_7(15.0)) * DoubleDouble::from(0.5) * over_7(5.0));
}

/// At the instant at which sliding begins from rest, its direction has no Taylor series.
#[test]
fn a_slip_that_begins_in_space_has_no_reference() {
    let text = "title = \"slope\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[parameters]\na = \"0.5 rad\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n\
                [frames]\nS = \"N turned a about y\"\n[points]\nP = \"O + x*S.x + y*S.y + z*S.z\"\n[bodies.block]\ncentre = \"P\"\nmass = \"(2 kg)\"\n\
                [[contact]]\nname = \"slope\"\nof = \"block\"\nthrough = \"O\"\nnormal = \"S.z\"\nfriction = \"0.3\"\ntouching = true\n\
                [run]\nspan = \"1 s\"\n";
    let Err(unknown) = scene_of(text).exact(PATIENCE) else { panic!("it has one") };
    assert!(unknown.to_string().contains("begins to slide in space"), "{unknown}");
}
