//! Checks of a system: principles agree, the power balance holds, loads between bodies are equal and opposite and do not depend on the
//! observer, forces that depend on speeds dissipate energy, and inertias are positive.

mod observer;
mod passivity;
mod states;

use crate::admissible::impossible;
use crate::inductances::impossible_inductances;
use crate::readiness::start_of;
use claims::finding::{Finding, PropertyVerdict};
use model::principles::Principle;
use model::{Agreement, Model, Pairs, Trace, agreement, statements};
use symbolic::apart;

/// All checks of a model. Inputs without a value are set to zero.
pub fn conform(model: &Model) -> Vec<Finding> {
    let mut model = model.clone();
    model.close_inputs();
    let model = &model;
    let dimensions = PropertyVerdict::Proved("the units of all expressions agree, as they were read".to_owned());
    [
        ("principles", apart(|| principles(model))),
        ("power", apart(|| power(model))),
        ("passivity", passivity::verdict(model)),
        ("pairs", apart(|| pairs(model))),
        ("frame", observer::verdict(model)),
        ("inertia", inertia(model)),
        ("dimensions", dimensions),
    ]
    .into_iter()
    .map(|(check, verdict)| Finding { check, verdict })
    .collect()
}

/// The verdict for an agreement of two derivations; `says` is the statement in words.
fn verdict(found: &Agreement, says: &str) -> PropertyVerdict {
    match found {
        Agreement::Proved { .. } | Agreement::Theorem { .. } => PropertyVerdict::Proved(says.to_owned()),
        Agreement::Identified { .. } | Agreement::Tested { .. } => PropertyVerdict::Tested(format!("{says}: {found}")),
        Agreement::Refuted { .. } => PropertyVerdict::Fails(format!("{says}: {found}")),
        Agreement::Undecided { .. } => PropertyVerdict::Undecided(format!("{says}: {found}")),
    }
}

/// Compares Lagrange's equations with the equations of Newton and Euler.
fn principles(model: &Model) -> PropertyVerdict {
    let trace = Trace::of(model);
    match agreement(&trace, Principle::Lagrange, Principle::NewtonEuler) {
        Ok(found) => verdict(&found, "Lagrange's equations agree with the equations of Newton and Euler for each body"),
        Err(why) => PropertyVerdict::DoesNotApply(why.to_string()),
    }
}

fn power(model: &Model) -> PropertyVerdict {
    let trace = Trace::of(model);
    match statements(&trace).into_iter().find(|one| one.subject == "energy") {
        Some(energy) => verdict(&energy.agreement, &energy.says),
        None => PropertyVerdict::DoesNotApply("it has no energy".to_owned()),
    }
}

fn pairs(model: &Model) -> PropertyVerdict {
    let Pairs { between, from_outside, along } = Pairs::of(model);
    let pairs = match between {
        0 => "no load acts between two bodies".to_owned(),
        1 => "one load acts between two bodies, equal and opposite".to_owned(),
        several => format!("{several} loads act between two bodies, equal and opposite"),
    };
    let alone = [from_outside, along].concat();
    match (between, alone.is_empty()) {
        (0, true) => PropertyVerdict::DoesNotApply(pairs),
        (_, true) => PropertyVerdict::Proved(format!("{pairs}; none acts on one alone")),
        (_, false) => PropertyVerdict::DoesNotApply(format!(
            "{pairs}; {}: the body on which its reaction acts is not given",
            alone.join(", ")
        )),
    }
}

fn inertia(model: &Model) -> PropertyVerdict {
    if let Some(issue) = impossible(model).into_iter().next() {
        return PropertyVerdict::Fails(issue.title);
    }
    let Ok(start) = start_of(model) else {
        return PropertyVerdict::DoesNotApply("it has no start: parameters or coordinates are open".to_owned());
    };
    match impossible_inductances(model, &start) {
        Some(issue) => PropertyVerdict::Fails(issue.title),
        None => {
            PropertyVerdict::Tested("masses, moments of inertia and inductances are physically possible".to_owned())
        }
    }
}
