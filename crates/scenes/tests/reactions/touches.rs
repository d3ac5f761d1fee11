//! Conditions on reactions whose value touches zero.

use super::{close, last, runs_by};
use integrators::Method;

/// A force k r^2, with the reaction r, pulls a bead down a straight wire y = a x. max(r^2, r^2 cos^2 b x) is always r^2: the difference touches
/// zero where b x is a multiple of pi, and the acceleration is constant.
#[test]
fn a_condition_that_touches_zero_leaves_the_law_as_it_is() {
    let text = "title = \"bead\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.3 kg\"\na = \"0.5\"\nk = \"0.2 1/N\"\nb = \"20 1/m\"\n\
         g = \"9.81 m/s^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
         [definitions]\nr = \"reaction(wire)\"\n[bodies]\nbead = { centre = \"P\", mass = \"m\" }\n\
         [[constraint]]\nname = \"wire\"\nzero = \"y - a*x\"\n[[force]]\non = \"bead\"\n\
         is = \"-k*max(r^2, r^2*cos(b*x)^2)*N.x\"\n\
         [start]\nx = \"0.1 m\"\n\"wire.impulse'\" = \"guess 2 N\"\n[run]\nspan = \"0.5 s\"\n";
    let (m, a, k, g) = (0.3_f64, 0.5_f64, 0.2_f64, 9.81_f64);
    // m x'' = -k r^2 - a r and m y'' = r - m g with y'' = a x''
    let sum = 1.0 + a * a;
    let reaction = ((sum * sum + 4.0 * a * k * m * g).sqrt() - sum) / (2.0 * a * k);
    let acceleration = -(k * reaction * reaction + a * reaction) / m;
    let exact = 0.1 + acceleration * 0.125;
    assert!((20.0 * exact).abs() > 3.0 * std::f64::consts::PI, "it passes some zeros");
    for method in [Method::DormandPrince8, Method::Taylor, Method::RadauIIA { stages: 5 }] {
        let trajectory = runs_by(text, method);
        close(last(&trajectory, "x"), exact, 1e-10);
        let told: Vec<&str> = trajectory.passages.iter().map(|passage| &*passage.what).collect();
        assert_eq!(told, ["start"], "{method}");
    }
}
