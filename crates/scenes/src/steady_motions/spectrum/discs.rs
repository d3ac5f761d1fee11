//! Discs that contain the roots of a real polynomial with enclosed coefficients.
//!
//! For distinct approximate roots z_1 ... z_n, the discs about z_i of radius n |W_i|,
//!
//!   W_i = p(z_i) / (a_n prod_(j != i) (z_i - z_j)) ,
//!
//! contain all roots, and a connected union of discs contains as many roots as discs (Smith 1970). Roots of real polynomials come in conjugate
//! pairs, those of conservative systems also in pairs of opposite sign. If a disc contains a single root and only this disc meets its mirror
//! image, the root is therefore on the axis of the mirror.

use algebra::real::{Ball, Ordered};
use field::{DoubleDouble, Over, Scalar};
use num_traits::Zero;

/// Largest number of iterations that improve the approximate roots.
const STEPS: usize = 60;

/// Size in 1/s to which the initial distances between approximate roots are relative if all are zero.
const LEAST: f64 = 1e-12;

/// Relative tolerance for rounding errors of distances and radii.
const SLACK: f64 = 1e-9;

/// The position of a disc relative to the imaginary axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    /// The eigenvalue is proved to be on the imaginary axis.
    Axis,
    Right,
    /// The disc touches the imaginary axis.
    Undecided,
}

/// A disc in the complex plane that contains exactly `count` eigenvalues; centre (real and imaginary part) and radius in 1/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EigenvalueDisc {
    pub centre: [f64; 2],
    pub radius: f64,
    pub count: usize,
    pub side: Side,
}

#[derive(Clone, Copy)]
struct Complex<S> {
    re: S,
    im: S,
}

impl<S: Scalar> Complex<S> {
    fn one() -> Self {
        Complex { re: S::one(), im: S::zero() }
    }

    fn plus(self, b: Self) -> Self {
        Complex { re: self.re + b.re, im: self.im + b.im }
    }

    fn minus(self, b: Self) -> Self {
        Complex { re: self.re - b.re, im: self.im - b.im }
    }

    fn times(self, b: Self) -> Self {
        Complex { re: self.re * b.re - self.im * b.im, im: self.re * b.im + self.im * b.re }
    }

    fn over(self, b: Self) -> Self {
        let square = b.re * b.re + b.im * b.im;
        let product = self.times(Complex { re: b.re, im: -b.im });
        Complex { re: product.re / square, im: product.im / square }
    }

    /// The values of p and p'; the highest coefficient comes first.
    fn polynomial(self, coefficients: &[S]) -> [Self; 2] {
        let zero = Complex { re: S::zero(), im: S::zero() };
        coefficients.iter().fold([zero; 2], |[value, slope], &c| {
            [value.times(self).plus(Complex { re: c, im: S::zero() }), slope.times(self).plus(value)]
        })
    }
}

fn near(z: Complex<DoubleDouble>) -> [f64; 2] {
    [z.re.hi(), z.im.hi()]
}

fn size([re, im]: [f64; 2]) -> f64 {
    re.hypot(im)
}

/// Discs for the roots of a polynomial, highest coefficient first, from the approximate roots `begin`. `is_even` says that roots come in pairs of
/// opposite sign. `None` if a disc is unbounded.
pub(super) fn discs(coefficients: &[Ball], begin: &[[f64; 2]], is_even: bool) -> Option<Vec<EigenvalueDisc>> {
    let n = begin.len();
    if coefficients.len() != n + 1 {
        return None;
    }
    let centres = improved(coefficients, begin);
    let radii = radii(coefficients, &centres)?;
    let places: Vec<[f64; 2]> = centres.iter().map(|z| near(*z)).collect();
    let meet = |a: [f64; 2], b: [f64; 2], radius: f64| {
        let rounded = f64::EPSILON * (size(a) + size(b));
        size([a[0] - b[0], a[1] - b[1]]) <= (radius + rounded) * (1.0 + SLACK)
    };
    let mut group: Vec<usize> = (0..n).collect();
    for i in 0..n {
        for j in 0..i {
            let (one, other) = (group[i], group[j]);
            if one != other && meet(places[i], places[j], radii[i] + radii[j]) {
                group.iter_mut().filter(|own| **own == one).for_each(|own| *own = other);
            }
        }
    }
    let mut all = Vec::new();
    for own in 0..n {
        let members: Vec<usize> = (0..n).filter(|&k| group[k] == own).collect();
        let alone = |image: &dyn Fn([f64; 2]) -> [f64; 2]| match members[..] {
            // the mirror image meets this disc and no other
            [k] => (0..n).all(|j| meet(image(places[k]), places[j], radii[k] + radii[j]) == (j == k)),
            _ => false,
        };
        let count = members.len();
        let Some(&first) = members.first() else { continue };
        let mean = |part: usize| members.iter().map(|&k| places[k][part]).sum::<f64>() / count as f64;
        let mut centre = if count == 1 { places[first] } else { [mean(0), mean(1)] };
        if alone(&|[re, im]| [re, -im]) {
            centre[1] = 0.0;
        }
        let is_on_axis = is_even && alone(&|[re, im]| [-re, im]);
        if is_on_axis {
            centre[0] = 0.0;
        }
        let reach = |&k: &usize| size([centre[0] - places[k][0], centre[1] - places[k][1]]) + radii[k];
        let radius = members.iter().map(reach).fold(0.0, f64::max);
        let is_beyond = |sign: f64| members.iter().all(|&k| sign * places[k][0] * (1.0 - SLACK) > radii[k]);
        let side = match () {
            () if is_on_axis => Side::Axis,
            () if is_beyond(-1.0) => Side::Left,
            () if is_beyond(1.0) => Side::Right,
            () => Side::Undecided,
        };
        // the centre is rounded to double precision
        let radius = (radius + f64::EPSILON * size(centre)) * (1.0 + SLACK);
        // the centre of a cluster about zero becomes exactly zero
        let (centre, radius) =
            if count > 1 && size(centre) <= radius { ([0.0; 2], 2.0 * radius) } else { (centre, radius) };
        all.push(EigenvalueDisc { centre, radius, count, side });
    }
    all.sort_by(|a, b| b.centre[0].total_cmp(&a.centre[0]).then(b.centre[1].total_cmp(&a.centre[1])));
    Some(all)
}

