//! Steady motions of models compared with closed forms: none is missing, and undecided boxes are reported.

mod along;
mod conditions;
mod contacts;
mod decimals;
mod ends;
mod friction;
mod given_values;
mod jumps;
mod loops;
mod nearest_motion;
mod orientations;
mod plays;
mod quasi_velocities;
mod reactions;
mod singular_coordinates;
mod smooth_laws;
mod turning_frames;

use dalembert_scenes::steady_motions::{
    Along, Family, Near, NoSteadyMotions, Range, SteadyMotions, SteadySearch, SteadyStability,
};
use dalembert_scenes::{Task, parse_titled};
use model::Model;
use std::f64::consts::{FRAC_PI_2, PI};

fn model(text: &str) -> Model {
    parse_titled("scene.toml", text, Task::Vary).unwrap_or_else(|error| panic!("{error}")).1
}

fn asked(ranges: &[(&str, f64, f64)], boxes: usize) -> SteadySearch {
    let ranges = ranges.iter().map(|&(name, from, to)| (name.to_owned(), Range { from, to })).collect();
    SteadySearch { ranges, boxes, ..SteadySearch::default() }
}

fn all(text: &str, ranges: &[(&str, f64, f64)]) -> SteadyMotions {
    let found = SteadyMotions::of(&model(text), &asked(ranges, 200_000), || true);
    found.unwrap_or_else(|why| panic!("{why:?}"))
}

/// For each motion the values of the unknowns, and whether it is proved to be a minimum or not.
fn values(found: &SteadyMotions) -> Vec<(Vec<f64>, Option<bool>)> {
    assert!(found.is_complete(), "{:?}", found.undecided);
    let value = |[low, high]: &[f64; 2]| {
        assert!(high - low < 1e-10, "{low} to {high}");
        0.5 * (low + high)
    };
    let verdict = |stability: &SteadyStability| match stability {
        SteadyStability::Minimum => Some(true),
        SteadyStability::Falls(_) | SteadyStability::FallsOdd(_) => Some(false),
        _ => None,
    };
    found
        .motions
        .iter()
        .map(|motion| (motion.enclosure.iter().map(value).collect(), verdict(&motion.stability)))
        .collect()
}

fn assert_are(found: &SteadyMotions, wanted: &[(&[f64], Option<bool>)]) {
    let found = values(found);
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (own, wanted) in found.iter().zip(wanted) {
        let is_near = own.0.iter().zip(wanted.0).all(|(own, wanted)| (own - wanted).abs() < 1e-9);
        assert!(is_near && own.1 == wanted.1, "{own:?} is not {wanted:?}");
    }
}

/// A pendulum in a frame that turns about the vertical.
const SHAFT: &str = r#"
title = "A pendulum on a turning shaft"
gravity = "-g*N.z"
[parameters]
m = "1 kg"
l = "0.5 m"
g = "9.81 m/s^2"
I = "0.2 kg m^2"
[coordinates]
phi = "rad"
theta = "rad"
[frames]
A = "N turned phi about z"
B = "A turned theta about x"
[points]
P = "O - l*B.z"
[bodies]
bob = { centre = "P", mass = "m" }
shaft = { frame = "A", inertia = { axes = "A", principal = ["I", "I", "I"] } }
[run]
span = "1 s"
"#;

#[test]
fn a_pendulum_on_a_turning_shaft_leaves_the_axis_where_the_shaft_is_fast() {
    let slow = all(SHAFT, &[("phi'", 2.0, 2.0)]);
    assert_are(&slow, &[(&[0.0], Some(true)), (&[PI], Some(false))]);
    assert_eq!(
        (slow.cyclic.as_slice(), slow.given.as_slice()),
        (&["phi".to_owned()][..], &[("phi'".to_owned(), 2.0)][..])
    );
    // cos theta = g/(l w^2)
    let away = (9.81 / (0.5 * 36.0_f64)).acos();
    let fast = all(SHAFT, &[("phi'", 6.0, 6.0)]);
    assert_are(&fast, &[(&[-away], Some(true)), (&[0.0], Some(false)), (&[away], Some(true)), (&[PI], Some(false))]);
}

