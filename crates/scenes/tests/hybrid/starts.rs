//! Events whose expression is zero at the start: an event occurs only when its expression passes zero again.

use super::{METHODS, close, runs};

/// A body on the y axis with a force of time, an event at y = 0, and a start.
fn moved(force: &str, direction: &str, start: &str) -> String {
    let direction = if direction.is_empty() { String::new() } else { format!("direction = \"{direction}\"\n") };
    format!(
        "title = \"A body that starts where its event is\"\n[coordinates]\ny = \"m\"\n\
         [bodies.one]\ncentre = \"O + y*N.y\"\nmass = \"(1 kg)\"\n[[force]]\nalong = \"y\"\nis = \"{force}\"\n\
         [[event]]\nwhen = \"y\"\n{direction}end = true\n[start]\n{start}\n[run]\nspan = \"5 s\"\n"
    )
}

/// For each direction of the event, the time at which it ends the run; `None` if the run reaches its span.
fn ends(force: &str, start: &str, known: [(&str, Option<f64>); 3]) {
    for (direction, time) in known {
        for method in METHODS {
            let run = runs(&moved(force, direction, start), method);
            assert_eq!(run.stopped(), None, "{force} {direction} {method:?}");
            close(run.outcome.time, time.unwrap_or(5.0), 1e-9);
        }
    }
}

#[test]
fn a_body_that_leaves_the_place_of_its_event_for_good_runs_on() {
    for force in ["-(9.81 N)", "(9.81 N)", "-(1 N/s)*t", "(1 N/s^2)*t^2", "-(1 N/s^3)*t^3"] {
        ends(force, "y = \"0 m\"", [("", None), ("up", None), ("down", None)]);
    }
    for speed in ["5 m/s", "-5 m/s"] {
        ends("0", &format!("\"y'\" = \"{speed}\""), [("", None), ("up", None), ("down", None)]);
    }
}

#[test]
fn a_body_that_comes_back_ends_its_run_in_the_direction_in_which_it_passes() {
    // y = t^2/2 - t^3/6
    ends("(1 N) - (1 N/s)*t", "y = \"0 m\"", [("", Some(3.0)), ("up", None), ("down", Some(3.0))]);
    ends("(1 N/s)*t - (1 N)", "y = \"0 m\"", [("", Some(3.0)), ("up", Some(3.0)), ("down", None)]);
    // y = t^3/6 - t^4/24, with no acceleration at the start
    ends("(1 N/s)*t - (1 N/s^2)*t^2/2", "y = \"0 m\"", [("", Some(4.0)), ("up", None), ("down", Some(4.0))]);
    // y = 2 t - t^2
    ends("-(2 N)", "\"y'\" = \"2 m/s\"", [("", Some(2.0)), ("up", None), ("down", Some(2.0))]);
}

/// A pendulum that starts at one of its turning points ends at the turning point of the given direction.
#[test]
fn a_pendulum_from_rest_ends_at_the_turning_point_that_is_asked_for() {
    let pendulum = |direction: &str| {
        format!(
            "title = \"From rest\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\n\
             [frames]\nA = \"N turned a about z\"\n[bodies.bob]\ncentre = \"O - (1 m)*A.y\"\nmass = \"(1 kg)\"\n\
             [[event]]\nwhen = \"a'\"\ndirection = \"{direction}\"\nend = true\n\
             [start]\na = \"20 deg\"\n[run]\nspan = \"10 s\"\n"
        )
    };
    for method in METHODS {
        let half = runs(&pendulum("up"), method);
        close(half.last[0], -20f64.to_radians(), 1e-9);
        let whole = runs(&pendulum("down"), method);
        close(whole.last[0], 20f64.to_radians(), 1e-9);
        close(whole.outcome.time, 2.0 * half.outcome.time, 1e-9);
    }
}

/// A wheel with constant speed has no acceleration that limits the step; the event is found in the first turn.
#[test]
fn an_event_that_bends_more_than_the_motion_is_not_stepped_over() {
    let wheel = "title = \"A wheel\"\n[coordinates]\na = \"rad\"\n[bodies.wheel]\nturns = \"a\"\ncentre = \"O\"\n\
                 mass = \"(1 kg)\"\ninertia = \"(1 kg m^2)\"\n[[event]]\nwhen = \"cos(a)\"\nend = true\n\
                 [start]\n\"a'\" = \"1 rad/s\"\n[run]\nspan = \"100 s\"\n";
    for method in METHODS {
        let run = runs(wheel, method);
        close(run.outcome.time, std::f64::consts::FRAC_PI_2, 1e-9);
    }
}

/// At x = 0 there is no force; an average of both cases would accelerate the body.
#[test]
fn a_body_that_rests_where_a_force_ends_stays_there() {
    for law in ["if(x >= (0 m), (0 N), (3 N))", "if(x < (0 m), (3 N), (0 N))", "if(x >= (0 m), (-1 N), (0 N))"] {
        let text = format!(
            "title = \"a force that ends at x = 0\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n\
             [bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[[force]]\non = \"b\"\nis = \"{law}*N.x\"\n[run]\nspan = \"1 s\"\n"
        );
        for method in METHODS {
            let trajectory = runs(&text, method);
            assert_eq!(trajectory.stopped(), None, "{law}, {method:?}");
            assert_eq!(&trajectory.last[..2], [0.0, 0.0], "{law}, {method:?}");
        }
    }
}
