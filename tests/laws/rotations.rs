//! Euler's angles have their usual meaning; Lagrange's equations, which hold in any coordinates, cannot verify this.

use field::Analytic;
use mechanics::rotation::{euler, euler_forms, vertical};
use nalgebra::Vector3;
use symbolic::{Hypotheses, Sym, symbols};

fn equal(a: Vector3<Sym>, b: Vector3<Sym>) -> bool {
    (0..3).all(|i| Hypotheses::none().equal(a[i], b[i]).is_zero())
}

#[test]
fn the_precession_turns_about_the_vertical_and_the_spin_about_the_bodys_third_axis() {
    let angles = symbols(["psi", "theta", "phi"]);
    let (forms, vertical) = (euler_forms(angles), vertical(&euler(angles)));
    assert!(equal(forms.column(0).into(), vertical), "{forms}");
    assert!(equal(forms.column(2).into(), Vector3::z()), "{forms}");
}

#[test]
fn the_nutation_turns_about_the_line_of_nodes_from_the_vertical_to_the_third_axis() {
    let angles = symbols(["psi", "theta", "phi"]);
    let (nutation, vertical) = (angles[1].circle(), vertical(&euler(angles)));
    let nodes: Vector3<Sym> = euler_forms(angles).column(1).into();
    assert!(equal(vertical.cross(&Vector3::z()), nodes * nutation.sin), "{nodes}");
    assert!(Hypotheses::none().equal(vertical.z, nutation.cos).is_zero(), "{vertical}");
}
