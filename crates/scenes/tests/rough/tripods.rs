//! Boxes on three feet, with sliding that ends or loads that grow; these starts failed in earlier versions.

use super::{events, last, runs};
use integrators::Method;

/// A tripod of 2 kg: principal moments of inertia, height of its centre, positions and coefficients of friction of its feet.
struct Tripod {
    moments: [f64; 3],
    height: f64,
    feet: [([f64; 2], f64); 3],
    gravity: &'static str,
    /// Further tables: a load, a start, a run.
    rest: &'static str,
}

impl Tripod {
    fn text(&self) -> String {
        let Tripod { moments: [a, b, c], height, feet, gravity, rest } = self;
        let points: String = (0..)
            .zip(feet)
            .map(|(foot, ([x, y], _))| format!("P{foot} = \"G + ({x} m)*B.x + ({y} m)*B.y - ({height} m)*B.z\"\n"))
            .collect();
        let contacts: String = (0..)
            .zip(feet)
            .map(|(foot, (_, friction))| {
                format!(
                    "[[contact]]\nname = \"f{foot}\"\nof = \"box at P{foot}\"\nthrough = \"O\"\nnormal = \"N.z\"\n\
                     friction = \"{friction}\"\ntouching = true\n"
                )
            })
            .collect();
        let outputs: String = (0..3)
            .map(|foot| format!("N{foot} = \"reaction(f{foot})\"\nT{foot} = \"norm(friction(f{foot}))\"\n"))
            .collect();
        format!(
            "title = \"tripod\"\ngravity = \"{gravity}\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n\
             [frames]\nB = \"N free\"\n[points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\n{points}\
             Q = \"G - (0.139 m)*B.x + (0.142 m)*B.y - (0.091 m)*B.z\"\n\
             [bodies.box]\nframe = \"B\"\ncentre = \"G\"\nmass = \"(2 kg)\"\n\
             inertia = {{ principal = [\"({a} kg m^2)\", \"({b} kg m^2)\", \"({c} kg m^2)\"] }}\n{contacts}\
             [outputs]\n{outputs}{rest}"
        )
    }
}

/// The distribution of friction at rest is not unique; the one that is shown must be within its limits throughout the run.
#[test]
fn no_foot_holds_more_than_its_friction_while_a_load_grows() {
    let tripod = Tripod {
        moments: [0.05, 0.06, 0.08],
        height: 0.17,
        feet: [([0.418, 0.364], 0.66), ([-0.158, 0.39], 0.24), ([-0.077, -0.363], 0.65)],
        gravity: "-(9.81 m/s^2)*N.z",
        rest: "[[force]]\non = \"box at Q\"\n\
               is = \"t*((-10.568 N/s)*N.x + (0.711 N/s)*N.y + (0.138 N/s)*N.z)\"\n\
               [start]\nz = \"0.17 m\"\n[run]\nspan = \"1.2 s\"\n",
    };
    let trajectory = runs(&tripod.text(), Method::DormandPrince8, 1e-10);
    for (foot, (_, friction)) in tripod.feet.iter().enumerate() {
        let [pressure, held] = ["N", "T"].map(|name| last(&trajectory, &format!("{name}{foot}")));
        assert!(held <= friction * pressure * (1.0 + 1e-9), "foot {foot}: {held} N on {pressure} N");
    }
    let said = trajectory.stopped().unwrap_or_default().to_string();
    assert!(said.contains("several contacts in space are at rest"), "{said}");
}

/// A foot that begins to slide from rest, becomes fast and slows down: the stop is judged relative to its largest speed, not to that at the beginning.
#[test]
fn a_slide_that_began_from_rest_stops_in_few_steps() {
    let tripod = Tripod {
        moments: [0.02, 0.03, 0.04],
        height: 0.2,
        feet: [([0.027, -0.146], 0.3), ([0.035, 0.074], 0.3), ([-0.115, 0.071], 0.3)],
        gravity: "-(9.81 m/s^2)*N.z",
        rest: "[start]\nz = \"0.2 m\"\n\"x'\" = \"0.508 m/s\"\n\"y'\" = \"-0.292 m/s\"\n\"B.wz\" = \"-0.44 rad/s\"\n\
               [run]\nspan = \"0.6 s\"\n",
    };
    let trajectory = runs(&tripod.text(), Method::Rodas4, 1e-10);
    assert_eq!(trajectory.stopped(), None);
    assert!(trajectory.outcome.work.rates < 50_000, "{:?}", trajectory.outcome.work);
    assert!((events(&trajectory)[4] - 0.529491020).abs() < 1e-8);
}

/// Two feet slide around a third one at rest and stop, whether a step ends shortly before this instant, at it, or behind it.
#[test]
fn a_turn_about_one_foot_ends_by_every_method() {
    let tripod = Tripod {
        moments: [0.05, 0.06, 0.08],
        height: 0.087,
        feet: [([0.141, -0.37], 0.41), ([-0.278, 0.447], 0.39), ([-0.078, 0.304], 0.5)],
        gravity: "(9.81 m/s^2)*(sin(-0.19)*N.x - cos(-0.19)*N.z)",
        rest: "[start]\nz = \"0.087 m\"\n\"x'\" = \"0.537 m/s\"\n\"y'\" = \"1.337 m/s\"\n\"B.wz\" = \"-5.232 rad/s\"\n\
               [run]\nspan = \"0.5 s\"\n",
    };
    for method in [Method::Radau5, Method::Rodas4, Method::DormandPrince8] {
        for tolerance in [1e-7, 1e-8] {
            let trajectory = runs(&tripod.text(), method, tolerance);
            assert_eq!(trajectory.stopped(), None, "{method:?} {tolerance}");
            let stops = events(&trajectory);
            assert_eq!(stops.len(), 2, "{method:?} {tolerance}");
            assert!((stops[1] - 0.414983197).abs() < 1e-6, "{method:?} {tolerance} {stops:?}");
        }
    }
}
