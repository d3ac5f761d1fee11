//! Numbers are exact decimals as written: sums of decimals that vanish are zero and not rounding errors.

use super::{all, asked, model};
use dalembert_scenes::steady_motions::{EnclosedSpectrum, SteadyMotions, SteadyStability};

/// A quartic spring and three linear ones with 0.1 + 0.2 - 0.3 = 0.
fn springs(sum: &str) -> String {
    format!(
        "title = \"Springs\"\n[parameters]\nm = \"1 kg\"\nk1 = \"0.1 N/m\"\nk2 = \"0.2 N/m\"\nk3 = \"0.3 N/m\"\nc = \"1 N/m^3\"\n[coordinates]\nx = \"m\"\n\
         [energies]\nkinetic = \"m*x'^2/2\"\npotential = \"({sum})*x^2/2 + c*x^4/4\"\n"
    )
}

#[test]
fn springs_that_cancel_leave_one_equilibrium() {
    for sum in ["k1 + k2 - k3", "k3 - k1 - k2"] {
        let found = all(&springs(sum), &[("x", -1.0, 1.0)]);
        assert!(found.is_complete(), "{found:?}");
        let [motion] = &found.motions[..] else { panic!("{:?}", found.motions) };
        assert!(motion.state[0] == 0.0 && matches!(motion.stability, SteadyStability::Minimum), "{motion:?}");
    }
}

#[test]
fn eigenvalues_of_springs_that_cancel_are_zero() {
    let text = springs("k1 + k2 - k3");
    let found = EnclosedSpectrum::near(&model(&text), &[0.0, 0.0], || true).expect("they are enclosed");
    assert!(found.discs.iter().all(|disc| disc.centre == [0.0; 2]), "{found:?}");
    assert_eq!(found.exact.map(|routh| (routh.left, routh.axis, routh.right, routh.unexplained)), Some((0, 0, 0, 2)));
}

/// A given speed is an exact decimal, too: w l = 0.1 * 3 = 0.3.
#[test]
fn a_given_speed_is_the_decimal_that_was_written() {
    let text = "title = \"Slider\"\n[parameters]\nm = \"1 kg\"\nv = \"0.3 rad/s\"\nn = \"3\"\nk = \"1 J s\"\nc = \"1 J\"\nJ = \"1 kg m^2\"\n[coordinates]\nphi = \"rad\"\nx = \"rad\"\n\
        [energies]\nkinetic = \"J*(phi'^2 + x'^2)/2\"\n[[force]]\nalong = \"x\"\nis = \"k*(n*phi' - v)*x - c*x^3\"\n";
    let found = SteadyMotions::of(&model(text), &asked(&[("x", -1.0, 1.0), ("phi'", 0.1, 0.1)], 10_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.is_complete() && found.motions.len() == 1 && found.motions[0].state[1] == 0.0, "{found:?}");
}
