//! Exact stability boundaries along one parameter: roots of the last coefficient of the characteristic polynomial and of Hurwitz' determinant.
//!
//! The coefficients are rational functions of the parameter. A real eigenvalue crosses the imaginary axis where the last coefficient vanishes, a
//! complex pair only where Hurwitz' determinant of order n - 1 vanishes (Orlando 1911). Between neighbouring roots and poles, the numbers of
//! eigenvalues on both sides of the axis are constant, and Routh's criterion counts them at one rational value.

use super::NotEnclosed;
use super::exact::{MOST_SPEEDS, Routh, at_motion, counted};
use super::quotient::{Quotient, product};
use super::reduction::{Layout, Matrix, Pivot, Reduced};
use crate::linearisation::VariedEquations;
use algebra::real::{Ordered, Polynomial, Root};
use field::{Rational, Scalar};
use mechanics::linear_stability::characteristic;
use model::Model;
use std::cmp::Ordering;
use symbolic::Sym;

/// Precision of the boundaries, in bits.
const BITS: usize = 80;

/// A value of the parameter at which an eigenvalue is on the imaginary axis, or an equation is singular.
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary {
    /// The value in SI units, rounded.
    pub value: f64,
    /// The value as a fraction; `None` for an irrational one.
    pub exact: Option<String>,
    /// The degree of the polynomial with integer coefficients of which the value is a root.
    pub degree: usize,
}

/// Exact numbers of stable and unstable eigenvalues as functions of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactAlong {
    /// The boundaries in ascending order.
    pub boundaries: Vec<Boundary>,
    /// The counts before the first boundary, between successive ones, and after the last.
    pub counts: Vec<Routh>,
}

/// The boundaries along the parameter with the given index; `reasons` is the number of zero eigenvalues with known reasons.
pub(super) fn along(
    model: &Model,
    layout: &Layout,
    (state, parameter): (&[f64], usize),
    reasons: usize,
) -> Result<ExactAlong, NotEnclosed> {
    if model.speeds() > MOST_SPEEDS {
        return Err(NotEnclosed::Large { states: 2 * model.speeds(), most: 2 * MOST_SPEEDS });
    }
    let (coefficients, unexplained) =
        polynomial(model, layout, (state, parameter), reasons).ok_or(NotEnclosed::NotExact)?;
    let one = Quotient::constant(Rational::int(1));
    let hurwitz = determinant(hurwitz(&coefficients, &one)).ok_or(NotEnclosed::NotExact)?;
    // for every value of the parameter some eigenvalues are opposite to others
    if hurwitz.above.is_empty() {
        return Err(NotEnclosed::Opposite);
    }
    bounded(&coefficients, &hurwitz, unexplained).ok_or(NotEnclosed::NotExact)
}

/// The coefficients of the characteristic polynomial without its zero roots, and the number of zero roots without a known reason.
fn polynomial(
    model: &Model,
    layout: &Layout,
    (state, parameter): (&[f64], usize),
    reasons: usize,
) -> Option<(Vec<Quotient>, usize)> {
    let all: Vec<usize> = (0..model.parameters.len()).collect();
    let varied = VariedEquations::with_inputs(model, &all, &[]).ok()?;
    let one = Quotient::constant(Rational::int(1));
    let data = model.parameters.iter().enumerate().map(|(place, own)| match place == parameter {
        true => Some(Quotient::letter()),
        false => Some(Quotient::constant(Rational::decimal(own.value?))),
    });
    let data: Vec<Quotient> = data.collect::<Option<_>>()?;
    let exactly = |point: &[Quotient]| {
        symbolic::apart(|| {
            let letter = Sym::symbol("along");
            let numbers: Vec<Sym> = [point, &data].concat().iter().map(|number| written(number, letter)).collect();
            varied.over(&numbers, Sym::ZERO).through(|value: Sym| Quotient::of(value, letter))
        })
    };
    let at = at_motion(&varied, layout, state, &one, exactly)?;
    let reduced = Reduced::of(&at, layout, &one)?;
    let mut coefficients = characteristic(&reduced.matrix, &one);
    while coefficients.len() > 1 && coefficients.last().is_some_and(|last| last.sign() == Some(0)) {
        coefficients.pop();
    }
    let zeros = reduced.matrix.len() + 1 - coefficients.len();
    Some((coefficients, zeros.checked_sub(reasons)?))
}

