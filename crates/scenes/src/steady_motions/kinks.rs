//! Steady motions at the zero of a condition, which the searches on both sides find; they are united.

use super::borders::remove_borders;
use super::conditions::Case;
use super::idle_conditions::join_families;
use super::open_sides::join_regions;
use super::stability::{OnSide, SteadyStability};
use super::{Family, Member, SteadyMotion, SteadyMotions};
use model::Model;

/// Tolerance, relative to the value, for a state at the end of a family.
const NEAR: f64 = 1e-9;

/// Indices of a combination and of one of its motions.
type Place = (usize, usize);

type Combination = (Vec<Case>, SteadyMotions);

/// The combinations of cases with each motion at the zero of a condition listed once: under `Case::Between` if this case was searched, otherwise in
/// a combination of its own.
pub(super) fn joined(model: &Model, mut all: Vec<Combination>) -> Vec<Combination> {
    // a condition that is never `Between` does not make the law jump
    let jumps: Vec<bool> = (0..all.first().map_or(0, |(cases, _)| cases.len()))
        .map(|place| all.iter().any(|(cases, _)| !matches!(cases[place], Case::Holds | Case::Fails)))
        .collect();
    while let Some((places, members)) = meeting(&all) {
        let is_between = |(at, _): &&(usize, usize)| places.iter().any(|&place| !is_side(all[*at].0[place]));
        let kept = members.iter().find(is_between).copied();
        // two opposite conditions have only two sides together
        let cases_there = &all[members[0].0].0;
        let is_around = |cases: &[Case]| {
            (0..cases.len()).all(|place| match places.contains(&place) {
                true => is_side(cases[place]),
                false => cases[place] == cases_there[place],
            })
        };
        let around = all.iter().filter(|(cases, _)| is_around(cases)).count();
        let each: Vec<&SteadyMotion> = members.iter().map(|&(at, own)| &all[at].1.motions[own]).collect();
        let is_whole = members.len() == around && places.iter().all(|&place| !jumps[place]);
        let stability = if is_whole { on_sides(&each) } else { SteadyStability::AtCondition(None) };
        let is_one_law = !matches!(stability, SteadyStability::AtCondition(_)) && !is_kink(&each);
        let examined = members.iter().map(|&(at, _)| all[at].1.examined).sum();
        let (first, own) = members[0];
        let mut cases = all[first].0.clone();
        let place_of = if is_one_law { Case::Either } else { Case::Meeting };
        places.iter().for_each(|&place| cases[place] = place_of);
        let mut motion = all[first].1.motions[own].clone();
        motion.at_conditions.clear();
        motion.stability = stability;
        let alone = all[first].1.alone(motion.clone(), examined);
        for &(at, own) in members.iter().rev() {
            match kept == Some((at, own)) {
                true => all[at].1.motions[own].at_conditions.clear(),
                false => drop(all[at].1.motions.remove(own)),
            }
        }
        if kept.is_none() {
            match all.iter_mut().find(|(own, _)| *own == cases) {
                Some((_, found)) => found.motions.push(motion),
                None => all.push((cases, alone)),
            }
        }
    }
    for motion in all.iter_mut().flat_map(|(_, found)| &mut found.motions) {
        // the stability on the other side of the condition is unknown
        if !motion.at_conditions.is_empty() {
            motion.stability = SteadyStability::AtCondition(None);
        }
    }
    let ends: Vec<Vec<bool>> = all.iter().map(|(cases, found)| ends_of_families(&all, (cases, found))).collect();
    for ((_, found), ends) in all.iter_mut().zip(ends) {
        let mut ends = ends.into_iter();
        found.motions.retain(|_| !ends.next().unwrap_or(false));
    }
    join_families(model, &mut all);
    remove_borders(&mut all);
    join_regions(&mut all, &jumps);
    // a combination without motions is left out if the united combination contains it
    let together: Vec<Vec<Case>> =
        all.iter().map(|(cases, _)| cases.clone()).filter(|cases| cases.contains(&Case::Either)).collect();
    let is_part = |cases: &[Case], whole: &Vec<Case>| {
        whole != cases && cases.iter().zip(whole).all(|(case, whole)| *whole == Case::Either || case == whole)
    };
    all.retain(|(cases, found)| !found.is_empty() || !together.iter().any(|whole| is_part(cases, whole)));
    all
}

