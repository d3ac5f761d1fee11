//! Systems without inertia whose law changes: switched circuits without inductances, and massless points with dry friction, compared with
//! closed forms.

use super::one_ways::root;
use super::{close, last, runs, stored};
use dalembert_scenes::ModelScene;
use simulation::Trajectory;

const RC: &str = "title = \"RC\"\n[parameters]\nV = \"10 V\"\nR = \"1 ohm\"\nC = \"1 mF\"\nw = \"3141.592653589793 rad/s\"\n\
    [coordinates]\nq = \"C\"\n[energies]\npotential = \"q^2/(2*C)\"\ndissipation = \"R/2*q'^2\"\n[[force]]\nalong = \"q\"\n\
    is = \"if(sin(w*t) > 0, V, 0*V)\"\n[outputs]\nu = \"q/C\"\n[run]\nspan = \"9.5 ms\"\n";

/// The times of all events after the start.
fn times(trajectory: &Trajectory) -> Vec<f64> {
    trajectory.passages[1..].iter().map(|passage| passage.time).collect()
}

/// In each half period the voltage u approaches V or 0 by an equal factor.
#[test]
fn a_square_wave_charges_and_discharges_a_capacitor() {
    let trajectory = runs(RC);
    let after = |from: f64, to: f64, time: f64| to + (from - to) * (-time / 1e-3_f64).exp();
    let u = (0..9).fold(0.0, |u, half| after(u, if half % 2 == 0 { 10.0 } else { 0.0 }, 1e-3));
    let u = after(u, 0.0, 0.5e-3);
    close(last(&trajectory, "u"), u, 1e-10);
    close(last(&trajectory, "q'"), -u, 1e-10);
    for (place, time) in times(&trajectory).into_iter().enumerate() {
        close(time, 1e-3 * (place + 1) as f64, 1e-17 + 1e-15);
    }
}

/// The current falls from 10 A to 5 A in R C ln 2, and jumps above 5 A when the source is switched on again at 2 ms.
#[test]
fn an_event_happens_where_a_current_jumps_over_its_bound() {
    for (direction, time) in [("down", 1e-3 * 2.0_f64.ln()), ("up", 2e-3)] {
        let event = format!("[[event]]\nwhen = \"q' - (5 A)\"\ndirection = \"{direction}\"\nend = true\n[run]");
        let trajectory = runs(&RC.replace("[run]", &event));
        close(trajectory.outcome.time, time, 1e-14);
    }
    let counted = "[[event]]\nname = \"over\"\nwhen = \"q' - (5 A)\"\nset = { q = \"q\" }\n[run]";
    let trajectory = runs(&RC.replace("[run]", counted).replace("9.5 ms", "3.5 ms"));
    let passed = trajectory.passages.iter().filter(|passage| passage.what.contains("over")).count();
    assert_eq!(passed, 3, "{:?}", trajectory.passages);
}

/// |U sin wt| across a resistor: the charge that flows through it.
#[test]
fn a_rectified_sine_passes_its_mean() {
    let text = RC.replace("potential = \"q^2/(2*C)\"\n", "").replace("u = \"q/C\"", "u = \"R*q'\"");
    let text = text.replace("if(sin(w*t) > 0, V, 0*V)", "abs(V*sin(w*t))").replace("9.5 ms", "10 ms");
    let trajectory = runs(&text);
    close(last(&trajectory, "q"), 10.0 * 2.0 * 10.0 / 3_141.592_653_589_793, 1e-13);
}

/// Capacitor and resistor at a node: the reaction of the node is its voltage, with a source that changes at a condition and with a constant one.
#[test]
fn the_reaction_of_a_node_is_its_voltage() {
    let text = RC.replace("q = \"C\"\n", "q = \"C\"\nc = \"C\"\nr = \"C\"\n").replace("q^2/(2*C)", "c^2/(2*C)");
    let text = text.replace("R/2*q'^2", "R/2*(q'^2 + r'^2)").replace("q/C", "c/C");
    let node = "[[constraint]]\nname = \"node\"\nzero = \"q' - c' - r'\"\n[outputs]\nnode = \"reaction(node)\"\n";
    let switched = text.replace("[outputs]\n", node);
    for text in [&switched, &switched.replace("if(sin(w*t) > 0, V, 0*V)", "V")] {
        let trajectory = runs(text);
        let voltage = last(&trajectory, "u");
        assert!(voltage > 1.0, "{voltage}");
        close(last(&trajectory, "node"), -voltage, 1e-12);
        close(last(&trajectory, "r'"), voltage, 1e-12);
    }
}

