//! Two generated programs of one top must give one motion: with a free frame (quaternion) and with three angles.

use crate::systems::{free_top, turned_top};
use crate::{Case, answers, code, folder, output};
use dalembert_model::{Model, Source};
use std::fs;
use std::process::Command;
use symbolic::Language;

/// Both programs take the same Runge-Kutta steps; the final orientations must coincide.
#[test]
fn the_code_of_a_free_top_moves_it_as_that_of_three_turns() {
    if !answers("python3", &["-c", "import numpy"]) {
        return;
    }
    let case = |name, source: Source| {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
        let (coordinates, speeds, expected, rates) = Default::default();
        code(&Case { name, model, time: 0.0, coordinates, speeds, expected, rates }, Language::Python)
    };
    for (name, source) in [("free", free_top()), ("turned", turned_top())] {
        fs::write(folder("python").join(format!("top_{name}.py")), case(name, source)).expect("the code is written");
    }
    let text = "import numpy as np\nimport top_free as free_top, top_turned as turned_top\nfrom numpy import cos, sin\n\
        def ends(rates, y):\n    h, t = 0.0005, 0.0\n    for _ in range(1000):\n        k1 = rates(t, y)\n        \
        k2 = rates(t + h/2, y + h/2*k1)\n        k3 = rates(t + h/2, y + h/2*k2)\n        k4 = rates(t + h, y + h*k3)\n        \
        y, t = y + h/6*(k1 + 2*k2 + 2*k3 + k4), t + h\n    return y\n\
        about = lambda a, i: np.array([cos(a/2)] + [sin(a/2) if k == i else 0.0 for k in range(3)])\n\
        def times(p, q):\n    return np.concatenate([[p[0]*q[0] - p[1:] @ q[1:]], p[0]*q[1:] + q[0]*p[1:] + np.cross(p[1:], q[1:])])\n\
        yaw, tilt, spin = 0.2, 0.7, 0.3\ndyaw, dtilt, dspin = 0.4, 0.5, 30.0\n\
        q = times(times(about(yaw, 2), about(tilt, 0)), about(spin, 2))\n\
        w = [dyaw*sin(tilt)*sin(spin) + dtilt*cos(spin), dyaw*sin(tilt)*cos(spin) - dtilt*sin(spin), dyaw*cos(tilt) + dspin]\n\
        free = ends(free_top.rates, np.concatenate([q, w]))\n\
        turned = ends(turned_top.rates, np.array([yaw, tilt, spin, dyaw, dtilt, dspin]))\n\
        one = times(times(about(turned[0], 2), about(turned[1], 0)), about(turned[2], 2))\n\
        other = free[:4]/np.linalg.norm(free[:4])\nprint(repr(float(1 - abs(one @ other))))\n";
    let source = folder("python").join("both_tops.py");
    fs::write(&source, text).expect("the code is written");
    let apart: f64 = output(Command::new("python3").arg(&source)).trim().parse().expect("a number");
    // 1 - |p . q| of two unit quaternions is a^2/8 for a small angle a between the orientations
    assert!(apart.abs() < 1e-10, "{apart}");
}
