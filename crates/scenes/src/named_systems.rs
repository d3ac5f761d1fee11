//! Systems with names: a file gives `system = "chain"` and data, and a crate builds the model in Rust.
//!
//! A crate registers them by [`submit!`](crate::submit):
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
//!         // parameters, starts and forces of the file are added
//!         Some(with_tables(source, top))
//!     },
//! } }
//! ```

use crate::text;
use model::{Entry, Source};
use reader::{Issue, Table};

/// A system that a crate builds from the data in a file.
#[derive(Clone, Copy, Debug)]
pub struct NamedSystem {
    /// The value of `system` in files.
    pub name: &'static str,
    /// A description of one line, for lists.
    pub summary: &'static str,
    /// Whether a scene integrates this model. Otherwise another law is integrated, and the model only gives the equations.
    pub runs: bool,
    /// Reads the data and builds the source of the model; faults of the data are added to the list.
    pub source: fn(&mut Table<'_>, &mut Vec<Issue>) -> Option<Source>,
}

inventory::collect!(NamedSystem);

reader::submit! { reader::KnownSystems(|| listed(|system| system.runs)) }

/// The names and summaries of the registered systems that fulfil a condition.
fn listed(is_meant: impl Fn(&NamedSystem) -> bool) -> Vec<(&'static str, &'static str)> {
    let systems = inventory::iter::<NamedSystem>().filter(|system| is_meant(system));
    systems.map(|system| (system.name, system.summary)).collect()
}

/// The registered system of this name.
fn named(name: &str) -> Option<&'static NamedSystem> {
    inventory::iter::<NamedSystem>().find(|system| system.name == name)
}

/// Whether scenes of the named system integrate its model.
pub(crate) fn runs(name: &str) -> bool {
    named(name).is_some_and(|system| system.runs)
}

/// Whether a system of this name is registered.
pub(crate) fn knows(name: &str) -> bool {
    named(name).is_some()
}

/// The source of the system in a file: built by a crate if `system` names a registered one, otherwise read from the tables of the file.
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

/// A source together with the tables of a file. Parameters, outputs and starts with equal names have the values of the file.
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

/// The union of two lists of entries; an entry of `own` replaces that with the same name.
fn replaced(mut entries: Vec<Entry>, own: Vec<Entry>) -> Vec<Entry> {
    for entry in own {
        match entries.iter_mut().find(|known| known.name.text == entry.name.text) {
            Some(known) => *known = entry,
            None => entries.push(entry),
        }
    }
    entries
}
