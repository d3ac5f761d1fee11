//! A system with quasi-velocities, and a system with a redundant constraint.

use super::{printed, refused};
use crate::{json, root, run, temporary};
use std::path::PathBuf;

/// A copy of a scene with `from` replaced by `to`.
fn edited(name: &str, scene: &str, from: &str, to: &str) -> PathBuf {
    let text = std::fs::read_to_string(root().join("scenes").join(scene)).expect("it is there");
    assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once");
    let path = temporary(name);
    std::fs::write(&path, text.replace(from, to)).expect("it is written");
    path
}

fn sleigh(name: &str) -> PathBuf {
    let speeds = "[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n\n[frames]";
    edited(name, "models/chaplygin_sleigh.toml", "[frames]", speeds)
}

#[test]
fn equations_stand_in_quasi_velocities_where_the_principle_uses_them() {
    let path = sleigh("speeds.toml");
    let file = path.to_str().expect("a path in UTF-8");
    for principle in ["virtual-power", "appell", "hamel", "maggi"] {
        let text = printed(&["derive", file, "--principle", principle]);
        for line in ["M u' + h = Q, with u = (v, w)", "y' = v*sin(psi)", "h[v] = -m*a*w^2", "h[w] = m*a*v*w"] {
            assert!(text.lines().any(|known| known.trim() == line), "{principle}: {line}\n{text}");
        }
    }
    for principle in ["lagrange", "gauss", "newton-euler", "hamilton"] {
        let text = printed(&["derive", file, "--principle", principle]);
        // `J` is a parameter of the system
        assert!(text.contains("M q'' + h = Q + jacobian^T lambda") && !text.contains("h[v]"), "{principle}: {text}");
    }
    for (format, part) in [
        ("latex", r"\dot{x} &= v\cos \psi"),
        ("mathml", "<mover accent=\"true\"><mi>ψ</mi>"),
        ("sympy", "    psi.diff(t) - (w),"),
        ("python", "# u = (v, w): quasi-velocities"),
        ("c", "SPEEDS = 2, CONSTRAINTS = 0"),
        ("rust", "pub const SPEEDS: usize = 2;"),
    ] {
        let text = printed(&["derive", file, "--format", format]);
        assert!(text.contains(part), "{format}: {part}\n{text}");
    }
    refused(
        &["derive", "gyrostat", "--principle", "maggi"],
        "newton-euler, hamilton, maggi and shulgin are for a system",
    );
    std::fs::remove_file(path).expect("it is there");
}

#[test]
fn without_quasi_velocities_equations_stand_along_independent_rates() {
    for scene in ["scenes/models/chaplygin_sleigh.toml", "scenes/models/slider_crank.toml"] {
        let [maggi, shulgin] =
            ["maggi", "shulgin"].map(|principle| printed(&["derive", scene, "--principle", principle]));
        assert_eq!(maggi, shulgin, "{scene}");
    }
    let text = printed(&["derive", "scenes/models/chaplygin_sleigh.toml", "--principle", "shulgin"]);
    for line in [
        "M u' + h = Q, with u = (x', psi')",
        "y' = x'*sin(psi)/cos(psi)",
        "M[x', x'] = m/cos(psi)^2",
        "h[x'] = m*x'*psi'*sin(psi)/cos(psi)^3 - m*a*psi'^2/cos(psi)",
    ] {
        assert!(text.lines().any(|known| known.trim() == line), "{line}\n{text}");
    }
    assert!(!text.contains("x' = x'"), "{text}");
    for format in ["latex", "mathml", "sympy", "c", "python", "rust"] {
        let text =
            printed(&["derive", "scenes/models/rolling_disc.toml", "--principle", "shulgin", "--format", format]);
        assert!(text.len() > 500, "{format}: {text}");
    }
    refused(
        &["derive", "scenes/models/double_pendulum.toml", "--principle", "maggi"],
        "maggi does not apply: without constraints its equations are those of lagrange",
    );
    // two principles have a second name
    for (name, of) in [("kane", "virtual-power"), ("lagrange-1", "lagrange")] {
        let [one, other] =
            [name, of].map(|name| printed(&["derive", "scenes/models/slider_crank.toml", "--principle", name]));
        assert_eq!(one, other);
    }
}

