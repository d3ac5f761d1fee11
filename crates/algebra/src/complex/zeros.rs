//! All zeros of a polynomial: approximated by Weierstrass' iteration, proved by Smith's discs.
//!
//! Let p be monic of degree n, z_1 .. z_n distinct numbers, and w_i = p(z_i) / prod_(j != i) (z_i - z_j). The zeros of
//! p are the eigenvalues of diag(z) - w 1^T. By Gershgorin's theorem the discs about z_i with the radii n |w_i| contain
//! all zeros, and a disc disjoint from the others contains exactly one (Smith 1970), however the z_i were obtained.
//! With enclosed coefficients the statement holds for every polynomial in the enclosures.
//!
//! A disc with a real centre is symmetric: if it is disjoint from the others, its zero is real.

use super::Rectangle;
use crate::real::Enclosure;

/// A simple zero.
#[derive(Clone, Debug)]
pub struct Zero {
    pub at: Rectangle,
    /// Whether the zero is proved to be real; then `at.im` is zero.
    pub real: bool,
}

/// The number of iterations in double precision; convergence is global but slow at first.
const FLOATING: usize = 400;
/// The number of iterations in long arithmetic; each doubles the number of correct digits.
const LONG: usize = 12;
/// An imaginary part smaller than this, relative to the zero, is set to zero; the proof then decides.
const FLAT: f64 = 1e-20;

/// All zeros of a real polynomial, with coefficients from the constant upwards: real ones and conjugate pairs. `None`
/// where the precision does not separate them (zeros that coincide or nearly do), or the leading coefficient may
/// vanish.
pub fn zeros(coefficients: &[Enclosure]) -> Option<Vec<Zero>> {
    let (lead, rest) = coefficients.split_last()?;
    let bits = coefficients.iter().map(Enclosure::bits).min()?;
    let monic: Vec<Enclosure> = rest.iter().map(|c| c.over(lead)).collect::<Option<_>>()?;
    let mut centres: Vec<Rectangle> = floating(&monic)?
        .into_iter()
        .map(|[re, im]| Some(Rectangle { re: Enclosure::float(re, bits)?, im: Enclosure::float(im, bits)? }))
        .collect::<Option<_>>()?;
    for _ in 0..LONG {
        let steps: Vec<Rectangle> =
            (0..centres.len()).map(|i| weierstrass(&monic, &centres, i)).collect::<Option<_>>()?;
        for (centre, step) in centres.iter_mut().zip(steps) {
            *centre = (&*centre - &step.middle()).middle();
            if centre.im.to_f64().abs() <= FLAT * centre.re.to_f64().abs() {
                centre.im = Enclosure::integer(0, bits);
            }
        }
    }
    proved(&monic, &centres, bits)
}

/// The zeros, if all discs are disjoint.
fn proved(monic: &[Enclosure], centres: &[Rectangle], bits: usize) -> Option<Vec<Zero>> {
    let degree = Enclosure::integer(centres.len() as i64, bits);
    let zero = Enclosure::integer(0, bits);
    let radius = |i: usize| Some(&weierstrass(monic, centres, i)?.square().upper().sqrt()?.upper() * &degree);
    let radii: Vec<Enclosure> = (0..centres.len()).map(|i| Some(radius(i)?.upper())).collect::<Option<_>>()?;
    for i in 0..centres.len() {
        for j in 0..i {
            let reach = &radii[i] + &radii[j];
            let gap = &(&centres[i] - &centres[j]).square() - &(&reach * &reach);
            gap.sign().filter(|sign| *sign > 0)?;
        }
    }
    let each = centres.iter().zip(&radii).map(|(centre, radius)| {
        let around = radius.hull(&-radius);
        let real = centre.im.sign() == Some(0);
        let im = if real { zero.clone() } else { &centre.im + &around };
        let known = real || im.sign().is_some_and(|sign| sign != 0);
        known.then(|| Zero { at: Rectangle { re: &centre.re + &around, im }, real })
    });
    each.collect()
}