#[test]
fn where_motions_merge_boxes_are_told_as_undecided() {
    let critical = (9.81_f64 / 0.5).sqrt();
    let found = all(SHAFT, &[("phi'", critical, critical)]);
    assert_eq!(found.motions.len(), 1, "the one above");
    assert!(!found.is_complete() && found.undecided_part > 0.0 && found.undecided_part < 1e-3);
    assert!(found.undecided.iter().all(|at| at[0][0].abs() < 1e-2), "{:?}", found.undecided);
    assert_eq!(found.regions.iter().map(|region| region.near).collect::<Vec<_>>(), [Near::Merging(1)]);
}

/// The derivatives of x^3 and y^3 vanish at the zero, and signs on the faces prove that it exists; for x^2 they do not.
#[test]
fn degenerate_motions_are_singular_in_every_direction_and_shown_by_signs() {
    let of = |force: &str| {
        let text = format!(
            "title = \"Cubes\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.a]\n\
             centre = \"O + x*N.x + y*N.y\"\nmass = \"m\"\n[[force]]\non = \"a\"\nis = \"{force}*N.x + (2 N/m^3)*y^3*N.y\"\n[run]\nspan = \"1 s\"\n"
        );
        let found = all(&text, &[("x", -1.0, 1.0), ("y", -1.0, 1.0)]);
        found.regions.iter().map(|region| (region.near, region.holds_one)).collect::<Vec<_>>()
    };
    assert_eq!(of("-(1 N/m^3)*x^3"), [(Near::Merging(2), true)]);
    assert!(of("-(1 N/m^2)*x^2").iter().all(|(near, shown)| *near != Near::Regular && !shown));
}

/// Two links, in angles and in Cartesian coordinates.
const ANGLES: &str = r#"
title = "Two links"
gravity = "-g*N.y"
[parameters]
m = "1 kg"
l = "1 m"
g = "9.81 m/s^2"
[coordinates]
a = "rad"
b = "rad"
[frames]
A = "N turned a about z"
B = "N turned b about z"
[points]
P = "O - l*A.y"
Q = "P - l*B.y"
[bodies]
one = { centre = "P", mass = "m" }
other = { centre = "Q", mass = "m" }
[run]
span = "1 s"
"#;

const PLACES: &str = r#"
title = "Two links in places"
gravity = "-g*N.y"
[parameters]
m = "1 kg"
l = "1 m"
g = "9.81 m/s^2"
[coordinates]
x1 = "m"
y1 = "m"
x2 = "m"
y2 = "m"
[points]
P = "O + x1*N.x + y1*N.y"
Q = "O + x2*N.x + y2*N.y"
[bodies]
one = { centre = "P", mass = "m" }
other = { centre = "Q", mass = "m" }
[[constraint]]
zero = "x1^2 + y1^2 - l^2"
[[constraint]]
zero = "(x2 - x1)^2 + (y2 - y1)^2 - l^2"
[start]
y1 = "-1 m"
y2 = "-2 m"
[run]
span = "1 s"
"#;

#[test]
fn two_links_rest_in_four_ways_in_angles_and_in_places() {
    let wanted = [(0.0, 0.0, true), (0.0, PI, false), (PI, 0.0, false), (PI, PI, false)];
    let in_angles: Vec<([f64; 2], bool)> = wanted.iter().map(|&(a, b, stable)| ([a, b], stable)).collect();
    let in_angles: Vec<(&[f64], Option<bool>)> =
        in_angles.iter().map(|(at, stable)| (&at[..], Some(*stable))).collect();
    assert_are(&all(ANGLES, &[]), &in_angles);
    let ranges = [("x1", -1.5, 1.5), ("y1", -1.5, 1.5), ("x2", -2.5, 2.5), ("y2", -2.5, 2.5)];
    let found = all(PLACES, &ranges);
    let in_places = values(&found);
    assert_eq!(in_places.len(), 4, "{in_places:?}");
    for (a, b, stable) in wanted {
        let at = [0.0, -a.cos(), 0.0, -a.cos() - b.cos()];
        let is_it = |(own, verdict): &(Vec<f64>, Option<bool>)| {
            own.iter().zip(at).all(|(own, at)| (own - at).abs() < 1e-9) && *verdict == Some(stable)
        };
        assert!(in_places.iter().any(is_it), "{at:?} in {in_places:?}");
    }
}

