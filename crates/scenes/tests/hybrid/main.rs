//! Systems whose law or state changes at events, compared with closed forms.

mod contacts;
mod draws;
mod friction;
mod poles;
mod relays;
mod shares;
mod starts;

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Axes, Choice, IvpScene, Problem, Trajectory};

const METHODS: [Method; 3] = [Method::DormandPrince8, Method::Taylor, Method::Radau5];

fn runs(text: &str, method: Method) -> Trajectory {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method, tolerance: 1e-12, ..scene.run().choice() };
    scene.problem(choice.axes).simulate(&choice, |_| {})
}

fn stored(name: &str) -> String {
    let path = format!("{}/../../scenes/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn close(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} and {known}");
}

/// x'' = -x - sgn x' from (12, 6): half circles about -1 and 1 in turn in the phase plane, until one ends between these points.
#[test]
fn a_block_with_dry_friction_sticks_where_the_closed_form_says() {
    for method in METHODS {
        let trajectory = runs(&stored("dry_friction"), method);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let at = |name: &str| trajectory.last[trajectory.column(name).unwrap()];
        close(at("x"), 15.0 - 205f64.sqrt(), 1e-10);
        close(at("x'"), 0.0, 1e-13);
        // friction balances the spring
        close(at("friction"), at("x"), 1e-10);
        let moving = |time: f64| trajectory.times.iter().position(|known| *known >= time).unwrap();
        let speed = trajectory.column("x'").unwrap();
        assert!(trajectory.rows[moving(22.0)][speed].abs() > 0.1);
        assert!(trajectory.rows[moving(22.5)][speed].abs() < 1e-13);
    }
}

/// Each bounce reduces the height by the factor e^2, so that the times of flight are a geometric series.
#[test]
fn a_ball_bounces_as_often_as_the_closed_form_says() {
    let (g, e) = (9.81f64, 0.8);
    for method in METHODS {
        let trajectory = runs(&stored("bouncing_ball"), method);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let (mut landed, mut flight, mut speed) = ((2.0 / g).sqrt(), 0.0, (2.0 * g).sqrt());
        while landed + flight < 3.0 {
            landed += flight;
            speed *= e;
            flight = 2.0 * speed / g;
        }
        let since = 3.0 - landed;
        close(trajectory.last[0], speed * since - g * since * since / 2.0, 1e-9);
        close(trajectory.last[1], speed - g * since, 1e-9);
    }
}

#[test]
fn bounces_without_end_are_told() {
    let endless = stored("bouncing_ball").replace("span = \"3 s\"", "span = \"5 s\"");
    let trajectory = runs(&endless, Method::DormandPrince8);
    let limit = (2.0f64 / 9.81).sqrt() * (1.0 + 0.8) / (1.0 - 0.8);
    close(trajectory.outcome.time, limit, 1e-6);
    assert!(
        trajectory.stopped().unwrap().contains("infinitely many occur in a finite time"),
        "{:?}",
        trajectory.stopped()
    );
}

const PUSHED: &str = r#"
title = "A mass that is pushed for two seconds"
[parameters]
m = "2 kg"
[coordinates]
x = "m"
[bodies.mass]
centre = "O + x*N.x"
mass = "m"
[inputs]
u = { unit = "N", value = "FORCE" }
[[force]]
on = "mass"
is = "u*N.x"
[run]
span = "5 s"
"#;

/// Position and speed after five seconds under a force.
fn pushed(force: &str) -> [f64; 2] {
    let trajectory = runs(&PUSHED.replace("FORCE", force), Method::DormandPrince8);
    assert_eq!(trajectory.stopped(), None, "{force}");
    [trajectory.last[0], trajectory.last[1]]
}

#[test]
fn an_input_of_pieces_gives_the_impulse_of_its_pieces() {
    let both = |[x, v]: [f64; 2], known: [f64; 2]| {
        close(x, known[0], 1e-10);
        close(v, known[1], 1e-11);
    };
    both(pushed("if(t < (2 s), (4 N), 0)"), [4.0 + 4.0 * 3.0, 4.0]);
    // rises to 2 N in one second, then stays 2 N
    both(pushed("min(t*(2 N/s), (2 N))"), [1.0 / 6.0 + 0.5 * 4.0 + 8.0, 4.5]);
    both(pushed("max(t - (2 s), 0)*(2 N/s)"), [4.5, 4.5]);
    // a triangular pulse over four seconds, then zero
    both(pushed("(1 N)*table(t, (0 s), 0, (2 s), 2, (4 s), 0)"), [4.0 + 2.0, 2.0]);
    both(pushed("(2 N)*abs(t - (1 s))/(1 s)"), [1.0 / 3.0 + 0.5 * 4.0 + 64.0 / 6.0, 8.5]);
    both(pushed("(2 N)*sign(t - (1 s))"), [-0.5 - 4.0 + 8.0, 3.0]);
}

