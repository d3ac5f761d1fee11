//! Steady motions of models beside what is known of them in closed form; none is missing, and what is not decided is told.

use dalembert_scenes::steady_motions::{
    Along, Asked, Case, Change, Family, Near, NoSteadyMotions, PlaneCell, Range, SteadyMotion, SteadyMotions,
    SteadyStability, middles,
};
use dalembert_scenes::{Task, parse_titled};
use model::Model;
use std::f64::consts::{FRAC_PI_2, PI};

fn model(text: &str) -> Model {
    parse_titled("scene.toml", text, Task::Vary).unwrap_or_else(|error| panic!("{error}")).1
}

fn asked(ranges: &[(&str, f64, f64)], boxes: usize) -> Asked {
    let ranges = ranges.iter().map(|&(name, from, to)| (name.to_owned(), Range { from, to })).collect();
    Asked { ranges, boxes }
}

fn all(text: &str, ranges: &[(&str, f64, f64)]) -> SteadyMotions {
    let found = SteadyMotions::of(&model(text), &asked(ranges, 200_000), || true);
    found.unwrap_or_else(|why| panic!("{why:?}"))
}

/// The values of the unknowns, motion after motion, and whether each is a proved minimum or proved to be none.
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

/// Two links, in angles and in places.
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

/// A potential energy of a plane.
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
    // tilted, it has a lowest and a highest point
    assert_eq!(values(&all(&plane("k*((x^2 + y^2)/a^2 - 1)^2 + k*x/a/10"), &SIDES)).len(), 3);
}

/// y = x^2: the force has no component along (1, 2 x), which is no turn and no shift.
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
    let none = SteadyMotions::of(&model(&bistable), &Asked::default(), || true);
    assert_eq!(none.err(), Some(NoSteadyMotions::WithoutRange { names: vec!["x".to_owned(), "y".to_owned()] }));
    let minima = [(&[-1.0, 0.0][..], Some(true)), (&[0.0, 0.0], Some(false)), (&[1.0, 0.0], Some(true))];
    assert_are(&all(&bistable, &SIDES), &minima);
    let unknown = SteadyMotions::of(&model(&bistable), &asked(&[("z", 0.0, 1.0)], 10), || true);
    assert!(matches!(unknown, Err(NoSteadyMotions::Unknown { name, .. }) if name == "z"));
}

/// Torque and friction determine the speed of a shaft, whose angle occurs nowhere.
#[test]
fn a_driven_shaft_has_the_speed_at_which_friction_takes_its_torque() {
    let torque = "[[torque]]\non = \"A\"\nis = \"((2 N m) - (0.1 N m s^2)*phi'^2)*A.z\"\n[run]";
    let found = all(&SHAFT.replace("[run]", torque), &[("phi'", 0.0, 20.0)]);
    let speed = 20f64.sqrt();
    // g/(l w^2) = 0.981: the bob has left the axis
    let away = (9.81 / (0.5 * speed * speed)).acos();
    let places: Vec<(Vec<f64>, Option<bool>)> = values(&found);
    assert_eq!(places.len(), 4, "{places:?}");
    assert!(places.iter().all(|(at, _)| (at[0] - speed).abs() < 1e-9));
    assert!(places.iter().any(|(at, _)| (at[1] - away).abs() < 1e-8), "{places:?}");
    assert!(places.iter().all(|(at, _)| at[1].abs() < 0.2 || at[1].abs() > FRAC_PI_2));
}

/// A disc that rolls straight ahead: lean'' = (4 g/(5 r) - 12/5 s^2) lean at the spin s, and its heading and spin stay as they are.
#[test]
fn a_disc_that_rolls_straight_falls_below_a_spin() {
    const DISC: &str = include_str!("../../../scenes/models/rolling_disc.toml");
    for spin in [5.0, 2.0] {
        let found = all(DISC, &[("heading'", 0.0, 0.0), ("spin'", spin, spin), ("lean", -1.0, 1.0)]);
        assert_eq!((found.motions.len(), found.free_speeds.len()), (1, 2));
        let square: f64 = 0.8 * 9.81 / 0.343 - 2.4 * spin * spin;
        let at = discs(&found.motions[0]);
        assert!(
            at.len() == 2
                && at.iter().all(|[re, im]| {
                    let (own, other) = if square > 0.0 { (re, im) } else { (im, re) };
                    (own.abs() - square.abs().sqrt()).abs() < 1e-10 && other.abs() < 1e-10
                }),
            "{at:?}"
        );
    }
}

