//! The stages that derive the equations and vectors of a system, and judge them.

use super::{Broken, Stage};
use crate::exit::be_quiet;
use crate::watch::told::Told;
use ::scenes::derivation::{Derived, NotDerived, derived};
use ::scenes::{SystemText, Task, parse_titled};
use charts::page::live::{self, LiveVector, LiveVerdict, Part};
use manuscript::PaperText;
use model::{DerivedVector, Judgement, Trace, constraints, derived_vectors, judgements};
use motor::reading::equations_of;
use reader::Family;
use simulation::models::has_model;
use std::path::{Path, PathBuf};
use studies::AnyScene;
use toml::de::{DeTable, DeValue};

/// Reads the text, reports whether it is acceptable, and derives equations and vectors.
pub(super) fn tell(path: &Path, text: String) -> Result<(), Broken> {
    if manuscript::is_paper(&text) {
        return tell_of_paper(path, text);
    }
    if !has_model(&text) {
        return tell_of_driven(path, &text);
    }
    let system = SystemText { name: path.display().to_string(), text, values: Vec::new() };
    let (title, _) = parse_titled(&system.name, &system.text, Task::Write)?;
    tell_acceptance(&title, &system.name, vec![Stage::Motion, Stage::Verdicts])?;
    tell_equations(&system)
}

/// Reports a paper with the equations of its system.
fn tell_of_paper(path: &Path, text: String) -> Result<(), Broken> {
    // the file of the system may be created later
    let model = entry(&text, "model", |value| value.as_str().map(PathBuf::from)).flatten();
    if let (Some(model), Some(folder)) = (model, path.parent()) {
        Told::Reads(folder.join(model)).write()?;
    }
    let paper = PaperText::parse(path, text)?;
    let system = paper.system();
    parse_titled(&system.name, &system.text, Task::Write)?;
    tell_acceptance(&paper.title, &paper.path, vec![Stage::Claims])?;
    tell_equations(system)
}

/// Reports that the text is acceptable: its heading, and the stages that follow. Later readings of the text print no warnings.
fn tell_acceptance(title: &str, file: &str, stages: Vec<Stage>) -> Result<(), Broken> {
    be_quiet();
    Told::part(Part::Heading, live::heading(title, file)).write()?;
    Ok(Told::Then(stages).write()?)
}

/// Reports a scene with a motor: the equations of the motor.
fn tell_of_driven(path: &Path, text: &str) -> Result<(), Broken> {
    let name = path.display().to_string();
    let scene = AnyScene::parse(&name, text)?;
    tell_acceptance(scene.title(), &name, vec![Stage::Motion])?;
    if let AnyScene::Driven(scene) = &scene {
        let content = match equations_of(&scene.machine) {
            Ok(equations) => {
                let sides = equations.iter().map(|each| (each.left.decimal_latex(), each.right.decimal_latex()));
                live::equations("torque and currents of the motor", &[sides.collect()])
            }
            Err(why) => live::message("note", &why.to_string()),
        };
        Told::part(Part::Equations, content).write()?;
    }
    Ok(())
}

/// Reports the equations by the default principle, and the vectors.
fn tell_equations(system: &SystemText) -> Result<(), Broken> {
    let shown = derived(system, None, false, |derived| {
        let kinds = constraints(derived.trace).into_iter().map(|line| LiveVector { name: line, latex: None });
        let vectors = derived_vectors(derived.trace).into_iter().map(vector);
        (equations(derived), live::vectors(&kinds.chain(vectors).collect::<Vec<_>>()))
    });
    let (equations, vectors) = match shown {
        Ok(shown) => shown,
        Err(NotDerived::Text(error)) => return Err(error.into()),
        Err(NotDerived::Refused(why)) => (live::message("note", &why), String::new()),
    };
    Told::part(Part::Equations, equations).write()?;
    Ok(Told::part(Part::Vectors, vectors).write()?)
}

fn vector(DerivedVector { name, value }: DerivedVector) -> LiveVector {
    LiveVector { name, latex: value.map(|[_, latex]| latex) }
}

fn equations(derived: &Derived<'_, '_>) -> String {
    let form = match derived.for_reading() {
        Ok(form) => form,
        Err(why) => return live::message("note", &why),
    };
    let groups = model::typeset(derived.trace, &form).into_iter();
    let groups: Vec<Vec<_>> =
        groups.map(|group| group.into_iter().map(|each| (each.left, each.right)).collect()).collect();
    let mut from = format!("by the principle {}", derived.principle.name());
    if derived.vanishes_at_start {
        from += "; the quasi-velocities do not determine the speeds at the start: these equations have no value there";
    }
    live::equations(&from, &groups)
}

/// Reports the verdicts on the agreement of principles and on conservation laws.
pub(super) fn tell_verdicts(path: &Path, text: String) -> Result<(), Broken> {
    let system = SystemText { name: path.display().to_string(), text, values: Vec::new() };
    let model = system.for_judgement()?;
    let rows: Vec<Judgement> = symbolic::apart(|| judgements(&Trace::of(&model)));
    let rows: Vec<LiveVerdict> = rows.into_iter().map(verdict).collect();
    Ok(Told::part(Part::Verdicts, live::verdicts(&rows)).write()?)
}

fn verdict(row: Judgement) -> LiveVerdict {
    LiveVerdict { title: row.title(), degree: row.degree().to_owned(), said: row.said(), behind: row.behind }
}

/// An entry at the top level of a TOML text; the text may have faults elsewhere.
pub(super) fn entry<T>(text: &str, key: &str, read: impl FnOnce(&DeValue<'_>) -> T) -> Option<T> {
    let (entries, _) = DeTable::parse_recoverable(text);
    entries.get_ref().get(key).map(|value| read(value.get_ref()))
}