/// Whether the law has a kink at a motion found on both sides.
fn is_kink(each: &[&SteadyMotion]) -> bool {
    each.iter().any(|motion| matches!(motion.stability, SteadyStability::AtCondition(_)))
}

/// The stability of a motion at the zero of conditions at which the law is continuous, from the stability on each side.
fn on_sides(each: &[&SteadyMotion]) -> SteadyStability {
    if !is_kink(each) {
        let is_alike = each.iter().all(|motion| motion.at_conditions == each[0].at_conditions);
        return if is_alike { each[0].stability.clone() } else { SteadyStability::AtCondition(None) };
    }
    let side = |motion: &&SteadyMotion| match &motion.stability {
        SteadyStability::AtCondition(side) => *side,
        _ => None,
    };
    let sides: Vec<Option<OnSide>> = each.iter().map(side).collect();
    let falls = sides.iter().flatten().find(|side| side.falls > 0);
    match falls {
        None if sides.iter().all(Option::is_some) => SteadyStability::MinimumOnSides,
        // the two sides of one smooth surface
        Some(side) if sides.len() == 2 && side.is_regular => SteadyStability::FallsOnSide(side.falls),
        _ => SteadyStability::AtCondition(None),
    }
}

/// For each motion of a combination, whether it is at the zero of a condition and belongs to a family of another combination, where it is
/// reported.
fn ends_of_families(all: &[Combination], (cases, found): (&Vec<Case>, &SteadyMotions)) -> Vec<bool> {
    let is_end = |motion: &SteadyMotion| {
        !motion.at_conditions.is_empty()
            && all.iter().any(|(others, there)| {
                let agree = (0..cases.len())
                    .all(|place| cases[place] == others[place] || motion.at_conditions.contains(&place));
                agree
                    && others != cases
                    && there.families.iter().any(|(family, _)| is_met(there, family, &motion.state))
            })
    };
    debug_assert!(found.motions.iter().all(|motion| motion.state.len() == found.state_size));
    found.motions.iter().map(is_end).collect()
}

/// Whether a state belongs to a family or to its closure, by the boxes of its pieces and the undecided boxes next to them.
pub(super) fn is_met(there: &SteadyMotions, family: &Family, state: &[f64]) -> bool {
    let known = there.unknowns.iter().enumerate().filter(|(_, unknown)| unknown.place < there.state_size);
    let known: Vec<(usize, usize)> = known.map(|(own, unknown)| (own, unknown.place)).collect();
    let meets = |at: &[[f64; 2]]| {
        known.iter().all(|&(own, place)| {
            let near = NEAR * (1.0 + state[place].abs());
            at[own][0] <= state[place] + near && state[place] - near <= at[own][1]
        })
    };
    let touches =
        |a: &[[f64; 2]], b: &[[f64; 2]]| known.iter().all(|&(own, _)| a[own][0] <= b[own][1] && b[own][0] <= a[own][1]);
    family.pieces.iter().any(|(_, at)| meets(at))
        || there.undecided.iter().any(|open| meets(open) && family.pieces.iter().any(|(_, at)| touches(at, open)))
}

/// The indices of conditions that are zero at a motion found in several combinations, and its index in each of these, in ascending order.
fn meeting(all: &[Combination]) -> Option<(Vec<usize>, Vec<Place>)> {
    let motions = || {
        all.iter().enumerate().flat_map(|(at, (cases, found))| {
            found.motions.iter().enumerate().map(move |(own, motion)| ((at, own), cases, found, motion))
        })
    };
    motions().filter(|(.., motion)| !motion.at_conditions.is_empty()).find_map(|(first, cases, found, motion)| {
        let mut places = motion.at_conditions.clone();
        let mut members = vec![first];
        for (other, others, found_there, there) in motions().filter(|(other, ..)| other.0 != first.0) {
            let is_open = |place: usize| motion.at_conditions.contains(&place) || there.at_conditions.contains(&place);
            let agree = (0..cases.len()).all(|place| cases[place] == others[place] || is_open(place));
            if agree && is_same((found, motion), (found_there, there)) {
                members.push(other);
                places.extend(&there.at_conditions);
            }
        }
        places.sort_unstable();
        places.dedup();
        members.sort_unstable();
        (members.len() > 1).then_some((places, members))
    })
}

