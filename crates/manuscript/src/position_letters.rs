//! Expressions of the position in the paper's letters: direction cosines instead of the four coordinates of a free frame, or instead of
//! products of sines and cosines.

use crate::letters::Letters;
use algebra::linear::nonnegative_combination;
use field::Rational;
use std::collections::{BTreeMap, BTreeSet};
use symbolic::{Hypotheses, Sym, coefficients, normal};

/// The largest number of letters; [`MOST_TERMS`]: of terms. Beyond these numbers an expression keeps the symbols of the model.
const MOST_LETTERS: usize = 9;
const MOST_TERMS: usize = 200;

/// A polynomial in functions of the position: coefficients by exponents.
type Terms = BTreeMap<Vec<u32>, Rational>;

/// A product of letters, in the paper's symbols and as a polynomial in functions of the position.
struct Product {
    own: Sym,
    terms: Terms,
}

/// An expression of the model as a polynomial of at most second degree in those letters of the paper that are functions of the position. `None` if there
/// is no such polynomial under the hypotheses.
pub(crate) fn by_position_letters(letters: &Letters<'_, '_>, expression: Sym, hypotheses: &Hypotheses) -> Option<Sym> {
    let coordinates = &letters.trace.coordinates;
    let varies = |leaf: &Sym| leaf.as_constant().is_none();
    let is_position = |leaf: &Sym| varies(leaf) && leaf.symbols_of().iter().all(|symbol| coordinates.contains(symbol));
    let of_positions: Vec<(Sym, Sym)> = letters
        .scalars()
        .filter(|(_, value, ..)| value.symbol_name().is_none() && is_position(value))
        .map(|(_, value, own, _)| (own, value))
        .collect();
    if of_positions.is_empty() || of_positions.len() > MOST_LETTERS {
        return None;
    }
    let form = normal(expression, hypotheses).ok()?;
    let (above, below) = (form.numerator(), form.denominator());
    let values = of_positions.iter().map(|(_, value)| *value);
    let (mut leaves, mut others): (Vec<Sym>, Vec<Sym>) =
        values.chain([above]).flat_map(Sym::leaves_of).filter(varies).partition(is_position);
    for each in [&mut leaves, &mut others] {
        each.sort_unstable();
        each.dedup();
    }
    if below.leaves_of().iter().any(|leaf| leaves.contains(leaf)) {
        return None;
    }
    // the coefficient, a polynomial, of each product of all other letters
    let mut wanted: BTreeMap<Vec<u32>, Terms> = BTreeMap::new();
    for (mut exponents, value) in terms(above, &[&leaves[..], &others].concat())? {
        let of_others = exponents.split_off(leaves.len());
        wanted.entry(of_others).or_default().insert(exponents, value);
    }
    let product = |own: Sym, value: Sym| {
        let form = normal(value, hypotheses).ok()?;
        form.denominator().as_constant()?;
        Some(Product { own, terms: terms(form.to_sym(), &leaves)? })
    };
    let mut products = vec![product(Sym::ONE, Sym::ONE)?];
    products.extend(of_positions.iter().filter_map(|&(own, value)| product(own, value)));
    let found = combinations(&wanted, &products).or_else(|| {
        for (place, &(own, value)) in of_positions.iter().enumerate() {
            let pairs = of_positions[place..].iter();
            products.extend(pairs.filter_map(|&(other, factor)| product(own * other, value * factor)));
        }
        combinations(&wanted, &products)
    })?;
    // placeholders are needed, since a letter of the paper may be a name of the model with another meaning
    let kept: Vec<(Sym, Sym)> = products
        .iter()
        .enumerate()
        .map(|(place, product)| (Sym::symbol(&format!("product {place}")), product.own))
        .collect();
    let mut sum = Sym::ZERO;
    for (of_others, factors) in wanted.keys().zip(found) {
        let other = others
            .iter()
            .zip(of_others)
            .fold(Sym::ONE, |all, (&leaf, &power)| (0..power).fold(all, |all, _| all * leaf));
        for (factor, (letter, _)) in factors.into_iter().zip(&kept).filter(|(factor, _)| factor.sign() != Some(0)) {
            sum += Sym::constant(factor) * other * *letter;
        }
    }
    Some(letters.told(sum / below).substitute(&kept))
}

