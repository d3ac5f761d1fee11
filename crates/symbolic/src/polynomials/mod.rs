//! Polynomials in states and circle points, evaluated side by side.
//!
//! A right-hand side and the entries of its Jacobian are sums of multiples of few monomials: f = C m(x) with constant C.
//! Straight-line code has an operation for each term; here eight outputs that stand side by side share one, eight products
//! share one, and a monomial is computed once.

mod blocks;
mod evaluate;
mod monomials;
mod narrow;
mod parts;

use crate::Sym;
use crate::coefficients::coefficients;
use crate::recurrence::Selection;
use blocks::{Blocks, Output};
use evaluate::MOST;
use monomials::Monomials;
use narrow::Narrow;
use parts::Parts;

/// How many numbers stand side by side.
const WIDTH: usize = 8;
/// What it takes to begin with registers so wide, in instructions.
const BEGINNING: usize = 8;

/// Rows of polynomials in the inputs and in circle points, roots and reciprocals of them.
#[derive(Clone, Debug)]
pub struct Polynomials {
    parts: Parts,
    /// Where the products begin: behind whole groups of inputs and parts.
    first: usize,
    /// The factors of eight monomials of degree two and more, each an earlier one and a variable; and how many these are.
    products: Vec<[Selection<WIDTH>; 2]>,
    multiplied: usize,
    blocks: Blocks,
    /// The same one by one, where that is faster.
    narrow: Option<Narrow>,
}

/// Numbers side by side, a register whole.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Lanes([f64; WIDTH]);

impl Polynomials {
    /// From expressions in the inputs, in rows of equal length; `None` where a part has no value, or where there are more
    /// monomials than there is room for.
    pub fn record(inputs: &[Sym], outputs: &[Sym], columns: usize) -> Option<Self> {
        let (parts, others) = Parts::of(inputs, outputs)?;
        let variables = [inputs, &others].concat();
        let mut expanded: Vec<Output> = Vec::new();
        for &output in outputs {
            let terms = coefficients(output, &variables).ok()?.into_iter();
            let value = |(exponents, coefficient): (Vec<u32>, Sym)| {
                let number = coefficient.evaluate_analytic(&|_| None::<f64>).ok();
                Some((exponents, number.filter(|number| number.is_finite())?))
            };
            expanded.push(terms.map(value).collect::<Option<Vec<_>>>()?);
        }
        let occurring = expanded.iter().flatten().map(|(exponents, _)| exponents.as_slice());
        let monomials = Monomials::of(occurring, inputs.len(), others.len());
        if monomials.end() > MOST {
            return None;
        }
        let blocks = Blocks::of(&expanded, columns, &monomials);
        Some(Polynomials {
            parts,
            first: monomials.first(),
            products: monomials.products(),
            multiplied: monomials.each_product().count(),
            blocks,
            narrow: Narrow::of(&expanded, &monomials),
        })
    }

    /// Instructions of one evaluation, what is no polynomial apart: products and sums, each of eight where there are so many.
    pub fn instructions(&self) -> usize {
        let begin = if self.narrow.is_some() { 0 } else { BEGINNING };
        begin + 3 * self.products.len() + self.blocks.terms()
    }

    /// Additions and multiplications of one evaluation, lanes that hold nothing left out; circle points apart.
    pub fn flops(&self) -> usize {
        self.multiplied + self.parts.flops() + self.blocks.flops()
    }
}

#[cfg(test)]
mod tests {
    use super::Polynomials;
    use crate::{Sym, symbols};
    use field::{Analytic, Scalar};

