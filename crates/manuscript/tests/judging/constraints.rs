//! Claims on systems with constraints, reactions and free frames.

use crate::{on, verdict};

const CARTESIAN: &str = r#"
title = "A pendulum in Cartesian coordinates"
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
x = "m"
y = "m"
[points]
P = "O + x*N.x + y*N.y"
[bodies.bob]
centre = "P"
mass = "m"
[[constraint]]
name = "rod"
zero = "(x^2 + y^2 - l^2)/2"
[letters]
'm' = "m"
'l' = "l"
'g' = "g"
'x' = "x"
'y' = "y"
'\lambda' = "reaction(rod)"
"#;

#[test]
fn a_multiplier_has_its_value_along_every_motion() {
    let tension = r"\lambda = \frac{m}{l^2}\left(g y - \dot{x}^2 - \dot{y}^2\right)";
    let found = on(CARTESIAN, "formula", tension, "");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let wrong = r"\lambda = \frac{m}{l^2}\left(g y + \dot{x}^2 + \dot{y}^2\right)";
    assert_eq!(verdict(&on(CARTESIAN, "formula", wrong, "")), "refuted");
    assert_eq!(verdict(&on(CARTESIAN, "equation of motion", r"m \ddot{x} = \lambda x", "")), "proved");
    assert_eq!(verdict(&on(CARTESIAN, "equation of motion", r"x \ddot{y} - y \ddot{x} + g x = 0", "")), "proved");
}