/// A shaft at every speed: the pendulum hangs, stands, or has left the axis where cos(theta) = g/(l w^2).
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

/// A disc that rolls in a circle: 3/2 W s cos(a) - 5/4 W^2 sin(a) cos(a) = g/r sin(a) for a lean a, a heading that turns by W and a spin s.
#[test]
fn a_disc_rolls_in_circles_at_every_lean_at_which_it_can() {
    const DISC: &str = include_str!("../../../scenes/models/rolling_disc.toml");
    for (turn, spin) in [(0.5, 6.0), (6.0, -3.0), (9.0, 0.0), (0.0, 5.0)] {
        let found = all(DISC, &[("heading'", turn, turn), ("spin'", spin, spin)]);
        assert!(found.is_complete() && found.unknowns.len() == 1);
        let out_of_balance =
            |a: f64| 1.5 * turn * spin * a.cos() - 1.25 * turn * turn * a.sin() * a.cos() - 9.81 / 0.343 * a.sin();
        let steps = 10_000;
        let at = |step: usize| -3.0 + 2.0 * PI * step as f64 / steps as f64;
        let turns = |step: &usize| (out_of_balance(at(*step)) > 0.0) != (out_of_balance(at(*step + 1)) > 0.0);
        let count = (0..steps).filter(turns).count();
        assert_eq!(found.motions.len(), count, "{turn} {spin}");
        for motion in &found.motions {
            let lean = motion.state[3];
            assert!(out_of_balance(lean).abs() < 1e-10, "{lean}");
            // rolling along the heading, which is x
            assert!((motion.state[5] - 0.343 * spin).abs() < 1e-9, "{:?}", motion.state);
        }
    }
}

fn along(text: &str, ranges: &[(&str, f64, f64)], (name, from, to): (&str, f64, f64)) -> Along {
    let found = Along::of(&model(text), &asked(ranges, 200_000), (name, Range { from, to }), 21, || true);
    found.unwrap_or_else(|why| panic!("{why:?}"))
}

fn assert_changes(found: &Along, wanted: &[(f64, Change)]) {
    let told: Vec<(f64, f64, Change)> =
        found.bifurcations.iter().map(|one| (one.before.value, one.after.value, one.change)).collect();
    assert_eq!(told.len(), wanted.len(), "{told:?}");
    for (&(from, to, change), &(at, kind)) in told.iter().zip(wanted) {
        assert!(from < at && at < to && to - from < 1e-3 && change == kind, "{told:?} for {at}");
    }
}

#[test]
fn a_pendulum_on_a_turning_shaft_leaves_the_axis_at_a_pitchfork() {
    let critical = (9.81_f64 / 0.5).sqrt();
    assert_changes(&along(SHAFT, &[], ("phi'", 1.0, 8.03)), &[(critical, Change::Pitchfork)]);
    // the same by the length at one speed: l = g/w^2
    let by_length = along(SHAFT, &[("phi'", 5.0, 5.0)], ("l", 0.1, 0.93));
    assert_changes(&by_length, &[(9.81 / 25.0, Change::Pitchfork)]);
}

/// A beam that snaps: V = x^4/4 - x^2/2 + p x has three equilibria for |p| < 2/sqrt(27).
#[test]
fn a_beam_that_snaps_has_folds_at_the_ends_of_its_two_shapes() {
    let text =
        plane("k*(x^4/a^4/4 - x^2/a^2/2 + p*x/a + y^2/a^2/2)").replace("[coordinates]", "p = \"0\"\n[coordinates]");
    let fold = 2.0 / 27f64.sqrt();
    assert_changes(&along(&text, &SIDES, ("p", -0.9, 0.87)), &[(-fold, Change::Fold), (fold, Change::Fold)]);
}

/// Springs that are written as forces have an energy; a follower force and a damper have none.
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

/// A wheel that rolls, driven by a torque and braked along its way: T = c r^2 phi'.
#[test]
fn loads_along_determined_speeds_act_through_the_constraint() {
    let wheel = "title = \"Wheel\"\n[parameters]\nm = \"1 kg\"\nI = \"2 kg m^2\"\nr = \"0.5 m\"\nc = \"4 N s/m\"\nT = \"3 N m\"\n\
        [coordinates]\nx = \"m\"\nphi = \"rad\"\n[energies]\nkinetic = \"m/2*x'^2 + I/2*phi'^2\"\n\
        [[force]]\nalong = \"x\"\nis = \"-c*x'\"\n[[force]]\nalong = \"phi\"\nis = \"T\"\n\
        [[constraint]]\nname = \"rolling\"\nzero = \"x' - r*phi'\"\n[run]\nspan = \"1 s\"\n";
    let found = all(wheel, &[("phi'", -100.0, 100.0)]);
    assert_are(&found, &[(&[3.0], None)]);
    // x' is determined
    assert!((found.motions[0].state[2] - 1.5).abs() < 1e-12, "{:?}", found.motions);
}

