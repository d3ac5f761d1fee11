//! Event location by every method on polynomials: all zeros are found, for steps of any length.

use dalembert_integrators::{
    Event, Happening, Method, Ode, Signal, Span, Switches, System, TaylorSeries, Tolerance, integrate_to_event,
};
use field::{Analytic, Over};

/// The law y' = p'(t), so that y = p(t); coefficients in ascending order.
struct Polynomial(&'static [f64]);

impl Polynomial {
    fn value<S: Over<f64>>(&self, t: S) -> S {
        self.0.iter().rev().fold(S::zero(), |sum, c| sum * t + S::lift(*c))
    }

    fn slope<S: Over<f64>>(&self, t: S) -> S {
        let terms = self.0.iter().enumerate().skip(1).rev();
        terms.fold(S::zero(), |sum, (k, c)| sum * t + S::lift(*c * k as f64))
    }
}

impl<S: Over<f64> + Analytic> Ode<S> for Polynomial {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, _: &[S], dy: &mut [S]) {
        dy[0] = self.slope(t);
    }
}

impl System for Polynomial {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        Some(Box::new(Shifted { of: self, terms: Vec::new() }))
    }
}

/// The polynomial expanded about a time, by repeated division.
struct Shifted<'a> {
    of: &'a Polynomial,
    terms: Vec<[f64; 1]>,
}

impl TaylorSeries<f64> for Shifted<'_> {
    fn expand(&mut self, t: f64, y: &[f64], order: usize) {
        let mut rest = self.of.0.to_vec();
        self.terms.clear();
        while !rest.is_empty() {
            for k in (0..rest.len() - 1).rev() {
                rest[k] += t * rest[k + 1];
            }
            self.terms.push([rest.remove(0)]);
        }
        self.terms.resize(order + 1, [0.0]);
        self.terms[0] = [y[0]];
    }

    fn coefficients(&self, k: usize) -> &[f64] {
        &self.terms[k]
    }

    fn sum(&self, h: f64, out: &mut [f64]) {
        out[0] = self.terms.iter().rev().fold(0.0, |sum, term| sum * h + term[0]);
    }
}

/// Signals: multiples of the polynomial by positive and negative factors, so that zeros crossed in either direction are
/// found.
struct Signs<'a> {
    of: &'a Polynomial,
    /// Each factor, with the level of noise below which its signal counts as zero.
    signs: Vec<(f64, f64)>,
    noise: f64,
}

impl Switches for Signs<'_> {
    fn count(&self) -> usize {
        self.signs.len()
    }

    fn signals(&self, t: f64, y: &[f64], out: &mut [Signal]) {
        for (signal, (sign, level)) in out.iter_mut().zip(&self.signs) {
            *signal = Signal {
                value: sign * (y[0] - level),
                rate: sign * self.of.slope(t),
                noise: self.noise,
                ..Signal::default()
            };
        }
    }
}

const METHODS: [Method; 13] = [
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner6,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Radau5,
    Method::Kvaerno5,
    Method::Rodas4,
    Method::BaderDeuflhard,
    Method::Gauss { stages: 4 },
    Method::RadauIIA { stages: 4 },
    Method::Taylor,
    Method::RungeKutta4 { steps: 3 },
];

const TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// All events between two times: after each event the integration starts anew, and the signal is watched in the
/// direction opposite to its present sign.
fn events(
    of: &Polynomial,
    method: Method,
    (tolerance, noise): (f64, f64),
    (start, end): (f64, f64),
) -> Vec<(f64, Happening)> {
    let (mut time, mut state, mut found) = (start, of.value(start), Vec::new());
    let mut sign = state.signum();
    loop {
        let span = Span::new(time, end, &[state]);
        let switches = Signs { of, signs: vec![(sign, 0.0)], noise };
        let tolerance = Tolerance::both(tolerance);
        let (outcome, event) = integrate_to_event(of, method, &tolerance, &span, &switches, &mut ());
        let Some(Event { what, time: at, .. }) = event else {
            assert!(outcome.reached(), "{method}: {:?}", outcome.end);
            return found;
        };
        (time, state) = (at, outcome.state[0]);
        found.push((at, what));
        assert!(found.len() < 10, "{method}: {found:?}");
        if what == Happening::Falls {
            sign = -sign;
        }
    }
}

/// Compares the zeros found with the expected ones. The noise below which a signal counts as zero may depend on the
/// tolerance.
fn check(of: &[f64], span: (f64, f64), expected: &[(f64, Happening)], (accuracy, noisy): (f64, bool)) {
    let of = Polynomial(of.to_vec().leak());
    for method in METHODS {
        for tolerance in TOLERANCES {
            let found = events(&of, method, (tolerance, if noisy { 1e-9 + 100.0 * tolerance } else { 1e-9 }), span);
            let same = found.len() == expected.len()
                && found
                    .iter()
                    .zip(expected)
                    .all(|((at, what), (zero, happening))| (at - zero).abs() < accuracy && what == happening);
            assert!(same, "{method} at {tolerance:e}: {found:?}, not {expected:?}");
        }
    }
}

#[test]
fn all_zeros_of_a_cubic_are_found_by_every_method_at_every_tolerance() {
    let falls = |zero: f64| (zero, Happening::Falls);
    check(&[-24.0, -4.0, 6.0, 1.0], (-8.0, 4.0), &[-6.0, -2.0, 2.0].map(falls), (1e-2, false));
}

/// The polynomial (t + 1) (t - 1) (t - 1.1) (t - 3), forwards and backwards.
#[test]
fn two_zeros_near_each_other_are_found_forwards_and_backwards() {
    let quartic = [-3.3, 4.1, 2.3, -4.1, 1.0];
    let falls = |zero: f64| (zero, Happening::Falls);
    check(&quartic, (-4.0, 6.0), &[-1.0, 1.0, 1.1, 3.0].map(falls), (1e-2, false));
    check(&quartic, (6.0, -4.0), &[3.0, 1.1, 1.0, -1.0].map(falls), (1e-2, false));
}

/// The polynomials (t - 1)^2 (t + 2)^2, with two double zeros, and (t - 1)^4.
#[test]
fn zeros_of_even_multiplicity_touch_and_are_told_once() {
    let touches = |zero: f64| (zero, Happening::Touches);
    check(&[4.0, -4.0, -3.0, 2.0, 1.0], (-5.0, 3.0), &[-2.0, 1.0].map(touches), (3e-2, true));
    check(&[1.0, -4.0, 6.0, -4.0, 1.0], (-2.0, 3.0), &[touches(1.0)], (0.2, true));
}

#[test]
fn of_several_signals_the_first_to_fall_ends_the_run() {
    let cubic = Polynomial(&[-24.0, -4.0, 6.0, 1.0]);
    for method in METHODS {
        for tolerance in TOLERANCES {
            let signs = vec![(-1.0, 50.0), (-1.0, -10.0), (-1.0, 8.0), (-1.0, 300.0)];
            let switches = Signs { of: &cubic, signs, noise: 1e-9 };
            let (span, tolerance) = (Span::new(-8.0, 4.0, &[-120.0]), Tolerance::both(tolerance));
            let (outcome, event) = integrate_to_event(&cubic, method, &tolerance, &span, &switches, &mut ());
            assert_eq!(event.map(|event| event.signal), Some(1), "{method}: {event:?}");
            assert!((outcome.state[0] + 10.0).abs() < 1e-7, "{method}: {}", outcome.state[0]);
        }
    }
}
