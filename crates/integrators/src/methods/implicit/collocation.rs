//! Gauss and Radau IIA collocation over any scalar type: nodes by Newton's iteration, matrices by Legendre polynomials.
//!
//! Collocation at nodes c_1 .. c_s takes the polynomial u of degree s with u(0) = y and u'(c_i h) = f(u(c_i h)); its
//! stages are Y_i = y + h sum_j a_ij f(Y_j) with a_ij = integral of the Lagrange polynomial l_j from 0 to c_i.
//! * Gauss (Butcher, Kuntzmann 1964): the zeros of P_s; order 2s, symplectic, A-stable.
//! * Radau IIA (Ehle, Axelsson 1969): the zeros of P_s - P_{s-1}, c_s = 1; order 2s - 1, L-stable, stiffly accurate.
//!
//! Both quadratures are exact up to degree 2s - 2, hence l_j = b_j sum_{k<s} (2k + 1) P_k(c_j) P_k, with P_k shifted to
//! (0, 1). The a_ij follow from the integrals of P_k, without the cancellation of a monomial basis.

use crate::Real;
use field::Scalar;

/// A family of collocation methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    Gauss,
    RadauIIA,
}

/// The coefficients of one collocation method.
#[derive(Clone, Debug)]
pub struct Collocation<S> {
    pub family: Family,
    /// The nodes c_i.
    pub nodes: Vec<S>,
    /// The weights b_i.
    pub weights: Vec<S>,
    /// The coefficients a_ij, row by row.
    pub matrix: Vec<Vec<S>>,
    /// The vector d = b A^-1, with y_1 = y_0 + sum_i d_i (Y_i - y_0). In this form a stiff law does not magnify the
    /// error of Newton's iteration.
    pub ends: Vec<S>,
    /// The vector e with h u' = sum_i e_i (Y_i - y_0), where the defect u' - f(u) is evaluated: at the end of the step
    /// for Gauss, at its start for Radau IIA.
    pub probe: Vec<S>,
}

impl<S: Real> Collocation<S> {
    /// The method with `stages` >= 1 stages.
    pub fn new(family: Family, stages: usize) -> Self {
        let nodes = nodes::<S>(family, stages);
        let weights: Vec<S> = nodes.iter().map(|c| weight(family, stages, *c)).collect();
        let basis: Vec<Vec<S>> = nodes.iter().map(|c| legendre(stages, *c)).collect();
        let lagrange = |j: usize, values: &dyn Fn(usize) -> S| {
            let sum = (0..stages).fold(S::zero(), |sum, k| sum + S::int(2 * k as i64 + 1) * basis[j][k] * values(k));
            weights[j] * sum
        };
        let row = |i: usize| (0..stages).map(|j| lagrange(j, &|k| integral(&basis[i], nodes[i], k))).collect();
        let matrix: Vec<Vec<S>> = (0..stages).map(row).collect();
        let at = legendre(stages, if family == Family::Gauss { S::one() } else { S::zero() });
        let slopes: Vec<S> = (0..stages).map(|j| lagrange(j, &|k| at[k])).collect();
        let (ends, probe) = (solve_transposed(&matrix, &weights), solve_transposed(&matrix, &slopes));
        Collocation { family, nodes, weights, matrix, ends, probe }
    }

    pub fn stages(&self) -> usize {
        self.nodes.len()
    }

    /// The order of convergence: 2s for Gauss, 2s - 1 for Radau IIA.
    pub fn order(&self) -> usize {
        match self.family {
            Family::Gauss => 2 * self.stages(),
            Family::RadauIIA => 2 * self.stages() - 1,
        }
    }
}

/// The Legendre polynomials P_0 .. P_s shifted to (0, 1): (k + 1) P_{k+1} = (2k + 1) (2c - 1) P_k - k P_{k-1}.
fn legendre<S: Scalar>(s: usize, c: S) -> Vec<S> {
    let x = c + c - S::one();
    let mut values = vec![S::one(), x];
    for k in 1..s {
        let next = (S::int(2 * k as i64 + 1) * x * values[k] - S::int(k as i64) * values[k - 1]) / S::int(k as i64 + 1);
        values.push(next);
    }
    values
}

/// The integral of P_k from 0 to c: (P_{k+1} - P_{k-1}) / (4k + 2), and c for k = 0.
fn integral<S: Real>(values: &[S], c: S, k: usize) -> S {
    if k == 0 { c } else { (values[k + 1] - values[k - 1]) / S::int(4 * k as i64 + 2) }
}

/// The polynomial whose zeros are the nodes, at c in (0, 1): P_s for Gauss, P_s - P_(s-1) for Radau IIA.
pub fn nodal<S: Scalar>(family: Family, stages: usize, c: S) -> S {
    let p = legendre(stages, c);
    match family {
        Family::Gauss => p[stages],
        Family::RadauIIA => p[stages] - p[stages - 1],
    }
}

