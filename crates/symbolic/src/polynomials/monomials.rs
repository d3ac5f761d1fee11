//! Monomials, by eights that can be multiplied at once.

use super::WIDTH;
use super::blocks::Output;
use super::parts::Parts;
use crate::recurrence::Selection;
use std::collections::{BTreeMap, BTreeSet};

/// The monomials that occur, each with its place among the numbers of an evaluation: the variables have theirs, products
/// come behind them.
pub(super) struct Monomials {
    known: BTreeMap<Vec<u32>, Known>,
    /// The factors of eight products.
    groups: Vec<Vec<[u32; 2]>>,
    first: usize,
}

/// Where a monomial stands. What waits for a part of the inputs is added last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Known {
    late: bool,
    pub place: u32,
}

impl Monomials {
    /// Of these exponents: of so many inputs, then of so many parts.
    pub fn of<'a>(occurring: impl Iterator<Item = &'a [u32]>, inputs: usize, parts: usize) -> Self {
        let is_late = |exponents: &[u32]| exponents[inputs..].iter().any(|exponent| *exponent > 0);
        let degree = |exponents: &[u32]| exponents.iter().sum::<u32>();
        let begin = Parts::first(inputs);
        let variables: Vec<usize> = (0..inputs).chain(begin..begin + parts).collect();
        let first = (begin + parts).next_multiple_of(WIDTH);
        // whatever waits for nothing comes first; a factor is of a lower degree
        let mut classes: BTreeMap<(bool, u32), BTreeSet<Vec<u32>>> = BTreeMap::new();
        for exponents in occurring {
            let mut exponents = exponents.to_vec();
            while degree(&exponents) > 1 {
                let class = classes.entry((is_late(&exponents), degree(&exponents))).or_default();
                let (lower, _) = factors(&exponents);
                class.insert(std::mem::replace(&mut exponents, lower));
            }
        }
        let single = |number: usize| (0..variables.len()).map(|each| u32::from(each == number)).collect();
        let mut known: BTreeMap<Vec<u32>, Known> = variables
            .iter()
            .enumerate()
            .map(|(number, &place)| (single(number), Known { late: number >= inputs, place: place as u32 }))
            .collect();
        let mut groups = Vec::new();
        for ((late, _), class) in classes {
            let class: Vec<Vec<u32>> = class.into_iter().collect();
            for eight in class.chunks(WIDTH) {
                let group = eight.iter().filter_map(|exponents| {
                    let (lower, variable) = factors(exponents);
                    Some([known.get(&lower)?.place, variables[variable] as u32])
                });
                let group: Vec<[u32; 2]> = group.collect();
                let begin = first + groups.len() * WIDTH;
                let places = eight.iter().zip(begin..);
                known.extend(places.map(|(own, place)| (own.clone(), Known { late, place: place as u32 })));
                groups.push(group);
            }
        }
        Monomials { known, groups, first }
    }

    /// `None` of the constant.
    pub fn place(&self, exponents: &[u32]) -> Option<Known> {
        self.known.get(exponents).copied()
    }

    /// The constant term of an output.
    pub fn constant(&self, output: &Output) -> f64 {
        let constants = output.iter().filter(|(exponents, _)| self.place(exponents).is_none());
        constants.map(|(_, value)| *value).sum()
    }

    /// Where products begin.
    pub fn first(&self) -> usize {
        self.first
    }

    /// Behind the last place.
    pub fn end(&self) -> usize {
        self.first + self.groups.len() * WIDTH
    }

    /// Each product: where it stands, and where its factors do.
    pub fn each_product(&self) -> impl Iterator<Item = [usize; 3]> {
        let begin = |number: usize| self.first + number * WIDTH;
        let groups = self.groups.iter().enumerate();
        groups.flat_map(move |(number, group)| {
            group.iter().zip(begin(number)..).map(|([a, b], place)| [place, *a as usize, *b as usize])
        })
    }

    /// The factors of all products; where eight are not full the last one is repeated.
    pub fn products(&self) -> Vec<[Selection<WIDTH>; 2]> {
        let side = |group: &[[u32; 2]], side: usize| {
            let own = |lane: usize| group.get(lane).or(group.last()).map_or(0, |factors| factors[side] as u16);
            Selection::new(std::array::from_fn(own))
        };
        self.groups.iter().map(|group| [side(group, 0), side(group, 1)]).collect()
    }
}

/// The exponents without one of the last variable, and that.
fn factors(exponents: &[u32]) -> (Vec<u32>, usize) {
    let last = exponents.iter().rposition(|exponent| *exponent > 0).unwrap_or(0);
    let mut lower = exponents.to_vec();
    lower[last] = lower[last].saturating_sub(1);
    (lower, last)
}