/// The number w_i at the centres.
fn weierstrass(monic: &[Enclosure], centres: &[Rectangle], i: usize) -> Option<Rectangle> {
    let (at, bits) = (&centres[i], centres[i].re.bits());
    let one = Rectangle::real(Enclosure::integer(1, bits), bits);
    let value = monic.iter().rev().fold(one.clone(), |sum, c| &(&sum * at) + &Rectangle::real(c.clone(), bits));
    let others = centres.iter().enumerate().filter(|(j, _)| *j != i);
    value.over(&others.fold(one, |product, (_, other)| &product * &(at - other)))
}

/// The iteration in double precision, scaled such that no zero is larger than two.
fn floating(monic: &[Enclosure]) -> Option<Vec<[f64; 2]>> {
    let n = monic.len();
    let size = |k: usize| monic[k].to_f64().abs().powf(1.0 / (n - k) as f64);
    let scale = (0..n).map(size).fold(0.0, f64::max);
    if scale == 0.0 || !scale.is_finite() {
        return (n <= 1 && scale == 0.0).then(|| vec![[0.0; 2]; n]);
    }
    let scaled: Vec<f64> = (0..n).map(|k| monic[k].to_f64() / scale.powi((n - k) as i32)).collect();
    let product = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a * c - b * d, a * d + b * c];
    // starting points without symmetry
    let mut z: Vec<[f64; 2]> = (0..n)
        .map(|i| {
            let (sin, cos) = (0.4 + std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
            [cos, sin]
        })
        .collect();
    for _ in 0..FLOATING {
        let mut largest = 0.0f64;
        for i in 0..n {
            let value = scaled.iter().rev().fold([1.0, 0.0], |sum, c| {
                let [re, im] = product(sum, z[i]);
                [re + c, im]
            });
            let others = (0..n).filter(|j| *j != i).map(|j| [z[i][0] - z[j][0], z[i][1] - z[j][1]]);
            let [c, d] = others.fold([1.0, 0.0], product);
            let [re, im] = product(value, [c, -d]);
            let step = [re / (c * c + d * d), im / (c * c + d * d)];
            z[i] = [z[i][0] - step[0], z[i][1] - step[1]];
            largest = largest.max(step[0].abs().max(step[1].abs()) / z[i][0].hypot(z[i][1]).max(f64::MIN_POSITIVE));
        }
        if largest < 1e-15 {
            break;
        }
    }
    let found: Vec<[f64; 2]> = z.into_iter().map(|[re, im]| [re * scale, im * scale]).collect();
    found.iter().flatten().all(|part| part.is_finite()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(coefficients: &[i64]) -> Option<Vec<Zero>> {
        zeros(&coefficients.iter().map(|c| Enclosure::integer(*c, 256)).collect::<Vec<_>>())
    }

    #[test]
    fn real_zeros_are_proved_real_and_the_others_not() {
        // (z - 1) (z + 2) (z^2 - 2z + 5)
        let found = of(&[-10, 9, 1, -1, 1]).expect("all are simple");
        let near = |re: f64, im: f64| {
            let of = |zero: &&Zero| (zero.at.re.to_f64() - re).abs() + (zero.at.im.to_f64() - im).abs() < 1e-50;
            found.iter().find(of).map(|zero| zero.real)
        };
        assert_eq!((near(1.0, 0.0), near(-2.0, 0.0)), (Some(true), Some(true)));
        assert_eq!((near(1.0, 2.0), near(1.0, -2.0)), (Some(false), Some(false)));
    }

    #[test]
    fn a_zero_that_may_be_real_is_no_answer_unless_it_is_proved_to_be() {
        let [zero, one] = [0, 1].map(|n| Enclosure::integer(n, 64));
        let beside =
            |im: &Enclosure| proved(std::slice::from_ref(&zero), &[Rectangle { re: zero.clone(), im: im.clone() }], 64);
        assert!(beside(&zero).is_some_and(|found| found[0].real));
        assert!(beside(&one).is_none());
    }

    #[test]
    fn zeros_that_coincide_are_no_answer() {
        assert!(of(&[1, -2, 1]).is_none());
    }

    #[test]
    fn a_coefficient_that_is_hardly_known_is_no_answer() {
        let coarse = Enclosure::integer(-1, 256).hull(&Enclosure::integer(1, 256));
        assert!(zeros(&[coarse, Enclosure::integer(0, 256), Enclosure::integer(1, 256)]).is_none());
    }
}
