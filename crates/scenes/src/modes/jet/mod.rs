//! Taylor coefficients of a quantity along a motion, each with a bound of its rounding error, called its doubt.
//!
//! At an event some values are zero up to rounding, and the next coefficient decides the sign. A coefficient counts as zero if it does
//! not exceed its doubt: a running bound of the errors of the state, of the time and of every operation. The sign of a value near zero is
//! the sign with which it leaves the interval of its doubt: -e s + s^2 with a small e first decreases, but by at most e^2/4, which may be
//! below rounding.

mod operators;

use field::{Analytic, Circle, Elementary};
use num_traits::Zero;

/// The relative rounding error of an operation.
pub(super) const ROUNDING: f64 = f64::EPSILON;

/// The factor between successive times at which a change is evaluated, and the largest number of times, which covers forty powers of ten.
const LONGER: f64 = 1.1;
const MOST_TIMES: usize = 1000;

/// The series c_0 + c_1 s + ... + c_(N-1) s^(N-1), where s is the time after an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Jet<const N: usize> {
    /// The coefficients c_k.
    pub terms: [f64; N],
    /// The error bound of each coefficient.
    pub doubts: [f64; N],
}

impl<const N: usize> Jet<N> {
    /// A constant with an error bound.
    pub fn constant(value: f64, doubt: f64) -> Self {
        let (mut terms, mut doubts) = ([0.0; N], [0.0; N]);
        (terms[0], doubts[0]) = (value, doubt);
        Jet { terms, doubts }
    }

    /// The series with zero error bounds.
    pub fn exact(self) -> Self {
        Jet { doubts: [0.0; N], ..self }
    }

    /// The first K coefficients; missing ones are zero.
    pub fn resized<const K: usize>(&self) -> Jet<K> {
        let of = |all: &[f64; N]| std::array::from_fn(|order| all.get(order).copied().unwrap_or(0.0));
        Jet { terms: of(&self.terms), doubts: of(&self.doubts) }
    }

    /// Sets coefficient `order` + 1 from coefficient `order` of the rate.
    pub fn follow(&mut self, rate: &Self, order: usize) {
        let per = 1.0 / (order + 1) as f64;
        self.terms[order + 1] = rate.terms[order] * per;
        self.doubts[order + 1] = rate.doubts[order] * per + ROUNDING * self.terms[order + 1].abs();
    }

    /// True if every coefficient is at most its error bound, or at most four machine epsilons of the coefficient of `other`.
    pub fn is_beside(&self, other: &Self) -> bool {
        let own = self.terms.iter().zip(&self.doubts).zip(&other.terms);
        own.into_iter().all(|((term, doubt), other)| term.abs() <= doubt.max(4.0 * ROUNDING * other.abs()))
    }

    fn rate(&self) -> Self {
        let mut rate = Jet::zero();
        for order in 1..N {
            rate.terms[order - 1] = order as f64 * self.terms[order];
            rate.doubts[order - 1] = order as f64 * self.doubts[order];
        }
        rate
    }

    /// The sign of a coefficient: zero if it does not exceed `slack` times its error bound, NaN if it is NaN.
    pub fn sign_of(&self, order: usize, slack: f64) -> f64 {
        let term = self.terms[order];
        if term.is_nan() || term.abs() > slack * self.doubts[order] { term.signum() } else { 0.0 }
    }

    /// The sign just after the instant.
    pub fn sign(&self, slack: f64) -> f64 {
        let value = self.sign_of(0, slack);
        if value == 0.0 { self.way(slack * self.doubts[0], slack) } else { value }
    }

    /// The sign of the change with which the value first leaves an interval of half width `band` around its value at the instant; zero if
    /// it does not change.
    pub fn way(&self, band: f64, slack: f64) -> f64 {
        let signs: [f64; N] = std::array::from_fn(|order| if order == 0 { 0.0 } else { self.sign_of(order, slack) });
        if signs.iter().any(|sign| sign.is_nan()) {
            return f64::NAN;
        }
        let known = || (1..N).filter(|&order| signs[order] != 0.0);
        let Some(first) = known().next() else { return 0.0 };
        if band == 0.0 {
            return signs[first];
        }
        // until this time no term reaches its part of the band
        let reach = |order: usize| (band / (N as f64 * self.terms[order].abs())).powf(1.0 / order as f64);
        let mut time = known().map(reach).fold(f64::INFINITY, f64::min);
        for _ in 0..MOST_TIMES {
            let change: f64 = known().map(|order| self.terms[order] * time.powi(order as i32)).sum();
            if change.abs() > band {
                return change.signum();
            }
            time *= LONGER;
        }
        signs[first]
    }

    /// The largest value that error bounds may hide in a quantity that leaves zero slowly, such as t^4 with an error bound proportional
    /// to t.
    pub fn hidden(&self, slack: f64) -> f64 {
        let Some(leading) = (0..N).find(|&order| self.sign_of(order, slack) != 0.0) else { return 0.0 };
        // until the time at which the leading term exceeds each error bound of lower order
        let doubted = (0..leading).filter(|&order| self.doubts[order] > 0.0);
        let hidden = doubted.map(|order| {
            let time = (slack * self.doubts[order] / self.terms[leading].abs()).powf(1.0 / (leading - order) as f64);
            slack * self.doubts[order] * time.powi(order as i32)
        });
        hidden.fold(0.0, f64::max)
    }