/// A driven shaft with a loose mass: torque and friction ask for the speed, T/d = 10 rad/s.
const DRIVEN: &str = "title = \"Shaft\"\n[parameters]\nT = \"0.1 N m\"\nd = \"0.01 N m s\"\n[coordinates]\nphi = \"rad\"\na = \"rad\"\n\
    [energies]\nkinetic = \"(1 kg m^2)/2*(phi'^2 + a'^2)\"\npotential = \"-(1 J)*cos(a)\"\n\
    [[force]]\nalong = \"phi\"\nis = \"T - d*phi'\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn one_value_of_a_speed_that_an_equation_asks_for_is_refused() {
    let of = |ranges: &[(&str, f64, f64)]| SteadyMotions::of(&model(DRIVEN), &asked(ranges, 200_000), || true);
    for value in [10.0, 3.0] {
        let refused = NoSteadyMotions::Sought { name: "phi'".to_owned(), value };
        assert_eq!(of(&[("phi'", value, value)]).err(), Some(refused));
    }
    assert_eq!(of(&[("phi'", 9.9, 10.1)]).map(|found| found.motions.len()), Ok(2));
    let along = Along::of(&model(DRIVEN), &asked(&[], 1000), ("phi'", Range { from: 5.0, to: 12.0 }), 3, || true);
    assert!(matches!(along, Err(NoSteadyMotions::Sought { .. })));
}

#[test]
fn two_motions_that_leave_their_range_together_are_no_fold() {
    let found = along(DRIVEN, &[("phi'", 1.0, 30.0)], ("T", 0.0, 0.193));
    assert_changes(&found, &[(0.01, Change::LeaveTogether)]);
}

/// The pendulum leaves the axis where l w^2 passes g.
#[test]
fn over_two_parameters_motions_change_where_the_closed_form_says() {
    let (model, asked) = (model(SHAFT), asked(&[], 20_000));
    let directions = [("l", Range { from: 0.25, to: 1.25 }), ("phi'", Range { from: 2.0, to: 7.0 })];
    let columns: Vec<Vec<PlaneCell>> = middles(directions[0].1, 4)
        .into_iter()
        .map(|value| PlaneCell::column(&model, &asked, directions, (value, 5), || true).expect("they are sought"))
        .collect();
    for cell in columns.iter().flatten() {
        let [l, w] = cell.values;
        let wanted = if l * w * w > 9.81 { 4 } else { 2 };
        assert!(cell.found.is_complete() && cell.found.motions.len() == wanted, "{:?}", cell.values);
    }
    let mut borders = 0;
    for pair in columns.iter().flat_map(|column| column.windows(2)).filter(|pair| !pair[0].is_like(&pair[1])) {
        let [[l, below], [_, above]] =
            pair[0].border(&pair[1], &model, &asked, ["l", "phi'"], || true).expect("they are sought");
        let w = (9.81 / l).sqrt();
        assert!((below..=above).contains(&w) && above - below <= 1.0 / 32.0 + 1e-12, "{below} to {above} beside {w}");
        borders += 1;
    }
    assert_eq!(borders, 4);
}

#[test]
fn values_on_the_way_to_a_change_are_kept() {
    let along = Along::of(&model(SHAFT), &asked(&[], 20_000), ("phi'", Range { from: 3.0, to: 6.0 }), 4, || true)
        .expect("sought");
    let critical = (9.81_f64 / 0.5).sqrt();
    let near = along.visited.iter().map(|sample| (sample.value - critical).abs()).fold(f64::INFINITY, f64::min);
    assert!(near < 1e-3 && along.visited.len() > along.samples.len() + 5, "{near}");
    assert!(along.visited.windows(2).all(|pair| pair[0].value <= pair[1].value));
}

const SLEIGH: &str = include_str!("../../../scenes/models/chaplygin_sleigh.toml");

fn discs(motion: &SteadyMotion) -> Vec<[f64; 2]> {
    let SteadyStability::Linear(found) = &motion.stability else { panic!("{:?}", motion.stability) };
    let enclosed = found.enclosed.as_ref().unwrap_or_else(|why| panic!("{why}"));
    enclosed.discs.iter().map(|disc| disc.centre).collect()
}

