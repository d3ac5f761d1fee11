//! Ensembles of scene files: each member equals the run of a file with its values, in any batch.

mod exponentials;
mod free_frames;
mod lone_members;

use dalembert_scenes::{ModelScene, parse_ensemble};
use integrators::{Projection, Taylor, TaylorSeries, Tolerance, batch_order};
use simulation::ensemble::{EnsembleScene, Row};
use simulation::{Axes, IvpScene};
use std::ops::ControlFlow;
use std::path::Path;

/// A stored scene whose `[ensemble]` is replaced.
fn text(name: &str, ensemble: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/models").join(name).with_extension("toml");
    let text = std::fs::read_to_string(path).expect("it is there");
    let own = text.split("[ensemble]").next().unwrap_or(&text);
    format!("{own}\n[ensemble]\n{ensemble}")
}

fn ensemble(text: &str) -> EnsembleScene {
    parse_ensemble("ensemble.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn rows(scene: &EnsembleScene, threads: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    scene.run(1..=scene.members, threads, |row| {
        rows.push(row);
        ControlFlow::Continue(())
    });
    rows
}

/// The text with one part replaced, which must occur once.
fn with(text: &str, from: &str, to: &str) -> String {
    assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once");
    text.replace(from, to)
}

/// A Taylor series with projection onto the constraints after each step.
struct OnConstraints<'a> {
    series: Box<dyn TaylorSeries<f64> + 'a>,
    projection: Option<&'a dyn Projection<f64>>,
    at: f64,
}

impl TaylorSeries<f64> for OnConstraints<'_> {
    fn expand(&mut self, t: f64, y: &[f64], order: usize) {
        self.at = t;
        self.series.expand(t, y, order);
    }

    fn coefficients(&self, k: usize) -> &[f64] {
        self.series.coefficients(k)
    }

    fn sum(&self, h: f64, out: &mut [f64]) {
        self.series.sum(h, out);
        if let Some(projection) = self.projection {
            projection.project(self.at + h, out);
        }
    }

    fn shown(&self) -> f64 {
        self.series.shown()
    }
}

/// Number of steps and last row of the run of one file with the method of ensembles.
fn single(text: &str) -> (u64, Vec<f64>) {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let problem = scene.problem(Axes::First);
    let tolerance = scene.run.tolerance;
    let series = problem.law.taylor().expect("its law is recorded");
    let series = OnConstraints { series, projection: problem.law.projection(), at: 0.0 };
    let mut taylor = Taylor::new(series, &Tolerance::both(tolerance)).with_order(batch_order(tolerance));
    let mut state = problem.state.clone();
    let steps = taylor.propagate(0.0, scene.run.span, &mut state).expect("it arrives");
    (steps, (problem.row)(scene.run.span, &state))
}

/// Compares each row of an ensemble with the run of a file that has its values; `edit` inserts the values into the text.
fn rows_are_runs(text: &str, least: f64, edit: impl Fn(&str, &[f64]) -> String) {
    for row in rows(&ensemble(text), 2) {
        let last = row.last.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        let (steps, shown) = single(&edit(text, &row.drawn));
        assert_eq!((row.steps, &row.stopped), (steps, &None));
        let found = last.state.iter().copied().map(Some).chain(last.derived.iter().copied());
        for (own, one) in shown.iter().zip(found) {
            let found = one.expect("it is a number");
            assert!((own - found).abs() <= least * own.abs().max(1.0), "member {}: {own} {found}", row.number);
        }
    }
}

const PENDULA: &str = "members = 11\n[ensemble.vary]\nparameters.m2 = { from = \"0.5 kg\", to = \"2 kg\" }\n\
                       parameters.l1 = { mean = \"1 m\", deviation = \"5 cm\" }\nstart.a = { from = \"30 deg\", to = \"60 deg\" }\n\
                       start.\"b'\" = { mean = \"0 rad/s\", deviation = \"0.1 rad/s\" }\n";

/// The span is short, since the motion is chaotic: rounding errors grow by a factor of about e each second.
fn pendula() -> String {
    with(&text("double_pendulum", PENDULA), "span = \"10 s\"", "span = \"2 s\"")
}

#[test]
fn every_member_of_a_double_pendulum_is_the_run_of_a_file_with_its_numbers() {
    rows_are_runs(&pendula(), 1e-12, |text, drawn| {
        let [m2, l1, a, b_rate] = drawn else { panic!("four numbers vary") };
        let text = with(text, "m2 = \"1 kg\"", &format!("m2 = \"{m2} kg\""));
        let text = with(&text, "l1 = \"1 m\"", &format!("l1 = \"{l1} m\""));
        with(&text, "a = \"120 deg\"", &format!("a = \"{a} rad\"\n\"b'\" = \"{b_rate} rad/s\""))
    });
}

