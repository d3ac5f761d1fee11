//! Failures of runs, each diagnosed on a system made for it, with location and remedy; entries of the catalogue from files.

use super::{json, run, temporary};
use serde_json::Value;

const MASS: &str = "title = \"A mass\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies.mass]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n";

const BOB: &str = "title = \"A pendulum\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
    [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n\
    [[constraint]]\nname = \"rod\"\nzero = \"x^2 + y^2 - l^2\"\n";

/// Runs a text with options: its JSON, its exit code, and its standard error.
fn ran(name: &str, text: &str, options: &[&str]) -> (Value, Option<i32>, String) {
    let file = temporary(&format!("{name}.toml"));
    std::fs::write(&file, text).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    let output = run(&[&["run", &path, "--format", "json"], options].concat());
    std::fs::remove_file(&file).expect("it is there");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    let found = if output.stdout.is_empty() { Value::Null } else { json(&output) };
    (found, output.status.code(), message)
}

/// The only failure of a run: its kind, time in seconds, evidence, remedy.
fn failure(found: &Value) -> (String, f64, String, String) {
    let all = found["failures"].as_array().expect("a list");
    assert_eq!(all.len(), 1, "{found}");
    let text = |key: &str| all[0][key].as_str().expect("a text").to_owned();
    (text("kind"), all[0]["at"].as_f64().expect("a time"), text("evidence"), text("remedy"))
}

/// A spherical pendulum that swings nearly in one plane from 1 rad: it passes the pole after `K(k^2)*sqrt(l/g)`, with `k = sin(1/2)`.
#[test]
fn angles_that_pass_near_their_pole_are_a_singular_chart() {
    let text = "title = \"Spherical angles\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
        [coordinates]\npolar = \"rad\"\nazimuth = \"rad\"\n[points]\n\
        P = \"O + l*(sin(polar)*cos(azimuth)*N.x + sin(polar)*sin(azimuth)*N.y - cos(polar)*N.z)\"\n\
        [bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[start]\npolar = \"1 rad\"\n\"azimuth'\" = \"1e-5 rad/s\"\n\
        [run]\nspan = \"1 s\"\ntolerance = 1e-9\n";
    let (found, code, _) = ran("pole", text, &[]);
    let (kind, at, evidence, remedy) = failure(&found);
    assert_eq!((kind.as_str(), code), ("singular chart", Some(0)), "{found}");
    assert!((at - 0.5343).abs() < 1e-3, "{at}");
    assert!(evidence.contains("`azimuth'` moves no body at `polar` = "), "{evidence}");
    assert!(remedy.contains("N free"), "{remedy}");
}

#[test]
fn an_inertia_that_vanishes_at_a_place_is_a_singular_mass_matrix() {
    let text = "title = \"Vanishing inertia\"\n[parameters]\nm = \"1 kg\"\na = \"1 m\"\nk = \"2 N/m\"\n[coordinates]\nx = \"m\"\n\
        [energies]\nkinetic = \"m/2*(1 - x/a)*x'^2\"\npotential = \"k/2*x^2\"\n[start]\n\"x'\" = \"2 m/s\"\n[run]\nspan = \"3 s\"\n";
    let (found, code, _) = ran("mass", text, &[]);
    let (kind, _, evidence, _) = failure(&found);
    assert_eq!((kind.as_str(), code), ("singular mass matrix", Some(1)), "{found}");
    assert!(evidence.contains("no inertia resists `x'` at `x` = 1 m"), "{evidence}");
    // constant steps continue past the singularity, and lose energy
    let (found, _, _) = ran("mass_steps", text, &["--method", "runge_kutta_4:1000"]);
    assert_eq!(failure(&found).0, "singular mass matrix", "{found}");
}

#[test]
fn a_crank_as_long_as_its_rod_loses_the_rank_of_its_constraints_at_the_right_angle() {
    let text = "title = \"Equal lengths\"\n[parameters]\nr = \"0.3 m\"\nm = \"1 kg\"\nJ = \"0.1 kg m^2\"\n\
        [coordinates]\ntheta = \"rad\"\nphi = \"rad\"\ns = \"m\"\n[points]\nA = \"O + r*(cos(theta)*N.x + sin(theta)*N.y)\"\n\
        B = \"A + r*(cos(phi)*N.x - sin(phi)*N.y)\"\nS = \"O + s*N.x\"\n[bodies.crank]\nturns = \"theta\"\ninertia = \"J\"\n\
        [bodies.slider]\ncentre = \"S\"\nmass = \"m\"\n[[constraint]]\nname = \"rod\"\nzero = \"B - S\"\n\
        [start]\ntheta = \"30 deg\"\nphi = \"guess 30 deg\"\ns = \"guess 0.5 m\"\n\"theta'\" = \"5 rad/s\"\n[run]\nspan = \"2 s\"\n";
    let (found, code, _) = ran("crank", text, &[]);
    let (kind, _, evidence, _) = failure(&found);
    assert_eq!((kind.as_str(), code), ("loss of rank of the constraints", Some(1)), "{found}");
    assert!(evidence.contains("`rod` along N.y") && evidence.contains("`theta` = 1.57"), "{evidence}");
    // the remedy: a length that differs by a factor of 1 + 1e-4
    let (found, code, _) = ran("crank_apart", &text.replace("r*(cos(phi)", "(1 + 1e-4)*r*(cos(phi)"), &[]);
    assert_eq!((code, found["failures"].as_array().map(Vec::len)), (Some(0), Some(0)), "{found}");
}

#[test]
fn a_constraint_that_is_written_twice_is_warned_of() {
    let text = format!(
        "{BOB}[[constraint]]\nname = \"again\"\nzero = \"distance(P, O) - l\"\n[start]\nx = \"1 m\"\ny = \"0 m\"\n[run]\nspan = \"1 s\"\n"
    );
    let (_, code, message) = ran("twice", &text, &[]);
    assert_eq!(code, Some(0), "{message}");
    assert!(message.contains("`again` follows from other constraints"), "{message}");
}

/// The drive moves the load by a spring: the unknown force appears in the fourth derivative of the constraint.
#[test]
fn a_force_that_keeps_a_place_through_a_spring_has_index_five() {
    let text = "title = \"Through a spring\"\n[parameters]\nm = \"1 kg\"\nM = \"2 kg\"\nk = \"100 N/m\"\na = \"0.1 m\"\nw = \"3 rad/s\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\nu = \"1\"\n[bodies.drive]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[bodies.load]\n\
        centre = \"O + y*N.x\"\nmass = \"M\"\n[[force]]\non = \"drive\"\nis = \"(k*(y - x) + u*(1 N))*N.x\"\n[[force]]\non = \"load\"\n\
        is = \"-k*(y - x)*N.x\"\n[[force]]\nalong = \"u\"\nis = \"(y - a*sin(w*t))*(1 N)\"\n[run]\nspan = \"2 s\"\n";
    let (_, code, message) = ran("index", text, &[]);
    assert_eq!(code, Some(2), "{message}");
    assert!(
        message.contains("the index of its differential-algebraic equations is 5")
            && message.contains("differentiated 4 times"),
        "{message}"
    );
}

/// In a law with events a constraint of speeds is kept by its derivative only.
#[test]
fn a_constraint_of_speeds_that_long_steps_leave_is_drift() {
    let text = "title = \"A sleigh\"\n[parameters]\nm = \"1 kg\"\nJ = \"1 kg m^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        theta = \"rad\"\n[frames]\nR = \"N turned theta about z\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.sleigh]\nframe = \"R\"\n\
        centre = \"P\"\nmass = \"m\"\ninertia = \"J\"\n[[constraint]]\nname = \"edge\"\nzero = \"velocity(P) . R.y\"\n[[event]]\n\
        when = \"x - (50 m)\"\nset = { \"theta'\" = \"0\" }\n[start]\n\"x'\" = \"1 m/s\"\n\"theta'\" = \"10 rad/s\"\n[run]\nspan = \"5 s\"\n";
    let (found, _, _) = ran("drift", text, &["--method", "runge_kutta_4:50"]);
    let (kind, _, evidence, remedy) = failure(&found);
    assert_eq!(kind, "drift off the constraints", "{found}");
    assert!(evidence.contains("`edge`") && remedy.contains("more steps than 50"), "{evidence}; {remedy}");
    let (found, _, _) = ran("drift_not", text, &["--method", "runge_kutta_4:5000"]);
    assert_eq!(found["failures"].as_array().map(Vec::len), Some(0), "{found}");
}

#[test]
fn a_damper_that_is_gone_at_once_is_stiffness_for_explicit_methods() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"-((1 N/m)*x + (20000 N s/m)*x')*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"10 s\"\ntolerance = 1e-6\n"
    );
    let (found, code, _) = ran("stiff", &text, &[]);
    let (kind, _, evidence, remedy) = failure(&found);
    assert_eq!((kind.as_str(), code), ("stiffness", Some(1)), "{found}");
    assert!(evidence.contains("`x'`") && evidence.contains("-2.000e4 1/s"), "{evidence}");
    assert!(remedy.contains("--method radau_5"), "{remedy}");
    // the remedy
    let (found, code, _) = ran("stiff_radau", &text, &["--method", "radau_5"]);
    assert_eq!((code, found["failures"].as_array().map(Vec::len)), (Some(0), Some(0)), "{found}");
    // constant steps that are too long: the stability limit is 2.785 time constants
    let (found, _, _) = ran("stiff_steps", &text, &["--method", "runge_kutta_4:1000"]);
    let (kind, _, _, remedy) = failure(&found);
    assert!(kind == "step beyond the stability limit" && remedy.contains("at least 71806 steps"), "{found}");
}

