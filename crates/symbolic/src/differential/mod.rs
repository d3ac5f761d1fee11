//! The differential of expressions in the form of sums, for derivatives in many directions:
//!
//!   dv = sum_k w_k du_k ,
//!
//! one sum for each intermediate quantity v, whose weights w_k depend only on the point. Each direction costs one multiplication and one
//! addition per term. Dual numbers would evaluate the expressions again for each direction, and the length of symbolic derivatives is proportional to the number of
//! directions.

mod elimination;

use crate::{Derivation, Sym, substitute_all};
use elimination::Graph;
use rustc_hash::FxHashMap;

/// A term of a differential: the index of the quantity `source`, and its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighted {
    pub source: usize,
    pub weight: Sym,
}

/// The differentials of outputs with respect to inputs, as sums over intermediate quantities.
///
/// ```
/// use dalembert_symbolic::{Differential, Sym, symbols};
///
/// let [x, y] = symbols(["x", "y"]);
/// let differential = Differential::of(&[x, y], &[x * y + x]);
/// // d(xy + x) = (y + 1) dx + x dy
/// let terms: Vec<String> = differential.sums[0].iter().map(|term| format!("{}: {}", term.source, term.weight)).collect();
/// assert_eq!(terms, ["0: 1 + y", "1: x"]);
/// ```
#[derive(Clone, Debug)]
pub struct Differential {
    /// The number of inputs, which have the indices 0 to `inputs - 1`.
    pub inputs: usize,
    /// The sums of the quantities with the next indices. Each sum refers to smaller indices; the last `outputs` sums are the outputs.
    pub sums: Vec<Vec<Weighted>>,
    /// The number of outputs.
    pub outputs: usize,
}

impl Differential {
    /// Returns the differential of the outputs with respect to the inputs, which are usually symbols; all other symbols are constant.
    pub fn of(inputs: &[Sym], outputs: &[Sym]) -> Self {
        Graph::of(&Self::written(inputs, outputs)).reduced()
    }

    /// Returns the differential of the composition `other` after `self`: the outputs of `self` are the inputs of `other`.
    ///
    /// # Panics
    /// If `other.inputs` differs from `self.outputs`.
    pub fn then(&self, other: &Differential) -> Self {
        assert_eq!(self.outputs, other.inputs, "outputs of the first are inputs of the second");
        let places = self.inputs + self.sums.len();
        let moved = |term: &Weighted| Weighted { source: term.source + places - self.outputs, ..*term };
        let added = other.sums.iter().map(|sum| sum.iter().map(moved).collect());
        let sums = self.sums.iter().cloned().chain(added).collect();
        Graph::of(&Differential { inputs: self.inputs, sums, outputs: other.outputs }).reduced()
    }

    /// Replaces expressions in the weights. The replacements must not depend on the inputs.
    #[must_use]
    pub fn substituted(mut self, replacements: &[(Sym, Sym)]) -> Self {
        let weights = substitute_all(&self.weights(), replacements);
        self.sums.iter_mut().flatten().zip(weights).for_each(|(term, weight)| term.weight = weight);
        self
    }

    /// Returns the weights of all sums in order.
    pub fn weights(&self) -> Vec<Sym> {
        self.sums.iter().flatten().map(|term| term.weight).collect()
    }