/// A mass in a plane with a potential energy.
fn plane(potential: &str) -> String {
    format!(
        "title = \"Plane\"\n[parameters]\nm = \"1 kg\"\nk = \"1 J\"\na = \"1 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[energies]\n\
         kinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"{potential}\"\n[run]\nspan = \"1 s\"\n"
    )
}

const SIDES: [(&str, f64, f64); 2] = [("x", -2.0, 2.0), ("y", -2.0, 2.0)];

#[test]
fn a_search_that_ends_early_says_that_there_is_one_motion_at_least() {
    let found = SteadyMotions::of(&model(SHAFT), &asked(&[("phi'", 6.0, 6.0)], 1), || true).expect("it is sought");
    assert!(!found.is_complete() && found.motions.len() < 4);
    assert!(found.regions.iter().any(|region| region.near == Near::Regular), "{:?}", found.regions);
}

fn held(family: &Family, point: &[f64]) -> bool {
    let holds =
        |at: &[[f64; 2]]| at.iter().zip(point).all(|([low, high], at)| low - 1e-12 <= *at && *at <= high + 1e-12);
    family.pieces.iter().any(|(_, at)| holds(at))
}

#[test]
fn a_circle_of_equilibria_is_enclosed_as_a_curve_by_symmetry() {
    let found = all(&plane("k*((x^2 + y^2)/a^2 - 1)^2"), &SIDES);
    assert!(found.is_complete(), "{:?}", found.regions);
    assert_eq!(found.motions.len(), 1);
    assert!(matches!(found.motions[0].stability, SteadyStability::Falls(2)));
    let [(circle, members)] = &found.families[..] else { panic!("{:?}", found.families) };
    assert_eq!((circle.dimension, circle.along.len()), (1, 1));
    for step in 0..360 {
        let point = [f64::from(step).to_radians().cos(), f64::from(step).to_radians().sin()];
        assert!(held(circle, &point), "{point:?}");
    }
    assert!(members.iter().all(|one| (one.values[0].hypot(one.values[1]) - 1.0).abs() < 1e-12));
    // the tilted ring has three equilibria: a lowest point, a saddle and a maximum
    assert_eq!(values(&all(&plane("k*((x^2 + y^2)/a^2 - 1)^2 + k*x/a/10"), &SIDES)).len(), 3);
}

/// y = x^2: the force has no component along (1, 2 x), which is neither a rotation nor a translation.
#[test]
fn a_bent_valley_is_a_family_of_equilibria() {
    let found = all(&plane("k*(y/a - x^2/a^2)^2"), &SIDES);
    assert!(found.is_complete() && found.motions.is_empty(), "{:?}", found.regions);
    let [(valley, _)] = &found.families[..] else { panic!("{:?}", found.families) };
    for step in -10..=10 {
        let x = f64::from(step) / 10.0;
        assert!(held(valley, &[x, x * x]), "{x}");
    }
}

#[test]
fn without_positive_masses_no_energy_proves_anything() {
    let negative = plane("k*(x^2 + y^2)/a^2").replace("m/2*(x'^2 + y'^2)", "m/2*(x'^2 - y'^2)");
    let found = all(&negative, &SIDES);
    assert!(matches!(found.motions[0].stability, SteadyStability::Linear(_)), "{:?}", found.motions);
}

#[test]
fn what_nothing_balances_has_no_steady_motion() {
    let falling = plane("k*x/a");
    assert!(values(&all(&falling, &[])).is_empty());
}