/// The derivative of [`nodal`], by (x^2 - 1) P_s' = s (x P_s - P_{s-1}) for x = 2c - 1.
fn nodal_slope<S: Real>(family: Family, s: usize, c: S) -> S {
    let p = legendre(s, c);
    let x = c + c - S::one();
    let slope = |k: usize| match k {
        0 => S::zero(),
        _ => S::int(2 * k as i64) * (x * p[k] - p[k - 1]) / (x * x - S::one()),
    };
    match family {
        Family::Gauss => slope(s),
        Family::RadauIIA => slope(s) - slope(s - 1),
    }
}

/// The nodes in (0, 1): bracketed by a Chebyshev grid, bisected, then refined by Newton's iteration.
fn nodes<S: Real>(family: Family, s: usize) -> Vec<S> {
    let fine = 40 * s + 1;
    let grid = |i: usize| 0.5 - 0.5 * (std::f64::consts::PI * (i as f64 + 0.5) / fine as f64).cos();
    let value = |c: f64| nodal(family, s, c);
    let mut found = Vec::with_capacity(s);
    for (mut low, mut high) in (1..fine).map(|i| (grid(i - 1), grid(i))) {
        if value(low) * value(high) > 0.0 {
            continue;
        }
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if value(low) * value(middle) <= 0.0 { high = middle } else { low = middle }
        }
        let mut node = S::lift(0.5 * (low + high));
        for _ in 0..4 {
            node -= nodal(family, s, node) / nodal_slope(family, s, node);
        }
        found.push(node);
    }
    if family == Family::RadauIIA {
        found.push(S::one());
    }
    found
}

/// The weight of a node: 1 / ((1 - x^2) P_s'(x)^2) for Gauss, (1 + x) / (2 s^2 P_{s-1}(x)^2) for Radau, x = 2c - 1.
fn weight<S: Real>(family: Family, s: usize, c: S) -> S {
    match family {
        Family::Gauss => {
            let slope = nodal_slope(family, s, c).half();
            S::one() / (S::int(4) * c * (S::one() - c) * slope * slope)
        }
        Family::RadauIIA => c / (S::int(s as i64) * legendre(s, c)[s - 1]).squared(),
    }
}

/// The solution x of x A = b, by Gauss-Jordan elimination with pivoting; A is regular for both families.
fn solve_transposed<S: Real>(matrix: &[Vec<S>], right: &[S]) -> Vec<S> {
    let n = right.len();
    let row = |i: usize| matrix.iter().map(|row| row[i]).chain(std::iter::once(right[i])).collect();
    let mut rows: Vec<Vec<S>> = (0..n).map(row).collect();
    for k in 0..n {
        let size = |row: usize| rows[row][k].magnitude();
        let pivot = (k + 1..n).fold(k, |best, row| if size(row) > size(best) { row } else { best });
        rows.swap(k, pivot);
        let pivot_row = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / pivot_row[k];
            row.iter_mut().zip(&pivot_row).for_each(|(entry, above)| *entry -= factor * *above);
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::DoubleDouble;

    /// The largest of |sum_j a_ij c_j^(k-1) - c_i^k / k| and |sum_j b_j c_j^(k-1) - 1/k|, for k up to the theoretical
    /// order.
    fn defect(method: &Collocation<DoubleDouble>) -> f64 {
        let power = |c: DoubleDouble, k: usize| (0..k).fold(DoubleDouble::int(1), |p, _| p * c);
        let moments = |row: &[DoubleDouble], k: usize| {
            row.iter().zip(&method.nodes).fold(DoubleDouble::int(0), |sum, (a, c)| sum + *a * power(*c, k - 1))
        };
        let over = |k: usize| DoubleDouble::ratio(1, k as i64);
        let stage = (1..=method.stages()).flat_map(|k| {
            method.matrix.iter().zip(&method.nodes).map(move |(row, c)| moments(row, k) - power(*c, k) * over(k))
        });
        let end = (1..=method.order()).map(|k| moments(&method.weights, k) - over(k));
        stage.chain(end).map(|d| d.approx().abs()).fold(0.0, f64::max)
    }

    #[test]
    fn every_method_meets_its_simplifying_assumptions_to_30_digits() {
        for family in [Family::Gauss, Family::RadauIIA] {
            for stages in 1..=20 {
                let defect = defect(&Collocation::new(family, stages));
                assert!(defect < 1e-30, "{family:?} with {stages} stages: {defect:.1e}");
            }
        }
    }

    #[test]
    fn a_wrong_coefficient_is_noticed() {
        let mut method = Collocation::<DoubleDouble>::new(Family::Gauss, 3);
        method.matrix[1][0] += DoubleDouble::from(1e-20);
        assert!(defect(&method) > 1e-22);
    }

    #[test]
    fn radau_iia_with_3_stages_has_the_nodes_of_the_textbook() {
        let nodes = Collocation::<f64>::new(Family::RadauIIA, 3).nodes;
        let root = 6.0_f64.sqrt();
        for (node, textbook) in nodes.iter().zip([(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0]) {
            assert!((node - textbook).abs() < 1e-15);
        }
    }
}
