//! The checks of `conform` on scene files: sound systems pass, and each mistake is found by its check.

use super::{all, path};
use claims::finding::{Finding, PropertyVerdict};
use dalembert_scenes::conformance::conform;
use dalembert_scenes::{Task, parse_titled, read_model};

fn found(text: &str) -> Vec<Finding> {
    let (_, model) = parse_titled("scene.toml", text, Task::Write).unwrap_or_else(|error| panic!("{error}"));
    conform(&model)
}

fn verdict<'f>(findings: &'f [Finding], check: &str) -> &'f PropertyVerdict {
    let finding = findings.iter().find(|finding| finding.check == check);
    &finding.unwrap_or_else(|| panic!("no {check}")).verdict
}

/// Systems with undecided or failing checks: `learning` is supplied with energy, and wheels of `wheelset` have creep forces only in contact with
/// their rails, where no random state lies.
const ACTIVE: [&str; 2] = ["learning", "wheelset"];

#[test]
fn every_model_conforms_but_for_one_whose_force_gives_energy() {
    for path in all() {
        let model = read_model(&path, Task::Write).unwrap_or_else(|error| panic!("{error}"));
        let name = path.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        for Finding { check, verdict } in conform(&model) {
            let sound = !matches!(verdict, PropertyVerdict::Fails(_) | PropertyVerdict::Undecided(_));
            let active = check == "passivity" && ACTIVE.contains(&name.as_str());
            assert_eq!(sound, !active, "{name}, {check}: {}", verdict.says());
        }
    }
}

/// Two blocks on a line with a force between them.
fn blocks(force: &str) -> Vec<Finding> {
    found(&format!(
        "title = \"blocks\"\n[parameters]\nc = \"3 N s/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x\"\nQ = \"O + y*N.x + (1 m)*N.x\"\n\
         [bodies.a]\ncentre = \"P\"\nmass = \"(1 kg)\"\n[bodies.b]\ncentre = \"Q\"\nmass = \"(2 kg)\"\n[[force]]\n{force}\n[run]\nspan = \"1 s\"\n"
    ))
}

#[test]
fn a_damper_between_bodies_takes_energy_whoever_looks() {
    let sound = blocks("between = [\"a\", \"b\"]\nis = \"-c*rate(distance(P, Q))\"");
    assert!(matches!(verdict(&sound, "passivity"), PropertyVerdict::Tested(_)));
    assert!(matches!(verdict(&sound, "frame"), PropertyVerdict::Tested(_)), "{}", verdict(&sound, "frame").says());
    for check in ["principles", "power", "pairs"] {
        assert!(
            matches!(verdict(&sound, check), PropertyVerdict::Proved(_)),
            "{check}: {}",
            verdict(&sound, check).says()
        );
    }
    let wrong_sign = blocks("between = [\"a\", \"b\"]\nis = \"c*rate(distance(P, Q))\"");
    assert!(matches!(verdict(&wrong_sign, "passivity"), PropertyVerdict::Fails(says) if says.contains(" W at ")));
    // behind each other, y' - x' is not the rate of their distance
    let passed = blocks("between = [\"a\", \"b\"]\nis = \"-c*(y' - x')\"");
    assert!(matches!(verdict(&passed, "passivity"), PropertyVerdict::Tested(says) if says.contains("away from it")));
    // drag by the velocity relative to the ground is not an internal force of two bodies
    let of_ground = blocks("between = [\"a\", \"b\"]\nis = \"-c*(velocity(Q) . N.x)\"");
    assert!(matches!(verdict(&of_ground, "frame"), PropertyVerdict::Fails(says) if says.contains("`a` and `b`")));
    let relative = blocks("between = [\"a\", \"b\"]\nis = \"-c*((velocity(Q) - velocity(P)) . N.x)\"");
    assert!(matches!(verdict(&relative, "frame"), PropertyVerdict::Tested(_)));
    let by_letters = blocks("between = [\"a\", \"b\"]\nis = \"-c*y'\"");
    assert!(
        matches!(verdict(&by_letters, "frame"), PropertyVerdict::Fails(says) if says.contains("a velocity relative to the ground"))
    );
    let by_place = blocks("between = [\"a\", \"b\"]\nis = \"-(3 N/m)*x\"");
    assert!(
        matches!(verdict(&by_place, "frame"), PropertyVerdict::Fails(says) if says.contains("a place relative to the ground"))
    );
    let alone = blocks("on = \"b\"\nis = \"-c*y'*N.x\"");
    assert!(
        verdict(&alone, "pairs")
            .says()
            .contains("a force acts on `b`: the body on which its reaction acts is not given"),
        "{}",
        verdict(&alone, "pairs").says()
    );
}

/// D = c/2 (x'^2 + y'^2) + b x' y' is indefinite for b > c, although its diagonal is positive.
#[test]
fn a_dissipation_that_is_indefinite_gives_energy() {
    let with = |b: &str| {
        found(&format!(
            "title = \"coupled\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"(1 kg)\"\n\
             [energies]\ndissipation = \"(1 N s/m)/2*(x'^2 + y'^2) + ({b} N s/m)*x'*y'\"\n[run]\nspan = \"1 s\"\n"
        ))
    };
    assert!(matches!(verdict(&with("0.9"), "passivity"), PropertyVerdict::Proved(_)));
    assert!(matches!(verdict(&with("1.1"), "passivity"), PropertyVerdict::Fails(_)));
}

#[test]
fn dry_friction_with_a_wrong_sign_gives_energy() {
    let sound = std::fs::read_to_string(path("dry_friction")).expect("it is there");
    assert!(matches!(verdict(&found(&sound), "passivity"), PropertyVerdict::Tested(_)));
    let wrong = sound.replace("k*x + F*sign(x')", "k*x - F*sign(x')");
    assert!(matches!(verdict(&found(&wrong), "passivity"), PropertyVerdict::Fails(_)));
}
