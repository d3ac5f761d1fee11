//! Speeds and accelerations in expressions that may not contain them are refused by name.

use crate::systems::{double_pendulum, entries, held, sleigh};
use dalembert_model::{Model, Source};

fn told(source: Source) -> String {
    let faults = Model::of(&source).err().unwrap_or_default();
    assert_eq!(faults.len(), 1, "{faults:?}");
    format!("{}; {}", faults[0].title, faults[0].accepted)
}

#[test]
fn positions_and_potentials_hold_no_speeds() {
    let points = entries(&[("P", "O + (1 s)*a'*l1*N.x"), ("Q", "P - l2*B.y")]);
    let point = told(Source { points, ..double_pendulum(true) });
    assert!(point.contains("the point `P` holds speeds; coordinates and the time"), "{point}");
    let frames = entries(&[("A", "N turned a about z"), ("B", "A turned b + (1 s)*rate(sin(a)) about z")]);
    let frame = told(Source { frames, ..double_pendulum(true) });
    assert!(frame.contains("the angle of `B` holds speeds"), "{frame}");
    let energies = |name: &str, value: &str| Source { energies: entries(&[(name, value)]), ..sleigh() };
    let potential = told(energies("potential", "(1 kg/s)*x*(velocity(G) . N.x)"));
    assert!(potential.contains("the potential energy holds speeds"), "{potential}");
}

#[test]
fn constraints_masses_and_energies_hold_no_accelerations() {
    let constraint = told(Source { constraints: vec![held("held", &["x'' - (1 m/s^2)"])], ..sleigh() });
    assert!(constraint.contains("a constraint holds accelerations; coordinates, speeds and the time"), "{constraint}");
    let seen = told(Source { constraints: vec![held("held", &["acceleration(G) . B.y"])], ..sleigh() });
    assert!(seen.contains("a constraint holds accelerations"), "{seen}");
    let mut heavy = sleigh();
    heavy.bodies[0].mass = Some("m*(1 + psi''*(1 s^2))".into());
    let heavy = told(heavy);
    assert!(heavy.contains("the inertia of `sleigh` holds accelerations"), "{heavy}");
    let energies = entries(&[("dissipation", "(1 kg)*x'*dot(rate(velocity(G)), N.x)")]);
    let dissipation = told(Source { energies, ..sleigh() });
    assert!(dissipation.contains("the dissipation holds accelerations"), "{dissipation}");
}

/// Acceleration-dependent forces would make the mass matrix unsymmetric.
#[test]
fn loads_hold_no_accelerations() {
    let load =
        |on: &str, is: &str| dalembert_model::LoadSource { on: Some(on.into()), is: is.into(), ..Default::default() };
    let force = told(Source { forces: vec![load("sleigh", "-(0.1 kg)*acceleration(G)")], ..sleigh() });
    assert!(force.contains("a force holds accelerations; coordinates, speeds and the time"), "{force}");
    let along =
        dalembert_model::LoadSource { along: Some("x".into()), is: "-(0.1 kg)*y''".into(), ..Default::default() };
    let along = told(Source { forces: vec![along], ..sleigh() });
    assert!(along.contains("a force holds accelerations"), "{along}");
    let torque = told(Source { torques: vec![load("sleigh", "-(0.1 kg m^2)*psi''*N.z")], ..sleigh() });
    assert!(torque.contains("a torque holds accelerations"), "{torque}");
}

/// The rate of a function of time alone is not a speed: positions may contain it.
#[test]
fn rates_of_the_time_may_stand_in_positions() {
    let points = entries(&[("P", "O + (1 m s)*rate(sin(t*(1 rad/s)))*N.x - l1*A.y"), ("Q", "P - l2*B.y")]);
    assert!(Model::of(&Source { points, ..double_pendulum(true) }).is_ok());
}
