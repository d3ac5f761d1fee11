//! Stability of rest under dry friction.

use super::{asked, model};
use dalembert_scenes::steady_motions::{Case, Family, Friction, SteadyMotion, SteadyMotions, SteadyStability};

type Found = Vec<(Vec<Case>, SteadyMotions)>;

/// A point with two coordinates on springs, with further loads.
fn point(loads: &str) -> String {
    format!(
        "title = \"Point\"\n[parameters]\nF = \"1 N\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [bodies]\nb = {{ centre = \"O + x*N.x + y*N.y\", mass = \"1 kg\" }}\n[energies]\npotential = \"(4 N/m)*x^2/2 + (2 N/m)*y^2/2\"\n\
         {loads}\n[run]\nspan = \"1 s\"\n"
    )
}

fn found(text: &str, ranges: &[(&str, f64, f64)]) -> Found {
    let all = SteadyMotions::of_cases(&model(text), &asked(ranges, 20_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(all.iter().all(|(_, own)| own.is_complete()), "{all:?}");
    all
}

fn families(all: &Found) -> Vec<&Family> {
    all.iter().flat_map(|(_, own)| &own.families).map(|(family, _)| family).collect()
}

fn along(speed: &str, force: &str) -> String {
    format!("[[force]]\nalong = \"{speed}\"\nis = \"{force}\"\n")
}

const PLANE: [(&str, f64, f64); 2] = [("x", -1.0, 1.1), ("y", -1.0, 1.2)];

#[test]
fn friction_along_every_coordinate_makes_a_rest_stable_even_on_a_saddle() {
    let both = along("x", "-F*sign(x')") + &along("y", "-F*sign(y')");
    for load in [String::new(), along("y", "(5 N/m)*y")] {
        let all = found(&point(&(both.clone() + &load)), &PLANE);
        let [rest] = families(&all)[..] else { panic!("{all:?}") };
        assert_eq!((rest.dimension, rest.friction), (2, Some(Friction::Resists)), "{rest:?}");
    }
}

#[test]
fn friction_along_one_of_two_coordinates_decides_nothing() {
    let all = found(&point(&along("x", "-F*sign(x')")), &PLANE);
    let [rest] = families(&all)[..] else { panic!("{all:?}") };
    assert_eq!((rest.dimension, rest.friction), (1, Some(Friction::Partial)), "{rest:?}");
}

#[test]
fn friction_of_a_negative_coefficient_feeds_motions() {
    let all = found(&point(&(along("x", "F*sign(x')") + &along("y", "F*sign(y')"))), &PLANE);
    let [rest] = families(&all)[..] else { panic!("{all:?}") };
    assert_eq!(rest.friction, Some(Friction::Feeds), "{rest:?}");
}

#[test]
fn friction_between_two_bodies_counts_along_their_relative_motion() {
    let pair = along("x", "-F*sign(x')") + &along("y", "-F*sign(y' - x')") + &along("x", "F*sign(y' - x')");
    let all = found(&point(&pair), &PLANE);
    let [rest] = families(&all)[..] else { panic!("{all:?}") };
    assert_eq!(rest.friction, Some(Friction::Resists), "{rest:?}");
}

/// The only motion at a given coordinate x; the fraction of friction is a single number then.
fn only(text: &str, x: f64) -> SteadyMotion {
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", x, x), ("y", -1.0, 1.2)], 2_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    let motions: Vec<&SteadyMotion> = all.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = motions[..] else { panic!("{all:?}") };
    motion.clone()
}

#[test]
fn a_rest_with_a_used_up_share_is_not_decided() {
    let text = point("[[constraint]]\nzero = \"y\"\n[[force]]\nalong = \"x\"\nis = \"-F*sign(x')\"");
    assert!(matches!(only(&text, 0.1).stability, SteadyStability::HeldByFriction));
    assert!(matches!(only(&text, 0.25).stability, SteadyStability::AtCondition(None)));
}

/// Dry friction with zero force has no effect: stability follows from the minimum of the energy.
#[test]
fn friction_without_force_leaves_the_energy_to_decide() {
    let all = found(&point(&along("x", "-(0 N)*sign(x')")), &PLANE);
    let motions: Vec<&SteadyMotion> = all.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = motions[..] else { panic!("{all:?}") };
    assert!(matches!(motion.stability, SteadyStability::Minimum), "{motion:?}");
}

/// Runs refuse a negative coefficient, too: friction of a contact cannot supply energy.
#[test]
fn a_negative_coefficient_of_a_contact_is_refused() {
    let block = |coefficient: &str| {
        format!(
            "title = \"Block on an incline\"\ngravity = \"-(10 m/s^2)*N.y\"\n[parameters]\nmu = \"{coefficient}\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [frames]\nI = \"N turned (0.3 rad) about z\"\n[bodies.b]\ncentre = \"O + x*I.x + y*I.y\"\nmass = \"1 kg\"\n\
             [[contact]]\nname = \"plane\"\nof = \"b\"\nthrough = \"O\"\nnormal = \"I.y\"\nfriction = \"mu\"\n\
             [energies]\npotential = \"(10 N/m)*x^2\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let ranges = asked(&[("x", -1.0, 1.0), ("y", -1.0, 1.0)], 1_000);
    let refused =
        |text: &str| SteadyMotions::of_cases(&model(text), &ranges, || true).err().map(|why| format!("{why:?}"));
    assert!(refused(&block("-0.5")).is_some_and(|why| why.contains("a coefficient of friction is negative")));
    assert_eq!(refused(&block("0.5")), None);
}

/// A contact that bounces without loss may gain energy from the normal force of the negative damper in each flight.
#[test]
fn friction_beside_a_contact_that_bounces_decides_nothing() {
    let text = |restitution: &str| {
        format!(
            "title = \"A particle on a floor\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\ng = \"10 m/s^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [bodies]\np = {{ centre = \"O + x*N.x + y*N.y\", mass = \"m\" }}\n[[contact]]\nof = \"p\"\nthrough = \"O\"\nnormal = \"N.y\"\nrestitution = \"{restitution}\"\n\
             [[force]]\non = \"p\"\nis = \"-(1 N/m)*x*N.x - (1 N)*sign(x')*N.x + (20 N s/m)*y'*N.y\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    for (restitution, resists) in [("0", true), ("1", false)] {
        let ranges = asked(&[("x", -3.0, 3.0), ("y", -3.0, 3.0)], 1_000);
        let found = SteadyMotions::of_cases(&model(&text(restitution)), &ranges, || true);
        let found = found.unwrap_or_else(|why| panic!("{why:?}"));
        let told = format!("{found:?}");
        assert_eq!(told.contains("Resists"), resists, "{restitution}: {told}");
    }
}

/// The coordinate in the sine is a length, not an angle: every minimum and maximum of the wave in the range is found.
#[test]
fn a_length_in_a_sine_keeps_its_range() {
    let text = "title = \"A bead on a wave\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\ng = \"10 m/s^2\"\nA = \"0.1 m\"\nL = \"0.5 m\"\n\
        [coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x + A*sin(x/L)*N.y\", mass = \"m\" }\n[run]\nspan = \"1 s\"\n";
    let found = super::all(text, &[("x", 0.0, 7.0)]);
    assert_eq!(found.motions.len(), 4, "{found:?}");
    assert!(found.motions.iter().all(|own| (0.0..7.0).contains(&own.state[0])), "{found:?}");
}
