//! Quasi-velocities of a file: completed starts, columns of runs, members, equilibria, linear equations.

use dalembert_scenes::linearisation::VariedEquations;
use dalembert_scenes::{ModelScene, equilibrium_of, parse_ensemble};
use integrators::Method;
use model::{QuasiPrinciple, QuasiVelocities, Trace, quasi_agreement};
use simulation::{Axes, IvpScene};

const SLEIGH: &str = r#"
title = "Chaplygin's sleigh"
[parameters]
m = "1 kg"
J = "0.1 kg m^2"
a = "0.1 m"
c = "0 N s/m"
[coordinates]
x = "m"
y = "m"
psi = "rad"
[speeds]
v = "velocity(P) . B.x"
w = "psi'"
[frames]
B = "N turned psi about z"
[points]
P = "O + x*N.x + y*N.y"
G = "P + a*B.x"
[bodies.sleigh]
frame = "B"
centre = "G"
mass = "m"
inertia = "J"
[[force]]
on = "sleigh at P"
is = "-c*v*B.x"
[[constraint]]
name = "edge"
zero = "velocity(sleigh at P) . B.y"
[outputs]
gain = "v' - a*w^2"
[start]
psi = "30 deg"
v = "1.5 m/s"
w = "0.8 rad/s"
[run]
span = "1 s"
tolerance = 1e-12
"#;

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("sleigh.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(text: &str) -> String {
    ModelScene::parse("sleigh.toml", text).err().map_or_else(String::new, |error| error.to_string())
}

fn with(from: &str, to: &str) -> String {
    assert_eq!(SLEIGH.matches(from).count(), 1, "`{from}` must stand once");
    SLEIGH.replace(from, to)
}

/// With k^2 = m a^2/(J + m a^2) the sum v^2 + (a/k)^2 w^2 is constant, and the ratio of v and w follows from
/// w' = -k^2/a v w.
#[test]
fn a_run_from_quasi_velocities_is_the_closed_form() {
    let scene = scene(SLEIGH);
    let circle = std::f64::consts::FRAC_PI_6.sin_cos();
    let known = [0.0, 0.0, std::f64::consts::FRAC_PI_6, 1.5 * circle.1, 1.5 * circle.0, 0.8];
    for (own, known) in scene.start.iter().zip(known) {
        assert!((own - known).abs() < 1e-14, "{:?}", scene.start);
    }
    let columns = scene.problem(Axes::First).columns;
    assert_eq!(columns[6..], ["v", "w", "gain", "kinetic_energy", "potential_energy"]);
    assert_eq!((&*scene.unit("v"), &*scene.unit("gain")), ("m/s", "m/s^2"));
    let (last, _) = super::end(&scene, Method::DormandPrince8, 1e-12);
    let [m, j, a]: [f64; 3] = [1.0, 0.1, 0.1];
    let k = (m * a * a / (j + m * a * a)).sqrt();
    let energy = (1.5_f64.powi(2) + (a / k * 0.8).powi(2)).sqrt();
    // v = E tanh(k E t/a + b), a w/k = E/cosh(...)
    let phase = k * k * energy / a + (1.5 / energy).atanh();
    assert!((last[6] - energy * phase.tanh()).abs() < 1e-9, "{last:?}");
    assert!((last[7] - k / a * energy / phase.cosh()).abs() < 1e-9, "{last:?}");
    assert!(last[8].abs() < 1e-9, "{last:?}");
}

#[test]
fn starts_that_contradict_quasi_velocities_are_refused_there() {
    let clash = refused(&with("[start]\n", "[start]\n\"x'\" = \"1 m/s\"\n\"y'\" = \"0.1 m/s\"\n"));
    assert!(clash.contains("constraint 1 `edge` does not hold at the start"), "{clash}");
    let clash = refused(&with("[start]\n", "[start]\n\"psi'\" = \"1 rad/s\"\n"));
    assert!(clash.contains("the value of `w` in [start] does not hold at the start"), "{clash}");
    for (value, parts) in [
        ("guess 1 m/s", "guesses are of coordinates and their rates"),
        ("1 rad/s", "this has the dimension s^-1"),
        ("fast", "such as \"0.3 m/s\""),
    ] {
        let found = refused(&with("v = \"1.5 m/s\"", &format!("v = \"{value}\"")));
        assert!(found.contains(parts) && found.contains("the start of the quasi-velocity `v`"), "{found}");
    }
    let event = "[[event]]\nwhen = \"psi - 1\"\nset = { v = \"0\" }\n[outputs]";
    let found = refused(&with("[outputs]", event));
    assert!(found.contains("`v` is a quasi-velocity") && found.contains("its rate such as x'"), "{found}");
    let found = refused(&with("gain = ", "v = \"w*(1 m)\"\ngain = "));
    assert!(found.contains("the output `v` has the name of a quasi-velocity"), "{found}");
    assert_eq!(refused(&with("gain = ", "v = \"v\"\ngain = ")), "");
    let found = refused(&with("w = \"psi'\"", "psi = \"psi'\"\nw = \"psi'\""));
    assert!(found.contains("`psi` is defined twice"), "{found}");
}