    fn by_terms(self, operation: impl Fn(f64) -> f64) -> Self {
        Jet { terms: self.terms.map(operation), doubts: self.doubts }
    }

    fn plus(self, terms: [f64; N], doubts: [f64; N]) -> Self {
        let mut sum = self;
        for order in 0..N {
            sum.terms[order] += terms[order];
            sum.doubts[order] += doubts[order] + ROUNDING * sum.terms[order].abs();
        }
        sum
    }
}

impl<const N: usize> Analytic for Jet<N> {
    fn circle(self) -> Circle<Self> {
        let Circle { cos, sin } = self.terms[0].circle();
        let doubt = |slope: f64, value: f64| slope.abs() * self.doubts[0] + 2.0 * ROUNDING * value.abs();
        let mut point = Circle { cos: Jet::constant(cos, doubt(sin, cos)), sin: Jet::constant(sin, doubt(cos, sin)) };
        for order in 0..N - 1 {
            let rates = [-point.sin * self.rate(), point.cos * self.rate()];
            point.cos.follow(&rates[0], order);
            point.sin.follow(&rates[1], order);
        }
        point
    }

    fn sqrt(self) -> Self {
        let root = self.terms[0].sqrt();
        let mut jet = Jet::constant(root, self.doubts[0] / (2.0 * root) + ROUNDING * root);
        for order in 0..N - 1 {
            jet.follow(&(self.rate() / (jet + jet)), order);
        }
        jet
    }

    fn elementary(self, function: Elementary, other: Self) -> Self {
        let value = function.of(self.terms[0], other.terms[0]);
        let [by_first, by_second] = function.slopes(self.terms[0], other.terms[0], value);
        let doubt = by_first.abs() * self.doubts[0] + by_second.abs() * other.doubts[0];
        let mut jet = Jet::constant(value, doubt + 2.0 * ROUNDING * value.abs());
        for order in 0..N - 1 {
            let [by_first, by_second] = function.slopes(self, other, jet);
            jet.follow(&(by_first * self.rate() + by_second * other.rate()), order);
        }
        jet
    }
}

#[cfg(test)]
mod tests {
    use super::Jet;
    use field::{Analytic, Elementary};

    fn time(at: f64) -> Jet<5> {
        let mut time = Jet::constant(at, 0.0);
        time.terms[1] = 1.0;
        time
    }

    /// Coefficients of known series about 0.7.
    #[test]
    fn functions_have_their_taylor_coefficients() {
        let at = 0.7_f64;
        let known = [
            (
                time(at).elementary(Elementary::Exp, time(at)),
                [1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0].map(|c| c * at.exp()),
            ),
            (
                time(at).elementary(Elementary::Ln, time(at)),
                [at.ln(), 1.0 / at, -0.5 / at.powi(2), 1.0 / (3.0 * at.powi(3)), -0.25 / at.powi(4)],
            ),
            (time(at).circle().sin, [at.sin(), at.cos(), -at.sin() / 2.0, -at.cos() / 6.0, at.sin() / 24.0]),
            ((time(at) * time(at)).sqrt(), [at, 1.0, 0.0, 0.0, 0.0]),
            (time(at) * time(at) / time(at), [at, 1.0, 0.0, 0.0, 0.0]),
        ];
        for (jet, terms) in known {
            for ((found, known), doubt) in jet.terms.iter().zip(terms).zip(jet.doubts) {
                assert!((found - known).abs() <= 4.0 * doubt.max(f64::EPSILON), "{jet:?} and {terms:?}");
                assert!(doubt < 1e-13, "{jet:?}");
            }
        }
    }

    /// A coefficient that is zero up to rounding does not decide; the next one does.
    #[test]
    fn a_sign_is_that_of_the_first_term_beyond_its_doubt() {
        let tenth = Jet::constant(0.1, 1e-17) * Jet::constant(3.0, 0.0) - Jet::constant(0.3, 5e-17);
        let mut falling = tenth - time(0.0) * time(0.0);
        assert_eq!(falling.sign(1.0), -1.0);
        assert_eq!(tenth.sign(1.0), 0.0);
        falling.terms[0] = f64::NAN;
        assert!(falling.sign(1.0).is_nan());
    }

    /// -e s + s^2 decreases by e^2/4: a decrease below rounding does not count.
    #[test]
    fn a_fall_that_rounding_hides_is_none() {
        let valley = |e: f64| Jet::<5>::constant(0.0, 1e-16) + time(0.0) * (time(0.0) - Jet::constant(e, 1e-17));
        assert_eq!(valley(1e-9).sign(16.0), 1.0);
        assert_eq!(valley(1e-6).sign(16.0), -1.0);
        // with zero error bounds the first coefficient decides
        assert_eq!(Jet { doubts: [0.0; 5], ..valley(1e-9) }.sign(16.0), -1.0);
    }
}
