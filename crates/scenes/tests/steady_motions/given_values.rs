//! Values that the user fixes for coordinates and speeds.

use super::{all, asked, model};
use dalembert_scenes::steady_motions::{SteadyMotions, SteadyStability};

const SPRING: &str = "title = \"Spring\"\n[parameters]\nk = \"1 N/m\"\nf = \"3 N\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies]\n\
                      p = { centre = \"O + x*N.x + y*N.y\", mass = \"1 kg\" }\n[[force]]\nalong = \"x\"\nis = \"f - k*x\"\n\
                      [[force]]\nalong = \"y\"\nis = \"-k*y\"\n";

#[test]
fn a_motion_is_judged_alike_whether_its_place_is_given_or_sought() {
    let sought = [("x", -5.0, 5.0), ("y", -1.0, 1.0)];
    for ranges in [[("x", 3.0, 3.0), sought[1]], [("x", 3.0, 3.0), ("y", 0.0, 0.0)], sought] {
        let found = all(SPRING, &ranges);
        assert_eq!(found.motions.len(), 1, "{found:?}");
        assert!(matches!(found.motions[0].stability, SteadyStability::Minimum), "{ranges:?}: {found:?}");
    }
}

/// m v' = F - k |v| v along a knife edge: v = sqrt(F/k); the range is given by the name of the quasi-velocity, and the law has a condition.
#[test]
fn speeds_of_the_file_may_have_ranges_where_the_law_has_conditions() {
    let text = "title = \"Sled\"\n[coordinates]\nx = \"m\"\ny = \"m\"\npsi = \"rad\"\n[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n[frames]\n\
                B = \"N turned psi about z\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.s]\nframe = \"B\"\ncentre = \"P + (0.3 m)*B.x\"\n\
                mass = \"1 kg\"\ninertia = \"0.2 kg m^2\"\n[[constraint]]\nzero = \"velocity(s at P) . B.y\"\n[[force]]\non = \"s at P\"\n\
                is = \"(2 N)*B.x - (0.5 kg/m)*abs(v)*v*B.x\"\n[[torque]]\non = \"s\"\nis = \"-(0.1 N m s)*w*N.z\"\n";
    let ranges = [("v", -5.0, 5.0), ("w", -3.0, 3.0)];
    let found = SteadyMotions::of_cases(&model(text), &asked(&ranges, 20_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let all: Vec<_> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    assert!(found.iter().all(|(_, own)| own.is_complete()), "{found:?}");
    // w = 0, or v = -d/(m b), for which F - k |v| v + m b w^2 = 0 has no solution
    let [motion] = all[..] else { panic!("{all:?}") };
    let (name, speed) = &motion.quasi_velocities[0];
    assert!(name == "v" && (speed - 2.0).abs() < 1e-9 && motion.state.len() == 6, "{motion:?}");
    assert!(matches!(motion.stability, SteadyStability::Linear(_)), "{motion:?}");
}
