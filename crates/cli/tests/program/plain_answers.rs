//! Results that claim no more and no less than is known, for motions that end, come to rest, or are degenerate.

use super::{json, run, temporary};
use std::process::Output;

/// Runs a command on two masses of 1 kg with parameters and further tables.
fn asked(name: &str, parameters: &str, rest: &str, words: &[&str]) -> Output {
    let file = temporary(&format!("{name}.toml"));
    let text = format!(
        "title = \"A mass\"\n[parameters]\nm = \"1 kg\"\n{parameters}[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x\"\n\
         mass = \"m\"\n[bodies.b]\ncentre = \"O + y*N.x\"\nmass = \"m\"\n{rest}"
    );
    std::fs::write(&file, text).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    let output = run(&[&[words[0], &path], &words[1..]].concat());
    std::fs::remove_file(&file).expect("it is there");
    output
}

fn text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// x' = -sqrt(x) has the solution x = (1 - t/2)^2 up to t = 2; the Taylor series of x continues beyond as a growing parabola.
#[test]
fn every_method_ends_where_a_tank_is_empty() {
    let tank = "[[constraint]]\nzero = \"x' + sqrt(x*(1 m/s^2))\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"400 s\"\n";
    for method in ["taylor", "dormand_prince_8", "radau_5", "rodas_4"] {
        let output = asked("tank", "", tank, &["run", "--method", method, "--format", "json"]);
        let found = json(&output);
        let failure = &found["failures"][0];
        assert_eq!(failure["kind"], "end of the domain of the law", "{method}: {found}");
        // the tank is empty after 2 s
        let at = failure["at"].as_f64().expect("a time");
        assert!((at - 2.0).abs() < 0.2, "{method}: {found}");
        let work = found["work"]["evaluations"].as_u64().expect("a number");
        assert!(work < 5_000, "{method}: {work}");
    }
}

#[test]
fn springs_that_are_all_rigid_leave_masses_at_rest_with_no_energy_to_lose() {
    let springs = "[energies]\npotential = \"K/2*(y - x)^2 + k/2*x^2\"\n[start]\nx = \"0.1 m\"\ny = \"0.1 m\"\n\"y'\" = \"1 m/s\"\n[run]\nspan = \"5 s\"\n";
    let parameters = "K = \"1e7 N/m\"\nk = \"50 N/m\"\n";
    for model in ["rigid k, K", "rigid K"] {
        let output = asked("rigid", parameters, springs, &["run", "--model", model]);
        let told = text(&output);
        assert!(
            output.status.success() && told.contains("changed by at most") && !told.contains("lost"),
            "{model}: {told}"
        );
    }
}

#[test]
fn the_drift_of_a_damped_motion_is_told_of_what_is_kept() {
    let damped = "[[force]]\non = \"a\"\nis = \"(-(25 N/m)*x - (2 N s/m)*x')*N.x\"\n[[force]]\non = \"b\"\nis = \"(-(25 N/m)*y)*N.x\"\n\
        [start]\nx = \"0.1 m\"\n[run]\nspan = \"30 s\"\n";
    let output = asked("damped", "", damped, &["numerical-stability", "--drift", "--steps", "100"]);
    let told = text(&output);
    assert!(output.status.success(), "{told}");
    assert!(told.contains("the energy alone is not kept, the energy less this work is"), "{told}");
    assert!(
        told.contains("does not return to its start within the span of 30 s") && told.contains("energy less work"),
        "{told}"
    );
}

/// x^3 = 0 and y^3 = 0: one solution, with a zero Jacobian.
#[test]
fn a_degenerate_steady_motion_is_told_as_that() {
    let cubes = "[[force]]\non = \"a\"\nis = \"-(1 N/m^3)*x^3*N.x\"\n[[force]]\non = \"b\"\nis = \"(1 N/m^3)*y^3*N.x\"\n[run]\nspan = \"1 s\"\n";
    let output = asked("cubes", "", cubes, &["stationary", "--range", "x=-1..1", "--range", "y=-1..1"]);
    let told = text(&output);
    assert!(told.contains("by enclosures there is at least one steady motion"), "{told}");
    assert!(told.contains("the equations are singular in 2 directions; more boxes do not decide it"), "{told}");
    assert!(!told.contains("which more boxes would show") && !told.contains("\nno steady motion;"), "{told}");
}

