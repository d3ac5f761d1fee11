//! A chain of pendulums, as many as a scene asks for.

use dalembert::model::{BodySource, Entry, Source};
use dalembert::scenes::{NamedSystem, submit, with_tables};

submit! {
    NamedSystem {
        name: "chain",
        summary: "a chain of pendulums",
        runs: true,
        source: |top, issues| {
            let mut data = top.table("data", "the number of links");
            let links = data.count("links", "number of links", 1, 200).value;
            issues.extend(data.finish());
            // lengths, masses, the start and whatever else the file adds
            Some(with_tables(chain(links), top))
        },
    }
}

/// Point masses on massless links, each turned about z against the vertical.
fn chain(links: usize) -> Source {
    let entries = |of: &dyn Fn(usize) -> [String; 2]| -> Vec<Entry> {
        let pairs = (1..=links).map(of);
        pairs.map(|[name, value]| (name.as_str(), value.as_str()).into()).collect()
    };
    let mut source = Source::default();
    source.parameters = vec![("m", "1 kg").into(), ("l", "1 m").into(), ("g", "9.81 m/s^2").into()];
    source.coordinates = entries(&|k| [format!("a{k}"), "rad".into()]);
    source.frames = entries(&|k| [format!("A{k}"), format!("N turned a{k} about z")]);
    source.points = entries(&|k| {
        let from = if k == 1 { "O".into() } else { format!("P{}", k - 1) };
        [format!("P{k}"), format!("{from} - l*A{k}.y")]
    });
    source.bodies = (1..=links).map(|k| BodySource::particle(&format!("bob{k}"), &format!("P{k}"), "m")).collect();
    source.gravity = Some("-g*N.y".into());
    source
}
