//! Voltages for a prescribed motion: currents follow from torques; compared with closed forms and with runs.

use dalembert_scenes::inverse::{Forces, inverse};
use dalembert_scenes::linearisation::VariedEquations;
use dalembert_scenes::read_prescribed;
use model::Model;

/// An arm driven by a DC motor through a gear.
const ARM: &str = "title = \"arm\"\ngravity = \"-g*N.y\"\n[parameters]\ng = \"9.81 m/s^2\"\n[coordinates]\ntheta = \"rad\"\n[frames]\nA = \"N turned theta about z\"\n\
    [bodies.arm]\nframe = \"A\"\ncentre = \"O - (0.3 m)*A.y\"\nmass = \"(2 kg)\"\ninertia = \"(0.02 kg m^2)\"\n[inputs]\nu = \"V\"\n\
    [[drive]]\nname = \"motor\"\nturns = \"theta\"\nratio = \"20\"\ninertia = \"(1e-4 kg m^2)\"\ntorque = \"-(1e-4 N m s)*motor.speed\"\n\
    [[drive.winding]]\ninductance = \"(2 mH)\"\nresistance = \"(0.5 ohm)\"\nsupply = \"u\"\nmotional = \"(0.05 V s)\"\n[run]\nspan = \"1 s\"\n";

/// Times of a motion in seconds.
const INSTANTS: [f64; 4] = [0.0, 0.1, 0.7, 1.3];

type Found = Result<(Model, Vec<Forces>), String>;

fn forces(name: &str, text: &str, motions: &[(&str, &str)], unknowns: &[&str], times: &[f64]) -> Found {
    let path = std::env::temp_dir().join(format!("dalembert_{}_{name}.toml", std::process::id()));
    std::fs::write(&path, text).expect("it can be written");
    let motions: Vec<(String, String)> = motions.iter().map(|&(name, is)| (name.to_owned(), is.to_owned())).collect();
    let read = read_prescribed(&path, &motions);
    std::fs::remove_file(&path).expect("it is there");
    let (model, prescribed) = read.map_err(|error| error.to_string())?;
    let unknowns: Vec<String> = unknowns.iter().map(|&name| name.to_owned()).collect();
    let found = inverse(&model, &prescribed, &unknowns, times).map_err(|why| why.to_string())?;
    Ok((model, found.forces))
}

/// V = R i + L i' + k n theta' with n k i = J theta'' + c theta' + m g l sin(theta).
#[test]
fn the_voltage_of_a_motor_for_a_motion_has_its_closed_form() {
    let (_, found) =
        forces("arm", ARM, &[("theta", "sin(t*(3 rad/s))")], &["u"], &INSTANTS).unwrap_or_else(|why| panic!("{why}"));
    for Forces { time, speeds, accelerations, unknowns, .. } in found {
        let (sin, cos) = (3.0 * time).sin_cos();
        let [theta, rate, second, third] = [sin, 3.0 * cos, -9.0 * sin, -27.0 * cos];
        let (inertia, c, weight) = (0.02 + 2.0 * 0.09 + 400.0 * 1e-4, 400.0 * 1e-4, 2.0 * 9.81 * 0.3);
        let current = inertia * second + c * rate + weight * theta.sin();
        let change = inertia * third + c * second + weight * theta.cos() * rate;
        assert!((speeds[1] - current).abs() < 1e-11 && (accelerations[1] - change).abs() < 1e-10, "{speeds:?}");
        let voltage = 0.5 * current + 2e-3 * change + 0.05 * 20.0 * rate;
        assert!((unknowns[0] - voltage).abs() < 1e-10, "{unknowns:?} {voltage}");
    }
}