#[test]
fn results_are_the_same_to_the_last_bit_with_any_number_of_threads() {
    let scene = ensemble(&pendula().replace("members = 11", "members = 40"));
    let one = rows(&scene, 1);
    assert_eq!(one, rows(&scene, 3));
    assert!(one.iter().zip(1..).all(|(row, number)| row.number == number) && one.len() == 40);
    let mut tail = Vec::new();
    scene.run(30..=40, 2, |row| {
        tail.push(row);
        ControlFlow::Continue(())
    });
    assert_eq!(tail[..], one[29..]);
}

/// The constraints are nonholonomic: the speeds at the point of contact are completed for every member.
#[test]
fn starts_of_a_rolling_disc_are_completed_for_every_member() {
    let vary = "members = 9\n[ensemble.vary]\nparameters.r = { from = \"20 cm\", to = \"50 cm\" }\n\
                start.lean = { from = \"0 deg\", to = \"20 deg\" }\nstart.\"spin'\" = { from = \"5 rad/s\", to = \"7 rad/s\" }\n";
    let free = with(&text("rolling_disc", vary), "\"x'\" = \"2.058 m/s\"\n", "");
    rows_are_runs(&free, 1e-12, |text, drawn| {
        let [r, lean, spin] = drawn else { panic!("three numbers vary") };
        let text = with(text, "r = \"343 mm\"", &format!("r = \"{r} m\""));
        let text = with(&text, "lean = \"10 deg\"", &format!("lean = \"{lean} rad\""));
        with(&text, "\"spin'\" = \"6 rad/s\"", &format!("\"spin'\" = \"{spin} rad/s\""))
    });
    // with x' given by the file, the varied spin violates the rolling constraint for every member
    for row in rows(&ensemble(&text("rolling_disc", vary)), 1) {
        let why = row.stopped.as_deref().unwrap_or_default();
        assert!(
            row.last.is_none() && why.starts_with("no start meets the constraints: constraint 1 `rolling` is "),
            "{row:?}"
        );
    }
}

/// The loop is closed by Newton's method for positions, then for speeds.
#[test]
fn loops_of_a_slider_crank_are_closed_for_every_member() {
    let vary = "members = 9\n[ensemble.vary]\nparameters.l = { from = \"0.25 m\", to = \"0.5 m\" }\n\
                start.theta = { from = \"-60 deg\", to = \"60 deg\" }\nstart.\"theta'\" = { from = \"0 rad/s\", to = \"2 rad/s\" }\n";
    let guessed = with(&text("slider_crank", vary), "s = \"0.4 m\"", "s = \"guess 0.4 m\"");
    rows_are_runs(&guessed, 1e-12, |text, drawn| {
        let [l, theta, rate] = drawn else { panic!("three numbers vary") };
        let text = with(text, "l = \"0.3 m\"", &format!("l = \"{l} m\""));
        let start = format!("s = \"guess 0.4 m\"\ntheta = \"{theta} rad\"\n\"theta'\" = \"{rate} rad/s\"");
        with(&text, "s = \"guess 0.4 m\"", &start)
    });
    // with a rod shorter than the crank, the loop cannot be closed at a right angle
    let short = guessed.replace("from = \"-60 deg\", to = \"60 deg\"", "values = \"60 90 85 rad\"").replace(
        "parameters.l = { from = \"0.25 m\", to = \"0.5 m\" }",
        "parameters.l = { from = \"1 mm\", to = \"2 mm\" }",
    );
    let short = short.replace("members = 9", "members = 3");
    for row in rows(&ensemble(&short), 2) {
        let why = row.stopped.as_deref().unwrap_or_default();
        assert!(row.last.is_none() && why.contains("no start meets the constraints: constraint 1 `pin`"), "{row:?}");
        assert!(!why.contains("NaN"), "{why}");
    }
}

