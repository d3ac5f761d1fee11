//! Conditions that do not influence the law, given the cases of other conditions, such as the sign of x within a backlash |x| < e. The law has no
//! kink at their zeros, and steady motions of both sides are joined.

use super::conditions::Case;
use super::differentiability::Sides;
use super::families::Family;
use super::{Member, SteadyMotions};
use model::Model;
use model::equations::vanishes;

type Combination = (Vec<Case>, SteadyMotions);

/// Whether the law is equal on both sides of the conditions with the given indices; the other conditions have their cases.
pub(super) fn is_one_law(model: &Model, cases: &[Case], places: &[usize]) -> bool {
    let is_condition = places.iter().all(|&place| place < model.switches.len());
    is_condition && symbolic::apart(|| does_not_hold(model, cases, places))
}

fn does_not_hold(model: &Model, cases: &[Case], places: &[usize]) -> bool {
    let Some(Sides { rows, letters, .. }) = Sides::of(model, cases, places) else { return false };
    letters.iter().all(|letter| rows.iter().all(|row| vanishes(row.diff(*letter))))
}

/// Joins families that meet at the zero of a condition that does not influence the law there.
pub(super) fn join_families(model: &Model, all: &mut Vec<Combination>) {
    while let Some(Meeting { places, sides: [(first, own), (second, other)] }) = meeting(model, all) {
        let examined = all[first].1.examined + all[second].1.examined;
        let beside = all[second].1.families.remove(other);
        let joined = joined(all[first].1.families.remove(own), beside);
        let mut cases = all[first].0.clone();
        places.iter().for_each(|&place| cases[place] = Case::Either);
        match all.iter_mut().find(|(known, _)| *known == cases) {
            Some((_, found)) => found.families.push(joined),
            None => {
                let alone = all[first].1.with_families(vec![joined], examined);
                all.push((cases, alone));
            }
        }
    }
}

/// Two families of different combinations that meet: the conditions in which these differ, and for each side the indices of combination and
/// family.
struct Meeting {
    places: Vec<usize>,
    sides: [(usize, usize); 2],
}

fn meeting(model: &Model, all: &[Combination]) -> Option<Meeting> {
    for (second, (others, there)) in all.iter().enumerate() {
        for (first, (cases, found)) in all[..second].iter().enumerate() {
            let places: Vec<usize> = (0..cases.len()).filter(|&place| cases[place] != others[place]).collect();
            let are_sides = places.iter().all(|&place| is_side(cases[place]) && is_side(others[place]));
            if !are_sides || found.unknowns != there.unknowns {
                continue;
            }
            let touching = (0..found.families.len())
                .flat_map(|own| (0..there.families.len()).map(move |other| (own, other)))
                .find(|&(own, other)| found.families[own].0.touches(&there.families[other].0));
            if let Some((own, other)) = touching.filter(|_| is_one_law(model, cases, &places)) {
                return Some(Meeting { places, sides: [(first, own), (second, other)] });
            }
        }
    }
    None
}

fn is_side(case: Case) -> bool {
    matches!(case, Case::Holds | Case::Fails)
}

fn joined((family, mut members): (Family, Vec<Member>), (other, more): (Family, Vec<Member>)) -> (Family, Vec<Member>) {
    members.extend(more);
    (family.joined(other), members)
}
