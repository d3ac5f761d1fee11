//! Removes duplicate families of steady motions. A family on which a condition is zero may be the border of a family of another combination of cases,
//! such as the rest position of a mass between two walls.

use super::conditions::Case;
use super::kinks::is_met;
use super::{Family, Member, SteadyMotions};

type Combination = (Vec<Case>, SteadyMotions);

/// Removes a family at the zero of conditions if a family of another combination contains all its members.
pub(super) fn remove_borders(all: &mut [Combination]) {
    let removed: Vec<Vec<bool>> =
        (0..all.len()).map(|at| (0..all[at].1.families.len()).map(|own| is_border(all, (at, own))).collect()).collect();
    for ((_, found), removed) in all.iter_mut().zip(removed) {
        let mut removed = removed.into_iter();
        found.families.retain(|_| !removed.next().unwrap_or(false));
    }
}

fn is_border(all: &[Combination], (at, own): (usize, usize)) -> bool {
    let (cases, found) = &all[at];
    let (family, members) = &found.families[own];
    if family.at_conditions.is_empty() {
        return false;
    }
    all.iter().enumerate().filter(|(other, _)| *other != at).any(|(place, (others, there))| {
        let agrees = |k: usize| cases[k] == others[k] || others[k] == Case::Either || family.at_conditions.contains(&k);
        let agree = (0..cases.len()).all(agrees);
        // of two such families the first is kept
        let comes_first = |other: &Family| other.at_conditions.is_empty() || place < at;
        let holds = |(other, _): &(Family, Vec<Member>)| {
            comes_first(other) && members.iter().all(|member| is_met(there, other, &member.state))
        };
        agree && there.families.iter().any(holds)
    })
}
