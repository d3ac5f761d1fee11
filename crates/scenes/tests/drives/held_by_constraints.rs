//! Point masses on a knife edge: the rotation has no inertia, and the constraint determines it.

use super::{last, runs};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene};

/// A point mass at the distance b ahead of a knife edge; `body` are further keys of the body.
fn trolley(body: &str, damping: &str, heading: f64) -> String {
    format!(
        "title = \"trolley\"\n[parameters]\nm = \"30 kg\"\nb = \"0.4 m\"\nJ = \"0 kg m^2\"\nd = \"{damping} N m s\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\npsi = \"rad\"\n[frames]\nB = \"N turned psi about z\"\n\
         [points]\nA = \"O + x*N.x + y*N.y\"\nG = \"A + b*B.x\"\n[bodies.cart]\ncentre = \"G\"\nmass = \"m\"\n{body}\
         [[force]]\nalong = \"psi\"\nis = \"-d*psi'\"\n[[constraint]]\nname = \"edge\"\nzero = \"velocity(A) . B.y\"\n\
         [start]\npsi = \"{heading} rad\"\n\"x'\" = \"guess 0.1 m/s\"\n\"psi'\" = \"0.5 rad/s\"\n[run]\nspan = \"2 s\"\n"
    )
}

/// With the speed v of the edge and w = psi', m (v' - b w^2) = 0 and m b (b w' + v w) = 0: v^2 + (b w)^2 is constant.
#[test]
fn a_point_mass_ahead_of_a_knife_edge_keeps_its_speed() {
    for (body, heading) in [("", 0.0), ("", 0.3), ("frame = \"B\"\ninertia = \"J\"\n", 0.0)] {
        let text = trolley(body, "0", heading);
        let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
        let first = scene.start[3].hypot(scene.start[4]);
        let size = first.hypot(0.4 * 0.5);
        for method in [Method::DormandPrince8, Method::Radau5, Method::Taylor] {
            let choice = Choice { method, tolerance: 1e-11, ..scene.run().choice() };
            let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
            assert_eq!(trajectory.stopped(), None, "{method:?}");
            assert!(trajectory.outcome.work.steps < 20_000, "{method:?}: {:?}", trajectory.outcome.work);
            let [psi, dx, dy, w] = ["psi", "x'", "y'", "psi'"].map(|name| last(&trajectory, name));
            let (v, aside) = (dx * psi.cos() + dy * psi.sin(), dy * psi.cos() - dx * psi.sin());
            assert!(aside.abs() < 1e-9, "{method:?}: {aside}");
            assert!((v.hypot(0.4 * w) - size).abs() < 1e-8, "{method:?}: {v}, {w}");
            // w = (s/b) / cosh(s (t - t0)/b), v = s tanh(s (t - t0)/b)
            let before = (first * scene.start[3].signum() / size).atanh() - 2.0 * size / 0.4;
            let later = (v / size).atanh();
            let shown = (later - before - 4.0 * size / 0.4).abs();
            assert!(shown < 1e-6, "{method:?}: {shown}");
        }
    }
}

#[test]
fn a_small_inertia_leads_to_the_motion_without_one() {
    let body = "frame = \"B\"\ninertia = \"J\"\n";
    let [none, small] = ["0 kg m^2", "1e-6 kg m^2"]
        .map(|inertia| runs(&trolley(body, "1", 0.0).replace("J = \"0 kg m^2\"", &format!("J = \"{inertia}\""))));
    for name in ["x", "y", "psi", "psi'"] {
        let [none, small] = [&none, &small].map(|trajectory| last(trajectory, name));
        assert!((none - small).abs() < 1e-5 && none != small, "{name}: {none} and {small}");
    }
}

/// The rotation moves no mass, violates no constraint and is not acted on by a force: it is undetermined.
#[test]
fn a_turn_that_no_equation_determines_is_refused() {
    let text = trolley("frame = \"B\"\ninertia = \"J\"\n", "0", 0.0).replace("A + b*B.x", "A");
    let said = ModelScene::parse("scene.toml", &text).expect_err("psi is not determined").to_string();
    assert!(said.contains("nothing with a mass or an inertia moves with `psi`"), "{said}");
    assert!(said.contains("`J` is zero"), "{said}");
    let two = text
        .replace("[[constraint]]\nname = \"edge\"\nzero = \"velocity(A) . B.y\"\n", "")
        .replace("\"A\"", "\"A + b*B.x\"");
    let said = ModelScene::parse("scene.toml", &two).expect_err("a point has two speeds").to_string();
    assert!(said.contains("together"), "{said}");
}
