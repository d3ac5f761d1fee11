//! Points, links and force elements found in models, compared with the known geometry.

use dalembert_scenes::ModelScene;
use dalembert_scenes::geometry::{Figure, Geometry, Joint};
use model::geometry::Action;
use nalgebra::Vector3;
use simulation::{Axes, IvpScene};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn geometry(scene: &ModelScene) -> Geometry {
    Geometry::of(&scene.model, &scene.start).unwrap_or_else(|why| panic!("{why}"))
}

/// For each link the names of its points, sorted.
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
    // the axle, and the distance of the wheels on the road, which is constant in time
    assert_eq!((axle.elements.len(), axle.rods.len()), (2, 2));
    let chain = geometry(&scene(include_str!("../../../scenes/foreign/five_links.toml")));
    assert_eq!(chain.rods.len(), 5);
    let circle = geometry(&scene(include_str!("../../../scenes/foreign/cartesian_pendulum.toml")));
    assert_eq!(circle.rods.len(), 1);
    // the pendulum is given by sine and cosine of an angle, without a frame
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

const TWO_BARS: &str = r#"
title = "Two bars with torsion springs"
parameters = { m = "1 kg", l = "0.5 m", k = "4 N m", c = "0.05 N m s", M = "1 N m", J = "0.02 kg m^2" }
coordinates = { alpha = "rad", beta = "rad" }
frames = { A = "N turned alpha about z", B = "N turned beta about z" }
points = { P = "O - l*A.y", Q = "P - l*B.y" }
energies = { potential = "k*alpha^2/2 + k*(beta - alpha)^2/2", dissipation = "c*(beta' - alpha')^2/2" }
run = { span = "3 s" }
[bodies.upper]
frame = "A"
centre = "O - l/2*A.y"
mass = "m"
inertia = "J"
[bodies.lower]
frame = "B"
centre = "P - l/2*B.y"
mass = "m"
inertia = "J"
[[torque]]
between = ["ground", "upper"]
is = "-M*N.z"
[[torque]]
on = "upper"
is = "-k*sin(alpha)*N.z"
[[force]]
along = "beta"
is = "M"
"#;

#[test]
fn torques_linear_in_an_angle_are_springs_at_its_joint_and_others_are_torques() {
    let scene = scene(TWO_BARS);
    let geometry = geometry(&scene);
    assert!(geometry.elements.is_empty(), "{:?}", geometry.elements);
    let at = |joint: &Joint| joint.at.map_or("", |spot| geometry.names[spot.place].as_str());
    let mut found: Vec<(Action, &str)> = geometry.rotaries.iter().map(|one| (one.action, at(&one.joint))).collect();
    found.sort_unstable();
    assert_eq!(found, [(Action::Elastic, "O"), (Action::Elastic, "P"), (Action::Viscous, "P")]);
    let figure = geometry.figure(0.0, &scene.start);
    let torques: Vec<f64> = figure.torques.iter().map(|torque| torque.z).collect();
    assert_eq!(torques, [-1.0, 0.0, 1.0]);
    // the angle of the lower bar is relative to the ground, with which the bar has no joint
    assert_eq!(geometry.couples.iter().map(at).collect::<Vec<_>>(), ["O", "O", ""]);
}

#[test]
fn a_spring_between_two_bodies_stands_at_their_hinge_where_no_place_tells_it() {
    let text = TWO_BARS
        .replace("points = { P = \"O - l*A.y\", Q = \"P - l*B.y\" }\n", "")
        .replace("P - l/2*B.y", "O - l*A.y - l/2*B.y")
        .replace("run = {", "start = { alpha = \"20 deg\", beta = \"-50 deg\" }\nrun = {");
    let scene = scene(&text);
    let geometry = geometry(&scene);
    let [alpha, beta] = [20.0_f64, -50.0].map(f64::to_radians);
    let figure = geometry.figure(0.0, &[alpha, beta, 0.0, 0.0]);
    let spot = |joint: &Joint| <[f64; 3]>::from(joint.at.expect("it has a point").in_figure(&figure));
    let mut found: Vec<[f64; 3]> = geometry.rotaries.iter().map(|one| spot(&one.joint)).collect();
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let hinge = [0.5 * alpha.sin(), -0.5 * alpha.cos(), 0.0];
    assert_eq!(found.len(), 3);
    for (found, wanted) in found.into_iter().zip([[0.0; 3], hinge, hinge]) {
        near(found, wanted, 1e-9);
    }
}

