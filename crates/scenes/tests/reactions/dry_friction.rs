//! Friction proportional to a reaction, through sliding and sticking.

use super::{bead, close, last, runs};

/// The bead comes to rest where the slope of the wire is below the coefficient of friction.
#[test]
fn a_bead_on_a_rough_wire_comes_to_rest_on_a_slope_that_friction_holds() {
    let text = bead(
        "n = \"unit(N.y - 2*a*x*N.x)\"\nN0 = \"reaction(wire)*sqrt(1 + 4*a^2*x^2)\"",
        "-mu*abs(N0)*sign(x')*cross(n, N.z)",
        "",
    );
    let found = runs(&text.replace("span = \"2 s\"", "span = \"6 s\""));
    close(last(&found, "x'"), 0.0, 1e-10);
    let slope = 4.0 * last(&found, "x");
    assert!(slope.abs() > 0.1 && slope.abs() < 0.2, "{slope}");
    // at rest the wire carries the normal component of the weight and friction the rest
    close(last(&found, "wire.impulse'"), 0.3 * 9.81 / (1.0 + slope * slope), 1e-9);
}

/// J1 a'' = M - F, J2 b'' = n F - L sgn b' - mu n |F| sgn b', a = n b: F > 0 while the motor drives, F < 0 while the system runs down.
#[test]
fn a_gear_whose_loss_grows_with_its_torque_has_its_closed_form() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/foreign/lossy_gear.toml");
    let text = std::fs::read_to_string(path).expect("it is there");
    let (j1, j2, n, mu, m, l, w0) = (0.01, 0.5, 5.0, 0.1, 2.0, 4.0, 0.1);
    let driven = (n * (1.0 - mu) * m - l) / (j2 + n * n * (1.0 - mu) * j1);
    let top = w0 + driven;
    let force = -j1 * n * (-l / (j2 + n * n * (1.0 + mu) * j1));
    // while running down, the motor's inertia drives the load through the gear and its losses
    let signed = if force < 0.0 { 1.0 + mu } else { 1.0 - mu };
    let slowed = -l / (j2 + n * n * signed * j1);
    let turned = w0 + driven / 2.0 + top * top / (2.0 * -slowed);
    let found = runs(&text);
    close(last(&found, "b"), turned, 1e-9);
    close(last(&found, "b'"), 0.0, 1e-12);
    close(last(&found, "gear.impulse'"), 0.0, 1e-12);
}
