//! Redundant constraints are reported and have no reaction; runs, members of ensembles and linear equations work.

use dalembert_scenes::linearisation::{VariedEquations, eigenvalues};
use dalembert_scenes::{ModelScene, independent_start, parse_ensemble};
use integrators::Method;
use model::{QuasiPrinciple, QuasiVelocities, Trace};
use simulation::{Axes, IvpScene};
use std::collections::HashMap;

/// A rod on three parallel cranks: the third crank constrains the rod in its own direction as the second does.
const CRANKS: &str = r#"
title = "A coupler on three parallel cranks"
gravity = "-g*N.y"
[parameters]
m = "1 kg"
g = "9.81 m/s^2"
r = "0.3 m"
w = "1 m"
[coordinates]
a = "rad"
b = "rad"
c = "rad"
d = "rad"
[frames]
A = "N turned a about z"
B = "N turned b about z"
C = "N turned c about z"
D = "N turned d about z"
[points]
P = "O + r*A.x"
Q = "O + (1 m)*N.x + r*B.x"
R = "O + (2 m)*N.x + r*C.x"
[bodies.coupler]
frame = "D"
centre = "P + (1.2 m)*D.x"
mass = "m"
inertia = "(0.3 kg m^2)"
[[constraint]]
name = "second"
zero = "P + w*D.x - Q"
[[constraint]]
name = "third"
zero = "P + (2 m)*D.x - R"
[outputs]
along = "reaction(third) . C.x"
second = "reaction(second) . B.x"
[start]
a = "80 deg"
b = "80 deg"
c = "80 deg"
[run]
span = "0.4 s"
tolerance = 1e-10
"#;

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("cranks.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn with(from: &str, to: &str) -> String {
    assert_eq!(CRANKS.matches(from).count(), 1, "`{from}` must stand once");
    CRANKS.replace(from, to)
}

/// The cranks move as an inverted pendulum of their length.
#[test]
fn a_constraint_that_follows_from_others_is_named_and_runs_without_a_reaction() {
    let scene = scene(CRANKS);
    let [warning] = &scene.model.warnings[..] else { panic!("{:?}", scene.model.warnings) };
    let start = "a = 1.3963 rad, b = 1.3963 rad, c = 1.3963 rad, d = 0 rad";
    let title = "constraint 3 `third` along C.x follows from other constraints for positions near the start";
    assert_eq!(warning.title, format!("{title}, {start}"));
    assert_eq!(&CRANKS[warning.span.clone()], "P + (2 m)*D.x - R");
    for method in [Method::DormandPrince8, Method::Taylor, Method::RadauIIA { stages: 5 }] {
        let (last, kept) = super::end(&scene, method, 1e-10);
        assert!(kept.iter().all(|moved| moved.abs() < 1e-8), "{method}: {kept:?}");
        let [a, b, c, d] = last[..4] else { panic!("four angles") };
        assert!((a - b).abs() < 1e-8 && (a - c).abs() < 1e-8 && d.abs() < 1e-8, "{method}: {last:?}");
        let speed = (2.0 * 9.81 / 0.3 * (80_f64.to_radians().sin() - a.sin())).sqrt();
        assert!((last[4] + speed).abs() < 1e-7, "{method}: {last:?}");
        assert_eq!(last[8], 0.0);
        assert!(last[9].abs() > 1e-3, "{last:?}");
    }
}