/// The source is on below 4 V: the capacitor reaches this voltage and stays there, and the mean of the source is 4 V.
#[test]
fn a_relay_that_chatters_holds_its_voltage() {
    let text = RC.replace("if(sin(w*t) > 0, V, 0*V)", "if(q/C < (4 V), V, 0*V)");
    let text = text.replace("[run]", "mean = \"if(q/C < (4 V), V, 0*V)\"\n[run]");
    let trajectory = runs(&text);
    close(times(&trajectory)[0], 1e-3 * (10.0_f64 / 6.0).ln(), 1e-14);
    assert_eq!(trajectory.passages.len(), 2, "{:?}", trajectory.passages);
    close(last(&trajectory, "u"), 4.0, 1e-13);
    close(last(&trajectory, "mean"), 4.0, 1e-12);
    close(last(&trajectory, "q'"), 0.0, 1e-13);
}

/// The negative source would discharge through the diode, which blocks its voltage; no chattering occurs.
#[test]
fn a_relay_behind_a_diode_comes_to_rest() {
    let text =
        RC.replace("potential = \"q^2/(2*C)\"\n", "").replace("if(sin(w*t) > 0, V, 0*V)", "if(q < (5 mC), V, -V/2)");
    let diode = "[[diode]]\nname = \"D\"\ncurrent = \"q'\"\n[outputs]\nblocked = \"reaction(D)\"\n";
    let trajectory = runs(&text.replace("[outputs]\nu = \"q/C\"\n", diode));
    close(times(&trajectory)[0], 0.5e-3, 1e-15);
    assert_eq!(trajectory.passages.len(), 2, "{:?}", trajectory.passages);
    close(last(&trajectory, "q"), 5e-3, 1e-15);
    close(last(&trajectory, "blocked"), 5.0, 1e-12);
}

const RECTIFIER: &str = "title = \"rectifier\"\n[parameters]\nR = \"10 ohm\"\nU = \"325 V\"\nw = \"314.1592653589793 rad/s\"\nC0 = \"1 mF\"\n\
    [coordinates]\nq = \"C\"\n[energies]\ndissipation = \"R/2*q'^2\"\n[[force]]\nalong = \"q\"\nis = \"U*sin(w*t)\"\n\
    [[diode]]\nname = \"D\"\ncurrent = \"q'\"\n[outputs]\nblocked = \"reaction(D)\"\n[run]\nspan = \"0.095 s\"\n";

/// i = max(0, U sin wt)/R: each positive half wave carries the charge 2 U/(R w).
#[test]
fn a_diode_with_a_resistor_cuts_off_half_waves() {
    let trajectory = runs(RECTIFIER);
    close(last(&trajectory, "q"), 5.0 * 2.0 * 325.0 / (10.0 * 314.159_265_358_979_3), 1e-12);
    close(last(&trajectory, "q'"), 0.0, 0.0);
    close(last(&trajectory, "blocked"), 325.0, 1e-9);
    let dropped =
        RECTIFIER.replace("current = \"q'\"\n", "current = \"q'\"\ndrop = \"(100 V)\"\n").replace("0.095 s", "6 ms");
    let trajectory = runs(&dropped);
    close(times(&trajectory)[0], (100.0 / 325.0_f64).asin() / 314.159_265_358_979_3, 1e-16);
    close(last(&trajectory, "q'"), (325.0 * (314.159_265_358_979_3 * 6e-3_f64).sin() - 100.0) / 10.0, 1e-11);
}

/// While the diode D conducts, the capacitor has the voltage of the source, until C U w cos wt + U/R sin wt = 0. Then its voltage decays
/// through the load until the voltage of the source is higher again.
#[test]
fn a_smoothing_capacitor_decays_between_the_tops_of_its_source() {
    let text = RECTIFIER.replace("q = \"C\"\n", "q = \"C\"\nc = \"C\"\n");
    let text =
        text.replace("dissipation = \"R/2*q'^2\"", "dissipation = \"R/2*(q' - c')^2\"\npotential = \"c^2/(2*C0)\"");
    let text = text.replace("0.095 s", "0.03 s");
    let w: f64 = 314.159_265_358_979_3;
    let trajectory = runs(&text);
    let [end, begin, again] = times(&trajectory)[..] else { panic!("{:?}", trajectory.passages) };
    close(end, (std::f64::consts::PI - (w * 10.0 * 1e-3).atan()) / w, 1e-15);
    close((w * begin).sin(), (w * end).sin() * (-(begin - end) / 10e-3).exp(), 1e-12);
    close(again, end + 0.02, 1e-15);
    let voltage = 325.0 * (w * end).sin() * (-(0.03 - again) / 10e-3).exp();
    close(last(&trajectory, "c"), 1e-3 * voltage, 1e-11);
    // with a resistance of the source the voltage decays in the same way between two events
    let text = text.replace("R/2*(q' - c')^2", "R/2*(q' - c')^2 + R/20*q'^2").replace("0.03 s", "0.015 s");
    let trajectory = runs(&text);
    let [end] = times(&trajectory)[..] else { panic!("{:?}", trajectory.passages) };
    close(last(&trajectory, "c"), 1e-3 * 325.0 * (w * end).sin() * (-(0.015 - end) / 10e-3).exp(), 1e-11);
}

