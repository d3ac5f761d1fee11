//! What is computed for each order, readied for lanes: the plan with its coefficients beside it.

use crate::recurrence::layout::Implicit;
use crate::recurrence::plan::{Place, Stage, Sums};
use field::Lanes;

/// Sums, then products, then what is solved for.
#[derive(Clone, Debug)]
pub(super) struct Side<const L: usize> {
    pub sums: Rows<L>,
    /// Which quantities are factors that are known by now, and where their series are.
    pub factors: Vec<(u16, u16)>,
    pub products: Vec<Product<L>>,
    pub reciprocals: Vec<Implicit<Lanes<L>>>,
    pub roots: Vec<Implicit<Lanes<L>>>,
}

/// The product of two factors, and what is known of its next order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Product<const L: usize> {
    pub place: u16,
    pub a: u16,
    pub b: u16,
    pub next: Lanes<L>,
}

/// Sums one after the other: where each goes and of how many terms it is made.
#[derive(Clone, Debug)]
pub(super) struct Rows<const L: usize> {
    rows: Vec<(u16, u16)>,
    constants: Vec<Lanes<L>>,
    /// What is added, and how often.
    places: Vec<u16>,
    times: Vec<Lanes<L>>,
    /// Which coefficients these are.
    constant_of: Vec<Option<u32>>,
    times_of: Vec<u32>,
}

/// Places for the series of factors.
pub(super) struct Slots {
    pub of: Vec<Option<u16>>,
    pub next: usize,
}

impl<const L: usize> Side<L> {
    pub fn new(stage: &Stage, order: usize, slots: &mut Slots) -> Self {
        let mut factors = Vec::new();
        let mut slot = |place: Place| {
            *slots.of[place as usize].get_or_insert_with(|| {
                let slot = slots.next as u16;
                slots.next += 1;
                factors.push((place as u16, slot));
                slot
            })
        };
        let products = stage.products.iter();
        let products = products.map(|product| Product {
            place: product.place as u16,
            a: slot(product.a),
            b: slot(product.b),
            next: Lanes::all(0.0),
        });
        let products = products.collect();
        let implicit = |pairs: &[(Place, Place)]| {
            let one = |&(place, of): &(Place, Place)| Implicit {
                column: place as usize,
                of: of as usize,
                series: vec![[Lanes::all(0.0); 2]; order + 1],
            };
            pairs.iter().map(one).collect()
        };
        let (reciprocals, roots) = (implicit(&stage.reciprocals), implicit(&stage.roots));
        Side { sums: Rows::new(&stage.sums, &stage.sum_places), factors, products, reciprocals, roots }
    }
}

impl<const L: usize> Rows<L> {
    pub fn new(sums: &Sums, places: &[Place]) -> Self {
        let mut terms = sums.terms.clone();
        terms.sort_by_key(|(row, ..)| *row);
        let count = |row: u32| terms.iter().filter(|term| term.0 == row).count() as u16;
        let constant = |row: u32| sums.constants.iter().find(|constant| constant.0 == row).map(|constant| constant.1);
        let numbers = 0..sums.rows as u32;
        Rows {
            rows: numbers.clone().zip(places).map(|(row, place)| (*place as u16, count(row))).collect(),
            constants: vec![Lanes::all(0.0); sums.rows],
            places: terms.iter().map(|term| term.1 as u16).collect(),
            times: vec![Lanes::all(0.0); terms.len()],
            constant_of: numbers.map(constant).collect(),
            times_of: terms.iter().map(|term| term.2).collect(),
        }
    }

    pub fn set(&mut self, lane: usize, values: &[f64]) {
        let constants = self.constants.iter_mut().zip(&self.constant_of).filter_map(|(to, of)| Some((to, (*of)?)));
        for (to, of) in self.times.iter_mut().zip(self.times_of.iter().copied()).chain(constants) {
            to.0[lane] = values.get(of as usize).copied().unwrap_or(0.0);
        }
    }

    /// Each sum of order k, given to `put` with its place.
    #[inline(always)]
    pub fn sums<const FUSED: bool, const N: usize>(
        &self,
        k: usize,
        now: &mut [Lanes<L>; N],
        mut put: impl FnMut(&mut [Lanes<L>; N], usize, Lanes<L>),
    ) {
        let (mut places, mut times) = (&self.places[..], &self.times[..]);
        for ((place, count), constant) in self.rows.iter().zip(&self.constants) {
            let mut sum = if k == 0 { *constant } else { Lanes::all(0.0) };
            let (own, more) = places.split_at(usize::from(*count).min(places.len()));
            let (own_times, more_times) = times.split_at(usize::from(*count).min(times.len()));
            for (of, often) in own.iter().zip(own_times) {
                sum = sum.plus_product(now[usize::from(*of) % N], *often, FUSED);
            }
            (places, times) = (more, more_times);
            put(now, usize::from(*place) % N, sum);
        }
    }
}
