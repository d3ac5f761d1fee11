//! Numerical tools of the tests: linear equations, difference quotients, random numbers, values of printed expressions.

use dalembert_model::expression::{Form, read};

/// Step of the difference quotients. Their stencils have seven points and an error of sixth order.
const STEP: f64 = 2e-4;
const STENCIL: [(f64, f64); 6] = [
    (-3.0, -1.0 / 60.0),
    (-2.0, 3.0 / 20.0),
    (-1.0, -3.0 / 4.0),
    (1.0, 3.0 / 4.0),
    (2.0, -3.0 / 20.0),
    (3.0, 1.0 / 60.0),
];
const SECOND: [(f64, f64); 7] = [
    (-3.0, 1.0 / 90.0),
    (-2.0, -3.0 / 20.0),
    (-1.0, 3.0 / 2.0),
    (0.0, -49.0 / 18.0),
    (1.0, 3.0 / 2.0),
    (2.0, -3.0 / 20.0),
    (3.0, 1.0 / 90.0),
];

/// Returns f'(0).
pub fn slope(f: impl Fn(f64) -> f64) -> f64 {
    STENCIL.iter().map(|(at, weight)| weight * f(at * STEP)).sum::<f64>() / STEP
}

/// Returns f'(0) of a quadratic function: central differences are exact, and the wide step reduces rounding errors.
pub fn quadratic_slope(f: impl Fn(f64) -> f64) -> f64 {
    (f(1.0) - f(-1.0)) / 2.0
}

/// Returns the derivatives at 0 of all components of a function.
pub fn slopes(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let mut sum = vec![0.0; f(0.0).len()];
    for (at, weight) in STENCIL {
        for (sum, value) in sum.iter_mut().zip(f(at * STEP)) {
            *sum += weight * value / STEP;
        }
    }
    sum
}

/// Returns f''(0).
pub fn curvature(f: impl Fn(f64) -> f64) -> f64 {
    SECOND.iter().map(|(at, weight)| weight * f(at * STEP)).sum::<f64>() / (STEP * STEP)
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn cross(a: &[f64], b: &[f64]) -> Vec<f64> {
    (0..3).map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]).collect()
}

/// Returns the unit vector with index `place` in n dimensions.
pub fn unit(n: usize, place: usize) -> Vec<f64> {
    (0..n).map(|other| if other == place { 1.0 } else { 0.0 }).collect()
}

/// Returns a solution of matrix * x = right by Gauss-Jordan elimination with full pivoting, and the rank. Unknowns without pivot are zero.
pub fn solved(matrix: &[Vec<f64>], right: &[f64]) -> (Vec<f64>, usize) {
    let columns = matrix.first().map_or(0, Vec::len);
    let mut rows: Vec<Vec<f64>> = matrix.iter().zip(right).map(|(row, &right)| [&row[..], &[right]].concat()).collect();
    let size = matrix.iter().flatten().fold(0.0, |size: f64, entry| size.max(entry.abs()));
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    while pivots.len() < rows.len().min(columns) {
        let is_free = |row: &usize| pivots.iter().all(|(known, _)| known != row);
        let places = (0..rows.len()).filter(is_free).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let largest = places.max_by(|&(a, b), &(c, d)| rows[a][b].abs().total_cmp(&rows[c][d].abs()));
        let Some((row, column)) = largest.filter(|&(row, column)| rows[row][column].abs() > 1e-9 * size) else { break };
        let pivot = rows[row].clone();
        for (_, entries) in rows.iter_mut().enumerate().filter(|(other, _)| *other != row) {
            let factor = entries[column] / pivot[column];
            entries.iter_mut().zip(&pivot).for_each(|(entry, pivot)| *entry -= factor * pivot);
            entries[column] = 0.0;
        }
        pivots.push((row, column));
    }
    let mut x = vec![0.0; columns];
    for &(row, column) in &pivots {
        x[column] = rows[row][columns] / rows[row][column];
    }
    (x, pivots.len())
}

/// Pseudo-random numbers between -1 and 1 (splitmix64), reproducible from the seed.
pub struct Drawn(pub u64);

impl Drawn {
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Returns the value of an expression as `prove` prints it, for given values of its symbols.
pub fn value(text: &str, letter: &impl Fn(&str) -> f64) -> f64 {
    let read = read(text).unwrap_or_else(|wrong| panic!("{wrong:?}: {text}"));
    let mut values: Vec<f64> = Vec::new();
    for form in &read.parts {
        let of = |part: &usize| values[*part];
        let value = match form {
            Form::Number(number) => number.parse().expect("a number"),
            Form::Name(name) => letter(name),
            Form::Member { of, name } => letter(&format!("{of}.{name}")),
            Form::Negation(a) => -of(a),
            Form::Sum(a, b) => of(a) + of(b),
            Form::Difference(a, b) => of(a) - of(b),
            Form::Product(a, b) => of(a) * of(b),
            Form::Quotient(a, b) => of(a) / of(b),
            Form::Power(a, exponent) => of(a).powf(f64::from(exponent.numerator) / f64::from(exponent.denominator)),
            Form::Call { function, arguments } => {
                let argument = of(&arguments[0].value);
                match function.as_str() {
                    "sin" => argument.sin(),
                    "cos" => argument.cos(),
                    "sqrt" => argument.sqrt(),
                    "exp" => argument.exp(),
                    other => panic!("{other}: {text}"),
                }
            }
            other => panic!("{other:?}: {text}"),
        };
        values.push(value);
    }
    values[read.whole()]
}
