//! A system with quasi-velocities, and one with a constraint that follows from others.

use super::{printed, refused};
use crate::{json, run, temporary};
use std::path::PathBuf;

/// A scene of the folder with other tables.
fn edited(name: &str, scene: &str, from: &str, to: &str) -> PathBuf {
    let text = std::fs::read_to_string(crate::root().join("scenes/models").join(scene)).expect("it is there");
    assert_eq!(text.matches(from).count(), 1, "`{from}` must stand once");
    let path = temporary(name);
    std::fs::write(&path, text.replace(from, to)).expect("it is written");
    path
}

fn sleigh(name: &str) -> PathBuf {
    let speeds = "[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n\n[frames]";
    edited(name, "chaplygin_sleigh.toml", "[frames]", speeds)
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
        assert!(text.contains("M q'' + h = Q + J^T lambda") && !text.contains("h[v]"), "{principle}: {text}");
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
        &["derive", "scenes/models/chaplygin_sleigh.toml", "--principle", "maggi"],
        "the table [speeds] gives these",
    );
    refused(&["derive", "gyrostat", "--principle", "maggi"], "newton-euler, hamilton and maggi are for a system");
    std::fs::remove_file(path).expect("it is there");
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
    let path = edited("twice.toml", "chaplygin_sleigh.toml", "[outputs]", twice);
    let file = path.to_str().expect("a path in UTF-8");
    let code = printed(&["derive", file, "--format", "python"]);
    assert!(code.contains("# constraint 2 `again` follows from the others and is left out."), "{code}");
    let output = run(&["run", file]);
    let warned = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{warned}");
    assert!(
        warned.contains("warning") && warned.contains("constraint 2 `again` follows from other constraints"),
        "{warned}"
    );
    std::fs::remove_file(path).expect("it is there");
}

/// Seven speeds, four constraints: the kinematic equations alone are pages.
#[test]
fn equations_that_nobody_reads_are_code_alone() {
    let speeds = "[speeds]\nu4 = \"lean'\"\nu6 = \"rear'\"\nu7 = \"steer'\"\n\n[frames]";
    let path = edited("bicycle.toml", "bicycle.toml", "[frames]", speeds);
    let file = path.to_str().expect("a path in UTF-8");
    for format in ["text", "latex", "mathml", "sympy"] {
        refused(
            &["derive", file, "--format", format],
            "operations, too many to be read; `--format c`, `python` and `rust`",
        );
    }
    assert!(printed(&["derive", file, "--format", "c"]).contains("SPEEDS = 3, CONSTRAINTS = 0"));
    std::fs::remove_file(path).expect("it is there");
}