/// A bridge of four diodes a, b, c, d: a and d conduct in one direction of the source, b and c in the other.
fn bridge(coordinate: &str, energies: &str, constraints: &str, supplied: &[&str], span: &str) -> String {
    let diodes =
        ["a", "b", "c", "d"].map(|name| format!("[[diode]]\nname = \"{name}{name}\"\ncurrent = \"{name}'\"\n"));
    let sources = supplied.iter().map(|of| match of.strip_prefix('-') {
        None => format!("[[force]]\nalong = \"{of}\"\nis = \"U*sin(w*t)\"\n"),
        Some(of) => format!("[[force]]\nalong = \"{of}\"\nis = \"-U*sin(w*t)\"\n"),
    });
    format!(
        "title = \"bridge\"\n[parameters]\nL = \"5 mH\"\nR = \"10 ohm\"\nU = \"325 V\"\nw = \"314.1592653589793 rad/s\"\nC0 = \"1 mF\"\n\
         [coordinates]\n{coordinate}a = \"C\"\nb = \"C\"\nc = \"C\"\nd = \"C\"\n[energies]\n{energies}[[constraint]]\nzero = {constraints}\n\
         {}{}[outputs]\nload = \"R*(a' + c')\"\n[run]\nspan = \"{span}\"\n",
        sources.collect::<String>(),
        diodes.concat()
    )
}

#[test]
fn a_bridge_with_a_resistor_gives_the_size_of_its_voltage() {
    let text = bridge("", "dissipation = \"R/2*(a' + c')^2\"\n", "\"a' + c' - b' - d'\"", &["a", "-b"], "0.033 s");
    let trajectory = runs(&text);
    let load = trajectory.column("load").expect("it is shown");
    for (time, row) in trajectory.times.iter().zip(&trajectory.rows) {
        close(row[load], (325.0 * (314.159_265_358_979_3 * time).sin()).abs(), 1e-9);
    }
    assert_eq!(times(&trajectory).len(), 3);
}

/// C u' = i - u/R with Rs i = U sin wt - u, from u = 0 until i = 0; the distribution of voltages among the diodes causes no events.
#[test]
fn a_bridge_charges_a_capacitor_until_its_current_is_spent() {
    let trajectory = runs(&stored("bridge_rectifier"));
    let (u, w, rs, r, c) = (325.0, 314.159_26_f64, 0.5, 100.0, 1e-3);
    let rate = 1.0 / (c * rs) + 1.0 / (c * r);
    let charged = |t: f64| {
        let (sin, cos) = (w * t).sin_cos();
        u / (c * rs) / (rate * rate + w * w) * (rate * sin - w * cos + w * (-rate * t).exp())
    };
    let end = root(4e-3, 9e-3, |t| u * (w * t).sin() - charged(t));
    close(times(&trajectory)[0], end, 1e-13);
    let begin = root(1e-2, 1.5e-2, |t| -u * (w * t).sin() - charged(end) * (-(t - end) / (r * c)).exp());
    close(times(&trajectory)[1], begin, 1e-12);
    assert_eq!(times(&trajectory).len(), 9, "{:?}", trajectory.passages);
}

/// The inductance of the line ends each conduction interval where its current is zero. The voltage is that of one diode fed by |U sin wt|.
#[test]
fn a_bridge_between_an_inductance_and_a_capacitor_is_one_diode_behind_a_rectified_source() {
    let energies = "coenergy = \"L/2*s'^2\"\npotential = \"p^2/(2*C0)\"\ndissipation = \"R/2*(a' + c' - p')^2\"\n";
    let nodes = "[\"s' - a' + b'\", \"s' - d' + c'\"]";
    let four = runs(&bridge("s = \"C\"\np = \"C\"\n", energies, nodes, &["s"], "0.06 s"));
    let one = RECTIFIER.replace("q = \"C\"\n", "q = \"C\"\np = \"C\"\n").replace("0.095 s", "0.06 s");
    let one = one.replace("U*sin(w*t)", "abs(U*sin(w*t))").replace(
        "dissipation = \"R/2*q'^2\"",
        "coenergy = \"(2.5 mH)*q'^2\"\npotential = \"p^2/(2*C0)\"\ndissipation = \"R/2*(q' - p')^2\"",
    );
    let one = runs(&one);
    for name in ["p", "p'"] {
        close(last(&four, name), last(&one, name), 1e-9);
    }
    for place in ["a'", "b'", "c'", "d'"].map(|name| four.column(name).expect("it is shown")) {
        assert!(four.rows.iter().all(|row| row[place] > -1e-9));
    }
}

