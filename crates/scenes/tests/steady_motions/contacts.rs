//! Equilibria in contact with curves whose normal vector is not normalised, and equilibria with open contacts.

use super::{asked, model};
use dalembert_scenes::steady_motions::{EnclosedVerdict, SteadyMotion, SteadyMotions, SteadyStability};

fn motions(text: &str, ranges: &[(&str, f64, f64)]) -> Vec<SteadyMotion> {
    let found = SteadyMotions::of_cases(&model(text), &asked(ranges, 20_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    found.into_iter().flat_map(|(_, own)| own.motions).collect()
}

/// A bead on the parabola y = a x^2, with a spring along x towards x = b.
fn parabola(spring: &str, more: &str) -> String {
    format!(
        "title = \"Parabola\"\ngravity = \"-(10 m/s^2)*N.y\"\n[parameters]\na = \"0.5 1/m\"\nk = \"{spring}\"\nb = \"1 m\"\n[coordinates]\nx = \"m\"\n\
         y = \"m\"\n[bodies]\np = {{ centre = \"O + x*N.x + y*N.y\", mass = \"1 kg\" }}\n[[contact]]\nname = \"c\"\nof = \"p\"\n\
         gap = \"y - a*x^2\"\nnormal = \"N.y - 2*a*x*N.x\"\n[[force]]\non = \"p\"\nis = \"-k*(x - b)*N.x{more}\"\n"
    )
}

const AROUND: [(&str, f64, f64); 2] = [("x", -3.03, 2.91), ("y", -1.0, 6.0)];

#[test]
fn a_contact_whose_gap_is_no_distance_is_judged_by_the_energy_along_it() {
    // along the curve V = (k/2)(x - b)^2 + m g a x^2: a minimum at x = k b/(k + 2 m g a) for k > -2 m g a, otherwise a maximum
    for (k, at, is_stable) in [(5.0, 1.0 / 3.0, true), (-20.0, 2.0, false)] {
        let found = motions(&parabola(&format!("{k} N/m"), ""), &AROUND);
        let [motion] = &found[..] else { panic!("{found:?}") };
        assert!((motion.state[0] - at).abs() < 1e-9, "{motion:?}");
        match is_stable {
            true => assert!(matches!(motion.stability, SteadyStability::Minimum), "{motion:?}"),
            false => assert!(matches!(motion.stability, SteadyStability::Falls(1)), "{motion:?}"),
        }
    }
}

#[test]
fn with_damping_motions_in_touch_that_grow_decide_and_those_that_fade_do_not() {
    let damped = " - (2 N s/m)*x'*N.x";
    let found = motions(&parabola("-20 N/m", damped), &AROUND);
    let [motion] = &found[..] else { panic!("{found:?}") };
    let SteadyStability::Linear(own) = &motion.stability else { panic!("{motion:?}") };
    let enclosed = own.enclosed.as_ref().expect("they are enclosed");
    assert_eq!(enclosed.verdict(), EnclosedVerdict::Unstable(1));
    // a damper and a minimum of the energy: stable
    let found = motions(&parabola("5 N/m", damped), &AROUND);
    let [motion] = &found[..] else { panic!("{found:?}") };
    assert!(matches!(motion.stability, SteadyStability::MinimumWithLoss), "{motion:?}");
    // a transverse force without a potential
    let found = motions(&parabola("5 N/m", " - (2 N s/m)*x'*N.x + (0.1 N/m)*(x*N.y - y*N.x)"), &AROUND);
    let [motion] = &found[..] else { panic!("{found:?}") };
    let SteadyStability::InTouch(own) = &motion.stability else { panic!("{motion:?}") };
    assert_eq!(own.enclosed.as_ref().map(|own| own.verdict()), Ok(EnclosedVerdict::Asymptotic));
}

#[test]
fn a_rough_contact_that_is_open_leaves_the_energy() {
    let text = parabola("5 N/m", " + (30 N)*N.y - (15 N/m)*(y - (3 m))*N.y")
        .replace("[[force]]", "friction = \"0.3\"\n[[force]]");
    let found = SteadyMotions::of_cases(&model(&text), &asked(&AROUND, 20_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let open: Vec<&SteadyMotion> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = &open[..] else { panic!("{open:?}") };
    assert!(matches!(motion.stability, SteadyStability::Minimum), "{motion:?}");
}
