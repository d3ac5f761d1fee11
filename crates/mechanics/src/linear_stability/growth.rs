//! The largest real part of the roots of a real polynomial, between two numbers.
//!
//! p(mu + r) has as many roots to the right of the imaginary axis as p has with a real part above r: they are counted
//! exactly, for r halved and doubled. This finds a growth far below the rounding errors of eigenvalues.

use super::HalfPlanes;
use algebra::real::Ordered;
use field::Rational;

/// Powers of two between which the growth is sought.
const POWERS: [i32; 2] = [-1000, 64];
/// Parts into which the last doubling is divided.
const PARTS: i64 = 64;

/// Two numbers between which the largest real part lies, close together where every sign is known; of a polynomial with these
/// coefficients, the highest first, of which a root is known to lie to the right. `None` where it is beyond all bounds.
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
            // a shift that is too small does not part roots from the axis
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
        // a shift that hits a root exactly leaves it on the axis, where enclosures do not tell it: its neighbours do
        let beside = [middle, middle + 1, middle - 1].into_iter().filter(|n| (least + 1..most).contains(n));
        match beside.flat_map(|n| above(part(n)).map(|is_above| (n, is_above))).next() {
            Some((n, true)) => least = n,
            Some((n, false)) => most = n,
            None => break,
        }
    }
    Some([part(least).to_f64(), part(most).to_f64()])
}

/// p(mu + r), by Horner's scheme again and again.
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