/// For each polynomial, the coefficients with which it is a sum of the products; `None` if one of them is not such a sum.
fn combinations(wanted: &BTreeMap<Vec<u32>, Terms>, products: &[Product]) -> Option<Vec<Vec<Rational>>> {
    let zero = Rational::new(0, 1);
    wanted
        .values()
        .map(|target| {
            let all = products.iter().map(|product| &product.terms).chain([target]);
            let rows: BTreeSet<&Vec<u32>> = all.flat_map(BTreeMap::keys).collect();
            let column = |terms: &Terms| -> Vec<Rational> {
                rows.iter().map(|exponents| terms.get(*exponents).copied().unwrap_or(zero)).collect()
            };
            // a coefficient of either sign is a difference of two nonnegative ones
            let columns: Vec<Vec<Rational>> = products.iter().map(|product| column(&product.terms)).collect();
            // since products of direction cosines are linearly dependent, sums of one or two products are preferred
            if let Some(found) = of_one_or_two(&columns, &column(target)) {
                return Some(found);
            }
            let opposite = columns.iter().map(|own| own.iter().map(|entry| -*entry).collect());
            let both: Vec<Vec<Rational>> = columns.iter().cloned().chain(opposite).collect();
            let found = nonnegative_combination(&both, &column(target))?;
            let (up, down) = found.split_at(products.len());
            Some(up.iter().zip(down).map(|(up, down)| *up - *down).collect())
        })
        .collect()
}

/// The factors with which one column, or the sum of two, equals the target; `None` if there are none.
fn of_one_or_two(columns: &[Vec<Rational>], target: &[Rational]) -> Option<Vec<Rational>> {
    let zero = Rational::new(0, 1);
    let is_zero = |entry: &Rational| *entry == zero;
    // the difference between a column and a multiple of another one
    let rest = |own: &[Rational], factor: Rational, of: &[Rational]| -> Vec<Rational> {
        of.iter().zip(own).map(|(entry, own)| *entry - factor * *own).collect()
    };
    let alone = |of: &[Rational], from: usize| {
        columns.iter().enumerate().skip(from).find_map(|(place, own)| {
            let first = own.iter().position(|entry| !is_zero(entry))?;
            let factor = of[first] / own[first];
            rest(own, factor, of).iter().all(is_zero).then_some((place, factor))
        })
    };
    let with = |chosen: &[(usize, Rational)]| {
        let mut factors = vec![zero; columns.len()];
        chosen.iter().for_each(|&(place, factor)| factors[place] = factor);
        factors
    };
    if let Some(one) = alone(target, 0) {
        return Some(with(&[one]));
    }
    columns.iter().enumerate().find_map(|(place, own)| {
        let entries = own.iter().enumerate().filter(|(_, entry)| !is_zero(entry));
        let mut factors: Vec<Rational> = Vec::new();
        for factor in entries.map(|(row, entry)| target[row] / *entry).filter(|factor| !is_zero(factor)) {
            if !factors.contains(&factor) {
                factors.push(factor);
            }
        }
        factors.into_iter().find_map(|factor| {
            let other = alone(&rest(own, factor, target), place + 1)?;
            Some(with(&[(place, factor), other]))
        })
    })
}

/// The terms of a polynomial in `leaves`; `None` for other expressions, or if there are too many terms.
fn terms(polynomial: Sym, leaves: &[Sym]) -> Option<Terms> {
    let found = coefficients(polynomial, leaves).ok().filter(|found| found.len() <= MOST_TERMS)?;
    let number = |value: Sym| normal(value, &Hypotheses::none()).ok()?.as_constant();
    found.into_iter().map(|(exponents, value)| Some((exponents, number(value)?))).collect()
}