/// A stored system with some texts replaced.
fn changed(name: &str, changes: &[(&str, &str)]) -> String {
    let text = std::fs::read_to_string(super::stored(&format!("models/{name}"))).expect("it is there");
    changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

/// A synchronous reluctance machine with saturation; the voltages of both phases are unknown.
fn saturated() -> String {
    changed(
        "synchronous_reluctance",
        &[
            ("U*cos(w*t)", "ua"),
            ("U*sin(w*t)", "ub"),
            ("[energies]", "[inputs]\nua = \"V\"\nub = \"V\"\n[energies]"),
            ("lag = \"w*t - 2*theta\"\n", ""),
        ],
    )
}

/// The slider-crank driven by a motor: the equation of its shaft contains the reactions of the closed loop.
fn crank() -> String {
    let motor = "[inputs]\nu = \"V\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\n[[drive.winding]]\ninductance = \"(5 mH)\"\n\
        resistance = \"(0.8 ohm)\"\nsupply = \"u\"\nmotional = \"(0.2 V s)\"\n[start]\n";
    changed("slider_crank", &[("[start]\n", motor)])
}

/// Two links with a motor each; the second motor acts between the links.
const TWO: &str = "title = \"two\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\n[frames]\nA = \"N turned a about z\"\n\
    B = \"A turned b about z\"\n[points]\nP = \"O - (0.4 m)*A.y\"\nQ = \"P - (0.3 m)*B.y\"\n[bodies.upper]\nframe = \"A\"\ncentre = \"P\"\nmass = \"(1 kg)\"\n\
    inertia = \"(0.01 kg m^2)\"\n[bodies.lower]\nframe = \"B\"\ncentre = \"Q\"\nmass = \"(0.5 kg)\"\ninertia = \"(0.01 kg m^2)\"\n[inputs]\nu1 = \"V\"\nu2 = \"V\"\n\
    [[drive]]\nname = \"first\"\nturns = \"a\"\nratio = \"10\"\n[[drive.winding]]\ninductance = \"(6 mH)\"\nresistance = \"(1 ohm)\"\nsupply = \"u1\"\n\
    motional = \"(0.05 V s)\"\n[[drive]]\nname = \"second\"\nbetween = [\"upper\", \"lower\"]\nratio = \"8\"\n[[drive.winding]]\ninductance = \"(8 mH)\"\n\
    resistance = \"(2 ohm)\"\nsupply = \"u2\"\nmotional = \"(0.04 V s)\"\n[run]\nspan = \"1 s\"\n";

/// A satellite with prescribed rotation by torques along its axes, and with a wheel whose angle is prescribed.
fn satellite() -> String {
    let text = changed("reaction_wheel", &[("[drive.machine]", "[machine]")]);
    let (before, behind) = text.split_once("[machine]").expect("it has one");
    let (_, behind) = behind.split_once("[outputs]").expect("it has some");
    let driven = "[[drive.winding]]\ninductance = \"(20 mH)\"\nresistance = \"(0.6 ohm)\"\nsupply = \"u\"\nmotional = \"(0.05 V s)\"\n[inputs]\nu = \"V\"\n\
        T1 = \"N m\"\nT2 = \"N m\"\nT3 = \"N m\"\n[[torque]]\non = \"satellite\"\nis = \"T1*F.x + T2*F.y + T3*F.z\"\n[outputs]";
    format!("{before}{driven}{behind}")
}

/// Integrates from the first instant by the classical Runge-Kutta method, with the voltages of each instant; returns the final state.
fn run(model: &Model, found: &[Forces], unknowns: &[&str], step: f64) -> Vec<f64> {
    let mut closed = model.clone();
    closed.close_inputs();
    let equations = VariedEquations::of(&closed, &[]).unwrap_or_else(|why| panic!("{why}"));
    let mut state = [&found[0].coordinates[..], &found[0].speeds].concat();
    let positions = model.positions();
    let rate = |at: &Forces, state: &[f64]| -> Vec<f64> {
        let mut point = equations.point(at.time, state);
        for (name, voltage) in unknowns.iter().zip(&at.unknowns) {
            point.inputs[equations.inputs.iter().position(|input| input == name).expect("it is one")] = *voltage;
        }
        let point = equations.with_accelerations(point).expect("it is determined");
        let mut rates = vec![0.0; positions];
        model.position_rates(state, &mut rates);
        [&rates[..], point.accelerations.as_slice()].concat()
    };
    let moved = |state: &[f64], rate: &[f64], by: f64| -> Vec<f64> {
        state.iter().zip(rate).map(|(part, rate)| part + rate * by).collect()
    };
    for three in found.windows(3).step_by(2) {
        let first = rate(&three[0], &state);
        let second = rate(&three[1], &moved(&state, &first, step / 2.0));
        let third = rate(&three[1], &moved(&state, &second, step / 2.0));
        let last = rate(&three[2], &moved(&state, &third, step));
        for (k, part) in state.iter_mut().enumerate() {
            *part += step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + last[k]);
        }
    }
    state
}

#[test]
fn a_run_with_the_voltages_that_are_found_follows_the_motion() {
    let (turning, swinging) = ("1 + t*(20 rad/s) + 0.1*sin(t*(4 rad/s))", "0.4 + 0.3*sin(t*(5 rad/s))");
    let series = changed(
        "series_motor",
        &[("supply = \"U\"", "supply = \"u\""), ("[outputs]", "[inputs]\nu = \"V\"\n[outputs]")],
    );
    let turns = "0.4*sin(t*(3 rad/s)) about z, then 0.3*cos(t*(4 rad/s)) about x, then t^2*(1 1/s^2) about y";
    let along = "(3 A)*cos(t*(2 rad/s))";
    for (name, text, motions, unknowns) in [
        ("arm", ARM.to_owned(), &[("theta", "sin(t*(3 rad/s))")][..], &["u"][..]),
        ("crank", crank(), &[("theta", swinging)], &["u"]),
        ("two", TWO.to_owned(), &[("a", "0.4*sin(t*(5 rad/s))"), ("b", "0.2*cos(t*(3 rad/s))")], &["u1", "u2"]),
        ("series", series, &[("theta", turning)], &["u"]),
        ("satellite", satellite(), &[("s", "5*sin(t*(3 rad/s))"), ("F", turns)], &["u", "T1", "T2", "T3"]),
        ("saturated", saturated(), &[("theta", turning), ("id", along)], &["ua", "ub"]),
    ] {
        let steps = 2000;
        let times: Vec<f64> = (0..=2 * steps).map(|k| 0.25 * k as f64 / steps as f64).collect();
        let (model, found) =
            forces(name, &text, motions, unknowns, &times).unwrap_or_else(|why| panic!("{name}: {why}"));
        let end = run(&model, &found, unknowns, 0.5 / steps as f64);
        let last = &found[found.len() - 1];
        let charge = |place: usize| model.coordinates.get(place).is_some_and(|one| one.unit == "C");
        for (place, (part, known)) in end.iter().zip([&last.coordinates[..], &last.speeds].concat()).enumerate() {
            assert!(
                charge(place) || (part - known).abs() < 1e-9 * (1.0 + known.abs()),
                "{name}: {place} {part} {known}"
            );
        }
    }
}

