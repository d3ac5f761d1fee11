//! Products of polynomials.

use super::{Budget, Coefficient, Limit, Monomial, Poly, monomial};
use std::cmp::Reverse;

/// The number of products of terms up to which they are sorted; above, equal monomials are found by an array or by
/// hashing.
const SORTED: usize = 1 << 10;

impl<C: Coefficient, const W: usize> Poly<C, W> {
    pub fn times(&self, other: &Self, budget: &Budget) -> Result<Self, Limit> {
        let (short, long) = if self.len() <= other.len() { (self, other) } else { (other, self) };
        budget.spend(short.len() * long.len())?;
        match short.terms.as_slice() {
            [] => return Ok(Self::zero()),
            [(monomial, factor)] => return long.scaled(monomial, factor),
            _ => {}
        }
        if short.len() * long.len() <= SORTED {
            let mut terms = Vec::with_capacity(short.len() * long.len());
            for (a, p) in &short.terms {
                for (b, q) in &long.terms {
                    terms.push((monomial::product(a, b)?, p.times(q)?));
                }
            }
            return Self::collected(terms);
        }
        if let Some(product) = short.dense_product(long) {
            return if product.len() > Budget::TERMS { Err(Limit::Terms) } else { Ok(product) };
        }
        let mut table = Table::new(4 * long.len());
        for (a, p) in &short.terms {
            for (b, q) in &long.terms {
                table.add(monomial::product(a, b)?, p.times(q)?)?;
            }
            if table.terms.len() > Budget::TERMS {
                return Err(Limit::Terms);
            }
        }
        table.terms.retain(|(_, coefficient)| !coefficient.is_zero());
        table.terms.sort_unstable_by_key(|term| Reverse(term.0));
        Ok(Poly { terms: table.terms })
    }
}

/// A hash table of terms by monomial: open addressing, linear probing, at most half full.
struct Table<C, const W: usize> {
    terms: Vec<(Monomial<W>, C)>,
    places: Vec<u32>,
    shift: u32,
}

const FREE: u32 = u32::MAX;

impl<C: Coefficient, const W: usize> Table<C, W> {
    fn new(expected: usize) -> Self {
        let size = (2 * expected).next_power_of_two().max(64);
        Table { terms: Vec::with_capacity(expected), places: vec![FREE; size], shift: 64 - size.trailing_zeros() }
    }

    #[inline]
    fn home(&self, monomial: &Monomial<W>) -> usize {
        let mix = |hash: u64, &word: &u64| (hash.rotate_left(26) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (monomial.iter().fold(0, mix) >> self.shift) as usize
    }

    #[inline]
    fn add(&mut self, monomial: Monomial<W>, coefficient: C) -> Result<(), Limit> {
        let mask = self.places.len() - 1;
        let mut place = self.home(&monomial);
        while self.places[place] != FREE {
            let term = &mut self.terms[self.places[place] as usize];
            if term.0 == monomial {
                term.1 = term.1.plus(&coefficient)?;
                return Ok(());
            }
            place = (place + 1) & mask;
        }
        self.places[place] = self.terms.len() as u32;
        self.terms.push((monomial, coefficient));
        if 2 * self.terms.len() > self.places.len() {
            self.grow();
        }
        Ok(())
    }

    fn grow(&mut self) {
        let size = 2 * self.places.len();
        self.shift -= 1;
        self.places = vec![FREE; size];
        for (number, (monomial, _)) in self.terms.iter().enumerate() {
            let mut place = self.home(monomial);
            while self.places[place] != FREE {
                place = (place + 1) & (size - 1);
            }
            self.places[place] = number as u32;
        }
    }
}
