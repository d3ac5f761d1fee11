//! Maps over two data of a scene, given by name, compared with closed forms.

use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::studies::stationary::stability::datum::Datum;
use dalembert_derivations::studies::stationary::stability::plane::{Cell, NoPlane, Plane};
use dalembert_derivations::studies::stationary::stability::reduced::Fate;
use reader::Family;
use std::path::Path;

fn scene() -> Scene {
    Scene::open(Path::new("scenes/closed_forms/upright_rotation.toml")).unwrap()
}

/// The cell at one load, over the height of the carrier's centre of mass, for rotation opposite to the rotor's axis.
fn over_height(load: f64, w: f64) -> Cell {
    let scene = scene();
    let [load_datum, height] = ["load", "carrier.centre.3"].map(|name| Datum::named(&scene, name).unwrap());
    let plane = Plane::of(&scene, [&load_datum, &height], w, false).unwrap();
    plane.cell(load, [-0.5, 0.5]).unwrap()
}

#[test]
fn over_the_height_a_tilt_costs_nothing_where_the_closed_form_says() {
    let Cell::Decided(column) = over_height(0.0, 3.0) else { panic!("in step without a load") };
    // v = -e3: H_i = w^2 (A3 - A_i) - w A'W - (m c + m' c') g; tensors of carrier and rotor about O, A' W = 1/16
    let rotor = 0.25 * 0.25f64.powi(2) + 0.000244140625;
    let stiff = |moment: f64| 9.0 * (0.03125 + 0.00048828125 - moment - rotor) - 3.0 * 0.0625;
    let height = |moment: f64| stiff(moment) / 8.0 - 0.25 * 0.25;
    let mut expected = [0.031005859375, 0.046630859375].map(height);
    expected.sort_by(f64::total_cmp);
    let neutral: Vec<f64> = column.edges.iter().filter(|edge| edge.neutral).map(|edge| edge.at).collect();
    assert_eq!(neutral.len(), 2, "{column:?}");
    assert!(neutral.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{neutral:?} {expected:?}");
    assert_eq!((column.at(-0.4), column.at(0.4)), (Fate::ByEnergy, Fate::Unstable));
}

#[test]
fn a_motor_in_step_bears_the_load_up_to_its_pull_out_and_leaves_the_map_as_it_is() {
    // b0 = 1/8 N m
    assert_eq!(over_height(0.124, 3.0), over_height(-0.1, 3.0));
    assert_eq!(over_height(0.126, 3.0), Cell::PulledOut);
}

#[test]
fn a_datum_that_is_none_or_moves_the_motor_is_refused_with_what_is_accepted() {
    let scene = scene();
    let unknown = Datum::named(&scene, "carrier.center.3").unwrap_err().to_string();
    assert!(unknown.contains("`carrier.center.3`") && unknown.contains("carrier.centre.3"), "{unknown}");
    let [load, height] = ["load", "carrier.centre.1"].map(|name| Datum::named(&scene, name).unwrap());
    assert!(matches!(Plane::of(&scene, [&height, &load], 0.0, true), Err(NoPlane::NotPolynomial(_))));
    let oblique = Plane::of(&scene, [&load, &height], 0.0, true).unwrap().cell(0.0, [-0.1, 0.2]);
    assert!(matches!(oblique, Err(NoPlane::Oblique { .. })), "{oblique:?}");
}