#[test]
fn members_equilibria_and_linear_equations_take_quasi_velocities() {
    let vary = "[ensemble]\nmembers = 2\n[ensemble.vary]\nstart.v = { values = \"1 2 m/s\" }\nparameters.a = { values = \"0.1 0.2 m\" }";
    let members = parse_ensemble("sleigh.toml", &format!("{SLEIGH}{vary}")).unwrap_or_else(|error| panic!("{error}"));
    for (number, v) in [(1, 1.0_f64), (2, 2.0)] {
        let member = members.member(number).unwrap_or_else(|why| panic!("{why:?}"));
        let [.., x, y, _] = member.state[..] else { panic!("six numbers") };
        assert!((x.hypot(y) - v).abs() < 1e-14, "{:?}", member.state);
    }
    let resting = with("v = \"1.5 m/s\"\nw = \"0.8 rad/s\"", "v = \"0 m/s\"\nequilibrium = true");
    assert!(equilibrium_of(&scene(&resting).model).is_ok());
    let moving = refused(&with("[start]\n", "[start]\nequilibrium = true\n"));
    assert!(moving.contains("an equilibrium has no speeds") && moving.contains("v is not zero"), "{moving}");
    let scene = scene(SLEIGH);
    let equations = VariedEquations::of(&scene.model, &[]).expect("it has them");
    let found = equations.linearised(equations.point(0.0, &scene.start)).expect("it is regular");
    assert_eq!(found.c.nrows(), 3);
}

#[test]
fn hamel_and_maggi_take_a_kinetic_energy_and_the_others_say_why_not() {
    let text = SLEIGH.split("[bodies.sleigh]").next().expect("it begins").to_owned()
        + "[energies]\nkinetic = \"m/2*(velocity(G) . velocity(G)) + J/2*psi'^2\"\n"
        + "[[constraint]]\nzero = \"velocity(P) . B.y\"\n[start]\nv = \"1 m/s\"\n[run]\nspan = \"1 s\"\n";
    let scene = scene(&text);
    symbolic::apart(|| {
        let trace = Trace::of(&scene.model);
        let quasi = QuasiVelocities::of(&trace).expect("they are independent");
        let found = quasi_agreement(&quasi, QuasiPrinciple::Maggi, QuasiPrinciple::Hamel).expect("it applies");
        assert_eq!(found.degree(), "proved", "{found}");
        for principle in [QuasiPrinciple::VirtualPower, QuasiPrinciple::Appell] {
            let why = principle.residual(&quasi).expect_err("it knows no bodies").to_string();
            assert!(why.contains("a kinetic energy is given"), "{why}");
        }
    });
}

/// A board on two wheels that are steered in opposite directions: it moves straight ahead, and its speed in y would be a rounding error.
#[test]
fn a_completed_start_shows_no_rounding() {
    let text = "title = \"A board on two wheels\"\n[parameters]\nm = \"4 kg\"\nJ = \"0.1 kg m^2\"\nl = \"0.3 m\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\nth = \"rad\"\nf = \"rad\"\nb = \"rad\"\n\
        [speeds]\ns = \"velocity(G) . B.x\"\nwf = \"f'\"\nwb = \"b'\"\n\
        [frames]\nB = \"N turned th about z\"\nF = \"B turned f about z\"\nR = \"B turned b about z\"\n\
        [points]\nG = \"O + x*N.x + y*N.y\"\nPF = \"G + l*B.x\"\nPB = \"G - l*B.x\"\n\
        [bodies.board]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"J\"\n\
        [bodies.front]\nframe = \"F\"\ncentre = \"PF\"\nmass = \"m/8\"\ninertia = \"J/10\"\n\
        [bodies.back]\nframe = \"R\"\ncentre = \"PB\"\nmass = \"m/8\"\ninertia = \"J/10\"\n\
        [[constraint]]\nzero = \"velocity(PF) . F.y\"\n[[constraint]]\nzero = \"velocity(PB) . R.y\"\n\
        [start]\nf = \"0.3 rad\"\nb = \"-0.3 rad\"\ns = \"0.2 m/s\"\n[run]\nspan = \"1 s\"\n";
    let path = std::env::temp_dir().join(format!("dalembert_{}_board.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let completed = dalembert_scenes::completed_start(&path);
    std::fs::remove_file(&path).expect("it is there");
    let names: Vec<&str> = completed.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["x'", "th'"], "{completed:?}");
}
