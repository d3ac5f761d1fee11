//! Exact sines and cosines of multiples of pi/12 by square roots: cos(pi/12) = (sqrt(6) + sqrt(2))/4.

use crate::Sym;
use dashu_int::IBig;
use field::{Analytic, Circle, Rational, Scalar};

impl Sym {
    /// Returns the exact (cos, sin) of the angle pi k/12.
    pub fn of_twelfths(k: i64) -> Circle<Sym> {
        Circle { cos: cosine(k), sin: cosine(k - 6) }
    }

    /// Returns the exact (cos, sin) of the angle pi * `number`; `None` if the angle is not a multiple of pi/12.
    pub fn of_half_turns(number: Rational) -> Option<Circle<Sym>> {
        let twelfths = (number * Rational::new(12, 1)).to_big().filter(dashu_ratio::RBig::is_int)?;
        // the remainder is the angle modulo full turns
        let around = i64::try_from(twelfths.numerator() % IBig::from(24)).ok()?;
        Some(Self::of_twelfths(around))
    }
}

fn cosine(k: i64) -> Sym {
    let root = |square: i64| Sym::int(square).sqrt();
    let around = k.rem_euclid(24);
    match if around > 12 { 24 - around } else { around } {
        0 => Sym::ONE,
        1 => (root(6) + root(2)) / Sym::int(4),
        2 => root(3) / Sym::int(2),
        3 => root(2) / Sym::int(2),
        4 => Sym::ratio(1, 2),
        5 => (root(6) - root(2)) / Sym::int(4),
        6 => Sym::ZERO,
        obtuse => -cosine(12 - obtuse),
    }
}

#[cfg(test)]
mod tests {
    use crate::Sym;

    #[test]
    fn circle_points_have_their_values() {
        for k in -30_i64..30 {
            let point = Sym::of_twelfths(k);
            let value = |part: Sym| part.evaluate_analytic::<f64>(&|_| None).expect("it has no letters");
            // the angle is at most 2 pi, hence its rounding error is below 1e-15
            let (sin, cos) = (k.rem_euclid(24) as f64 * std::f64::consts::PI / 12.0).sin_cos();
            assert!((value(point.cos) - cos).abs() < 2e-15 && (value(point.sin) - sin).abs() < 2e-15, "{k}");
        }
    }
}
