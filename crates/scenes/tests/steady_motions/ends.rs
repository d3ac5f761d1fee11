//! Bounds of families: values that their motions reach, and values beyond which there is no motion.

use super::{asked, model};
use dalembert_scenes::steady_motions::{Family, SteadyMotions};

fn families(text: &str, ranges: &[(&str, f64, f64)]) -> Vec<Family> {
    let found = SteadyMotions::of_cases(&model(text), &asked(ranges, 20_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete()), "{found:?}");
    found.into_iter().flat_map(|(_, own)| own.families).map(|(family, _)| family).collect()
}

/// Requires that the outer bounds and the proved values of a family agree with the given ends.
fn assert_ends(family: &Family, place: usize, [low, high]: [f64; 2]) {
    let (hull, reached) = (family.hull[place], family.reached[place].expect("its ends are reached"));
    let near = |one: f64, other: f64| (one - other).abs() < 1e-7;
    assert!(near(hull[0], low) && near(hull[1], high), "{hull:?} {low} {high}");
    assert!(near(reached[0], low) && near(reached[1], high), "{reached:?} {low} {high}");
    assert!(hull[0] <= reached[0] && reached[1] <= hull[1], "{hull:?} {reached:?}");
}

/// A pendulum with dry friction in its joint is at rest where |sin a| <= F/(m g l), whichever unknown is the parameter of a piece.
#[test]
fn dry_friction_in_a_joint_holds_up_to_the_arcsine_of_its_part_and_no_further() {
    for part in [0.05_f64, 0.2, 0.5, 0.9, 0.999] {
        let text = format!(
            "title = \"Rough joint\"\ngravity = \"-(10 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nF = \"{part:?} N m\"\n[coordinates]\na = \"rad\"\n\
             [bodies]\nb = {{ centre = \"O + (0.1 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"m\" }}\n\
             [[force]]\nalong = \"a\"\nis = \"-F*sign(a')\"\n[run]\nspan = \"1 s\"\n"
        );
        let half = part.asin();
        let all = families(&text, &[]);
        assert_eq!(all.len(), 2, "{part}: {all:?}");
        for family in &all {
            let turn = std::f64::consts::PI;
            let middle = if family.hull[0][0] < -1.6 || family.hull[0][1] > 1.6 { turn } else { 0.0 };
            let turned = if family.hull[0][1] < 0.0 { -middle } else { middle };
            assert_ends(family, 0, [turned - half, turned + half]);
        }
    }
}

/// Friction F = c (1 + x^2) against a spring k x: the ends of the positions of rest are roots of a quadratic equation.
#[test]
fn ends_are_roots_of_the_equation_at_the_largest_friction() {
    let text = "title = \"Growing\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"-(5 N/m)*x - (2 N)*(1 + x^2/(1 m^2))*sign(x')\"\n[run]\nspan = \"1 s\"\n";
    // 2 x^2 - 5 x + 2 = 0 at 1/2 and 2
    let all = families(text, &[("x", -1.9, 1.9)]);
    let [family] = &all[..] else { panic!("{all:?}") };
    assert_ends(family, 0, [-0.5, 0.5]);
}
