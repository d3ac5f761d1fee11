//! Named systems that a program registers, with tables of their own.

use dalembert_scenes::{ModelScene, NamedSystem, submit, with_tables};
use model::{BodySource, Source};
use simulation::{Axes, IvpScene};

submit! {
    NamedSystem {
        name: "beads",
        summary: "beads on parallel wires",
        runs: true,
        source: |top, issues| {
            // `data` would be reported as another word for [parameters] in other systems
            let mut data = top.table("data", "the number of beads");
            let beads = data.count("beads", "number of beads", 1, 9).value;
            issues.extend(data.finish());
            let bead = |k| BodySource::particle(&format!("bead{k}"), &format!("O + x{k}*N.x"), "m");
            let source = Source {
                parameters: vec![("m", "1 kg").into()],
                coordinates: (1..=beads).map(|k| (format!("x{k}").as_str(), "m").into()).collect(),
                bodies: (1..=beads).map(bead).collect(),
                ..Source::default()
            };
            Some(with_tables(source, top))
        },
    }
}

const BEADS: &str = "title = \"beads\"\nsystem = \"beads\"\n\n[data]\nbeads = 2\n\n[run]\nspan = \"1 s\"\n";

#[test]
fn a_named_system_reads_tables_whose_names_mean_others_elsewhere() {
    let scene = ModelScene::parse("scene.toml", BEADS).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.problem(Axes::First).state, [0.0; 4]);
}

#[test]
fn a_word_that_the_named_system_does_not_read_is_still_told() {
    let text = BEADS.replace("[run]", "[constants]\nm = \"2 kg\"\n\n[run]");
    let error = ModelScene::parse("scene.toml", &text).expect_err("constants are parameters").to_string();
    assert!(error.contains("unknown key `constants`") && error.contains("help: [parameters]"), "{error}");
}