/// m v' = m a w^2, (J + m a^2) w' = -m a v w: the sleigh runs straight at every speed v, and turns back like exp(-m a v t/(J + m a^2)).
#[test]
fn a_sleigh_runs_straight_at_every_speed_in_every_heading() {
    let named = SLEIGH.replace("[frames]", "[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n[frames]");
    let named =
        named.replace("[start]\n\"x'\" = \"1 m/s\"\n\"psi'\" = \"1 rad/s\"", "[start]\nv = \"1 m/s\"\nw = \"1 rad/s\"");
    for (text, v) in [(named.as_str(), "v"), (SLEIGH, "velocity(G).B.x")] {
        for (speed, rate) in [(3.0, -0.3 / 0.11), (-2.0, 0.2 / 0.11)] {
            let found = all(text, &[(v, speed, speed), ("psi'", -2.0, 2.0)]);
            assert_eq!(found.cyclic, ["x", "y", "psi"]);
            assert_eq!(values(&found).iter().map(|one| one.0.clone()).collect::<Vec<_>>(), [[0.0]], "{found:?}");
            let [at] = &discs(&found.motions[0])[..] else { panic!("{found:?}") };
            assert!((at[0] - rate).abs() < 1e-12 && at[1] == 0.0, "{at:?}");
            assert!((found.motions[0].quasi_velocities[0].1 - speed).abs() < 1e-12);
        }
    }
}

/// A car whose steering is held by a spring: at the angle d the heading turns by v tan(d)/l.
#[test]
fn a_car_runs_in_a_circle_at_every_speed() {
    const CAR: &str = r#"
title = "Car"
[parameters]
m = "2 kg"
J = "0.3 kg m^2"
I = "0.01 kg m^2"
l = "0.5 m"
k = "1 N m"
[coordinates]
x = "m"
y = "m"
psi = "rad"
d = "rad"
[frames]
B = "N turned psi about z"
F = "B turned d about z"
[points]
P = "O + x*N.x + y*N.y"
Q = "P + l*B.x"
[bodies]
car = { frame = "B", centre = "P", mass = "m", inertia = "J" }
fork = { frame = "F", inertia = "I" }
[[force]]
along = "d"
is = "-k*(d - 0.3)"
[[constraint]]
zero = "velocity(P) . B.y"
[[constraint]]
zero = "velocity(Q) . F.y"
[start]
"x'" = "1 m/s"
[run]
span = "1 s"
"#;
    for speed in [1.0, 4.0] {
        let found = all(CAR, &[("velocity(P).B.x", speed, speed), ("d", -1.0, 1.0)]);
        assert_eq!(found.cyclic, ["x", "y", "psi"]);
        let [motion] = &found.motions[..] else { panic!("{found:?}") };
        assert!((motion.state[3] - 0.3).abs() < 1e-12 && (motion.state[6] - speed * 0.3_f64.tan() / 0.5).abs() < 1e-12);
    }
}

/// Whipple's bicycle runs straight ahead at every speed.
#[test]
fn a_bicycle_runs_straight_at_every_speed() {
    const BICYCLE: &str = include_str!("../../../scenes/foreign/bicycle.toml");
    let near = 1e-5;
    let found = all(
        BICYCLE,
        &[("rear'", -17.51, -17.5), ("lean", -near, near), ("pitch", -near, near), ("steer", -near, near)],
    );
    assert!(found.is_complete() && found.motions.is_empty(), "{:?}", found.regions);
    let [(straight, _)] = &found.families[..] else { panic!("{:?}", found.families) };
    assert_eq!(straight.dimension, 1);
    for speed in [-17.51, -17.503, -17.5] {
        assert!(held(straight, &straight_on(&found, speed)));
    }
}

fn straight_on(found: &SteadyMotions, speed: f64) -> Vec<f64> {
    found.unknowns.iter().map(|unknown| if unknown.name == "rear'" { speed } else { 0.0 }).collect()
}

