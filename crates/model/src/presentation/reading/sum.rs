//! Sums of monomials times cosines and sines of multiple angles.

use super::harmonic::{Harmonic, Multiple};
use field::Rational;
use num_traits::Zero;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// (index of the symbol, nonzero exponent), sorted by index.
pub(super) type Monomial = Vec<(u32, i32)>;

/// A cosine or sine of an angle; the cosine of the empty angle is one.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Wave {
    pub angle: Vec<(u32, Multiple)>,
    pub is_sine: bool,
}

/// A term of a sum: coefficient times monomial times wave.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub monomial: Monomial,
    pub wave: Wave,
    pub coefficient: Rational,
}

/// A sum of terms. Equal terms are collected, and no coefficient is zero.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum(BTreeMap<(Monomial, Wave), Rational>);

impl Sum {
    pub fn constant(value: Rational) -> Self {
        Sum::of(Term { monomial: Vec::new(), wave: Wave::default(), coefficient: value })
    }

    pub fn letter(place: u32) -> Self {
        let one = Rational::new(1, 1);
        Sum::of(Term { monomial: vec![(place, 1)], wave: Wave::default(), coefficient: one })
    }

    pub fn circle(harmonic: Harmonic, is_sine: bool) -> Self {
        let sign = if is_sine && harmonic.is_turned { -1 } else { 1 };
        let mut sum = Sum::default();
        sum.add_wave(Vec::new(), harmonic, is_sine, Rational::new(sign, 1));
        sum
    }

    pub fn of(term: Term) -> Self {
        let mut sum = Sum::default();
        sum.add(term.monomial, term.wave, term.coefficient);
        sum
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn terms(&self) -> impl Iterator<Item = Term> {
        self.0.iter().map(|((monomial, wave), coefficient)| Term {
            monomial: monomial.clone(),
            wave: wave.clone(),
            coefficient: *coefficient,
        })
    }

    pub fn monomials(&self) -> impl Iterator<Item = &Monomial> {
        self.0.keys().map(|(monomial, _)| monomial)
    }

    fn add(&mut self, monomial: Monomial, wave: Wave, coefficient: Rational) {
        match self.0.entry((monomial, wave)) {
            Entry::Vacant(_) if coefficient.is_zero() => {}
            Entry::Vacant(free) => drop(free.insert(coefficient)),
            Entry::Occupied(mut known) => {
                *known.get_mut() += coefficient;
                if known.get().is_zero() {
                    known.remove();
                }
            }
        }
    }

    /// Adds a cosine or sine; the sine of the empty angle is zero.
    fn add_wave(&mut self, monomial: Monomial, harmonic: Harmonic, is_sine: bool, coefficient: Rational) {
        if !(is_sine && harmonic.multiples.is_empty()) {
            self.add(monomial, Wave { angle: harmonic.multiples, is_sine }, coefficient);
        }
    }

    /// Returns this sum plus `times` times the other.
    pub fn plus(&self, other: &Sum, times: i64) -> Self {
        let mut sum = self.clone();
        for ((monomial, wave), coefficient) in &other.0 {
            sum.add(monomial.clone(), wave.clone(), *coefficient * Rational::new(times, 1));
        }
        sum
    }

    /// Returns the product of two sums; `None` if it has more than `most` terms.
    pub fn times(&self, other: &Sum, most: usize) -> Option<Self> {
        if self.len().saturating_mul(other.len()) > 50 * most {
            return None;
        }
        let (mut product, half) = (Sum::default(), Rational::new(1, 2));
        for ((one, first), a) in &self.0 {
            for ((other, second), b) in &other.0 {
                let (monomial, coefficient) = (multiplied(one, other), *a * *b);
                if first.angle.is_empty() {
                    product.add(monomial, second.clone(), coefficient);
                    continue;
                }
                if second.angle.is_empty() {
                    product.add(monomial, first.clone(), coefficient);
                    continue;
                }
                let added = Harmonic::combined(&first.angle, &second.angle, 1)?;
                let parted = Harmonic::combined(&first.angle, &second.angle, -1)?;
                let turned = |harmonic: &Harmonic| Rational::new(if harmonic.is_turned { -1 } else { 1 }, 1);
                let (plus, minus) = (half * coefficient, -(half * coefficient));
                // cos cos and sin sin give cosines; sin a cos b = (sin(a + b) + sin(a - b))/2; cos a sin b = (sin(a + b) - sin(a - b))/2
                let (is_sine, of_sum, of_difference) = match (first.is_sine, second.is_sine) {
                    (false, false) => (false, plus, plus),
                    (true, true) => (false, minus, plus),
                    (true, false) => (true, plus * turned(&added), plus * turned(&parted)),
                    (false, true) => (true, plus * turned(&added), minus * turned(&parted)),
                };
                product.add_wave(monomial.clone(), added, is_sine, of_sum);
                product.add_wave(monomial, parted, is_sine, of_difference);
            }
        }
        (product.len() <= most).then_some(product)
    }

    /// Returns the reciprocal of a single term without an angle; `None` for other sums.
    pub fn inverse(&self) -> Option<Self> {
        let (mut terms, one) = (self.terms(), Rational::new(1, 1));
        let only = terms.next().filter(|only| only.wave.angle.is_empty())?;
        if terms.next().is_some() {
            return None;
        }
        let monomial = only.monomial.iter().map(|(place, exponent)| (*place, -exponent)).collect();
        Some(Sum::of(Term { monomial, coefficient: one / only.coefficient, wave: Wave::default() }))
    }

    /// Returns the square root of a single term that is the square of positive symbols; `None` for other sums.
    pub fn root(&self, is_positive: impl Fn(u32) -> bool) -> Option<Self> {
        let mut terms = self.terms();
        let only = terms.next().filter(|only| only.wave.angle.is_empty())?;
        let is_square = only.monomial.iter().all(|&(place, exponent)| exponent % 2 == 0 && is_positive(place));
        if terms.next().is_some() || !is_square {
            return None;
        }
        let root = field::Analytic::sqrt(symbolic::Sym::constant(only.coefficient)).as_constant()?;
        let monomial = only.monomial.iter().map(|(place, exponent)| (*place, exponent / 2)).collect();
        root.is_defined().then(|| Sum::of(Term { monomial, coefficient: root, wave: Wave::default() }))
    }
}

fn multiplied(a: &Monomial, b: &Monomial) -> Monomial {
    let mut product = a.clone();
    for &(place, exponent) in b {
        match product.binary_search_by_key(&place, |(known, _)| *known) {
            Ok(at) => product[at].1 += exponent,
            Err(at) => product.insert(at, (place, exponent)),
        }
    }
    product.retain(|(_, exponent)| *exponent != 0);
    product
}
