//! Systems that have a name: a file says `system = "chain"` and gives data, and a crate builds the model.
//!
//! A crate brings them by [`submit!`](crate::submit):
//!
//! ```
//! use dalembert_scenes::{NamedSystem, submit, with_tables};
//! use model::{BodySource, Source};
//!
//! submit! { NamedSystem {
//!     name: "stack",
//!     summary: "masses on springs, one above the other",
//!     runs: true,
//!     source: |top, issues| {
//!         let mut data = top.table("data", "the number of masses");
//!         let count = data.count("masses", "number of masses", 1, 100).value;
//!         issues.extend(data.finish());
//!         let mut source = Source::default();
//!         source.parameters = vec![("m", "1 kg").into()];
//!         for k in 1..=count {
//!             let (x, point) = (format!("x{k}"), format!("P{k}"));
//!             source.coordinates.push((x.as_str(), "m").into());
//!             source.points.push((point.as_str(), format!("O + {x}*N.z").as_str()).into());
//!             source.bodies.push(BodySource::particle(&format!("mass{k}"), &point, "m"));
//!         }
//!         // values of parameters, starts, forces of the file are taken too
//!         Some(with_tables(source, top))
//!     },
//! } }
//! ```

use crate::text;
use model::{Entry, Source};
use reader::{Issue, Table};

/// A system that a crate builds from the data of a file.
#[derive(Clone, Copy, Debug)]
pub struct NamedSystem {
    /// As files have it behind `system`.
    pub name: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// Whether a scene runs as this model; of others a law of their own runs, and the model answers what is asked of equations.
    pub runs: bool,
    /// Reads the data and builds the system; what is wrong with the data goes into the list.
    pub source: fn(&mut Table<'_>, &mut Vec<Issue>) -> Option<Source>,
}

inventory::collect!(NamedSystem);

reader::submit! { reader::KnownSystems(|| listed(|system| system.runs)) }

/// Systems by name and summary.
fn listed(is_meant: impl Fn(&NamedSystem) -> bool) -> Vec<(&'static str, &'static str)> {
    let systems = inventory::iter::<NamedSystem>().filter(|system| is_meant(system));
    systems.map(|system| (system.name, system.summary)).collect()
}

/// The system that a text names.
fn named(name: &str) -> Option<&'static NamedSystem> {
    inventory::iter::<NamedSystem>().find(|system| system.name == name)
}

/// Whether the model of a named system is what its scenes run.
pub(crate) fn runs(name: &str) -> bool {
    named(name).is_some_and(|system| system.runs)
}

/// Whether a crate builds a model of this name.
pub(crate) fn knows(name: &str) -> bool {
    named(name).is_some()
}

/// The system of a file: the one that it names, or the one that is written in it.
pub(crate) fn source(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Source> {
    if !top.has("system") {
        return Some(text::source(top));
    }
    let name = top.text("system", "name of what moves");
    match named(&name.value) {
        Some(system) => (system.source)(top, issues),
        None => Some(text::source(top)),
    }
}

/// A system with what the tables of a file add to it: a parameter or a start that both give has the file's value.
pub fn with_tables(base: Source, top: &mut Table<'_>) -> Source {
    let own = text::source(top);
    Source {
        parameters: replaced(base.parameters, own.parameters),
        coordinates: [base.coordinates, own.coordinates].concat(),
        speeds: [base.speeds, own.speeds].concat(),
        definitions: [base.definitions, own.definitions].concat(),
        frames: [base.frames, own.frames].concat(),
        points: [base.points, own.points].concat(),
        bodies: [base.bodies, own.bodies].concat(),
        gravity: own.gravity.or(base.gravity),
        energies: [base.energies, own.energies].concat(),
        forces: [base.forces, own.forces].concat(),
        torques: [base.torques, own.torques].concat(),
        constraints: [base.constraints, own.constraints].concat(),
        contacts: [base.contacts, own.contacts].concat(),
        one_ways: [base.one_ways, own.one_ways].concat(),
        drives: [base.drives, own.drives].concat(),
        outputs: replaced(base.outputs, own.outputs),
        inputs: [base.inputs, own.inputs].concat(),
        events: [base.events, own.events].concat(),
        regulator: own.regulator.or(base.regulator),
        start: replaced(base.start, own.start),
        equilibrium: own.equilibrium.or(base.equilibrium),
        absent: base.absent,
        rigid: base.rigid,
        angles: base.angles,
    }
}

/// Entries, those of a name that both have as the second has them.
fn replaced(mut entries: Vec<Entry>, own: Vec<Entry>) -> Vec<Entry> {
    for entry in own {
        match entries.iter_mut().find(|known| known.name.text == entry.name.text) {
            Some(known) => *known = entry,
            None => entries.push(entry),
        }
    }
    entries
}