#[test]
fn bounces_whose_times_have_a_limit_are_told_as_zeno_with_their_factor() {
    let text = format!(
        "{}[[event]]\nname = \"impact\"\nwhen = \"x\"\ndirection = \"down\"\nset = {{ \"x'\" = \"-0.5*x'\" }}\n[start]\nx = \"1 m\"\n[run]\nspan = \"5 s\"\n",
        MASS.replace("[parameters]", "gravity = \"-(9.81 m/s^2)*N.x\"\n[parameters]")
    );
    let (found, code, _) = ran("zeno", &text, &[]);
    let (kind, at, evidence, _) = failure(&found);
    assert_eq!((kind.as_str(), code), ("Zeno: events accumulate", Some(1)), "{found}");
    // t = sqrt(2 h/g) (1 + e)/(1 - e)
    assert!((at - 3.0 * (2.0_f64 / 9.81).sqrt()).abs() < 1e-8, "{at}");
    assert!(evidence.contains("`impact`") && evidence.contains("0.5000"), "{evidence}");
}

#[test]
fn relays_and_rough_rods_are_named_by_their_contact_modes() {
    let of = |scene: &str| json(&run(&["run", scene, "--format", "json"]));
    let none = of("scenes/friction/painleve.toml");
    assert!(failure(&none).0.starts_with("Painleve's paradox"), "{none}");
    let jam = of("scenes/friction/jam.toml");
    let (kind, _, evidence, _) = failure(&jam);
    assert!(kind == "jam" && evidence.contains("contact `end`"), "{jam}");
}

