//! Systems whose accelerations are solved for at each evaluation.

use derivations::scene::{Choice, Smooth, Trajectory};
use integrators::Method;
use scenes::ModelScene;

fn runs(text: &str, method: Method, tolerance: f64) -> Trajectory {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method, tolerance, ..scene.run().choice() };
    scene.problem(choice.axes).simulate(&choice, |_| {})
}

/// Links of one metre with point masses at their ends, hanging from the origin, the first one raised.
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
    let trajectory = runs(&chain(50), Method::DormandPrince8, 1e-9);
    assert_eq!(trajectory.stopped(), None);
    let [energy] = trajectory.outcome.deviations.as_slice() else { panic!("the energy is watched") };
    assert!(energy.largest < 1e-6 * energy.first.abs(), "{energy:?}");
}

/// A slider that is moved by a massless arm: theta carries nothing, the constraint ties it to x.
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
    for method in [Method::DormandPrince8, Method::Radau5] {
        let trajectory = runs(MASSLESS, method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let at = |name: &str| trajectory.last[trajectory.column(name).unwrap()];
        let x = 6f64.cos();
        assert!((at("x") - x).abs() < 1e-8, "{method:?}: {}", at("x"));
        assert!((3.0 * at("theta").sin() - x).abs() < 1e-8);
        assert!((at("pull") + 8.0 * x).abs() < 1e-6);
    }
}

#[test]
fn a_coordinate_that_nothing_holds_is_refused() {
    let text = MASSLESS.replace("zero = \"x - r*sin(theta)\"", "zero = \"x - (1 m)\"");
    let error = ModelScene::parse("scene.toml", &text).unwrap_err().to_string();
    assert!(error.contains("nothing with a mass or an inertia moves with `theta`"), "{error}");
}
