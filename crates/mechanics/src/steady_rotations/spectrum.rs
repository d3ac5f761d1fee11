//! The equation (K - x) v + b = 0 in terms of polynomials in x.

use algebra::real::{Enclosure, Number, Polynomial, Root};
use std::cmp::Ordering;

pub(super) type Vector<T> = [T; 3];
pub(super) type Matrix<T> = [[T; 3]; 3];

/// The resolvent of K applied to one or two vectors, in lowest terms, and the eigenvalues that cancel.
pub(super) struct Spectrum {
    /// The adjugate adj(K - x).
    pub adjugate: Matrix<Polynomial>,
    /// Eigenvalues in ascending order, with their multiplicities.
    pub eigenvalues: Vec<(Root, usize)>,
    /// The polynomial q of least degree whose roots are the eigenvalues with eigenvectors not orthogonal to all the
    /// vectors.
    pub seen: Polynomial,
    /// The numerators N_k with (K - x) N_k = q b_k.
    pub numerators: Vec<Vector<Polynomial>>,
    /// The indices of the other eigenvalues.
    pub unseen: Vec<usize>,
}

impl Spectrum {
    pub fn of(matrix: &Matrix<Number>, vectors: &[Vector<Number>]) -> Self {
        let shifted: Matrix<Polynomial> = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let entry = matrix[i][j].clone();
                Polynomial::new(if i == j { vec![entry, Number::from(-1)] } else { vec![entry] })
            })
        });
        let adjugate = adjugate(&shifted);
        let determinant = sum((0..3).map(|j| &shifted[0][j] * &adjugate[j][0]));
        let images: Vec<Vector<Polynomial>> = vectors
            .iter()
            .map(|b| std::array::from_fn(|i| sum((0..3).map(|j| scaled(&adjugate[i][j], &b[j])))))
            .collect();
        let all = images.iter().flatten();
        let common = all.fold(determinant.clone(), |common, p| match common.degree() {
            Some(0) => common,
            _ => common.gcd(p),
        });
        // one common power, so that ratios are preserved
        let reduced = |p: &Polynomial| match common.degree() {
            Some(0) => p.clone(),
            _ => p.quotient(&common, 4),
        };
        let seen = reduced(&determinant);
        let numerators = images.iter().map(|image| std::array::from_fn(|i| reduced(&image[i]))).collect();
        let slope = determinant.derivative();
        let bend = slope.derivative();
        let multiplicity = |root: &Root| {
            if root.sign_of(&slope) != 0 {
                1
            } else if root.sign_of(&bend) != 0 {
                2
            } else {
                3
            }
        };
        let eigenvalues: Vec<_> =
            determinant.real_roots().into_iter().map(|root| (multiplicity(&root), root)).collect();
        let eigenvalues: Vec<_> = eigenvalues.into_iter().map(|(multiplicity, root)| (root, multiplicity)).collect();
        let unseen = match common.degree() {
            Some(0) => Vec::new(),
            _ => (0..eigenvalues.len()).filter(|&k| eigenvalues[k].0.sign_of(&seen) != 0).collect(),
        };
        Spectrum { adjugate, eigenvalues, seen, numerators, unseen }
    }

    /// The numbers of eigenvalues below and above x; `None` where x is an eigenvalue.
    pub fn around(&self, x: &Root) -> Option<[usize; 2]> {
        let mut counts = [0, 0];
        for (eigenvalue, multiplicity) in &self.eigenvalues {
            match eigenvalue.compare(x) {
                Ordering::Less => counts[0] += multiplicity,
                Ordering::Greater => counts[1] += multiplicity,
                Ordering::Equal => return None,
            }
        }
        Some(counts)
    }

    /// The numbers of eigenvalues below and above the one with index `place`.
    pub fn beside(&self, place: usize) -> [usize; 2] {
        let count = |part: &[(Root, usize)]| part.iter().map(|(_, multiplicity)| multiplicity).sum();
        [count(&self.eigenvalues[..place]), count(&self.eigenvalues[place + 1..])]
    }

    /// A unit eigenvector of a simple eigenvalue; `None` where the precision is too low.
    pub fn eigenvector(&self, place: usize, bits: usize) -> Option<Vector<Enclosure>> {
        let at = self.eigenvalues[place].0.enclosure(bits);
        // adj(K - k) = c u u^T, c its trace: column i is c u_i u
        let entry = |i: usize, j: usize| self.adjugate[i][j].enclosure(&at, bits);
        let trace = &(&entry(0, 0) + &entry(1, 1)) + &entry(2, 2);
        let column = (0..3).max_by(|&i, &j| entry(i, i).to_f64().abs().total_cmp(&entry(j, j).to_f64().abs()))?;
        let length = (&trace * &entry(column, column)).sqrt()?;
        let unit: Vec<Enclosure> = (0..3).map(|i| entry(i, column).over(&length)).collect::<Option<_>>()?;
        unit.try_into().ok()
    }

    /// A unit normal of the eigenspace of a double eigenvalue, which is the eigenvector of the other one; `None` for a
    /// triple eigenvalue.
    pub fn normal(&self, place: usize, bits: usize) -> Option<Vector<Enclosure>> {
        let other = (0..self.eigenvalues.len()).find(|&k| k != place)?;
        self.eigenvector(other, bits)
    }
}

/// The scalar product a.b.
pub(super) fn dot(a: &Vector<Polynomial>, b: &Vector<Polynomial>) -> Polynomial {
    sum((0..3).map(|i| &a[i] * &b[i]))
}

/// The scalar product a.b with constant b.
pub(super) fn along(a: &Vector<Polynomial>, b: &Vector<Number>) -> Polynomial {
    sum((0..3).map(|i| scaled(&a[i], &b[i])))
}

pub(super) fn scaled(p: &Polynomial, factor: &Number) -> Polynomial {
    p * &Polynomial::constant(factor.clone())
}

pub(super) fn sum(terms: impl Iterator<Item = Polynomial>) -> Polynomial {
    terms.fold(Polynomial::default(), |sum, term| &sum + &term)
}

pub(super) fn adjugate(m: &Matrix<Polynomial>) -> Matrix<Polynomial> {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (a, b, c, d) = ((j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3);
            &(&m[a][c] * &m[b][d]) - &(&m[a][d] * &m[b][c])
        })
    })
}
