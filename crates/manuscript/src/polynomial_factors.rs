//! Factors of a polynomial: common factors of the coefficients of a letter, and the two factors of a polynomial of second degree whose
//! discriminant is a square.

use field::Analytic;
use symbolic::{Hypotheses, Sym, coefficients, decide, normal};

/// The largest number of successive splits of a polynomial.
const DEPTH: usize = 8;

/// The factors of a polynomial that are found; the polynomial itself if there are none.
pub(crate) fn polynomial_factors(polynomial: Sym) -> Vec<Sym> {
    parted(polynomial, DEPTH)
}

fn parted(polynomial: Sym, depth: usize) -> Vec<Sym> {
    let leaves: Vec<Sym> = polynomial.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none()).collect();
    let split = leaves.into_iter().filter(|_| depth > 0).find_map(|leaf| split_by(polynomial, leaf));
    match split {
        Some((one, other)) => [parted(one, depth - 1), parted(other, depth - 1)].concat(),
        None => vec![polynomial],
    }
}

/// Two factors of a polynomial, from its coefficients as a polynomial in a letter.
fn split_by(polynomial: Sym, leaf: Sym) -> Option<(Sym, Sym)> {
    let form = |of: Sym| normal(of, &Hypotheses::none()).ok();
    let dense = dense(polynomial, leaf)?;
    let lowest = dense.iter().position(|value| *value != Sym::ZERO)?;
    if lowest > 0 && polynomial != leaf {
        return Some((leaf, form(polynomial / leaf)?.numerator()));
    }
    match dense[..] {
        [constant, slope] => {
            let below = form(constant / slope)?.denominator();
            // the normal form of a quotient may express sines by cosines in its denominator
            let common = form(slope / below).filter(|common| common.denominator().as_constant().is_some())?.to_sym();
            let rest = form(polynomial / common)?.numerator();
            common.as_constant().is_none().then_some((common, rest))
        }
        [constant, slope, leading] => {
            let four = Sym::ONE + Sym::ONE + Sym::ONE + Sym::ONE;
            let root = square_root(form(slope * slope - four * leading * constant)?.to_sym())?;
            let one = form((leading + leading) * leaf + slope - root)?.numerator();
            let other = form(polynomial / one)?;
            other.denominator().as_constant().is_some().then(|| (one, other.numerator()))
        }
        _ => None,
    }
}

/// The coefficients of a letter by ascending powers.
fn dense(polynomial: Sym, leaf: Sym) -> Option<Vec<Sym>> {
    let terms = coefficients(polynomial, &[leaf]).ok()?;
    let highest = terms.iter().map(|(powers, _)| powers[0]).max()?;
    let of = |power: u32| terms.iter().find(|(powers, _)| powers[0] == power).map_or(Sym::ZERO, |(_, value)| *value);
    Some((0..=highest).map(of).collect())
}

/// The polynomial whose square is the given one, by its coefficients from the highest power on; `None` if it is not a square.
pub(crate) fn square_root(polynomial: Sym) -> Option<Sym> {
    let form = |of: Sym| normal(of, &Hypotheses::none()).ok().map(|form| form.to_sym());
    if let Some(value) = polynomial.as_constant() {
        let root = form(Sym::constant(value).sqrt())?;
        return root.as_constant().filter(|root| root.is_defined()).map(Sym::constant);
    }
    let leaf = polynomial.leaves_of().into_iter().find(|leaf| leaf.as_constant().is_none())?;
    let dense = dense(polynomial, leaf)?;
    let degree = dense.len() - 1;
    if degree % 2 == 1 {
        return None;
    }
    let half = degree / 2;
    let mut root = vec![Sym::ZERO; half + 1];
    root[half] = square_root(form(dense[degree])?)?;
    for power in (0..half).rev() {
        let products = (power + 1..half).map(|other| root[other] * root[half + power - other]);
        let known = products.fold(Sym::ZERO, |sum, product| sum + product);
        root[power] = form((dense[half + power] - known) / (root[half] + root[half]))?;
    }
    let value = root.iter().rev().fold(Sym::ZERO, |sum, part| sum * leaf + *part);
    decide(value * value - polynomial, &Hypotheses::none()).is_zero().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(factors: Vec<Sym>) -> Sym {
        factors.into_iter().fold(Sym::ONE, |product, factor| product * factor)
    }

    #[test]
    fn differences_and_sums_of_squares_are_taken_apart_where_their_factors_have_rational_coefficients() {
        let [x, y, a] = ["x", "y", "a"].map(Sym::symbol);
        let written = [x * x - y * y, x * x - a * x * y - (a + Sym::ONE) * y * y, a * x - a * y, x * x + x * y];
        for polynomial in written.map(|one| normal(one, &Hypotheses::none()).expect("a polynomial").to_sym()) {
            let factors = polynomial_factors(polynomial);
            assert_eq!(factors.len(), 2, "{polynomial}: {factors:?}");
            let quotient = normal(polynomial / product(factors), &Hypotheses::none()).expect("a quotient").to_sym();
            assert!(quotient.as_constant().is_some(), "{polynomial}");
        }
        for whole in [x * x + y * y, x * x - y, x * x - a * y * y] {
            assert_eq!(polynomial_factors(whole).len(), 1, "{whole}");
        }
    }
}
