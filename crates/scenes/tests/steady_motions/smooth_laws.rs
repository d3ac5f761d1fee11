//! Contacts without friction, and laws with equal derivatives on both sides of a condition.

use super::{asked, model};
use dalembert_scenes::steady_motions::{
    Case, EnclosedSpectrum, EnclosedVerdict, SteadyMotion, SteadyMotions, SteadyStability,
};

fn motions(text: &str, ranges: &[(&str, f64, f64)]) -> Vec<(Vec<Case>, SteadyMotion)> {
    let found = SteadyMotions::of_cases(&model(text), &asked(ranges, 10_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    found.into_iter().flat_map(|(cases, own)| own.motions.into_iter().map(move |one| (cases.clone(), one))).collect()
}

/// A block on a floor with a horizontal spring of the given stiffness.
fn block(friction: &str, stiffness: &str) -> String {
    format!(
        "title = \"Block\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nk = \"{stiffness}\"\nmu = \"0\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [bodies]\nb = {{ centre = \"O + x*N.x + y*N.y\", mass = \"m\" }}\n[energies]\npotential = \"k*x^2/2\"\n\
         [[contact]]\nname = \"floor\"\nof = \"b\"\nthrough = \"O\"\nnormal = \"N.y\"\n{friction}\n"
    )
}

#[test]
fn a_contact_whose_friction_is_zero_is_smooth() {
    let ranges = [("x", -1.0, 1.0), ("y", -1.0, 1.0)];
    for friction in ["", "friction = \"0\"", "friction = \"mu\"", "friction = \"mu - mu\""] {
        let found = motions(&block(friction, "50 N/m"), &ranges);
        let [(_, motion)] = &found[..] else { panic!("{friction}: {found:?}") };
        assert!(matches!(motion.stability, SteadyStability::Minimum), "{friction}: {motion:?}");
        assert_eq!(motion.state[..2], [0.0, 0.0], "{motion:?}");
        let found = motions(&block(friction, "-50 N/m"), &ranges);
        let [(_, motion)] = &found[..] else { panic!("{friction}: {found:?}") };
        assert!(matches!(motion.stability, SteadyStability::Falls(1)), "{friction}: {motion:?}");
    }
}

fn oscillator(force: &str) -> String {
    format!(
        "title = \"One\"\n[parameters]\nm = \"1 kg\"\nk = \"2 N/m\"\nc = \"1 N/m^2\"\nd = \"1 N s/m\"\ne = \"1 N s^2/m^2\"\n[coordinates]\nx = \"m\"\n\
         [bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"m\" }}\n[[force]]\non = \"b\"\nis = \"({force})*N.x\"\n"
    )
}

#[test]
fn a_law_with_one_derivative_on_both_sides_is_judged_by_its_linear_equations() {
    for force in [
        "-k*x - c*abs(x)*x - d*x'",
        "-k*x - e*abs(x')*x' - d*x'",
        "-k*x - d*x' - sign(x)*c*x^2",
        "-k*x - d*x' - if(x > (0 m), c*x^2, c*x^2/2)",
    ] {
        let text = oscillator(force);
        let found = motions(&text, &[("x", -1.0, 1.0)]);
        let [(_, motion)] = &found[..] else { panic!("{force}: {found:?}") };
        let SteadyStability::Linear(eigenvalues) = &motion.stability else { panic!("{force}: {motion:?}") };
        let enclosed = eigenvalues.enclosed.as_ref().expect("they are enclosed");
        assert_eq!(enclosed.verdict(), EnclosedVerdict::Asymptotic, "{force}: {enclosed:?}");
        let near = EnclosedSpectrum::near(&model(&text), &[0.0, 0.0], || true).expect("they are enclosed");
        assert_eq!(near.verdict(), EnclosedVerdict::Asymptotic, "{force}: {near:?}");
    }
}

#[test]
fn a_law_whose_derivative_jumps_has_a_kink() {
    for force in ["-k*x - if(x > (0 m), k*x, (0 N)) - d*x'", "-k*x - d*abs(x') - d*x'"] {
        let text = oscillator(force);
        let found = motions(&text, &[("x", -1.0, 1.0)]);
        let [(_, motion)] = &found[..] else { panic!("{force}: {found:?}") };
        assert!(!matches!(motion.stability, SteadyStability::Linear(_)), "{force}: {motion:?}");
        assert!(EnclosedSpectrum::near(&model(&text), &[0.0, 0.0], || true).is_err(), "{force}");
    }
}

/// A particle on springs in a plane, with linear damping. A drag proportional to the square of its speed does not change the verdict of the linear
/// equations; a drag proportional to |v| has no derivative at rest, and no verdict is given.
#[test]
fn a_drag_with_the_length_of_the_velocity_has_no_part_in_the_linear_equations_at_rest() {
    let verdict = |stiffness: &str, drag: &str| {
        let text = format!(
            "title = \"Plane\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\np = {{ centre = \"P\", mass = \"1 kg\" }}\n\
             [[force]]\non = \"p\"\nis = \"-(2 N/m)*x*N.x - ({stiffness} N/m)*y*N.y - (1 N s/m)*velocity(P) - {drag}\"\n\
             [outputs]\nspeed = \"norm(velocity(P))\"\n"
        );
        let found = SteadyMotions::of(&model(&text), &asked(&[("x", -1.0, 1.1), ("y", -1.0, 1.1)], 2_000), || true);
        let found = found.unwrap_or_else(|why| panic!("{why:?}"));
        let [motion] = &found.motions[..] else { panic!("{found:?}") };
        match &motion.stability {
            SteadyStability::Linear(own) => own.enclosed.as_ref().ok().map(EnclosedSpectrum::verdict),
            _ => None,
        }
    };
    let quadratic = "(3 kg/m)*norm(velocity(P))*velocity(P)";
    assert_eq!(verdict("3", quadratic), Some(EnclosedVerdict::Asymptotic));
    assert_eq!(verdict("-3", quadratic), Some(EnclosedVerdict::Unstable(1)));
    // |v| has no derivative at rest
    assert_eq!(verdict("3", "(3 N s/m)*norm(velocity(P))*N.x"), None);
}

/// Drag and cubic damping take power at all speeds: a minimum of the potential energy is stable although the linear equations keep their energy.
#[test]
fn a_minimum_with_drag_of_a_higher_order_alone_is_stable_by_its_energy() {
    let links = |loads: &str| {
        format!(
            "title = \"Links\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\n[frames]\nA = \"N turned a about z\"\n\
             B = \"N turned b about z\"\n[points]\nP = \"O - (0.5 m)*A.y\"\nQ = \"P - (0.4 m)*B.y\"\n[bodies]\np = {{ centre = \"P\", mass = \"1 kg\" }}\n\
             q = {{ centre = \"Q\", mass = \"2 kg\" }}\n{loads}"
        )
    };
    let drag = |body: &str, sign: &str| {
        format!("[[force]]\non = \"{body}\"\nis = \"{sign}(0.3 kg/m)*norm(velocity({body}))*velocity({body})\"\n")
    };
    let damper = |factor: &str| format!("[[force]]\nalong = \"a\"\nis = \"{factor}*a'^3\"\n");
    let lowest = |loads: &str| {
        let found = motions(&links(loads), &[("a", -1.0, 1.0), ("b", -1.0, 1.0)]);
        let [(_, motion)] = &found[..] else { panic!("{loads}: {found:?}") };
        motion.stability.clone()
    };
    let both = drag("p", "-") + &drag("q", "-");
    for loads in [both.clone(), drag("q", "-"), damper("-(0.1 N m s^3)"), both + &damper("-(0.1 N m s^3)")] {
        assert!(matches!(lowest(&loads), SteadyStability::MinimumWithLoss), "{loads}: {:?}", lowest(&loads));
    }
    for loads in [drag("q", ""), damper("(0.1 N m s^3)"), drag("p", "-") + &drag("q", "")] {
        assert!(!matches!(lowest(&loads), SteadyStability::MinimumWithLoss), "{loads}: {:?}", lowest(&loads));
    }
}
