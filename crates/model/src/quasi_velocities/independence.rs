//! Whether quasi-velocities, with the constraints, determine all speeds.

use crate::equations::{Equation, generic_pivots};
use crate::{Fault, QuasiVelocity, Trace};
use symbolic::Sym;

/// Why quasi-velocities do not determine the speeds.
pub(super) enum Dependence {
    /// What they are made of.
    Forms(Vec<Fault>),
    /// Their number, or that of directions that they and constraints hold, at a general point.
    Ranks(Fault),
}

/// The places of the constraints that are independent.
pub(super) fn independent(trace: &Trace<'_>, met: &[Equation], definitions: &[Sym]) -> Result<Vec<usize>, Dependence> {
    let speeds = &trace.model.quasi_velocities;
    let n = trace.speeds.len();
    let slopes = |rate: &Sym| (0..n).map(|i| trace.by_speed(*rate, i)).collect::<Vec<Sym>>();
    let rows: Vec<Vec<Sym>> = definitions.iter().map(slopes).collect();
    let faults: Vec<Fault> = speeds
        .iter()
        .zip(definitions)
        .zip(&rows)
        .filter_map(|((speed, is), row)| form(trace, speed, *is, row))
        .collect();
    if !faults.is_empty() {
        return Err(Dependence::Forms(faults));
    }
    let moves = |sym: &Sym| sym.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol));
    if let Some(place) = met.iter().position(|constraint| constraint.row.iter().any(moves)) {
        let title = format!("{} is not linear in the speeds", met[place].title(place));
        let accepted = "constraints that are linear in the speeds; without [speeds] this one is accepted";
        let fault = Fault::at(met[place].at.clone(), title, "quasi-velocities cannot meet it", accepted);
        return Err(Dependence::Forms(vec![fault]));
    }
    let all: Vec<Vec<Sym>> = met.iter().map(|constraint| constraint.row.clone()).chain(rows).collect();
    let order: Vec<usize> = (0..n).collect();
    let found = generic_pivots(&all, &order);
    let constraints: Vec<usize> = found.iter().map(|&(row, _)| row).filter(|row| *row < met.len()).collect();
    let depends = |place: &usize| found.iter().all(|(row, _)| *row != met.len() + place);
    let dependent: Vec<usize> = (0..speeds.len()).filter(depends).collect();
    let needed = n - constraints.len();
    let list = |names: Vec<String>| names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let named = |places: &[usize]| list(places.iter().map(|&place| speeds[place].name.clone()).collect());
    let freedom = match needed {
        1 => "the speeds have one degree of freedom".to_owned(),
        _ => format!("the speeds have {needed} degrees of freedom"),
    };
    if speeds.len() > needed {
        let title = format!("{freedom}, and [speeds] has {}: {} too many", speeds.len(), speeds.len() - needed);
        let at = dependent.first().map_or(0..0, |&place| speeds[place].at.clone());
        let rest = if constraints.is_empty() { "those before" } else { "the constraints and those before" };
        return Err(Dependence::Ranks(Fault::at(
            at,
            title,
            format!("determined by {rest}"),
            format!("without {}", named(&dependent)),
        )));
    }
    // rates that would complete what is independent
    let units = (0..n).map(|i| (0..n).map(|j| if i == j { Sym::ONE } else { Sym::ZERO }).collect());
    let completed: Vec<Vec<Sym>> = all.iter().cloned().chain(units).collect();
    let completed = generic_pivots(&completed, &order);
    let free = completed.iter().filter_map(|&(row, _)| row.checked_sub(all.len()));
    let free = list(free.map(|speed| trace.speeds[speed].to_string()).collect());
    if let Some(&first) = dependent.first() {
        let QuasiVelocity { name, at, .. } = &speeds[first];
        let others = if constraints.is_empty() {
            "the quasi-velocities before it"
        } else {
            "the constraints and the quasi-velocities before it"
        };
        let title = format!("the quasi-velocity `{name}` depends on {others}");
        return Err(Dependence::Ranks(Fault::at(
            at.clone(),
            title,
            "it adds no direction",
            format!("an expression that holds {free} too"),
        )));
    }
    if speeds.len() < needed {
        let title = format!("{freedom}, and [speeds] has {}: {} missing", speeds.len(), needed - speeds.len());
        let at = speeds.last().map_or(0..0, |last| last.at.clone());
        let accepted = match needed - speeds.len() {
            1 => format!("one more that holds {free}"),
            missing => format!("{missing} more that hold {free}"),
        };
        return Err(Dependence::Ranks(Fault::at(at, title, "the last of them", accepted)));
    }
    Ok(constraints)
}

/// The fault of an expression that is not affine in the speeds.
fn form(trace: &Trace<'_>, QuasiVelocity { name, at, .. }: &QuasiVelocity, is: Sym, row: &[Sym]) -> Option<Fault> {
    let holds = |letters: &[Sym]| is.symbols_of().iter().any(|symbol| letters.contains(symbol));
    let fault = |why: &str, label: &str, accepted: &str| {
        Some(Fault::at(at.clone(), format!("the quasi-velocity `{name}` {why}"), label, accepted))
    };
    let moves = |slope: &Sym| slope.symbols_of().iter().any(|symbol| trace.speeds.contains(symbol));
    if holds(&trace.switches) {
        let accepted = "an expression without `if`, `sign`, `abs`, `min`, `max` and `table`";
        return fault("changes at a condition", "piecewise", accepted);
    }
    if row.iter().any(moves) {
        let accepted = "sums of speeds, each times an expression of coordinates and the time, such as x'*cos(a) + r*a'";
        return fault("is not linear in the speeds", "nonlinear", accepted);
    }
    if row.iter().all(|slope| crate::equations::vanishes(*slope)) {
        return fault(
            "holds no speed",
            "no rate of a coordinate",
            "an expression that is linear in rates, such as l*a'",
        );
    }
    None
}