#[test]
fn a_force_as_the_square_of_its_speed_blows_up_at_a_finite_time() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"(1 kg/m)*x'^2*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"2 s\"\n"
    );
    let (found, code, _) = ran("blow_up", &text, &[]);
    let (kind, at, evidence, _) = failure(&found);
    assert_eq!((kind.as_str(), code), ("blow-up in finite time", Some(1)), "{found}");
    // t = m/(c v)
    assert!((at - 1.0).abs() < 1e-6 && evidence.contains("`x'`"), "{found}");
    let (found, _, _) = ran("blow_up_steps", &text, &["--method", "runge_kutta_4:100"]);
    assert_eq!(failure(&found).0, "blow-up in finite time", "{found}");
}

#[test]
fn a_stiffness_of_the_wrong_sign_and_a_power_of_time_grow_without_bound_and_do_not_blow_up() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"(10000 N/m)*x*N.x\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"20 s\"\nmethod = \"runge_kutta_4:20000\"\n"
    );
    let (found, code, _) = ran("growth", &text, &[]);
    assert_eq!((failure(&found).0.as_str(), code), ("growth without bound", Some(1)), "{found}");
    assert!(failure(&found).2.contains("as it did before"), "{found}");
    // terms of a series and matrices overflow before the state does
    for method in ["taylor", "dormand_prince_8", "radau_5", "kvaerno_5"] {
        let (found, code, _) = ran("growth_by_methods", &text, &["--method", method]);
        assert_eq!((failure(&found).0.as_str(), code), ("growth without bound", Some(1)), "{method}: {found}");
    }
    // x grows as t^66
    let text = format!("{MASS}[[force]]\non = \"mass\"\nis = \"(1 N)*(t/(1 s))^64*N.x\"\n[run]\nspan = \"400 s\"\n");
    let (found, ..) = ran("power", &text, &[]);
    let (kind, _, evidence, _) = failure(&found);
    assert!(kind == "growth without bound" && evidence.contains("more slowly than an exponential"), "{found}");
}