#[test]
fn a_spring_to_a_body_whose_centre_is_the_hinge_stands_there_and_one_between_shafts_has_no_hinge() {
    let text =
        TWO_BARS.replace("points = { P = \"O - l*A.y\", Q = \"P - l*B.y\" }\n", "").replace("P - l/2*B.y", "O - l*A.y");
    let scene = scene(&text);
    let found = geometry(&scene);
    let figure = found.figure(0.0, &scene.start);
    let hinge = found.rotaries.iter().filter(|one| one.joint.frames[0] != 0).map(|one| one.joint.at);
    for at in hinge {
        near(at.expect("it has a point").in_figure(&figure).into(), [0.0, -0.5, 0.0], 1e-9);
    }
    let shafts = r#"
title = "Two rotors on shafts of their own"
parameters = { J = "1 kg m^2", m = "1 kg", k = "3 N m", d = "1 m" }
coordinates = { a = "rad", b = "rad" }
frames = { A = "N turned a about z", B = "N turned b about z" }
points = { Q = "O + d*N.x" }
energies = { potential = "k*(b - a)^2/2" }
run = { span = "1 s" }
bodies.one = { frame = "A", centre = "O", mass = "m", inertia = "J" }
bodies.other = { frame = "B", centre = "Q", mass = "m", inertia = "J" }
"#;
    let found = geometry(&self::scene(shafts));
    assert_eq!(found.rotaries.len(), 1);
    assert_eq!((found.rotaries[0].joint.at, found.rotaries[0].joint.bodies), (None, [Some(0), Some(1)]));
}

const WHEELS: &str = r#"
title = "A gear and a belt"
parameters = { J = "1e-3 kg m^2", m = "1 kg", d = "0.4 m" }
coordinates = { a = "rad", b = "rad", c = "rad" }
frames = { A = "N turned a about z", B = "N turned b about z", C = "N turned c about z" }
points = { P = "O + d*N.x", Q = "P + d*N.x" }
run = { span = "2 s" }
bodies.pinion = { frame = "A", centre = "O", mass = "m", inertia = "J" }
bodies.wheel = { frame = "B", centre = "P", mass = "m", inertia = "J" }
bodies.pulley = { frame = "C", centre = "Q", mass = "m", inertia = "J" }
[[constraint]]
name = "mesh"
zero = "a + 3*b"
[[constraint]]
name = "belt"
zero = "b' - 2*c'"
"#;

#[test]
fn gears_touch_in_the_ratio_of_their_angles_and_belts_turn_both_wheels_one_way() {
    let geometry = geometry(&scene(WHEELS));
    let [mesh, belt] = geometry.gears.as_slice() else { panic!("{:?}", geometry.gears) };
    assert!(!mesh.is_belt && belt.is_belt && geometry.told_gears.is_empty());
    let [pinion, wheel] = mesh.wheels.map(|wheel| wheel.radius);
    assert!((pinion - 0.1).abs() < 1e-9 && (wheel - 0.3).abs() < 1e-9, "{pinion} {wheel}");
    let [first, second] = belt.wheels.map(|wheel| wheel.radius);
    assert!((second - 2.0 * first).abs() < 1e-9 && first + second < 0.4, "{first} {second}");
}

#[test]
fn gears_without_centres_are_told() {
    let text = "title = \"g\"\nparameters = { J = \"1 kg m^2\" }\ncoordinates = { a = \"rad\", b = \"rad\" }\nrun = { span = \"1 s\" }\n\
        bodies.pinion = { turns = \"a\", inertia = \"J\" }\nbodies.wheel = { turns = \"b\", inertia = \"J\" }\n\
        constraint = [{ name = \"mesh\", zero = \"a + 4*b\" }]\n";
    let geometry = geometry(&scene(text));
    assert!(geometry.gears.is_empty());
    assert_eq!(
        geometry.told_gears,
        ["The constraint mesh ties two angles: wheel turns 0.25 times as fast as pinion, the other way."]
    );
}

#[test]
fn friction_that_sticks_points_against_the_load() {
    let text = |load: &str| {
        format!(
            "title = \"s\"\nparameters = {{ m = \"1 kg\", F = \"3 N\" }}\ncoordinates = {{ x = \"m\" }}\n\
             bodies = {{ block = {{ centre = \"O + x*N.x\", mass = \"m\" }} }}\nrun = {{ span = \"1 s\" }}\n\
             [[force]]\non = \"block\"\nis = \"-F*sign(x')*N.x\"\n[[force]]\nalong = \"x\"\nis = \"{load}\"\n"
        )
    };
    for (load, force) in [("1 N", -1.0), ("-1 N", 1.0), ("0 N", 0.0), ("4 N", -3.0)] {
        let scene = scene(&text(load));
        let found = geometry(&scene).first_figure(&scene.start).forces[0].1.x;
        assert!((found - force).abs() < 1e-12, "{load}: {found}");
        let mut problem = scene.problem_with_mode_values();
        problem.span = 0.5;
        let run = problem.simulate(&scene.run().choice(), |_| ());
        let (states, switches) = (scene.start.len(), run.last.len() - 1);
        let figure = geometry(&scene).figure_with(0.5, &run.last[..states], &run.last[switches..]);
        assert!((figure.forces[0].1.x - force).abs() < 1e-12, "{load}: {:?}", figure.forces);
    }
}