/// A varied current has its own name, or that of the rate of its charge.
#[test]
fn a_current_at_the_start_varies() {
    let of = |name: &str| {
        let vary = format!("members = 3\n[ensemble.vary]\nstart.\"{name}\" = {{ values = \"0 1 2 A\" }}\n");
        let rows = rows(&ensemble(&text("geared_motor", &vary)), 1).into_iter();
        rows.map(|row| row.last.expect("it starts").state).collect::<Vec<_>>()
    };
    let ends = of("motor.i");
    assert_eq!(ends, of("motor.q'"));
    // the initial energy of the winding accelerates the carriage and the wheel
    assert!(ends[0] != ends[1] && ends[1] != ends[2], "{ends:?}");
}

#[test]
fn a_guess_that_varies_is_still_a_guess() {
    let vary = "members = 3\n[ensemble.vary]\nstart.s = { values = \"0.3 0.35 0.4 m\" }\n";
    let start = "theta = \"0.5 rad\"\ns = \"guess 0.35 m\"";
    let scene = ensemble(&with(&text("slider_crank", vary), "s = \"0.4 m\"", start));
    let ends: Vec<Vec<f64>> = rows(&scene, 1).into_iter().map(|row| row.last.expect("it starts").state).collect();
    for end in &ends {
        assert!(end.iter().zip(&ends[0]).all(|(a, b)| (a - b).abs() < 1e-8), "{ends:?}");
    }
}

#[test]
fn the_energy_of_every_member_stays_and_is_a_column_where_it_is_kept() {
    let scene = ensemble(&pendula());
    let columns = scene.columns();
    assert_eq!(columns[..6], ["member", "parameters.m2", "parameters.l1", "start.a", "start.b'", "stopped"]);
    assert_eq!(
        columns[8..],
        ["a", "b", "a'", "b'", "height", "kinetic_energy", "potential_energy", "energy_change"].map(String::from)
    );
    let headings = scene.headings();
    assert!(
        ["start.b' [rad/s]", "height [m]", "energy_change [J]"].iter().all(|one| headings.contains(&(*one).to_owned()))
    );
    for row in rows(&scene, 1) {
        let change = row.last.and_then(|last| last.derived.last().copied().flatten());
        assert!(change.is_some_and(|change| change.abs() < 1e-8), "{change:?}");
    }
    let viscous = ensemble(&text(
        "cart_with_two_links",
        "members = 2\n[ensemble.vary]\nparameters.c = { from = \"0 N m s\", to = \"1 N m s\" }\n",
    ));
    assert!(!viscous.columns().contains(&"energy_change".to_owned()));
}

/// Results are in coherent units, also if the file names another unit for a coordinate.
#[test]
fn a_coordinate_that_is_named_in_degrees_is_shown_in_radians() {
    let scene = ensemble(&with(&pendula(), "[coordinates]\na = \"rad\"", "[coordinates]\na = \"deg\""));
    let headings = scene.headings();
    assert!(["start.a [rad]", "a [rad]", "a' [rad/s]"].iter().all(|one| headings.contains(&(*one).to_owned())));
}

#[test]
fn members_that_cannot_exist_are_rows_with_a_reason() {
    let spread = with(&pendula(), "from = \"0.5 kg\", to = \"2 kg\"", "from = \"-1 kg\", to = \"1 kg\"");
    let rows = rows(&ensemble(&with(&spread, "members = 11", "members = 40")), 2);
    let gone: Vec<&Row> = rows.iter().filter(|row| row.last.is_none()).collect();
    assert!(gone.len() > 5 && gone.len() < 35 && rows.len() == 40, "{}", gone.len());
    for row in gone {
        let why = row.stopped.as_deref().unwrap_or_default();
        assert!(
            row.drawn[0] <= 0.0
                && why.starts_with("no such bodies exist: the mass of `lower` must be positive: it is -"),
            "{why}"
        );
    }
    // a rod of zero length: the rotation has no inertia
    let still = with(
        &pendula(),
        "parameters.l1 = { mean = \"1 m\", deviation = \"5 cm\" }",
        "parameters.l1 = { mean = \"0 m\", deviation = \"0 m\" }",
    );
    for row in self::rows(&ensemble(&still), 1) {
        let last = row.last.as_ref().expect("its bodies exist");
        assert!(row.stopped.is_some() && last.time == 0.0, "{row:?}");
        assert!(last.state.iter().chain(last.derived.iter().flatten()).all(|number| number.is_finite()), "{row:?}");
    }
}

/// Requires one message that contains all parts and marks its place in the text.
fn refused(text: &str, parts: &[&str]) {
    let error = parse_ensemble("ensemble.toml", text).expect_err(text);
    let message = error.to_string();
    assert_eq!(error.issues.len(), 1, "{message}");
    assert!(parts.iter().all(|part| message.contains(part)) && message.contains('^'), "{message}");
}