#[test]
fn a_range_is_asked_for_where_no_circle_has_one() {
    let bistable = plane("k*(x^4/a^4 - 2*x^2/a^2 + y^2/a^2)");
    let none = SteadyMotions::of(&model(&bistable), &SteadySearch::default(), || true);
    assert_eq!(none.err(), Some(NoSteadyMotions::WithoutRange { names: vec!["x".to_owned(), "y".to_owned()] }));
    let minima = [(&[-1.0, 0.0][..], Some(true)), (&[0.0, 0.0], Some(false)), (&[1.0, 0.0], Some(true))];
    assert_are(&all(&bistable, &SIDES), &minima);
    let unknown = SteadyMotions::of(&model(&bistable), &asked(&[("z", 0.0, 1.0)], 10), || true);
    assert!(matches!(unknown, Err(NoSteadyMotions::Unknown { name, .. }) if name == "z"));
}

/// Torque and friction determine the speed of a shaft, whose angle is cyclic.
#[test]
fn a_driven_shaft_has_the_speed_at_which_friction_takes_its_torque() {
    let torque = "[[torque]]\non = \"A\"\nis = \"((2 N m) - (0.1 N m s^2)*phi'^2)*A.z\"\n[run]";
    let found = all(&SHAFT.replace("[run]", torque), &[("phi'", 0.0, 20.0)]);
    let speed = 20f64.sqrt();
    // g/(l w^2) = 0.981: the bob has left the vertical
    let away = (9.81 / (0.5 * speed * speed)).acos();
    let places: Vec<(Vec<f64>, Option<bool>)> = values(&found);
    assert_eq!(places.len(), 4, "{places:?}");
    assert!(places.iter().all(|(at, _)| (at[0] - speed).abs() < 1e-9));
    assert!(places.iter().any(|(at, _)| (at[1] - away).abs() < 1e-8), "{places:?}");
    assert!(places.iter().all(|(at, _)| at[1].abs() < 0.2 || at[1].abs() > FRAC_PI_2));
}

/// A shaft at any speed: the pendulum hangs, stands, or has left the vertical, where cos(theta) = g/(l w^2).
#[test]
fn motions_at_every_speed_of_a_shaft_are_curves() {
    let found = all(SHAFT, &[("phi'", 5.0, 9.0)]);
    assert!(found.is_complete() && found.motions.is_empty(), "{:?}", found.regions);
    assert_eq!(found.families.len(), 4, "{:?}", found.families);
    for speed in [5.0, 6.5, 9.0_f64] {
        let away = (9.81 / (0.5 * speed * speed)).acos();
        for angle in [0.0, PI, away, -away] {
            let turned =
                |family: &Family| (-1..=1).any(|turn| held(family, &[speed, angle + 2.0 * PI * f64::from(turn)]));
            assert!(found.families.iter().any(|(family, _)| turned(family)), "{speed} {angle}");
        }
    }
}

/// Springs written as forces have a potential energy; a follower force and a damper have none.
#[test]
fn springs_as_forces_prove_what_an_energy_does() {
    let with = |load: &str| ANGLES.replace("[run]", &format!("{load}\n[run]"));
    let spring = with("[[force]]\nbetween = [\"O\", \"Q\"]\nis = \"-(2 N/m)*(distance(O, Q) - (1.5 m))\"");
    let found = all(&spring, &[("a", -0.3, 0.3), ("b", -0.3, 0.3)]);
    assert!(found.have_potential && matches!(found.motions[0].stability, SteadyStability::Minimum), "{found:?}");
    let follower = with("[[force]]\non = \"other\"\nis = \"(2 N)*B.y\"");
    let damper = with("[[force]]\non = \"other\"\nis = \"-(2 N s/m)*velocity(Q)\"");
    for text in [follower, damper] {
        let found = all(&text, &[("a", -0.3, 0.3), ("b", -0.3, 0.3)]);
        assert!(!found.have_potential && matches!(found.motions[0].stability, SteadyStability::Linear(_)), "{found:?}");
    }
}

