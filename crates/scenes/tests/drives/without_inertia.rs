//! Coordinates without inertia: circuits without inductances, dampers and springs in series, compared with closed forms.

use super::{close, last, runs};
use dalembert_scenes::ModelScene;
use dalembert_scenes::linearisation::VariedEquations;

const RC: &str = "title = \"RC\"\n[parameters]\nU = \"10 V\"\nR = \"1 kohm\"\nC = \"1 mF\"\n[coordinates]\nq = \"C\"\n\
    [energies]\npotential = \"q^2/(2*C)\"\ndissipation = \"R/2*q'^2\"\n[[force]]\nalong = \"q\"\nis = \"U\"\n[run]\nspan = \"3 s\"\n";

#[test]
fn a_capacitor_is_charged_through_a_resistor() {
    let trajectory = runs(RC);
    close(last(&trajectory, "q"), 0.01 * (1.0 - (-3.0_f64).exp()), 1e-11);
    close(last(&trajectory, "q'"), 0.01 * (-3.0_f64).exp(), 1e-11);
    let driven = runs(&RC.replace("is = \"U\"", "is = \"U*sin((1 rad/s)*t)\""));
    // q' + q = sin t in units of C U and R C
    let exact = 0.005 * (3.0_f64.sin() - 3.0_f64.cos() + (-3.0_f64).exp());
    close(last(&driven, "q"), exact, 1e-11);
}

/// Kirchhoff's current law at the node leaves two independent loops.
#[test]
fn branches_at_a_node_have_the_laws_of_their_loops() {
    let text = "title = \"node\"\n[parameters]\nU = \"10 V\"\nR1 = \"1 kohm\"\nR2 = \"2 kohm\"\nC = \"1 mF\"\n\
        [coordinates]\nq1 = \"C\"\nq2 = \"C\"\nq3 = \"C\"\n[energies]\npotential = \"q3^2/(2*C)\"\n\
        dissipation = \"R1/2*q1'^2 + R2/2*q2'^2\"\n[[constraint]]\nzero = \"q1' - q2' - q3'\"\n[[force]]\nalong = \"q1\"\nis = \"U\"\n\
        [run]\nspan = \"2 s\"\n";
    let trajectory = runs(text);
    let (voltage, time) = (10.0 * 2.0 / 3.0, 2.0 / 3.0);
    close(last(&trajectory, "q3"), 1e-3 * voltage * (1.0 - (-2.0_f64 / time).exp()), 1e-11);
    close(last(&trajectory, "q2'"), voltage / 2e3 * (1.0 - (-2.0_f64 / time).exp()), 1e-11);
}

/// J w' = k i with i = (U - k w)/R; the rotor starts at rest, and the current is completed.
#[test]
fn a_motor_without_an_inductance_starts_at_rest() {
    let text = "title = \"motor\"\n[parameters]\nJ = \"1e-3 kg m^2\"\nR = \"0.5 ohm\"\nk = \"0.05 V s\"\nU = \"12 V\"\n\
        [coordinates]\ntheta = \"rad\"\nq = \"C\"\n[bodies.disc]\nturns = \"theta\"\ninertia = \"J\"\n\
        [energies]\ndissipation = \"R/2*q'^2\"\n[[force]]\nalong = \"q\"\nis = \"U - k*theta'\"\n[[force]]\nalong = \"theta\"\nis = \"k*q'\"\n\
        [run]\nspan = \"0.5 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.start[2..], [0.0, 24.0]);
    let trajectory = runs(text);
    close(last(&trajectory, "theta'"), 240.0 * (1.0 - (-2.5_f64).exp()), 1e-9);
    // with the voltage as an input: the current follows at once, the acceleration through the current
    let text = text
        .replace("\"U - k*theta'\"", "\"u - k*theta'\"")
        .replace("[run]", "[inputs]\nu = { unit = \"V\", value = \"U\" }\n[run]");
    let scene = ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"));
    let state = [0.0, 0.0, 0.0, 24.0];
    let equations = VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}"));
    let found = equations.linearised(equations.point(0.0, &state)).unwrap_or_else(|why| panic!("{why}"));
    let row = |matrix: &nalgebra::DMatrix<f64>, place: usize| matrix.row(place).iter().copied().collect::<Vec<f64>>();
    assert_eq!((row(&found.a, 1), row(&found.b, 1)), (vec![0.0, 0.0, -0.1], vec![2.0]));
    close(found.a[(2, 2)], -5.0, 1e-12);
    close(found.b[(2, 0)], 100.0, 1e-12);
}

/// A constant force on a mass with a spring and a damper in series, m x'' = F - k (x - y), c y' = k (x - y); and with two springs in series.
#[test]
fn a_spring_and_a_damper_in_series_hold_a_mass() {
    let element = |potential: &str, dissipation: &str, force: &str, start: &str| {
        runs(&format!(
            "title = \"series\"\n[parameters]\nm = \"1 kg\"\nk = \"100 N/m\"\nc = \"5 N s/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [bodies.block]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[energies]\npotential = \"{potential}\"\n{dissipation}\
             [[force]]\non = \"block\"\nis = \"{force}*N.x\"\n{start}[run]\nspan = \"3 s\"\n"
        ))
    };
    let maxwell = element("k/2*(x - y)^2", "dissipation = \"c/2*y'^2\"\n", "(1 N)", "");
    // the stretch e = x - y satisfies e'' + (k/c) e' + (k/m) e = F/m, with the double root -10/s
    let stretch = |t: f64| 0.01 * (1.0 - (-10.0 * t).exp() * (1.0 + 10.0 * t));
    close(last(&maxwell, "x") - last(&maxwell, "y"), stretch(3.0), 1e-11);
    let springs = element("k/2*(x - y)^2 + 3*k/2*y^2", "", "(0 N)", "[start]\nx = \"0.1 m\"\n");
    close(last(&springs, "x"), 0.1 * (75.0_f64.sqrt() * 3.0).cos(), 1e-10);
    close(last(&springs, "y"), last(&springs, "x") / 4.0, 1e-12);
}

