//! Taylor's method with a series written by hand: the pendulum, with the recurrences of sine and cosine.

use crate::problems::{Kepler, Pendulum, distance};
use dalembert_integrators::{
    Dual8, Failure, Method, Ode, Record, Refusal, Span, System, Taylor, TaylorSeries, Tolerance, Working, integrate,
    integrate_in, reference,
};
use field::DoubleDouble;

/// The pendulum with its series.
struct Series(Pendulum);

impl<S: field::Scalar> Ode<S> for Series
where
    Pendulum: Ode<S>,
{
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        self.0.rates(t, y, dy);
    }
}

impl System for Series
where
    Pendulum: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble>,
{
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        Some(Box::new(Recurrence {
            frequency: self.0.frequency,
            sine: Vec::new(),
            cosine: Vec::new(),
            series: Vec::new(),
        }))
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        Some(Box::new(Recurrence {
            frequency: self.0.frequency,
            sine: Vec::new(),
            cosine: Vec::new(),
            series: Vec::new(),
        }))
    }
}

struct Recurrence<S> {
    frequency: f64,
    sine: Vec<S>,
    cosine: Vec<S>,
    series: Vec<S>,
}

impl<S: Working> TaylorSeries<S> for Recurrence<S> {
    fn expand(&mut self, _: S, y: &[S], order: usize) {
        self.series.resize(2 * (order + 1), S::zero());
        let out = &mut self.series;
        let square = S::lift(self.frequency * self.frequency);
        let point = y[0].circle();
        self.sine.clear();
        self.cosine.clear();
        self.sine.push(point.sin);
        self.cosine.push(point.cos);
        out[..2].copy_from_slice(y);
        for k in 0..order {
            let over = S::ratio(1, k as i64 + 1);
            out[2 * (k + 1)] = out[2 * k + 1] * over;
            out[2 * (k + 1) + 1] = -square * self.sine[k] * over;
            // k s_k = sum j a_j c_{k-j}, k c_k = -sum j a_j s_{k-j}
            let angle = |j: usize| S::int(j as i64) * out[2 * j];
            let sum = |other: &[S]| (1..=k + 1).fold(S::zero(), |sum, j| sum + angle(j) * other[k + 1 - j]);
            let (sine, cosine) = (sum(&self.cosine) * over, -sum(&self.sine) * over);
            self.sine.push(sine);
            self.cosine.push(cosine);
        }
    }

    fn coefficients(&self, k: usize) -> &[S] {
        &self.series[2 * k..2 * (k + 1)]
    }

    fn sum(&self, h: S, out: &mut [S]) {
        let pairs = self.series.chunks(2).rev();
        let [a, b] = pairs.fold([S::zero(); 2], |[a, b], pair| [a * h + pair[0], b * h + pair[1]]);
        (out[0], out[1]) = (a, b);
    }
}

const PENDULUM: Series = Series(Pendulum { frequency: 3.0 });

#[test]
fn the_error_is_proportional_to_the_tolerance_between_the_steps_too() {
    let exact = {
        let span = Span::new(0.0, 4.0, &[1.0, 0.5]).with_even_outputs(40);
        reference(&Series(Pendulum { frequency: 3.0 }), &span).expect("the pendulum has a reference")
    };
    assert_eq!(exact.methods[1], Method::Taylor);
    assert!(exact.digits > 26.0, "{}", exact.digits);
    let span = Span::new(0.0, 4.0, &[1.0, 0.5]).with_even_outputs(40);
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mut record = Record::new();
        let outcome = integrate(&PENDULUM, Method::Taylor, &Tolerance::both(tolerance), &span, &mut record);
        let error = exact.error(&record);
        assert!(outcome.reached() && outcome.work.steps < 80, "{}", outcome.work);
        assert!(error < 100.0 * tolerance && error > 1e-3 * tolerance, "{error:.1e} at {tolerance:e}");
    }
}

#[test]
fn the_energy_is_kept_to_28_digits_in_double_double() {
    let start = [DoubleDouble::from(2.0), DoubleDouble::from(0.0)];
    let span = Span::new(0.0, 10.0, &start).with_monitor("energy", |_, y: &[DoubleDouble]| PENDULUM.0.energy(y));
    let outcome = integrate_in(&PENDULUM, Method::Taylor, &Tolerance::both(1e-30), &span, &mut ());
    assert!(outcome.reached() && outcome.deviations[0].largest < 1e-28, "{:?}", outcome.deviations);
}

#[test]
fn a_run_backwards_returns() {
    let span = Span::new(0.0, 4.0, &[1.0, 0.5]);
    let there = integrate(&PENDULUM, Method::Taylor, &Tolerance::both(1e-12), &span, &mut ());
    let span = Span::new(4.0, 0.0, &there.state);
    let back = integrate(&PENDULUM, Method::Taylor, &Tolerance::both(1e-12), &span, &mut ());
    assert!(distance(&back.state, &[1.0, 0.5]) < 1e-10);
}

#[test]
fn a_system_without_a_series_is_refused() {
    let ellipse = Kepler { eccentricity: 0.1 };
    let span = Span::new(0.0, 1.0, &ellipse.state::<f64>(0.0));
    let outcome = integrate(&ellipse, Method::Taylor, &Tolerance::both(1e-6), &span, &mut ());
    assert_eq!(outcome.failure(), Some(Failure::Refused(Refusal::NoSeries)));
}

#[test]
fn one_method_carries_many_states_there_and_back() {
    let Series(pendulum) = PENDULUM;
    let series = Recurrence { frequency: pendulum.frequency, sine: Vec::new(), cosine: Vec::new(), series: Vec::new() };
    let mut taylor = Taylor::new(series, &Tolerance::both(1e-13));
    for start in [[1.0, 0.5], [-2.0, 3.0], [0.0, 0.0]] {
        let mut state = start;
        let there = taylor.propagate(0.0, 4.0, &mut state);
        let back = taylor.propagate(4.0, 0.0, &mut state);
        assert!(there.is_ok() && back.is_ok() && distance(&state, &start) < 1e-11, "{state:?}");
    }
    let mut lost = [f64::NAN, 0.0];
    assert_eq!(taylor.propagate(0.0, 1.0, &mut lost), Err(Failure::LeftTheNumbers { at: 0.0 }));
    assert!(taylor.propagate(0.0, f64::INFINITY, &mut [0.0; 2]).is_err());
}
