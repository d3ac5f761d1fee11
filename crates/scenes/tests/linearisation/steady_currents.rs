//! Equilibria with steady currents, in which cyclic charges grow.

use super::scene;
use dalembert_scenes::linearisation::{Stability, Standing, VariedEquations, eigenvalues};
use dalembert_scenes::{ModelScene, equilibrium_of};

/// A pendulum held by a DC motor at constant voltage.
const HELD: &str = "title = \"held\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.5 kg\"\nl = \"0.2 m\"\ng = \"9.81 m/s^2\"\nk = \"0.05 V s\"\n\
    R = \"2 ohm\"\nL = \"3 mH\"\nU = \"12 V\"\n[coordinates]\ntheta = \"rad\"\n[frames]\nA = \"N turned theta about z\"\n[points]\nP = \"O - l*A.y\"\n\
    [bodies.bob]\nframe = \"A\"\ncentre = \"P\"\nmass = \"m\"\ninertia = \"(1e-4 kg m^2)\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\n\
    torque = \"-(1e-3 N m s)*motor.speed\"\n[[drive.winding]]\ninductance = \"L\"\nresistance = \"R\"\nsupply = \"U\"\nmotional = \"k\"\n\
    [start]\nequilibrium = true\n[run]\nspan = \"1 s\"\n";

/// k U/R = m g l sin(theta).
#[test]
fn a_motor_holds_a_load_with_a_steady_current() {
    let angle = (0.05 * 6.0 / (0.5 * 9.81 * 0.2_f64)).asin();
    let started = |line: &str| HELD.replace("equilibrium = true\n", &format!("equilibrium = true\n{line}\n"));
    for text in [HELD.to_owned(), started("\"motor.i\" = \"guess 1 A\""), started("\"motor.q'\" = \"-3 A\"")] {
        let scene = scene(&text);
        let [theta, charge, turning, current] = scene.start[..] else { panic!("{:?}", scene.start) };
        assert!((theta - angle).abs() < 1e-12 && (current - 6.0).abs() < 1e-12, "{:?}", scene.start);
        assert_eq!([charge, turning], [0.0, 0.0]);
    }
    let scene = scene(HELD);
    let equations = VariedEquations::of(&scene.model, &[]).unwrap_or_else(|why| panic!("{why}"));
    let linear = equations.linearised(equations.point(0.0, &scene.start)).unwrap_or_else(|why| panic!("{why}"));
    assert_eq!(equations.standing(&linear), Ok(Standing::SteadyCurrents));
    // the only neutral direction is the charge
    assert_eq!(Stability::of(&eigenvalues(&linear.a), true), Stability::Asymptotic { idle: 1 });
    let moving = started("\"theta'\" = \"1 rad/s\"");
    let refused = ModelScene::parse("scene.toml", &moving).expect_err("it moves").to_string();
    assert!(refused.contains("an equilibrium has no speeds") && refused.contains("theta' is not zero"), "{refused}");
}

/// No force holds the rotor: a steady rotation is not an equilibrium, and no other guess leads to one.
#[test]
fn a_motor_without_a_load_that_holds_it_has_no_equilibrium() {
    let refused =
        ModelScene::parse("scene.toml", &HELD.replace("gravity = \"-g*N.y\"\n", "")).expect_err("it turns").to_string();
    assert!(
        refused.contains("no equilibrium is found") && refused.contains("a force that holds it at rest"),
        "{refused}"
    );
}

/// The current U/(R1 + R2) flows through both meshes of a circuit with a capacitor between them; both charges grow at an equal rate.
#[test]
fn a_current_flows_past_a_capacitor() {
    let found = scene(
        "title = \"meshes\"\n[parameters]\nR1 = \"2 ohm\"\nR2 = \"3 ohm\"\nL = \"1 H\"\nC = \"1 mF\"\nU = \"10 V\"\n[coordinates]\np = \"C\"\nq = \"C\"\n\
         [energies]\ncoenergy = \"L/2*(p'^2 + q'^2)\"\npotential = \"(p - q)^2/(2*C)\"\ndissipation = \"R1*p'^2/2 + R2*q'^2/2\"\n\
         [[force]]\nalong = \"p\"\nis = \"U\"\n[start]\nequilibrium = true\n[run]\nspan = \"1 s\"\n",
    );
    let [p, q, first, second] = found.start[..] else { panic!("{:?}", found.start) };
    assert!((first - 2.0).abs() < 1e-12 && (second - 2.0).abs() < 1e-12, "{:?}", found.start);
    assert!((p - q - 1e-3 * 3.0 * 2.0).abs() < 1e-14, "{:?}", found.start);
}

/// Kirchhoff's current law at a node, for charges or for currents; the third branch has no inductance.
#[test]
fn currents_of_a_node_are_steady_whether_its_law_holds_charges_or_currents() {
    for law in ["a' - b' - c'", "a - b - c"] {
        let found = scene(&format!(
            "title = \"node\"\n[coordinates]\na = \"C\"\nb = \"C\"\nc = \"C\"\n[energies]\ncoenergy = \"(1 H)/2*(a'^2 + b'^2)\"\n\
             dissipation = \"(2 ohm)/2*(a'^2 + b'^2 + 2*c'^2)\"\n[[force]]\nalong = \"a\"\nis = \"(10 V)\"\n[[constraint]]\nzero = \"{law}\"\n\
             [start]\nequilibrium = true\n[run]\nspan = \"1 s\"\n"
        ));
        let known = [0.0, 0.0, 0.0, 3.0, 2.0, 1.0];
        assert!(
            found.start.iter().zip(known).all(|(part, known)| (part - known).abs() < 1e-12),
            "{law}: {:?}",
            found.start
        );
        let again = equilibrium_of(&found.model).unwrap_or_else(|why| panic!("{}", why.title));
        assert!(again.choice().is_none() && again.family == 0, "{again:?}");
    }
}

/// A permanent-magnet machine at direct voltage turns until the torque of its direct and quadrature currents balances the load.
#[test]
fn a_synchronous_machine_at_standstill_has_steady_currents() {
    let text = std::fs::read_to_string(super::stored("models/interior_magnet")).expect("it is there");
    let mut text =
        text.replace("U*cos(w*t)", "U/50").replace("U*sin(w*t)", "0*U").replace("if(t < (0.5 s), 0, T)", "T/10");
    for (from, to) in [
        ("lag = \"w*t - 2*theta\"\n", ""),
        ("w = \"50 rev/s\"\n", ""),
        ("theta = \"-45 deg\"\n\"theta'\" = \"1500 rpm\"", "equilibrium = true\nid = \"2 A\""),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let start = scene(&text).start;
    let (current, theta) = (170.0 / 50.0 / 1.2, start[0]);
    let (id, iq) = (current * (2.0 * theta).cos(), -current * (2.0 * theta).sin());
    let torque = 2.0 * (0.5 * iq + (0.02 - 0.045) * id * iq);
    assert!((start[4] - current).abs() < 1e-11 && start[5].abs() < 1e-11, "{start:?}");
    assert!((torque - 0.4).abs() < 1e-11 && id > 0.0, "{torque} {start:?}");
}
