//! Joint loads and constraint reactions, compared with results derived by hand.

use crate::systems::{double_pendulum, entries, held, rolling_disc, sleigh, slider_crank};
use dalembert_model::equations::Equations;
use dalembert_model::{Model, Source, Trace};
use symbolic::{Hypotheses, Sym, apart, substitute_all};

/// Asserts that every output is zero for every state, with the accelerations and multipliers of the equations substituted.
fn vanish(source: &Source) {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let outputs: Vec<Sym> = model.outputs.iter().map(|output| trace.scalar(output.is)).collect();
        let equations = Equations::of(&trace);
        let (accelerations, multipliers) = equations.solved().expect("it is regular");
        let symbols = trace.accelerations.iter().copied();
        let symbols = symbols.chain(equations.constraints.iter().map(|one| one.multiplier));
        let known: Vec<(Sym, Sym)> = symbols.zip(accelerations.into_iter().chain(multipliers)).collect();
        for (place, output) in substitute_all(&outputs, &known).into_iter().enumerate() {
            let decided = symbolic::decide(output, &Hypotheses::none());
            assert!(decided.is_zero(), "output {place}: {decided}");
        }
    });
}

fn with_outputs(source: Source, outputs: &[&str]) -> Source {
    let named: Vec<(String, &str)> = outputs.iter().enumerate().map(|(k, &is)| (format!("out{k}"), is)).collect();
    let pairs: Vec<(&str, &str)> = named.iter().map(|(name, is)| (name.as_str(), *is)).collect();
    Source { outputs: entries(&pairs), ..source }
}

/// A frictionless double pendulum: the force in the upper rod balances both masses, the force in the lower rod is along this rod and
/// balances the lower mass.
#[test]
fn rods_of_a_pendulum_carry_what_hangs_on_them() {
    let free = Source { torques: Vec::new(), ..double_pendulum(false) };
    vanish(&with_outputs(
        free,
        &[
            "joint_force(second) . B.x",
            "joint_force(second) . B.y - m2*(acceleration(Q) + g*N.y) . B.y",
            "joint_force(first) . N.x - m1*acceleration(P) . N.x - m2*acceleration(Q) . N.x",
            "joint_force(first) . N.y - m1*(acceleration(P) . N.y + g) - m2*(acceleration(Q) . N.y + g)",
            "dot(cross(P - O, joint_force(first) - joint_force(second)), N.z) - m1*dot(cross(P - O, acceleration(P) + g*N.y), N.z)",
        ],
    ));
}

/// A rolling disc: the plane gives the vertical part of m (a + g), friction the two horizontal ones; the joint transmits no torque.
#[test]
fn a_rolling_disc_is_carried_by_the_plane_and_held_by_friction() {
    vanish(&with_outputs(
        rolling_disc(),
        &[
            "joint_force(disc) . N.z - m*(acceleration(G) . N.z + g)",
            "joint_force(disc) . N.x",
            "joint_force(disc) . N.y",
            "reaction(rolling, 1) - m*acceleration(G) . N.x",
            "reaction(rolling, 2) - m*acceleration(G) . N.y",
            // the normal force acts at the contact point, the joint load is reduced to the centre
            "(joint_torque(disc) - cross(P - G, (joint_force(disc) . N.z)*N.z)) . C.x",
            "(joint_torque(disc) - cross(P - G, (joint_force(disc) . N.z)*N.z)) . C.y",
        ],
    ));
}

/// A slider-crank: the pin force along the guide accelerates the slider; the guide carries its transverse component.
#[test]
fn the_vector_of_a_loop_is_the_force_in_its_pin() {
    vanish(&with_outputs(
        slider_crank(),
        &[
            "reaction(pin) . N.x + m*s''",
            "joint_force(slider) . N.y - reaction(pin) . N.y - m*g",
            "joint_force(slider) . N.x",
            "dot(joint_torque(rod), N.z)",
            "dot(joint_torque(crank), N.z) - J*theta'' + T",
        ],
    ));
}

/// By the sign convention M u' + h = J^T lambda, the ice pushes the edge of a sleigh with lambda along B.y.
#[test]
fn a_multiplier_has_the_sign_of_its_constraint() {
    vanish(&with_outputs(
        sleigh(),
        &["reaction(edge) - m*acceleration(G) . B.y", "F - m*acceleration(G) . B.x", "norm(joint_force(sleigh))"],
    ));
}