/// A step-down converter of a switch, a diode and a capacitor: the mean voltage is the duty ratio times the supply.
#[test]
fn a_step_down_converter_gives_the_part_of_the_voltage_in_which_its_switch_is_closed() {
    let text = "title = \"converter\"\n[parameters]\nV = \"24 V\"\nL = \"1 mH\"\nLs = \"1 uH\"\nR = \"5 ohm\"\nC = \"100 uF\"\n\
        ron = \"10 mohm\"\nroff = \"10 kohm\"\nw = \"62831.853 rad/s\"\n[coordinates]\nqs = \"C\"\nqd = \"C\"\nq = \"C\"\nqc = \"C\"\n\
        [energies]\ncoenergy = \"Ls/2*qs'^2 + Ls/2*qd'^2 + L/2*q'^2\"\npotential = \"qc^2/(2*C)\"\n\
        dissipation = \"if(sin(w*t) > 0, ron, roff)/2*qs'^2 + R/2*(q' - qc')^2\"\n[[constraint]]\nzero = \"qs' + qd' - q'\"\n\
        [[force]]\nalong = \"qs\"\nis = \"V\"\n[[diode]]\nname = \"D\"\ncurrent = \"qd'\"\n[outputs]\nu = \"qc/C\"\n\
        [run]\nspan = \"0.01 s\"\nmethod = \"radau_5\"\ntolerance = 1e-8\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = simulation::IvpScene::run(&scene).choice();
    let trajectory = simulation::IvpScene::problem(&scene, choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None);
    close(last(&trajectory, "u"), 12.0, 0.1);
}

/// An integral controller: J e'' + kp e' + ki e = 0 for the error e, with the double root -10/s; the disc starts at rest.
#[test]
fn an_integral_of_an_error_is_a_coordinate_without_a_reaction() {
    let text = "title = \"PI\"\n[parameters]\nJ = \"1e-3 kg m^2\"\nkp = \"0.02 N m s\"\nki = \"0.1 N m\"\nw0 = \"100 rad/s\"\n\
        load = \"0.3 N m\"\n[coordinates]\ntheta = \"rad\"\nz = \"rad\"\n[bodies.disc]\nturns = \"theta\"\ninertia = \"J\"\n\
        [inputs]\nu = { unit = \"N m\", value = \"kp*(w0 - theta') + ki*z\" }\n[[constraint]]\nname = \"integral\"\nzero = \"z' - (w0 - theta')\"\n\
        [[torque]]\non = \"disc\"\nis = \"(u - load)*N.z\"\n[outputs]\nback = \"reaction(integral)\"\n[run]\nspan = \"1 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.start[2..], [0.0, 100.0]);
    let trajectory = runs(text);
    close(last(&trajectory, "theta'"), 100.0 + 600.0 * (-10.0_f64).exp(), 1e-9);
    close(last(&trajectory, "back"), 0.0, 1e-12);
}

/// Two capacitors in parallel behind a resistor: their laws contain no speed, a/C1 = b/C2.
#[test]
fn capacitors_in_parallel_share_a_charge() {
    let text = RC
        .replace("q = \"C\"\n", "q = \"C\"\na = \"C\"\nb = \"C\"\n")
        .replace("q^2/(2*C)", "a^2/(2*C) + b^2/(6*C)")
        .replace("[run]", "[[constraint]]\nzero = \"q' - a' - b'\"\n[run]");
    let trajectory = runs(&text);
    // the sum of capacitances is 4 C
    let voltage = 10.0 * (1.0 - (-0.75_f64).exp());
    close(last(&trajectory, "a"), 1e-3 * voltage, 1e-11);
    close(last(&trajectory, "b"), 3e-3 * voltage, 1e-11);
    let emptied =
        runs(&text.replace(
            "[run]",
            "[[event]]\nwhen = \"t - (1 s)\"\nset = { q = \"0*q\", a = \"0*a\", b = \"0*b\" }\n[run]",
        ));
    close(last(&emptied, "a"), 0.01 * (1.0 - (-0.5_f64).exp()), 1e-10);
}

#[test]
fn a_coordinate_without_a_law_is_refused_by_its_name() {
    let none = RC.replace("[coordinates]\n", "[coordinates]\nb = \"m\"\n");
    let said = ModelScene::parse("scene.toml", &none).expect_err("b has no law").to_string();
    assert!(said.contains("moves with `b`"), "{said}");
}

#[test]
fn a_coordinate_that_nothing_resists_is_still_refused() {
    let nothing = RC.replace("potential = \"q^2/(2*C)\"\ndissipation = \"R/2*q'^2\"\n", "potential = \"(1 J)\"\n");
    let said = ModelScene::parse("scene.toml", &nothing).expect_err("no law").to_string();
    assert!(said.contains("nothing with a mass or an inertia moves with `q`"), "{said}");
}
