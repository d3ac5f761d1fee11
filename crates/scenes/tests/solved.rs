//! Systems whose accelerations are solved for numerically at each evaluation.

use dalembert_scenes::{ModelScene, parse_ensemble};
use field::DoubleDouble;
use integrators::{Jacobian, Method, Ode, System};
use simulation::{Choice, IvpScene, Trajectory};
use std::ops::ControlFlow;

fn runs(text: &str, method: Method, tolerance: f64) -> Trajectory {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method, tolerance, ..scene.run().choice() };
    scene.problem(choice.axes).simulate(&choice, |_| {})
}

/// A chain of links of one metre with point masses at their ends, hanging from the origin, the first link raised.
fn chain(links: usize) -> String {
    let mut text =
        "title = \"chain\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\n".to_owned();
    let lines =
        |head: &str, of: &dyn Fn(usize) -> String| format!("[{head}]\n{}", (1..=links).map(of).collect::<String>());
    text += &lines("coordinates", &|k| format!("a{k} = \"rad\"\n"));
    text += &lines("frames", &|k| format!("A{k} = \"N turned a{k} about z\"\n"));
    text += &lines("points", &|k| {
        let from = if k == 1 { "O".to_owned() } else { format!("P{}", k - 1) };
        format!("P{k} = \"{from} - l*A{k}.y\"\n")
    });
    text += &lines("bodies", &|k| format!("B{k} = {{ centre = \"P{k}\", mass = \"m\" }}\n"));
    text + "[start]\na1 = \"0.5 rad\"\n[run]\nspan = \"1 s\"\n"
}

#[test]
fn a_chain_of_fifty_links_keeps_its_energy() {
    for (method, tolerance) in [(Method::DormandPrince8, 1e-9), (Method::Taylor, 1e-12)] {
        let trajectory = runs(&chain(50), method, tolerance);
        assert_eq!(trajectory.stopped(), None);
        let [energy] = trajectory.outcome.deviations.as_slice() else { panic!("the energy is watched") };
        assert!(energy.largest < 1e3 * tolerance * energy.first.abs(), "{method:?}: {energy:?}");
    }
}

#[test]
fn series_and_single_steps_of_a_long_chain_have_one_end() {
    let text = chain(45);
    let [series, steps] = [(Method::Taylor, 1e-13), (Method::DormandPrince8, 1e-12)].map(|(method, tolerance)| {
        let trajectory = runs(&text, method, tolerance);
        assert_eq!(trajectory.stopped(), None);
        trajectory.last
    });
    for (series, steps) in series.iter().zip(&steps) {
        assert!((series - steps).abs() < 1e-8 * steps.abs().max(1.0), "{series} is not {steps}");
    }
}

/// Difference quotients of the rates by the components of the state, and by time.
fn differences(law: &dyn System, t: f64, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (n, h) = (y.len(), DoubleDouble::from(1e-10));
    let rates = |t: DoubleDouble, y: &[DoubleDouble]| {
        let mut rates = vec![DoubleDouble::from(0.0); n];
        Ode::<DoubleDouble>::rates(law, t, y, &mut rates);
        rates
    };
    let at = y.iter().map(|&y| DoubleDouble::from(y)).collect::<Vec<_>>();
    let t = DoubleDouble::from(t);
    let between = |after: Vec<DoubleDouble>, before: Vec<DoubleDouble>| {
        let pairs = after.into_iter().zip(before);
        pairs.map(|(after, before)| ((after - before) / (h + h)).hi()).collect::<Vec<f64>>()
    };
    let mut matrix = vec![0.0; n * n];
    for column in 0..n {
        let moved = |by: DoubleDouble| {
            let mut moved = at.clone();
            moved[column] += by;
            rates(t, &moved)
        };
        let slopes = between(moved(h), moved(-h));
        slopes.iter().enumerate().for_each(|(row, slope)| matrix[row * n + column] = *slope);
    }
    (matrix, between(rates(t + h, &at), rates(t - h, &at)))
}

#[test]
fn the_jacobian_with_one_factorisation_is_that_of_differences() {
    let moved = MASSLESS.replace("is = \"-k*x*N.x\"", "is = \"-k*x^2*sin((3 1/s)*t)*x'*(1 s/m^2)*N.x\"");
    for (text, state) in [(chain(41), None), (moved, Some(vec![0.4, 3.0 * 0.4_f64.sin(), 0.7, -0.6]))] {
        let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
        let problem = scene.problem(scene.run().choice().axes);
        let state = state.unwrap_or_else(|| (0..problem.state.len()).map(|k| (k as f64).sin()).collect());
        let (n, t) = (state.len(), 0.3);
        let mut jacobian = Jacobian::of(&*problem.law);
        let (mut matrix, mut by_time) = (vec![0.0; n * n], vec![0.0; n]);
        jacobian.matrix(t, &state, &mut matrix);
        jacobian.time_derivatives(t, &state, &mut by_time);
        let (differences, differences_by_time) = differences(&*problem.law, t, &state);
        for (own, other) in matrix.iter().zip(&differences).chain(by_time.iter().zip(&differences_by_time)) {
            assert!((own - other).abs() < 1e-9 * other.abs().max(1.0), "{own} is not {other}");
        }
        assert!(differences.iter().any(|slope| slope.abs() > 1e-2));
    }
}

