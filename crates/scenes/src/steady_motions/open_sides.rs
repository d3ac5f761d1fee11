//! Undecided regions on both sides of the zero of a condition, which are united.

use super::conditions::Case;
use super::{Region, SteadyMotions};

type Combination = (Vec<Case>, SteadyMotions);

/// Regions touch if their distance is below this tolerance, in SI units and relative to the values.
const NEAR: f64 = 1e-9;

/// Unites undecided regions that touch at the zero of a condition at which the law does not jump.
pub(super) fn join_regions(all: &mut Vec<Combination>, jumps: &[bool]) {
    while let Some(Meeting { places, sides }) = meeting(all, jumps) {
        let examined = sides.iter().map(|(at, _)| all[*at].1.examined).sum();
        let (mut cases, alone) = (all[sides[0].0].0.clone(), all[sides[0].0].1.with_families(Vec::new(), examined));
        places.iter().for_each(|&place| cases[place] = Case::Either);
        let [first, second] = sides.map(|(at, own)| all[at].1.without_region(own));
        let target = match all.iter().position(|(known, _)| *known == cases) {
            Some(known) => known,
            None => {
                all.push((cases, alone));
                all.len() - 1
            }
        };
        let found = &mut all[target].1;
        found.regions.push(joined(first.0, second.0));
        found.undecided.extend(first.1.into_iter().chain(second.1));
        found.undecided_part = found.part();
    }
}

/// Two touching regions of different combinations: the conditions in which these differ, and for each side the indices of combination and region.
struct Meeting {
    places: Vec<usize>,
    sides: [(usize, usize); 2],
}

fn meeting(all: &[Combination], jumps: &[bool]) -> Option<Meeting> {
    for (second, (others, there)) in all.iter().enumerate() {
        for (first, (cases, found)) in all[..second].iter().enumerate() {
            let places: Vec<usize> = (0..cases.len()).filter(|&place| cases[place] != others[place]).collect();
            let is_side = |case: Case| matches!(case, Case::Holds | Case::Fails);
            let are_sides =
                places.iter().all(|&place| is_side(cases[place]) && is_side(others[place]) && !jumps[place]);
            if !are_sides || found.unknowns != there.unknowns {
                continue;
            }
            let pairs = (0..found.regions.len())
                .flat_map(|own| (0..there.regions.len()).map(move |other| (own, other)))
                .find(|&(own, other)| touch(&found.regions[own], &there.regions[other]));
            if let Some((own, other)) = pairs {
                return Some(Meeting { places, sides: [(first, own), (second, other)] });
            }
        }
    }
    None
}

fn touch(one: &Region, other: &Region) -> bool {
    one.hull.iter().zip(&other.hull).all(|(one, other)| {
        let near = NEAR * (1.0 + one[0].abs().max(one[1].abs()));
        one[0] <= other[1] + near && other[0] <= one[1] + near
    })
}

fn joined(one: Region, other: Region) -> Region {
    let both = |([a, b], [c, d]): (&[f64; 2], &[f64; 2])| [a.min(*c), b.max(*d)];
    Region {
        hull: one.hull.iter().zip(&other.hull).map(both).collect(),
        boxes: one.boxes + other.boxes,
        near: one.near.max(other.near),
        holds_one: one.holds_one || other.holds_one,
    }
}

impl SteadyMotions {
    /// Removes a region and its boxes, and returns both.
    fn without_region(&mut self, own: usize) -> (Region, Vec<Vec<[f64; 2]>>) {
        let region = self.regions.remove(own);
        let is_in =
            |at: &Vec<[f64; 2]>| at.iter().zip(&region.hull).all(|(at, hull)| hull[0] <= at[0] && at[1] <= hull[1]);
        let (taken, left) = std::mem::take(&mut self.undecided).into_iter().partition(is_in);
        self.undecided = left;
        self.undecided_part = self.part();
        self.elsewhere += taken.len();
        (region, taken)
    }

    /// The volume of undecided boxes as a fraction of the searched box.
    fn part(&self) -> f64 {
        let share = |(at, unknown): (&[f64; 2], &super::Unknown)| (at[1] - at[0]) / unknown.range.interval().width();
        let volume = |at: &Vec<[f64; 2]>| at.iter().zip(&self.unknowns).map(share).product::<f64>();
        self.undecided.iter().map(volume).sum::<f64>().clamp(0.0, 1.0)
    }
}