/// Five rods along edges of a cube, joined by six hinges (Bricard 1897): five angles and five constraints, of which one follows from the others.
#[test]
fn the_rectangular_bricard_mechanism_moves_with_one_degree_of_freedom() {
    let hinges = [("N", "y"), ("F1", "z"), ("F2", "x"), ("F3", "y"), ("F4", "z")];
    let rods = [("O", "x", 1.0), ("P1", "y", -1.0), ("P2", "z", 1.0), ("P3", "x", -1.0), ("P4", "y", 1.0)];
    let [mut coordinates, mut frames, mut points, mut bodies] = [const { String::new() }; 4];
    for (k, ((base, axis), (from, along, way))) in (1..).zip(hinges.into_iter().zip(rods)) {
        coordinates += &format!("a{k} = \"rad\"\n");
        frames += &format!("F{k} = \"{base} turned a{k} about {axis}\"\n");
        points += &format!("P{k} = \"{from} + ({way} m)*F{k}.{along}\"\n");
        let about = |own: &str| if own == along { "(0 kg m^2)" } else { "(1 kg m^2)/12" };
        let principal = ["x", "y", "z"].map(|own| format!("\"{}\"", about(own))).join(", ");
        let half = 0.5 * way;
        bodies += &format!(
            "[bodies.rod{k}]\nframe = \"F{k}\"\ncentre = \"{from} + ({half} m)*F{k}.{along}\"\nmass = \"(1 kg)\"\ninertia = {{ principal = [{principal}] }}\n"
        );
    }
    let scene = scene(&format!(
        "title = \"Bricard\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\n{coordinates}[frames]\n{frames}[points]\n{points}{bodies}\
         [[constraint]]\nzero = \"P5 - O - (1 m)*N.z\"\n[[constraint]]\nzero = [\"F5.x . N.y\", \"F5.x . N.z\"]\n[run]\nspan = \"3 s\"\n"
    ));
    assert_eq!(scene.model.implied.len(), 1);
    let [first, second] = [Method::DormandPrince8, Method::Taylor].map(|method| super::end(&scene, method, 1e-12));
    for (last, kept) in [&first, &second] {
        assert!(kept.iter().all(|moved| moved.abs() < 1e-9), "{kept:?}");
        // the mechanism is symmetric
        assert!((last[0] - last[2]).abs() < 1e-9 && (last[0] - last[4]).abs() < 1e-9, "{last:?}");
        assert!((last[1] - last[3]).abs() < 1e-9 && last[0].abs() > 0.1, "{last:?}");
    }
    assert!(first.0[..10].iter().zip(&second.0).all(|(one, other)| (one - other).abs() < 1e-8), "{first:?} {second:?}");
}

/// Four constraints and four angles: in general no motion is possible, but on the branch of the start there is one degree of freedom.
#[test]
fn quasi_velocities_are_judged_on_the_branch_of_the_start() {
    let text = with("[frames]", "[speeds]\nw1 = \"b'\"\n[frames]").replace("[run]", "w1 = \"2 rad/s\"\n[run]");
    let scene = scene(&text);
    assert_eq!(scene.model.implied.len(), 1);
    let equations = VariedEquations::of(&scene.model, &[]).expect("it has them");
    let point = equations.with_accelerations(equations.point(0.0, &scene.start)).expect("it is determined");
    let acceleration: f64 = symbolic::apart(|| {
        let trace = Trace::of(&scene.model);
        let quasi = QuasiVelocities::of(&trace).expect("they are independent");
        let residual = QuasiPrinciple::VirtualPower.residual(&quasi).expect("it applies")[0];
        let letters = scene.model.state_names().into_iter().map(|(name, _)| name).zip(scene.start.iter().copied());
        let parameters = scene.model.parameters.iter().filter_map(|one| Some((one.name.clone(), one.value?)));
        let mut values: HashMap<String, f64> = letters.chain(parameters).chain([("w1".to_owned(), 2.0)]).collect();
        let mut at = |acceleration: f64| {
            values.insert("w1'".to_owned(), acceleration);
            residual.evaluate_analytic(&|name| values.get(name).copied()).expect("every letter has a value")
        };
        let bias: f64 = at(0.0);
        -bias / (at(1.0) - bias)
    });
    assert!((acceleration - point.accelerations[1]).abs() < 1e-10 * acceleration.abs(), "{acceleration}: {point:?}");
    let refused = |text: &str| ModelScene::parse("cranks.toml", text).expect_err("it is wrong").to_string();
    let two = text.replace("w1 = \"b'\"", "w1 = \"b'\"\nw2 = \"c'\"");
    let found = refused(&two);
    assert!(found.contains("the speeds have one degree of freedom, and [speeds] has 2: 1 too many"), "{found}");
    // another branch, on which the system cannot move
    let apart = text.replace("c = \"80 deg\"", "c = \"-80 deg\"");
    let found = refused(&apart);
    assert!(found.contains("the speeds have 0 degrees of freedom, and [speeds] has 1: 1 too many"), "{found}");
}

fn diagnosis(text: &str) -> String {
    let scene = scene(text);
    let choice = scene.run().choice();
    let run = scene.problem(Axes::First).simulate(&choice, |_| ());
    assert_eq!(run.stopped(), None, "{:?}", run.outcome.state);
    scene.told(&choice, &run).diagnosis.unwrap_or_default()
}