#[test]
fn constraints_and_their_rates_are_identities() {
    for (formula, expected) in [
        (r"x^2 + y^2 = l^2", "proved"),
        (r"x \dot{x} + y \dot{y} = 0", "proved"),
        (r"x \dot{x} = y \dot{y}", "refuted"),
    ] {
        let found = on(CARTESIAN, "identity", formula, "");
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

const FREE: &str = r#"
title = "A free body"
[parameters]
m = "kg"
A = "kg m^2"
B = "kg m^2"
C = "kg m^2"
[coordinates]
x = "m"
[frames]
F = "N free"
[points]
P = "O + x*N.x"
[bodies.body]
frame = "F"
centre = "P"
mass = "m"
inertia = { axes = "F", principal = ["A", "B", "C"] }
[letters]
'A' = "A"
'B' = "B"
'C' = "C"
'p' = "F.wx"
'q' = "F.wy"
'r' = "F.wz"
'\gamma' = "F.x . N.z"
'\gamma_1' = "F.y . N.z"
'\gamma_2' = "F.z . N.z"
"#;

#[test]
fn a_free_body_obeys_euler() {
    for (kind, formula, expected) in [
        ("equation of motion", r"A \dot{p} + (C - B) q r = 0", "proved"),
        ("equation of motion", r"A \dot{p} + (B - C) q r = 0", "refuted"),
        ("integral of motion", r"A p^2 + B q^2 + C r^2", "proved"),
        ("integral of motion", r"A^2 p^2 + B^2 q^2 + C^2 r^2", "proved"),
        ("integral of motion", r"A p \gamma + B q \gamma_1 + C r \gamma_2", "proved"),
        ("identity", r"\gamma^2 + \gamma_1^2 + \gamma_2^2 = 1", "proved"),
        ("identity", r"\dot{\gamma} = r \gamma_1 - q \gamma_2", "proved"),
        ("identity", r"\dot{\gamma} = q \gamma_2 - r \gamma_1", "refuted"),
    ] {
        let found = on(FREE, kind, formula, "");
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

const SPHERICAL: &str = r#"
title = "A spherical pendulum"
gravity = "-g*N.z"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
phi = "rad"
theta = "rad"
[frames]
A = "N turned phi about z"
B = "A turned theta about y"
[points]
P = "O - l*B.z"
[bodies.bob]
centre = "P"
mass = "m"
[letters]
'm' = "m"
'l' = "l"
'g' = "g"
'\varphi' = "phi"
'\theta' = "theta"
"#;

#[test]
fn a_steady_motion_has_the_condition_of_its_equations() {
    let resting = r"resting = ['\theta', '\dot{\varphi}']";
    let found = on(SPHERICAL, "steady motion", r"\dot{\varphi}^2 l \cos\theta = g", resting);
    // the pendulum may also hang at rest
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let aside = format!("{resting}\n{}", r"given = ['\sin\theta \neq 0']");
    let found = on(SPHERICAL, "steady motion", r"\dot{\varphi}^2 l \cos\theta = g", &aside);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    assert!(found.judged.requires.iter().any(|(text, _)| text.contains("sin(theta)")), "{:?}", found.judged.requires);
    let found = on(SPHERICAL, "steady motion", r"\dot{\varphi}^2 l \sin\theta = g", resting);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

const HOOP: &str = r#"
title = "A bead on a hoop that turns about its vertical diameter"
gravity = "-g*N.z"
[parameters]
m = "kg"
r = "m"
g = "m/s^2"
Omega = "rad/s"
c = "N m s"
[coordinates]
theta = "rad"
[frames]
A = "N turned Omega*t about z"
B = "A turned theta about y"
[points]
P = "O - r*B.z"
[bodies.bead]
centre = "P"
mass = "m"
[[force]]
along = "theta"
is = "-c*theta'"
[letters]
'm' = "m"
'r' = "r"
'g' = "g"
'c' = "c"
'\Omega' = "Omega"
'\theta' = "theta"
"#;

#[test]
fn a_bead_leaves_the_bottom_of_a_hoop_at_its_critical_speed() {
    let bottom = "resting = ['\\theta']\ngiven = ['\\theta = 0', 'm > 0', 'r > 0', 'c > 0']";
    let found = on(HOOP, "stability", r"\Omega^2 r < g", bottom);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    assert!(found.judged.evidence.contains("asymptotically stable"), "{}", found.judged.evidence);
    let found = on(HOOP, "stability", r"\Omega^2 r < 2 g", bottom);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let beside =
        "resting = ['\\theta']\ngiven = ['g = \\Omega^2 r \\cos\\theta', 'm > 0', 'r > 0', 'c > 0', '\\Omega > 0']";
    let found = on(HOOP, "stability", r"\Omega^2 \sin^2\theta > 0", beside);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}

#[test]
fn a_spherical_pendulum_is_stable_on_its_circles() {
    let resting = "resting = ['\\theta', '\\dot{\\varphi}']\ngiven = ['g = l \\dot{\\varphi}^2 \\cos\\theta', 'm > 0', 'l > 0', '\\dot{\\varphi} > 0', '\\sin\\theta \\neq 0']";
    let found = on(SPHERICAL, "stability", r"1 + 3\cos^2\theta > 0", resting);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}

const SLIDER_CRANK: &str = r#"
title = "A slider-crank"
[parameters]
r = "m"
l = "m"
m = "kg"
J = "kg m^2"
[coordinates]
theta = "rad"
phi = "rad"
s = "m"
[points]
A = "O + r*(cos(theta)*N.x + sin(theta)*N.y)"
B = "A + l*(cos(phi)*N.x - sin(phi)*N.y)"
S = "O + s*N.x"
[bodies.crank]
turns = "theta"
inertia = "J"
[bodies.slider]
centre = "S"
mass = "m"
[[constraint]]
name = "pin"
zero = "B - S"
[start]
theta = "30 deg"
[letters]
'r' = "r"
'l' = "l"
'm' = "m"
'J' = "J"
's' = "s"
'\theta' = "theta"
'\varphi' = "phi"
'T' = "kinetic_energy"
"#;

#[test]
fn a_loop_is_closed_at_an_exact_point_too() {
    let system = SLIDER_CRANK.replace("l = \"m\"", "l = \"0.5 m\"").replace("r = \"m\"", "r = \"0.1 m\"");
    for (kind, formula, expected) in [
        ("identity", r"r \sin\theta = l \sin\varphi", "proved"),
        ("identity", r"\dot{\varphi} = \frac{r \cos\theta}{l \cos\varphi} \dot{\theta}", "proved"),
        ("identity", r"\dot{\varphi} = \frac{r \sin\theta}{l \cos\varphi} \dot{\theta}", "refuted"),
        ("identity", r"\dot{s} = -r \dot{\theta} \frac{\sin(\theta + \varphi)}{\cos\varphi}", "proved"),
        ("integral of motion", r"T = \mathrm{const}", "proved"),
        ("integral of motion", r"\dot{\theta} = \mathrm{const}", "refuted"),
    ] {
        let found = on(&system, kind, formula, "");
        assert_eq!(verdict(&found), expected, "{}", found.text());
        if expected == "refuted" {
            let at: Vec<&str> = found.judged.counterexample.iter().map(|(name, _)| name.as_str()).collect();
            assert!(at.contains(&"r") && at.contains(&"l"), "{at:?}");
        }
    }
}

/// A disc that rolls down a slope: the constraint makes its angular speed constant if the speed of its centre is.
#[test]
fn a_speed_that_a_constraint_ties_to_one_at_rest_rests_too() {
    let system = r#"
title = 'A disc on a slope'
[parameters]
m = 'kg'
R = 'm'
J = 'kg m^2'
g = 'm/s^2'
al = 'rad'
[coordinates]
s = 'm'
p = 'rad'
[frames]
I = 'N turned -al about z'
D = 'N turned -p about z'
[points]
C = 'O + s*I.x + R*I.y'
[bodies.disc]
frame = 'D'
centre = 'C'
mass = 'm'
inertia = 'J'
[[force]]
on = 'disc'
is = '-m*g*N.y'
[[constraint]]
name = 'rolling'
zero = "s' - R*p'"
[letters]
'm' = 'm'
'R' = 'R'
'J' = 'J'
'g' = 'g'
'\alpha' = 'al'
's' = 's'
"#;
    let given = r"given = ['g > 0', 'm > 0', 'R > 0', 'J > 0']
resting = ['\dot s']";
    let found = on(system, "steady motion", r"\sin\alpha = 0", given);
    assert_ne!(verdict(&found), "refuted", "{}", found.text());
}
