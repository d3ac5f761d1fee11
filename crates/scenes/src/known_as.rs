//! The key `known_as` of a file: it names a system for which a crate provides theory beyond the equations, such as a closed form.

use crate::compiled_system::rates;
use crate::letters::Letters;
use crate::modes::Mode;
use crate::program::recorded;
use model::{Model, Trace};
use reader::{At, Issue};
use simulation::knowledge::{self, Knowledge};
use units::nearest;

/// A function that reads the model of a file's text; `None` if the text has errors.
type Reader = fn(&str) -> Option<Model>;

/// The registered theory with this name.
///
/// # Errors
/// No theory has this name.
pub(crate) fn known(At { value, span }: &At<String>) -> Result<&'static Knowledge, Issue> {
    let entries = knowledge::entries();
    entries.iter().find(|entry| entry.name == *value).copied().ok_or_else(|| {
        let list = entries.iter().map(|entry| entry.name).collect::<Vec<_>>().join(", ");
        let accepted = match nearest(value, entries.iter().map(|entry| entry.name)) {
            Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
            None if list.is_empty() => {
                "a file without `known_as`: no knowledge about any system is linked into this program".to_owned()
            }
            None => format!("known: {list}"),
        };
        Issue::at(span.clone(), format!("no system is known as `{value}`"), "not known").accepted(accepted)
    })
}

/// The registered theory with this name. `None` with an issue if there is none, or if the model has other parameters, columns or
/// equations. `columns` are the columns of the model's runs.
pub(crate) fn asked_for(
    (model, columns): (&Model, &[String]),
    name: &At<String>,
    read: Reader,
    issues: &mut Vec<Issue>,
) -> Option<&'static Knowledge> {
    let found = known(name).map_err(|issue| issues.push(issue)).ok()?;
    let At { value, span } = name;
    let has_value = |name: &str| model.parameters.iter().any(|one| one.name == name && one.value.is_some());
    let parameters =
        found.parameters.iter().filter(|name| !has_value(name)).map(|name| (name, "parameter with a value"));
    let shown = found.columns.iter().filter(|name| !columns.iter().any(|own| own == *name));
    let mut missing = parameters.chain(shown.map(|name| (name, "coordinate, speed or output")));
    let Some((name, what)) = missing.next() else {
        let Some(difference) = difference(model, found, read) else { return Some(found) };
        let title = format!("the equations are not those of `{value}`");
        let accepted = "the equations of a scene that has this key; without `known_as` any are accepted";
        issues.push(Issue::at(span.clone(), title, difference).accepted(accepted));
        return None;
    };
    let title = format!("`{value}` is a system with `{name}`, which is no {what} here");
    let letters = found.parameters.iter().chain(found.columns).copied().collect::<Vec<_>>().join(", ");
    let issue = Issue::at(span.clone(), title, found.summary);
    issues.push(issue.accepted(format!("a system with {letters}; without `known_as` any names are accepted")));
    None
}

/// A sentence on the difference of the rates from those of all texts that the theory accepts; `None` if one of these texts has equal
/// rates.
fn difference(model: &Model, known: &Knowledge, read: Reader) -> Option<String> {
    let mut nearest: Option<String> = None;
    for text in known.equations {
        match compared(model, known, read(text)) {
            None => return None,
            Some(found) => nearest = nearest.or(Some(found)),
        }
    }
    nearest
}

/// The relative difference up to which rates count as equal.
const EQUAL: f64 = 1e-9;

/// Displacements from the start, relative to 1 + |component|, at which rates are compared.
const ASIDE: [[f64; 3]; 3] = [[0.0; 3], [0.037, -0.021, 0.053], [-0.047, 0.031, 0.019]];

/// A sentence on the first rate or column that differs from that of another model with the same parameters; `None` if all agree.
fn compared(model: &Model, known: &Knowledge, other: Option<Model>) -> Option<String> {
    // a registered text with errors is skipped
    let mut other = other?;
    for parameter in &mut other.parameters {
        match model.parameters.iter().find(|one| one.name == parameter.name) {
            Some(own) if own.dimension == parameter.dimension => parameter.value = own.value,
            Some(_) => return Some(format!("`{}` has another dimension there", parameter.name)),
            None => return Some(format!("`{}` is a parameter there", parameter.name)),
        }
    }
    let [own_names, names] = [model, &other].map(|model| {
        let states = model.state_names().into_iter().map(|(name, _)| name);
        states.collect::<Vec<String>>()
    });
    if own_names != names {
        return Some(format!("the states there are {}, in this order", names.join(", ")));
    }
    let shown = |model: &Model| {
        let shown = known.columns.iter().filter_map(|name| model.outputs.iter().find(|output| output.name == **name));
        shown.map(|output| output.is).collect::<Vec<_>>()
    };
    let law = |model: &Model| {
        let mut wrong = false;
        let program = recorded(names.len(), |time, state| {
            let letters = Letters::with_data(time, state);
            let trace = Trace::of(model);
            let outputs: Vec<_> = shown(model).into_iter().map(|id| trace.scalar(id)).collect();
            let found = rates(model, &Mode::default(), letters);
            wrong |= found.is_err();
            [found.unwrap_or_default(), letters.put_into(&trace, &outputs)].concat()
        });
        program.ok().filter(|_| !wrong)
    };
    let (Some(own), Some(known_law)) = (law(model), law(&other)) else {
        return Some("their rates cannot be compared with those that are known".to_owned());
    };
    let titles = names.iter().map(|name| format!("the rate of `{name}`"));
    let titles: Vec<String> = titles.chain(known.columns.iter().map(|name| format!("`{name}`"))).collect();
    let start = model.start_state();
    for aside in ASIDE {
        let moved = |(place, y): (usize, &f64)| y + aside[place % 3] * (1.0 + y.abs());
        let state: Vec<f64> = start.iter().enumerate().map(moved).collect();
        let count = names.len() + shown(&other).len();
        let (mut here, mut there) = (vec![f64::NAN; count], vec![f64::NAN; count]);
        let _ = (own.run(0.1, &state, &mut here), known_law.run(0.1, &state, &mut there));
        let size = there.iter().filter(|value| value.is_finite()).fold(1.0, |size: f64, value| size.max(value.abs()));
        let differs = |(a, b): (&f64, &f64)| {
            let is_close = (a - b).abs() <= EQUAL * size.min(1.0 + 1e6 * b.abs());
            b.is_finite() && !is_close
        };
        if let Some(place) = here.iter().zip(&there).position(differs) {
            let title = titles.get(place).cloned().unwrap_or_default();
            return Some(format!("{title} is {:.9e} near the start, and {:.9e} there", here[place], there[place]));
        }
    }
    None
}
