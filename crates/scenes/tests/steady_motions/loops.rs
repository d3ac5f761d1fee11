//! Closed loops of links with relative angles.

use super::{all, values};
use std::f64::consts::PI;

const ANDREWS: &str = include_str!("../../../../scenes/foreign/andrews_mechanism.toml");

/// An angle reduced to the interval from -pi to pi.
fn turned(angle: f64) -> f64 {
    angle - (angle / (2.0 * PI)).round() * 2.0 * PI
}

/// Andrews' mechanism has eight equilibria under its torque, which differ by the side of the crank and the shapes of the loops. A model with absolute
/// angles has these eight, too.
#[test]
fn a_mechanism_of_three_loops_has_all_its_equilibria_however_its_angles_are_counted() {
    let from_ground = ["K1 turned Theta", "K5 turned Phi", "K7 turned Omega"]
        .iter()
        .fold(ANDREWS.to_owned(), |text, turn| text.replace(turn, &format!("N{}", &turn[2..])));
    let (found, absolute) = (values(&all(ANDREWS, &[])), values(&all(&from_ground, &[])));
    assert_eq!((found.len(), absolute.len()), (8, 8));
    for (own, verdict) in &found {
        // beta, Theta, gamma, Phi, delta, Omega, epsilon
        let mut directions = own.clone();
        [(1, 0), (3, 4), (5, 6)].into_iter().for_each(|(link, before)| directions[link] += own[before]);
        let is_same = |other: &Vec<f64>| other.iter().zip(&directions).all(|(a, b)| turned(a - b).abs() < 1e-9);
        assert_eq!(absolute.iter().filter(|(other, known)| is_same(other) && known == verdict).count(), 1, "{own:?}");
    }
}

/// Two massless rods from the origin to a slider on the x axis; a spring pulls the slider to the distance of one rod.
const RODS: &str = r#"
title = "A slider on two rods"
parameters = { m = "2 kg", k = "50 N/m", l = "0.5 m" }
coordinates = { a = "rad", b = "rad" }
frames = { A = "N turned a about z", B = "A turned b about z" }
points = { knee = "O + l*A.x", tip = "knee + l*B.x" }
bodies = { slider = { centre = "tip", mass = "m" } }
energies = { potential = "k*(distance(O, tip) - l)^2/2" }
[[constraint]]
zero = "(tip - O) . N.y"
"#;

/// The slider is at rest with the rods at 60 degrees to each other; the rods have no kinetic energy.
#[test]
fn an_equilibrium_of_links_without_mass_is_a_minimum_of_the_energy() {
    let found = all(RODS, &[("a", 0.3, 1.5), ("b", -3.0, -0.3)]);
    super::assert_are(&found, &[(&[PI / 3.0, -2.0 * PI / 3.0], Some(true))]);
}