/// x^2 = 0 and y^3 = 0: x^2 does not change its sign, so that its zero cannot be proved by signs.
#[test]
fn a_double_root_is_not_shown_by_signs() {
    let squares = "[[force]]\non = \"a\"\nis = \"-(1 N/m^2)*x^2*N.x\"\n[[force]]\non = \"b\"\nis = \"(1 N/m^3)*y^3*N.x\"\n[run]\nspan = \"1 s\"\n";
    let output = asked("squares", "", squares, &["stationary", "--range", "x=-1..1", "--range", "y=-1..1"]);
    let told = text(&output);
    assert!(told.contains("undecided boxes") && !told.contains("by enclosures there is"), "{told}");
}

#[test]
fn a_choice_says_which_outputs_it_was_made_for() {
    let spring = "[energies]\npotential = \"k/2*(x^2 + y^2)\"\n[start]\nx = \"0.1 m\"\n[run]\nspan = \"1 s\"\n";
    let choose = |words: &[&str]| {
        text(&asked("outputs", "k = \"50 N/m\"\n", spring, &[&["choose", "--tol", "1e-3"], words].concat()))
    };
    let all = choose(&[]);
    assert!(all.contains("(all columns of the run; --outputs names others)"), "{all}");
    let one = choose(&["--outputs", "x"]);
    assert!(one.contains("to 1e-3 in x (as --outputs names them)"), "{one}");
}

/// A slider crank with an elastic rod. Accuracy limits the steps to half the period of the rod; rounding then makes the estimated
/// Lipschitz constant larger than the eigenvalue, for many steps in a row.
#[test]
fn a_fast_mode_that_accuracy_resolves_is_followed_to_the_end() {
    let text = "title = \"Crank\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\nM = \"2 kg\"\ng = \"9.81 m/s^2\"\nl = \"1 m\"\nK = \"1e8 N/m\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\ns = \"m\"\n[points]\nS = \"O + s*N.x\"\nP = \"O + x*N.x + y*N.y\"\n[bodies.p]\ncentre = \"P\"\nmass = \"m\"\n\
        [bodies.q]\ncentre = \"S\"\nmass = \"M\"\n[[constraint]]\nname = \"crank\"\nzero = \"x^2 + y^2 - (0.25 m^2)\"\n[[force]]\nbetween = [\"p\", \"q\"]\n\
        is = \"-K*(distance(P, S) - l)\"\n[[force]]\non = \"q\"\nis = \"-(1e-3 N s/m)*s'*N.x\"\n[start]\nx = \"0.5 m\"\ns = \"1.5 m\"\n\"y'\" = \"3 m/s\"\n\
        [run]\nspan = \"2 s\"\n";
    let file = temporary("crank.toml");
    std::fs::write(&file, text).expect("it can be written");
    for method in ["dormand_prince_8", "dormand_prince_5"] {
        let found =
            json(&run(&["run", &file.to_string_lossy(), "--tol", "1e-11", "--method", method, "--format", "json"]));
        assert_eq!(
            (found["time"].as_f64(), found["failures"].as_array().map(Vec::len)),
            (Some(2.0), Some(0)),
            "{found}"
        );
        assert!((found["state"]["s"].as_f64().expect("a place") - 0.596_395_744).abs() < 1e-7, "{found}");
    }
    std::fs::remove_file(&file).expect("it is there");
}