#[test]
fn a_root_whose_argument_turns_negative_is_the_end_of_the_domain_of_the_law() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"-sqrt(x/(1 m))*(1 N)*N.x\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"5 s\"\n"
    );
    let (found, code, _) = ran("domain", &text, &[]);
    let (kind, at, evidence, _) = failure(&found);
    assert_eq!((kind.as_str(), code), ("end of the domain of the law", Some(1)), "{found}");
    // the time from x = 1 to x = 0 with x' = -sqrt(4/3 (1 - x^(3/2)))
    assert!((at - 1.4937).abs() < 1e-3 && evidence.contains("`sqrt(x/(1 m))` in line 11"), "{found}");
}

/// Torricelli's law: `sqrt(h)` decreases linearly in time, and is zero at `t = A/a*sqrt(2 h/g)`.
#[test]
fn a_tank_that_is_empty_names_the_root_its_line_and_the_time_by_every_method() {
    let text = "title = \"A tank drains\"\n[parameters]\nA = \"1 m^2\"\na = \"0.02 m^2\"\ng = \"9.81 m/s^2\"\nb = \"1 N s/m\"\n[coordinates]\n\
        h = \"m\"\n[energies]\ndissipation = \"b/2*h'^2\"\n[[force]]\nalong = \"h\"\nis = \"-b*a/A*sqrt(2*g*h)\"\n[start]\nh = \"1 m\"\n\
        [run]\nspan = \"60 s\"\n";
    let empty = 50.0 * (2.0_f64 / 9.81).sqrt();
    for method in ["dormand_prince_8", "radau_5", "runge_kutta_4:1000", "gauss:4"] {
        let (found, code, _) = ran("tank", text, &["--method", method]);
        let (kind, at, evidence, remedy) = failure(&found);
        assert_eq!((kind.as_str(), code), ("end of the domain of the law", Some(1)), "{method}: {found}");
        assert!((at - empty).abs() < 0.02, "{method}: {at} beside {empty}");
        assert!(evidence.contains("`sqrt(2*g*h)` in line 13") && evidence.contains("`h` = "), "{method}: {evidence}");
        assert!(remedy.contains("`when = \"2*g*h - EPS\"`"), "{remedy}");
    }
    // the remedy
    let ended = format!("{text}[[event]]\nwhen = \"2*g*h - (1e-3 m^2/s^2)\"\nend = true\n");
    let (found, code, message) = ran("tank_ended", &ended, &[]);
    assert_eq!((code, found["failures"].as_array().map(Vec::len)), (Some(0), Some(0)), "{found} {message}");
}

/// A ball between two walls 1e-6 m apart hits one of them every microsecond.
#[test]
fn events_by_the_thousand_are_chattering_with_their_distance() {
    let text = format!(
        "{MASS}[[event]]\nname = \"left\"\nwhen = \"x\"\ndirection = \"down\"\nset = {{ \"x'\" = \"-x'\" }}\n[[event]]\nname = \"right\"\n\
         when = \"x - (1e-6 m)\"\ndirection = \"up\"\nset = {{ \"x'\" = \"-x'\" }}\n[start]\nx = \"5e-7 m\"\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n"
    );
    let (found, code, _) = ran("chattering", &text, &[]);
    let (kind, at, evidence, remedy) = failure(&found);
    assert_eq!((kind.as_str(), code), ("chattering", Some(1)), "{found}");
    assert!((at - 0.02).abs() < 1e-3, "{at}");
    assert!(
        evidence.contains("the event `left` and the event `right`") && evidence.contains("every 1.0e-6 s"),
        "{evidence}"
    );
    assert!(remedy.contains("if(s > 0, a, b)"), "{remedy}");
}

/// The constraint acts on y and z only; the inertia of x vanishes at x = a.
#[test]
fn an_inertia_that_vanishes_beside_a_constraint_is_no_loss_of_rank() {
    let text = "title = \"Vanishing inertia\"\n[parameters]\nm = \"1 kg\"\na = \"1 m\"\nk = \"2 N/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        z = \"m\"\n[energies]\nkinetic = \"m/2*(1 - x/a)*x'^2 + m/2*y'^2 + m/2*z'^2\"\npotential = \"k/2*x^2\"\n[[constraint]]\nzero = \"y - z\"\n\
        [start]\n\"x'\" = \"2 m/s\"\n[run]\nspan = \"3 s\"\n";
    let (found, _, _) = ran("mass_beside", text, &[]);
    let (kind, _, evidence, _) = failure(&found);
    assert_eq!(kind, "singular mass matrix", "{found}");
    assert!(evidence.contains("no inertia resists `x'` at `x` = 1 m"), "{evidence}");
}

