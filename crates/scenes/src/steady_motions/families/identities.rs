//! Identities between the equations R_k of steady motion,
//!
//!   sum_k c_k(q) R_k(q) = 0 at every q ,
//!
//! with coefficients c_k linear in the unknowns and in sines and cosines of angles. The forces do no work along the displacement c, such as the
//! rotation (-y, x) about a centre. If c_k is not zero, equation k follows from the others.
//!
//! Candidates follow from values at sample points and are then decided by identity testing.

use crate::steady_motions::Unknown;
use algebra::linear::minors;
use field::{Analytic, Interval, Over, Rational};
use model::equations::vanishes;
use nalgebra::DMatrix;
use symbolic::{Sym, Tape};

/// The coefficients of an identity as functions of the unknowns, one for each equation.
#[derive(Debug)]
pub(in crate::steady_motions) struct Identity {
    coefficients: Tape,
    /// The displacement c as text.
    told: String,
}

/// Largest number of unknowns for which identities are searched.
const MOST_UNKNOWNS: usize = 6;

/// Largest denominator of a rational coefficient.
const LARGEST: u16 = 10_000;

/// Largest number of sample points that are tried for each point needed; at some the equations may be undefined.
const MOST_POINTS: usize = 16;

/// Largest number of iterations of the singular value decomposition.
const MOST_ITERATIONS: usize = 1_000;

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-10;

impl Identity {
    /// All identities between the equations; none if these contain other letters than `letters`. `along` names the displacement of each equation.
    pub fn of(residuals: &[Sym], (letters, unknowns): (&[Sym], &[Unknown]), along: &[String]) -> Vec<Self> {
        let (rows, n) = (residuals.len(), letters.len());
        if rows == 0 || n > MOST_UNKNOWNS || rows > n {
            return Vec::new();
        }
        let mut basis = vec![Sym::ONE];
        for (&letter, unknown) in letters.iter().zip(unknowns) {
            match unknown.is_circle {
                true => basis.extend([letter.circle().cos, letter.circle().sin]),
                false => basis.push(letter),
            }
        }
        let products: Vec<Sym> = residuals.iter().flat_map(|row| basis.iter().map(move |by| *row * *by)).collect();
        candidates(&products, letters, unknowns)
            .into_iter()
            .filter_map(|factors| {
                let of_row = |row: usize| -> Sym {
                    let own = &factors[row * basis.len()..(row + 1) * basis.len()];
                    let terms = own.iter().zip(&basis).map(|(factor, by)| Sym::lift(*factor) * *by);
                    terms.fold(Sym::ZERO, |sum, term| sum + term)
                };
                let coefficients: Vec<Sym> = (0..rows).map(of_row).collect();
                let sum = coefficients.iter().zip(residuals).fold(Sym::ZERO, |sum, (c, row)| sum + *c * *row);
                let moved = coefficients.iter().zip(along).filter(|(own, _)| **own != Sym::ZERO);
                let told: Vec<String> =
                    moved.map(|(own, name)| format!("{name}: {}", named(own, letters, unknowns))).collect();
                let coefficients = Tape::record(letters, &coefficients).ok()?;
                vanishes(sum).then(|| Identity { coefficients, told: format!("({})", told.join(", ")) })
            })
            .collect()
    }

    /// As many equations as possible that follow from the others everywhere in a box, and the displacements of the identities used.
    pub fn implied(all: &[Self], at: &[Interval]) -> (Vec<usize>, Vec<String>) {
        let Some(first) = all.first() else { return (Vec::new(), Vec::new()) };
        let rows = first.coefficients.outputs();
        let values: Vec<Vec<Interval>> = all
            .iter()
            .map(|identity| {
                let mut values = vec![Interval::EVERYTHING; rows];
                identity.coefficients.over::<Interval>().evaluate(at, &mut values);
                values
            })
            .collect();
        let told = |chosen: &[usize]| chosen.iter().map(|&own| all[own].told.clone()).collect();
        for count in (1..=all.len().min(rows)).rev() {
            let largest = choices(all.len(), count)
                .into_iter()
                .flat_map(|own| choices(rows, count).into_iter().map(move |columns| (own.clone(), columns)))
                .map(|(own, columns)| {
                    let minors = minors(count, |i, j| values[own[i]][columns[j]], count);
                    let least = minors[(1 << count) - 1];
                    (if least.contains(0.0) { 0.0 } else { least.low().abs().min(least.high().abs()) }, own, columns)
                })
                .max_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((size, own, columns)) = largest
                && size > 0.0
            {
                return (columns, told(&own));
            }
        }
        (Vec::new(), Vec::new())
    }
}