/// During commutation both diodes of a leg conduct, and the source alone changes the current of the line: L s' = U/w (cos wt1 - cos wt).
#[test]
fn diodes_between_two_inductances_take_over_from_each_other() {
    let energies = "coenergy = \"L/2*s'^2 + 2*L*l'^2\"\ndissipation = \"R/2*l'^2\"\n";
    let nodes = "[\"s' - a' + b'\", \"s' - d' + c'\", \"a' + c' - l'\"]";
    let trajectory = runs(&bridge("s = \"C\"\nl = \"C\"\n", energies, nodes, &["s"], "0.011 s"));
    let both = times(&trajectory)[0];
    let [line, load] = ["s'", "l'"].map(|name| trajectory.column(name).expect("it is shown"));
    let angle = |time: f64| (314.159_265_358_979_3 * time).cos();
    let rows = trajectory.times.iter().zip(&trajectory.rows).filter(|(time, _)| **time > both);
    let rows: Vec<(&f64, &Vec<f64>)> = rows.collect();
    assert!(rows.len() > 5);
    for pair in rows.windows(2) {
        let [(before, from), (now, to)] = [pair[0], pair[1]];
        let change = 325.0 / 314.159_265_358_979_3 / 5e-3 * (angle(*before) - angle(*now));
        close(to[line] - from[line], change, 1e-8);
        // the current of the load decays with the time constant L/R
        close(to[load], from[load] * (-(now - before) * 10.0 / 20e-3).exp(), 1e-8);
    }
}

/// A mass on a spring whose other end is held by dry friction only: it sticks, slips at a constant force, and sticks again.
#[test]
fn a_spring_slips_where_dry_friction_holds_it_no_more() {
    let text = "title = \"Jenkin\"\n[parameters]\nm = \"1 kg\"\nk = \"100 N/m\"\nF = \"5 N\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies.block]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[energies]\npotential = \"k/2*(x - y)^2\"\n[[force]]\nalong = \"y\"\n\
        is = \"-F*sign(y')\"\n[outputs]\nfriction = \"F*sign(y')\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n";
    let trajectory = runs(text);
    let slips = (5.0 * 10.0 / 100.0_f64).asin() / 10.0;
    let speed = (10.0 * slips).cos();
    let [begin, end] = times(&trajectory)[..] else { panic!("{:?}", trajectory.passages) };
    close(begin, slips, 1e-14);
    close(end, slips + speed / 5.0, 1e-13);
    let slipped = speed * speed / 10.0;
    close(last(&trajectory, "y"), slipped, 1e-12);
    let angle = 10.0 * (1.0 - end);
    close(last(&trajectory, "x"), slipped + 0.05 * angle.cos(), 1e-11);
    close(last(&trajectory, "friction"), 5.0 * angle.cos(), 1e-9);
}

/// A spring pulled at constant speed, with a damper and dry friction at its end: beyond the limit of friction c y' = k (v t - y) - F.
#[test]
fn a_damper_beside_dry_friction_begins_to_move_at_its_bound() {
    let text = "title = \"creep\"\n[parameters]\nk = \"100 N/m\"\nF = \"5 N\"\nc = \"20 N s/m\"\nv = \"1 m/s\"\n[coordinates]\ny = \"m\"\n\
        [energies]\npotential = \"k/2*(v*t - y)^2\"\ndissipation = \"c/2*y'^2\"\n[[force]]\nalong = \"y\"\nis = \"-F*sign(y')\"\n\
        [run]\nspan = \"1 s\"\n";
    let trajectory = runs(text);
    close(times(&trajectory)[0], 0.05, 1e-15);
    let (time, rest) = (0.95, 0.2_f64);
    close(last(&trajectory, "y"), time - rest * (1.0 - (-time / rest).exp()), 1e-11);
    close(last(&trajectory, "y'"), 1.0 - (-time / rest).exp(), 1e-11);
}