#[test]
fn a_proof_compares_the_principles_in_quasi_velocities() {
    let path = sleigh("proved_speeds.toml");
    let file = path.to_str().expect("a path in UTF-8");
    let text = printed(&["prove", file]);
    for other in ["virtual-power", "appell", "hamel"] {
        let line = format!("maggi = {other} in v, w: proved by normal form: equal for all values of all letters");
        assert!(text.lines().any(|known| known == line), "{line}\n{text}");
    }
    let rows = json(&run(&["prove", file, "--format", "json"]));
    let rows =
        rows.as_array().expect("rows").iter().filter(|row| row["quasi_velocities"] == serde_json::json!(["v", "w"]));
    assert_eq!(rows.filter(|row| row["verdict"] == "proved").count(), 3);
    std::fs::remove_file(path).expect("it is there");
}

#[test]
fn code_leaves_out_what_follows_from_other_constraints() {
    let twice = "[[constraint]]\nname = \"again\"\nzero = \"(3 1/m)*(velocity(sleigh at P) . B.y)\"\n\n[outputs]";
    let path = edited("twice.toml", "models/chaplygin_sleigh.toml", "[outputs]", twice);
    let file = path.to_str().expect("a path in UTF-8");
    let code = printed(&["derive", file, "--format", "python"]);
    assert!(code.contains("# constraint 2 `again` follows from the others and is left out."), "{code}");
    for format in ["text", "latex"] {
        let told = printed(&["derive", file, "--format", format]);
        assert!(told.contains("follows from the others and is left out."), "{told}");
    }
    for command in [&["derive", file, "--format", "mathml"][..], &["prove", file]] {
        let warned = String::from_utf8_lossy(&run(command).stderr).into_owned();
        assert!(warned.contains("constraint 2 `again` follows from other constraints"), "{warned}");
    }
    let output = run(&["run", file]);
    let warned = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{warned}");
    assert!(
        warned.contains("warning") && warned.contains("constraint 2 `again` follows from other constraints"),
        "{warned}"
    );
    std::fs::remove_file(path).expect("it is there");
}

#[test]
fn of_constraints_that_contradict_each_other_nothing_is_derived_or_proved() {
    let against = "[[constraint]]\nname = \"against\"\nzero = \"velocity(sleigh at P) . B.y - (1 m/s)\"\n\n[outputs]";
    let path = edited("against.toml", "models/chaplygin_sleigh.toml", "[outputs]", against);
    let file = path.to_str().expect("a path in UTF-8");
    for command in [&["derive", file][..], &["derive", file, "--format", "c"], &["prove", file], &["run", file]] {
        refused(command, "constraint 2 `against` contradicts constraint 1 `edge`");
    }
    std::fs::remove_file(path).expect("it is there");
    // an unsatisfied initial state does not prevent a derivation
    let start = "\"y'\" = \"7 m/s\"\n\n[run]";
    let path = edited("unmet.toml", "models/chaplygin_sleigh.toml", "[run]", start);
    let file = path.to_str().expect("a path in UTF-8");
    refused(&["run", file], "does not hold at the start");
    assert!(printed(&["derive", file]).contains("M q'' + h"));
    assert!(printed(&["prove", file]).contains("proved by normal form"));
    std::fs::remove_file(path).expect("it is there");
}

/// Eight pole pairs: products of cosines and sines become multiple angles again, also inside exponentials.
#[test]
fn machines_of_many_poles_have_short_equations() {
    let text = std::fs::read_to_string(root().join("scenes/models/interior_magnet.toml")).expect("it is there");
    let path = temporary("eight_pairs.toml");
    std::fs::write(&path, text.replace("2*theta", "8*theta")).expect("it is written");
    let text = printed(&["derive", path.to_str().expect("a path in UTF-8")]);
    std::fs::remove_file(path).expect("it is there");
    for line in ["h[id] = -8*Lq*turning*iq", "a' = id*cos(8*theta) - iq*sin(8*theta)"] {
        assert!(text.lines().any(|known| known.trim() == line), "{line}\n{text}");
    }
    let text = printed(&["derive", "scenes/models/synchronous_reluctance.toml"]);
    assert!(text.contains("exp(id/i0)") && !text.contains("cos(theta)"), "{text}");
}

