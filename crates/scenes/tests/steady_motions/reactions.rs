//! Reactions of either sign, more equations than unknowns, and events.

use super::{all, assert_are, values};
use dalembert_scenes::steady_motions::Near;
use std::f64::consts::FRAC_PI_2;

/// A chain of rods: each rod hangs or stands, and there are no other equilibria, although each reaction may have either sign.
#[test]
fn rods_in_cartesian_coordinates_rest_upright_alone() {
    const RODS: &str = include_str!("../../../../scenes/foreign/triple_pendulum.toml");
    let ranges = ["x1", "y1", "x2", "y2", "x3", "y3"].map(|name| (name, -1.6, 1.6));
    let found = all(RODS, &ranges);
    assert!(found.examined < 100, "{}", found.examined);
    let mut wanted: Vec<Vec<f64>> = Vec::new();
    for signs in 0..8 {
        let mut at = 0.0;
        let heights = (0..3).map(|rod| {
            at += if signs >> rod & 1 == 0 { -0.5 } else { 0.5 };
            [0.0, at]
        });
        wanted.push(heights.flatten().collect());
    }
    let own: Vec<Vec<f64>> = values(&found).into_iter().map(|(values, _)| values).collect();
    assert_eq!(own.len(), 8);
    for wanted in &wanted {
        let is_near = |own: &&Vec<f64>| own.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9);
        assert_eq!(own.iter().filter(is_near).count(), 1, "{wanted:?}");
    }
}

/// A body on a line with a force that depends on the angle of a pendulum: two equations for one angle.
fn pushed(push: &str) -> String {
    format!(
        "title = \"A pushed carriage\"\n[parameters]\nm = \"1 kg\"\nk = \"2 N m\"\n[coordinates]\nx = \"m\"\ntheta = \"rad\"\n[points]\nP = \"O + x*N.x\"\n\
         [energies]\nkinetic = \"m/2*x'^2 + m/2*(1 m^2)*theta'^2\"\npotential = \"k*(1 - cos(theta))\"\n[[force]]\non = \"P\"\n\
         is = \"(1 N)*({push})*N.x\"\n[run]\nspan = \"1 s\"\n"
    )
}

#[test]
fn more_equations_than_unknowns_are_fulfilled_together_or_not() {
    let none = all(&pushed("cos(theta) - 1/2"), &[]);
    assert!(none.motions.is_empty() && none.is_complete(), "{none:?}");
    // the zero of one equation satisfies the other one numerically, which is not a proof
    let open = all(&pushed("cos(theta) - 1"), &[]);
    assert!(open.motions.is_empty() && !open.undecided.is_empty(), "{open:?}");
    assert!(open.undecided.iter().all(|at| at[0][0].abs() < 1e-6 && at[0][1].abs() < 1e-6), "{open:?}");
}

#[test]
fn events_leave_the_equations_between_them_as_they_are() {
    let bead = "title = \"A bead on a spring\"\n[parameters]\nm = \"1 kg\"\nk = \"4 N/m\"\na = \"0.5 m\"\n[coordinates]\nx = \"m\"\n\
        [energies]\nkinetic = \"m/2*x'^2\"\npotential = \"k/2*(x - a)^2\"\n[[event]]\nwhen = \"x\"\ndirection = \"down\"\nset = { \"x'\" = \"-x'\" }\n\
        [run]\nspan = \"1 s\"\n";
    assert_are(&all(bead, &[("x", -2.0, 2.0)]), &[(&[0.5], Some(true))]);
}

/// A crank and a rod of equal length: where the crank is upright, the slider is below its axis, and the gradient of the constraint is zero along the
/// crank. No equation bounds the reaction there.
#[test]
fn a_dead_centre_is_told_as_a_place_where_constraints_become_dependent() {
    let text = "title = \"Dead centre\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nr = \"0.3 m\"\n[coordinates]\na = \"rad\"\nx = \"m\"\n\
        [points]\nP = \"O + r*(cos(a)*N.x + sin(a)*N.y)\"\nS = \"O + x*N.x\"\n\
        [bodies]\ncrank = { centre = \"P\", mass = \"1 kg\" }\nslider = { centre = \"S\", mass = \"0.5 kg\" }\n\
        [[constraint]]\nname = \"rod\"\nzero = \"distance(P, S)^2 - r^2\"\n[run]\nspan = \"1 s\"\n";
    let found = all(text, &[("x", -1.0, 1.1)]);
    assert!(!found.is_complete() && found.motions.is_empty(), "{found:?}");
    assert!(found.regions.iter().all(|region| region.near == Near::Dependent), "{:?}", found.regions);
    for side in [-1.0, 1.0] {
        let holds = |at: &[f64; 2], value: f64| at[0] <= value && value <= at[1];
        let is_there = found.regions.iter().any(|region| holds(&region.hull[0], side * FRAC_PI_2));
        assert!(is_there, "{:?}", found.regions);
    }
}