/// k x = F s with a part s of the friction from -1 to 1: a block rests for |x| <= F/k.
#[test]
fn dry_friction_holds_a_block_over_an_interval() {
    const BLOCK: &str = include_str!("../../../scenes/models/dry_friction.toml");
    let found = SteadyMotions::of_cases(&model(BLOCK), &asked(&[("x", -3.0, 3.0)], 1_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let [(cases, own)] = &found[..] else { panic!("{found:?}") };
    assert_eq!(cases, &[Case::Between]);
    assert!(own.is_complete() && own.motions.is_empty());
    let [(rest, _)] = &own.families[..] else { panic!("{own:?}") };
    let [low, high] = rest.hull[0];
    assert!((low + 1.0).abs() < 1e-2 && (high - 1.0).abs() < 1e-2, "{low} {high}");
}

/// A spring on one side and a weaker one on the other, both pushed by a force: rest on that side alone which the force pushes to.
#[test]
fn springs_on_two_sides_have_the_equilibrium_of_the_side_that_is_pushed() {
    let text = "title = \"Two sides\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"(1 N) - if(x > (0 m), (4 N/m)*x, (1 N/m)*x)\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -3.0, 3.0)], 1_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let motions: Vec<f64> =
        found.iter().flat_map(|(_, own)| own.motions.iter().map(|motion| motion.state[0])).collect();
    assert_eq!(motions.len(), 1, "{found:?}");
    assert!((motions[0] - 0.25).abs() < 1e-12 && found.iter().all(|(_, own)| own.is_complete()));
    let stable =
        found.iter().flat_map(|(_, own)| &own.motions).all(|own| matches!(own.stability, SteadyStability::Minimum));
    assert!(stable, "{found:?}");
}

/// A block on a slope rests everywhere where the slope is below the friction, and nowhere above it.
#[test]
fn a_block_rests_on_a_slope_below_the_friction() {
    let slope = |angle: f64| {
        let text = format!(
            "title = \"Slope\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"20 kg\"\nf = \"0.3\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nblock = {{ centre = \"P\", mass = \"m\" }}\n\
             [[contact]]\nname = \"floor\"\nof = \"block at P\"\nthrough = \"O\"\nnormal = \"cos({angle})*N.y - sin({angle})*N.x\"\n\
             friction = \"f\"\ntouching = true\n[run]\nspan = \"1 s\"\n"
        );
        let ranges = asked(&[("x", -1.0, 1.0), ("y", -2.0, 2.0)], 2_000);
        SteadyMotions::of_cases(&model(&text), &ranges, || true).unwrap_or_else(|why| panic!("{why:?}"))
    };
    // atan(0.3) = 0.29146
    for (angle, rests) in [(0.2_f64, true), (0.29, true), (0.3, false)] {
        let found = slope(angle);
        assert!(found.iter().all(|(_, own)| own.is_complete()), "{found:?}");
        let all: Vec<&(Vec<Case>, SteadyMotions)> =
            found.iter().filter(|(_, own)| !own.families.is_empty() || !own.motions.is_empty()).collect();
        assert_eq!(all.len(), usize::from(rests), "{angle} {all:?}");
        if let [(cases, own)] = &all[..] {
            assert_eq!((cases.as_slice(), own.families.len()), (&[Case::Between][..], 1));
            let share =
                own.unknowns.iter().position(|unknown| unknown.name.contains("mu")).expect("friction is sought");
            let [low, high] = own.families[0].0.hull[share];
            assert!(((0.5 * (low + high)).abs() - angle.tan() / 0.3).abs() < 1e-6, "{low} {high}");
        }
    }
}

/// A block that is pulled over a floor against a viscous drag: c v = F - mu m g where that is positive, else it rests.
#[test]
fn a_pulled_block_slides_at_the_speed_at_which_drag_takes_the_rest_of_the_pull() {
    for (pull, speed) in [(10.0, Some((10.0 - 0.3 * 2.0 * 9.81) / 2.0)), (5.0, None)] {
        let text = format!(
            "title = \"Pulled\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"2 kg\"\nf = \"0.3\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nblock = {{ centre = \"P\", mass = \"m\" }}\n\
             [[force]]\non = \"block\"\nis = \"(({pull:?} N) - (2 N s/m)*x')*N.x\"\n\
             [[contact]]\nname = \"floor\"\nof = \"block at P\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"f\"\ntouching = true\n\
             [run]\nspan = \"1 s\"\n"
        );
        let ranges = asked(&[("x'", -9.0, 10.0), ("y", -2.0, 2.0)], 2_000);
        let found = SteadyMotions::of_cases(&model(&text), &ranges, || true).unwrap_or_else(|why| panic!("{why:?}"));
        assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
        let speeds: Vec<f64> = found.iter().flat_map(|(_, own)| own.motions.iter().map(|one| one.state[2])).collect();
        let [found] = speeds[..] else { panic!("{speeds:?}") };
        assert!((found - speed.unwrap_or(0.0)).abs() < 1e-9, "{found}");
    }
}