#[test]
fn a_law_with_events_leaves_out_what_follows() {
    let event = "[[event]]\nname = \"low\"\nwhen = \"a - (60 deg)\"\nend = true\n[outputs]";
    // events require that every coordinate has inertia
    let pins = "[bodies.pin2]\ncentre = \"Q\"\nmass = \"(0.1 kg)\"\n[bodies.pin3]\ncentre = \"R\"\nmass = \"(0.1 kg)\"\n[bodies.coupler]";
    let text = with("[outputs]", event).replace("[bodies.coupler]", pins);
    assert_eq!(diagnosis(&text), "the event `low` ends the run");
}

#[test]
fn what_depends_on_others_at_the_start_alone_is_refused() {
    let text = "title = \"t\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"(1 kg)\"\n\
                [[constraint]]\nzero = \"x^2 + y^2 - (1 m^2)\"\n[[constraint]]\nzero = \"x - (1 m)\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"1 s\"\n";
    let error = ModelScene::parse("t.toml", text).expect_err("it is singular").to_string();
    assert!(error.contains("depends on other constraints at the start"), "{error}");
    let one = |zero: &str, start: &str| {
        let head = text.split("[[constraint]]").next().expect("a beginning");
        let text = format!("{head}[[constraint]]\nzero = \"{zero}\"\n[start]\n{start}\n[run]\nspan = \"1 s\"\n");
        ModelScene::parse("t.toml", &text).expect_err("it is singular").to_string()
    };
    let error = one("(x - y)^2", "x = \"0.3 m\"\ny = \"0.3 m\"");
    assert!(error.contains("the gradient of constraint 1 is zero wherever the constraint holds"), "{error}");
    let error = one("norm(x*N.x + y*N.y)", "x = \"0 m\"\ny = \"0 m\"");
    assert!(error.contains("its gradient does not exist there"), "{error}");
    // a stabilised constraint, which need not hold at the start, depends on the others, too
    let led = "[[constraint]]\nzero = \"2*a - 2*b\"\nprogrammed = { gains = [\"(8 1/s)\", \"(16 1/s^2)\"] }\n[outputs]";
    let error = ModelScene::parse("t.toml", &with("[outputs]", led)).expect_err("it is singular").to_string();
    assert!(error.contains("depends on other constraints at the start"), "{error}");
}

#[test]
fn time_speeds_and_free_frames_do_not_hide_what_follows() {
    let body = "title = \"t\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[frames]\nF = \"N free\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
                [bodies.b]\nframe = \"F\"\ncentre = \"P\"\nmass = \"(1 kg)\"\ninertia = { xx = \"(1 kg m^2)\", yy = \"(2 kg m^2)\", zz = \"(2.5 kg m^2)\" }\n\
                [start]\nx = \"guess 0.1 m\"\n\"F.wx\" = \"guess 0.2 rad/s\"\n\"F.wy\" = \"guess 0.3 rad/s\"\n[run]\nspan = \"1 s\"\n";
    let titles = |zeros: &[&str]| -> Vec<String> {
        let constraints: String = zeros.iter().map(|zero| format!("[[constraint]]\nzero = \"{zero}\"\n")).collect();
        let scene = scene(&format!("{body}{constraints}"));
        let warnings = scene.model.warnings.iter().map(|warning| warning.title.clone());
        warnings.map(|title| title.split(" follows").next().unwrap_or_default().to_owned()).collect()
    };
    let moved = "x - (0.5 m)*sin(t*(1 rad/s))";
    assert_eq!(titles(&[moved, "x' - (0.5 m/s)*cos(t*(1 rad/s))"]), ["constraint 2"]);
    assert_eq!(
        titles(&[moved, "2*y*(x - (0.5 m)*sin(t*(1 rad/s))) + x*(1 m) - (0.5 m^2)*sin(t*(1 rad/s))"]),
        ["constraint 2"]
    );
    assert_eq!(titles(&["F.z . N.x", "cross(F.z, N.y) . N.z", "F.wx*(F.x . N.x)"]), ["constraint 2"]);
    assert_eq!(titles(&["F.z . N.x", "F.wx"]), Vec::<String>::new());
}

