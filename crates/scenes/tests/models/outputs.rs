//! Outputs with their own conditions, which do not split the law into modes.

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

/// The friction that sticks is shown by the value that holds it.
#[test]
fn a_condition_of_the_law_stays_one_in_outputs() {
    let text = SPRING.replace("-k*x*N.x", "(-k*x - (1 N)*sign(x'))*N.x");
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.model.switches.len(), 1);
}