fn is_side(case: Case) -> bool {
    matches!(case, Case::Holds | Case::Fails)
}

/// Whether two motions may be equal, since the enclosures of all coordinates and speeds meet.
fn is_same((found, motion): (&SteadyMotions, &SteadyMotion), (others, other): (&SteadyMotions, &SteadyMotion)) -> bool {
    let ends = |all: &SteadyMotions, of: &SteadyMotion, place: usize| {
        let own = all.unknowns.iter().position(|unknown| unknown.place == place);
        own.map_or([of.state[place]; 2], |own| of.enclosure[own])
    };
    (0..motion.state.len()).all(|place| {
        let ([low, high], [from, to]) = (ends(found, motion, place), ends(others, other, place));
        low <= to && from <= high
    })
}

impl SteadyMotions {
    /// The motions of all combinations with the unknowns that these have in common; fractions of friction and factors of conditions are
    /// removed.
    pub(super) fn united(all: Vec<Combination>) -> Self {
        let mut all = all.into_iter().map(|(_, found)| found.of_state());
        let Some(mut united) = all.next() else { return SteadyMotions::default() };
        for found in all {
            united.motions.extend(found.motions);
            united.families.extend(found.families);
            united.undecided.extend(found.undecided);
            united.regions.extend(found.regions);
            united.undecided_part += found.undecided_part;
            united.elsewhere += found.elsewhere;
            united.examined += found.examined;
            united.free_speeds.retain(|name| found.free_speeds.contains(name));
        }
        united.motions.sort_by(|a, b| {
            let differing = a.state.iter().zip(&b.state).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
            differing.unwrap_or(std::cmp::Ordering::Equal)
        });
        united
    }

    /// The motions without unknowns that are not components of the state.
    fn of_state(mut self) -> Self {
        let is_state: Vec<bool> = self.unknowns.iter().map(|unknown| unknown.place < self.state_size).collect();
        let kept = |ends: &mut Vec<[f64; 2]>| {
            let mut keep = is_state.iter().copied();
            ends.retain(|_| keep.next().unwrap_or(false));
        };
        self.motions.iter_mut().for_each(|motion| kept(&mut motion.enclosure));
        self.families.iter_mut().for_each(|(family, _)| {
            kept(&mut family.hull);
            let mut keep = is_state.iter().copied();
            family.reached.retain(|_| keep.next().unwrap_or(false));
        });
        self.undecided.iter_mut().for_each(kept);
        self.regions.iter_mut().for_each(|region| kept(&mut region.hull));
        self.unknowns.retain(|unknown| unknown.place < self.state_size);
        self
    }

    /// A result of the same search with a single motion.
    fn alone(&self, motion: SteadyMotion, examined: usize) -> Self {
        SteadyMotions { motions: vec![motion], ..self.with_families(Vec::new(), examined) }
    }

    /// A result of the same search with only the given families.
    pub(super) fn with_families(&self, families: Vec<(Family, Vec<Member>)>, examined: usize) -> Self {
        SteadyMotions {
            unknowns: self.unknowns.clone(),
            state_size: self.state_size,
            given: self.given.clone(),
            cyclic: self.cyclic.clone(),
            cyclic_by_values: self.cyclic_by_values.clone(),
            motions: Vec::new(),
            have_potential: self.have_potential,
            are_in_turning_frames: self.are_in_turning_frames,
            families,
            free_speeds: self.free_speeds.clone(),
            undecided: Vec::new(),
            regions: Vec::new(),
            undecided_part: 0.0,
            elsewhere: 0,
            examined,
            singular_places: Vec::new(),
        }
    }
}
