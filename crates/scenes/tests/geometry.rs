//! Places, links and elements that are found in models, compared with known geometry.

use dalembert_scenes::ModelScene;
use dalembert_scenes::geometry::{Figure, Geometry};
use model::geometry::Action;
use simulation::{Axes, IvpScene};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn geometry(scene: &ModelScene) -> Geometry {
    Geometry::of(&scene.model, &scene.start).unwrap_or_else(|why| panic!("{why}"))
}

/// The names of a link's places, in order of the alphabet.
fn links(geometry: &Geometry) -> Vec<Vec<&str>> {
    let names = |places: &[usize]| {
        let mut names: Vec<&str> = places.iter().map(|place| geometry.names[*place].as_str()).collect();
        names.sort_unstable();
        names
    };
    geometry.links.iter().map(|link| names(&link.places)).collect()
}

fn place(geometry: &Geometry, figure: &Figure, name: &str) -> [f64; 3] {
    let number =
        geometry.names.iter().position(|known| known == name).unwrap_or_else(|| panic!("no place is called {name}"));
    figure.places[number].into()
}

fn near(a: [f64; 3], b: [f64; 3], within: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= within), "{a:?} beside {b:?}");
}

#[test]
fn the_rods_of_a_double_pendulum_have_their_ends_where_its_angles_say() {
    let scene = scene(include_str!("../../../scenes/models/double_pendulum.toml"));
    let geometry = geometry(&scene);
    assert_eq!(links(&geometry), [["O", "P"], ["P", "Q"]]);
    assert_eq!(geometry.plane.map(<[f64; 3]>::from), Some([0.0, 0.0, 1.0]));
    let figure = geometry.figure(0.0, &scene.start);
    let (sin, cos) = 120.0_f64.to_radians().sin_cos();
    near(place(&geometry, &figure, "P"), [sin, -cos, 0.0], 1e-12);
    near(place(&geometry, &figure, "Q"), [sin + 1.0, -cos, 0.0], 1e-12);
}

const FOUR_BAR: &str = r#"
title = "A four-bar linkage"
parameters = { a = "0.2 m", b = "0.6 m", c = "0.5 m", d = "0.7 m", m = "1 kg" }
coordinates = { alpha = "rad", beta = "rad", gamma = "rad" }
frames = { A = "N turned alpha about z", B = "N turned beta about z", C = "N turned gamma about z" }
points = { P = "O + a*A.x", Q = "P + b*B.x", G = "O + d*N.x", R = "G + c*C.x" }
bodies = { coupler = { frame = "B", centre = "P + b/2*B.x", mass = "m", inertia = "m*b^2/12" } }
constraint = [{ name = "pin", zero = "Q - R" }]
start = { alpha = "60 deg", beta = "guess 30 deg", gamma = "guess 100 deg", "alpha'" = "6 rad/s" }
run = { span = "2 s", tolerance = 1e-10 }
"#;

#[test]
fn the_loop_of_a_four_bar_linkage_is_closed_at_every_time() {
    let scene = scene(FOUR_BAR);
    let geometry = geometry(&scene);
    assert_eq!(links(&geometry).len(), 3, "{:?}", links(&geometry));
    let mut problem = scene.problem(Axes::First);
    problem.span = 2.0;
    let run = problem.simulate(&scene.run().choice(), |_| ());
    assert!(run.outcome.reached() && run.rows.len() > 100);
    for (time, row) in run.times.iter().zip(&run.rows) {
        let figure = geometry.figure(*time, &row[..scene.start.len()]);
        near(place(&geometry, &figure, "Q"), place(&geometry, &figure, "R"), 1e-9);
    }
}

const TOP: &str = r#"
title = "A top"
gravity = "-g*N.z"
parameters = { m = "1 kg", l = "0.3 m", A = "0.1 kg m^2", C = "0.02 kg m^2", g = "9.81 m/s^2" }
coordinates = { psi = "rad", theta = "rad", phi = "rad" }
frames = { B = "N turned psi about z", D = "B turned theta about x", F = "D turned phi about z" }
points = { G = "O + l*F.z" }
bodies = { top = { frame = "F", centre = "G", mass = "m", inertia = { principal = ["A", "A", "C"] } } }
start = { psi = "30 deg", theta = "40 deg", phi = "70 deg", "phi'" = "30 rad/s" }
run = { span = "1 s" }
"#;

#[test]
fn the_axis_of_a_top_leans_as_its_angles_say() {
    let scene = scene(TOP);
    let geometry = geometry(&scene);
    assert_eq!(links(&geometry), [["G", "O"]]);
    assert_eq!((geometry.plane, geometry.links[0].bodies.as_slice()), (None, &[0][..]));
    let figure = geometry.figure(0.0, &scene.start);
    let (psi, theta) = (30.0_f64.to_radians(), 40.0_f64.to_radians());
    let axis = [psi.sin() * theta.sin(), -psi.cos() * theta.sin(), theta.cos()];
    near(place(&geometry, &figure, "G"), axis.map(|part| 0.3 * part), 1e-12);
    near(figure.frames[3][2].into(), axis, 1e-12);
}

#[test]
fn springs_are_found_in_energies_and_between_points_and_rods_in_constraints() {
    let swing = r#"
title = "A pendulum on a spring"
gravity = "-g*N.y"
parameters = { m = "1 kg", k = "50 N/m", l = "0.5 m", g = "9.81 m/s^2" }
coordinates = { r = "m", theta = "rad" }
frames = { A = "N turned theta about z" }
bodies = { bob = { centre = "O - r*A.y", mass = "m" } }
energies = { potential = "k*(r - l)^2/2" }
start = { r = "0.6 m" }
run = { span = "1 s" }
"#;
    let found = geometry(&scene(swing));
    assert_eq!(found.elements.iter().map(|one| one.action).collect::<Vec<_>>(), [Action::Elastic]);
    assert!(found.links.is_empty() && found.telescopes.is_empty());
    let axle = geometry(&scene(include_str!("../../../scenes/foreign/car_axis.toml")));
    // the axle, and the line between the wheels, which the road moves and keeps as long
    assert_eq!((axle.elements.len(), axle.rods.len()), (2, 2));
    let chain = geometry(&scene(include_str!("../../../scenes/foreign/five_links.toml")));
    assert_eq!(chain.rods.len(), 5);
    let circle = geometry(&scene(include_str!("../../../scenes/foreign/cartesian_pendulum.toml")));
    assert_eq!(circle.rods.len(), 1);
    // by the sine and the cosine of an angle, without a frame
    let cart = geometry(&scene(include_str!("../../../scenes/models/stiff_spring.toml")));
    assert_eq!((cart.rods.len(), cart.elements.len()), (1, 2));
}

#[test]
fn a_rolling_disc_is_a_wheel_and_its_contact_no_part_of_it() {
    let scene = scene(include_str!("../../../scenes/models/rolling_disc.toml"));
    let geometry = geometry(&scene);
    let [wheel] = geometry.wheels.as_slice() else { panic!("{:?}", geometry.wheels) };
    assert!((wheel.radius - 0.343).abs() < 1e-12 && wheel.axis == Some(1));
    assert!(geometry.links.is_empty(), "{:?}", links(&geometry));
}
