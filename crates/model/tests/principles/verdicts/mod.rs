//! Every sentence that `prove` prints about many models is checked numerically in an independent way: Newton's law, energies, momenta
//! and constraints by difference quotients along motions, at random consistent states.

mod claims;
mod mechanics;
mod mistakes;
mod numbers;
mod random_model;
mod system;
mod text;

use claims::{At, Fault, equal};
use dalembert_model::equations::{Characteristics, constraints_of};
use dalembert_model::principles::{Principle, Projection};
use dalembert_model::{Agreement, Mistake, Model, Trace, agreement, mistaken, projected_agreement, statements};
use mechanics::Mechanics;
use numbers::Drawn;
use symbolic::{Sym, apart};
use system::System;

/// Returns names and texts of the models in the folder `models`.
fn corpus() -> Vec<(String, String)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/principles/models");
    let files = std::fs::read_dir(folder).expect("the models stand there");
    let read = |file: std::io::Result<std::fs::DirEntry>| {
        let path = file.expect("a file").path();
        let name = path.file_stem().expect("it has a name").to_string_lossy().into_owned();
        (name, std::fs::read_to_string(&path).expect("a text"))
    };
    let mut models: Vec<(String, String)> = files.map(read).collect();
    models.sort();
    models
}

/// Returns whether a verdict states the equality of both sides.
fn holds(agreement: &Agreement) -> bool {
    matches!(agreement.degree(), "proved" | "identified" | "tested")
}

/// The printed lines of a model and the false ones among them.
#[derive(Default)]
struct Examined {
    lines: Vec<String>,
    faults: Vec<Fault>,
    /// Number of comparisons of sentences with numbers, summed over the states.
    checks: usize,
}

impl Examined {
    fn held(&mut self, line: &str, found: Result<(), Fault>) {
        self.checks += 1;
        self.faults.extend(found.err().map(|fault| format!("{line}: {fault}")));
    }

    /// Records a printed line, as a fault if its verdict is a refutation. Returns whether the verdict states equality.
    fn printed(&mut self, line: String, agreement: &Agreement) -> bool {
        let line = format!("{line}: {agreement}");
        if !holds(agreement) {
            self.faults.push(line.clone());
        }
        self.lines.push(line);
        holds(agreement)
    }
}

/// Number of states at which every sentence is checked.
const STATES: usize = 6;

fn examined(model: &Model) -> Examined {
    apart(|| {
        let trace = Trace::of(model);
        let mut found = Examined::default();
        let mut laws: Vec<(&str, Vec<Sym>)> = Vec::new();
        for principle in Principle::ALL {
            let compared = agreement(&trace, Principle::Lagrange, principle);
            let holds =
                compared.is_ok_and(|compared| found.printed(format!("lagrange = {}", principle.name()), &compared));
            if holds {
                laws.push((principle.name(), principle.residual(&trace).expect("it applies")));
            }
        }
        let constraints = constraints_of(&trace);
        let characteristics = Characteristics::of(&trace, &constraints);
        let mut projected: Vec<(&str, Vec<Sym>)> = Vec::new();
        for projection in Projection::ALL {
            let compared = projected_agreement(&trace, projection);
            let line = format!("lagrange = {projection}");
            if compared.is_ok_and(|compared| found.printed(line, &compared.agreement)) {
                let residual = projection.residual(&trace, &constraints, &characteristics).expect("it applies");
                projected.push((projection.name(), residual));
            }
        }
        let stated = statements(&trace);
        for one in &stated {
            found.printed(format!("{}: {}", one.subject, one.says), &one.agreement);
        }
        let mistakes = Mistake::ALL.map(|mistake| (mistake, mistaken(&trace, mistake)));
        let mistakes: Vec<_> = mistakes.into_iter().filter_map(|(mistake, made)| Some((mistake, made.ok()?))).collect();
        for (_, made) in &mistakes {
            found.lines.push(format!("mistake: {}: {}", made.says, made.agreement));
        }
        let mut drawn = Drawn(7);
        let system = System::of(&trace, &mut drawn);
        let mechanics = Mechanics::of(&system);
        let mut states = 0;
        for _ in 0..80 {
            let Some(state) = system.drawn(&mut drawn).filter(|_| states < STATES) else { continue };
            states += 1;
            let solved = system.motion(&state).0;
            let accelerations: Vec<f64> = state.u.iter().map(|_| drawn.number()).collect();
            let at = At { mechanics: &mechanics, state, solved };
            found.held("law", at.law());
            let kept = system.kept(&at.state, &at.solved[..at.state.u.len()]);
            found.held("law", kept.iter().try_for_each(|rate| equal("J u' + c", *rate, 0.0, 0.0)));
            let reactions = at.reactions();
            for (name, residual) in &laws {
                let values = system.at(&system.numbers(residual), &at.state, &at.solved);
                let held =
                    values.iter().zip(&reactions).try_for_each(|(value, reaction)| equal(name, *value, *reaction, 0.0));
                found.held(name, held);
            }
            for (name, residual) in &projected {
                let values = system.at(&system.numbers(residual), &at.state, &at.solved);
                let size = reactions.iter().fold(0.0, |size: f64, one| size.max(one.abs()));
                found.held(name, values.iter().try_for_each(|value| equal(name, *value, 0.0, size)));
            }
            let mut number = 0;
            for one in &stated {
                let line = format!("{}: {}", one.subject, one.says);
                let held = match one.subject.strip_prefix("momentum of ") {
                    _ if one.subject == "energy" => at.energy(&one.says),
                    Some(name) => {
                        let speed = (0..trace.speeds.len()).find(|&speed| trace.direction(speed) == name);
                        at.momentum(speed.expect("a speed"), &one.says)
                    }
                    None => {
                        number += 1;
                        at.constraint(number - 1, &accelerations, &one.says)
                    }
                };
                found.held(&line, held);
            }
            for (mistake, made) in &mistakes {
                found.held(&made.says, mistakes::lost(&at, &characteristics, *mistake, made));
            }
        }
        if states < STATES {
            found.faults.push("no consistent state is found".to_owned());
        }
        found
    })
}

