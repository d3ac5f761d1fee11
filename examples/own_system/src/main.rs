//! A system that is better computed than written: a chain of pendulums, as many as one likes.
//!
//! The model is the same as one read from a file; nothing here is compiled for a number of links.

use dalembert::model::principles::Principle;
use dalembert::model::{self, BodySource, Entry, MatrixForm, Model, Source, Trace, agreement};
use dalembert::symbolic;
use std::process::ExitCode;

/// Point masses on massless links, each turned about z against the vertical.
fn chain(links: usize) -> Source {
    let entries = |of: &dyn Fn(usize) -> [String; 2]| -> Vec<Entry> {
        (1..=links)
            .map(|k| {
                let [name, value] = of(k);
                (name.as_str(), value.as_str()).into()
            })
            .collect()
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

fn main() -> ExitCode {
    for links in [2, 12] {
        let model = match Model::of(&chain(links)) {
            Ok(model) => model,
            Err(faults) => {
                faults.iter().for_each(|fault| eprintln!("{}: {}", fault.title, fault.accepted));
                return ExitCode::FAILURE;
            }
        };
        // symbols live in the graph of one task
        let lines = symbolic::apart(|| {
            let trace = Trace::of(&model);
            let mut lines = vec![format!("{links} links")];
            for other in [Principle::Appell, Principle::Gauss] {
                let verdict = agreement(&trace, Principle::Lagrange, other).map(|found| found.to_string());
                let verdict = verdict.unwrap_or_else(|why| why.to_string());
                lines.push(format!("lagrange = {}: {verdict}", other.name()));
            }
            if links == 2
                && let Ok(form) = MatrixForm::of(&trace, Principle::Lagrange)
            {
                lines.push(model::text(&trace, &form.for_reading()));
            }
            lines
        });
        lines.iter().for_each(|line| println!("{line}"));
    }
    ExitCode::SUCCESS
}
