//! Bodies on several feet in space: rest, beginning of sliding, turning, and stopping.

use super::{close, events, last, runs};
use integrators::Method;

const THREE: [[f64; 2]; 3] = [[0.2, 0.0], [-0.1, 0.17], [-0.1, -0.17]];
const FOUR: [[f64; 2]; 4] = [[0.2, 0.2], [-0.2, 0.2], [0.2, -0.2], [-0.2, -0.2]];

/// The largest friction of all feet together, 0.1 of the weight, in N.
const MOST: f64 = 0.1 * 4.0 * 9.81;

/// A stool of 4 kg on feet 0.4 m below its centre, with a load and a start; its point `S` is on the floor.
fn stool(feet: &[[f64; 2]], load: &str, start: &str) -> String {
    let points: String = (1..)
        .zip(feet)
        .map(|(foot, [x, y])| format!("A{foot} = \"G + ({x} m)*B.x + ({y} m)*B.y - (0.4 m)*B.z\"\n"))
        .collect();
    let contacts: String = (1..=feet.len())
        .map(|foot| {
            format!(
                "[[contact]]\nname = \"A{foot}\"\nof = \"stool at A{foot}\"\nthrough = \"O\"\nnormal = \"N.z\"\n\
                 friction = \"0.1\"\ntouching = true\n"
            )
        })
        .collect();
    let reactions: String = (1..=feet.len()).map(|foot| format!("N{foot} = \"reaction(A{foot})\"\n")).collect();
    format!(
        "title = \"stool\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n\
         [frames]\nB = \"N free\"\n[points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\n\
         S = \"G + (0.3 m)*B.x - (0.1 m)*B.y - (0.4 m)*B.z\"\n{points}\
         [bodies.stool]\nframe = \"B\"\ncentre = \"G\"\nmass = \"(4 kg)\"\n\
         inertia = {{ principal = [\"(0.1 kg m^2)\", \"(0.1 kg m^2)\", \"(0.08 kg m^2)\"] }}\n{contacts}{load}\
         [outputs]\n{reactions}[start]\nz = \"0.4 m\"\n{start}\n[run]\nspan = \"2 s\"\n"
    )
}

/// A force at a point of the stool.
fn force(at: &str, is: &str) -> String {
    format!("[[force]]\non = \"stool at {at}\"\nis = \"{is}\"\n")
}

/// Without spin every foot slides the distance v^2/(2 mu g), and all stop together.
#[test]
fn a_stool_slides_on_three_feet_and_stands() {
    let trajectory = runs(&stool(&THREE, "", "\"x'\" = \"0.8 m/s\""), Method::DormandPrince8, 1e-9);
    assert_eq!(trajectory.stopped(), None);
    close(last(&trajectory, "x"), 0.64 / (2.0 * 0.1 * 9.81), 1e-9);
    close(events(&trajectory)[0], 0.8 / 0.981, 1e-9);
    close(last(&trajectory, "x'"), 0.0, 1e-12);
}

/// A stool with spin finally turns about one foot, and stops.
#[test]
fn a_stool_that_spins_comes_to_rest_foot_by_foot() {
    let trajectory = runs(&stool(&THREE, "", "\"B.wz\" = \"1 rad/s\""), Method::DormandPrince8, 1e-9);
    assert_eq!(trajectory.stopped(), None);
    let stops: Vec<&str> = trajectory.passages.iter().filter_map(|one| one.then.as_deref()).collect();
    assert_eq!(stops.last(), Some(&"contact `A1` sticks, contact `A2` sticks, contact `A3` sticks"));
    assert!(stops[1].matches("sticks").count() == 1, "{stops:?}");
    close(last(&trajectory, "B.wz"), 0.0, 1e-12);
}

/// Sliding and turning end at one instant, with every method and tolerance; then the stool is at rest.
#[test]
fn a_stool_that_slides_and_spins_comes_to_rest_on_all_feet() {
    let tripod = [[0.3, 0.0], [-0.2, 0.25], [-0.15, -0.3]];
    for start in [
        "\"x'\" = \"1 m/s\"\n\"y'\" = \"0.3 m/s\"\n\"B.wz\" = \"4 rad/s\"",
        "\"x'\" = \"-0.9 m/s\"\n\"B.wz\" = \"-1 rad/s\"",
    ] {
        let text = stool(&tripod, "", start);
        let ends = |method: Method, tolerance: f64| {
            let trajectory = runs(&text, method, tolerance);
            assert_eq!(trajectory.stopped(), None, "{method:?} {tolerance}");
            let then = trajectory.passages.last().and_then(|one| one.then.clone()).unwrap_or_default();
            assert_eq!(then.matches("sticks").count(), 3, "{method:?} {tolerance}: {then}");
            ["z", "B.wz", "x'", "x", "y"].map(|name| last(&trajectory, name))
        };
        let known = ends(Method::DormandPrince8, 1e-12);
        for method in [Method::DormandPrince8, Method::Radau5, Method::Rodas4] {
            for tolerance in [1e-6, 1e-8, 1e-9, 1e-10] {
                let [z, turning, speed, x, y] = ends(method, tolerance);
                close(z, 0.4, 1e-9);
                close(turning.abs() + speed.abs(), 0.0, 1e-9);
                close(x, known[3], 1e3 * tolerance);
                close(y, known[4], 1e3 * tolerance);
            }
        }
    }
}

