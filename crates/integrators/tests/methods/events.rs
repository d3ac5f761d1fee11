//! Events: where a signal falls through zero, or only touches it.

use field::{Analytic, Over};
use integrators::{
    Event, Happening, Method, Ode, Outcome, Record, Signal, Span, Switches, System, Tolerance, integrate_to_event,
};

/// q'' = -q
struct Oscillator;

impl<S: Over<f64> + Analytic> Ode<S> for Oscillator {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1]) = (y[1], -y[0]);
    }
}

impl System for Oscillator {}

/// q - level
struct Above(f64);

impl Switches for Above {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, y: &[f64], out: &mut [Signal]) {
        out[0] = Signal { value: y[0] - self.0, rate: y[1], noise: 1e-11 };
    }
}

const ADAPTIVE: [Method; 5] =
    [Method::DormandPrince5, Method::DormandPrince8, Method::Verner9, Method::GraggBulirschStoer, Method::Radau5];

fn run(method: Method, level: f64, start: [f64; 2], outputs: &[f64]) -> (Outcome<f64>, Option<Event>, Record<f64>) {
    let tolerance = Tolerance::both(if method == Method::Radau5 { 1e-11 } else { 1e-13 });
    let mut record = Record::new();
    let span = Span::new(0.0, 10.0, &start).with_outputs(outputs);
    let (outcome, event) = integrate_to_event(&Oscillator, method, &tolerance, &span, &Above(level), &mut record);
    (outcome, event, record)
}

#[test]
fn a_fall_through_zero_is_located_as_well_as_the_motion_is_known() {
    for method in ADAPTIVE {
        let (outcome, event, _) = run(method, 0.5, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("{method:?} saw nothing"));
        assert_eq!((event.signal, event.what), (0, Happening::Falls));
        let exact = std::f64::consts::FRAC_PI_3;
        let bound = if method == Method::Radau5 { 1e-8 } else { 1e-12 };
        assert!((event.time - exact).abs() < bound, "{method:?}: {:e}", event.time - exact);
        assert_eq!(outcome.time, event.time);
        assert!((outcome.state[0] - 0.5).abs() < 1e-13, "{method:?}");
    }
}

#[test]
fn a_touch_is_seen_and_a_dip_that_stays_above_is_not() {
    for method in [Method::DormandPrince8, Method::GraggBulirschStoer] {
        let (_, event, _) = run(method, -1.0, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("{method:?} saw no touch"));
        assert_eq!(event.what, Happening::Touches);
        assert!((event.time - std::f64::consts::PI).abs() < 1e-10, "{method:?}: {:e}", event.time);
        let (outcome, event, _) = run(method, -1.001, [1.0, 0.0], &[10.0]);
        assert!(event.is_none() && outcome.reached(), "{method:?}");
    }
}

#[test]
fn a_short_dip_within_one_step_is_found() {
    for level in [-0.999, -0.9999, -0.99999999] {
        let (_, event, _) = run(Method::GraggBulirschStoer, level, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("the dip below {level} was not seen"));
        assert_eq!(event.what, Happening::Falls);
        assert!((event.time - f64::acos(level)).abs() < 1e-9, "{level}: {}", event.time);
    }
}

#[test]
fn a_signal_that_starts_at_zero_counts_once_it_was_positive() {
    let (_, event, _) = run(Method::DormandPrince8, 0.0, [0.0, 1.0], &[10.0]);
    let event = event.expect("it falls after half a turn");
    assert_eq!(event.what, Happening::Falls);
    assert!((event.time - std::f64::consts::PI).abs() < 1e-12);
    let (outcome, event, _) = run(Method::DormandPrince8, 0.0, [0.0, -1.0], &[10.0]);
    assert_eq!(event.map(|e| (e.what, e.time)), Some((Happening::StartsBelow, 0.0)));
    assert_eq!(outcome.time, 0.0);
}

#[test]
fn the_observer_sees_nothing_beyond_the_event() {
    for method in ADAPTIVE {
        let (_, _, record) = run(method, 0.5, [1.0, 0.0], &[0.0, 0.5, 1.0, 1.5, 10.0]);
        assert_eq!(record.times, [0.0, 0.5, 1.0], "{method:?}");
    }
}
