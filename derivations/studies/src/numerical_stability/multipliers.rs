//! Whether a step's multipliers leave the unit circle, for all step sizes of an interval at once.
//!
//! The entries of the matrix M(h) of a step are Taylor models in h, or enclosed numbers for a single h. The map s =
//! (2/h)(z - 1)/(z + 1) of a multiplier z maps the unit disc to the left half-plane, where Routh's scheme counts roots.
//! If the scheme has a zero that is no threshold, growth is proved by a root beyond a shifted line or, if strong, by
//! the size of a coefficient.

use algebra::real::{Ordered, TaylorModel};
use field::Rational;
use mechanics::linear_stability::{HalfPlanes, characteristic};

/// A matrix, row by row.
pub(super) type Matrix<R = TaylorModel> = Vec<Vec<R>>;

/// Lines Re s = const to the right of which a root is searched, in thousandths of 1/h.
const FURTHER: [i64; 3] = [3, 30, 300];

/// True if a multiplier lies outside the unit circle for every step size of the range, false if none does for any;
/// `None` if undecided. `symmetric`: multipliers come in pairs z, 1/z, as in compositions of Hamiltonian flows.
pub(super) fn grows<R: Ordered>(map: &Matrix<R>, step: &R, symmetric: bool) -> Option<bool> {
    if leaves(&characteristic(map, step)) {
        return Some(true);
    }
    let rate = |(i, row): (usize, &Vec<R>)| -> Option<Vec<R>> {
        let less = |(j, entry): (usize, &R)| entry.minus(&step.integer(i64::from(i == j))).over(step);
        row.iter().enumerate().map(less).collect()
    };
    let rates: Matrix<R> = map.iter().enumerate().map(rate).collect::<Option<_>>()?;
    let mut plane = on_the_plane(&characteristic(&rates, step), step);
    if symmetric {
        // roots come in pairs s, -s
        plane.iter_mut().rev().skip(1).step_by(2).for_each(|odd| *odd = step.integer(0));
    }
    match HalfPlanes::of(&plane) {
        Some(places) => Some(places.right > 0),
        None => FURTHER.iter().find_map(|share| {
            let line = step.fraction(Rational::new(*share, 1000))?.over(step)?;
            HalfPlanes::of(&shifted(&plane, &line)).filter(|places| places.right > 0).map(|_| true)
        }),
    }
}

/// Whether a coefficient of the characteristic polynomial is larger than multipliers in the closed unit disc allow.
fn leaves<R: Ordered>(polynomial: &[R]) -> bool {
    let n = polynomial.len().saturating_sub(1) as i64;
    let mut choices = 1;
    (0..).zip(polynomial).any(|(k, c)| {
        let most = c.integer(choices);
        choices = choices * (n - k) / (k + 1);
        c.minus(&most).sign() == Some(1) || c.plus(&most).sign() == Some(-1)
    })
}

/// A polynomial in w = (z - 1)/h transformed to s = (2/h)(z - 1)/(z + 1), both with the highest power first: w = 2 s/(2 - h s).
fn on_the_plane<R: Ordered>(rates: &[R], step: &R) -> Vec<R> {
    let n = rates.len().saturating_sub(1);
    let (zero, two) = (step.integer(0), step.integer(2));
    let mut sum = vec![zero.clone(); n + 1];
    for (k, rate) in rates.iter().rev().enumerate() {
        // rate (2 s)^k (2 - h s)^(n - k), the constant first
        let mut term = vec![zero.clone(); k];
        term.push((0..k).fold(rate.clone(), |term, _| term.times(&two)));
        for _ in k..n {
            let doubled = term.iter().map(|c| c.times(&two)).chain([zero.clone()]);
            let turned = std::iter::once(zero.clone()).chain(term.iter().map(|c| c.times(step)));
            term = doubled.zip(turned).map(|(a, b)| a.minus(&b)).collect();
        }
        sum.iter_mut().rev().zip(&term).for_each(|(sum, c)| *sum = sum.plus(c));
    }
    sum
}

/// p(s + line), by repeated Horner steps.
fn shifted<R: Ordered>(polynomial: &[R], line: &R) -> Vec<R> {
    let mut shifted = polynomial.to_vec();
    for end in (1..shifted.len()).rev() {
        for k in 1..=end {
            shifted[k] = shifted[k].plus(&shifted[k - 1].times(line));
        }
    }
    shifted
}
