//! Ideal membership: an expression that is a polynomial combination of others vanishes wherever they do.

use crate::polynomial_terms::{Terms, product, terms};
use algebra::linear::nonnegative_combination;
use field::Rational;
use std::collections::BTreeSet;
use symbolic::{Hypotheses, Sym, normal};

/// The largest number of expressions; [`MOST_PRODUCTS`]: of their products with monomials.
const MOST_ZEROS: usize = 6;
const MOST_PRODUCTS: usize = 120;

/// The letters of a monomial that never vanishes and whose product with the expression is a combination of the others; `None` if none is found.
pub(crate) fn combination(target: Sym, zeros: &[Sym], is_apart: &dyn Fn(Sym) -> bool) -> Option<Vec<Sym>> {
    if zeros.len() > MOST_ZEROS {
        return None;
    }
    let numerator = |of: Sym| normal(of, &Hypotheses::none()).ok().map(|form| form.numerator());
    let target = numerator(target)?;
    let zeros = zeros.iter().map(|zero| numerator(*zero)).collect::<Option<Vec<Sym>>>()?;
    let mut leaves: Vec<Sym> = [&[target], &zeros[..]].concat().into_iter().flat_map(Sym::leaves_of).collect();
    leaves.retain(|leaf| leaf.as_constant().is_none());
    leaves.sort_unstable();
    leaves.dedup();
    let target = terms(target, &leaves)?;
    let zeros = zeros.into_iter().map(|zero| terms(zero, &leaves)).collect::<Option<Vec<Terms>>>()?;
    let one = Rational::new(1, 1);
    let monomial = |powers: Vec<u32>| Terms::from([(powers, one)]);
    // monomials with which a term of the target becomes a multiple of a term of the others
    let lacking = ratios(&zeros, std::slice::from_ref(&target));
    let unit = vec![0; leaves.len()];
    let is_free = |powers: &Vec<u32>| leaves.iter().zip(powers).all(|(leaf, power)| *power == 0 || is_apart(*leaf));
    std::iter::once(unit).chain(lacking.into_iter().filter(is_free)).find_map(|by| {
        let multiple = product(&target, &monomial(by.clone()))?;
        let factors = ratios(&[std::slice::from_ref(&multiple), &zeros[..]].concat(), &zeros);
        let products = zeros.iter().flat_map(|zero| {
            factors.iter().filter_map(|powers| product(zero, &monomial(powers.clone()))).collect::<Vec<Terms>>()
        });
        let products: Vec<Terms> = products.take(MOST_PRODUCTS).collect();
        is_sum(&multiple, &products)
            .then(|| leaves.iter().zip(&by).filter(|(_, power)| **power > 0).map(|(leaf, _)| *leaf).collect())
    })
}

/// Monomials that are quotients of a term of one list and a term of the other, with negative exponents replaced by zero.
fn ratios(above: &[Terms], below: &[Terms]) -> BTreeSet<Vec<u32>> {
    let keys = |all: &[Terms]| all.iter().flat_map(|each| each.keys().cloned()).collect::<BTreeSet<Vec<u32>>>();
    let (above, below) = (keys(above), keys(below));
    let ratio = |a: &Vec<u32>, b: &Vec<u32>| a.iter().zip(b).map(|(a, b)| a.saturating_sub(*b)).collect::<Vec<u32>>();
    above.iter().flat_map(|a| below.iter().map(move |b| ratio(a, b))).collect()
}

/// Whether a polynomial is a linear combination of others with numerical coefficients.
fn is_sum(target: &Terms, products: &[Terms]) -> bool {
    let zero = Rational::new(0, 1);
    let monomials: BTreeSet<&Vec<u32>> = products.iter().chain([target]).flat_map(|each| each.keys()).collect();
    let column =
        |each: &Terms| monomials.iter().map(|powers| each.get(*powers).copied().unwrap_or(zero)).collect::<Vec<_>>();
    let both = products.iter().flat_map(|each| {
        let column = column(each);
        let opposite = column.iter().map(|value| -*value).collect();
        [column, opposite]
    });
    nonnegative_combination(&both.collect::<Vec<_>>(), &column(target)).is_some()
}