/// The roots of the last coefficient and of Hurwitz' determinant, and the poles, with the counts between them.
fn bounded(coefficients: &[Quotient], hurwitz: &Quotient, unexplained: usize) -> Option<ExactAlong> {
    let last = coefficients.last()?;
    let poles = coefficients.iter().fold(vec![Rational::int(1)], |all, c| product(&all, &c.below));
    let places = [&last.above, &hurwitz.above, &hurwitz.below, &poles];
    let mut roots: Vec<Root> = Vec::new();
    for polynomial in places {
        for root in Polynomial::from_rationals(polynomial)?.real_roots() {
            if roots.iter().all(|known| known.compare(&root) != Ordering::Equal) {
                roots.push(root);
            }
        }
    }
    roots.sort_by(Root::compare);
    let mut boundaries = Vec::new();
    let mut ends = Vec::new();
    for root in &mut roots {
        root.refine(BITS);
        boundaries.push(Boundary {
            value: root.to_f64(),
            exact: root.as_rational().map(|value| value.to_string()),
            degree: root.polynomial().degree().unwrap_or(1),
        });
        ends.push(root.bounds());
    }
    let between = |k: usize| match (k.checked_sub(1).map(|k| ends[k][1]), ends.get(k).map(|end| end[0])) {
        (None, None) => Rational::int(0),
        (None, Some(high)) => high - Rational::int(1),
        (Some(low), None) => low + Rational::int(1),
        (Some(low), Some(high)) => (low + high) / Rational::int(2),
    };
    let count = |k: usize| {
        let value = between(k);
        let numbers: Vec<Rational> = coefficients.iter().map(|c| c.at(value)).collect::<Option<_>>()?;
        counted(numbers, unexplained)
    };
    let counts = (0..=ends.len()).map(count).collect::<Option<_>>()?;
    Some(ExactAlong { boundaries, counts })
}

/// A rational function as an expression.
fn written(number: &Quotient, letter: Sym) -> Sym {
    let horner = |all: &[Rational]| all.iter().rev().fold(Sym::ZERO, |sum, c| sum * letter + Sym::constant(*c));
    let above = horner(&number.above);
    if number.below.len() == 1 { above } else { above / horner(&number.below) }
}

/// Hurwitz' matrix of order n - 1 for a polynomial of degree n, whose highest coefficient comes first.
fn hurwitz<R: Pivot>(coefficients: &[R], one: &R) -> Matrix<R> {
    let order = coefficients.len().saturating_sub(2);
    let entry = |row: usize, column: usize| {
        let place = (2 * column + 1).checked_sub(row);
        place.and_then(|place| coefficients.get(place)).cloned().unwrap_or_else(|| one.integer(0))
    };
    (0..order).map(|row| (0..order).map(|column| entry(row, column)).collect()).collect()
}

/// The determinant up to its sign, by elimination.
fn determinant(mut matrix: Matrix<Quotient>) -> Option<Quotient> {
    let mut all = Quotient::constant(Rational::int(1));
    let size = matrix.len();
    for column in 0..size {
        let best = (column..size).max_by(|&a, &b| matrix[a][column].weight().total_cmp(&matrix[b][column].weight()))?;
        if matrix[best][column].weight() == 0.0 {
            return Some(all.integer(0));
        }
        matrix.swap(column, best);
        let own = matrix[column].clone();
        for row in &mut matrix[column + 1..] {
            let factor = row[column].over(&own[column])?;
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry = entry.minus(&own.times(&factor)));
        }
        // row exchanges change only the sign, which does not influence the roots
        all = all.times(&own[column]);
    }
    Some(all)
}
