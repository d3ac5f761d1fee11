//! Messages about starts, constraints, and laws that cannot run.

use super::{messages, one};

#[test]
fn a_free_frame_starts_by_turns() {
    let free = |start: &str, parts: &[&str]| {
        let start = format!("theta = \"0.3 rad\"\n{start}");
        one(&[("[points]", "B = \"N free\"\n[points]"), ("theta = \"0.3 rad\"", &start)], parts);
    };
    free("B = \"30 deg\"", &["the start of `B` is a turn", "this is none"]);
    free("B = \"30 deg about w\"", &["about another axis"]);
    free("B = \"3 m about x\"", &["this has the dimension m"]);
    free("\"B.wq\" = \"3 rad/s\"", &["no coordinate is called `B.wq`", "is `B.wz` meant?"]);
    free("\"B.wx\" = \"3 rad\"", &["the start of `B.wx`", "this has the dimension 1"]);
}

#[test]
fn a_force_between_points_that_coincide_at_the_start_is_named() {
    let spring = "[[force]]\nbetween = [\"O\", \"cart\"]\nis = \"-(3 N/m)*x\"\n[outputs]";
    one(
        &[
            ("theta = \"rad\"", "theta = \"rad\"\nx = \"m\""),
            ("[bodies.bob]", "[bodies.cart]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[bodies.bob]"),
            ("[outputs]", spring),
        ],
        &[
            "a force acts between `O` and `cart`, which coincide at the start",
            "`along = \"x\"` in the place of `between`",
        ],
    );
}

#[test]
fn what_cannot_run_says_why() {
    one(&[("m = \"2 kg\"", "m = \"kg\"")], &["the parameter `m` has no value"]);
    one(
        &[("theta = \"rad\"", "theta = \"rad\"\nidle = \"m\"")],
        &["nothing with a mass or an inertia moves with `idle`"],
    );
    one(
        &[("[outputs]", "[[constraint]]\nzero = \"theta - 0.4\"\n\n[outputs]")],
        &["constraint 1 does not hold at the start", "-0.1 with the coordinates"],
    );
}

#[test]
fn a_start_without_a_motion_names_what_stops_it() {
    one(&[("[run]\nspan = \"1 s\"\n", "")], &["the table [run] is missing", "the file ends here"]);
    one(&[("m = \"2 kg\"", "m = \"kg\"")], &["the parameter `m` has no value", ":5:1"]);
    let high = "[[constraint]]\nname = \"high\"\nzero = \"(P - O) . N.y - 2*l\"\n\n[outputs]";
    let guessed = [("[outputs]", high), ("theta = \"0.3 rad\"", "theta = \"guess 0.3 rad\"")];
    one(
        &guessed,
        &[
            "constraint 1 `high` was not met from this start",
            "is -0.6386726 m after",
            "after `theta` was adjusted, not zero",
            "theta = \"guess ...\"",
        ],
    );
    let same = "[[constraint]]\nzero = \"l - l\"\n\n[outputs]";
    one(&[("[outputs]", same)], &["this constraint holds no coordinate and no speed"]);
    let pole = [
        ("theta = \"rad\"", "phi = \"rad\"\ntheta = \"rad\""),
        ("N turned theta about z", "B turned theta about x\"\nB = \"N turned phi about y"),
        ("theta = \"0.3 rad\"", "theta = \"0 rad\""),
    ];
    one(
        &pole,
        &["the acceleration of `phi` is not determined at the start", "spherical angles are not defined at the pole"],
    );
    one(&[("\"(0.1 N)*N.x\"", "\"(0.1 N)*ln(theta - 1)*N.x\"")], &["the forces on `theta` have no value at the start"]);
}

#[test]
fn a_start_without_its_unit_is_shown_one_of_its_own() {
    let metres = ("[coordinates]\ntheta = \"rad\"", "[coordinates]\ntheta = \"rad\"\nx = \"mm\"");
    let start = "theta = \"0.3 rad\"";
    one(&[metres, (start, "x = 100")], &["the start of `x` cannot be read", "such as \"0.3 m\""]);
    one(&[metres, (start, "\"x'\" = 100")], &["such as \"0.3 m/s\" or \"guess 0.3 m/s\""]);
}

