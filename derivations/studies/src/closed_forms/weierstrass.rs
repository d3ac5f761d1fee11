//! Weierstrass' elliptic function P(z; g2, g3) on the real line: P'^2 = 4 P^3 - g2 P - g3.
//!
//! The argument is reduced to the interval between the half-periods, halved until the Laurent series converges, and
//! doubled again.

use integrators::Real;

/// Below this argument, in units of max(|g2|^(1/4), |g3|^(1/6))^-1, which is less than half of the smallest period, the
/// terms after `TERMS` powers of z^2 are below rounding in double-double. At much smaller arguments rounding would hide
/// g3.
const SMALL: f64 = 1.5;
const TERMS: usize = 56;

/// The largest number of Newton steps for the largest root from an upper bound: some tens of linear, then five of
/// quadratic convergence.
const NEWTON: usize = 200;

/// The invariants g2, g3 with the real period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice<S> {
    g2: S,
    g3: S,
    /// The real period; infinite where the two smaller roots of the cubic coincide.
    pub period: S,
}

/// The function and its derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weierstrass<S> {
    pub value: S,
    pub slope: S,
}

impl<S: Real> Lattice<S> {
    /// The lattice with the given invariants.
    ///
    /// With e1 the largest root of 4 x^3 - g2 x - g3 and q = g2 - 3 e1^2, the other two are (-e1 +- sqrt q)/2, and the period
    /// is pi / M(sqrt(e1 - e2), sqrt(e1 - e3)); where q < 0, with r^2 = 3 e1^2 - g2/4, 2 pi / M(2 sqrt r, sqrt(3 e1 + 2 r))
    /// (Cohen, A Course in Computational Algebraic Number Theory, 7.4). M is the arithmetic-geometric mean.
    pub fn new(g2: S, g3: S) -> Self {
        let e1 = largest_root(g2, g3);
        let q = g2 - S::int(3) * e1 * e1;
        let nearly = S::lift(std::f64::consts::PI);
        let pi = nearly + nearly.circle().sin;
        let period = if q < S::zero() {
            let r = (S::int(3) * e1 * e1 - g2 * S::ratio(1, 4)).sqrt();
            pi / mean(S::int(2) * r.sqrt(), (S::int(3) * e1 + S::int(2) * r).sqrt()) * S::int(2)
        } else {
            let (middle, half) = (S::ratio(3, 2) * e1, q.sqrt().half());
            pi / mean((middle - half).sqrt(), (middle + half).sqrt())
        };
        Lattice { g2, g3, period }
    }

    /// The function at a real argument; `None` at a period, where it is infinite.
    pub fn at(&self, z: S) -> Option<Weierstrass<S>> {
        let turns = (z.approx() / self.period.approx()).round();
        let z = if turns.is_finite() { z - self.period * S::lift(turns) } else { z };
        if z == S::zero() {
            return None;
        }
        let scale = self.g2.approx().abs().powf(0.25).max(self.g3.approx().abs().powf(1.0 / 6.0));
        let halvings = (z.approx().abs() * scale / SMALL).log2().ceil().clamp(0.0, 60.0) as u32;
        let small = (0..halvings).fold(z, |z, _| z.half());
        Some((0..halvings).fold(self.series(small), |one, _| one.doubled(self.g2)))
    }

    /// The Laurent series 1/z^2 + sum c_k z^(2k - 2) with c_2 = g2/20, c_3 = g3/28, (2k + 1)(k - 3) c_k = 3 sum c_m
    /// c_(k - m), 2 <= m <= k - 2.
    fn series(&self, z: S) -> Weierstrass<S> {
        let mut c = [S::zero(); TERMS];
        (c[2], c[3]) = (self.g2 * S::ratio(1, 20), self.g3 * S::ratio(1, 28));
        for k in 4..TERMS {
            let sum = (2..=k - 2).fold(S::zero(), |sum, m| sum + c[m] * c[k - m]);
            c[k] = sum * S::ratio(3, (2 * k as i64 + 1) * (k as i64 - 3));
        }
        let square = z * z;
        let (mut value, mut slope) = (S::zero(), S::zero());
        for k in (2..TERMS).rev() {
            value = value * square + c[k];
            slope = slope * square + c[k] * S::int(2 * k as i64 - 2);
        }
        let (value, slope) = (value * square, slope * z);
        Weierstrass { value: value + S::one() / square, slope: slope - S::int(2) / (square * z) }
    }
}

impl<S: Real> Weierstrass<S> {
    /// The duplication formula P(2 z) = L^2 - 2 P with L = P''/(2 P'), and its derivative P'(2 z) = L (6 P - 2 L^2) -
    /// P'.
    fn doubled(self, g2: S) -> Self {
        let Weierstrass { value, slope } = self;
        let second = S::int(6) * value * value - g2.half();
        let tangent = second / (S::int(2) * slope);
        let square = tangent * tangent;
        Weierstrass {
            value: square - S::int(2) * value,
            slope: tangent * (S::int(6) * value - S::int(2) * square) - slope,
        }
    }
}

/// The largest root of 4 x^3 - g2 x - g3 by Newton's method from above, where the cubic is convex and the iterates
/// decrease.
fn largest_root<S: Real>(g2: S, g3: S) -> S {
    let mut x = S::lift(g2.approx().abs().sqrt().max(g3.approx().abs().cbrt()).max(f64::MIN_POSITIVE));
    for _ in 0..NEWTON {
        let slope = S::int(12) * x * x - g2;
        let next = x - (S::int(4) * x * x * x - g2 * x - g3) / slope;
        // at the root rounding ends the monotonic decrease
        match next < x {
            true if next.finite() => x = next,
            _ => break,
        }
    }
    x
}

/// The arithmetic-geometric mean; the iteration converges quadratically.
fn mean<S: Real>(mut a: S, mut b: S) -> S {
    for _ in 0..64 {
        if (a - b).approx().abs() <= 4.0 * S::EPSILON * a.approx() {
            break;
        }
        (a, b) = ((a + b).half(), (a * b).sqrt());
    }
    a
}