#[test]
fn members_need_the_same_constraints_to_follow() {
    let vary = |what: &str| format!("{CRANKS}[ensemble]\nmembers = 2\n[ensemble.vary]\n{what}\n");
    let members = |text: &str| parse_ensemble("cranks.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let sound = members(&vary("parameters.r = { values = \"0.3 0.4 m\" }"));
    assert!((1..=2).all(|number| sound.member(number).is_ok()));
    let guessed = vary("parameters.w = { values = \"1 1.01 m\" }").replace(" = \"80 deg\"", " = \"guess 80 deg\"");
    let other = members(&guessed);
    assert!(other.member(1).is_ok());
    let why = other.member(2).err().map(|why| format!("{why:?}")).unwrap_or_default();
    assert!(why.contains("other constraints follow from others"), "{why}");
}

/// The linear equations at 80 degrees: a'' = -g/r cos(a).
#[test]
fn linear_equations_know_the_independent_constraints() {
    let mut model =
        dalembert_scenes::ModelScene::parse("cranks.toml", CRANKS).unwrap_or_else(|error| panic!("{error}")).model;
    let model = std::sync::Arc::make_mut(&mut model);
    model.implied.clear();
    let start = independent_start(model).unwrap_or_else(|issue| panic!("{issue:?}"));
    let equations = VariedEquations::of(model, &[]).expect("it has them");
    let found = equations.linearised(equations.point(0.0, &start)).expect("it is regular");
    assert_eq!(found.a.shape(), (2, 2));
    let values = eigenvalues(&found.a).values;
    let rate = (9.81 / 0.3 * 80_f64.to_radians().sin()).sqrt();
    assert!(values.iter().all(|value| (value.re.abs() - rate).abs() < 1e-9), "{values:?}");
}

/// A plate on three equal cranks whose pivots are not collinear: one of four equations is redundant, whichever comes last. Where the kept ones
/// become dependent, the removed one would be independent.
#[test]
fn a_set_of_constraints_that_loses_its_rank_where_all_keep_it_is_told() {
    let text = |first: &str, second: &str| {
        let pins = [("pin2", "P2 - Q2"), ("pin3", "P3 - Q3")];
        let zero = |name: &str| pins.iter().find(|(own, _)| *own == name).map_or("", |(_, zero)| zero);
        format!(
            "title = \"plate\"\n[parameters]\nr = \"0.1 m\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\nc = \"rad\"\ne = \"rad\"\n\
             [frames]\nA = \"N turned a about z\"\nB = \"N turned b about z\"\nC = \"N turned c about z\"\nE = \"N turned e about z\"\n\
             [points]\nP1 = \"O + r*A.x\"\nP2 = \"P1 + (0.4 m)*B.x\"\nP3 = \"P1 + (0.2 m)*B.x + (0.3 m)*B.y\"\n\
             Q2 = \"O + (0.4 m)*N.x + r*C.x\"\nQ3 = \"O + (0.2 m)*N.x + (0.3 m)*N.y + r*E.x\"\n\
             [bodies.crank]\nframe = \"A\"\ninertia = \"(0.01 kg m^2)\"\n[bodies.second]\nframe = \"C\"\ninertia = \"(0.01 kg m^2)\"\n\
             [bodies.third]\nframe = \"E\"\ninertia = \"(0.01 kg m^2)\"\n\
             [bodies.plate]\nframe = \"B\"\ncentre = \"P1 + (0.2 m)*B.x + (0.1 m)*B.y\"\nmass = \"(1 kg)\"\ninertia = \"(0.02 kg m^2)\"\n\
             [[constraint]]\nname = \"{first}\"\nzero = \"{}\"\n[[constraint]]\nname = \"{second}\"\nzero = \"{}\"\n\
             [start]\na = \"60 deg\"\nb = \"0 rad\"\nc = \"60 deg\"\ne = \"60 deg\"\n\"a'\" = \"2 rad/s\"\n[run]\nspan = \"3 s\"\n",
            zero(first),
            zero(second)
        )
    };
    for (first, second) in [("pin2", "pin3"), ("pin3", "pin2")] {
        let scene = scene(&text(first, second));
        assert_eq!(scene.model.implied.len(), 1);
        let choice = scene.run().choice();
        let left = scene.problem(Axes::First).simulate(&choice, |_| {}).left.expect("it ends");
        assert!(
            left.contains("the constraints that are used become dependent at this position, but the redundant one"),
            "{left}"
        );
    }
}