/// At a dead point the gradient of a constraint is zero, although the constraint is not a square.
#[test]
fn a_constraint_without_a_gradient_is_told_with_both_causes() {
    let level = "[[constraint]]\nname = \"top\"\nzero = \"(P - O) . N.y + l\"\n\n[outputs]";
    let parts = [
        "constraint 1 `top` has no effect at the start",
        "every derivative of it by coordinates and speeds is zero there",
        "a crank at its dead point are singular positions",
        "x - y, and not its square",
    ];
    one(&[("[outputs]", level), ("theta = \"0.3 rad\"", "theta = \"0 rad\"")], &parts);
}

/// Newton's method satisfies a square up to rounding, with a small gradient that is not zero. Sums of squares and squares of speeds are similar.
#[test]
fn a_constraint_whose_gradient_vanishes_wherever_it_holds_is_refused() {
    let cart = [
        ("[coordinates]", "[coordinates]\nx = \"m\"\ny = \"m\""),
        ("centre = \"P\"", "centre = \"P + x*N.x + y*N.z\""),
    ];
    let held = |zero: &str, start: &str| {
        let constraint = format!("[[constraint]]\nname = \"tie\"\nzero = \"{zero}\"\n\n[outputs]");
        let start = format!("theta = \"0.3 rad\"\n{start}");
        one(
            &[cart[0], cart[1], ("[outputs]", &constraint), ("theta = \"0.3 rad\"", &start)],
            &[
                "the gradient of constraint 1 `tie` is zero wherever the constraint holds",
                "its root: x - y in the place of (x - y)^2",
            ],
        );
    };
    held("(x - l*sin(theta))^2", "");
    held("(x - l*sin(theta))^2", "x = \"guess 0.5 m\"");
    held("x^2 - 2*x*y + y^2", "x = \"0.2 m\"");
    held("(x - l*theta)^4", "x = \"guess 0.5 m\"");
    held("(x - l*theta)^2 + y^2", "y = \"guess 0.3 m\"");
    held("(x' - l*theta')^2", "\"theta'\" = \"2 rad/s\"");
    let found = |zero: &str, start: &str| {
        let constraint = format!("[[constraint]]\nname = \"tie\"\nzero = \"{zero}\"\n\n[outputs]");
        let start = format!("theta = \"0.3 rad\"\n{start}");
        messages(&[cart[0], cart[1], ("[outputs]", &constraint), ("theta = \"0.3 rad\"", &start)])
    };
    assert_eq!(found("x - l*sin(theta)", ""), Vec::<String>::new());
    // a simple root, whose gradient is 1e-5 of that at displaced positions
    assert_eq!(found("x + (1e5 1/m^2)*x^3", ""), Vec::<String>::new());
    assert_eq!(found("x*y", "y = \"1e-5 m\""), Vec::<String>::new());
}

#[test]
fn residuals_have_units_and_rates_are_told_as_rates() {
    let level = "[[constraint]]\nname = \"level\"\nzero = \"(P - O) . N.x\"\n\n[outputs]";
    let place = "constraint 1 `level` does not hold at the start";
    one(&[("[outputs]", level)], &[place, "0.1477601 m with the coordinates in [start]"]);
    let turning = "theta = \"0 rad\"\n\"theta'\" = \"2 rad/s\"";
    one(&[("[outputs]", level), ("theta = \"0.3 rad\"", turning)], &[place, "its rate is 1 m/s with the speeds"]);
}

#[test]
fn gains_that_are_too_few_are_told_where_they_stand() {
    let led = "[[constraint]]\nzero = \"theta - 0.4\"\nprogrammed = { gains = [\"(1 1/s)\"] }\n\n[outputs]";
    one(&[("[outputs]", led)], &["a programmed constraint of positions needs two gains", ":31:26", "one is given"]);
}