    /// Builds one sum per subexpression, in the order of the expressions.
    fn written(inputs: &[Sym], outputs: &[Sym]) -> Self {
        let mut places: FxHashMap<Sym, usize> = inputs.iter().copied().zip(0..).collect();
        let mut sums: Vec<Vec<Weighted>> = Vec::new();
        for each in Sym::reached(outputs, |each, _| !places.contains_key(&each)) {
            if places.contains_key(&each) {
                continue;
            }
            let mut children: Vec<Sym> = each.node().children().collect();
            children.dedup();
            let mut sum = Vec::new();
            for &child in &children {
                let Some(&source) = places.get(&child) else { continue };
                // differentiates only with respect to the direct operands
                let rates = children.iter().map(|&other| (other, if other == child { Sym::ONE } else { Sym::ZERO }));
                let weight = Derivation::new(rates).of(each);
                if weight != Sym::ZERO {
                    sum.push(Weighted { source, weight });
                }
            }
            if !sum.is_empty() {
                places.insert(each, inputs.len() + sums.len());
                sums.push(sum);
            }
        }
        let copy = |source: &usize| vec![Weighted { source: *source, weight: Sym::ONE }];
        sums.extend(outputs.iter().map(|output| places.get(output).map(copy).unwrap_or_default()));
        Differential { inputs: inputs.len(), sums, outputs: outputs.len() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Unbound, symbols};
    use field::{Analytic, Scalar};

    /// Computes the Jacobian matrix by rows, by evaluating the sums once for each input.
    fn matrix(differential: &Differential, value: impl Fn(Sym) -> f64) -> Vec<f64> {
        let Differential { inputs, sums, outputs } = differential;
        let column = |input: usize| {
            let mut places: Vec<f64> = (0..*inputs).map(|place| f64::from(place == input)).collect();
            for sum in sums {
                places.push(sum.iter().map(|term| value(term.weight) * places[term.source]).sum());
            }
            places.split_off(places.len() - outputs)
        };
        let columns: Vec<Vec<f64>> = (0..*inputs).map(column).collect();
        (0..*outputs).flat_map(|row| columns.iter().map(move |column| column[row])).collect()
    }

    fn at<const N: usize>(letters: [&'static str; N], values: [f64; N]) -> impl Fn(Sym) -> f64 {
        move |weight| {
            let of = |name: &str| letters.iter().zip(values).find(|(own, _)| **own == name).map(|(_, value)| value);
            let found: Result<f64, Unbound> = weight.evaluate_analytic(&of);
            found.expect("all letters have values")
        }
    }

    #[test]
    fn sums_have_the_derivatives_of_the_expressions() {
        let letters = symbols(["x", "y", "z"]);
        let [x, y, z] = letters;
        let shared = (x * y + z.circle().sin).sqrt();
        let outputs = [shared * shared.circle().cos / (y + z), x, Sym::int(3), (shared - x).powi(3) + shared];
        let value = at(["x", "y", "z"], [0.7, 1.9, 0.3]);
        let found = matrix(&Differential::of(&letters, &outputs), &value);
        let wanted = outputs.iter().flat_map(|output| letters.iter().map(|&by| output.diff(by)));
        for (found, wanted) in found.into_iter().zip(wanted) {
            let wanted = value(wanted);
            assert!((found - wanted).abs() <= 1e-14 * (1.0 + wanted.abs()), "{found} {wanted}");
        }
    }

    #[test]
    fn a_composition_has_the_product_of_the_derivatives() {
        let [x, y, u, v] = symbols(["x", "y", "u", "v"]);
        let inner = Differential::of(&[x, y], &[x * y, x + y]);
        let outer = Differential::of(&[u, v], &[u * x + v, v]);
        let value = at(["x", "y"], [2.0, 3.0]);
        assert_eq!(matrix(&inner.then(&outer), &value), [7.0, 5.0, 1.0, 1.0]);
        // a constant output does not change anything behind it
        let resting = Differential::of(&[x, y], &[Sym::int(3), x + y]);
        assert_eq!(matrix(&resting.then(&outer), &value), [1.0, 1.0, 1.0, 1.0]);
    }

    #[test]
    fn quantities_with_one_source_or_one_reader_are_eliminated() {
        let [x, y] = symbols(["x", "y"]);
        let long = (0..20).fold(x, |sum, k| (sum * sum + Sym::int(k)).sqrt());
        let differential = Differential::of(&[x, y], &[long * y, long + y]);
        assert_eq!(differential.sums.iter().map(Vec::len).collect::<Vec<_>>(), [2, 2]);
    }
}
