//! Alphabets: the letters of a page with their LaTeX and dimensions.

use claims::Point;
use field::Rational;
use symbolic::{Dimension, Sym};

/// (name, LaTeX, exponents of kg, m, s and, where there are four, A). Each `#` of a name stands for a digit, which takes
/// the place of a `#` of the LaTeX.
pub type Letter<const E: usize> = (&'static str, &'static str, [i64; E]);

fn find<const E: usize>(
    alphabet: impl IntoIterator<Item = &'static Letter<E>>,
    name: &str,
) -> Option<&'static Letter<E>> {
    alphabet.into_iter().find(|(pattern, ..)| matches(pattern, name))
}

/// Whether the name is the pattern with digits in its places.
fn matches(pattern: &str, name: &str) -> bool {
    let mut letters = name.chars();
    pattern.chars().all(|wanted| match letters.next() {
        Some(found) if wanted == '#' => found.is_ascii_digit(),
        found => found == Some(wanted),
    }) && letters.next().is_none()
}

/// The dimension of a name; `None` where the alphabet does not have it.
pub fn dimension<const E: usize>(
    alphabet: impl IntoIterator<Item = &'static Letter<E>>,
    name: &str,
) -> Option<Dimension> {
    let (_, _, exponents) = find(alphabet, name)?;
    let of = |unit: usize| exponents.get(unit).copied().unwrap_or(0);
    Some(Dimension::of(of(0), of(1), of(2), of(3)))
}

/// The symbol of a name, with the alphabet's LaTeX.
pub fn letter<const E: usize>(alphabet: impl IntoIterator<Item = &'static Letter<E>>, name: &str) -> Sym {
    let Some((pattern, latex, _)) = find(alphabet, name) else { return Sym::symbol(name) };
    let places = pattern.chars().zip(name.chars()).filter(|(wanted, _)| *wanted == '#');
    Sym::named(name, &places.fold((*latex).to_string(), |text, (_, digit)| text.replacen('#', &digit.to_string(), 1)))
}

/// An exact point, as (name, numerator, denominator); the coordinates of an angle are `cos θ` and `sin θ`.
pub fn exact<const N: usize>(values: [(&str, i64, i64); N]) -> Point {
    Point::named(values.map(|(name, numerator, denominator)| (name.to_string(), Rational::new(numerator, denominator))))
}
