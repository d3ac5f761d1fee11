//! Independence of quasi-velocities: decides whether they determine all speeds together with the constraints.

use crate::equations::{Equation, generic_circuits, generic_pivots};
use crate::{Fault, QuasiVelocity, Trace};
use std::ops::Range;
use symbolic::Sym;

/// The reason why quasi-velocities do not determine the speeds.
pub(super) enum Dependence {
    /// An expression is not affine in the speeds, or a constraint is not linear in them.
    Forms(Vec<Fault>),
    /// The number of quasi-velocities, or the generic rank of quasi-velocities and constraints, is wrong.
    Ranks(Fault),
}

/// Returns the indices of the independent constraints.
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
    let needed = n - constraints.len();
    let independent = found.len() - constraints.len();
    if independent < speeds.len() || speeds.len() < needed {
        let groups = Group::all(speeds, met.len(), &generic_circuits(&all, &order));
        let fault = wrong_number(trace, needed, &groups, &open_speeds(trace, &all, &order));
        return Err(Dependence::Ranks(fault));
    }
    Ok(constraints)
}

/// Quasi-velocities that depend on each other on the constraints.
struct Group {
    /// The indices of the quasi-velocities, in the order of the file.
    members: Vec<usize>,
    /// The number of quasi-velocities that are superfluous.
    excess: usize,
    /// Whether they are independent without the constraints.
    by_constraints: bool,
}

impl Group {
    /// Returns all groups, from sets of dependent rows: rows of the constraints come first, then those of the quasi-velocities.
    fn all(speeds: &[QuasiVelocity], constraints: usize, circuits: &[Vec<usize>]) -> Vec<Group> {
        let mut groups: Vec<Group> = Vec::new();
        for circuit in circuits {
            let (of_constraints, of_speeds) = circuit.split_at(circuit.partition_point(|row| *row < constraints));
            if of_speeds.is_empty() {
                continue;
            }
            let members = of_speeds.iter().map(|row| row - constraints).collect();
            let mut group = Group { members, excess: 1, by_constraints: !of_constraints.is_empty() };
            // dependent sets with a common member form one group
            groups.retain(|known| {
                let is_apart = known.members.iter().all(|member| !group.members.contains(member));
                if !is_apart {
                    group.members.extend(&known.members);
                    group.excess += known.excess;
                    group.by_constraints |= known.by_constraints;
                }
                is_apart
            });
            group.members.sort_by_key(|&member| (speeds[member].at.start, member));
            group.members.dedup();
            groups.push(group);
        }
        groups
    }

    /// Returns the position of the last member in the file.
    fn at(&self, speeds: &[QuasiVelocity]) -> Range<usize> {
        self.members.last().map_or(0..0, |&last| speeds[last].at.clone())
    }

    /// Returns the names as text: `v`, `w` and `z`.
    fn named(&self, speeds: &[QuasiVelocity], last: &str) -> String {
        let names: Vec<String> = self.members.iter().map(|&member| format!("`{}`", speeds[member].name)).collect();
        match names.split_last() {
            Some((name, [])) => name.clone(),
            Some((name, rest)) => format!("{} {last} {name}", rest.join(", ")),
            None => String::new(),
        }
    }

    /// Returns a sentence on the dependence of the members.
    fn dependence(&self, speeds: &[QuasiVelocity]) -> String {
        match (self.members.as_slice(), self.by_constraints) {
            ([_], _) => format!("the constraints determine {}", self.named(speeds, "and")),
            (_, true) => format!("{} depend on each other where the constraints hold", self.named(speeds, "and")),
            (_, false) => format!("{} depend on each other", self.named(speeds, "and")),
        }
    }

    /// Returns a text that states which quasi-velocities to omit.
    fn without(&self, speeds: &[QuasiVelocity]) -> String {
        match self.excess {
            1 => format!("without {}", self.named(speeds, "or")),
            all if all == self.members.len() => format!("without {}", self.named(speeds, "and")),
            several => format!("without {several} of {}", self.named(speeds, "and")),
        }
    }
}

/// Returns the fault of quasi-velocities that are too many, too few, or dependent.
fn wrong_number(trace: &Trace<'_>, needed: usize, groups: &[Group], open: &[String]) -> Fault {
    let speeds = &trace.model.quasi_velocities;
    let freedom = match needed {
        1 => "the speeds have one degree of freedom".to_owned(),
        _ => format!("the speeds have {needed} degrees of freedom"),
    };
    let independent = speeds.len() - groups.iter().map(|group| group.excess).sum::<usize>();
    let free = open.join(", ");
    let more = match open.len() {
        1 => format!("one more that holds {free}"),
        missing => format!("{missing} more that hold {free}"),
    };
    if let (Some(group), true) = (groups.first(), speeds.len() > needed) {
        let title = format!("{freedom}, and [speeds] has {}: {} too many", speeds.len(), speeds.len() - needed);
        let mut accepted: Vec<String> = groups.iter().map(|group| group.without(speeds)).collect();
        accepted.extend((independent < needed).then_some(more));
        return Fault::at(group.at(speeds), title, group.dependence(speeds), accepted.join(", and "));
    }
    if let Some(group) = groups.first() {
        let title = match group.members.as_slice() {
            [_] => format!("the quasi-velocity {} is determined by the constraints", group.named(speeds, "and")),
            _ => format!("the quasi-velocities {}", group.dependence(speeds)),
        };
        let accepted = match group.members.len() {
            1 => format!("an expression that holds {free} too"),
            _ => format!("in the place of one of them an expression that holds {free} too"),
        };
        return Fault::at(group.at(speeds), title, "no direction of its own", accepted);
    }
    let title = format!("{freedom}, and [speeds] has {}: {} missing", speeds.len(), needed - speeds.len());
    let last = speeds.iter().max_by_key(|speed| speed.at.start);
    Fault::at(last.map_or(0..0, |last| last.at.clone()), title, "the last of them", more)
}

/// Returns rates that would complete the independent rows.
fn open_speeds(trace: &Trace<'_>, rows: &[Vec<Sym>], order: &[usize]) -> Vec<String> {
    let n = trace.speeds.len();
    let units = (0..n).map(|i| (0..n).map(|j| if i == j { Sym::ONE } else { Sym::ZERO }).collect());
    let completed: Vec<Vec<Sym>> = rows.iter().cloned().chain(units).collect();
    let pivots = generic_pivots(&completed, order);
    let free = pivots.iter().filter_map(|&(row, _)| row.checked_sub(rows.len()));
    free.map(|speed| format!("`{}`", trace.speeds[speed])).collect()
}

/// Returns the fault of an expression that is not affine in the speeds.
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