/// Better approximate roots, by the method of Ehrlich and Aberth for all roots together.
fn improved(coefficients: &[Ball], begin: &[[f64; 2]]) -> Vec<Complex<DoubleDouble>> {
    let middle: Vec<DoubleDouble> = coefficients.iter().map(Ball::middle).collect();
    let largest = begin.iter().map(|z| size(*z)).fold(0.0, f64::max);
    let lift = |value: f64| DoubleDouble::lift(value);
    // makes the starting values distinct
    let aside = |k: usize| (k + 1) as f64 * 1e-13;
    let apart = |(k, &[re, im]): (usize, &[f64; 2])| {
        let by = aside(k) * (size([re, im]) + 1e-6 * largest + LEAST);
        Complex { re: lift(re + by), im: lift(im + 0.7 * by) }
    };
    let mut all: Vec<Complex<DoubleDouble>> = begin.iter().enumerate().map(apart).collect();
    for _ in 0..STEPS {
        let mut moved = 0.0_f64;
        for k in 0..all.len() {
            let z = all[k];
            let [value, slope] = z.polynomial(&middle);
            if value.re.is_zero() && value.im.is_zero() {
                continue;
            }
            let zero = Complex { re: lift(0.0), im: lift(0.0) };
            let others = (0..all.len()).filter(|&j| j != k);
            let sum = others.fold(zero, |sum, j| sum.plus(Complex::one().over(z.minus(all[j]))));
            let step = value.over(slope.minus(value.times(sum)));
            let way = size(near(step));
            if way.is_finite() && way > 0.0 {
                all[k] = z.minus(step);
                moved = moved.max(way / size(near(z)).max(f64::MIN_POSITIVE));
            }
        }
        if moved < 1e-29 {
            break;
        }
    }
    all
}

/// The radii n |W_i|, rounded up; `None` if one is infinite.
fn radii(coefficients: &[Ball], centres: &[Complex<DoubleDouble>]) -> Option<Vec<f64>> {
    let n = centres.len();
    let exact: Vec<Complex<Ball>> =
        centres.iter().map(|z| Complex { re: Ball::number(z.re), im: Ball::number(z.im) }).collect();
    let lead = coefficients.first()?;
    let radius = |i: usize| {
        let z = exact[i];
        let [value, _] = z.polynomial(coefficients);
        let others = (0..n).filter(|&j| j != i);
        let below = others.fold(Complex { re: *lead, im: Ball::zero() }, |all, j| all.times(z.minus(exact[j])));
        let correction = value.over(below);
        let square = correction.re.times(&correction.re).plus(&correction.im.times(&correction.im));
        let radius = n as f64 * square.size().sqrt() * (1.0 + SLACK);
        radius.is_finite().then_some(radius)
    };
    (0..n).map(radius).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn balls(coefficients: &[f64]) -> Vec<Ball> {
        coefficients.iter().map(|c| Ball::constant(*c)).collect()
    }

    #[test]
    fn discs_hold_roots_and_tell_sides() {
        // (x + 1)(x - 2)(x^2 + 9)
        let all = balls(&[1.0, -1.0, 7.0, -9.0, -18.0]);
        let begin = [[-1.001, 0.0], [2.001, 0.0], [0.001, 3.0], [0.001, -3.0]];
        let found = discs(&all, &begin, false).expect("they have bounds");
        let sides: Vec<Side> = found.iter().map(|disc| disc.side).collect();
        assert_eq!(found.len(), 4);
        assert!(sides.contains(&Side::Left) && sides.contains(&Side::Right), "{found:?}");
        assert_eq!(sides.iter().filter(|side| **side == Side::Undecided).count(), 2);
        assert!(found.iter().all(|disc| disc.radius < 1e-14), "{found:?}");
        let double = discs(&balls(&[1.0, 2.0, 1.0]), &[[-1.0, 0.0], [-1.0, 0.0]], false).expect("they have bounds");
        assert_eq!((double.len(), double[0].count, double[0].side), (1, 2, Side::Left));
        let zeros = discs(&balls(&[1.0, 0.0, 0.0]), &[[0.0, 0.0], [0.0, 0.0]], false).expect("they have bounds");
        assert_eq!((zeros.len(), zeros[0].count, zeros[0].side), (1, 2, Side::Undecided));
    }

    #[test]
    fn a_root_alone_with_its_mirror_image_lies_on_the_axis() {
        // (x^2 + 4)(x^2 + 9)
        let even = balls(&[1.0, 0.0, 13.0, 0.0, 36.0]);
        let begin = [[1e-9, 2.0], [1e-9, -2.0], [0.0, 3.0], [0.0, -3.0]];
        let found = discs(&even, &begin, true).expect("they have bounds");
        assert!(found.iter().all(|disc| disc.side == Side::Axis && disc.centre[0] == 0.0), "{found:?}");
        let open = discs(&even, &begin, false).expect("they have bounds");
        assert!(open.iter().all(|disc| disc.side == Side::Undecided), "{open:?}");
    }
}