#[test]
fn an_event_ends_a_run_or_stops_a_motion_that_breaks_a_constraint() {
    let event = |keys: &str| format!("{}\n[[event]]\nwhen = \"x - (4 m)\"\n{keys}", PUSHED.replace("FORCE", "(2 N)"));
    let ended = runs(&event("end = true"), Method::Taylor);
    assert_eq!(ended.stopped(), None);
    close(ended.outcome.time, 8f64.sqrt(), 1e-11);
    let held = format!("{}\n[[constraint]]\nzero = \"x - (1 m/s)*t\"\n", event("set = { x = \"0\" }"));
    let broken = runs(&held, Method::Taylor);
    assert!(broken.stopped().unwrap().contains("violates a constraint"), "{:?}", broken.stopped());
    // the run ends with the state before the event
    close(broken.last[0], 4.0, 1e-9);
    close(broken.last[1], 1.0, 1e-9);
    let scene = ModelScene::parse("scene.toml", &held).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method: Method::Taylor, ..scene.run.choice() };
    let broken = scene.problem(Axes::First).simulate(&choice, |_| ());
    let told = scene.told(&choice, &broken).diagnosis.expect("it is told");
    assert!(
        told.starts_with("after the event in line ")
            && told.ends_with(" constraint 1 becomes -4 m, which must be zero"),
        "{told}"
    );
}

/// Such a system has one law: its energy is conserved, its end depends on its start, and its reference needs no events.
#[test]
fn an_event_that_only_ends_a_run_changes_no_law() {
    let fall = |keys: &str| {
        let text = "title = \"A fall\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\ny = \"m\"\n[points]\nP = \"O + y*N.y\"\n\
                    [bodies.b]\ncentre = \"P\"\nmass = \"(1 kg)\"\n[start]\ny = \"20 m\"\n[run]\nspan = \"1 s\"\n";
        let text = format!("{text}[[event]]\nwhen = \"y\"\ndirection = \"down\"\n{keys}\n");
        ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
    };
    let (ends, sets) = (fall("end = true"), fall("end = true\nset = { y = \"0\" }"));
    assert!(ends.hybrid().is_none() && sets.hybrid().is_some());
    let problem = ends.problem(Axes::First);
    assert_eq!(problem.invariants.iter().map(|one| one.name).collect::<Vec<_>>(), ["energy"]);
    let matrix = problem.transition(1e-12).expect("it has one law");
    close(matrix[0][1], 1.0, 1e-12);
    let reference = problem.reference(std::time::Duration::from_secs(20)).expect("it has one law");
    close(reference.states[7][0].hi(), 15.0, 1e-14);
    let longer = Problem { span: 3.0, ..problem };
    let run = longer.simulate(&ends.run.choice(), |_| ());
    assert!(run.ends_before(longer.span) && run.stopped().is_none());
    close(run.outcome.time, 2.0, 1e-9);
}

/// The message names the event that ended the run, one of two, by its name or its line.
#[test]
fn the_event_that_ends_a_run_is_told() {
    let ends = |when: &str, name: &str| {
        format!("[[event]]\n{name}when = \"x - ({when})\"\nset = {{ x = \"0\" }}\nend = true\n")
    };
    let text = PUSHED.replace("FORCE", "(2 N)") + &ends("9 m", "name = \"far\"\n");
    let told = |text: &str| {
        let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
        let choice = Choice { method: Method::Taylor, ..scene.run().choice() };
        let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
        (trajectory.outcome.time, scene.told(&choice, &trajectory).diagnosis)
    };
    let (time, diagnosis) = told(&(text.clone() + &ends("4 m", "name = \"wall\"\n")));
    close(time, 8f64.sqrt(), 1e-9);
    assert_eq!(diagnosis.as_deref(), Some("the event `wall` ends the run"));
    let (_, diagnosis) = told(&(text.clone() + &ends("4 m", "")));
    let line = text.lines().count() + 1;
    assert_eq!(diagnosis, Some(format!("the event in line {line} ends the run")));
    // an event that does not occur does not end the run
    assert_eq!(told(&(PUSHED.replace("FORCE", "(2 N)") + &ends("90 m", ""))).1, None);
}