#[test]
fn faults_of_an_ensemble_are_told_at_their_place() {
    let all = pendula();
    let vary = |from: &str, to: &str| with(&all, from, to);
    refused(
        &vary("parameters.m2 =", "parameters.m3 ="),
        &["no parameter is called `m3`", "known here: m1, m2, l1, l2, g"],
    );
    refused(&vary("parameters.m2 =", "parameter.m2 ="), &["unknown key `parameter`", "is `parameters` meant?"]);
    refused(&vary("start.\"b'\" =", "start.\"c'\" ="), &["unknown key `c'`"]);
    refused(
        &vary("\"5 cm\"", "\"5 kg\""),
        &["`deviation`, a value for the parameter `l1`, cannot be read", "this is kg", "`m`"],
    );
    refused(&vary("to = \"60 deg\"", "to = \"60 m\""), &["`to`, a value for the start of `a`, cannot be read"]);
    refused(&vary("to = \"60 deg\"", "to = \"20 deg\""), &["`to` is less than `from`"]);
    refused(&vary("mean = \"1 m\", ", ""), &["how `l1` varies is not said", "{ from, to }"]);
    refused(
        &vary("mean = \"1 m\", deviation", "mean = \"1 m\", deviaton"),
        &["unknown key `deviaton`", "is `deviation` meant?"],
    );
    refused(
        &vary("{ from = \"30 deg\", to = \"60 deg\" }", "\"30 deg\""),
        &["how `a` varies is not said", "{ from, to }"],
    );
    refused(
        &vary("{ from = \"30 deg\", to = \"60 deg\" }", "{ from = \"3 rad\", to = \"6 m\" }"),
        &["`to`, a value for the start of `a`"],
    );
    refused(&vary("members = 11", "members = 0"), &["`members` is out of range"]);
    refused(&vary("members = 11", "member = 11"), &["unknown key `member`", "is `members` meant?"]);
    refused(
        &text("double_pendulum", "members = 5\n[ensemble.vary]\n"),
        &["nothing varies", "parameters.m1 = { from = \"1 kg\""],
    );
    refused(&vary("m2 = \"1 kg\"", "m2 = \"kg\""), &["the parameter `m2` has no value"]);
    let without = all.split("[ensemble]").next().unwrap_or_default();
    refused(without, &["the table [ensemble] is missing"]);
}

/// The law depends on time; parameters occur in an angle, a root and a quotient.
#[test]
fn parameters_stand_anywhere_in_a_law_that_knows_the_time() {
    let text = "title = \"A bead on a wire that is turned and shaken\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"0.1 kg\"\nR = \"20 cm\"\n\
                g = \"9.81 m/s^2\"\nw = \"3 rad/s\"\ntilt = \"10 deg\"\nh = \"0.04 m^2\"\nk = \"2 N/m\"\n[coordinates]\nth = \"rad\"\n\
                [frames]\nT = \"N turned tilt about x\"\nH = \"T turned w*t about z\"\n\
                [points]\nC = \"O + sqrt(h)/10*cos(2*w*t)*N.z\"\nP = \"C + R*(sin(th)*H.x - cos(th)*H.z)\"\n\
                [bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n[[force]]\nbetween = [\"O\", \"bead\"]\nis = \"-k*(distance(O, P) - R)\"\n\
                [start]\nth = \"1 rad\"\n[run]\nspan = \"1 s\"\ntolerance = 1e-12\n\
                [ensemble]\nmembers = 7\n[ensemble.vary]\nparameters.tilt = { from = \"0 deg\", to = \"30 deg\" }\n\
                parameters.w = { from = \"1 rad/s\", to = \"5 rad/s\" }\nparameters.h = { from = \"0.01 m^2\", to = \"0.1 m^2\" }\n\
                parameters.k = { from = \"1 N/m\", to = \"4 N/m\" }\n";
    rows_are_runs(text, 1e-11, |text, drawn| {
        let [w, tilt, h, k] = drawn else { panic!("four numbers vary") };
        let text = with(text, "w = \"3 rad/s\"", &format!("w = \"{w} rad/s\""));
        let text = with(&text, "tilt = \"10 deg\"", &format!("tilt = \"{tilt} rad\""));
        let text = with(&text, "h = \"0.04 m^2\"", &format!("h = \"{h} m^2\""));
        with(&text, "\nk = \"2 N/m\"", &format!("\nk = \"{k} N/m\""))
    });
}
