//! Outputs with conditions, which do not divide the law into modes.

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene};

const SPRING: &str = "title = \"spring\"\n[parameters]\nk = \"4 N/m\"\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n\
    [points]\nP = \"O + x*N.x\"\n[definitions]\nfar = \"if(x > (0.5 m), 1, 0)\"\n[bodies.b]\ncentre = \"P\"\nmass = \"m\"\n\
    [[force]]\non = \"b\"\nis = \"-k*x*N.x\"\n[outputs]\nsize = \"abs(x)\"\nway = \"sign(x')\"\nis_far = \"far\"\n\
    least = \"min(x, (0.2 m))\"\nline = \"table(x, (-1 m), 0, (1 m), 2)\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"2 s\"\n";

#[test]
fn conditions_of_outputs_alone_do_not_change_the_law() {
    let scene = ModelScene::parse("scene.toml", SPRING).unwrap_or_else(|error| panic!("{error}"));
    assert!(scene.model.switches.is_empty());
    for method in [Method::DormandPrince8, Method::Taylor, Method::Radau5] {
        let choice = Choice { method, tolerance: 1e-11, ..scene.run().choice() };
        let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
        assert!(trajectory.passages.is_empty());
        for (time, row) in trajectory.times.iter().zip(&trajectory.rows).skip(1) {
            let at = |name: &str| row[trajectory.column(name).unwrap()];
            let (x, speed) = ((2.0 * time).cos(), -2.0 * (2.0 * time).sin());
            assert!((at("size") - x.abs()).abs() < 1e-8, "{method:?} {time}");
            assert_eq!(at("way"), speed.signum(), "{time}");
            assert_eq!(at("is_far"), f64::from(u8::from(x > 0.5)), "{time}");
            assert!((at("least") - x.min(0.2)).abs() < 1e-8 && (at("line") - (x + 1.0)).abs() < 1e-8, "{time}");
        }
    }
}

/// At equality `<=` and `>=` hold, `<` and `>` do not, and the sign of zero is zero.
#[test]
fn conditions_of_outputs_are_decided_at_equality() {
    let outputs = "[outputs]\nat_least = \"if(t >= (0 s), 1, 2)\"\nat_most = \"if(x <= (1 m), 1, 2)\"\nabove = \"if(x > (1 m), 1, 2)\"\n\
        below = \"if(t < (0 s), 1, 2)\"\nsigned = \"sign(x')\"\n";
    let text = SPRING.replace("[outputs]\n", outputs);
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    let choice = scene.run().choice();
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    let first = |name: &str| trajectory.rows[0][trajectory.column(name).unwrap()];
    let names = ["at_least", "at_most", "above", "below", "signed"];
    assert_eq!(names.map(first), [1.0, 1.0, 2.0, 2.0, 0.0]);
}

/// While friction sticks, the output shows the factor of the condition at which the forces balance.
#[test]
fn a_condition_of_the_law_stays_one_in_outputs() {
    let text = SPRING.replace("-k*x*N.x", "(-k*x - (1 N)*sign(x'))*N.x");
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.model.switches.len(), 1);
}

/// A heavy top with an oblique inertia tensor about its fixed point, in a free frame.
const TOP: &str = r#"
title = "A heavy top"
gravity = "-g*N.z"
[parameters]
m = "2 kg"
l = "0.1 m"
g = "9.81 m/s^2"
[frames]
F = "N free"
[bodies.top]
frame = "F"
centre = "O + l*F.z"
mass = "m"
[bodies.top.inertia]
xx = "(0.03 kg m^2)"
yy = "(0.03 kg m^2)"
zz = "(0.01 kg m^2)"
[bodies.bob]
centre = "O + l*F.x"
mass = "m/4"
[start]
F = "60 deg about x, then 20 deg about y"
"F.wx" = "1 rad/s"
"F.wz" = "40 rad/s"
[outputs]
vertical = "(angular_momentum(top, O) + angular_momentum(bob, O)) . N.z"
own = "(angular_momentum(top, O) + angular_momentum(bob, O)) . F.y"
from_energy = "momentum(F.wy)"
about_centre = "angular_momentum(top) . F.z - (0.01 kg m^2)*(angular_velocity(top) . F.z)"
[run]
span = "1 s"
"#;

#[test]
fn momenta_of_bodies_are_those_of_the_energy() {
    let scene = ModelScene::parse("scene.toml", TOP).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { tolerance: 1e-12, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    let column = |name: &str| trajectory.column(name).unwrap_or_else(|| panic!("{name}"));
    let (vertical, own, of_energy) = (column("vertical"), column("own"), column("from_energy"));
    let first = trajectory.rows[0][vertical];
    assert!(first.abs() > 0.1, "{first}");
    for row in &trajectory.rows {
        // gravity has no torque about the vertical through the fixed point
        assert!((row[vertical] - first).abs() < 1e-10 * first.abs(), "{first} {}", row[vertical]);
        assert!((row[own] - row[of_energy]).abs() < 1e-13, "{} {}", row[own], row[of_energy]);
        assert!(row[column("about_centre")].abs() < 1e-13);
    }
}

#[test]
fn a_momentum_of_a_body_has_a_body_and_a_point() {
    let refused = |from: &str, to: &str| {
        let text = TOP.replace(from, to);
        ModelScene::parse("scene.toml", &text).err().map(|error| error.to_string()).unwrap_or_default()
    };
    let output = "angular_momentum(top) . F.z - (0.01 kg m^2)*(angular_velocity(top) . F.z)";
    assert!(refused(output, "angular_momentum(O, top) . F.z").contains("a body has an angular momentum"));
    assert!(refused(output, "angular_momentum(top, N.x) . F.z").contains("the second argument is a point"));
    let force = "[[force]]\non = \"bob\"\nis = \"(1 1/s)*momentum(bob)\"\n[start]";
    assert!(refused("[start]", force).contains("`momentum` stands in [outputs] only"));
}