#[test]
fn a_start_from_which_two_motions_go_has_no_run() {
    let stopped = runs(&PUSHED.replace("FORCE", "(2 N)*sign(x')"), Method::DormandPrince8).stopped();
    assert!(stopped.is_some_and(|why| why.starts_with("does not begin: several motions are possible from here")));
}

/// The force begins beyond x = 0: the body may stay there, or leave. Where it begins at x = 0, the body leaves.
#[test]
fn a_body_at_rest_where_a_force_begins_has_two_motions() {
    let stopped = runs(&PUSHED.replace("FORCE", "if(x > (0 m), (2 N), 0)"), Method::DormandPrince8).stopped();
    assert!(stopped.is_some_and(|why| why.starts_with("does not begin: several motions are possible from here")));
    let pushed = runs(&PUSHED.replace("FORCE", "if(x >= (0 m), (2 N), 0)"), Method::DormandPrince8);
    assert_eq!(pushed.stopped(), None);
    close(pushed.last[0], 12.5, 1e-9);
}

/// A force that is switched 5000 times a second for five seconds: more than 20,000 events are no failure.
#[test]
fn switching_at_a_fixed_frequency_goes_on() {
    let switched = PUSHED.replace("FORCE", "if(sin(2*pi*t*(2500 1/s)) > 0, (4 N), 0)");
    let trajectory = runs(&switched, Method::DormandPrince8);
    assert_eq!(trajectory.stopped(), None);
    assert!(trajectory.passages.len() > 20_000);
    // the mean force is 2 N
    close(trajectory.last[0], 12.5, 2e-3);
}

#[test]
fn a_programmed_constraint_is_led_to_zero_from_where_it_starts() {
    let led = format!(
        "{}\n[[constraint]]\nzero = \"x - (1 m)\"\nprogrammed = {{ gains = [\"2*(1 1/s)\", \"(1 1/s)^2\"] }}\n",
        PUSHED.replace("FORCE", "(2 N)")
    );
    let trajectory = runs(&led, Method::DormandPrince8);
    // f'' + 2 f' + f = 0 from f = -1: f = -(1 + t) e^-t
    close(trajectory.last[0], 1.0 - 6.0 * (-5f64).exp(), 1e-11);
}

#[test]
fn elementary_functions_run_by_every_method() {
    for (force, known) in [("(2 N)*exp(-t/(1 s))", 4.0 + (-5f64).exp()), ("(2 N)*tanh(t/(1 s))", f64::NAN)] {
        let text = PUSHED.replace("FORCE", force);
        let all: Vec<f64> = METHODS.map(|method| runs(&text, method).last[0]).to_vec();
        all.iter().for_each(|x| close(*x, all[0], 1e-9));
        if known.is_finite() {
            close(all[0], known, 1e-10);
        }
    }
    let spring = PUSHED.replace("FORCE", "-(2 N)*atan2(x, (1 m)) - (1 N)*ln(1 + (x/(1 m))^2)*x/(1 m) + (1 N)");
    let all = METHODS.map(|method| runs(&spring, method).last[0]);
    all.iter().for_each(|x| close(*x, all[0], 1e-9));
}

/// At the start a condition and its rate are zero: its second derivative decides, or two motions are possible.
#[test]
fn a_condition_at_rest_at_zero_is_decided_by_its_next_rate() {
    let spring = PUSHED.replace("FORCE", "-(2 N)*x/(1 m)*if(x > (1 m), 1, 2)") + "[start]\nx = \"1 m\"\n";
    let trajectory = runs(&spring, Method::DormandPrince8);
    assert_eq!(trajectory.stopped(), None);
    // x'' = -2 x below one metre
    close(trajectory.last[0], (2f64.sqrt() * 5.0).cos(), 1e-9);
    let fork = PUSHED.replace("FORCE", "if(x > (1 m), (2 N), -(2 N))") + "[start]\nx = \"1 m\"\n";
    let stopped = runs(&fork, Method::DormandPrince8).stopped();
    assert!(stopped.is_some_and(|why| why.contains("several motions are possible from here")));
}