/// A damper with a time constant of 1e-9 s needs more steps than are allowed; a slow machine reaches the time limit first.
#[test]
fn a_stiff_run_that_is_given_up_is_told_as_stiff() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"-((1 N/m)*x + (1e9 N s/m)*(x' - (1 m/s)*cos(t/(1 s))))*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n\
         [run]\nspan = \"10 s\"\nmethod = \"gragg_bulirsch_stoer\"\n"
    );
    let (found, code, message) = ran("stiff_time", &text, &["--seconds", "10"]);
    assert_eq!(code, Some(1), "{found} {message}");
    let (kind, _, evidence, remedy) = failure(&found);
    assert!(kind == "stiffness" && evidence.contains("-1.000e9 1/s") && remedy.contains("--method radau_5"), "{found}");
}

/// An impulse of about 0.9 N s within 2 ms at t = 5.03 s.
#[test]
fn a_smooth_push_between_two_long_steps_is_told_under_constant_ones() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"(1000 N)*exp(-((t - (5.03 s))/(0.0005 s))^2)*N.x\"\n[run]\nspan = \"10 s\"\n"
    );
    let (found, code, _) = ran("push", &text, &["--method", "runge_kutta_4:400"]);
    let (kind, at, evidence, remedy) = failure(&found);
    assert_eq!((kind.as_str(), code), ("missed event", Some(1)), "{found}");
    assert!((at - 5.03).abs() < 2e-3 && evidence.contains("the rate of `x'` changes by itself"), "{found}");
    let method = remedy.split("--method ").nth(1).expect("a method");
    let (found, code, _) = ran("push_steps", &text, &["--method", method]);
    assert_eq!((code, found["failures"].as_array().map(Vec::len)), (Some(0), Some(0)), "{found}");
}

/// A force of 1000 N from 5.03 s to 5.031 s by conditions on the time: steps end at both instants.
#[test]
fn a_push_by_conditions_of_the_time_is_stepped_to() {
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"if(t < (5.03 s), 0*(1 N), if(t < (5.031 s), (1000 N), 0*(1 N)))*N.x\"\n[run]\nspan = \"10 s\"\n"
    );
    let (found, code, _) = ran("push_conditions", &text, &[]);
    assert_eq!(code, Some(0), "{found}");
    let speed = found["state"]["x'"].as_f64().expect("a speed");
    assert!((speed - 1.0).abs() < 1e-9, "{found}");
}

#[test]
fn a_start_off_the_constraints_is_refused_with_what_is_left() {
    let (_, code, message) =
        ran("off", &format!("{BOB}[start]\nx = \"1.1 m\"\ny = \"0 m\"\n[run]\nspan = \"1 s\"\n"), &[]);
    assert_eq!(code, Some(2), "{message}");
    assert!(message.contains("`rod` does not hold at the start") && message.contains("0.21 m^2"), "{message}");
}

/// The function of the event is positive for 3.3 ms.
#[test]
fn a_pulse_between_two_long_steps_is_a_missed_event() {
    let text = format!(
        "{MASS}[[event]]\nname = \"kick\"\nwhen = \"exp(-((t - (5.03 s))/(0.002 s))^2) - 0.5\"\ndirection = \"up\"\nset = {{ \"x'\" = \"x' + (1 m/s)\" }}\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"10 s\"\n"
    );
    // a method with error control finds both events
    let (found, code, _) = ran("pulse_seen", &text, &[]);
    assert_eq!((code, found["events"].as_array().map(Vec::len)), (Some(0), Some(2)), "{found}");
    let (found, code, _) = ran("pulse", &text, &["--method", "runge_kutta_4:100"]);
    let (kind, at, evidence, remedy) = failure(&found);
    assert_eq!((kind.as_str(), code), ("missed event", Some(1)), "{found}");
    assert!((at - 5.03).abs() < 2e-3 && evidence.contains("the event `kick`"), "{found}");
    let method = remedy.split("--method ").nth(1).and_then(|rest| rest.split(';').next()).expect("a method");
    let (found, code, _) = ran("pulse_steps", &text, &["--method", method]);
    assert_eq!((code, found["events"].as_array().map(Vec::len)), (Some(0), Some(2)), "{found}");
}

