//! Polynomials in states and circle points, evaluated side by side.
//!
//! The entries of a Jacobian are sums of multiples of few monomials: f' = C m(x) with constant C. Straight-line code has
//! an operation for each term; here eight entries that stand side by side share one, and a monomial is computed once.

use crate::coefficients::{NotPolynomial, coefficients};
use crate::graph::Node;
use crate::tape::Program;
use crate::{Sym, Tape};
use pulp::{Arch, Simd, WithSimd};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// How many outputs are computed side by side.
const WIDTH: usize = 8;

/// Rows of polynomials in the inputs, and in cosines and sines of expressions in the inputs.
#[derive(Clone, Debug)]
pub struct Polynomials {
    inputs: usize,
    /// The cosines and sines that occur.
    points: Tape,
    /// Monomials of degree two and more, each a product of an earlier one and a variable; 1 and the variables come before.
    products: Vec<[u32; 2]>,
    blocks: Vec<Block>,
    /// Of all blocks: the monomials, and their coefficients in each output.
    terms: Vec<u32>,
    factors: Vec<Lanes>,
}

/// Eight outputs, from one on; the end of a row may reach into the next, which is written after it.
#[derive(Clone, Debug)]
struct Block {
    first: usize,
    constants: Lanes,
    /// Where its terms end.
    end: usize,
}

/// Numbers side by side, a register whole.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Lanes([f64; WIDTH]);

impl Polynomials {
    /// From expressions in the inputs, in rows of equal length.
    ///
    /// # Errors
    /// [`NotPolynomial`] names a part that is a quotient, a root or a function, or has no value.
    pub fn record(inputs: &[Sym], outputs: &[Sym], columns: usize) -> Result<Self, NotPolynomial> {
        let is_point = |each: &Sym| matches!(each.node(), Node::Cos(_) | Node::Sin(_));
        let points: Vec<Sym> = Sym::ascending(outputs).into_iter().filter(is_point).collect();
        let variables: Vec<Sym> = inputs.iter().chain(&points).copied().collect();
        let mut monomials = Monomials::new(variables.len());
        let (mut blocks, mut terms, mut factors) = (Vec::new(), Vec::new(), Vec::new());
        for (row, expressions) in outputs.chunks(columns.max(1)).enumerate() {
            for (place, eight) in expressions.chunks(WIDTH).enumerate() {
                let mut lanes: BTreeMap<u32, Lanes> = BTreeMap::new();
                for (lane, &expression) in eight.iter().enumerate() {
                    for (exponents, coefficient) in coefficients(expression, &variables)? {
                        let value = coefficient.evaluate_analytic(&|_| None::<f64>);
                        let value = value.map_err(|_| NotPolynomial(coefficient))?;
                        let place = monomials.place(&exponents);
                        lanes.entry(place).or_insert(Lanes([0.0; WIDTH])).0[lane] = value;
                    }
                }
                let constants = lanes.remove(&0).unwrap_or(Lanes([0.0; WIDTH]));
                terms.extend(lanes.keys());
                factors.extend(lanes.values());
                blocks.push(Block { first: row * columns + place * WIDTH, constants, end: terms.len() });
            }
        }
        let points = Tape::record(inputs, &points).map_err(|_| NotPolynomial(Sym::UNDEFINED))?;
        Ok(Polynomials { inputs: inputs.len(), points, products: monomials.products, blocks, terms, factors })
    }

    /// Additions and multiplications of one evaluation, lanes that hold nothing left out; circle points apart.
    pub fn flops(&self) -> usize {
        let filled = |lanes: &Lanes| lanes.0.iter().filter(|value| **value != 0.0).count();
        self.products.len() + self.points.flops() + self.factors.iter().map(|lanes| 2 * filled(lanes)).sum::<usize>()
    }

    /// Ready for evaluation, with room for the monomials.
    pub fn ready(&self) -> Evaluation<'_> {
        let variables = self.inputs + self.points.outputs();
        let mut values = vec![0.0; 1 + variables + self.products.len()];
        values[0] = 1.0;
        Evaluation { polynomials: self, points: self.points.over(), values, arch: Arch::new() }
    }
}

/// Monomials by their exponents.
struct Monomials {
    variables: usize,
    products: Vec<[u32; 2]>,
    known: FxHashMap<Vec<u32>, u32>,
}