/// The slip decays exponentially, down to rounding errors, and the speed does not reverse.
#[test]
fn a_slip_that_dies_away_does_not_turn_round() {
    let text = "title = \"rest\"\n[parameters]\nk = \"100 N/m\"\nF = \"2 N\"\nc = \"2 N s/m\"\n[coordinates]\ny = \"m\"\n\
        [energies]\npotential = \"k/2*y^2\"\ndissipation = \"c/2*y'^2\"\n[[force]]\nalong = \"y\"\nis = \"(3 N) - F*sign(y')\"\n\
        [run]\nspan = \"2 s\"\n";
    let trajectory = runs(text);
    close(last(&trajectory, "y"), 0.01, 1e-11);
    let speed = trajectory.column("y'").expect("it is shown");
    for (time, row) in trajectory.times.iter().zip(&trajectory.rows) {
        close(row[speed], 0.5 * (-50.0 * time).exp(), 1e-10);
    }
}

/// J w' = k i with i = (U - k w)/R: w approaches U/k or zero by an equal factor in each half period of the chopper. In the second system
/// an additional resistance acts on currents above 10 A.
#[test]
fn a_motor_without_an_inductance_is_fed_by_a_chopper_and_by_a_limiter() {
    let text = "title = \"motor\"\n[parameters]\nJ = \"1e-3 kg m^2\"\nR = \"0.5 ohm\"\nk = \"0.05 V s\"\nU = \"12 V\"\nw = \"628.3185307179587 rad/s\"\n\
        [coordinates]\ntheta = \"rad\"\nq = \"C\"\n[bodies.disc]\nturns = \"theta\"\ninertia = \"J\"\n[energies]\ndissipation = \"R/2*q'^2\"\n\
        [[force]]\nalong = \"q\"\nis = \"if(sin(w*t) > 0, U, 0*U) - k*theta'\"\n[[force]]\nalong = \"theta\"\nis = \"k*q'\"\n[run]\nspan = \"0.0975 s\"\n";
    let after = |from: f64, to: f64, time: f64| to + (from - to) * (-5.0 * time).exp();
    let speed = (0..19).fold(0.0, |speed, half| after(speed, if half % 2 == 0 { 240.0 } else { 0.0 }, 5e-3));
    let speed = after(speed, 0.0, 2.5e-3);
    let trajectory = runs(text);
    close(last(&trajectory, "theta'"), speed, 1e-9);
    close(last(&trajectory, "q'"), -0.05 * speed / 0.5, 1e-10);
    // U = R i + (2 ohm) (i - 10 A) + k w, until U - k w = R (10 A)
    let limited =
        text.replace("if(sin(w*t) > 0, U, 0*U)", "U - (2 ohm)*max(q' - (10 A), 0)").replace("0.0975 s", "2 s");
    let trajectory = runs(&limited);
    let free = -(1.0 - 140.0 / 640.0_f64).ln();
    close(times(&trajectory)[0], free, 1e-12);
    close(last(&trajectory, "theta'"), after(140.0, 240.0, 2.0 - free), 1e-8);
}

#[test]
fn laws_that_change_and_cannot_be_solved_are_refused_by_their_reason() {
    let springs = "title = \"springs\"\n[parameters]\nk = \"100 N/m\"\nF = \"5 N\"\n[coordinates]\ny = \"m\"\n[energies]\n\
        potential = \"k/2*y^2\"\n[[force]]\nalong = \"y\"\nis = \"if(t < (1 s), F, 0*F)\"\n[run]\nspan = \"2 s\"\n";
    let nonlinear = RC.replace("R/2*q'^2", "R/2*q'^2 + R*q'^4/(1 A)^2");
    let against = RC.replace("[run]", "[start]\n\"q'\" = \"1 A\"\n[run]");
    let damped = springs.replace("k/2*y^2\"\n", "k/2*y^2\"\ndissipation = \"(1 N s/m)/2*y'^2\"\n");
    let lid = "[coordinates]\nx = \"m\"\n[bodies.lid]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n[[contact]]\nof = \"lid\"\nthrough = \"O\"\nnormal = \"N.x\"\nfriction = \"0.3 + y'/(1 m/s)\"\n";
    let (contact, table) = lid.split_at(lid.find("[bodies").unwrap_or(0));
    let contact = damped.replace("[coordinates]\n", contact).replace("[[force]]", &format!("{table}[[force]]"));
    for (text, message) in [
        (springs, "holds a condition and no speed"),
        (&nonlinear, "is not linear in the speeds without inertia"),
        (&against, "the law of `q` does not hold at the start"),
        (&contact, "a contact between bodies holds its speed"),
    ] {
        let said =
            ModelScene::parse("scene.toml", text).map_or_else(|error| error.to_string(), |_| panic!("{message}"));
        assert!(said.contains(message), "{message}: {said}");
    }
}