/// A slider moved by a massless arm: theta has no inertia, and the constraint couples it with x.
const MASSLESS: &str = r#"
title = "A massless arm"
[parameters]
m = "2 kg"
k = "8 N/m"
r = "3 m"
[coordinates]
theta = "rad"
x = "m"
[bodies.slider]
centre = "O + x*N.x"
mass = "m"
[[force]]
on = "slider"
is = "-k*x*N.x"
[[constraint]]
zero = "x - r*sin(theta)"
[outputs]
pull = "m*x''"
[start]
x = "1 m"
[run]
span = "3 s"
"#;

#[test]
fn a_coordinate_without_inertia_moves_with_what_holds_it() {
    for method in [Method::DormandPrince8, Method::Radau5, Method::Taylor] {
        let trajectory = runs(MASSLESS, method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let at = |name: &str| trajectory.last[trajectory.column(name).unwrap()];
        let x = 6f64.cos();
        assert!((at("x") - x).abs() < 1e-8, "{method:?}: {}", at("x"));
        assert!((3.0 * at("theta").sin() - x).abs() < 1e-8);
        assert!((at("pull") + 8.0 * x).abs() < 1e-6);
    }
}

/// Without inertia lambda (-r cos(theta)) + T = 0.
#[test]
fn the_reaction_on_a_coordinate_without_inertia_balances_the_force_along_it() {
    let text = MASSLESS
        .replacen(
            "[outputs]",
            "[[force]]\nalong = \"theta\"\nis = \"(0.6 N m)\"\n[outputs]\nlambda = \"reaction(rod)\"",
            1,
        )
        .replacen("[[constraint]]", "[[constraint]]\nname = \"rod\"", 1)
        .replacen("span = \"3 s\"", "span = \"0.2 s\"", 1);
    let trajectory = runs(&text, Method::DormandPrince8, 1e-11);
    assert_eq!(trajectory.stopped(), None);
    let at = |name: &str| trajectory.last[trajectory.column(name).unwrap()];
    assert!((at("lambda") - 0.6 / (3.0 * at("theta").cos())).abs() < 1e-9, "{}", at("lambda"));
}

#[test]
fn members_of_an_ensemble_are_solved_for_too() {
    let vary = "[ensemble]\nmembers = 11\n[ensemble.vary]\nparameters.k = { from = \"4 N/m\", to = \"9 N/m\" }\n";
    let scene = parse_ensemble("scene.toml", &format!("{MASSLESS}{vary}")).unwrap_or_else(|error| panic!("{error}"));
    let mut rows = Vec::new();
    scene.run(1..=11, 2, |row| {
        rows.push(row);
        ControlFlow::Continue(())
    });
    for row in &rows {
        let (k, last) = (row.drawn[0], row.last.as_ref().unwrap_or_else(|| panic!("{row:?}")));
        let x = (3.0 * (k / 2.0).sqrt()).cos();
        assert!((last.state[1] - x).abs() < 1e-7, "{k}: {:?}", last.state);
        // this output, the force on the slider, contains the acceleration
        assert!((last.derived[0].unwrap() + k * x).abs() < 1e-6, "{k}: {:?}", last.derived);
    }
    assert_eq!(rows.len(), 11);
}

#[test]
fn a_long_chain_has_members_of_its_own() {
    let vary = "[ensemble]\nmembers = 3\n[ensemble.vary]\nparameters.m = { from = \"0.5 kg\", to = \"2 kg\" }\n";
    let scene =
        parse_ensemble("scene.toml", &format!("{}{vary}", chain(41).replace("span = \"1 s\"", "span = \"0.1 s\"")));
    let scene = scene.unwrap_or_else(|error| panic!("{error}"));
    let mut ends = Vec::new();
    scene.run(1..=3, 1, |row| {
        ends.push(row.last.unwrap_or_else(|| panic!("it arrives")).state);
        ControlFlow::Continue(())
    });
    // the motion does not depend on the common mass
    for end in &ends[1..] {
        assert!(end.iter().zip(&ends[0]).all(|(own, first)| (own - first).abs() < 1e-9));
    }
    assert!((ends[0][0] - 0.5).abs() > 1e-3);
}

#[test]
fn a_coordinate_that_nothing_holds_is_refused() {
    let text = MASSLESS.replace("zero = \"x - r*sin(theta)\"", "zero = \"x - (1 m)\"");
    let error = ModelScene::parse("scene.toml", &text).unwrap_err().to_string();
    assert!(error.contains("nothing with a mass or an inertia moves with `theta`"), "{error}");
}