#[test]
fn a_tolerance_below_rounding_is_refused_with_the_finest() {
    let (_, code, message) = ran("fine", MASS, &["--tol", "1e-17"]);
    assert!(code == Some(2) && message.contains("below the rounding of double precision; from 1e-14"), "{message}");
}

const ENTRY: &str = "method = \"euler:4000\"\n[failure]\nname = \"mine\"\ntitle = \"t\"\nwhy = \"w\"\nadvice = \"a\"\nvary = \"step\"\n\
    holds_at = \"0.1 s\"\nfails_at = \"1 s\"\nof = \"longest step\"\nthreshold = \"2*m/c\"\nwhile = \"(2 m/s) - abs(x')\"\nexpects = \"step beyond the stability limit\"\n";

/// A mass with a damper c: Euler's method is stable for steps up to 2 m/c.
fn damper() -> String {
    format!(
        "{}[[force]]\non = \"mass\"\nis = \"-c*x'*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n{ENTRY}",
        MASS.replace("m = \"1 kg\"", "m = \"1 kg\"\nc = \"5 N s/m\"")
    )
}

#[test]
fn a_scene_of_a_user_is_measured_as_an_entry_of_the_catalogue() {
    let file = temporary("own_entry.toml");
    std::fs::write(&file, damper()).expect("it can be written");
    let output = run(&["failures", &file.to_string_lossy(), "--format", "json"]);
    let found = json(&output);
    let threshold = &found[0]["thresholds"][0];
    assert_eq!(
        (output.status.code(), threshold["exact"].as_str(), threshold["agrees"].as_bool()),
        (Some(0), Some("2/5"), Some(true)),
        "{found}"
    );
    assert!(found[0]["diagnosis"].as_str().is_some_and(|says| says.starts_with("step beyond")), "{found}");
    let plain = run(&["run", &file.to_string_lossy()]);
    assert_eq!(plain.status.code(), Some(0), "{}", String::from_utf8_lossy(&plain.stdout));
    std::fs::remove_file(&file).expect("it is there");
}

#[test]
fn what_is_wrong_with_an_entry_is_told_at_its_place() {
    for (from, to, says) in [
        ("\"2*m/c\"", "\"2*m\"", "an expression whose unit is s"),
        ("\"2*m/c\"", "\"2*m/c + x/(1 m/s)\"", "the threshold depends on the motion"),
        ("\"2*m/c\"", "\"200*m/c\"", "does not lie between"),
        ("vary = \"step\"", "vary = \"stop\"", "nothing is called `stop`"),
        ("\"1 s\"\nof", "\"1 m\"\nof", "is varied, and this is no value of it"),
        ("expects = \"step beyond the stability limit\"", "expects = \"luck\"", "no failure is called `luck`"),
        ("title = \"t\"\n", "", "title"),
    ] {
        let file = temporary("wrong_entry.toml");
        std::fs::write(&file, damper().replace(from, to)).expect("it can be written");
        let output = run(&["failures", &file.to_string_lossy()]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && message.contains(says), "{to}: {message}");
        std::fs::remove_file(&file).expect("it is there");
    }
}

#[test]
fn the_six_entries_of_the_folder_that_are_text_are_theory_s() {
    for name in ["penalty contact", "stabilised constraint", "bounces", "sampling", "drawer", "draining tank"] {
        let output = run(&["failures", name, "--format", "json"]);
        let found = json(&output);
        assert_eq!(output.status.code(), Some(0), "{name}: {found} {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(found[0]["thresholds"][0]["agrees"].as_bool(), Some(true), "{found}");
    }
}

#[test]
fn the_first_member_of_an_ensemble_that_stops_is_diagnosed() {
    let (file, table) = (temporary("members.toml"), temporary("members.csv"));
    let text = format!(
        "{MASS}[[force]]\non = \"mass\"\nis = \"(1 kg/m)*x'^2*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"2 s\"\n\
         [ensemble]\nmembers = 3\n[ensemble.vary]\nstart.\"x'\" = {{ from = \"0.4 m/s\", to = \"1 m/s\" }}\n"
    );
    std::fs::write(&file, text).expect("it can be written");
    let output = run(&["ensemble", &file.to_string_lossy(), "--out", &table.to_string_lossy()]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        told.contains("failure: blow-up in finite time at t = "),
        "{told} {}",
        String::from_utf8_lossy(&output.stderr)
    );
    [file, table].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}