/// Seven speeds and four constraints: the kinematic equations alone fill pages.
#[test]
fn equations_that_nobody_reads_are_code_alone() {
    let speeds = "[speeds]\nu4 = \"lean'\"\nu6 = \"rear'\"\nu7 = \"steer'\"\n\n[frames]";
    let path = edited("bicycle.toml", "foreign/bicycle.toml", "[frames]", speeds);
    let file = path.to_str().expect("a path in UTF-8");
    for format in ["text", "latex", "mathml", "sympy"] {
        refused(
            &["derive", file, "--format", format],
            "operations, too many to be read; the formats c, python and rust",
        );
    }
    assert!(printed(&["derive", file, "--format", "c"]).contains("SPEEDS = 3, CONSTRAINTS = 0"));
    std::fs::remove_file(path).expect("it is there");
}

/// Two equal cranks of a parallelogram: the difference of their angles is zero on the branch of the initial state.
#[test]
fn code_whose_divisor_vanishes_at_the_start_is_warned_of() {
    let cranks = |speed: &str| {
        format!(
            "title = \"Two cranks\"\n[parameters]\nm = \"1 kg\"\nr = \"0.3 m\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\nd = \"rad\"\n\
             [speeds]\nw = \"{speed}\"\n[frames]\nA = \"N turned a about z\"\nB = \"N turned b about z\"\nD = \"N turned d about z\"\n\
             [points]\nP = \"O + r*A.x\"\nQ = \"O + (1 m)*N.x + r*B.x\"\n\
             [bodies.coupler]\nframe = \"D\"\ncentre = \"P + (0.4 m)*D.x\"\nmass = \"m\"\ninertia = \"(0.1 kg m^2)\"\n\
             [[constraint]]\nzero = \"P + (1 m)*D.x - Q\"\n[start]\na = \"1 rad\"\nb = \"1 rad\"\n"
        )
    };
    let path = temporary("cranks.toml");
    let file = path.to_str().expect("a path in UTF-8").to_owned();
    for (speed, warns) in [("a' - b'", true), ("a' + b'", false)] {
        std::fs::write(&path, cranks(speed)).expect("it is written");
        let output = run(&["derive", &file, "--format", "c"]);
        let (code, warned) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert_eq!(warned.contains("do not determine the speeds at the start"), warns, "{speed}: {warned}");
        assert_eq!(code.contains("It vanishes at the start: these equations have no value there"), warns, "{code}");
    }
    std::fs::remove_file(path).expect("it is there");
}

/// A ball that rolls in a bowl: its equilibrium does not depend on the initial speeds.
#[test]
fn an_equilibrium_that_motions_reach_is_told() {
    let path = temporary("bowl.toml");
    let text = "title = \"A ball in a bowl\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"0.2 kg\"\nr = \"0.05 m\"\ng = \"9.81 m/s^2\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[speeds]\nvx = \"x'\"\nvy = \"y'\"\nspin = \"F.wz\"\n[frames]\nF = \"N free\"\n\
        [points]\nC = \"O + x*N.x + y*N.y + z*N.z\"\nK = \"C + r*unit(C - O)\"\n\
        [bodies.ball]\nframe = \"F\"\ncentre = \"C\"\nmass = \"m\"\ninertia = { principal = [\"2/5*m*r^2\", \"2/5*m*r^2\", \"2/5*m*r^2\"] }\n\
        [[constraint]]\nname = \"roll\"\nzero = \"velocity(ball at K)\"\n[start]\nx = \"0.3 m\"\nz = \"-0.4 m\"\nvy = \"0.5 m/s\"\n";
    std::fs::write(&path, text).expect("it is written");
    let file = path.to_str().expect("a path in UTF-8");
    let output = run(&["linearise", file, "--about", "equilibrium"]);
    let (text, told) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{told}");
    assert!(text.contains("z = -0.5 m, z' = 0 m/s"), "{text}");
    assert!(
        told.contains("this equilibrium is one that motions from the start reach; it belongs to a family of equilibria with one parameter"),
        "{told}"
    );
    std::fs::remove_file(path).expect("it is there");
}