#[test]
fn constraints_that_contradict_each_other_are_both_named() {
    let two = |one: &str, other: &str| {
        format!("[[constraint]]\nname = \"low\"\nzero = \"{one}\"\n[[constraint]]\nzero = \"{other}\"\n[outputs]")
    };
    let found = |one_zero: &str, other: &str, parts: &[&str]| {
        one(&[("[outputs]", &two(one_zero, other)), ("theta = \"0.3 rad\"", "theta = \"guess 0.3 rad\"")], parts)
    };
    let both =
        ["constraint 2 contradicts constraint 1 `low`", "its value is -0.1, not zero", "zero = \"2*theta - 0.1\""];
    found("theta", "2*theta - 0.1", &both);
    found("sin(theta)", "3*sin(theta) + 1", &["constraint 2 contradicts constraint 1 `low`"]);
    // both constraints cannot hold together, but are not linearly related
    found("sin(theta)", "cos(theta)", &["no start was found that satisfies constraint", "may contradict each other"]);
}

#[test]
fn what_is_wrong_with_a_constraint_is_told_once() {
    let load = "[[constraint]]\nname = \"low\"\nzero = \"thata\"\n[outputs]\nload = \"reaction(low)\"";
    one(&[("[outputs]", load)], &["is called `thata`"]);
    one(&[("theta = \"rad\"", "theta = \"radd\""), ("[outputs]", &load.replace("thata", "theta"))], &["`radd`"]);
    let none = load.replace("zero = \"thata\"", "zero = \"theta\"").replace("reaction(low)", "reaction(high)");
    one(&[("[outputs]", &none)], &["no constraint is called `high`"]);
}

#[test]
fn speeds_that_no_inertia_resists_together_are_named() {
    let text = |kinetic: &str| {
        format!(
            "title = \"t\"\n[coordinates]\na = \"m\"\nb = \"m\"\n[energies]\nkinetic = \"{kinetic}\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let told = |kinetic: &str| match dalembert_scenes::ModelScene::parse("scene.toml", &text(kinetic)) {
        Ok(_) => panic!("it runs"),
        Err(error) => error.to_string(),
    };
    let together = told("(1 kg)/2*(a' + b')^2");
    assert!(
        together.contains("no mass and no inertia resists the speeds a' = 1 m/s, b' = -1 m/s together"),
        "{together}"
    );
    let alone = told("(1 kg)/2*a'^2");
    assert!(alone.contains("nothing with a mass or an inertia moves with `b`"), "{alone}");
}

/// A moving belt and a driven crank have no position of rest; with V = 0 there is one.
#[test]
fn a_constraint_that_moves_the_system_at_rest_is_told_where_an_equilibrium_is_asked_for() {
    let driven = |zero: &str| {
        let constraint = format!("[[constraint]]\nname = \"belt\"\nzero = \"{zero}\"\n\n[outputs]");
        messages(&[
            ("[outputs]", &constraint),
            ("theta = \"0.3 rad\"", "theta = \"guess 0.1 rad\"\nequilibrium = true"),
        ])
    };
    for (zero, rate) in [("theta' - (0.5 rad/s)", "-0.5 rad/s"), ("theta - (0.5 rad/s)*t", "-0.5 1/s")] {
        let found = driven(zero);
        assert_eq!(found.len(), 1, "{found:?}");
        let told = "there is no equilibrium: constraint 1 `belt` moves the system";
        assert!(found[0].contains(told) && found[0].contains(&format!("at rest it is {rate}")), "{}", found[0]);
        assert!(found[0].contains("that of a belt that does not move"), "{}", found[0]);
    }
    assert_eq!(driven("theta - 0.1"), Vec::<String>::new());
}

/// The message shows a guess for a free frame as rotations, not as components of a quaternion.
#[test]
fn a_guess_of_a_free_frame_is_shown_as_turns() {
    let edits = [
        ("[frames]", "[frames]\nB = \"N free\""),
        (
            "[bodies.bob]",
            "[bodies.top]\nframe = \"B\"\ninertia = { principal = [\"(1 kg m^2)\", \"(1 kg m^2)\", \"(1 kg m^2)\"] }\n[bodies.bob]",
        ),
        ("[outputs]", "[[constraint]]\nname = \"far\"\nzero = \"B.x . N.y - 2\"\n\n[outputs]"),
    ];
    one(
        &edits,
        &["was not met from this start", "after `B` was adjusted, not zero", "such as B = \"guess 20 deg about z\""],
    );
}