/// A block of 2 kg on a rough floor under a constant force: friction balances the force up to its limit 0.5 m g = 9.81 N.
#[test]
fn friction_of_a_contact_sticks_up_to_its_limit_and_slides_against_the_motion_beyond() {
    let text = |push: f64| {
        format!(
            "title = \"b\"\ngravity = \"-g*N.y\"\nparameters = {{ m = \"2 kg\", g = \"9.81 m/s^2\" }}\n\
             coordinates = {{ x = \"m\", y = \"m\" }}\nbodies = {{ block = {{ centre = \"O + x*N.x + y*N.y\", mass = \"m\" }} }}\n\
             run = {{ span = \"1 s\" }}\n[[contact]]\nof = \"block\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"0.5\"\n\
             touching = true\n[[force]]\nalong = \"x\"\nis = \"{push} N\"\n"
        )
    };
    for (push, friction) in [(0.0, 0.0), (4.0, -4.0), (-4.0, 4.0), (12.0, -9.81), (-12.0, 9.81)] {
        let scene = scene(&text(push));
        let geometry = geometry(&scene);
        let mut problem = scene.problem_with_mode_values();
        problem.span = 0.5;
        let run = problem.simulate(&scene.run().choice(), |_| ());
        let later = geometry.figure_with(0.5, &run.outcome.state, &run.last[run.names.len()..]);
        for figure in [geometry.first_figure(&scene.start), later] {
            let found = figure.touches[0].friction;
            assert!((found.x - friction).abs() < 1e-9 && found.y == 0.0, "{push}: {found}");
            assert!(friction != 0.0 || found == Vector3::zeros(), "{push}: {found}");
        }
    }
}

#[test]
fn a_contact_place_that_is_fixed_in_no_body_is_the_rim_of_a_circle_and_no_bar() {
    let ball = "title = \"b\"\nparameters = { m = \"1 kg\", r = \"0.1 m\" }\ncoordinates = { x = \"m\", y = \"m\" }\n\
        points = { G = \"O + x*N.x + y*N.y\", P = \"G - r*N.y\" }\nbodies = { ball = { centre = \"G\", mass = \"m\" } }\n\
        start = { y = \"0.4 m\" }\nrun = { span = \"1 s\" }\n\
        contact = [{ name = \"floor\", of = \"ball at P\", through = \"O\", normal = \"N.y\" }]\n";
    let found = geometry(&scene(ball));
    assert!(found.links.is_empty() && found.planes == [true]);
    assert!(found.wheels.len() == 1 && (found.wheels[0].radius - 0.1).abs() < 1e-12 && !found.wheels[0].turns);
    let drum = "title = \"d\"\nparameters = { m = \"1 kg\", r = \"0.1 m\", R = \"0.25 m\", J = \"1 kg m^2\" }\n\
        coordinates = { x = \"m\", y = \"m\", a = \"rad\", b = \"rad\" }\n\
        frames = { A = \"N turned a about z\", B = \"N turned b about z\" }\n\
        points = { G = \"O + x*N.x + y*N.y\", P = \"G - r*(x*N.x + y*N.y)/sqrt(x^2 + y^2)\" }\n\
        start = { x = \"0.3 m\", y = \"0.4 m\" }\nrun = { span = \"0.1 s\" }\n\
        bodies.disc = { frame = \"A\", centre = \"G\", mass = \"m\", inertia = \"J\" }\n\
        bodies.drum = { frame = \"B\", centre = \"O\", mass = \"m\", inertia = \"J\" }\n\
        contact = [{ of = \"disc at P\", with = \"drum\", gap = \"sqrt(x^2 + y^2) - r - R\", normal = \"(x*N.x + y*N.y)/sqrt(x^2 + y^2)\", friction = \"0.5\" }]\n";
    let found = geometry(&scene(drum));
    let mut radii: Vec<f64> = found.wheels.iter().map(|wheel| (1e9 * wheel.radius).round() / 1e9).collect();
    radii.sort_by(f64::total_cmp);
    assert!(radii == [0.1, 0.25] && found.planes == [false], "{:?} {:?}", found.wheels, found.planes);
}
