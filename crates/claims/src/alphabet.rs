//! Alphabets: the letters of a paper with their LaTeX and physical dimensions.

use crate::Point;
use field::Rational;
use symbolic::{Dimension, Sym};

/// A letter: name, LaTeX, and exponents of kg, m, s and, if there are four, A. Each `#` of the name stands for a digit, which also replaces
/// the corresponding `#` of the LaTeX.
pub type Letter<const E: usize> = (&'static str, &'static str, [i64; E]);

fn find<const E: usize>(alphabet: &'static [Letter<E>], name: &str) -> Option<&'static Letter<E>> {
    alphabet.iter().find(|(pattern, ..)| matches(pattern, name))
}

/// Whether a name fits a pattern in which each `#` stands for a digit.
fn matches(pattern: &str, name: &str) -> bool {
    let mut letters = name.chars();
    pattern.chars().all(|wanted| match letters.next() {
        Some(found) if wanted == '#' => found.is_ascii_digit(),
        found => found == Some(wanted),
    }) && letters.next().is_none()
}

/// The dimension of a letter; `None` for a name that is not in the alphabet.
pub fn dimension<const E: usize>(alphabet: &'static [Letter<E>], name: &str) -> Option<Dimension> {
    let (_, _, exponents) = find(alphabet, name)?;
    let of = |unit: usize| exponents.get(unit).copied().unwrap_or(0);
    Some(Dimension::of(of(0), of(1), of(2), of(3)))
}

/// The symbol of a letter with its LaTeX; `None` for a name that is not in the alphabet.
pub fn letter<const E: usize>(alphabet: &'static [Letter<E>], name: &str) -> Option<Sym> {
    let (pattern, latex, _) = find(alphabet, name)?;
    let places = pattern.chars().zip(name.chars()).filter(|(wanted, _)| *wanted == '#');
    let latex = places.fold((*latex).to_string(), |text, (_, digit)| text.replacen('#', &digit.to_string(), 1));
    Some(Sym::named(name, &latex))
}

/// Defines the named functions (`dimension`, `letter`, `letters`, `indexed`, `vector`) for the letters of these alphabets.
#[macro_export]
macro_rules! read_by {
    ($($function:ident),+; $tables:tt) => { $($crate::read_by!(@$function $tables);)+ };
    (@dimension [$($table:expr),+]) => {
        /// The dimension of a letter; `None` for a name that is in no alphabet of the paper.
        pub fn dimension(name: &str) -> Option<$crate::symbolic::Dimension> {
            None$(.or_else(|| $crate::alphabet::dimension($table, name)))+
        }
    };
    (@letter [$($table:expr),+]) => {
        /// The symbol of a letter with its LaTeX; a name that is in no alphabet has its name as LaTeX.
        pub fn letter(name: &str) -> $crate::symbolic::Sym {
            None$(.or_else(|| $crate::alphabet::letter($table, name)))+.unwrap_or_else(|| $crate::symbolic::Sym::symbol(name))
        }
    };
    (@letters $tables:tt) => {
        /// The symbols of several letters.
        pub fn letters<const N: usize>(names: [&str; N]) -> [$crate::symbolic::Sym; N] {
            names.map(letter)
        }
    };
    (@indexed $tables:tt) => {
        /// The symbols of a letter with the indices 1 to N in place of `#`.
        pub fn indexed<const N: usize>(pattern: &str) -> [$crate::symbolic::Sym; N] {
            std::array::from_fn(|i| letter(&pattern.replacen('#', &(i + 1).to_string(), 1)))
        }
    };
    (@vector $tables:tt) => {
        /// The three components of a vector: the letters `stem` followed by 1, 2, 3.
        pub fn vector(stem: &str) -> nalgebra::Vector3<$crate::symbolic::Sym> {
            nalgebra::Vector3::from_fn(|i, _| letter(&format!("{stem}{}", i + 1)))
        }
    };
}
pub use read_by;

/// An exact point from (name, numerator, denominator). An angle θ is given by two values, named `cos θ` and `sin θ`.
pub fn exact<const N: usize>(values: [(&str, i64, i64); N]) -> Point {
    Point::named(values.map(|(name, numerator, denominator)| (name.to_string(), Rational::new(numerator, denominator))))
}