/// A rolling wheel with a torque and with drag on its centre: T = c r^2 phi'.
#[test]
fn loads_along_determined_speeds_act_through_the_constraint() {
    let wheel = "title = \"Wheel\"\n[parameters]\nm = \"1 kg\"\nI = \"2 kg m^2\"\nr = \"0.5 m\"\nc = \"4 N s/m\"\nT = \"3 N m\"\n\
        [coordinates]\nx = \"m\"\nphi = \"rad\"\n[energies]\nkinetic = \"m/2*x'^2 + I/2*phi'^2\"\n\
        [[force]]\nalong = \"x\"\nis = \"-c*x'\"\n[[force]]\nalong = \"phi\"\nis = \"T\"\n\
        [[constraint]]\nname = \"rolling\"\nzero = \"x' - r*phi'\"\n[run]\nspan = \"1 s\"\n";
    let found = all(wheel, &[("phi'", -100.0, 100.0)]);
    assert_are(&found, &[(&[3.0], None)]);
    // x' is determined by rolling
    assert!((found.motions[0].state[2] - 1.5).abs() < 1e-12, "{:?}", found.motions);
}

/// A driven shaft with a loose mass: torque and friction determine the speed T/d = 10 rad/s.
const DRIVEN: &str = "title = \"Shaft\"\n[parameters]\nT = \"0.1 N m\"\nd = \"0.01 N m s\"\n[coordinates]\nphi = \"rad\"\na = \"rad\"\n\
    [energies]\nkinetic = \"(1 kg m^2)/2*(phi'^2 + a'^2)\"\npotential = \"-(1 J)*cos(a)\"\n\
    [[force]]\nalong = \"phi\"\nis = \"T - d*phi'\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn one_value_of_a_speed_that_an_equation_asks_for_is_refused() {
    let of = |ranges: &[(&str, f64, f64)]| SteadyMotions::of(&model(DRIVEN), &asked(ranges, 200_000), || true);
    for value in [9.999, 3.0] {
        let refused = NoSteadyMotions::Sought { name: "phi'".to_owned(), value };
        assert_eq!(of(&[("phi'", value, value)]).err(), Some(refused));
    }
    // 0.1 = 0.01 10 exactly as decimals; no other speed is accepted
    let exact = of(&[("phi'", 10.0, 10.0)]).unwrap_or_else(|why| panic!("{why:?}"));
    assert_eq!((exact.motions.len(), exact.free_speeds.len()), (2, 0), "{exact:?}");
    assert_eq!(of(&[("phi'", 9.9, 10.1)]).map(|found| found.motions.len()), Ok(2));
    let along = Along::of(&model(DRIVEN), &asked(&[], 1000), ("phi'", Range { from: 5.0, to: 12.0 }), 3, || true);
    assert!(matches!(along, Err(NoSteadyMotions::Sought { .. })));
}

/// A bead on a hoop driven at constant speed: cos(theta) = g/(r W^2), although the frame is given as a function of the time.
#[test]
fn a_frame_that_is_turned_steadily_leaves_no_time_in_the_equations() {
    const HOOP: &str = r#"
title = "Hoop"
gravity = "-g*N.z"
[parameters]
r = "1 m"
g = "9.81 m/s^2"
W = "4 rad/s"
[coordinates]
theta = "rad"
[frames]
A = "N turned W*t about z"
B = "A turned theta about y"
[points]
P = "O - r*B.z"
[bodies]
bead = { centre = "P", mass = "1 kg" }
"#;
    let angle = (9.81_f64 / 16.0).acos();
    let mut found: Vec<f64> = values(&all(HOOP, &[])).iter().map(|(at, _)| at[0]).collect();
    found.sort_by(f64::total_cmp);
    let wanted = [-angle, 0.0, angle, PI];
    assert!(
        found.len() == 4 && found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-9),
        "{found:?}"
    );
}
