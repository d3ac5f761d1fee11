//! Relative equilibria in frames that turn at a given rate, by Jacobi's integral.

use super::all;
use dalembert_scenes::steady_motions::{EnclosedVerdict, SteadyMotion, SteadyMotions, SteadyStability};

/// The steady motions of a bead on a hoop that turns about the vertical.
fn hoop(radius: &str, gravity: &str, rate: &str) -> SteadyMotions {
    let text = format!(
        "title = \"Hoop\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\nR = \"{radius} m\"\ng = \"{gravity} m/s^2\"\n[coordinates]\ntheta = \"rad\"\n\
         [frames]\nH = \"N turned {rate}*t about z\"\n\
         [bodies]\nbead = {{ centre = \"O + R*(sin(theta)*H.x - cos(theta)*H.z)\", mass = \"m\" }}\n[run]\nspan = \"1 s\"\n"
    );
    all(&text, &[])
}

/// The angle of each motion, and whether it is a minimum of V - T0.
fn told(found: &SteadyMotions) -> Vec<(f64, bool)> {
    assert!(found.is_complete() && found.are_in_turning_frames, "{found:?}");
    let told = |motion: &SteadyMotion| match &motion.stability {
        SteadyStability::Minimum => (motion.state[0], true),
        SteadyStability::Falls(1) => (motion.state[0], false),
        other => panic!("{other:?}"),
    };
    found.motions.iter().map(told).collect()
}

/// A bead in a turning bowl, r^2 = R^2 - (g/W^2)^2: a circle of equilibria, also if the ranges extend beyond the bowl.
#[test]
fn a_circle_is_one_family_where_ranges_reach_beyond_the_domain_of_the_law() {
    let text = "title = \"Bowl\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[parameters]\nR = \"1 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [frames]\nA = \"N turned (3.5 rad/s)*t about z\"\n[bodies]\nb = { centre = \"O + x*A.x + y*A.y - sqrt(R^2 - x^2 - y^2)*N.z\", mass = \"1 kg\" }\n";
    let found = all(text, &[("x", -0.9, 0.9), ("y", -0.9, 0.9)]);
    let [(family, _)] = &found.families[..] else { panic!("{found:?}") };
    let radius = (1.0 - (9.81_f64 / 3.5 / 3.5).powi(2)).sqrt();
    assert!(found.motions.len() == 1 && family.along.len() == 1, "{found:?}");
    assert!(
        family.hull.iter().all(|[low, high]| (low + radius).abs() < 1e-2 && (high - radius).abs() < 1e-2),
        "{family:?}"
    );
}

#[test]
fn a_bead_leaves_the_bottom_of_a_hoop_that_turns_fast() {
    let away = (9.81 / (0.5 * 36.0_f64)).acos();
    let turn = std::f64::consts::PI;
    for (rate, wanted) in [
        ("(2 rad/s)", &[(0.0, true), (turn, false)][..]),
        ("(6 rad/s)", &[(-away, true), (0.0, false), (away, true), (turn, false)][..]),
    ] {
        let found = told(&hoop("0.5", "9.81", rate));
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found.0 - wanted.0).abs() < 1e-9 && found.1 == wanted.1, "{found:?} {wanted:?}");
        }
    }
}

/// At the critical rate w^2 = g/R the energy V - T0 begins with the fourth power of the angle, and the lowest position is still stable.
#[test]
fn at_the_critical_rate_the_fourth_power_of_the_angle_holds_the_bead() {
    for (radius, gravity, rate) in
        [("0.25", "9", "(6 rad/s)"), ("0.2725", "9.81", "(6 rad/s)"), ("0.5", "9.81", "sqrt(g/R)")]
    {
        let found = told(&hoop(radius, gravity, rate));
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].0 == 0.0 && found[0].1 && !found[1].1, "{radius} {gravity} {rate}: {found:?}");
    }
}

/// A mass on springs in a turning plane: a minimum for k > m w^2. For k < m w^2 the energy decreases in two directions, and gyroscopic forces stabilise
/// the mass; linear equations do not decide this, and with two different springs they show growth.
#[test]
fn gyroscopic_forces_in_a_turning_plane_leave_the_decision_to_linear_equations() {
    let plane = |first: f64, second: f64| {
        let text = format!(
            "title = \"Plane\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[frames]\nH = \"N turned (3 rad/s)*t about z\"\n\
             [bodies]\nb = {{ centre = \"O + x*H.x + y*H.y\", mass = \"m\" }}\n\
             [energies]\npotential = \"({first:?} N/m)*x^2/2 + ({second:?} N/m)*y^2/2\"\n[run]\nspan = \"1 s\"\n"
        );
        let found = all(&text, &[("x", -1.0, 1.1), ("y", -1.2, 1.0)]);
        let [motion] = &found.motions[..] else { panic!("{found:?}") };
        motion.stability.clone()
    };
    assert!(matches!(plane(10.0, 12.0), SteadyStability::Minimum));
    assert!(matches!(plane(5.0, 12.0), SteadyStability::FallsOdd(1)));
    let verdict = |stability: SteadyStability| match stability {
        SteadyStability::Linear(own) => own.enclosed.map(|found| found.verdict()),
        other => panic!("{other:?}"),
    };
    assert_eq!(verdict(plane(5.0, 6.0)), Ok(EnclosedVerdict::Undecided { on_axis: 4, touching: 0 }));
}

/// If the centrifugal force balances a spring, x is cyclic, but the momentum dT/dx' = x' - w y is not conserved, so that there is no amended potential.
/// Instead x' - 2 w y is conserved, and y'' + (3 w^2 + k) y = const is stable for k = -w^2.
#[test]
fn no_amended_potential_is_taken_where_a_momentum_is_not_kept() {
    let text = "title = \"Rotating saddle\"\n[parameters]\nm = \"1 kg\"\nk = \"1 N/m\"\nw = \"1 rad/s\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
                [frames]\nR = \"N turned w*t about z\"\n[bodies]\np = { centre = \"O + x*R.x + y*R.y\", mass = \"m\" }\n\
                [energies]\npotential = \"k/2*(x^2 - y^2)\"\n[run]\nspan = \"1 s\"\n";
    let found = all(text, &[("y", -1.0, 1.0)]);
    let [motion] = &found.motions[..] else { panic!("{found:?}") };
    let SteadyStability::Linear(own) = &motion.stability else { panic!("{:?}", motion.stability) };
    let enclosed = own.enclosed.as_ref().expect("eigenvalues are enclosed");
    assert_eq!(enclosed.verdict(), EnclosedVerdict::Undecided { on_axis: 2, touching: 0 });
}
