//! Ensemble members with exponentials in their law.

use crate::{ensemble, rows};

/// Smooth friction F tanh(v/d) from a speed at which its slope is zero: sinh(v/d) decays as e^(-F t/(m d)), and v does not change its sign.
#[test]
fn a_member_does_not_step_over_an_exponential() {
    let text = "title = \"t\"\n[parameters]\nF = \"1 N\"\nd = \"0.01 m/s\"\n[coordinates]\nx = \"m\"\n\
        [bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n[[force]]\non = \"a\"\nis = \"-F*tanh(x'/d)*N.x\"\n\
        [start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"1.02 s\"\ntolerance = 1e-10\n\
        [ensemble]\nmembers = 3\n[ensemble.vary]\nparameters.F = { values = \"0.8 1 1.2 N\" }\n";
    for row in rows(&ensemble(text), 1) {
        let last = row.last.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        // asinh(sinh(100) e^-a), where sinh(100) is e^100/2
        let known = 0.01 * (0.5 * (100.0 - row.drawn[0] * 1.02 / 0.01).exp()).asinh();
        assert!((last.state[1] - known).abs() < 1e-7, "{:?}: {} for {known}", row.drawn, last.state[1]);
    }
}
