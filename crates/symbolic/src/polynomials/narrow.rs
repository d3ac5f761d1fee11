//! Few polynomials of few numbers, one number at a time: to begin with registers of eight would take longer than all of it.

use super::blocks::Output;
use super::monomials::Monomials;
use super::parts::Parts;

/// Numbers of an evaluation: inputs, parts, products. What is cleared and not needed costs.
const NUMBERS: usize = 32;
/// With more outputs than that, registers of eight pay.
const OUTPUTS: usize = 4;

/// Products, then sums of multiples of monomials.
#[derive(Clone, Debug)]
pub(super) struct Narrow {
    /// Where each product goes, and the places of its factors.
    products: Vec<[usize; 3]>,
    sums: Vec<Sum>,
    terms: Vec<Term>,
}

/// One output: its constant, and where its terms end.
#[derive(Clone, Copy, Debug)]
struct Sum {
    constant: f64,
    end: usize,
}

/// A multiple of the monomial at a place.
#[derive(Clone, Copy, Debug)]
struct Term {
    place: usize,
    factor: f64,
}

impl Narrow {
    /// Of outputs and monomials so few that this is faster.
    pub fn of(outputs: &[Output], monomials: &Monomials) -> Option<Self> {
        if outputs.len() > OUTPUTS || monomials.end() > NUMBERS {
            return None;
        }
        let mut narrow = Narrow { products: monomials.each_product().collect(), sums: Vec::new(), terms: Vec::new() };
        for output in outputs {
            let known = |(exponents, factor): &(Vec<u32>, f64)| Some((monomials.place(exponents)?, *factor));
            let mut own: Vec<_> = output.iter().filter_map(known).collect();
            own.sort_by_key(|(known, _)| *known);
            narrow
                .terms
                .extend(own.iter().map(|(known, factor)| Term { place: known.place as usize, factor: *factor }));
            narrow.sums.push(Sum { constant: monomials.constant(output), end: narrow.terms.len() });
        }
        Some(narrow)
    }

    /// As [`super::Polynomials::evaluate`].
    #[inline(never)]
    pub fn evaluate(&self, parts: &Parts, inputs: &[f64], outputs: &mut [f64]) {
        let mut values = [0.0; NUMBERS];
        parts.fill_singly(inputs, &mut values);
        for &[place, lower, variable] in &self.products {
            values[place % NUMBERS] = values[lower % NUMBERS] * values[variable % NUMBERS];
        }
        let mut begin = 0;
        for (output, sum) in outputs.iter_mut().zip(&self.sums) {
            *output = sum.constant;
            for term in &self.terms[begin..sum.end] {
                *output += term.factor * values[term.place % NUMBERS];
            }
            begin = sum.end;
        }
    }
}
