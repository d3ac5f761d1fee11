//! Bounds of a signal over an interval from its values and rates at both ends. They decide whether the signal has a
//! zero.
//!
//! The error e of the cubic Hermite interpolant has a double zero at each end. With |e(s)| <= 16 d s^2 (1 - s)^2, where
//! d is the error bound at the middle ("doubt"), the signal lies between two polynomials of degree 4. Their Bernstein
//! coefficients
//!
//!   a,  (a + 3 p)/4,  (p + q)/2 -+ 8/3 d,  (3 q + b)/4,  b,    p = a + h a'/3,  q = b - h b'/3,
//!
//! differ only in the middle one. If all are positive, there is no zero; with one change of sign, there is exactly one
//! (Descartes' rule of signs).

use super::Signal;

/// The factor of d in the middle coefficient: 16 over the binomial coefficient 6.
const SHARE: f64 = 16.0 / 6.0;

/// An interval with the signal at both ends a and b.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    a: Signal,
    b: Signal,
    /// The length of the interval from a to b in s, negative for runs backwards in time.
    length: f64,
    /// The error bound d of the cubic at the middle.
    doubt: f64,
}

impl Bounds {
    pub fn new(a: Signal, b: Signal, length: f64, doubt: f64) -> Self {
        Bounds { a, b, length, doubt }
    }

    pub fn length(&self) -> f64 {
        self.length
    }

    pub fn doubt(&self) -> f64 {
        self.doubt
    }

    /// The inner coefficients p and q of the cubic.
    fn inner(&self) -> [f64; 2] {
        let third = self.length / 3.0;
        [self.a.value + third * self.a.rate, self.b.value - third * self.b.rate]
    }

    /// The Bernstein coefficients for d = 0.
    fn coefficients(&self) -> [f64; 5] {
        let ([p, q], a, b) = (self.inner(), self.a.value, self.b.value);
        [a, 0.25 * (a + 3.0 * p), 0.5 * (p + q), 0.25 * (3.0 * q + b), b]
    }

    /// The largest distance of the inner coefficients of the cubic from its chord.
    pub fn bow(&self) -> f64 {
        let ([p, q], rise) = (self.inner(), self.b.value - self.a.value);
        (p - self.a.value - rise / 3.0).abs().max((q - self.b.value + rise / 3.0).abs())
    }

    /// The difference between the largest and the smallest coefficient of the cubic.
    pub fn spread(&self) -> f64 {
        let all = self.coefficients();
        all.iter().copied().fold(f64::NEG_INFINITY, f64::max) - all.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// An upper bound of the signal.
    pub fn greatest(&self) -> f64 {
        self.coefficients().iter().copied().fold(f64::NEG_INFINITY, f64::max) + SHARE * self.doubt
    }

    /// A lower bound of the signal.
    pub fn least(&self) -> f64 {
        let [a, p, middle, q, b] = self.coefficients();
        [a, p, middle - SHARE * self.doubt, q, b].into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Whether a signal that is nonnegative at the beginning stays so; values above `-noise` at the beginning count as
    /// nonnegative.
    pub fn stays_up(&self, noise: f64) -> bool {
        let [a, p, middle, q, b] = self.coefficients();
        a >= -noise && p >= -noise && middle > SHARE * self.doubt && q >= -noise && b > 0.0
    }

    /// Whether every signal within the bounds changes its sign exactly once.
    pub fn changes_once(&self) -> bool {
        let [a, p, middle, q, b] = self.coefficients();
        let once = |middle: f64| {
            let signs = [a, p, middle, q, b].into_iter().filter(|value| *value != 0.0).map(|value| value > 0.0);
            signs.clone().zip(signs.skip(1)).filter(|(left, right)| left != right).count() == 1
        };
        once(middle - SHARE * self.doubt) && once(middle + SHARE * self.doubt)
    }

    /// Whether the signal has a minimum within: its rate along the run changes from negative to nonnegative.
    pub fn has_valley(&self) -> bool {
        self.a.rate * self.length < 0.0 && self.b.rate * self.length >= 0.0
    }

    /// Whether the cubic is monotonic.
    pub fn is_monotone(&self) -> bool {
        let [p, q] = self.inner();
        let steps = [p - self.a.value, q - p, self.b.value - q];
        steps.iter().all(|step| *step >= 0.0) || steps.iter().all(|step| *step <= 0.0)
    }

    /// The error of the cubic at the middle, from the exact value and rate there.
    pub fn error_at_middle(&self, middle: Signal) -> f64 {
        let [p, q] = self.inner();
        let value = 0.125 * (self.a.value + 3.0 * (p + q) + self.b.value);
        let rise = 0.75 * (self.b.value + q - p - self.a.value);
        (value - middle.value).abs().max(0.25 * (rise - self.length * middle.rate).abs())
    }

    /// An estimate of the error bound of this interval from the error of the previous cubic extrapolated to the end of
    /// this interval. Both errors are proportional to the fourth derivative.
    pub fn error_of_continued(before: &Bounds, next: Signal, length: f64) -> f64 {
        // the extrapolation error at 1 + r is (1 + r)^2 r^2, the interpolation error at the middle of the next interval
        // r^4/16, with a common factor
        let ratio = (length / before.length).abs();
        let ([p, q], at) = (before.inner(), 1.0 + ratio);
        let left = 1.0 - at;
        let value =
            left * left * (left * before.a.value + 3.0 * at * p) + at * at * (3.0 * left * q + at * before.b.value);
        let off = (value - next.value).abs();
        off * ratio * ratio / (16.0 * at * at)
    }
}
