//! The orders of a small series: those in full precision by direct evaluation, the others by the cheapest method.

use super::direct::Direct;
use super::factors::{MOST_ORDER, Places};
use super::law::Law;
use super::linearisation::Linearised;
use super::round::rounded;
use super::solving::Solving;
use super::starts::Starts;
use crate::fused::Fused;
use crate::small::permutation::{Permute, Permuted};

/// A law with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<S: Fused, const B: usize, const G: usize> {
    law: Law,
    starts: Starts<S, B>,
    solving: Solving<S, B, G>,
    places: Places<G>,
    orders: Direct<S, B, G>,
    later: Later<B, G>,
}

/// The method for the orders for which the digits of `f64` suffice.
#[derive(Clone, Debug)]
enum Later<const B: usize, const G: usize> {
    /// As the previous orders; the type is `f64`.
    Same,
    /// Direct evaluation of the law in `f64`.
    Direct(Box<Direct<f64, B, G>>),
    /// Linearisation about the expansion point, for laws with solved quantities, whose solution in each order would add
    /// latency.
    Linearised(Box<Linearised<B, G>>),
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    pub(super) fn new(law: &Law) -> Self {
        Kernel {
            law: law.clone(),
            starts: Starts::new(law),
            solving: Solving::new(law),
            places: Places::new(law),
            orders: Direct::new(law),
            later: match law.solved[..] {
                [] if !S::FINER => Later::Same,
                [] => Later::Direct(Box::new(Direct::new(law))),
                _ => Later::Linearised(Box::new(Linearised::new(law))),
            },
        }
    }

    pub(super) fn set(&mut self, values: &[S]) {
        let Kernel { law, starts, solving, orders, later, .. } = self;
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        starts.set(law, value);
        solving.set(values);
        orders.set(law, value);
        match later {
            Later::Same => (),
            Later::Direct(rounded) => rounded.set(law, |number| value(number).rounded()),
            Later::Linearised(linearised) => linearised.set(|number| value(number).rounded()),
        }
    }
}

/// Expands the solution whose first coefficients are in the first row of the series.
pub(super) struct Expand<'a, S: Fused, const B: usize, const G: usize> {
    pub kernel: &'a mut Kernel<S, B, G>,
    pub series: &'a mut [S],
    /// Coefficients above this order need only the digits of `f64`.
    pub fine: usize,
}

impl<S: Fused, const B: usize, const G: usize> Permuted<S> for Expand<'_, S, B, G> {
    #[inline(always)]
    fn run<P: Permute<S> + Permute<f64>>(self, pick: P) {
        let Expand { kernel: Kernel { law, starts, solving, places, orders, later }, series, fine } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let fine = match later {
            Later::Same => order,
            Later::Linearised(_) if !S::FINER => 1,
            _ => fine,
        };
        let (fine, begin) = (fine.min(order), starts.begin(pick, rows));
        let between = if law.solved.is_empty() {
            let begin = orders.begin(pick, begin);
            orders.run(pick, places, None, 0..fine, begin, rows)
        } else {
            let begin = orders.begin(pick, solving.first(pick, &begin));
            if let Later::Linearised(linearised) = later
                && fine < order
            {
                linearised.about(pick, solving);
            }
            orders.run(pick, places, Some(solving), 0..fine, begin, rows)
        };
        match later {
            Later::Direct(rounded) if fine < order => {
                rounded.factors.take(&orders.factors, fine);
                let between = between.rounded::<S, P>(pick);
                rounded.run(pick, places, None, fine..order, between, rows);
            }
            Later::Linearised(linearised) if fine < order => {
                let newest = rounded::<S, P, B>(pick, &between.newest);
                linearised.run(pick, places, &orders.factors, fine..order, newest, rows);
            }
            _ => (),
        }
    }
}
