//! The operations of each order for a batch: the plan together with its coefficients.

use super::products::{Factor, Fan, paired};
use super::sums::Rows;
use crate::layout::Implicit;
use crate::linear_equations::{LaneEquations, LinearSeries};
use crate::plan::{Product, Quotient, Slot, Stage};
use field::Batch;

/// The operations of a stage: sums, then products, then the solved quantities.
#[derive(Clone, Debug)]
pub(super) struct Side<const L: usize> {
    pub sums: Rows<L>,
    pub pairs: Vec<Fan<L, 2>>,
    pub alone: Vec<Fan<L, 1>>,
    pub quotients: Vec<Implicit<Batch<L>>>,
    pub roots: Vec<Implicit<Batch<L>>>,
    pub linear: Option<Box<LinearSeries<Batch<L>, LaneEquations<L>>>>,
}

/// The factors of products, numbered, by place.
pub(super) struct Slots {
    pub of: Vec<Option<u16>>,
    pub factors: Vec<Factor>,
}

impl Slots {
    pub fn factor(&mut self, place: Slot) -> Factor {
        let next = self.factors.len() as u16;
        let slot = *self.of[place as usize].get_or_insert(next);
        let factor = Factor { place: place as u16, slot };
        if slot == next {
            self.factors.push(factor);
        }
        factor
    }

    /// Products with a common factor.
    fn fan<const L: usize, const M: usize>(&mut self, products: [Product; M]) -> Fan<L, M> {
        let common = |place: &Slot| products.iter().all(|product| product.a == *place || product.b == *place);
        let Product { a, b, .. } = products[0];
        let one = if common(&a) { a } else { b };
        let other = |product: Product| if product.a == one { product.b } else { product.a };
        Fan {
            places: products.map(|product| product.place as u16),
            one: self.factor(one),
            others: products.map(|product| self.factor(other(product))),
            known: [[Batch::all(0.0); 4]; M],
        }
    }
}

impl<const L: usize> Side<L> {
    pub fn new(stage: &Stage, order: usize, slots: &mut Slots) -> Self {
        let (pairs, alone) = paired(&stage.products);
        let implicit = |place: Slot, of: Slot, above: Option<Slot>| {
            Implicit::new(place as usize, of as usize, above.map(|above| above as usize), order)
        };
        let quotient = |&Quotient { place, above, below }: &Quotient| implicit(place, below, above);
        Side {
            sums: Rows::new(&stage.sums, &stage.sum_places),
            pairs: pairs.into_iter().map(|pair| slots.fan(pair)).collect(),
            alone: alone.into_iter().map(|product| slots.fan([product])).collect(),
            quotients: stage.quotients.iter().map(quotient).collect(),
            roots: stage.roots.iter().map(|&(place, of)| implicit(place, of, None)).collect(),
            linear: stage.linear.as_ref().map(|linear| {
                let factors = LaneEquations::new(&linear.pattern);
                Box::new(LinearSeries::new(linear, order, factors, |place| place as usize))
            }),
        }
    }
}
