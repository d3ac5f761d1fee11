//! Diodes and freewheels, compared with closed forms and by balances that hold in every conducting state.

use super::{close, last, runs, stored};
use dalembert_scenes::ModelScene;

const HALF_WAVE: &str = "title = \"half wave\"\n[parameters]\nL = \"0.1 H\"\nR = \"10 ohm\"\nU = \"325 V\"\nw = \"314 rad/s\"\n\
                         [coordinates]\nq = \"C\"\n[energies]\ncoenergy = \"L/2*q'^2\"\ndissipation = \"R/2*q'^2\"\n\
                         [[force]]\nalong = \"q\"\nis = \"U*sin(w*t)\"\n[[diode]]\nname = \"D\"\ncurrent = \"q'\"\n\
                         [outputs]\nblocked = \"reaction(D)\"\n[run]\nspan = \"0.02 s\"\n";

/// The root of a function with one change of sign, by bisection.
pub(super) fn root(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (of(low) > 0.0) == (of(middle) > 0.0) { low = middle } else { high = middle }
    }
    low
}

/// L i' + R i = U sin wt until i is zero; then the diode D blocks -U sin wt.
#[test]
fn a_diode_stops_the_current_that_would_turn_round() {
    let (l, r, u, w) = (0.1_f64, 10.0_f64, 325.0, 314.0_f64);
    let (z, phi, decay) = (r.hypot(w * l), (w * l / r).atan(), r / l);
    let current = |t: f64| u / z * ((w * t - phi).sin() + phi.sin() * (-decay * t).exp());
    let end = root(3.3 / w, 6.2 / w, current);
    // R q is the integral of the voltage, since i is zero at both ends
    let charge = u / w * (1.0 - (w * end).cos()) / r;
    let trajectory = runs(HALF_WAVE);
    close(last(&trajectory, "q"), charge, 1e-10);
    close(last(&trajectory, "q'"), 0.0, 1e-10);
    close(last(&trajectory, "blocked"), -u * (w * 0.02).sin(), 1e-9);
}

/// A forward voltage: no current flows before U sin wt exceeds it.
#[test]
fn a_drop_is_what_the_voltage_must_exceed() {
    let text =
        HALF_WAVE.replace("current = \"q'\"\n", "current = \"q'\"\ndrop = \"100 V\"\n").replace("0.02 s", "1e-3 s");
    let text = text.replace("\"100 V\"", "\"(100 V)\"");
    let begin = (100.0 / 325.0_f64).asin() / 314.0;
    assert!(begin < 1e-3);
    close(last(&runs(&text.replace("1e-3 s", "0.9e-3 s")), "q'"), 0.0, 1e-12);
    assert!(last(&runs(&text), "q'") > 0.0);
}

/// T cos wt drives a wheel through a freewheel: both turn together until the torque is zero, then the wheel runs free.
#[test]
fn a_freewheel_lets_its_wheel_run_on() {
    let text = "title = \"freewheel\"\n[parameters]\nJ1 = \"0.01 kg m^2\"\nJ2 = \"0.1 kg m^2\"\nT = \"1 N m\"\nw = \"3 rad/s\"\n\
                [coordinates]\na = \"rad\"\nb = \"rad\"\n[bodies.engine]\nturns = \"a\"\ninertia = \"J1\"\n[bodies.wheel]\nturns = \"b\"\n\
                inertia = \"J2\"\n[[torque]]\non = \"engine\"\nis = \"T*cos(w*t)*N.z\"\n[[freewheel]]\nname = \"F\"\nspeed = \"b' - a'\"\n\
                [outputs]\nload = \"reaction(F)\"\n[run]\nspan = \"0.4 s\"\n";
    let (j1, j2, t, w) = (0.01, 0.1, 1.0, 3.0_f64);
    let driven = runs(text);
    close(last(&driven, "b'"), t / ((j1 + j2) * w) * (w * 0.4).sin(), 1e-10);
    close(last(&driven, "load"), t * (w * 0.4).cos() * j2 / (j1 + j2), 1e-10);
    let free = runs(&text.replace("0.4 s", "1 s"));
    let last_driven = t / ((j1 + j2) * w);
    close(last(&free, "b'"), last_driven, 1e-10);
    close(last(&free, "a'"), last_driven + t / (j1 * w) * (w.sin() - 1.0), 1e-9);
    close(last(&free, "load"), 0.0, 0.0);
}