#[test]
fn every_sentence_of_every_model_holds_along_its_motions() {
    let (mut checks, mut faults) = (0, Vec::new());
    let show = std::env::var_os("SHOW_VERDICTS").is_some();
    for (name, text) in corpus() {
        let examined = examined(&text::model(&text));
        if show {
            println!("== {name}\n{}", examined.lines.join("\n"));
        }
        checks += examined.checks;
        faults.extend(examined.faults.into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    assert!(checks > 1_000, "{checks}");
}

/// False sentences, some of which earlier versions of `prove` printed, must be detected.
#[test]
fn a_false_sentence_is_found() {
    let texts = corpus();
    let fails = |name: &str, claim: &(dyn Fn(&At<'_, '_, '_, '_>) -> Result<(), Fault> + Sync)| {
        let (_, text) = texts.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("no {name}"));
        let model = text::model(text);
        apart(|| {
            let trace = Trace::of(&model);
            let mut drawn = Drawn(11);
            let system = System::of(&trace, &mut drawn);
            let mechanics = Mechanics::of(&system);
            for _ in 0..3 {
                let state = (0..80).find_map(|_| system.drawn(&mut drawn)).expect("a consistent state");
                let solved = system.motion(&state).0;
                let at = At { mechanics: &mechanics, state, solved };
                assert!(claim(&at).is_err(), "{name}");
            }
        });
    };
    let energies = [
        ("pendulum_on_a_driven_cart", "(T + V)' is zero"),
        ("ball_on_a_turntable", "(T + V)' is zero"),
        ("mass_led_along_a_line", "(T + V)' is the power of the forces"),
        ("mass_under_a_programme", "(T + V)' is the power of the forces"),
        ("mass_led_along_a_line", "(T + V)' is the power of the forces plus the power of the reactions (lambda1)"),
        (
            "growing_mass_led_along_a_line",
            "(T + V)' is the power of the forces plus the power of the reactions (lambda1*cos(2*t))",
        ),
        ("spring_to_a_driven_point", "(T + V)' is the power of the forces"),
        ("spring_to_a_driven_point_as_a_potential", "(T + V)' is zero"),
        ("bead_on_a_turning_hoop", "(H = sum u dT/du - T + V)' is the power of the forces"),
        ("bead_on_a_turning_hoop", "(T + V)' is the power of the forces"),
    ];
    for (name, says) in energies {
        fails(name, &|at| at.energy(says));
    }
    let constraints = [
        ("mass_under_a_programme", "J u' + c is its second rate; the power of its reaction is lambda1*x'"),
        ("programmed_speed", "J u' + c is f' + g1 f; its reaction does no work"),
        ("pendulum_on_a_driven_cart", "J u' + c is its rate; its reaction does no work"),
        ("speed_that_is_kept", "J u' + c is its rate; the power of its reaction is lambda1*v^2"),
        ("constraint_in_a_turning_frame", "J u' + c is its second rate; its reaction does no work"),
    ];
    for (name, says) in constraints {
        fails(name, &|at| at.constraint(0, &[0.3, -0.2, 0.5][..at.state.u.len()], says));
    }
    fails("pendulum_on_a_driven_cart", &|at| at.momentum(0, "(dT/dx')' is zero"));
    fails("pendulum_on_a_driven_cart", &|at| {
        let wrong = At { solved: at.solved.iter().map(|value| 1.1 * value).collect(), state: at.state.clone(), ..*at };
        wrong.law()
    });
    fails("rolling_disc", &|at| {
        let trace = at.mechanics.system.trace;
        let characteristics = Characteristics::of(trace, &constraints_of(trace));
        let made = mistaken(trace, Mistake::ConstraintsInEnergy).expect("it can be made");
        let less = dalembert_model::Mistaken { lost: made.lost[1..].to_vec(), ..made };
        mistakes::lost(at, &characteristics, Mistake::ConstraintsInEnergy, &less)
    });
}

/// Models composed at random from a fixed seed.
#[test]
fn every_sentence_of_composed_models_holds_along_their_motions() {
    let count = std::env::var("COMPOSED").ok().and_then(|count| count.parse().ok()).unwrap_or(40);
    let mut drawn = Drawn(std::env::var("SEED").ok().and_then(|seed| seed.parse().ok()).unwrap_or(3));
    let (mut faults, mut checks) = (Vec::new(), 0);
    for _ in 0..count {
        let text = random_model::text(&mut drawn);
        let examined = examined(&text::model(&text));
        checks += examined.checks;
        // a model with contradictory constraints has no consistent state
        let found = examined.faults.into_iter().filter(|fault| fault != "no consistent state is found");
        faults.extend(found.map(|fault| format!("{fault}\n{text}")));
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n\n"));
    assert!(checks > 50 * count, "{checks}");
}