/// Circular motion of a sleigh: the linear equations of x, y and the heading vary along it, those of the two speeds are constant.
#[test]
fn methods_are_judged_by_what_is_constant_along_a_circling_motion() {
    let file = temporary("circling.toml");
    let sleigh = "title = \"Sleigh\"\n[parameters]\nm = \"2 kg\"\nJ = \"0.5 kg m^2\"\na = \"0.2 m\"\n[coordinates]\nX = \"m\"\nY = \"m\"\np = \"rad\"\n\
        [speeds]\nv = \"velocity(K) . B.x\"\nw = \"p'\"\n[frames]\nB = \"N turned p about z\"\n\
        [points]\nG = \"O + X*N.x + Y*N.y\"\nK = \"G - a*B.x\"\n[bodies.s]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"J\"\n\
        [[constraint]]\nname = \"edge\"\nzero = \"velocity(s at K) . B.y\"\n[[force]]\nalong = \"v\"\nis = \"(4 N) - (2 N s/m)*v\"\n\
        [[torque]]\non = \"s\"\nis = \"((0.6 N m) - (0.3 N m s)*w)*B.z\"\n[start]\nv = \"1 m/s\"\n[run]\nspan = \"5 s\"\n";
    std::fs::write(&file, sleigh).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    let output = run(&["numerical-stability", &path, "--range", "v=-10..10", "--range", "p'=-10..10"]);
    std::fs::remove_file(&file).expect("it is there");
    let told = text(&output);
    // m v' = m a w^2 + F - c v, (J + m a^2) w' = -m a v w + T - d w
    assert!(told.contains("eigenvalues, 1/s: -1.0935018589, -1.8424344592"), "{told}");
    assert!(told.contains("correct up to h = 1.085520296"), "{told}");
}

/// x'' = -x^3: both eigenvalues are zero, and no method is called correct because of them.
#[test]
fn zero_eigenvalues_alone_judge_no_method() {
    let cubes = "[[force]]\non = \"a\"\nis = \"-(1 N/m^3)*x^3*N.x\"\n[run]\nspan = \"1 s\"\n";
    let output = asked("zeros", "", cubes, &["numerical-stability", "--range", "x=-1..1"]);
    let told = text(&output);
    assert!(told.contains("every eigenvalue of the linear equations is zero: they decide nothing"), "{told}");
    assert!(!told.contains("correct up to") && !told.contains("correct at every"), "{told}");
}

/// The inertia m r^2 is far from zero at the start, though small compared with its value at the end.
#[test]
fn a_motion_that_grows_without_bound_has_no_singular_coordinates() {
    let file = temporary("grows.toml");
    let text = "title = \"A spring that pushes\"\n[parameters]\nm = \"1 kg\"\nk = \"-5e6 N/m\"\n[coordinates]\nr = \"m\"\ntheta = \"rad\"\n[frames]\n\
        A = \"N turned theta about z\"\n[bodies.bob]\ncentre = \"O - r*A.y\"\nmass = \"m\"\n[energies]\npotential = \"k*(r - (0.5 m))^2/2\"\n\
        [start]\nr = \"0.6 m\"\ntheta = \"40 deg\"\n[run]\nspan = \"10 s\"\nsamples = 600\n";
    std::fs::write(&file, text).expect("it can be written");
    let told = String::from_utf8_lossy(&run(&["run", &file.to_string_lossy()]).stdout).into_owned();
    std::fs::remove_file(&file).expect("it is there");
    assert!(told.contains("growth without bound") && !told.contains("singular chart"), "{told}");
}

#[test]
fn energies_have_their_unit_and_a_name_of_their_own() {
    let path = crate::temporary("named_energy.toml");
    let scene = "title = \"A mass on a spring\"\n[coordinates]\nkinetic_energy = \"m\"\n[energies]\nkinetic = \"(1 kg)*kinetic_energy'^2/2\"\n\
        potential = \"(1 N/m)*kinetic_energy^2/2\"\n[start]\nkinetic_energy = \"1 m\"\n[run]\nspan = \"2 s\"\n";
    std::fs::write(&path, scene).expect("it is written");
    let output = crate::program(&["run", &path.display().to_string()]).output().expect("the program starts");
    std::fs::remove_file(&path).expect("it is there");
    let told = text(&output);
    for part in
        ["  kinetic_energy     -0.416", " m\n", "  run.kinetic_energy ", " J\n", "0.500000000 J, changed by at most"]
    {
        assert!(told.contains(part), "{part}\n{told}");
    }
}
