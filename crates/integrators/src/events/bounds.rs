//! Bounds of a signal over an interval at whose ends the signal and its rate are known: whether it has a zero there.
//!
//! The cubic through both values and rates has an error e with a double zero at each end. With |e(s)| <= 16 d s^2 (1 - s)^2, d the
//! doubt at the middle, the signal lies between two polynomials of degree 4, whose coefficients in Bernstein's basis,
//!
//!   a,  (a + 3 p)/4,  (p + q)/2 -+ 8/3 d,  (3 q + b)/4,  b,    p = a + h a'/3,  q = b - h b'/3,
//!
//! differ in the middle one alone. All positive, there is no zero; one change of sign, there is one (Descartes' rule).

use super::Signal;

/// The share of the doubt in the middle coefficient: 16 over the binomial 6.
const SHARE: f64 = 16.0 / 6.0;

/// An interval with its signal at both ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    a: Signal,
    b: Signal,
    /// The length of the interval from a to b, negative backwards.
    length: f64,
    /// The largest distance of the signal from the cubic in the middle.
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

    /// p and q.
    fn inner(&self) -> [f64; 2] {
        let third = self.length / 3.0;
        [self.a.value + third * self.a.rate, self.b.value - third * self.b.rate]
    }

    /// The coefficients without the doubt.
    fn coefficients(&self) -> [f64; 5] {
        let ([p, q], a, b) = (self.inner(), self.a.value, self.b.value);
        [a, 0.25 * (a + 3.0 * p), 0.5 * (p + q), 0.25 * (3.0 * q + b), b]
    }

    /// The largest distance of the cubic from its chord, by its inner coefficients.
    pub fn bow(&self) -> f64 {
        let ([p, q], rise) = (self.inner(), self.b.value - self.a.value);
        (p - self.a.value - rise / 3.0).abs().max((q - self.b.value + rise / 3.0).abs())
    }

    /// The range of the cubic, by its coefficients.
    pub fn spread(&self) -> f64 {
        let all = self.coefficients();
        all.iter().copied().fold(f64::NEG_INFINITY, f64::max) - all.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The greatest value that the signal may have.
    pub fn greatest(&self) -> f64 {
        self.coefficients().iter().copied().fold(f64::NEG_INFINITY, f64::max) + SHARE * self.doubt
    }

    /// The least value that the signal may have.
    pub fn least(&self) -> f64 {
        let [a, p, middle, q, b] = self.coefficients();
        [a, p, middle - SHARE * self.doubt, q, b].into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Whether the signal, where it is at least zero at the beginning, stays so; below this noise an end counts as zero.
    pub fn stays_up(&self, noise: f64) -> bool {
        let [a, p, middle, q, b] = self.coefficients();
        a >= -noise && p >= -noise && middle > SHARE * self.doubt && q >= -noise && b > 0.0
    }

    /// Whether the signal changes its sign once, for every value within its bounds.
    pub fn changes_once(&self) -> bool {
        let [a, p, middle, q, b] = self.coefficients();
        let once = |middle: f64| {
            let signs = [a, p, middle, q, b].into_iter().filter(|value| *value != 0.0).map(|value| value > 0.0);
            signs.clone().zip(signs.skip(1)).filter(|(left, right)| left != right).count() == 1
        };
        once(middle - SHARE * self.doubt) && once(middle + SHARE * self.doubt)
    }

    /// Whether the rate changes its sign from below to above zero along the run.
    pub fn has_valley(&self) -> bool {
        self.a.rate * self.length < 0.0 && self.b.rate * self.length >= 0.0
    }

    /// Whether the cubic is monotonic.
    pub fn is_monotone(&self) -> bool {
        let [p, q] = self.inner();
        let steps = [p - self.a.value, q - p, self.b.value - q];
        steps.iter().all(|step| *step >= 0.0) || steps.iter().all(|step| *step <= 0.0)
    }

    /// The distance of the signal, known in the middle, from the cubic, by its value and by its rate.
    pub fn error_at_middle(&self, middle: Signal) -> f64 {
        let [p, q] = self.inner();
        let value = 0.125 * (self.a.value + 3.0 * (p + q) + self.b.value);
        let rise = 0.75 * (self.b.value + q - p - self.a.value);
        (value - middle.value).abs().max(0.25 * (rise - self.length * middle.rate).abs())
    }

    /// The distance of the signal from the cubic of the interval before, continued, in the measure of the doubt of this interval:
    /// both errors go with the fourth derivative.
    pub fn error_of_continued(before: &Bounds, next: Signal, length: f64) -> f64 {
        // at 1 + r the cubic is off by (1 + r)^2 r^2, in the middle of the next by r^4/16, each times the same
        let ratio = (length / before.length).abs();
        let ([p, q], at) = (before.inner(), 1.0 + ratio);
        let left = 1.0 - at;
        let value =
            left * left * (left * before.a.value + 3.0 * at * p) + at * at * (3.0 * left * q + at * before.b.value);
        let off = (value - next.value).abs();
        off * ratio * ratio / (16.0 * at * at)
    }
}