/// A coefficient as text, with the names of the unknowns.
fn named(coefficient: &Sym, letters: &[Sym], unknowns: &[Unknown]) -> String {
    let names = letters.iter().zip(unknowns).map(|(letter, unknown)| (*letter, Sym::symbol(&unknown.name)));
    coefficient.substitute(&names.collect::<Vec<_>>()).to_string()
}

/// Rational factors for which the sum of the products vanishes at the sample points, in reduced row echelon form.
fn candidates(products: &[Sym], letters: &[Sym], unknowns: &[Unknown]) -> Vec<Vec<Rational>> {
    let wide = products.len();
    let Ok(tape) = Tape::record(letters, products) else { return Vec::new() };
    let mut program = tape.over::<f64>();
    let tall = wide + 6;
    let mut values = DMatrix::zeros(tall, wide);
    let mut row = vec![0.0; wide];
    let mut found = 0;
    for point in 0..MOST_POINTS * tall {
        if found == tall {
            break;
        }
        // a quasi-random sequence (Weyl) fills the domain evenly
        let part = |k: usize| (0.5 + (point + 1) as f64 * STEPS[k % STEPS.len()]).fract();
        let at: Vec<f64> = unknowns
            .iter()
            .enumerate()
            .map(|(k, unknown)| unknown.range.from + part(k) * (unknown.range.to - unknown.range.from))
            .collect();
        program.evaluate(&at, &mut row);
        // points outside the domain of a function are left out
        if row.iter().all(|value| value.is_finite()) {
            row.iter().enumerate().for_each(|(column, value)| values[(found, column)] = *value);
            found += 1;
        }
    }
    if found < tall {
        return Vec::new();
    }
    let sizes: Vec<f64> = (0..wide).map(|column| values.column(column).amax()).collect();
    for (column, size) in sizes.iter().enumerate().filter(|(_, size)| **size > 0.0) {
        values.column_mut(column).unscale_mut(*size);
    }
    let Some(svd) = values.try_svd(false, true, f64::EPSILON, MOST_ITERATIONS) else { return Vec::new() };
    let Some(v) = svd.v_t else { return Vec::new() };
    let largest = svd.singular_values.max();
    let zero: Vec<usize> = (0..wide).filter(|&k| svd.singular_values[k] <= RANK * largest).collect();
    let mut null = DMatrix::from_fn(zero.len(), wide, |row, column| match sizes[column] > 0.0 {
        true => v[(zero[row], column)] / sizes[column],
        false => v[(zero[row], column)],
    });
    reduce(&mut null);
    let fraction = |value: f64| -> Option<Rational> {
        let found = (1..=LARGEST).find_map(|below| {
            let below = f64::from(below);
            let above = (value * below).round();
            let is_near = (value - above / below).abs() <= 1e-8 * (1.0 + value.abs());
            (is_near && above.abs() < 1e12).then(|| Rational::exactly(above) / Rational::exactly(below))
        });
        found.filter(|value| value.is_defined())
    };
    null.row_iter().filter_map(|row| row.iter().map(|&value| fraction(value)).collect()).collect()
}

/// Increments of the sequence of sample points: fractional parts of square roots of primes.
const STEPS: [f64; 6] = [
    0.414_213_562_373_095_05,
    0.732_050_807_568_877_3,
    0.236_067_977_499_789_7,
    0.645_751_311_064_590_6,
    0.316_624_790_355_399_85,
    0.605_551_275_463_989_3,
];

/// Brings a matrix to reduced row echelon form.
fn reduce(matrix: &mut DMatrix<f64>) {
    let mut done = 0;
    for column in 0..matrix.ncols() {
        let Some(pivot) = (done..matrix.nrows())
            .max_by(|&a, &b| matrix[(a, column)].abs().total_cmp(&matrix[(b, column)].abs()))
            .filter(|&row| matrix[(row, column)].abs() > 1e-7)
        else {
            continue;
        };
        matrix.swap_rows(done, pivot);
        let own = matrix.row(done) / matrix[(done, column)];
        matrix.set_row(done, &own);
        for row in (0..matrix.nrows()).filter(|row| *row != done) {
            let left = matrix.row(row) - &own * matrix[(row, column)];
            matrix.set_row(row, &left);
        }
        done += 1;
    }
}

/// All subsets of `count` of the numbers below `of`.
fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |last: usize| choices(last, count - 1).into_iter().map(move |rest| [&rest[..], &[last]].concat());
    (0..of).flat_map(with).collect()
}