/// A motor without inductance: the law of its charge gives the voltage.
#[test]
fn a_winding_without_an_inductance_needs_the_voltage_of_its_resistance() {
    let text = "title = \"disc\"\n[coordinates]\ntheta = \"rad\"\nq = \"C\"\n[bodies.disc]\nturns = \"theta\"\ninertia = \"(0.01 kg m^2)\"\n[energies]\n\
        dissipation = \"(2 ohm)/2*q'^2\"\n[inputs]\nu = \"V\"\n[[force]]\nalong = \"q\"\nis = \"u - (0.1 V s)*theta'\"\n[[torque]]\non = \"disc\"\n\
        is = \"(0.1 V s)*q'*N.z\"\n[run]\nspan = \"1 s\"\n";
    let (_, found) =
        forces("law", text, &[("theta", "sin(t*(3 rad/s))")], &["u"], &INSTANTS).unwrap_or_else(|why| panic!("{why}"));
    for Forces { time, speeds, unknowns, multipliers, .. } in found {
        let (sin, cos) = (3.0 * time).sin_cos();
        let current = 0.01 * -9.0 * sin / 0.1;
        assert!((speeds[1] - current).abs() < 1e-11 && multipliers[0].abs() < 1e-11, "{speeds:?} {multipliers:?}");
        assert!((unknowns[0] - (2.0 * current + 0.1 * 3.0 * cos)).abs() < 1e-11, "{unknowns:?}");
    }
}

#[test]
fn currents_that_a_motion_does_not_determine_are_refused_by_name() {
    let swinging = ("theta", "1 + t*(20 rad/s) + 0.1*sin(t*(4 rad/s))");
    let refused = |name: &str, text: &str, motions: &[(&str, &str)], unknowns: &[&str]| {
        forces(name, text, motions, unknowns, &[0.2]).err().unwrap_or_else(|| panic!("{name} is accepted"))
    };
    let open = refused("open", &saturated(), &[swinging], &["ua", "ub"]);
    assert!(open.contains("the motion does not determine the currents `a'`, `b'`"), "{open}");
    let more = refused("more", &saturated(), &[swinging, ("id", "0"), ("iq", "(3 A)")], &["ua", "ub"]);
    assert!(
        more.contains("no currents are found that give this motion: the equation of forces along `theta` leaves"),
        "{more}"
    );
    // unknown load, given voltage
    let loaded = ARM
        .replace("u = \"V\"", "T = \"N m\"")
        .replace("\"u\"", "\"(3 V)\"")
        .replace("[[drive]]", "[[torque]]\non = \"arm\"\nis = \"T*N.z\"\n[[drive]]");
    let start = refused("start", &loaded, &[("theta", "sin(t*(3 rad/s))")], &["T"]);
    assert!(start.contains("the law of `motor.q'` contains its rate and no unknown"), "{start}");
    // the torque is proportional to the square of the current and cannot brake
    let series = changed(
        "series_motor",
        &[("supply = \"U\"", "supply = \"u\""), ("[outputs]", "[inputs]\nu = \"V\"\n[outputs]")],
    );
    let braked = refused("braked", &series, &[("theta", "-(4 rad/s^2)*t^2 + t*(3 rad/s)")], &["u"]);
    assert!(braked.contains("no currents are found that give this motion"), "{braked}");
    let named = refused("named", ARM, &[("motor.j", "(1 A)")], &["u"]);
    assert!(named.contains("no coordinate has this name") && named.contains("motor.i"), "{named}");
    let charged = saturated()
        .replace("ua = ", "T = \"N m\"\nua = ")
        .replace("[[torque]]", "[[torque]]\non = \"rotor\"\nis = \"T*N.z\"\n[[torque]]");
    let all = [swinging, ("a", "(0 C)"), ("b", "(0 C)"), ("id", "(0 A)")];
    let alone = refused("alone", &charged, &all, &["ua", "ub", "T"]);
    assert!(alone.contains("determines the charge of each"), "{alone}");
}