/// A multiplier has the unit of power per constraint rate: N for a length and for a speed, N m for an angle.
#[test]
fn multipliers_have_the_unit_of_power_per_rate() {
    let mut source = sleigh();
    source.constraints.push(held("turn", &["psi - (1 rad/s)*t"]));
    source.constraints.push(held("line", &["x - (1 m/s)*t"]));
    let source = with_outputs(source, &["reaction(edge)", "reaction(turn)", "reaction(line)"]);
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    let units: Vec<String> = model.outputs.iter().map(|output| output.dimension.to_string()).collect();
    assert_eq!(units, ["kg m s^-2", "kg m^2 s^-2", "kg m s^-2"]);
}

#[test]
fn loads_that_are_not_known_are_refused_by_name() {
    let told = |source: Source| match Model::of(&source) {
        Ok(_) => panic!("it is accepted"),
        Err(faults) => {
            assert_eq!(faults.len(), 1, "{faults:?}");
            format!("{}; {}; {}", faults[0].title, faults[0].label, faults[0].accepted)
        }
    };
    let force = dalembert_model::LoadSource {
        on: Some("sleigh".into()),
        is: "dot(joint_force(sleigh), B.y)*B.y".into(),
        ..Default::default()
    };
    let early = told(Source { forces: vec![force], ..sleigh() });
    assert!(early.contains("`joint_force` stands in [outputs] only"), "{early}");
    let unknown = told(with_outputs(sleigh(), &["reaction(edgy)"]));
    assert!(unknown.contains("no constraint is called `edgy`") && unknown.contains("`edge`"), "{unknown}");
    let two = told(with_outputs(rolling_disc(), &["reaction(rolling)"]));
    assert!(two.contains("`rolling` holds 2 equations"), "{two}");
    let massless = told(with_outputs(slider_crank(), &["joint_force(crank) . N.x"]));
    assert!(massless.contains("the force on the joint of `crank` is not known"), "{massless}");
    let energies = entries(&[("potential", "m*(9.81 m/s^2)*y")]);
    let given = told(with_outputs(Source { energies, ..sleigh() }, &["joint_force(sleigh) . N.x"]));
    assert!(given.contains("[energies] does not say on which bodies it acts"), "{given}");
    // the constraint contains the absolute angles of both links, so its reaction acts on both joints
    let mut links = double_pendulum(false);
    links.constraints.push(held("gear", &["a - 2*b"]));
    let spread = told(with_outputs(links, &["joint_force(first) . N.x"]));
    assert!(spread.contains("moves more than one joint"), "{spread}");
}

/// T + V is constant without friction. Energies are compared with results by hand; the units of momenta are checked.
#[test]
fn energies_and_momenta_are_outputs() {
    let free = Source { torques: Vec::new(), ..double_pendulum(false) };
    vanish(&with_outputs(
        free,
        &[
            "rate(kinetic_energy + potential_energy)",
            "rate(kinetic_energy) - m1*velocity(P) . acceleration(P) - m2*velocity(Q) . acceleration(Q)",
            "kinetic_energy - m1/2*velocity(P) . velocity(P) - m2/2*velocity(Q) . velocity(Q)",
            "potential_energy - g*(m1*(P - O) + m2*(Q - O)) . N.y",
        ],
    ));
    let with_momentum = |text: &str| match Model::of(&with_outputs(sleigh(), &[text])) {
        Ok(model) => model.outputs[0].dimension.to_string(),
        Err(faults) => faults[0].title.clone(),
    };
    assert_eq!(with_momentum("momentum(x)"), "kg m s^-1");
    assert_eq!(with_momentum("momentum(psi)"), "kg m^2 s^-1");
    for none in ["momentum(x')", "momentum(m)", "momentum(G)"] {
        assert!(with_momentum(none).contains("a coordinate has a momentum"), "{none}");
    }
    let mut force = sleigh();
    force.forces.push(dalembert_model::LoadSource {
        along: Some("x".into()),
        is: "kinetic_energy/(1 m)".into(),
        ..dalembert_model::LoadSource::default()
    });
    let faults = Model::of(&force).expect_err("no force holds the energy of a run");
    assert!(faults[0].title.contains("`kinetic_energy` stands in [outputs] only"), "{faults:?}");
    // a parameter with the name of a built-in quantity takes precedence
    let mut own = with_outputs(sleigh(), &["kinetic_energy"]);
    own.parameters.push(("kinetic_energy", "3 kg").into());
    assert_eq!(Model::of(&own).expect("it is sound").outputs[0].dimension.to_string(), "kg");
}
