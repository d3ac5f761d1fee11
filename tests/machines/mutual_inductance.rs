//! Windings with mutual inductances, written as a text motor in decoupled currents.

use dalembert_derivations::studies::scene::Scene;
use field::Analytic;
use motor::torque_and_current_rates;
use nalgebra::{Matrix2, Vector2};
use reader::Family;

/// An induction machine in the stator's axes: inductances, resistances, voltage amplitude, pole pairs.
const STATOR: f64 = 9.5e-3;
const ROTOR: f64 = 9.6e-3;
const MUTUAL: f64 = 9.2e-3;
const RESISTANCES: [f64; 2] = [0.03, 0.04];
const VOLTAGE: f64 = 173.2;
const POLES: f64 = 2.0;

fn inductances() -> Matrix2<f64> {
    Matrix2::new(STATOR, MUTUAL, MUTUAL, ROTOR)
}

/// The matrix T with T^T L T = 1 and T^T R T diagonal: the generalised eigenvectors of R and L.
fn decoupling() -> (Matrix2<f64>, Vector2<f64>) {
    let root = inductances().cholesky().expect("inductances are positive").l();
    let inverse = root.try_inverse().expect("it is regular");
    let eigen = (inverse * Matrix2::from_diagonal(&RESISTANCES.into()) * inverse.transpose()).symmetric_eigen();
    (inverse.transpose() * eigen.eigenvectors, eigen.eigenvalues)
}

/// The machine as text, in the currents j with i = T j, two along d and two along q.
fn text(allowed: &str) -> String {
    let (t, resistances) = decoupling();
    let swept = inductances() * t;
    let mut parameters = "l = \"1 H\"\nload = \"10 N m\"\n".to_owned();
    let mut windings = String::new();
    for (axis, other, sign) in [("d", "q", -POLES), ("q", "d", POLES)] {
        let voltage = if axis == "d" { "cos(2*g)" } else { "sin(2*g)" };
        for k in 0..2 {
            let name = format!("{axis}{k}");
            let supply = t[(0, k)] * if axis == "d" { VOLTAGE } else { -VOLTAGE };
            parameters += &format!("r_{name} = \"{:?} ohm\"\nv_{name} = \"{supply:?} V\"\n", resistances[k]);
            for l in 0..2 {
                parameters += &format!("c_{name}{l} = \"{:?} V s/A\"\n", sign * t[(0, k)] * swept[(0, l)]);
            }
            windings += &format!(
                "[[machine.winding]]\ncurrent = \"{name}\"\ninductance = \"l\"\nresistance = \"r_{name}\"\n\
                 supply = \"v_{name}*{voltage}\"\nmotional = \"c_{name}0*{other}0 + c_{name}1*{other}1\"\n"
            );
        }
    }
    format!(
        "title = \"an induction machine\"\nsystem = \"bench\"\n{allowed}[rotor]\naxial = \"0.1 kg m^2\"\n[machine]\nmodel = \"text\"\n\
         field_speed = \"157 rad/s\"\ntorque_law = \"-load\"\n[machine.parameters]\n{parameters}{windings}\
         [start]\nrotor_speed = \"0 rad/s\"\n[run]\nspan = \"1 s\"\n"
    )
}

#[test]
fn an_induction_machine_in_decoupled_currents_has_the_moment_and_the_rates_of_the_coupled_one() {
    let scene =
        Scene::parse("scene.toml", &text("allow = [\"separate fluxes\"]\n")).unwrap_or_else(|error| panic!("{error}"));
    let (t, _) = decoupling();
    let (angle, slip) = (0.7_f64, -20.0);
    let (j_d, j_q) = (Vector2::new(0.3, -0.2), Vector2::new(-0.5, 0.9));
    let currents = [j_d[0], j_d[1], j_q[0], j_q[1]];
    let mut rates = [0.0; 4];
    let moment = torque_and_current_rates(&scene.machine, angle.circle(), slip, &currents, &mut rates);

    let (i_d, i_q, speed) = (t * j_d, t * j_q, slip + 157.0);
    let (flux_d, flux_q) = (inductances() * i_d, inductances() * i_q);
    let resisted = |i: Vector2<f64>| i.component_mul(&Vector2::from(RESISTANCES));
    let [v_d, v_q] = [(2.0 * angle).cos(), -(2.0 * angle).sin()].map(|wave| Vector2::new(VOLTAGE * wave, 0.0));
    let inverse = inductances().try_inverse().expect("inductances are regular");
    let rate_d: Vector2<f64> = inverse * (v_d - resisted(i_d) + Vector2::new(POLES * flux_q[0] * speed, 0.0));
    let rate_q: Vector2<f64> = inverse * (v_q - resisted(i_q) - Vector2::new(POLES * flux_d[0] * speed, 0.0));
    let printed = POLES * MUTUAL * (i_d[1] * i_q[0] - i_q[1] * i_d[0]) - 10.0;

    let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * (1.0 + b.abs());
    assert!(close(moment, printed), "{moment} beside {printed}");
    let (own_d, own_q) = (t * Vector2::new(rates[0], rates[1]), t * Vector2::new(rates[2], rates[3]));
    for (own, coupled) in own_d.iter().chain(&own_q).zip(rate_d.iter().chain(&rate_q)) {
        assert!(close(*own, *coupled), "{own} beside {coupled}");
    }
}

#[test]
fn currents_in_one_motional_law_are_said_not_to_induce_in_each_other() {
    let error = Scene::parse("scene.toml", &text("")).expect_err("it is not said").to_string();
    assert!(error.contains("M d(q1)/dt") && error.contains("allow = [\"separate fluxes\"]"), "{error}");
}
