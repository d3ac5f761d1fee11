//! Events in runs with projection onto the constraints.

use super::parsed;
use integrators::Method;
use simulation::{Axes, Choice, IvpScene};

/// A pendulum that hits a wall at its lowest position; at every event the bob must be on the circle.
const PENDULUM_AT_A_WALL: &str = "title = \"t\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
     [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nbob = { centre = \"P\", mass = \"(1 kg)\" }\n\
     [[constraint]]\nzero = \"x^2 + y^2 - (1 m)^2\"\n\
     [[event]]\nname = \"lowest\"\nwhen = \"x\"\nset = { \"x'\" = \"-0.9*x'\" }\n\
     [start]\nx = \"-1 m\"\ny = \"guess 0 m\"\n\"x'\" = \"0 m/s\"\n[run]\nspan = \"3 s\"\n";

#[test]
fn events_lie_on_the_constraints() {
    let scene = parsed(PENDULUM_AT_A_WALL);
    let problem = scene.problem(Axes::First);
    for method in [Method::Taylor, Method::DormandPrince8, Method::RadauIIA { stages: 3 }] {
        let choice = Choice { method, tolerance: 1e-6, ..scene.run().choice() };
        let run = problem.simulate(&choice, |_| {});
        assert_eq!(run.stopped(), None, "{method}");
        assert!(run.passages.len() > 2, "{method}: {}", run.passages.len());
        let off = |row: &[f64]| (row[0] * row[0] + row[1] * row[1] - 1.0).abs();
        let events = run.passages.iter().map(|passage| &passage.row);
        let largest = events.chain(&run.rows).map(|row| off(row)).fold(0.0, f64::max);
        assert!(largest < 1e-14, "{method}: {largest:e}");
    }
}
