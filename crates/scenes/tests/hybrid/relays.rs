//! Relays as two events of one expression, each of which reverses the effect of the other.

use super::{METHODS, close, runs};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene};

/// A mass under the force -s, with s set to the sign of an expression when that passes zero; `order` is the order of the events in the file.
fn relay(when: &str, order: [&str; 2], start: [&str; 3]) -> String {
    let event = |direction: &str| {
        let sign = if direction == "up" { "1" } else { "-1" };
        format!("[[event]]\nwhen = \"{when}\"\ndirection = \"{direction}\"\nset = {{ s = \"{sign}\" }}\n")
    };
    let [x, speed, s] = start;
    format!(
        "title = \"Relay\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ns = \"1\"\n[bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
         [[constraint]]\nzero = \"s'\"\n[[force]]\non = \"a\"\nis = \"-s*(1 N)*N.x\"\n{}{}[start]\nx = \"{x} m\"\n\"x'\" = \"{speed} m/s\"\n\
         s = \"{s}\"\n[run]\nspan = \"3 s\"\n",
        event(order[0]),
        event(order[1])
    )
}

/// The speed is zero after 0.3 s, where each event reverses the force, so that infinitely many events follow in a finite time.
#[test]
fn events_that_set_back_each_other_at_once_are_told_from_either_side_and_in_either_order() {
    for (speed, s) in [("-0.3", "-1"), ("0.3", "1")] {
        for order in [["up", "down"], ["down", "up"]] {
            for method in METHODS {
                let found = runs(&relay("x'", order, ["0", speed, s]), method);
                let stopped = found.stopped();
                assert!(
                    stopped.as_ref().is_some_and(|why| why.contains("in a finite time")),
                    "{speed} {order:?} {stopped:?}"
                );
                close(found.outcome.time, 0.3, 1e-9);
            }
        }
    }
}

/// x'' = -s with s = sign(x): the motion consists of parabolas, and each event occurs once for each passage.
#[test]
fn a_relay_that_passes_through_zero_has_each_event_once() {
    for order in [["up", "down"], ["down", "up"]] {
        for method in METHODS {
            let found = runs(&relay("x", order, ["0.125", "0", "1"]), method);
            assert_eq!(found.stopped(), None, "{method:?}");
            let times: Vec<f64> = found.passages.iter().skip(1).map(|passage| passage.time).collect();
            assert_eq!(times.len(), 3, "{order:?} {:?}", found.passages);
            times.iter().zip([0.5, 1.5, 2.5]).for_each(|(time, known)| close(*time, known, 1e-9));
            close(found.last[found.column("x").unwrap()], -0.125, 1e-9);
        }
    }
}

/// The signal cos(200 x) along x = t: the first step of extrapolation would span a whole period, with equal values at both ends.
#[test]
fn a_guard_that_swings_within_the_first_step_is_seen() {
    let text = "title = \"Marks\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\nc = \"1\"\n[bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
        [[constraint]]\nzero = \"c'\"\n[[event]]\nwhen = \"cos((200 1/m)*x)\"\nset = { c = \"c + 1\" }\n[start]\n\"x'\" = \"1 m/s\"\n\
        [run]\nspan = \"10 s\"\n";
    let scene = ModelScene::parse("marks.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method: Method::GraggBulirschStoer, tolerance: 1e-8, ..scene.run().choice() };
    let found = scene.problem(choice.axes).simulate(&choice, |_| {});
    close(found.last[found.column("c").unwrap()], 637.0, 0.0);
}