/// Pushed into a corner of smooth walls, by less and by more than the friction of a foot: the walls prevent motion.
#[test]
fn walls_hold_what_is_pushed_into_their_corner() {
    let wall = |name: &str, normal: &str, friction: &str| {
        format!(
            "[[contact]]\nname = \"{name}\"\nof = \"stool at G\"\nthrough = \"O\"\nnormal = \"{normal}\"\n{friction}touching = true\n"
        )
    };
    for friction in ["", "friction = \"0.2\"\n"] {
        for push in [1.0, 8.0] {
            let walls = wall("X", "-N.x", friction) + &wall("Y", "-N.y", friction);
            let push = force("G", &format!("({push} N)*N.x + (9 N)*N.y"));
            let trajectory = runs(&stool(&THREE, &(walls + &push), ""), Method::Radau5, 1e-9);
            assert_eq!(trajectory.stopped(), None, "{friction} {push}");
            close(last(&trajectory, "x"), 0.0, 1e-12);
            close(last(&trajectory, "B.wz"), 0.0, 1e-12);
        }
    }
}

#[test]
fn a_stool_that_is_pushed_at_its_centre_slides_along_the_push() {
    for feet in [&THREE[..], &FOUR] {
        let trajectory =
            runs(&stool(feet, &force("G", "(10 N)*(0.6*N.x + 0.8*N.y)"), ""), Method::DormandPrince8, 1e-9);
        assert_eq!(trajectory.stopped(), None);
        let way = 0.5 * (10.0 - MOST) / 4.0 * 4.0;
        for (name, known) in [("x", 0.6 * way), ("y", 0.8 * way), ("z", 0.4), ("B.wz", 0.0)] {
            close(last(&trajectory, name), known, 1e-9);
        }
    }
}

/// Friction holds the feet until the force equals the largest friction of all feet together, for any distribution of the weight.
#[test]
fn feet_under_a_growing_push_begin_to_slide_together() {
    for feet in [&THREE[..], &FOUR] {
        let trajectory = runs(&stool(feet, &force("G", "(5 N/s)*t*N.y"), ""), Method::Radau5, 1e-11);
        assert_eq!(trajectory.stopped(), None);
        let begins = MOST / 5.0;
        close(events(&trajectory)[0], begins, 1e-11);
        close(last(&trajectory, "y"), 5.0 / 4.0 * (2.0_f64 - begins).powi(3) / 6.0, 1e-8);
        close(last(&trajectory, "x"), 0.0, 1e-8);
    }
}

/// The weight is carried by two opposite feet, each with one half at a distance of 0.2 sqrt(2) m from the axis.
#[test]
fn a_stool_turns_on_four_feet_under_a_torque_beyond_that_of_their_friction() {
    let torque = "[[torque]]\non = \"stool\"\nis = \"(2 N m)*N.z\"\n";
    let trajectory = runs(&stool(&FOUR, torque, ""), Method::DormandPrince8, 1e-9);
    assert_eq!(trajectory.stopped(), None);
    close(last(&trajectory, "B.wz"), (2.0 - MOST * 0.2 * 2.0_f64.sqrt()) / 0.08 * 2.0, 1e-8);
}

/// Newton's law for the plane motion of the stool, with the friction mu N of each foot opposite to its own acceleration.
#[test]
fn a_push_beside_the_centre_gives_every_foot_friction_against_its_own_slip() {
    let short = 1e-5;
    let text = stool(&THREE, &force("S", "(6 N)*N.y"), "").replace("span = \"2 s\"", &format!("span = \"{short} s\""));
    let trajectory = runs(&text, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    let [ax, ay, turning] = ["x'", "y'", "B.wz"].map(|name| last(&trajectory, name) / short);
    let (mut sum, mut weight) = ([0.0, 6.0, 6.0 * 0.3], 0.0);
    for (foot, [x, y]) in (1..).zip(THREE) {
        let pressure = last(&trajectory, &format!("N{foot}"));
        let (along, aside) = (ax - turning * y, ay + turning * x);
        let [fx, fy] = [along, aside].map(|part| -0.1 * pressure * part / along.hypot(aside));
        sum = [sum[0] + fx, sum[1] + fy, sum[2] + x * fy - y * fx];
        weight += pressure;
    }
    for (sum, known) in sum.into_iter().chain([weight]).zip([4.0 * ax, 4.0 * ay, 0.08 * turning, 4.0 * 9.81]) {
        assert!((sum - known).abs() < 1e-4 * known.abs().max(1.0), "{sum} {known}");
    }
}

/// The force is still below the limit for the rigid body, but one foot is at its limit for the assumed distribution of the load.
#[test]
fn a_foot_that_others_might_relieve_is_refused() {
    let trajectory = runs(&stool(&THREE, &force("S", "(5 N/s)*t*N.y"), ""), Method::Radau5, 1e-11);
    let said = trajectory.stopped().unwrap_or_default().to_string();
    assert!(said.contains("several contacts in space are at rest"), "{said}");
}

/// The stool does not slide on a slope whose tangent is below the coefficient of friction, for any distribution of the weight.
#[test]
fn a_stool_holds_on_a_slope_up_to_its_friction() {
    let slope = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let weight = format!("gravity = \"(9.81 m/s^2)*({sin}*N.x - {cos}*N.z)\"");
        stool(&THREE, "", "").replace("gravity = \"-(9.81 m/s^2)*N.z\"", &weight)
    };
    for angle in [0.02, 0.06, 0.09] {
        let trajectory = runs(&slope(angle), Method::DormandPrince8, 1e-9);
        assert_eq!(trajectory.stopped(), None, "{angle}");
        close(last(&trajectory, "x'"), 0.0, 1e-12);
    }
    let trajectory = runs(&slope(0.105), Method::DormandPrince8, 1e-9);
    assert_eq!(trajectory.stopped(), None);
    let (sin, cos) = 0.105_f64.sin_cos();
    close(last(&trajectory, "x'"), 2.0 * 9.81 * (sin - 0.1 * cos), 1e-9);
}
