//! Impacts that alternate between contacts: a block that rocks from edge to edge, and a toy of millimetres.

use super::{METHODS, close, events, last, runs};

/// A block with the half width 0.2 m and the half height 0.8 m, tilted on its left lower edge.
fn block(impact: &str) -> String {
    let edge = |name: &str, of: &str, rest: &str| {
        format!(
            "[[contact]]\nname = \"{name}\"\nof = \"block at {of}\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"0.7\"\n\
             impact = \"{impact}\"\n{rest}"
        )
    };
    format!(
        "title = \"block\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"100 kg\"\nb = \"0.2 m\"\nh = \"0.8 m\"\nJ = \"22.5 kg m^2\"\n\
         g = \"9.81 m/s^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n[frames]\nA = \"N turned a about z\"\n\
         [points]\nG = \"O + x*N.x + y*N.y\"\nL = \"G - b*A.x - h*A.y\"\nR = \"G + b*A.x - h*A.y\"\n\
         [bodies.block]\nframe = \"A\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"J\"\n{}{}[start]\na = \"0.15 rad\"\n\
         [run]\nspan = \"10 s\"\n",
        edge("left", "L", "touching = true\n"),
        edge("right", "R", "")
    )
}

/// The angular momentum about the new edge is kept (Housner 1963): the angular velocity becomes (J + m (h^2 - b^2))/(J + m (h^2 + b^2)) of what it was.
/// Infinitely many impacts happen in a finite time, and the block stands.
#[test]
fn a_rocking_block_comes_to_rest() {
    let kept = (22.5 + 100.0 * (0.64 - 0.04)) / (22.5 + 100.0 * (0.64 + 0.04));
    for impact in ["newton", "moreau"] {
        let trajectory = runs(&block(impact), METHODS[0], 1e-10);
        assert_eq!(trajectory.stopped(), None, "{impact}");
        for (name, known) in [("y", 0.8), ("a", 0.0), ("x'", 0.0), ("y'", 0.0), ("a'", 0.0)] {
            close(last(&trajectory, name), known, 1e-12);
        }
        let speeds: Vec<f64> = trajectory.passages.iter().map(|passage| passage.row[5].abs()).collect();
        let times = events(&trajectory);
        close(speeds[2] / speeds[1], kept, 1e-8);
        // near the end successive flights shrink by the same ratio
        let flights: Vec<f64> = times.windows(2).map(|two| two[1] - two[0]).collect();
        close(flights[60] / flights[59], kept, 1e-5);
        let rest = times[times.len() - 1];
        close(rest, times[60] + flights[60] / (1.0 - kept), 1e-4);
    }
}

/// A sleeve on a pole with millimetres of play carries a bird on a spring (Pfeiffer 1984): it slides down in steps of one period.
#[test]
fn a_woodpecker_toy_goes_down_in_equal_steps() {
    let text = "title = \"toy\"\ngravity = \"-g*N.y\"\n[parameters]\nmM = \"0.0003 kg\"\nJM = \"5e-9 kg m^2\"\nmS = \"0.0045 kg\"\n\
                JS = \"7e-7 kg m^2\"\nc = \"0.0056 N m\"\nlM = \"10 mm\"\nlG = \"15 mm\"\nlS = \"20.1 mm\"\nhM = \"5.8 mm\"\n\
                rM = \"3.1 mm\"\nr0 = \"2.5 mm\"\nhS = \"20 mm\"\ng = \"9.81 m/s^2\"\n[coordinates]\ny = \"m\"\np = \"rad\"\ns = \"rad\"\n\
                [frames]\nA = \"N turned p about z\"\nB = \"N turned s about z\"\n[points]\nS = \"O + y*N.y\"\nJ = \"S + lM*A.x\"\n\
                W = \"J + lG*B.x\"\nlow = \"S + rM*A.x - hM*A.y\"\nhigh = \"S + rM*A.x + hM*A.y\"\nbeak = \"W - lS*B.x + hS*B.y\"\n\
                [bodies.sleeve]\nframe = \"A\"\ncentre = \"S\"\nmass = \"mM\"\ninertia = \"JM\"\n\
                [bodies.bird]\nframe = \"B\"\ncentre = \"W\"\nmass = \"mS\"\ninertia = \"JS\"\n\
                [energies]\npotential = \"c/2*(p-s)^2\"\n";
    let contact = |name: &str, of: &str, rest: &str| {
        format!(
            "[[contact]]\nname = \"{name}\"\nof = \"{of}\"\nthrough = \"O + r0*N.x\"\nnormal = \"N.x\"\nfriction = \"0.3\"\nimpact = \"moreau\"\n{rest}"
        )
    };
    let text = format!(
        "{text}{}{}{}[start]\np = \"guess -0.1 rad\"\ns = \"-0.2788 rad\"\n\"y'\" = \"-0.3411 m/s\"\n\"s'\" = \"-7.4583 rad/s\"\n[run]\nspan = \"3 s\"\n",
        contact("lower", "sleeve at low", "touching = true\n"),
        contact("upper", "sleeve at high", ""),
        contact("beak", "bird at beak", "restitution = \"0.5\"\n")
    );
    let trajectory = runs(&text, METHODS[0], 1e-10);
    assert_eq!(trajectory.stopped(), None);
    let strikes: Vec<(f64, f64)> = trajectory
        .passages
        .iter()
        .filter(|passage| passage.what == "contact `beak` closes")
        .map(|passage| (passage.time, passage.row[0]))
        .collect();
    let [.., (t1, y1), (t2, y2), (t3, y3)] = strikes.as_slice() else { panic!("{strikes:?}") };
    close(t3 - t2, t2 - t1, 1e-6);
    close(y3 - y2, y2 - y1, 1e-6);
    assert!((t3 - t2 - 0.1307).abs() < 1e-3 && y3 < y2, "{strikes:?}");
}