    /// The largest error over the outputs, and how many there are.
    fn off(inputs: &[(Sym, f64)], outputs: &[Sym], columns: usize) -> f64 {
        let (symbols, at): (Vec<Sym>, Vec<f64>) = inputs.iter().copied().unzip();
        let value =
            |name: &str| symbols.iter().zip(&at).find(|(known, _)| **known == Sym::symbol(name)).map(|it| *it.1);
        let Some(polynomials) = Polynomials::record(&symbols, outputs, columns) else { panic!("polynomials") };
        let mut values = vec![f64::NAN; outputs.len()];
        polynomials.evaluate(&at, &mut values);
        let exact = outputs.iter().map(|output| output.evaluate_analytic(&value).unwrap_or(f64::NAN));
        // no number where one of them is none
        exact.zip(&values).fold(0.0, |most, (exact, value)| {
            let error = (value - exact).abs();
            if error <= most { most } else { error }
        })
    }

    #[test]
    fn rows_of_any_length_have_the_values_of_their_expressions() {
        let [x, y, z] = symbols(["x", "y", "z"]);
        let (two, point) = (Sym::int(2), (x / Sym::int(3)).circle());
        let parts = [x * y, z, point.cos * y * y, two, x + point.sin * point.cos, Sym::ZERO, z.powi(5) / two];
        for columns in 1..20 {
            let outputs: Vec<Sym> =
                (0..3 * columns).map(|i| parts[i % 7] - parts[i % 3] * Sym::int(i as i64)).collect();
            assert!(off(&[(x, 0.7), (y, -1.3), (z, 0.4)], &outputs, columns) < 1e-13, "rows of {columns}");
        }
    }

    #[test]
    fn more_variables_than_registers_hold_find_their_factors() {
        for count in [7, 8, 9, 15, 16, 17, 23, 24, 25, 40] {
            let inputs: Vec<(Sym, f64)> =
                (0..count).map(|i| (Sym::symbol(&format!("x{i}")), (1.0 + i as f64).sin())).collect();
            let (first, turned) = (inputs[0].0.circle(), inputs[count - 1].0.circle());
            let each = |i: usize| {
                let (x, y) = (inputs[i].0, inputs[(5 * i + 3) % count].0);
                x * y - Sym::int(i as i64) * x * first.cos + x * y * turned.sin * first.sin
            };
            let outputs: Vec<Sym> = (0..count).map(each).collect();
            assert!(off(&inputs, &outputs, count) < 1e-12, "{count} variables");
        }
    }

    #[test]
    fn what_is_divided_by_and_roots_are_parts() {
        let [x, y] = symbols(["x", "y"]);
        let point = y.circle();
        let divisor = x * x + Sym::int(2) + point.cos;
        let outputs = [x / divisor, y * point.sin / (divisor * divisor), (x * x + y).sqrt() * y, x / (y / divisor + x)];
        assert!(off(&[(x, 0.7), (y, 1.3)], &outputs, 4) < 1e-14);
    }

    #[test]
    fn few_outputs_with_their_products_points_and_fractions_have_the_values_of_their_expressions() {
        let [x, y] = symbols(["x", "y"]);
        let (two, point) = (Sym::int(2), y.circle());
        let alone = x / (x * x + two);
        let all = [alone + y * point.sin, two - x * y, alone * alone - point.cos, x + two * y];
        for count in 1..=4 {
            assert!(off(&[(x, 0.7), (y, -1.3)], &all[..count], count) < 1e-15, "{count} outputs");
        }
    }

    #[test]
    fn what_is_divided_by_two_powers_of_one_input_is_a_product_of_its_reciprocal() {
        let [x, y] = symbols(["x", "y"]);
        let divisor = x * x + Sym::int(2);
        let outputs = [x / divisor, y / (divisor * divisor), y / divisor, x * y, x, y];
        assert!(off(&[(x, 0.7), (y, 1.3)], &outputs, 6) < 1e-15);
    }

    #[test]
    fn what_has_no_value_has_no_polynomials() {
        let [x, y] = symbols(["x", "y"]);
        assert!(Polynomials::record(&[x], &[x * y], 1).is_none());
        assert!(Polynomials::record(&[x], &[x / Sym::ZERO], 1).is_none());
    }
}
