//! Motions with reactions in loads, compared with such motions in coordinates without constraints.

use super::{bead, close, last, runs, runs_by};
use integrators::Method;

/// Drag along the wire does not change its reaction N: N sqrt(1 + 4 a^2 x^2) = m (g + 2 a x'^2)/sqrt(1 + 4 a^2 x^2).
#[test]
fn a_drag_in_proportion_to_a_reaction_is_that_of_one_coordinate() {
    let text = bead("", "-c*reaction(wire)*velocity(P)", "[outputs]\npush = \"reaction(wire)\"");
    let alone = "title = \"bead\"\n[parameters]\nm = \"0.3 kg\"\na = \"2 1/m\"\nc = \"0.4 s/m\"\ng = \"9.81 m/s^2\"\n\
                 [coordinates]\nx = \"m\"\n[definitions]\nw = \"1 + 4*a^2*x^2\"\npush = \"m*(g + 2*a*x'^2)/w\"\n\
                 [energies]\nkinetic = \"m/2*w*x'^2\"\npotential = \"m*g*a*x^2\"\n\
                 [[force]]\nalong = \"x\"\nis = \"-c*push*w*x'\"\n[start]\nx = \"1 m\"\n[outputs]\nN_of_x = \"push\"\n[run]\nspan = \"2 s\"\n";
    let alone = runs(alone);
    for method in [Method::DormandPrince8, Method::Taylor, Method::GraggBulirschStoer] {
        let found = runs_by(&text, method);
        close(last(&found, "x"), last(&alone, "x"), 1e-10);
        close(last(&found, "x'"), last(&alone, "x'"), 1e-10);
        close(last(&found, "push"), last(&alone, "N_of_x"), 1e-9);
        close(last(&found, "wire.impulse'"), last(&alone, "N_of_x"), 1e-9);
    }
}

/// J theta'' = -m g l sin(theta) - s k |R|, with s the sign of theta': |R|^2 = R_n^2 + (A - s B |R|)^2 is a quadratic equation for |R|.
#[test]
fn a_bearing_that_rubs_in_proportion_to_its_force_swings_as_euler_s_equation_says() {
    let parameters = "m = \"1 kg\"\nl = \"0.5 m\"\nJ = \"0.02 kg m^2\"\nk = \"0.02 m\"\ng = \"9.81 m/s^2\"\n";
    let run = "[start]\ntheta = \"80 deg\"\n[run]\nspan = \"3 s\"\n";
    let with_pin = format!(
        "title = \"pendulum\"\ngravity = \"-g*N.y\"\n[parameters]\n{parameters}[coordinates]\nx = \"m\"\ny = \"m\"\ntheta = \"rad\"\n\
         [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nrod = {{ turns = \"theta\", centre = \"P\", mass = \"m\", inertia = \"J\" }}\n\
         [[constraint]]\nname = \"pin\"\nzero = \"P - O - l*(sin(theta)*N.x - cos(theta)*N.y)\"\n\
         [[torque]]\nbetween = [\"ground\", \"rod\"]\nis = \"-k*norm(reaction(pin))*sign(theta')*N.z\"\n{run}"
    );
    let alone = format!(
        "title = \"pendulum\"\n[parameters]\n{parameters}[coordinates]\ntheta = \"rad\"\n[definitions]\nI = \"J + m*l^2\"\n\
         A = \"m*g*sin(theta)*(1 - m*l^2/I)\"\nB = \"m*l*k/I\"\nalong = \"m*(l*theta'^2 + g*cos(theta))\"\ns = \"sign(theta')\"\n\
         R = \"(sqrt(A^2*B^2 + (1 - B^2)*(along^2 + A^2)) - s*A*B)/(1 - B^2)\"\n\
         [energies]\nkinetic = \"I/2*theta'^2\"\npotential = \"-m*g*l*cos(theta)\"\n\
         [[force]]\nalong = \"theta\"\nis = \"-k*R*s\"\n{run}"
    );
    let (with_pin, alone) = (runs(&with_pin), runs(&alone));
    close(last(&with_pin, "theta"), last(&alone, "theta"), 1e-9);
    close(last(&with_pin, "theta'"), last(&alone, "theta'"), 1e-8);
}

/// A mass on a rope released horizontally has the tension 3 m g cos(phi): twice the weight at cos(phi) = 2/3.
#[test]
fn a_rope_breaks_at_the_tension_of_its_closed_form() {
    let text = "title = \"rope\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
                [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nbob = { centre = \"P\", mass = \"m\" }\n\
                [[constraint]]\nname = \"rope\"\nzero = \"distance(O, P) - l\"\n\
                [[event]]\nname = \"breaks\"\nwhen = \"-reaction(rope) - 2*m*g\"\ndirection = \"up\"\nend = true\n\
                [start]\nx = \"1 m\"\ny = \"0 m\"\n[run]\nspan = \"5 s\"\n";
    let found = runs(text);
    close(last(&found, "y"), -2.0 / 3.0, 1e-10);
    close(last(&found, "rope.impulse'"), -2.0 * 2.0 * 9.81, 1e-9);
}

/// Powers with real exponents, of reactions in loads, too.
#[test]
fn a_power_of_a_reaction_has_any_exponent() {
    let by_powers = bead("", "-c*reaction(wire)^(1/3)*reaction(wire)^0.8*velocity(P)/(1 N)^(2/15)", "");
    let by_functions = by_powers
        .replace("reaction(wire)^(1/3)*reaction(wire)^0.8", "exp(ln(reaction(wire)/(1 N))*17/15)*(1 N)^(17/15)");
    let (by_powers, by_functions) = (runs(&by_powers), runs(&by_functions));
    close(last(&by_powers, "x"), last(&by_functions, "x"), 1e-12);
}
