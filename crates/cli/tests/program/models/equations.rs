//! Equations of motion as `derive` prints them.

use super::{BLOCK, MODEL, printed};
use crate::{run, temporary};

#[test]
fn every_principle_and_notation_gives_the_equations() {
    let body = "scenes/models/tumbling_body.toml";
    for format in ["text", "latex", "mathml", "sympy", "c", "python", "rust"] {
        assert!(
            printed(&["derive", body, "--format", format]).contains("q0") || format == "latex" || format == "mathml"
        );
    }
    for principle in ["lagrange", "virtual-power", "appell", "gauss", "newton-euler", "hamel", "hamilton"] {
        for format in ["text", "latex", "mathml", "sympy", "c", "python", "rust"] {
            let output = run(&["derive", MODEL, "--principle", principle, "--format", format]);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{principle} {format}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
            assert!(output.stdout.len() > 100, "{principle} {format}");
        }
    }
    let text = printed(&["derive", MODEL, "--echo"]);
    for line in [
        "acceleration(P) = l1*a''*A.x + l1*a'^2*A.y",
        "joint of lower to upper: at Q",
        "m1 = 1 kg",
        "M[a, b] = m2*l1*l2*cos(a - b)",
    ] {
        assert!(text.lines().any(|known| known.trim() == line), "{line}\n{text}");
    }
    let latex = printed(&["derive", MODEL, "--format", "latex"]);
    assert!(latex.contains(r"\begin{align}") && latex.contains(r"\dot{a}^2\sin(a - b)"), "{latex}");
    let refused = run(&["derive", MODEL, "--principle", "momentum"]);
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        refused.status.code() == Some(2)
            && message
                .contains("lagrange, virtual-power, appell, gauss, newton-euler, hamel, hamilton, maggi, shulgin"),
        "{message}"
    );
}

#[test]
fn equations_say_what_their_conditions_are_and_what_they_leave_out() {
    let path = temporary("block.toml");
    std::fs::write(&path, BLOCK).expect("it is written");
    let file = path.display().to_string();
    let text = printed(&["derive", &file]);
    for line in [
        "Conditions; a bracket is 1 where its condition is positive, else 0",
        "  [f1' > 0]: condition 1 = f1', in m/s, line 14",
        "in N, line 17",
        "  constraint 1 `rail` along N.y: of positions",
        "  F1 = y",
        "A positive lambda acts along the gradient of F",
        "A condition that stays at zero, such as the speed of dry friction that sticks, is not part of these equations",
        "  event `wall` (line 21): where f1 - 1 passes zero upwards, f1' becomes -1/2*f1', the run ends",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let bracket = text.lines().find(|line| line.starts_with("  [condition 2 > 0]: condition 2 = "));
    assert!(bracket.is_some_and(|line| line.contains("sin(2*t)")), "{text}");
    let latex = printed(&["derive", &file, "--format", "latex"]);
    for part in [r"\text{condition 2} &= ", r"0 = \mathbf{f}_{1} &= y \quad \text{along N.y}", "% Events are not part"]
    {
        assert!(latex.contains(part), "{part}\n{latex}");
    }
    printed(&["derive", &file, "--format", "mathml"]);
    for (format, sign) in [("python", "#"), ("sympy", "#"), ("c", "//"), ("rust", "//")] {
        let code = printed(&["derive", &file, "--format", format]);
        let event = format!("\n{sign}   event `wall` (line 21): where ");
        assert!(code.contains(&event) && code.contains("along N.y"), "{format}\n{code}");
    }
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn an_echo_shows_definitions_centres_and_loads() {
    let text = "title = \"t\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"kg\"\nl = \"m\"\ng = \"m/s^2\"\nmu = \"[1]\"\n[coordinates]\na = \"rad\"\n\
                [definitions]\narm = \"l*A.y\"\nQ = \"O - arm/2\"\nfast = \"O + (1 s)*a'*arm\"\n[frames]\nA = \"N turned a about z\"\n\
                [bodies.bob]\ncentre = \"O - arm\"\nmass = \"m\"\n[[force]]\non = \"bob\"\nis = \"-mu*m*g*N.x\"\n\
                [[force]]\nbetween = [\"ground at O + (1 m)*N.x\", \"bob at Q\"]\nis = \"(1 N)\"\n[[torque]]\non = \"A\"\nis = \"(2 N m)*N.z\"\n";
    let path = temporary("echo.toml");
    std::fs::write(&path, text).expect("it is written");
    let echo = printed(&["derive", path.to_str().expect("a path in UTF-8"), "--echo"]);
    for line in [
        "arm = l*A.y",
        "Q - O = -l/2*A.y",
        "velocity(Q) = l*a'/2*A.x",
        "centre of bob - O = -l*A.y",
        "velocity(bob) = l*a'*A.x",
        "acceleration(bob) = l*a''*A.x + l*a'^2*A.y",
        "force on bob = -m*g*mu*N.x",
        "weight of bob = -m*g*N.y",
        "torque on A = 2*N.z",
        "mu in 1, without a value",
    ] {
        assert!(echo.lines().any(|known| known.trim() == line), "{line}\n{echo}");
    }
    assert!(echo.contains("force on bob at O - l/2*A.y = "), "{echo}");
    // the acceleration of this point would need a third derivative
    assert!(echo.contains("fast - O = ") && !echo.contains("acceleration(fast)"), "{echo}");
    std::fs::remove_file(path).expect("it is there");
}