/// The balances of the primary's flux and of the rotor's momentum hold in every conducting state, and no current is negative.
#[test]
fn a_rectifier_keeps_the_balances_of_flux_and_momentum() {
    let trajectory = runs(&stored("rectifier_drive"));
    let value = |name: &str| last(&trajectory, name);
    let (u, w, l1, r1, m, time) = (325.0, 314.159_26_f64, 0.5, 2.0, 68e-3, 0.1);
    let flux = l1 * value("p'") + m * (value("a'") - value("b'"));
    close(flux, u / w * (1.0 - (w * time).cos()) - r1 * value("p"), 1e-9);
    close(2e-3 * value("theta'"), 0.2 * value("motor.q") - 0.01 * value("theta"), 1e-10);
    close(value("a") + value("b"), value("motor.q"), 1e-12);
    let [a, b, blocked] = ["a'", "b'", "blocked"].map(|name| trajectory.column(name).expect("it is shown"));
    let (mut conducts, mut both) = (0, 0);
    for row in &trajectory.rows {
        assert!(row[a] > -1e-9 && row[b] > -1e-9 && row[blocked] > -1e-6, "{row:?}");
        assert!(row[a] * row[blocked] < 1e-6, "{row:?}");
        conducts += usize::from(row[a] > 1e-6);
        both += usize::from(row[a] > 1e-6 && row[b] > 1e-6);
    }
    assert!(conducts > 50 && both > 5 && conducts < trajectory.rows.len(), "{conducts} {both}");
}

#[test]
fn diodes_that_mean_nothing_are_refused_at_their_place() {
    for (from, to, message) in [
        ("current = \"q'\"", "current = \"q\"", "the current of a diode"),
        ("current = \"q'\"", "current = \"q''*(1 s)\"", "is linear in rates of coordinates"),
        ("current = \"q'\"", "current = \"q'^2/(1 A)\"", "has a speed that is linear in rates of coordinates"),
        ("current = \"q'\"", "", "`current` is missing"),
        ("current = \"q'\"", "current = \"q'\"\ndrop = \"L\"", "the drop of a diode must have the dimension"),
        ("current = \"q'\"", "current = \"q'\"\nside = \"one\"", "unknown key `side`"),
        ("reaction(D)", "gap(D)", "`D` is a diode, which has a `reaction` alone"),
        ("[[diode]]", "[diode]", "double brackets"),
        ("[run]", "[start]\n\"q'\" = \"-1 A\"\n[run]", "starts with a speed against it"),
    ] {
        assert!(HALF_WAVE.contains(from), "{from}");
        let changed = HALF_WAVE.replacen(from, to, 1);
        let found = ModelScene::parse("scene.toml", &changed);
        let said = found.map_or_else(|error| error.to_string(), |_| panic!("it is read: {to}"));
        assert!(said.contains(message), "{message}: {said}");
    }
}

/// Two diodes in series block and conduct together; the blocked voltage does not contain the forward voltage.
#[test]
fn diodes_of_one_current_change_together() {
    let second = "[[diode]]\nname = \"E\"\ncurrent = \"q'\"\n[outputs]";
    let text = HALF_WAVE.replace("[outputs]", second).replace("0.02 s", "0.06 s");
    let trajectory = runs(&text);
    assert_eq!(trajectory.passages.len(), runs(&HALF_WAVE.replace("0.02 s", "0.06 s")).passages.len());
    close(last(&trajectory, "q'"), 0.0, 1e-9);
    let dropped = HALF_WAVE.replace("current = \"q'\"\n", "current = \"q'\"\ndrop = \"(0.7 V)\"\n");
    close(last(&runs(&dropped), "blocked"), -325.0 * (314.0 * 0.02_f64).sin(), 1e-9);
}
