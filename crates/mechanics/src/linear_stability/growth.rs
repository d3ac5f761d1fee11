//! Bounds of the largest real part of the roots of a real polynomial.
//!
//! The roots of p(mu + r) to the right of the imaginary axis are those of p with real parts above r. They are counted
//! exactly, and r is bisected. This finds growth rates far below the rounding errors of eigenvalues.

use super::HalfPlanes;
use algebra::real::Ordered;
use field::Rational;

/// The exponents of two between which the growth rate is searched.
const POWERS: [i32; 2] = [-1000, 64];
/// The number of intervals into which the last factor of two is divided.
const PARTS: i64 = 64;

/// Lower and upper bound of the largest real part of the roots of a polynomial with these coefficients, the highest
/// first, which must have a root in the right half-plane. The bounds are close if all signs can be determined. `None`
/// where the largest real part is outside the range of the search.
pub fn growth<R: Ordered>(coefficients: &[R]) -> Option<[f64; 2]> {
    let above = |rate: Rational| -> Option<bool> {
        Some(HalfPlanes::of(&shifted(coefficients, &coefficients.first()?.fraction(rate)?))?.right > 0)
    };
    let power = |n: i32| Rational::exactly(2.0_f64.powi(n));
    let [mut low, mut high] = POWERS;
    if above(power(high))? {
        return None;
    }
    let mut seen = false;
    while high - low > 1 {
        let middle = (low + high) / 2;
        match above(power(middle)) {
            Some(false) => high = middle,
            // a shift below the resolution does not separate the roots from the axis
            told => (low, seen) = (middle, told.is_some()),
        }
    }
    if !seen {
        return Some([0.0, 2.0_f64.powi(high)]);
    }
    let part = |n: i64| power(low) * Rational::new(PARTS + n, PARTS);
    let (mut least, mut most) = (0, PARTS);
    while most - least > 1 {
        let middle = (least + most) / 2;
        // a shift equal to a real part leaves the root on the axis, where enclosures do not determine signs: neighbours
        // do
        let beside = [middle, middle + 1, middle - 1].into_iter().filter(|n| (least + 1..most).contains(n));
        match beside.flat_map(|n| above(part(n)).map(|is_above| (n, is_above))).next() {
            Some((n, true)) => least = n,
            Some((n, false)) => most = n,
            None => break,
        }
    }
    Some([part(least).to_f64(), part(most).to_f64()])
}

/// The coefficients of p(mu + r), by repeated Horner schemes.
fn shifted<R: Ordered>(coefficients: &[R], r: &R) -> Vec<R> {
    let mut shifted = coefficients.to_vec();
    for end in (1..shifted.len()).rev() {
        for k in 1..=end {
            shifted[k] = shifted[k].plus(&shifted[k - 1].times(r));
        }
    }
    shifted
}

#[cfg(test)]
mod tests {
    use super::growth;
    use algebra::real::Enclosure;
    use field::Rational;

    #[test]
    fn a_growth_is_enclosed_at_every_size() {
        // (mu - g)(mu + 2)(mu^2 + 1)
        for g in [3.0, 0.1, 1e-9, 1.8e-36, 1e-200] {
            let rate = Rational::exactly(g);
            let [one, two] = [1, 2].map(|n| Rational::new(n, 1));
            let all = [one, two - rate, one - two * rate, two - rate, -two * rate];
            let [low, high] = growth(&all).unwrap();
            assert!(low <= g && g <= high && high <= 1.04 * low, "{g:e}: {low:e} {high:e}");
            let enclosed = all.map(|c| Enclosure::rational(c, 1024).unwrap());
            let [low, high] = growth(&enclosed).unwrap();
            assert!(low <= g && g <= high && high <= 1.04 * low, "{g:e}: {low:e} {high:e}");
        }
    }

    #[test]
    fn of_a_pair_it_is_the_real_part() {
        // (mu - 1/4)^2 + 9
        let all = [Rational::new(1, 1), Rational::new(-1, 2), Rational::new(145, 16)];
        let [low, high] = growth(&all).unwrap();
        assert!((low..=high).contains(&0.25), "{low} {high}");
    }
}