impl Monomials {
    fn new(variables: usize) -> Self {
        Monomials { variables, products: Vec::new(), known: FxHashMap::default() }
    }

    /// 0 for the constant, then the variables, then the products.
    fn place(&mut self, exponents: &[u32]) -> u32 {
        let Some(last) = exponents.iter().rposition(|exponent| *exponent > 0) else { return 0 };
        if let Some(&known) = self.known.get(exponents) {
            return known;
        }
        let mut rest = exponents.to_vec();
        rest[last] -= 1;
        let place = match self.place(&rest) {
            0 => last as u32 + 1,
            lower => {
                self.products.push([lower, last as u32 + 1]);
                (self.variables + self.products.len()) as u32
            }
        };
        self.known.insert(exponents.to_vec(), place);
        place
    }
}

/// Polynomials with their monomials: evaluation allocates nothing.
#[derive(Clone, Debug)]
pub struct Evaluation<'a> {
    polynomials: &'a Polynomials,
    points: Program<'a, f64>,
    /// 1, the inputs, the circle points, the products.
    values: Vec<f64>,
    arch: Arch,
}

impl Evaluation<'_> {
    /// The outputs at the inputs, row after row; inputs that are missing stay what they were, and of the outputs as
    /// many are written as there is room for.
    pub fn evaluate(&mut self, inputs: &[f64], outputs: &mut [f64]) {
        let Polynomials { inputs: count, products, .. } = self.polynomials;
        for (value, input) in self.values[1..=*count].iter_mut().zip(inputs) {
            *value = *input;
        }
        let variables = count + self.polynomials.points.outputs();
        self.points.evaluate(inputs, &mut self.values[1 + count..=variables]);
        for (place, [a, b]) in products.iter().enumerate() {
            self.values[1 + variables + place] = self.values[*a as usize] * self.values[*b as usize];
        }
        self.arch.dispatch(Combine { polynomials: self.polynomials, values: &self.values, outputs });
    }
}

struct Combine<'a> {
    polynomials: &'a Polynomials,
    values: &'a [f64],
    outputs: &'a mut [f64],
}

impl WithSimd for Combine<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Polynomials { blocks, terms, factors, .. } = self.polynomials;
        let mut begin = 0;
        for block in blocks {
            let mut sums = block.constants.0;
            for (&monomial, factors) in terms[begin..block.end].iter().zip(&factors[begin..block.end]) {
                let value = self.values[monomial as usize];
                for (sum, factor) in sums.iter_mut().zip(&factors.0) {
                    *sum += factor * value;
                }
            }
            begin = block.end;
            let Some(room) = self.outputs.get_mut(block.first..) else { return };
            match room.first_chunk_mut() {
                Some(whole) => *whole = sums,
                None => room.iter_mut().zip(sums).for_each(|(output, sum)| *output = sum),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Polynomials;
    use crate::{Sym, symbols};
    use field::{Analytic, Scalar};

    #[test]
    fn rows_of_any_length_have_the_values_of_their_expressions() {
        let [x, y, z] = symbols(["x", "y", "z"]);
        let (two, point) = (Sym::int(2), (x / Sym::int(3)).circle());
        let parts = [x * y, z, point.cos * y * y, two, x + point.sin * point.cos, Sym::ZERO, z.powi(5) / two];
        let at = [0.7_f64, -1.3, 0.4];
        let value = |name: &str| ["x", "y", "z"].iter().position(|known| *known == name).map(|place| at[place]);
        for columns in 1..20 {
            let outputs: Vec<Sym> =
                (0..3 * columns).map(|i| parts[i % 7] - parts[i % 3] * Sym::int(i as i64)).collect();
            let Ok(polynomials) = Polynomials::record(&[x, y, z], &outputs, columns) else { panic!("polynomials") };
            let mut values = vec![f64::NAN; outputs.len()];
            polynomials.ready().evaluate(&at, &mut values);
            for (output, computed) in outputs.iter().zip(&values) {
                let Ok(exact) = output.evaluate_analytic(&value) else { panic!("{output}") };
                assert!((computed - exact).abs() < 1e-13, "{output}: {computed} for {exact}");
            }
        }
    }

    #[test]
    fn what_is_divided_by_an_input_is_refused_by_name() {
        let [x, y] = symbols(["x", "y"]);
        let refused = Polynomials::record(&[x, y], &[x, x / y], 2);
        assert!(refused.is_err_and(|error| error.to_string().contains("x/y")));
    }
}
